//! Tangents, pace, fixed frames, views along the way and points that keep the motion,
//! as edits and in files: each is taken back to the last bit, and comes back
//! from its file to the last bit.

mod common;

use common::Random;
use glam::{DMat4, DVec3};
use vides::document::{At, Document, Edit};
use vides::path::{
    CurveKind, Ease, EaseKind, OrientationOverrides, Pace, Tangents, Up, UpPath, UpVector, own,
};

fn document(random: &mut Random) -> Document {
    let path = random.path(30.0);
    Document::from_parts(path, Default::default()).expect("a path")
}

/// A change of what an orientation owns.
fn owning(
    document: &Document,
    point: usize,
    change: impl FnOnce(&mut OrientationOverrides),
) -> Edit {
    let mut orientation = document.path().points[point].orientations[0].clone();
    orientation.own = orientation.own.with(change).expect("memory");
    Edit::SetOrientation {
        point,
        at: 0,
        orientation,
    }
}

fn edits(random: &mut Random, document: &Document) -> Vec<Edit> {
    let at = random.below(document.path().points.len());
    let mut vector = || DVec3::new(random.between(-1.0, 1.0), -0.0, random.between(-1.0, 1.0));
    let tangents = Tangents {
        before: vector(),
        after: vector(),
    };
    let ease = Ease {
        kind: EaseKind::Parabolic,
        rise: random.between(0.0, 0.5),
        fall: random.between(0.0, 0.5),
        cruise: random.between(1.0, 100.0),
    };
    let keys = [[0.0, 0.0], [random.between(0.1, 0.9), 0.3], [1.0, 1.0]];
    let last = document.path().points.len() - 1;
    let up = match (random.between(0.0, 7.0)) as usize {
        0 => UpVector::Axis,
        1 => UpVector::Point(tangents.after),
        2 => UpVector::Path(UpPath::of(document.path()).unwrap()),
        3 => UpVector::Minimal,
        4 => UpVector::Fixed(Up::Y),
        5 => UpVector::Fixed(Up::Z),
        _ => UpVector::Frenet,
    };
    let frames = document.timeline(|t| t.frame_count()).unwrap().unwrap_or(1);
    let frame = random.between(1.0, frames as f64);
    vec![
        Edit::set(At::Point(at), "tangents", Some(tangents)),
        Edit::set(At::Path, "curve", CurveKind::Cubic),
        owning(document, at, |own| own.pace = Pace::Ease(ease)),
        owning(document, at, |own| own.pace = own::distance(&keys).unwrap()),
        owning(document, at, |own| own.frames = 77),
        owning(document, at, |own| own.ahead = Some(0.25)),
        owning(document, at, |own| own.up = up.clone()),
        owning(document, last, |own| own.up = up.clone()),
        Edit::InsertOnCurve { frame },
        Edit::FitFrames {
            first: 0,
            last,
            frames: frames + 500,
        },
    ]
}

#[test]
fn each_edit_is_undone_and_saved_to_the_last_bit() {
    let mut random = Random::new(71);
    let (mut done, mut inserted) = (0, 0);
    for _ in 0..150 {
        let mut document = document(&mut random);
        for k in 0..10 {
            let edit = edits(&mut random, &document).swap_remove(k);
            let inserts = matches!(edit, Edit::InsertOnCurve { .. });
            let before = document.to_toml().unwrap();
            if document.apply(edit.clone()).is_err() {
                assert_eq!(document.to_toml().unwrap(), before);
                continue;
            }
            let after = document.to_toml().unwrap();
            // The same up twice is no edit.
            if after == before {
                continue;
            }
            let undone = document.undo();
            assert_eq!(document.to_toml().unwrap(), before, "{edit:?}");
            assert_eq!(undone, after != before);
            if undone {
                assert!(document.redo());
            }
            assert_eq!(document.to_toml().unwrap(), after, "{edit:?}");
            let read = Document::from_toml(&after).unwrap();
            assert_eq!(read.path(), document.path());
            assert_eq!(read.to_toml().unwrap(), after);
            done += 1;
            inserted += usize::from(inserts);
        }
    }
    assert!(done > 900 && inserted > 60, "{done} {inserted}");
}

#[test]
fn what_an_insertion_left_goes_with_the_values_that_are_changed() {
    let mut document = Document::new();
    let change = |document: &mut Document, point: usize, zoom: Option<f64>, speed: Option<f64>| {
        let mut orientation = document.path().points[point].orientations[0].clone();
        orientation.zoom = zoom.unwrap_or(orientation.zoom);
        orientation.speeds[3] = speed.unwrap_or(orientation.speeds[3]);
        document
            .apply(Edit::SetOrientation {
                point,
                at: 0,
                orientation,
            })
            .unwrap();
    };
    // Two keys alone are joined by a straight line, which needs no slope.
    let position = DVec3::new(0.1, 0.9, 0.0);
    document
        .apply(Edit::InsertPoint { at: 2, position })
        .unwrap();
    change(&mut document, 2, Some(25.0), None);
    change(&mut document, 0, None, Some(10.0));
    change(&mut document, 1, Some(80.0), None);
    document.apply(Edit::InsertOnCurve { frame: 40.0 }).unwrap();
    let own = |document: &Document| {
        OrientationOverrides::clone(&document.path().points[1].orientations[0].own)
    };
    assert_eq!(document.selection().point, 1);
    assert!(own(&document).zoom_slope.is_some() && matches!(own(&document).pace, Pace::Part(_)));
    change(&mut document, 1, Some(30.0), None);
    assert!(own(&document).zoom_slope.is_none() && matches!(own(&document).pace, Pace::Part(_)));
    change(&mut document, 1, None, Some(77.0));
    assert!(own(&document).pace == Pace::Speeds);
}

#[test]
fn a_wrong_value_is_told_with_its_line() {
    let file = |orientation: &str, point: &str| {
        format!(
            "version = 1\n[[point]]\nposition = [0.0, 0.0, 0.0]\n{point}\n[[point.orientation]]\n{orientation}\n[[point]]\nposition = [1.0, 0.0, 0.0]\n"
        )
    };
    let refused = |text: &str| Document::from_toml(text).unwrap_err().to_string();
    for (orientation, said) in [
        (
            "frames = -1",
            "line 6: frames: must lie between 0 and 99999999",
        ),
        (
            "ahead = -0.5",
            "line 6: ahead: the distance ahead must lie between 0 and 1e9 half edges of the space",
        ),
        (
            "up = \"down\"",
            "line 6: up: must be \"axis\", \"minimal\", \"frenet\", \"y\" or \"z\"",
        ),
        (
            "up_path = 1",
            "line 6: up_path: this up path has not been given further up",
        ),
        (
            "up = \"minimal\"\nup_point = [0.0, 1.0, 0.0]",
            "line 7: up_point: an orientation has one of up, up_point and up_path",
        ),
        (
            "up = \"frenet\"",
            "up by \"frenet\" needs a curve of kind cubic whose points own no tangents, else its normal would jump; \"minimal\" goes on any curve",
        ),
        (
            "ease = { kind = \"bouncy\" }",
            "line 6: kind: must be \"sine\" or \"parabolic\"",
        ),
        (
            "ease = { rise = 0.7, fall = 0.4 }",
            "line 6: ease: the shares of time for speeding up and slowing down must not be negative, and together not exceed 1",
        ),
        (
            "distance = [[0.0, 0.0], [0.5, 0.5]]",
            "line 6: distance: the keys of a given distance must lead from 0, 0 to 1, 1, with both numbers increasing",
        ),
        (
            "ease = { rise = 0.5 }\ndistance = [[0.0, 0.0], [1.0, 1.0]]",
            "line 6: ease: an orientation has either an ease, a distance or a part of a pace",
        ),
        (
            "pace_part = { from = 0.5, to = 0.5, ease = {} }",
            "line 6: pace_part: a part must begin and end between 0 and 1, its end after its start",
        ),
        (
            "pace_part = { from = 0.5 }",
            "line 6: pace_part: a part needs its whole: speed_curve, ease, distance or track",
        ),
        (
            "velocity_degrees = { reach = [0, 0, 0] }",
            "line 6: velocity_degrees: both reach and leave must be given",
        ),
        (
            "zoom_slope_mm = 1e7",
            "line 6: zoom_slope_mm: a velocity or slope must not exceed 1000000",
        ),
        (
            "turning_part = { control = [[1, 0, 0, 0]] }",
            "line 6: control: expected 4 quaternions, found 1",
        ),
        (
            "turning_part = { control = [[2, 0, 0, 0], [1, 0, 0, 0], [1, 0, 0, 0], [1, 0, 0, 0]] }",
            "line 6: turning_part: the control quaternions of a turning must have length 1",
        ),
    ] {
        let found = refused(&file(orientation, ""));
        // Of two keys the alphabetically later one complains.
        assert!(
            found == said || found.ends_with(&said[20..]),
            "{orientation}: {found}"
        );
    }
    let found = refused(&file(
        "",
        "tangents = { before = [0, 0, 0], after = [0, 0] }",
    ));
    assert_eq!(found, "line 4: after: expected 3 numbers, found 2");
    let found = refused("version = 1\ncurve = \"round\"\n");
    assert_eq!(
        found,
        "line 2: curve: must be \"tcb\", \"centripetal\", \"chordal\", \"cubic\" or \"linear\""
    );
}

/// A path of six points with two on its curve that keep the motion: numbers 2 and 5.
fn keeping(closed: bool) -> Document {
    let mut document = Document::new();
    let places = [
        [0.3, 0.9, 0.1],
        [-0.2, 0.4, -0.6],
        [0.7, -0.3, 0.2],
        [0.0, -0.8, 0.5],
    ];
    for (k, place) in places.into_iter().enumerate() {
        let position = DVec3::from(place);
        let at = k + 2;
        document.apply(Edit::InsertPoint { at, position }).unwrap();
    }
    document
        .apply(Edit::set(At::Path, "closed", closed))
        .unwrap();
    for segment in [3, 1] {
        let frame = document
            .timeline(|timeline| {
                let section = timeline.section_from(segment, 0).unwrap();
                let start: usize = (0..section).map(|one| timeline.section(one).frames).sum();
                (start + timeline.section(section).frames / 2) as f64
            })
            .unwrap();
        document.apply(Edit::InsertOnCurve { frame }).unwrap();
    }
    document
}

/// Numbers of the points that keep a motion, which are those that own tangents.
fn keepers(document: &Document) -> Vec<usize> {
    let points = document.path().points.iter().enumerate();
    points
        .filter_map(|(at, point)| {
            assert_eq!(point.keeps_motion, point.tangents.is_some());
            point.keeps_motion.then_some(at)
        })
        .collect()
}

#[test]
fn tangents_that_keep_a_motion_lapse_when_their_point_or_one_beside_it_moves() {
    let position = DVec3::new(0.5, 0.5, 0.5);
    let matrix = DMat4::from_translation(DVec3::splat(0.01));
    let moved = |points: &[usize]| Edit::TransformPoints {
        points: points.to_vec(),
        matrix,
        with_targets: false,
    };
    let place = |at| Edit::set(At::Point(at), "position", position);
    let all: Vec<usize> = (0..8).collect();
    for (edit, left) in [
        (place(2), vec![0, 4, 5, 6, 7]),
        (place(1), vec![3, 4, 5, 6, 7]),
        (place(3), vec![0, 1, 5, 6, 7]),
        (place(0), vec![2, 3, 4, 5, 6, 7]),
        (Edit::RemovePoint { at: 2 }, vec![0, 3, 4, 5, 6]),
        (Edit::RemovePoint { at: 7 }, vec![0, 1, 2, 3, 4, 5]),
        (
            Edit::InsertPoint { at: 2, position },
            vec![0, 4, 5, 6, 7, 8],
        ),
        (
            Edit::DivideSegment {
                segment: 4,
                points: 3,
            },
            vec![0, 1, 2, 3, 9, 10],
        ),
        (Edit::AppendAfterLast, vec![0, 1, 2, 3, 4, 5, 6]),
        (Edit::MovePoint { from: 2, to: 0 }, vec![4, 5, 6, 7]),
        (Edit::MovePoint { from: 2, to: 4 }, vec![0, 6, 7]),
        (moved(&all), all.clone()),
        (moved(&[0, 1, 2, 3]), vec![0, 1, 2, 5, 6, 7]),
        (
            Edit::set(At::Point(2), "tangents", None::<Tangents>),
            vec![0, 1, 3, 4, 5, 6, 7],
        ),
    ] {
        let mut document = keeping(false);
        assert_eq!(keepers(&document), all);
        let before = document.to_toml().unwrap();
        document.apply(edit.clone()).unwrap();
        assert_eq!(keepers(&document), left, "{edit:?}");
        let after = document.to_toml().unwrap();
        let read = Document::from_toml(&after).unwrap();
        assert_eq!(read.path(), document.path());
        assert!(document.undo());
        assert_eq!(document.to_toml().unwrap(), before, "{edit:?}");
        assert!(document.redo());
        assert_eq!(document.to_toml().unwrap(), after, "{edit:?}");
    }
    // Around the end of a closed path.
    let mut closed = keeping(true);
    let frames = closed.timeline(|timeline| timeline.frame_count());
    let frame = frames.unwrap().unwrap() as f64 - 3.0;
    closed.apply(Edit::InsertOnCurve { frame }).unwrap();
    assert_eq!(keepers(&closed), [0, 1, 2, 3, 4, 5, 6, 7, 8]);
    closed.apply(place(8)).unwrap();
    assert_eq!(keepers(&closed), [1, 2, 3, 4, 5, 6]);
}

#[test]
fn tangents_of_the_users_own_stay_where_a_motion_was_kept() {
    let mut document = keeping(false);
    // Those that are there, taken over: from then on they are the user's.
    let tangents = document.path().points[3].tangents;
    document
        .apply(Edit::set(At::Point(3), "tangents", tangents))
        .unwrap();
    assert!(!document.path().points[3].keeps_motion);
    let position = DVec3::new(0.5, 0.5, 0.5);
    document
        .apply(Edit::set(At::Point(2), "position", position))
        .unwrap();
    let own = |at: usize| document.path().points[at].tangents;
    assert_eq!([own(1), own(2), own(3)], [None, None, tangents]);
}
