//! Lines on the screen: clipped, dashed, put on whole pixels where that makes them crisp.

use egui::{Color32, Rect};
use glam::{DVec2, DVec3};
use vides_engine::path::Space;
use vides_raster::{Line, Lines};

use super::projection::{Projection, from_pos, to_pos};
use super::scene::Look;
use crate::state::space::solid::Sight;

/// Lengths of a dash and of the gap after it, in points.
const DASH: [f64; 2] = [5.0, 4.0];

/// Collects lines clipped to the viewport, so that the raster gets coordinates of reasonable size.
#[derive(Debug)]
pub(super) struct Strokes<'a> {
    projection: &'a Projection,
    low: DVec2,
    high: DVec2,
    out: Lines,
    /// Lines behind these faces are dimmed.
    sight: Option<&'a Sight>,
    /// How far into the pattern of dashes the last dashed piece went.
    phase: f64,
}

impl<'a> Strokes<'a> {
    pub(super) fn new(projection: &'a Projection, viewport: Rect) -> Self {
        // Wide enough that no round end and no join shows at the border.
        let viewport = viewport.expand(24.0);
        Self {
            projection,
            low: from_pos(viewport.min),
            high: from_pos(viewport.max),
            out: Lines::default(),
            sight: None,
            phase: 0.0,
        }
    }

    /// Those of which one sees whether they lie before or behind an object's faces.
    pub(super) fn in_space(look: &'a Look<'a>) -> Self {
        Self {
            sight: look.sight,
            ..Self::new(look.projection, look.viewport)
        }
    }

    pub(super) fn space(&self) -> Space {
        self.projection.space()
    }

    pub(super) fn finish(self) -> Lines {
        self.out
    }

    /// A line between two images.
    pub(super) fn flat(&mut self, from: DVec2, to: DVec2, width: f32, color: Color32) {
        if let Some([from, to]) = cut(from, to, self.low, self.high) {
            self.out.lines.push(Line {
                from: to_pos(from),
                to: to_pos(to),
                width,
                color,
            });
        }
    }

    /// A disc around an image: a line without length.
    #[allow(clippy::cast_possible_truncation)]
    pub(super) fn disc(&mut self, centre: DVec2, radius: f64, color: Color32) {
        self.flat(centre, centre, 2.0 * radius as f32, color);
    }

    pub(super) fn line(&mut self, from: DVec3, to: DVec3, width: f32, color: Color32) {
        let projection = self.projection;
        let Some(sight) = self.sight else {
            let [from, to] = [from, to].map(|end| projection.image(end));
            return self.flat(from, to, width, color);
        };
        sight.parts(from, to, |start, end, hidden| {
            let [from, to] = [start, end].map(|part| projection.image(from.lerp(to, part)));
            self.flat(from, to, width, dimmed(color, hidden));
        });
    }

    /// Makes the next dashed line begin with a dash.
    pub(super) fn restart_dashes(&mut self) {
        self.phase = 0.0;
    }

    /// A dashed line between two images, which continues the pattern of the last one.
    pub(super) fn flat_dashed(&mut self, from: DVec2, to: DVec2, width: f32, color: Color32) {
        let length = from.distance(to);
        let Some([first, last]) = cut(from, to, self.low, self.high) else {
            self.phase = (self.phase + length) % (DASH[0] + DASH[1]);
            return;
        };
        if !(length > 0.0) {
            return;
        }
        let way = (to - from) / length;
        let [start, end] = [first, last].map(|end| from.distance(end));
        let period = DASH[0] + DASH[1];
        // The beginning of the dash that is under way at `start`.
        let mut at = start - (self.phase + start) % period;
        while at < end {
            let [a, b] = [at.max(start), (at + DASH[0]).min(end)];
            if a < b {
                self.out.lines.push(Line {
                    from: to_pos(from + way * a),
                    to: to_pos(from + way * b),
                    width,
                    color,
                });
            }
            at += period;
        }
        self.phase = (self.phase + length) % period;
    }

    pub(super) fn dashed(&mut self, from: DVec3, to: DVec3, width: f32, color: Color32) {
        let hidden = self.sight.is_some_and(|sight| sight.hides(from));
        let [from, to] = [from, to].map(|end| self.projection.image(end));
        self.flat_dashed(from, to, width, dimmed(color, hidden));
    }
}

/// The colour of lines behind faces.
pub(super) fn dimmed(color: Color32, hidden: bool) -> Color32 {
    if hidden {
        color.gamma_multiply(0.4)
    } else {
        color
    }
}

/// Clips a line to a rectangle (Liang and Barsky 1984); none if it is outside or not finite.
pub(super) fn cut(from: DVec2, to: DVec2, low: DVec2, high: DVec2) -> Option<[DVec2; 2]> {
    let inside = |p: DVec2| p.cmpge(low).all() && p.cmple(high).all();
    if inside(from) && inside(to) {
        return Some([from, to]);
    }
    let ends = [from.extend(0.0), to.extend(0.0)];
    let [low, high] = [low.extend(-1.0), high.extend(1.0)];
    part_between(ends[0], ends[1], low, high).map(|[s, e]| {
        let at = |t: f64| {
            if t == 0.0 {
                from
            } else if t == 1.0 {
                to
            } else {
                from.lerp(to, t).clamp(low.truncate(), high.truncate())
            }
        };
        [at(s), at(e)]
    })
}

/// From where to where, in parts of its length, a line is in a box; none if outside or not finite.
pub(super) fn part_between(from: DVec3, to: DVec3, low: DVec3, high: DVec3) -> Option<[f64; 2]> {
    let way = to - from;
    if !(way.is_finite() && from.is_finite()) {
        return None;
    }
    let [mut start, mut end] = [0.0f64, 1.0f64];
    for axis in 0..3 {
        if way[axis] == 0.0 {
            if from[axis] < low[axis] || from[axis] > high[axis] {
                return None;
            }
            continue;
        }
        let [a, b] = [low, high].map(|face| (face[axis] - from[axis]) / way[axis]);
        start = start.max(a.min(b));
        end = end.min(a.max(b));
    }
    (start <= end).then_some([start, end])
}

/// The middle of a coordinate's pixel: a line there of one pixel's width fills that pixel alone.
pub(super) fn in_pixel(coordinate: f64, pixels_per_point: f64) -> f64 {
    ((coordinate * pixels_per_point).floor() + 0.5) / pixels_per_point
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::super::projection::tests::viewport;
    use super::*;
    use crate::setup::View;

    fn point() -> impl Strategy<Value = DVec2> {
        prop::array::uniform2(-3.0..3.0f64).prop_map(DVec2::from_array)
    }

    proptest! {
        #[test]
        fn cutting_leaves_what_lies_inside(from in point(), to in point()) {
            let [low, high] = [DVec2::NEG_ONE, DVec2::ONE];
            let inside = |p: DVec2, margin: f64| p.abs().max_element() <= 1.0 + margin;
            let found = cut(from, to, low, high);
            for step in 0..=200 {
                let t = f64::from(step) / 200.0;
                let at = from.lerp(to, t);
                match found {
                    None => prop_assert!(!inside(at, -1e-9)),
                    Some([start, end]) => {
                        let way = to - from;
                        let [s, e] = [start, end].map(|p| (p - from).dot(way) / way.length_squared());
                        if inside(at, -1e-9) {
                            prop_assert!(t >= s - 1e-9 && t <= e + 1e-9);
                        } else if t > s + 1e-9 && t < e - 1e-9 {
                            prop_assert!(inside(at, 1e-9));
                        }
                    }
                }
            }
        }

        /// Dashes are laid along the whole row, wherever it is divided.
        #[test]
        fn dashes_go_on_from_piece_to_piece(parts in prop::collection::vec(0.1..30.0f64, 1..12)) {
            let projection = Projection::new(&View::default(), viewport());
            let mut strokes = Strokes::new(&projection, viewport());
            let start = from_pos(viewport().min);
            let mut x = 0.0;
            for part in &parts {
                let at = |x: f64| start + DVec2::X * x;
                strokes.flat_dashed(at(x), at(x + part), 1.0, Color32::RED);
                x += part;
            }
            let lines = strokes.finish().lines;
            let period = DASH[0] + DASH[1];
            let painted = |x: f64| lines.iter().any(|line| {
                let [a, b] = [line.from, line.to].map(|end| f64::from(end.x) - start.x);
                x >= a && x <= b
            });
            for step in 0..400 {
                let x = x * (f64::from(step) + 0.5) / 400.0;
                let in_period = x % period;
                // Single precision leaves the ends of the dashes open.
                if (in_period - DASH[0]).abs() > 1e-3 && in_period > 1e-3 && in_period < period - 1e-3 {
                    prop_assert_eq!(painted(x), in_period < DASH[0]);
                }
            }
        }
    }

    #[test]
    fn what_is_far_away_stays_exact_where_it_is_seen() {
        let far = [DVec2::new(-1e12, 5.0), DVec2::new(1e12, 5.0)];
        let [from, to] = cut(far[0], far[1], DVec2::ZERO, DVec2::splat(10.0)).unwrap();
        assert!((from - DVec2::new(0.0, 5.0)).length() < 1e-3);
        assert!((to - DVec2::new(10.0, 5.0)).length() < 1e-3);
        assert_eq!(cut(DVec2::NAN, far[1], DVec2::ZERO, DVec2::ONE), None);
    }

    #[test]
    fn pixels_are_hit_in_the_middle() {
        assert_eq!(in_pixel(7.0, 1.0), 7.5);
        assert_eq!(in_pixel(7.9, 1.0), 7.5);
        assert_eq!(in_pixel(7.0, 2.0), 7.25);
        assert_eq!(in_pixel(-0.2, 1.0), -0.5);
    }
}
