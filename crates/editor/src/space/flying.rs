//! Flying in the camera's picture: looking around, walking, circling. Arithmetic without a window.

use glam::{DQuat, DVec3};
use vides_engine::path::Space;

use crate::space::cameras::Camera;

/// Degrees of turning for each point of mouse motion.
const TURN: f64 = 0.3;

/// The view comes no nearer to the vertical than this, in degrees.
const POLE: f64 = 0.5;

/// How far a notch of the wheel and a point of mouse motion walk, in units of `half_size`.
pub(super) const NOTCH: f64 = 0.08;
pub(super) const DRAG: f64 = 0.004;

/// Walking speed of a held key, in units of `half_size` per second.
pub(super) const WALK: f64 = 0.6;

/// Looks around by a mouse motion in points.
pub(super) fn looked(camera: Camera, space: Space, [right, down]: [f64; 2]) -> Camera {
    let turned = turn(&camera, space, [-right * TURN, -down * TURN]);
    Camera {
        view: turned * camera.view,
        up: turned * camera.up,
        ..camera
    }
}

/// Circles around what is in the middle of the picture, as if the mouse turned that.
pub(super) fn circled(camera: Camera, space: Space, [right, down]: [f64; 2]) -> Camera {
    let middle = camera.position + camera.view * depth(&camera, space);
    let turned = turn(&camera, space, [-right * TURN, -down * TURN]);
    Camera {
        position: middle + turned * (camera.position - middle),
        view: turned * camera.view,
        up: turned * camera.up,
        ..camera
    }
}

/// Walks to the right, up and ahead, in units of `half_size`.
pub(super) fn walked(camera: Camera, space: Space, [right, up, ahead]: [f64; 3]) -> Camera {
    let way = camera.view.cross(camera.up) * right + camera.up * up + camera.view * ahead;
    let far = DVec3::splat(FAR * space.half_size);
    let to = camera.position + way * space.half_size;
    Camera {
        position: to.clamp(space.centre - far, space.centre + far),
        ..camera
    }
}

/// Farthest flight from the middle along each axis, in units of `half_size`.
const FAR: f64 = 50.0;

/// Distance of what it looks at: as far as the middle of the space.
fn depth(camera: &Camera, space: Space) -> f64 {
    let middle = (space.centre - camera.position).dot(camera.view);
    middle.max(0.1 * space.half_size)
}

/// A turn about the vertical, then up or down, in degrees; never over a pole.
fn turn(camera: &Camera, space: Space, [aside, rise]: [f64; 2]) -> DQuat {
    let vertical = space.up.world(DVec3::Y);
    let height = camera
        .view
        .dot(vertical)
        .clamp(-1.0, 1.0)
        .asin()
        .to_degrees();
    let most = 90.0 - POLE;
    // A view already nearer to the pole is not pushed away from it.
    let rise = (height + rise).clamp((-most).min(height), most.max(height)) - height;
    let level = camera.view.cross(vertical);
    let level = level
        .try_normalize()
        .unwrap_or(camera.view.cross(camera.up));
    DQuat::from_axis_angle(vertical, aside.to_radians())
        * DQuat::from_axis_angle(level.normalize(), rise.to_radians())
}

#[cfg(test)]
mod tests {
    use super::*;
    use vides_engine::path::Up;

    fn spaces() -> [Space; 2] {
        let far = Space {
            centre: DVec3::new(100.0, -20.0, 3.0),
            half_size: 40.0,
            up: Up::Z,
        };
        [Space::default(), far]
    }

    fn camera(space: Space) -> Camera {
        let position = space.centre + DVec3::new(0.4, 0.3, 0.9) * space.half_size;
        let view = (space.centre - position).normalize();
        let up = space.up.up_from_roll(view, 0.3);
        Camera {
            position,
            view,
            up,
            zoom: 24.0,
        }
    }

    fn is_rigid(camera: &Camera) {
        assert!((camera.view.length() - 1.0).abs() < 1e-12);
        assert!((camera.up.length() - 1.0).abs() < 1e-12);
        assert!(camera.view.dot(camera.up).abs() < 1e-12);
    }

    #[test]
    fn looking_turns_on_the_spot_and_stops_before_the_poles() {
        for space in spaces() {
            let from = camera(space);
            let vertical = space.up.world(DVec3::Y);
            let aside = looked(from, space, [100.0, 0.0]);
            assert_eq!(aside.position, from.position);
            // The height of what it looks at stays; it has turned by 30°.
            assert!((aside.view.dot(vertical) - from.view.dot(vertical)).abs() < 1e-12);
            let flat = |v: DVec3| (v - vertical * v.dot(vertical)).normalize();
            let angle = flat(aside.view).dot(flat(from.view)).acos().to_degrees();
            assert!((angle - 30.0).abs() < 1e-9, "{angle}");
            // To the right: towards view × up.
            assert!((aside.view - from.view).dot(from.view.cross(vertical)) > 0.0);
            let mut down = from;
            for _ in 0..100 {
                down = looked(down, space, [3.0, 40.0]);
                is_rigid(&down);
            }
            let height = down.view.dot(vertical).asin().to_degrees();
            assert!((height + 90.0 - POLE).abs() < 1e-6, "{height}");
        }
    }

    #[test]
    fn circling_keeps_the_middle_in_the_middle() {
        for space in spaces() {
            let mut at = camera(space);
            let distance = at.position.distance(space.centre);
            for step in 0..50 {
                at = circled(at, space, [7.0, f64::from(step % 9) - 4.0]);
                is_rigid(&at);
                let view = (space.centre - at.position).normalize();
                assert!(view.abs_diff_eq(at.view, 1e-9));
                let now = at.position.distance(space.centre);
                assert!((now / distance - 1.0).abs() < 1e-9);
            }
        }
    }

    #[test]
    fn walking_goes_where_the_picture_says() {
        for space in spaces() {
            let from = camera(space);
            let to = walked(from, space, [0.0, 0.0, 0.25]);
            let gone = to.position - from.position;
            assert!(gone.abs_diff_eq(from.view * 0.25 * space.half_size, 1e-9));
            let to = walked(from, space, [0.5, 0.0, 0.0]).position - from.position;
            assert!(to.dot(from.view).abs() < 1e-9 && to.dot(from.up).abs() < 1e-9);
            // Not out of the world.
            let far = walked(from, space, [1e9, 0.0, 0.0]);
            assert!(space.check_place(far.position).is_ok());
        }
    }
}
