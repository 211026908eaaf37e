//! Another frame rate: what happens keeps its second.

use std::iter;

use super::edit::{At, Edit};
use super::editing::Document;
use super::info::Info;
use crate::error::Result;
use vides_engine::path::CameraPath;
use vides_engine::path::rate::at_rate;
use vides_engine::scene::{FollowPath, Part};

impl Document {
    /// The edits, to be one step, after which the document has another rate and everything in it
    /// keeps its second: sections, holds, keys, markers, starts. [`Edit::SetInfo`] alone keeps the
    /// frames instead, so that the film gets faster or slower.
    ///
    /// # Errors
    /// `ErrorKind::Range` for the rate, or where something is beyond its limits at this rate;
    /// `ErrorKind::Memory`.
    pub fn rate_edits(&self, fps: f64) -> Result<Vec<Edit>> {
        let info = Info {
            fps,
            ..self.info().try_clone()?
        };
        info.check(self.path().space)?;
        let ratio = fps / self.info().fps;
        let mut edits = vec![Edit::SetInfo(Box::new(info))];
        let Some(edited) = self.edited_scene() else {
            let made = self.timeline(|timeline| at_rate(self.path(), timeline, ratio))??;
            edits.extend(of_path(self.path(), &made));
            return Ok(edits);
        };
        let scene = self.scene()?.at_rate(ratio)?;
        let mut parts = Vec::new();
        for marker in scene.markers() {
            let (name, frame) = (marker.name.clone(), Some(marker.frame));
            parts.push(Part::Marker { name, frame });
        }
        let own = edited.scene().range().and(scene.range());
        parts.extend(own.map(|range| Part::Range(Some(range))));
        for (node, at) in scene.nodes().iter().zip(0..) {
            for track in node.keys().tracks() {
                let channel = track.channel().clone();
                parts.push(Part::track(at, channel, Some(track.clone()))?);
            }
            let Some(follow) = node.path() else {
                continue;
            };
            if Some(at) == edited.node() {
                edits.extend(of_path(self.path(), follow.path()));
                parts.push(Part::Start {
                    node: at,
                    start_frame: follow.start_frame(),
                    beyond: follow.extrapolation(),
                });
            } else {
                let path = follow.path().try_clone()?;
                let follow = FollowPath::new(path, follow.start_frame(), follow.extrapolation())?;
                parts.push(Part::path(at, Some(follow))?);
            }
        }
        edits.extend(parts.into_iter().map(|part| Edit::Part(Box::new(part))));
        Ok(edits)
    }
}

/// The edits that make a path another one with the same points.
fn of_path(path: &CameraPath, made: &CameraPath) -> impl Iterator<Item = Edit> {
    let speeds = Edit::set(At::Path, "base_speeds", made.base_frames);
    let points = path.points.iter().zip(&made.points).zip(0..);
    let views = points.flat_map(|((old, new), point)| {
        let views = old.orientations.iter().zip(&new.orientations).zip(0..);
        views.filter_map(move |((old, new), at)| {
            let orientation = new.clone();
            (old != new).then_some(Edit::SetOrientation {
                point,
                at,
                orientation,
            })
        })
    });
    iter::once(speeds).chain(views)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn another_rate_is_one_step() {
        let mut document = Document::new();
        document
            .set_property("point.1.view.1.hold_frames", "50")
            .unwrap();
        document
            .set_property("point.1.view.1.frames", "100")
            .unwrap();
        let before = document.path().try_clone().unwrap();
        let edits = document.rate_edits(50.0).unwrap();
        document.apply_all(edits).unwrap();
        let orientation = &document.path().points[0].orientations[0];
        assert_eq!((orientation.hold, orientation.own.frames), (100, 200));
        assert_eq!(document.info().fps, 50.0);
        assert!(document.undo());
        assert_eq!((document.path(), document.info().fps), (&before, 25.0));
        for bad in [0.0, -1.0, f64::NAN, f64::INFINITY] {
            assert!(document.rate_edits(bad).is_err());
        }
    }
}
