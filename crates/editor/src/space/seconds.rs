//! A mark on the path for each second of the flight: close together where the camera is slow.

use std::sync::Arc;

use glam::DVec3;
use vides_document::Document;
use vides_document::error::Result;
use vides_raster::Lines;

use super::scene::{Look, LookKey};
use super::strokes::{Strokes, dimmed};
use crate::setup::Element;

/// Radius of a mark, in points.
const RADIUS: f64 = 2.6;

/// A longer flight has a mark every ten seconds, every hundred and so on.
const MOST: f64 = 200.0;

/// On a path of more points the marks wait for the end of a drag.
const MANY_POINTS: usize = 2000;

/// Made again only where the path or the view is another.
#[derive(Debug, Default)]
pub(crate) struct Seconds {
    revision: Option<u64>,
    places: Vec<DVec3>,
    seen: Option<LookKey>,
    lines: Arc<Lines>,
}

impl Seconds {
    pub(super) fn update(&mut self, document: &Document, look: &Look<'_>) -> &Arc<Lines> {
        let revision = Some(document.revision());
        let other = self.revision != revision;
        if other {
            self.revision = revision;
            // A path that cannot be sampled has no marks; why is said elsewhere.
            self.places = places(document).unwrap_or_default();
        }
        let seen = Some(look.key());
        if other || self.seen != seen {
            self.seen = seen;
            let mut strokes = Strokes::new(look.projection, look.viewport);
            if let Some(color) = look.of(Element::Curve) {
                for &place in &self.places {
                    let hidden = look.sight.is_some_and(|sight| sight.hides(place));
                    let image = look.projection.image(place);
                    strokes.disc(image, RADIUS, dimmed(color, hidden));
                }
            }
            self.lines = Arc::new(strokes.finish());
        }
        &self.lines
    }
}

/// Where the camera is at each whole second between the first frame and the last.
fn places(document: &Document) -> Result<Vec<DVec3>> {
    if document.in_step() && document.path().points.len() > MANY_POINTS {
        return Ok(Vec::new());
    }
    let sampler = document.sampler()?;
    #[allow(clippy::cast_precision_loss)]
    let last = sampler.frame_count() as f64;
    let mut every = document.info().fps;
    while (last - 1.0) / every > MOST {
        every *= 10.0;
    }
    let frames = (1..).map(|count| 1.0 + f64::from(count) * every);
    let frames = frames.take_while(|&frame| frame < last);
    frames
        .map(|frame| Ok(sampler.pose(frame)?.position()))
        .collect()
}

#[cfg(test)]
mod tests {
    use super::super::scene::tests::Eye;
    use super::*;
    use crate::setup::View;
    use crate::tests::{At, Edit, some_points};

    /// As many marks as whole seconds have passed before the end, each where the camera is then.
    #[test]
    fn each_second_has_a_mark_where_the_camera_is() {
        let mut document = some_points();
        let eye = Eye::new(&View::default());
        let mut seconds = Seconds::default();
        for fps in [25.0, 10.0] {
            let info = vides_document::Info {
                fps,
                ..document.info().clone()
            };
            document.apply(Edit::SetInfo(Box::new(info))).unwrap();
            seconds.update(&document, &eye.look());
            let poses = document.sampler().unwrap();
            let count = poses.frame_count();
            let whole = (1..count - 1).filter(|at| at % fps as usize == 0).count();
            assert_eq!(seconds.places.len(), whole);
            for (at, place) in seconds.places.iter().enumerate() {
                let frame = 1.0 + (at + 1) as f64 * fps;
                assert_eq!(*place, poses.pose(frame).unwrap().position());
            }
        }
        // They follow the path.
        let before = seconds.places.clone();
        let moved = Edit::set(At::Point(0), "position", DVec3::splat(0.4));
        document.apply(moved).unwrap();
        seconds.update(&document, &eye.look());
        assert_ne!(seconds.places, before);
    }
}
