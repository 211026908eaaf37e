//! Tests of [`super::cameras`].

use egui::{Rect, pos2, vec2};

use super::tests::pyramid;
use super::*;
use crate::document::Edit;
use crate::editor::setup::View;
use crate::path::Timeline;

/// Every orientation is there as a camera, and the ribbon is the flight.
#[test]
fn all_orientations_of_the_path_are_shown() {
    let document = pyramid();
    let projection = Projection::new(
        &View::default(),
        Rect::from_min_size(pos2(0.0, 0.0), vec2(900.0, 700.0)),
    );
    let shown = crate::editor::setup::Shown::default();
    let mut hidden = shown;
    hidden.set(Element::Cameras, false);
    let colours = crate::editor::setup::Colours::DARK;
    let look = |shown| Look {
        projection: &projection,
        room: Rect::from_min_size(pos2(0.0, 0.0), vec2(900.0, 700.0)),
        pixels_per_point: 1.0,
        colours: &colours,
        shown,
    };
    // Nine orientations at six points, eleven lines each.
    assert_eq!(cameras::keys(&document, &look(&shown)).lines.len(), 9 * 11);
    let mut ribbon = Ribbon::default();
    ribbon.update(&document).unwrap();
    let sampler = document.sampler().unwrap();
    // Frames in which the camera rests are one and the same to be seen.
    let mut poses = ribbon.poses();
    let mut last: Option<Camera> = None;
    for frame in 1..=sampler.frame_count() {
        #[allow(clippy::cast_precision_loss)]
        let pose: Camera = sampler.pose(frame as f64).unwrap().into();
        if last.replace(pose) == Some(pose) {
            continue;
        }
        let found = poses.next().expect("a pose for each frame");
        assert!(found.position.abs_diff_eq(pose.position, 1e-9));
        assert!(found.up.abs_diff_eq(pose.up, 1e-9));
        assert!(found.view.abs_diff_eq(pose.view, 1e-9));
    }
    assert!(poses.next().is_none());
    assert!(cameras::keys(&document, &look(&hidden)).lines.is_empty());
}

/// A long path gives the ribbon no more poses than can be seen, the keys
/// included.
#[test]
fn the_ribbon_of_a_long_path_is_thinned() {
    let mut document = pyramid();
    let mut speeds = document.path().speeds;
    speeds.movement = 5000.0;
    document.apply(Edit::SetSpeeds(speeds)).unwrap();
    let mut ribbon = Ribbon::default();
    ribbon.update(&document).unwrap();
    let sampler = document.sampler().unwrap();
    assert!(sampler.frame_count() > 10_000);
    let poses: Vec<_> = ribbon.poses().collect();
    assert!((600..1300).contains(&poses.len()), "{}", poses.len());
    for section in 0..document.timeline(Timeline::section_count).unwrap() {
        #[allow(clippy::cast_precision_loss)]
        let key = sampler.first_frame(section) as f64 - 1.0;
        let key: Camera = sampler.pose(key).unwrap().into();
        assert!(poses.contains(&key), "section {section}");
    }
    #[allow(clippy::cast_precision_loss)]
    let last = sampler.pose(sampler.frame_count() as f64).unwrap();
    assert_eq!(poses.last(), Some(&last.into()));
}

/// What a change does not reach keeps its part of the ribbon, so that nothing
/// is painted again there.
#[test]
fn the_ribbon_changes_only_where_the_path_does() {
    let mut document = pyramid();
    let mut ribbon = Ribbon::default();
    ribbon.update(&document).unwrap();
    let before: Vec<_> = ribbon.poses().collect();
    let at = document.path().points[0].position + DVec3::new(0.05, 0.03, 0.0);
    document
        .apply(Edit::SetPosition {
            at: 0,
            position: at,
        })
        .unwrap();
    ribbon.update(&document).unwrap();
    let after: Vec<_> = ribbon.poses().collect();
    assert_ne!(before[0], after[0]);
    let key = Camera::at(&document, 3, 0).unwrap();
    let rest = |poses: &[Camera]| {
        let at = poses.iter().position(|pose| pose.position == key.position);
        poses[at.unwrap()..].to_vec()
    };
    let (before, after) = (rest(&before), rest(&after));
    assert_eq!(before.len(), after.len());
    for (a, b) in before.iter().zip(&after) {
        assert!(a.position.abs_diff_eq(b.position, 1e-12));
        assert!(a.up.abs_diff_eq(b.up, 1e-12));
    }
}
