//! What a user sets up: the movement window's colours, what it shows, from where (thesis A.5.3).
//!
//! Plain data with the defaults of a new window. It knows neither files nor how anything is drawn.

mod colours;
mod display;
pub(crate) mod file;

#[cfg(test)]
mod window_tests;

use egui::Color32;
use vides_engine::math::view::HALF_FILM_HEIGHT;
use vides_engine::property::choices;

use crate::texts::Language;
use crate::theme::rgb;

choices! {
    /// Something in the movement window with a custom colour that can be switched off.
    #[derive(Hash)]
    pub(super) enum Element {
        #[default]
        Background = "background",
        /// The edges of the movement space.
        Cube = "cube",
        /// The host's wireframe object.
        Object = "object",
        Curve = "curve",
        /// The segment that begins at the current point.
        Segment = "current_segment",
        /// The small crosses at the support points.
        Crosses = "crosses",
        Numbers = "numbers",
        /// The arrow from the current point to what its camera looks at.
        Vpn = "vpn",
        /// The arrow upwards of the current camera.
        Vup = "vup",
        /// The circle on which the tip of VUP runs.
        Circle = "vup_circle",
        /// The axes through a point that is dragged.
        Axes = "axes",
        /// The border of the plane in which it is dragged.
        Plane = "plane",
        /// The pieces of the curve outside the movement space.
        Outside = "outside",
        /// Each orientation of the path as a small camera.
        Cameras = "cameras",
        /// The ribbon that shows view and roll all along the curve.
        Ribbon = "ribbon",
        /// The camera at the frame that is played.
        Player = "player",
    }
}

impl Element {
    /// Whether it can be switched off; the background cannot.
    pub(super) const fn has_switch(self) -> bool {
        !matches!(self, Self::Background)
    }
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Colours([Color32; Element::ALL.len()]);

impl Colours {
    /// For a dark ground.
    pub(super) const DARK: Self = Self([
        rgb(0x0f_13_18),
        rgb(0x4d_54_5f),
        rgb(0xd5_dc_e6),
        rgb(0xf2_a3_3c),
        rgb(0x4f_a8_ff),
        rgb(0xf4_f6_f9),
        rgb(0x9a_a5_b4),
        rgb(0xff_7d_78),
        rgb(0xa0_f0_b0),
        rgb(0x3d_7f_58),
        rgb(0xb9_8c_ff),
        rgb(0x8d_6c_c8),
        rgb(0xff_4d_8d),
        rgb(0x8a_9b_b4),
        rgb(0x5c_c8_d8),
        rgb(0xff_d8_5e),
    ]);

    /// For a light ground.
    pub(super) const LIGHT: Self = Self([
        rgb(0xfb_fb_fd),
        rgb(0xa8_ae_b8),
        rgb(0x30_3a_48),
        rgb(0xc0_5a_00),
        rgb(0x0b_62_c4),
        rgb(0x14_18_1e),
        rgb(0x5b_65_73),
        rgb(0xc0_24_2c),
        rgb(0x00_75_6a),
        rgb(0x7d_b8_92),
        rgb(0x6a_38_c0),
        rgb(0x9a_7a_d0),
        rgb(0xd0_10_60),
        rgb(0x66_74_88),
        rgb(0x0d_86_96),
        rgb(0x5a_4a_00),
    ]);

    pub(super) const fn of(&self, element: Element) -> Color32 {
        self.0[element as usize]
    }

    pub(super) const fn set(&mut self, element: Element, colour: Color32) {
        self.0[element as usize] = colour;
    }
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Shown([bool; Element::ALL.len()]);

impl Default for Shown {
    fn default() -> Self {
        Self([true; Element::ALL.len()])
    }
}

impl Shown {
    pub(super) const fn has(&self, element: Element) -> bool {
        self.0[element as usize] || !element.has_switch()
    }

    pub(super) const fn set(&mut self, element: Element, shown: bool) {
        self.0[element as usize] = shown;
    }
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
pub(super) enum Theme {
    #[default]
    Dark,
    Light,
}

/// From where the movement space is seen.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct View {
    /// Rotation about the y axis in degrees, in (−180, 180].
    pub(super) rotation: f64,
    /// Tilt in degrees, in [−90, 90]; at 90 one looks down.
    pub(super) tilt: f64,
    /// Size of the cube: 1 just fits into the window at any rotation.
    pub(super) size: f64,
    /// The shift on the screen, to the right and up, in units of the movement space.
    pub(super) shift: [f64; 2],
}

impl Default for View {
    fn default() -> Self {
        Self {
            rotation: 28.0,
            tilt: 20.0,
            size: 1.0,
            shift: [0.0; 2],
        }
    }
}

impl View {
    pub(super) const MIN_SIZE: f64 = 0.1;
    pub(super) const MAX_SIZE: f64 = 50.0;

    /// The same view with every value in its range; those not finite are as in a new window.
    pub(super) fn in_range(self) -> Self {
        let new = Self::default();
        let or = |value: f64, instead: f64| if value.is_finite() { value } else { instead };
        Self {
            rotation: vides_engine::math::orientation::wrap_degrees(or(
                self.rotation,
                new.rotation,
            )),
            tilt: or(self.tilt, new.tilt).clamp(-90.0, 90.0),
            size: or(self.size, new.size).clamp(Self::MIN_SIZE, Self::MAX_SIZE),
            shift: self.shift.map(|shift| or(shift, 0.0).clamp(-4.0, 4.0)),
        }
    }
}

choices! {
    /// Where the camera's picture is.
    pub(super) enum CameraPlace {
        /// A pane above the movement space.
        #[default]
        Corner = "corner",
        /// Side by side with it.
        Beside = "beside",
        /// In its place.
        Whole = "whole",
    }
}

impl CameraPlace {
    /// This place, or the corner if it is there already.
    pub(super) fn switched(self, place: Self) -> Self {
        if self == place { Self::Corner } else { place }
    }
}

choices! {
    /// The aspect ratio of the camera's picture.
    pub(super) enum Aspect {
        /// That of film, 36 by 24 mm.
        #[default]
        Film = "3:2",
        Wide = "16:9",
        Television = "4:3",
        Square = "1:1",
        Scope = "2.39:1",
    }
}

impl Aspect {
    pub(super) const fn ratio(self) -> f32 {
        match self {
            Self::Film => 1.5,
            Self::Wide => 16.0 / 9.0,
            Self::Television => 4.0 / 3.0,
            Self::Square => 1.0,
            Self::Scope => 2.39,
        }
    }

    /// The next one, round and round.
    pub(super) const fn next(self) -> Self {
        Self::ALL[(self as usize + 1) % Self::ALL.len()]
    }
}

choices! {
    /// A part of the panels that is folded to its heading.
    pub(super) enum Fold {
        #[default]
        Position = "position",
        Curve = "curve",
        View = "view",
        Lens = "lens",
        Timing = "timing",
        Node = "node",
        Place = "place",
        Kind = "kind",
        Deformations = "deformations",
        Shapes = "shapes",
        Motion = "motion",
    }
}

/// The least and the greatest height of a sensor, in mm: a telephone's and more than large format.
pub(super) const MIN_SENSOR: f64 = 1.0;
pub(super) const MAX_SENSOR: f64 = 500.0;

/// Everything that the setup file keeps.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Setup {
    /// As it was chosen; `None`: as the desktop's.
    pub(super) theme: Option<Theme>,
    /// The desktop's theme, which no file keeps.
    pub(super) desktop: Theme,
    pub(super) dark: Colours,
    pub(super) light: Colours,
    pub(super) shown: Shown,
    /// Objects are lines, not shaded faces.
    pub(super) wireframe: bool,
    pub(super) view: View,
    pub(super) camera_view: bool,
    pub(super) camera_place: CameraPlace,
    pub(super) camera_aspect: Aspect,
    /// In mm, of the camera whose lens the zoom panel tells.
    pub(super) sensor_height: f64,
    /// Marks the part of the picture that every screen shows.
    pub(super) safe_frame: bool,
    /// The speeds of the whole path under the frames.
    pub(super) speed_graph: bool,
    /// Whether to show sliders around the space; `None`: as the host does.
    pub(super) sliders: Option<bool>,
    /// Whether edits keep the times of other keys; `None`: unless the host fixes the speeds.
    pub(super) fixed_times: Option<bool>,
    /// The ruler counts frames, not seconds.
    pub(super) ruler_frames: bool,
    pub(super) folded: [bool; Fold::ALL.len()],
    /// As it was chosen; `None`: that of the host or the environment.
    pub(super) language: Option<Language>,
}

impl Default for Setup {
    fn default() -> Self {
        Self {
            theme: None,
            desktop: Theme::default(),
            dark: Colours::DARK,
            light: Colours::LIGHT,
            shown: Shown::default(),
            wireframe: false,
            view: View::default(),
            camera_view: true,
            camera_place: CameraPlace::default(),
            camera_aspect: Aspect::default(),
            sensor_height: 2.0 * HALF_FILM_HEIGHT,
            safe_frame: false,
            speed_graph: true,
            sliders: None,
            fixed_times: None,
            ruler_frames: false,
            folded: [false; Fold::ALL.len()],
            language: None,
        }
    }
}

impl Setup {
    pub(super) fn theme(&self) -> Theme {
        self.theme.unwrap_or(self.desktop)
    }

    pub(super) fn colours(&self) -> &Colours {
        match self.theme() {
            Theme::Dark => &self.dark,
            Theme::Light => &self.light,
        }
    }

    pub(super) fn colours_mut(&mut self) -> &mut Colours {
        match self.theme() {
            Theme::Dark => &mut self.dark,
            Theme::Light => &mut self.light,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::theme;

    #[test]
    fn the_list_is_in_the_order_of_the_enumeration() {
        for (index, element) in Element::ALL.into_iter().enumerate() {
            assert_eq!(element as usize, index);
        }
    }

    #[test]
    fn keys_differ() {
        let mut keys = Element::ALL.map(Element::name);
        keys.sort_unstable();
        assert!(keys.windows(2).all(|pair| pair[0] != pair[1]));
    }

    #[test]
    fn the_background_stays() {
        let mut shown = Shown::default();
        for element in Element::ALL {
            shown.set(element, false);
            assert_eq!(shown.has(element), element == Element::Background);
        }
    }

    #[test]
    fn what_must_be_seen_stands_out() {
        for colours in [Colours::DARK, Colours::LIGHT] {
            let ground = colours.of(Element::Background);
            let contrast = |element| theme::contrast(colours.of(element), ground);
            // Text, then lines (WCAG 1.4.3, 1.4.11).
            assert!(contrast(Element::Numbers) >= 4.5);
            for element in Element::ALL {
                // The circle is a faint guide beside the arrow that it leads, the cube a frame around
                // what matters.
                let least = match element {
                    Element::Background => continue,
                    Element::Circle | Element::Cube => 2.0,
                    _ => 3.0,
                };
                let found = contrast(element);
                assert!(found >= least, "{element:?}: {found}");
            }
        }
    }

    /// What differs by its colour differs for who lacks one kind of cones, too: without those for
    /// red, green and blue by Machado, Oliveira and Fernandes 2009, compared in Oklab (Ottosson
    /// 2020), where 0.02 is just seen.
    #[test]
    fn colours_differ_for_the_colour_blind() {
        const WITHOUT: [[f64; 9]; 3] = [
            [
                0.152_286, 1.052_583, -0.204_868, 0.114_503, 0.786_281, 0.099_216, -0.003_882,
                -0.048_116, 1.051_998,
            ],
            [
                0.367_322, 0.860_646, -0.227_968, 0.280_085, 0.672_501, 0.047_413, -0.011_820,
                0.042_940, 0.968_881,
            ],
            [
                1.255_528, -0.076_749, -0.178_779, -0.078_411, 0.930_809, 0.147_602, 0.004_733,
                0.691_367, 0.303_900,
            ],
        ];
        const CONES: [f64; 9] = [
            0.412_22, 0.536_33, 0.051_45, 0.211_90, 0.680_70, 0.107_40, 0.088_30, 0.281_72,
            0.629_98,
        ];
        const LAB: [f64; 9] = [
            0.210_45, 0.793_62, -0.004_07, 1.978_00, -2.428_59, 0.450_59, 0.025_90, 0.782_77,
            -0.808_68,
        ];
        let times = |m: &[f64; 9], v: glam::DVec3| glam::DMat3::from_cols_array(m).transpose() * v;
        let seen = |colour: Color32, without: &[f64; 9]| {
            let [r, g, b, _] = egui::Rgba::from(colour).to_array().map(f64::from);
            let light =
                times(without, glam::dvec3(r, g, b)).clamp(glam::DVec3::ZERO, glam::DVec3::ONE);
            times(&LAB, times(&CONES, light).map(f64::cbrt))
        };
        use Element::{Curve, Player, Segment, Vpn, Vup};
        for colours in [Colours::DARK, Colours::LIGHT] {
            for [one, other] in [
                [Curve, Segment],
                [Curve, Player],
                [Segment, Player],
                [Vpn, Vup],
            ] {
                for without in &WITHOUT {
                    let [a, b] = [one, other].map(|of| seen(colours.of(of), without));
                    let apart = a.distance(b);
                    assert!(apart > 0.1, "{one:?}, {other:?}: {apart}");
                }
            }
        }
    }

    #[test]
    fn a_view_is_brought_into_range() {
        let odd = View {
            rotation: 270.0,
            tilt: f64::NAN,
            size: 1e9,
            shift: [f64::INFINITY, -9.0],
        };
        let mended = View {
            rotation: -90.0,
            tilt: 20.0,
            size: View::MAX_SIZE,
            shift: [0.0, -4.0],
        };
        assert_eq!(odd.in_range(), mended);
    }
}
