//! A path that begins where the host's camera is.

use glam::DVec3;
use vides_document::error::{Result, can_allocate};
use vides_document::{Document, Edit};
use vides_engine::path::{CameraPath, Orientation, Pose, Target};

use super::{checked, seen_by};

/// How far the camera goes to the right at first, in shares of the distance of what it looks at.
const ASIDE: f64 = 0.5;

/// Has a new path begin with a pose of the host's. It leads aside, and the camera keeps what is in
/// the middle of its picture there: at the depth of the object's middle, or that of the space.
///
/// # Errors
/// `ErrorKind::Argument`, `ErrorKind::Range` for a pose that is not valid; `ErrorKind::Memory`.
pub fn begin_at(document: &mut Document, pose: &Pose) -> Result<()> {
    let path = document.path();
    let space = path.space;
    let pose = checked(pose, space)?;
    let [position, view, up] = [pose.vrp, pose.vpn, pose.vup].map(DVec3::from_array);
    let middle = document.object_middle().unwrap_or(space.centre);
    // What lies behind the camera, or at it, it does not look at.
    let depth = (middle - position).dot(view);
    let depth = if depth > 0.01 * space.half_size {
        depth
    } else {
        space.half_size
    };
    let first = seen_by(&pose, space, &path.points[0].orientations[0]);
    let second = Orientation {
        target: Target::Absolute(position + depth * view),
        ..first.clone()
    };
    let mut points = path.try_clone()?.points;
    points[0].position = position;
    points[0].orientations[0] = first;
    points[1].position = position + ASIDE * depth * view.cross(up);
    points[1].orientations[0] = second;
    let begun = CameraPath { points, ..*path };
    can_allocate(size_of::<CameraPath>())?;
    document.apply(Edit::ReplacePath(Box::new(begun)))
}

/// Whether a pose of the host's could be one of a document's path.
///
/// # Errors
/// `ErrorKind::Argument`, `ErrorKind::Range` if not.
pub fn check_view(document: &Document, pose: &Pose) -> Result<()> {
    checked(pose, document.path().space).map(drop)
}

#[cfg(test)]
mod tests {
    use super::*;
    use vides_engine::path::Space;

    #[test]
    fn a_path_begins_with_the_hosts_pose() {
        for (at, half_size) in [(DVec3::ZERO, 1.0), (DVec3::new(900.0, 20.0, -70.0), 250.0)] {
            let mut document = Document::new();
            let space = Space {
                centre: at,
                half_size,
                ..Space::default()
            };
            document.apply(Edit::SetSpace { space, fit: true }).unwrap();
            let view = DVec3::new(-0.48, -0.6, -0.64);
            let up = DVec3::new(0.3, 1.0, 0.2);
            let pose = Pose {
                vrp: (at + half_size * DVec3::new(0.7, 0.9, 1.1)).to_array(),
                vpn: (3.0 * view).to_array(),
                vup: up.to_array(),
                zoom: 31.0,
            };
            begin_at(&mut document, &pose).unwrap();
            let sampler = document.sampler().unwrap();
            let seen = sampler.pose(1.0).unwrap();
            let level = (up - view * up.dot(view)).normalize();
            let near = |a: [f64; 3], b: DVec3| DVec3::from_array(a).distance(b) < 1e-12;
            assert_eq!((seen.vrp, seen.zoom), (pose.vrp, 31.0));
            assert!(near(seen.vpn, view) && near(seen.vup, level), "{seen:?}");
            assert!(sampler.frame_count() > 10);
        }
        let mut document = Document::new();
        let before = document.path().clone();
        let wrong = Pose {
            vpn: [0.0; 3],
            ..Pose::default()
        };
        assert!(begin_at(&mut document, &wrong).is_err());
        assert_eq!(*document.path(), before);
    }
}
