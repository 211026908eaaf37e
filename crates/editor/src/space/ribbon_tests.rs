//! Tests of [`super`].

use proptest::prelude::*;
use vides_document::{At, Edit};

use super::super::cameras::KeyCameras;
use super::super::projection::Projection;
use super::super::projection::tests::{view, viewport};
use super::super::scene::tests::{Eye, document, edit};
use super::super::tests::pyramid;
use super::*;

proptest! {
    #![proptest_config(ProptestConfig::with_cases(32))]

    /// Whatever was done: what is kept up to date is what is made anew.
    #[test]
    fn what_is_kept_equals_what_is_made_anew(
        edits in prop::collection::vec((edit(40), 0..6u8), 1..20), views in prop::array::uniform3(view()),
    ) {
        let mut document = document(40);
        let mut eye = Eye::new(&views[0]);
        let (mut ribbon, mut keys) = (Ribbon::default(), KeyCameras::default());
        let contents = |ribbon: &mut Ribbon, look: &Look<'_>| -> Vec<_> {
            let made = ribbon.made(look).into_iter();
            made.map(|(mesh, lines)| (Mesh::clone(mesh), lines.lines.clone())).collect()
        };
        for (edit, also) in edits {
            // Some cannot be done; that is no change then.
            let _ = document.apply(edit);
            match also {
                0 => { document.undo(); }
                1 => eye.projection = Projection::new(&views[1], viewport()),
                2 => eye.projection = Projection::new(&views[2], viewport()),
                3 => { let _ = document.select(7, 0); }
                _ => {}
            }
            let look = eye.look();
            ribbon.update(&document).unwrap();
            let mut anew = Ribbon::default();
            anew.update(&document).unwrap();
            prop_assert_eq!(contents(&mut ribbon, &look), contents(&mut anew, &look));
            let anew = KeyCameras::default().update(&document, &look).lines.clone();
            prop_assert_eq!(&keys.update(&document, &look).lines, &anew);
        }
    }
}

/// A long path gives the ribbon no more poses than can be seen, the keys
/// included.
#[test]
fn the_ribbon_of_a_long_path_is_thinned() {
    let mut document = pyramid();
    let mut speeds = document.path().base_frames;
    speeds.movement = 5000.0;
    document
        .apply(Edit::set(At::Path, "base_speeds", speeds))
        .unwrap();
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
        .apply(Edit::set(At::Point(0), "position", at))
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
