//! The path with which a window begins: where an object is given the camera looks at it.

use glam::DVec3;

use super::camera_path::{CameraPath, Orientation, Target};
use super::space::Space;
use crate::error::Result;
use crate::math::view::HALF_FILM_HEIGHT;

/// The shortest lens that is taken to get all of an object into the picture: 106 degrees high.
const SHORTEST: f64 = 9.0;

/// What the object's box is taken larger by, so that it does not touch the picture's edge.
const SPARE: f64 = 1.05;

/// A box as a camera sees it that looks at its middle.
struct Seen {
    /// Of each corner: how far from the line of sight, to the side or up, and how much farther than
    /// the middle.
    corners: [(f64, f64); 8],
}

impl Seen {
    fn new([low, high]: [DVec3; 2], view: DVec3, space: Space) -> Self {
        let (aside, up) = space.up.level_axes(view);
        let corners = std::array::from_fn(|at| {
            let half = 0.5 * SPARE * (high - low);
            let sign = |bit: usize| if at & bit == 0 { -1.0 } else { 1.0 };
            let corner = half * DVec3::new(sign(1), sign(2), sign(4));
            let off = corner.dot(aside).abs().max(corner.dot(up).abs());
            (off, corner.dot(view))
        });
        Self { corners }
    }

    /// The distance from the middle at which a lens shows all of it, in a square picture.
    fn distance(&self, zoom: f64) -> f64 {
        let far = |&(off, behind): &(f64, f64)| off * zoom / HALF_FILM_HEIGHT - behind;
        self.corners.iter().map(far).fold(0.0, f64::max)
    }

    /// The longest lens up to `zoom` that shows all of it at a distance.
    fn zoom(&self, distance: f64, zoom: f64) -> f64 {
        let lens = |&(off, behind): &(f64, f64)| {
            let depth = distance + behind;
            if depth > 0.0 {
                HALF_FILM_HEIGHT * depth / off
            } else {
                0.0
            }
        };
        self.corners
            .iter()
            .map(lens)
            .fold(zoom, f64::min)
            .max(SHORTEST)
    }
}

impl CameraPath {
    /// The path that a new window begins with around an object, given by the corners of its box: as
    /// without one, but the camera looks at the object's middle. It is farther away where it would
    /// not see all of it, yet within the space, and has a shorter lens where that is not enough.
    ///
    /// # Errors
    /// [`crate::Error::Memory`].
    pub fn first(space: Space, [low, high]: [DVec3; 2]) -> Result<Self> {
        let mut path = Self::try_new()?;
        path.space = space;
        let middle = low + 0.5 * (high - low);
        let mut zoom = Orientation::default().zoom;
        for point in &mut path.points {
            point.position = space.place(point.position);
            point.orientations[0] = Orientation::new_in(space);
            let away = point.position - middle;
            // In single precision an object may hold no place that differs from the point's.
            if !(away.length() > 1e-6 * space.half_size) {
                continue;
            }
            let back = away.normalize();
            let seen = Seen::new([low, high], -back, space);
            let wanted = seen
                .distance(zoom)
                .min(room(space, middle, back))
                .max(away.length());
            if wanted > away.length() {
                point.position = middle + back * wanted;
            }
            point.orientations[0].target = Target::Absolute(middle);
            zoom = seen.zoom(wanted, zoom);
        }
        for point in &mut path.points {
            point.orientations[0].zoom = zoom;
        }
        Ok(path)
    }
}

/// How far from a place the space reaches in a direction; 0 if the place is outside.
fn room(space: Space, from: DVec3, towards: DVec3) -> f64 {
    let (low, high) = (space.low(), space.high());
    if from.cmplt(low).any() || from.cmpgt(high).any() {
        return 0.0;
    }
    let walls = (0..3).map(|axis| match towards[axis] {
        along if along > 0.0 => (high[axis] - from[axis]) / along,
        along if along < 0.0 => (low[axis] - from[axis]) / along,
        _ => f64::INFINITY,
    });
    walls.fold(f64::INFINITY, f64::min)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::path::{Sampler, Timeline, Up};

    /// Where the corners of a box are in the pictures of both points: at most ±1 to the side and up,
    /// in a square picture; infinite behind the camera.
    fn most(path: &CameraPath, [low, high]: [DVec3; 2]) -> f64 {
        let timeline = Timeline::new(path).unwrap();
        let sampler = Sampler::new(path, &timeline).unwrap();
        let mut most: f64 = 0.0;
        for frame in [1, timeline.frame_count().unwrap()] {
            let pose = sampler.pose(frame as f64).unwrap();
            let [vrp, vpn, vup] = [pose.vrp, pose.vpn, pose.vup].map(DVec3::from_array);
            for corner in 0..8 {
                let pick = |bit: usize| if corner & bit == 0 { low } else { high };
                let place = DVec3::new(pick(1).x, pick(2).y, pick(4).z) - vrp;
                let depth = place.dot(vpn);
                let aside = place.dot(vpn.cross(vup)).abs().max(place.dot(vup).abs());
                let at = aside / depth * pose.zoom / HALF_FILM_HEIGHT;
                most = most.max(if depth > 0.0 { at } else { f64::INFINITY });
            }
        }
        most
    }

    #[test]
    fn an_object_is_in_the_picture_from_a_place_in_the_space() {
        for up in [Up::Y, Up::Z] {
            for (half_size, centre) in [(1.0, DVec3::ZERO), (40.0, DVec3::new(300.0, -5.0, 9.0))] {
                let space = Space {
                    centre,
                    half_size,
                    up,
                };
                for (middle, half) in [
                    (DVec3::ZERO, DVec3::splat(0.05)),
                    (DVec3::ZERO, DVec3::splat(0.4)),
                    (DVec3::new(-0.4, -0.3, 0.2), DVec3::splat(0.3)),
                    (DVec3::ZERO, DVec3::new(0.8, 0.1, 0.3)),
                ] {
                    let corners = [middle - half, middle + half].map(|p| centre + half_size * p);
                    let path = CameraPath::first(space, corners).unwrap();
                    path.check_in(space).unwrap();
                    assert!(
                        most(&path, corners) < 1.0,
                        "{middle} {half} {}",
                        most(&path, corners)
                    );
                    for point in &path.points {
                        let place = (point.position - centre) / half_size;
                        assert!(place.abs().max_element() < 1.0 + 1e-9, "{place}");
                    }
                }
            }
        }
    }

    #[test]
    fn a_small_object_changes_the_targets_alone() {
        let corners = [DVec3::splat(-0.1), DVec3::splat(0.1)];
        let path = CameraPath::first(Space::default(), corners).unwrap();
        let plain = CameraPath::try_new().unwrap();
        for (point, before) in path.points.iter().zip(&plain.points) {
            assert_eq!(point.position, before.position);
            let view = &point.orientations[0];
            assert_eq!(view.target, Target::Absolute(DVec3::ZERO));
            assert_eq!(view.zoom, before.orientations[0].zoom);
        }
    }
}
