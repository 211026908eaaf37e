//! A scene brought to another frame rate: whatever happens in it keeps its second.

use super::interpolation::Interpolation;
use super::motion::{FollowPath, check_frame};
use super::scene::Scene;
use super::track::Track;
use crate::error::Result;
use crate::path::rate;

/// Frame 1 stays where it is.
fn moved(frame: f64, ratio: f64) -> f64 {
    1.0 + (frame - 1.0) * ratio
}

impl Track {
    fn at_rate(&self, ratio: f64) -> Result<Self> {
        let frames = self.frames().iter().map(|frame| moved(*frame, ratio));
        let mut shape = self.shape().to_vec();
        if *self.interpolation() == Interpolation::Hermite {
            shape.iter_mut().for_each(|tangent| *tangent /= ratio);
        }
        let (before, after) = self.extrapolation();
        let (channel, manner) = (self.channel().clone(), self.interpolation().clone());
        Self::new(
            channel,
            manner,
            frames.collect(),
            self.values().to_vec(),
            shape,
        )?
        .with_extrapolation(before, after)
    }
}

impl Scene {
    /// The scene at `ratio` times as many frames a second: keys, markers, starts and the range keep
    /// their seconds, paths as [`rate::at_rate`] says.
    ///
    /// # Errors
    /// [`crate::Error::Range`] or [`crate::Error::Argument`] where something is then beyond its
    /// limits, or keys too close; [`crate::Error::Memory`].
    pub fn at_rate(&self, ratio: f64) -> Result<Self> {
        let mut made = self.clone();
        let pins = std::mem::take(&mut made.pins);
        for marker in &mut made.markers {
            marker.frame = moved(marker.frame, ratio);
            check_frame(marker.frame)?;
        }
        if let Some((first, last)) = self.range {
            // The last frame is shown until the next would begin.
            let last = moved(last + 1.0, ratio) - 1.0;
            made.set_range(Some((moved(first, ratio), last)))?;
        }
        for (at, node) in self.nodes().iter().enumerate() {
            for track in node.keys.tracks() {
                made.set_track(at, track.at_rate(ratio)?)?;
            }
            if let Some(follow) = node.path() {
                let path =
                    follow.timeline(|timeline| rate::at_rate(follow.path(), timeline, ratio))??;
                let start = moved(follow.start_frame(), ratio);
                let follow = FollowPath::new(path, start, follow.extrapolation())?;
                made.set_path(at, Some(follow))?;
            }
        }
        made.pins = pins;
        for marker in &self.markers {
            made.hold_at(&marker.name)?;
        }
        Ok(made)
    }
}

#[cfg(test)]
mod tests {
    use glam::DVec3;

    use super::*;
    use crate::path::{CameraPath, SupportPoint};
    use crate::scene::scene::tests::{states, track};
    use crate::scene::{Camera, Channel, Extrapolation, Kind, Node};

    #[test]
    fn everything_keeps_its_second() {
        let path = |x: f64| CameraPath {
            points: [-0.5, 0.1, 0.6]
                .map(|y| SupportPoint::new(DVec3::new(x, y, 0.5)))
                .to_vec()
                .into(),
            ..CameraPath::default()
        };
        let mut scene = Scene::of_path(path(0.3)).unwrap();
        let mut car = Node::new("car", Kind::Group);
        let shape = [0.0, 0.0, 0.0, 0.1, 0.0, 0.0, 0.2, 0.0, 0.0, 0.0, 0.0, 0.0];
        let keys = Track::new(
            Channel::parse("position").unwrap(),
            Interpolation::Hermite,
            vec![1.0, 41.0],
            vec![0.0, 0.0, 0.0, 5.0, 1.0, 0.0],
            shape.to_vec(),
        );
        car.set_track(keys.unwrap()).unwrap();
        car.set_track(track(
            "scale",
            "cubic",
            &[5.0, 9.0, 33.0],
            &[1.0, 1.0, 1.0, 2.0, 1.5, 1.0, 1.0, 1.0, 2.0],
        ))
        .unwrap();
        let car = scene.add(car).unwrap();
        let mut other = Node::new("other", Kind::Camera(Camera::default()));
        let follow = FollowPath::new(path(-0.2), 11.0, Extrapolation::Hold).unwrap();
        other.set_path(Some(follow)).unwrap();
        let other = scene.add(other).unwrap();
        scene.set_marker("here", 61.0).unwrap();
        scene.pin(other, 1, Some("here")).unwrap();
        scene.set_range(Some((1.0, 101.0))).unwrap();
        let fine = scene.at_rate(3.0).unwrap();
        assert_eq!(fine.marker("here"), Some(181.0));
        assert_eq!(fine.frame_range(), (1.0, 303.0));
        assert_eq!(fine.pins(), scene.pins());
        let place = |scene: &Scene, node: usize, frame: f64| states(scene, frame)[node].matrix;
        for (node, frame) in [(car, 1.0), (car, 17.0), (car, 33.5), (other, 61.0)] {
            let (a, b) = (
                place(&scene, node, frame),
                place(&fine, node, moved(frame, 3.0)),
            );
            let far = a
                .iter()
                .zip(b)
                .map(|(a, b)| (a - b).abs())
                .fold(0.0, f64::max);
            assert!(far < 1e-12, "{node} at {frame}: {far}");
        }
    }
}
