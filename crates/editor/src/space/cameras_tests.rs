//! Tests of [`super::cameras`].

use egui::{Rect, pos2, vec2};

use super::tests::pyramid;
use super::*;
use crate::setup::View;
use crate::space::ribbon::Ribbon;

/// Every point has a camera, and the ribbon is the flight.
#[test]
fn each_point_of_the_path_has_a_camera() {
    let document = pyramid();
    let projection = Projection::new(
        &View::default(),
        Rect::from_min_size(pos2(0.0, 0.0), vec2(900.0, 700.0)),
    );
    let shown = crate::setup::Shown::default();
    let mut hidden = shown;
    hidden.set(Element::Cameras, false);
    let colours = crate::setup::Colours::DARK;
    let look = |shown| Look {
        sight: None,
        projection: &projection,
        viewport: Rect::from_min_size(pos2(0.0, 0.0), vec2(900.0, 700.0)),
        pixels_per_point: 1.0,
        colours: &colours,
        shown,
        pane: None,
    };
    // Nine orientations at six points: one camera each, of eleven lines.
    let count = |look: &Look<'_>| {
        let others = cameras::KeyCameras::default()
            .update(&document, look)
            .lines
            .len();
        others + cameras::current_key(&document, look).lines.len()
    };
    assert_eq!(count(&look(&shown)), 6 * 11);
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
    assert_eq!(count(&look(&hidden)), 0);
}
