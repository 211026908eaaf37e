//! The parallel projection of the movement space, its up axis vertical: rotation about it,
//! then tilt, then size (thesis 6.2). In double precision and egui's points, so that what is
//! dragged lies under the pointer however far the view is enlarged.

use egui::{Pos2, Rect, pos2};
use glam::{DMat4, DVec2, DVec3, DVec4};
use vides_engine::path;
use vides_engine::path::Space;

use crate::setup::View;

/// A world axis. In an unturned view with y up, x leads to the right and z towards the viewer; with
/// z up these are y and x.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Axis {
    X,
    Y,
    Z,
}

impl Axis {
    pub(super) const ALL: [Self; 3] = [Self::X, Self::Y, Self::Z];

    pub(super) const fn letter(self) -> &'static str {
        match self {
            Self::X => "x",
            Self::Y => "y",
            Self::Z => "z",
        }
    }

    pub(super) const fn index(self) -> usize {
        self as usize
    }

    pub(super) const fn unit(self) -> DVec3 {
        match self {
            Self::X => DVec3::X,
            Self::Y => DVec3::Y,
            Self::Z => DVec3::Z,
        }
    }

    pub(super) const fn others(self) -> [Self; 2] {
        match self {
            Self::X => [Self::Y, Self::Z],
            Self::Y => [Self::X, Self::Z],
            Self::Z => [Self::X, Self::Y],
        }
    }
}

/// A plane of which less than this share is seen counts as edge-on: an angle below two degrees.
pub(super) const EDGE_ON: f64 = 0.035;

/// The share of the viewport that the largest cube fills.
const FILL: f64 = 0.98;

/// From the movement space to the screen.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Projection {
    space: Space,
    middle: DVec2,
    /// Points to the right for a unit of each axis.
    across: DVec3,
    /// Points downwards for a unit of each axis.
    down: DVec3,
    /// Unit vector towards the viewer.
    toward: DVec3,
    /// Points for a `half_size` of the space across the line of sight.
    scale: f64,
}

/// Points for a `half_size` of a space across the line of sight.
pub(super) fn scale(view: &View, viewport: Rect) -> f64 {
    let [width, height] = [viewport.width(), viewport.height()].map(|x| f64::from(x.max(1.0)));
    // The farthest that a corner gets from the middle, however turned.
    let [wide, high] = [2.0f64.sqrt(), 3.0f64.sqrt()];
    let fitting = FILL * (width / (2.0 * wide)).min(height / (2.0 * high));
    view.size * fitting
}

impl Projection {
    #[cfg(test)]
    pub(super) fn new(view: &View, viewport: Rect) -> Self {
        Self::of(view, viewport, Space::default())
    }

    pub(super) fn of(view: &View, viewport: Rect, space: Space) -> Self {
        let (sin, cos) = view.rotation.to_radians().sin_cos();
        let (sin_tilt, cos_tilt) = view.tilt.to_radians().sin_cos();
        let right = DVec3::new(cos, 0.0, sin);
        let upright = DVec3::new(sin * sin_tilt, cos_tilt, -cos * sin_tilt);
        let toward = DVec3::new(-sin * cos_tilt, sin_tilt, cos * cos_tilt);
        let scale = scale(view, viewport);
        let unit = scale / space.half_size;
        let centre = viewport.center();
        Self {
            space,
            middle: DVec2::new(
                f64::from(centre.x) + scale * view.shift[0],
                f64::from(centre.y) - scale * view.shift[1],
            ),
            across: space.up.world(right) * unit,
            down: space.up.world(upright) * -unit,
            toward: space.up.world(toward),
            scale,
        }
    }

    /// To pixels of the screen, with the nearness in pixels as the third coordinate.
    pub(super) fn matrix(&self, pixels_per_point: f64) -> DMat4 {
        let near = self.toward * (self.scale / self.space.half_size);
        let row = |way: DVec3, at: f64| {
            let way = way * pixels_per_point;
            way.extend(at * pixels_per_point - way.dot(self.space.centre))
        };
        DMat4::from_cols(
            row(self.across, self.middle.x),
            row(self.down, self.middle.y),
            row(near, 0.0),
            DVec4::W,
        )
        .transpose()
    }

    /// From where the light comes, see [`lights`].
    pub(super) fn lights(&self) -> [DVec3; 2] {
        let [right, down] = [self.across, self.down].map(DVec3::normalize_or_zero);
        lights(right, -down, self.toward)
    }

    pub(super) fn image(&self, point: DVec3) -> DVec2 {
        self.middle + self.image_of_way(point - self.space.centre)
    }

    /// The image of a vector: that of its end less that of its beginning.
    pub(super) fn image_of_way(&self, way: DVec3) -> DVec2 {
        DVec2::new(self.across.dot(way), self.down.dot(way))
    }

    /// As [`Projection::image`], for egui.
    pub(super) fn pos(&self, point: DVec3) -> Pos2 {
        to_pos(self.image(point))
    }

    pub(super) fn space(&self) -> Space {
        self.space
    }

    pub(super) fn scale(&self) -> f64 {
        self.scale
    }

    pub(super) fn toward(&self) -> DVec3 {
        self.toward
    }

    /// The point seen at `image` in the plane through `point` that faces the viewer.
    pub(super) fn point_facing(&self, point: DVec3, image: DVec2) -> DVec3 {
        let way = image - self.image(point);
        let along = |side: DVec3, far: f64| side * (far / side.length_squared());
        point + along(self.across, way.x) + along(self.down, way.y)
    }

    /// The share of the plane across an axis that is seen, in [0, 1].
    pub(super) fn share_seen(&self, across: Axis) -> f64 {
        self.toward[across.index()].abs()
    }

    /// The point seen at `image` in the plane through `point` across `fixed`, whose coordinate
    /// keeps every bit; none if the plane is seen edge-on. Solves the equations of the thesis
    /// (6.2.1) verbatim, without the sines and cosines of the axes' images.
    pub(super) fn point_in_plane(&self, point: DVec3, fixed: Axis, image: DVec2) -> Option<DVec3> {
        if self.share_seen(fixed) < EDGE_ON {
            return None;
        }
        let [a, b] = fixed.others().map(Axis::index);
        let f = fixed.index();
        let centre = self.space.centre;
        let of_f = DVec2::new(self.across[f], self.down[f]);
        let rest = image - self.middle - of_f * (point[f] - centre[f]);
        let of_a = DVec2::new(self.across[a], self.down[a]);
        let of_b = DVec2::new(self.across[b], self.down[b]);
        let area = of_a.perp_dot(of_b);
        let mut found = point;
        found[a] = centre[a] + rest.perp_dot(of_b) / area;
        found[b] = centre[b] + of_a.perp_dot(rest) / area;
        found.is_finite().then_some(found)
    }

    /// The axis across the plane that is seen best.
    pub(super) fn facing(&self) -> Axis {
        Axis::ALL.into_iter().fold(Axis::Z, |best, axis| {
            if self.share_seen(axis) > self.share_seen(best) {
                axis
            } else {
                best
            }
        })
    }

    /// The point seen nearest to `image` on the line through `point` along `axis`; none if that
    /// points at the viewer.
    pub(super) fn point_on_line(&self, point: DVec3, axis: Axis, image: DVec2) -> Option<DVec3> {
        let at = axis.index();
        let way = DVec2::new(self.across[at], self.down[at]);
        let mut found = point;
        found[at] += (image - self.image(point)).dot(way) / way.length_squared();
        found.is_finite().then_some(found)
    }

    /// Whether the cube hides its edge along `along`, which is at the ends `signs` of the other
    /// axes: the cube is convex, so it does if both faces that meet there are turned away.
    pub(super) fn hides_edge(&self, along: Axis, signs: [f64; 2]) -> bool {
        along
            .others()
            .iter()
            .zip(signs)
            .all(|(axis, sign)| self.toward[axis.index()] * sign < -1e-12)
    }
}

/// From where the light comes for a viewer, unit vectors: the main one from the upper left, a weak
/// one from the right.
pub(super) fn lights(right: DVec3, up: DVec3, toward: DVec3) -> [DVec3; 2] {
    let main = toward + 0.7 * up - 0.45 * right;
    let other = 0.4 * toward - 0.2 * up + right;
    [main, other].map(DVec3::normalize_or_zero)
}

/// For egui, in single precision.
pub(crate) fn to_pos(image: DVec2) -> Pos2 {
    #[allow(clippy::cast_possible_truncation)]
    let [x, y] = image.to_array().map(|x| x as f32);
    pos2(x, y)
}

/// From egui; exact.
pub(super) fn from_pos(pos: Pos2) -> DVec2 {
    DVec2::new(f64::from(pos.x), f64::from(pos.y))
}

/// The twelve edges of the cube: along which axis, and at which ends of the others.
pub(super) fn cube_edges() -> impl Iterator<Item = (Axis, [f64; 2])> {
    Axis::ALL.into_iter().flat_map(|axis| {
        [[-1.0, -1.0], [-1.0, 1.0], [1.0, -1.0], [1.0, 1.0]].map(|signs| (axis, signs))
    })
}

pub(super) fn edge_ends(space: Space, along: Axis, signs: [f64; 2]) -> [DVec3; 2] {
    [-1.0, 1.0].map(|end| {
        let mut corner = DVec3::ZERO;
        corner[along.index()] = end;
        for (axis, sign) in along.others().iter().zip(signs) {
            corner[axis.index()] = sign;
        }
        space.centre + space.half_size * corner
    })
}

/// The edges of a movement space.
pub(crate) fn cube(space: path::Space) -> impl Iterator<Item = (DVec3, DVec3)> {
    cube_edges().map(move |(along, signs)| {
        let [from, to] = edge_ends(space, along, signs);
        (from, to)
    })
}

#[cfg(test)]
pub(super) mod tests {
    use egui::vec2;
    use glam::DMat4;
    use proptest::prelude::*;

    use super::*;
    use vides_engine::math::transform::{rotation_x, rotation_y};

    pub(in super::super) fn view() -> impl Strategy<Value = View> {
        (
            -180.0..180.0f64,
            -90.0..90.0f64,
            -1.0..1.0f64,
            prop::array::uniform2(-0.5..0.5f64),
        )
            .prop_map(|(rotation, tilt, size, shift)| View {
                rotation,
                tilt,
                size: 10f64.powf(size),
                shift,
            })
    }

    pub(in super::super) fn in_cube() -> impl Strategy<Value = DVec3> {
        prop::array::uniform3(-1.0..=1.0f64).prop_map(DVec3::from_array)
    }

    pub(in super::super) fn viewport() -> Rect {
        Rect::from_min_size(pos2(263.0, 71.0), vec2(884.5, 611.0))
    }

    #[test]
    fn unturned_it_is_a_front_view() {
        let view = View {
            rotation: 0.0,
            tilt: 0.0,
            ..View::default()
        };
        let p = Projection::new(&view, viewport());
        let middle = from_pos(viewport().center());
        assert_eq!(p.image(DVec3::ZERO), middle);
        assert_eq!(p.image(DVec3::Z), middle);
        assert_eq!(p.image(DVec3::X), middle + DVec2::X * p.scale());
        assert_eq!(p.image(DVec3::Y), middle - DVec2::Y * p.scale());
    }

    #[test]
    fn tilted_one_looks_from_above() {
        let p = Projection::new(&View::default(), viewport());
        assert!(p.toward().y > 0.3);
        // The near edge of the floor is lower on the screen than the far one.
        let z = DVec3::new(0.0, 0.0, 1.0);
        assert!(p.image(z).y > p.image(-z).y);
    }

    proptest! {
        #[test]
        fn it_is_the_product_of_the_matrices(view in view(), point in in_cube()) {
            let p = Projection::new(&view, viewport());
            // Rodrigues-checked rotations of the thesis's chapter 2, then x to
            // the right and y up, as it stands there. The view turns the world
            // the other way round than the camera.
            let turn: DMat4 = rotation_x(view.tilt.to_radians())
                * rotation_y(-(-view.rotation).to_radians());
            let eye = turn.transform_point3(point);
            let expected = from_pos(viewport().center())
                + DVec2::new(eye.x + view.shift[0], -(eye.y + view.shift[1])) * p.scale();
            prop_assert!((p.image(point) - expected).length() < 1e-9);
            // The viewer stands where z grows.
            prop_assert!((p.toward().dot(point) - eye.z).abs() < 1e-12);
        }

        #[test]
        fn y_stays_upright_and_the_cube_fits(view in view()) {
            let p = Projection::new(&view, viewport());
            prop_assert_eq!(p.image_of_way(DVec3::Y).x, 0.0);
            prop_assert!(p.image_of_way(DVec3::Y).y <= 0.0);
            let fitted = View { size: 1.0, shift: [0.0; 2], ..view };
            let p = Projection::new(&fitted, viewport());
            for (axis, signs) in cube_edges() {
                for corner in edge_ends(Space::default(), axis, signs) {
                    prop_assert!(viewport().contains(p.pos(corner)));
                }
            }
        }

        #[test]
        fn dragging_is_exact(
            view in view(), point in in_cube(), axis in 0..3usize,
            way in prop::array::uniform2(-300.0..300.0f64),
        ) {
            let p = Projection::new(&view, viewport());
            let fixed = Axis::ALL[axis];
            let image = p.image(point) + DVec2::from_array(way);
            match p.point_in_plane(point, fixed, image) {
                None => prop_assert!(p.share_seen(fixed) < EDGE_ON),
                Some(found) => {
                    prop_assert!((p.image(found) - image).length() < 1e-9);
                    prop_assert_eq!(found[axis].to_bits(), point[axis].to_bits());
                }
            }
        }

        #[test]
        fn hidden_edges_are_those_behind_the_cube(view in view(), along in 0.02..0.98f64) {
            let p = Projection::new(&view, viewport());
            // Near an edge-on face the ray below is too short to tell.
            prop_assume!(Axis::ALL.iter().all(|&axis| p.share_seen(axis) > 1e-3));
            let mut hidden = 0;
            for (axis, signs) in cube_edges() {
                let [from, to] = edge_ends(Space::default(), axis, signs);
                // From a point of the edge straight towards the viewer: hidden
                // if that way leads through the cube's inside.
                let start = from.lerp(to, along);
                let behind = (1..2000).any(|step| {
                    let on_way = start + p.toward() * (f64::from(step) * 1e-5);
                    on_way.abs().max_element() < 1.0
                });
                prop_assert_eq!(p.hides_edge(axis, signs), behind);
                hidden += usize::from(behind);
            }
            prop_assert_eq!(hidden, 3);
        }
    }

    #[test]
    fn edge_on_planes_have_no_point() {
        let flat = View {
            rotation: 0.0,
            tilt: 0.0,
            ..View::default()
        };
        let p = Projection::new(&flat, viewport());
        let image = from_pos(pos2(500.0, 400.0));
        assert_eq!(p.point_in_plane(DVec3::ZERO, Axis::X, image), None);
        assert_eq!(p.point_in_plane(DVec3::ZERO, Axis::Y, image), None);
        assert!(p.point_in_plane(DVec3::ZERO, Axis::Z, image).is_some());
        let above = View { tilt: 90.0, ..flat };
        let p = Projection::new(&above, viewport());
        assert!(p.point_in_plane(DVec3::ZERO, Axis::Y, image).is_some());
        assert_eq!(p.point_in_plane(DVec3::ZERO, Axis::Z, image), None);
    }
}
