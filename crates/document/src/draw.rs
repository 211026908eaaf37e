//! A path along a line drawn by hand.

use glam::DVec3;
use vides_engine::tools::fit::{Options, Tolerance, fit};

use super::editing::Document;
use crate::error::Result;
use vides_engine::path::{CameraPath, Orientation, Pose};

const DRAWN: usize = 400;

/// A path along drawn positions at the base speed; its cameras look as the current one does.
pub(super) fn drawn(document: &Document, places: &[DVec3], tolerance: f64) -> Result<CameraPath> {
    let path = document.path();
    let poses: Vec<_> = spread(places, DRAWN)
        .into_iter()
        .map(|place| Pose {
            vrp: place.to_array(),
            vpn: [0.0, 0.0, -1.0],
            vup: [0.0, 1.0, 0.0],
            zoom: 24.0,
        })
        .collect();
    let tolerance = Tolerance {
        position: tolerance,
        angle: 1.0,
    };
    let options = Options {
        space: Some(path.space),
        ..tolerance.into()
    };
    let fps = document.info().fps;
    let mut made = fit(&poses, None, fps, &options, &mut |_, _| true)?.path;
    let here = document.selection();
    let mut view = path.points[here.point].orientations[here.orientation].clone();
    view.own = view.own.for_a_copy()?;
    view.speeds = Orientation::default().speeds;
    for point in &mut made.points {
        point.orientations = vec![view.clone()];
    }
    made.base_frames = path.base_frames;
    Ok(made)
}

/// `count` evenly spaced points along a polyline.
fn spread(line: &[DVec3], count: usize) -> Vec<DVec3> {
    let lengths: Vec<_> = line
        .windows(2)
        .map(|ends| ends[0].distance(ends[1]))
        .collect();
    let whole: f64 = lengths.iter().sum();
    let mut spread = Vec::with_capacity(count);
    let (mut piece, mut passed) = (0, 0.0);
    for number in 0..count {
        let at = whole * number as f64 / (count - 1) as f64;
        while piece + 1 < lengths.len() && passed + lengths[piece] < at {
            passed += lengths[piece];
            piece += 1;
        }
        if let (Some(ends), Some(&length)) = (line.get(piece..piece + 2), lengths.get(piece)) {
            let share = if length > 0.0 {
                ((at - passed) / length).min(1.0)
            } else {
                0.0
            };
            spread.push(ends[0].lerp(ends[1], share));
        }
    }
    spread
}
