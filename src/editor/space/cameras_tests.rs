//! Tests of [`super::cameras`].

use egui::{Rect, pos2, vec2};

use super::tests::pyramid;
use super::*;
use crate::document::Edit;
use crate::editor::setup::View;

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
    let poses = ribbon.poses();
    assert_eq!(poses.len(), sampler.frame_count());
    for (frame, found) in (1u32..).zip(poses) {
        let pose: Camera = sampler.pose(f64::from(frame)).unwrap().into();
        assert!(found.position.abs_diff_eq(pose.position, 1e-9));
        assert!(found.up.abs_diff_eq(pose.up, 1e-9));
        assert!(found.view.abs_diff_eq(pose.view, 1e-9));
    }
    assert!(cameras::keys(&document, &look(&hidden)).lines.is_empty());
}

/// A long path gives the ribbon no more poses than can be seen, ends included.
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
    let poses = ribbon.poses();
    assert_eq!(poses.len(), 1200);
    #[allow(clippy::cast_precision_loss)]
    let last = sampler.pose(sampler.frame_count() as f64).unwrap();
    assert_eq!(poses[0], sampler.pose(1.0).unwrap().into());
    assert_eq!(poses[1199], last.into());
}
