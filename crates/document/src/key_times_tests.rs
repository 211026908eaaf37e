use glam::{DMat4, DVec3};
use vides_engine::path::fit_frames::frames_between;
use vides_engine::path::{BaseFrames, CurveKind, Target, Timeline};

use super::*;
use crate::Info;

/// Numbers in [0, 1) of a linear congruence (Knuth, MMIX).
struct Random(u64);

impl Random {
    fn unit(&mut self) -> f64 {
        let next = self.0.wrapping_mul(6_364_136_223_846_793_005);
        self.0 = next.wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 33) as f64 / (1_u64 << 31) as f64
    }
}

/// Five points called a to e. At b the camera rests; at c it turns, and rests before and after.
fn flight() -> Document {
    let mut document = Document::new();
    let divide = Edit::DivideSegment {
        segment: 0,
        points: 3,
    };
    document.apply(divide).unwrap();
    for (at, name) in (0..5).zip(["a", "b", "c", "d", "e"]) {
        let x = 0.1 * at as f64;
        let position = DVec3::new(0.25 * at as f64 - 0.6 + x * x, 0.3 * (at % 2) as f64, 0.1);
        let edit = Edit::set(At::Point(at), "position", position);
        document.apply(edit).unwrap();
        let edit = Edit::set(At::Point(at), "name", name.to_owned());
        document.apply(edit).unwrap();
    }
    let view = Edit::InsertOrientation {
        point: 2,
        at: 1,
        orientation: None,
    };
    document.apply(view).unwrap();
    document.apply(looks(&document, 2, 1, DVec3::X)).unwrap();
    for (point, at, frames) in [(1, 0, 12), (2, 0, 5), (2, 1, 7)] {
        let edit = Edit::set(At::View(point, at), "hold_frames", frames);
        document.apply(edit).unwrap();
    }
    document.as_opened()
}

fn looks(document: &Document, point: usize, at: usize, way: DVec3) -> Edit {
    let mut orientation = document.path().points[point].orientations[at].clone();
    orientation.target = Target::Relative(way);
    Edit::SetOrientation {
        point,
        at,
        orientation,
    }
}

/// When the points that have names are reached, in seconds.
fn reached(document: &Document) -> Vec<(String, f64)> {
    let (path, fps) = (document.path(), document.info().fps);
    let named = path.points.iter().zip(0..);
    let named = named.filter_map(|(point, at)| Some((point.name.clone()?, at)));
    let times = named.map(|(name, at)| {
        let frames = |timeline: &Timeline| frames_between(path, timeline, 0, at);
        (name, document.timeline(frames).unwrap() as f64 / fps)
    });
    times.collect()
}

/// What an operation does to the times of the points that it is not about.
#[derive(Debug, PartialEq)]
enum Times {
    /// All stay.
    Stay,
    /// Later ones come earlier or later, all by as much.
    Move,
    /// They come in other times from one to the next.
    Follow,
}

fn times(before: &[(String, f64)], after: &[(String, f64)], about: &str) -> Times {
    let by = after.iter().filter(|(name, _)| !about.contains(&**name));
    let by = by.filter_map(|(name, now)| {
        let then = before.iter().find(|then| then.0 == *name)?;
        Some((then.1, now - then.1))
    });
    let by: Vec<(f64, f64)> = by.collect();
    assert!(by.len() > 1);
    // A frame at 50 a second, to which another rate may round: half of one at 25.
    let near = |a: f64, b: f64| (a - b).abs() < 0.020_001;
    let steps: Vec<f64> = by.windows(2).map(|two| two[1].1 - two[0].1).collect();
    if by.iter().all(|by| near(by.1, 0.0)) {
        Times::Stay
    } else if steps.iter().filter(|step| !near(**step, 0.0)).count() <= 1 {
        Times::Move
    } else {
        Times::Follow
    }
}

type Operation = (
    &'static str,
    &'static str,
    fn(&Document) -> Vec<Edit>,
    [Times; 2],
);

/// The table of docs/project/window.md: what is done, which points that is about, and what happens
/// to the times of the others, fixed and following the speed.
const OPERATIONS: [Operation; 22] = {
    use Times::{Follow, Move, Stay};
    [
        (
            "move a point",
            "",
            |_| {
                vec![Edit::set(
                    At::Point(2),
                    "position",
                    DVec3::new(0.1, -0.7, 0.4),
                )]
            },
            [Stay, Follow],
        ),
        (
            "move points together",
            "",
            |_| {
                vec![Edit::TransformPoints {
                    points: vec![1, 2, 3],
                    matrix: DMat4::from_scale(DVec3::splat(1.4)),
                    with_targets: false,
                }]
            },
            [Stay, Follow],
        ),
        (
            "another curve",
            "",
            |_| vec![Edit::set(At::Path, "curve", CurveKind::Linear)],
            [Stay, Follow],
        ),
        (
            "remove a point",
            "c",
            |_| vec![Edit::RemovePoint { at: 2 }],
            [Stay, Follow],
        ),
        (
            "remove points",
            "bd",
            |_| [3, 1].map(|at| Edit::RemovePoint { at }).into(),
            [Stay, Follow],
        ),
        (
            "remove the first point",
            "a",
            |_| vec![Edit::RemovePoint { at: 0 }],
            [Move, Move],
        ),
        (
            "remove the last point",
            "e",
            |_| vec![Edit::RemovePoint { at: 4 }],
            [Stay, Stay],
        ),
        (
            "divide a segment",
            "",
            |_| {
                vec![Edit::DivideSegment {
                    segment: 2,
                    points: 2,
                }]
            },
            [Stay, Follow],
        ),
        (
            "a point elsewhere",
            "",
            |_| {
                vec![Edit::InsertPoint {
                    at: 2,
                    position: DVec3::new(0.2, 0.9, 0.0),
                }]
            },
            [Stay, Follow],
        ),
        (
            "a point on the curve",
            "",
            |_| vec![Edit::InsertOnCurve { frame: 20.0 }],
            [Stay, Stay],
        ),
        (
            "a point behind the last",
            "",
            |_| vec![Edit::AppendAfterLast],
            [Stay, Move],
        ),
        (
            "a point before the first",
            "",
            |_| vec![Edit::PrependBeforeFirst],
            [Move, Move],
        ),
        (
            "insert a path",
            "",
            |document| {
                vec![Edit::InsertPath {
                    at: 1,
                    block: Box::new(document.path().clone()),
                    fit: vides_engine::tools::block::Fit::None,
                    with_targets: false,
                }]
            },
            [Stay, Move],
        ),
        (
            "add a view",
            "",
            |_| {
                vec![Edit::InsertOrientation {
                    point: 3,
                    at: 1,
                    orientation: None,
                }]
            },
            [Stay, Stay],
        ),
        (
            "add a view and turn it",
            "",
            |document| {
                let mut turned = document.path().points[3].orientations[0].clone();
                turned.target = Target::Relative(DVec3::X);
                vec![Edit::InsertOrientation {
                    point: 3,
                    at: 1,
                    orientation: Some(turned),
                }]
            },
            [Stay, Move],
        ),
        (
            "turn a view",
            "",
            |document| vec![looks(document, 2, 1, DVec3::new(1.0, 0.0, 1.0))],
            [Stay, Move],
        ),
        (
            "remove a view",
            "",
            |_| vec![Edit::RemoveOrientation { point: 2, at: 1 }],
            [Stay, Move],
        ),
        (
            "the ten speeds",
            "",
            |document| {
                let mut orientation = document.path().points[1].orientations[0].clone();
                orientation.speeds = [80.0; 10];
                vec![Edit::SetOrientation {
                    point: 1,
                    at: 0,
                    orientation,
                }]
            },
            [Move, Move],
        ),
        (
            "base speeds",
            "",
            |_| {
                let base = BaseFrames {
                    movement: 90.0,
                    ..BaseFrames::default()
                };
                vec![Edit::set(At::Path, "base_speeds", base)]
            },
            [Follow, Follow],
        ),
        (
            "a hold",
            "",
            |_| vec![Edit::set(At::View(1, 0), "hold_frames", 40)],
            [Move, Move],
        ),
        (
            "frames of a section",
            "",
            |_| vec![Edit::set(At::View(1, 0), "frames", 99)],
            [Move, Move],
        ),
        (
            "another frame rate",
            "",
            |document| document.rate_edits(50.0).unwrap(),
            [Stay, Stay],
        ),
    ]
};

#[test]
fn operations_and_the_times_of_other_keys() {
    let mut others = Vec::new();
    for (what, about, edits, expected) in OPERATIONS {
        let mut document = flight();
        let (before, path) = (reached(&document), document.path().clone());
        let found = [true, false].map(|fixed| {
            let edits = edits(&document);
            let done = match fixed {
                true => document.apply_all_keeping_times(edits),
                false => document.apply_all(edits),
            };
            done.unwrap();
            let found = times(&before, &reached(&document), about);
            // It is one step, which takes back the times as well.
            assert!(document.undo() && !document.can_undo(), "{what}");
            assert_eq!(document.path(), &path, "{what}");
            found
        });
        if found != expected {
            others.push(format!("{what}: {found:?}, expected {expected:?}"));
        }
    }
    assert!(others.is_empty(), "{}", others.join("\n"));
}

/// Whatever is moved, removed and added, in any order, on open and closed paths: no other key gets
/// another time.
#[test]
fn no_other_key_gets_another_time_in_many_edits() {
    let mut random = Random(77);
    for round in 0..300 {
        let mut document = flight();
        document
            .apply(Edit::set(At::Path, "closed", round % 2 == 0))
            .unwrap();
        let last = document.path().points.len() - 1;
        let frames = 20_000;
        document
            .apply(Edit::FitFrames {
                first: 0,
                last,
                frames,
            })
            .unwrap();
        let before = reached(&document);
        for _ in 0..6 {
            let count = document.path().points.len();
            let at = |random: &mut Random| (random.unit() * count as f64) as usize;
            let place = DVec3::from_array([(); 3].map(|()| random.unit() * 1.8 - 0.9));
            let point = at(&mut random);
            let named = document.path().points[point].name.is_some();
            let edit = match (random.unit() * 5.0) as usize {
                0 if point > 0 && count > 3 && !named => Edit::RemovePoint { at: point },
                1 if point > 0 => Edit::InsertPoint {
                    at: point,
                    position: place,
                },
                2 => Edit::InsertOrientation {
                    point,
                    at: 1,
                    orientation: None,
                },
                3 => looks(&document, point, 0, place),
                _ => Edit::set(At::Point(point), "position", place),
            };
            document.apply_keeping_times(edit).unwrap();
        }
        let after = reached(&document);
        assert_eq!(before.len(), after.len());
        assert_eq!(
            times(&before, &after, ""),
            Times::Stay,
            "{round} {before:?} {after:?}"
        );
    }
}

/// After a point moved the whole is given a number of frames: where times are fixed each key keeps its
/// share of it, else each section takes what its length needs.
#[test]
fn a_number_of_frames_keeps_the_times_or_follows_the_speed() {
    let mut document = Document::new();
    document
        .apply(Edit::set(At::Path, "curve", CurveKind::Linear))
        .unwrap();
    let divide = Edit::DivideSegment {
        segment: 0,
        points: 2,
    };
    document.apply(divide).unwrap();
    let total = |frames| Edit::FitFrames {
        first: 0,
        last: 3,
        frames,
    };
    document.apply(total(301)).unwrap();
    let frames = |document: &Document| {
        let frames = |at: usize| document.path().points[at].orientations[0].own.frames;
        [frames(0), frames(1), frames(2)]
    };
    assert_eq!(frames(&document), [100, 100, 100]);
    let ends = [0, 3].map(|at| document.path().points[at].position);
    let place = ends[0].lerp(ends[1], 0.1);
    let moved = Edit::set(At::Point(1), "position", place);
    document.apply_keeping_times(moved).unwrap();
    document.apply_keeping_times(total(601)).unwrap();
    assert_eq!(frames(&document), [200, 200, 200]);
    document.apply_all_keeping_times([total(301)]).unwrap();
    assert_eq!(frames(&document), [100, 100, 100]);
    document.apply(total(301)).unwrap();
    assert_eq!(frames(&document), [30, 170, 100]);
    // What is locked stays in either case.
    document
        .apply(Edit::set(At::View(2, 0), "locked", true))
        .unwrap();
    document.apply_keeping_times(total(501)).unwrap();
    assert_eq!(frames(&document), [60, 340, 100]);
    document
        .apply(Edit::set(At::View(0, 0), "frames", 1))
        .unwrap();
    document.apply(total(501)).unwrap();
    assert_eq!(frames(&document), [60, 340, 100]);
}

/// Of a turn that becomes larger the way behind it gives the frames; the turn is not squeezed.
#[test]
fn a_turn_takes_its_frames_from_the_way_behind_it() {
    let mut document = flight();
    let movement = 900.0;
    let base = BaseFrames {
        movement,
        ..BaseFrames::default()
    };
    let slow = Edit::set(At::Path, "base_speeds", base);
    document.apply(slow).unwrap();
    let total = |document: &Document| document.timeline(Timeline::frame_count).unwrap().unwrap();
    let (frames, before) = (total(&document), document.path().clone());
    for way in [
        DVec3::new(1.0, 0.1, 0.0),
        DVec3::Y,
        DVec3::new(-1.0, 0.2, 0.0),
    ] {
        let edit = looks(&document, 2, 1, way);
        document.apply_keeping_times(edit).unwrap();
        let own = |at: usize| document.path().points[2].orientations[at].own.frames;
        assert_eq!((total(&document), own(0)), (frames, 0));
    }
    assert_ne!(document.path(), &before);
    // More than there is: it comes later.
    let base = BaseFrames {
        turning: 5000.0,
        ..BaseFrames::default()
    };
    document
        .apply(Edit::set(At::Path, "base_speeds", base))
        .unwrap();
    let long = total(&document);
    document
        .apply_keeping_times(Edit::set(At::Point(2), "position", DVec3::ONE))
        .unwrap();
    assert_eq!(total(&document), long);
}

/// Pasted points share the time up to the next point; without that they keep their seconds.
#[test]
fn pasted_points_fit_between_the_others() {
    let copied = flight();
    for (fixed, expected) in [(true, Times::Stay), (false, Times::Move)] {
        let mut document = flight();
        document
            .apply(Edit::FitFrames {
                first: 0,
                last: 4,
                frames: 400,
            })
            .unwrap();
        let mut unnamed = copied.try_clone().unwrap();
        for at in 0..5 {
            unnamed
                .apply(Edit::set(At::Point(at), "name", None::<String>))
                .unwrap();
        }
        let before = reached(&document);
        document.paste_points(1, &unnamed, fixed).unwrap();
        assert_eq!(times(&before, &reached(&document), ""), expected);
        document.paste_points(9, &unnamed, fixed).unwrap();
        assert_eq!(times(&before, &reached(&document), ""), expected);
    }
    // Cut and pasted where they were they come when they came.
    let mut document = flight();
    let text = document.points_as_text(&[2, 3]).unwrap();
    let before = reached(&document);
    document.remove_points(&[2, 3]).unwrap();
    let block = Document::points_of_text(&text).unwrap().unwrap();
    document.paste_points(1, &block, true).unwrap();
    let (after, fps) = (reached(&document), Info::default().fps);
    for ((name, then), (_, now)) in before.iter().zip(&after) {
        assert!(
            (then - now).abs() <= 12.0 / fps,
            "{name}: {before:?} {after:?}"
        );
    }
}
