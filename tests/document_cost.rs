//! What edits cost, counted in allocations: moving one point of many must not
//! touch the others, and a document without history must keep nothing.

#[path = "common/counting.rs"]
mod counting;

use std::time::{Duration, Instant};

use counting::cost;
use glam::dvec3;
use vides::document::{At, Document, Edit, Info};
use vides::path::{CameraPath, Orientation, SupportPoint, Tcb};

fn document(points: usize) -> Document {
    let path = CameraPath {
        points: (0..points)
            .map(|index| SupportPoint::new(dvec3(index as f64, 0.0, 0.0)))
            .collect(),
        ..CameraPath::default()
    };
    Document::from_parts(path, Info::default()).unwrap()
}

/// Edits of the values at point `at`, `round` making them differ.
fn edits(at: usize, round: usize) -> [Edit; 4] {
    let x = round as f64 * 1e-5;
    [
        Edit::set(At::Point(at), "position", dvec3(at as f64, 1.0 + x, 0.0)),
        Edit::set(At::Point(at), "own", Tcb::new(x, 0.0, 0.0)),
        Edit::SetOrientation {
            point: at,
            at: 0,
            orientation: Orientation {
                roll: x,
                ..Orientation::default()
            },
        },
        Edit::SetAbsolute {
            point: at,
            at: 0,
            absolute: true,
        },
    ]
}

/// An edit copies the list of the points and the point that it changes, no other.
#[test]
fn changing_one_point_copies_no_other() {
    let costs = |points| {
        let mut document = document(points);
        let mut costs = Vec::new();
        for edit in edits(points / 2, 1) {
            costs.push(cost(|| document.apply(edit).unwrap()).bytes);
        }
        for _ in 0..4 {
            costs.push(cost(|| assert!(document.undo())).bytes);
        }
        for _ in 0..4 {
            costs.push(cost(|| assert!(document.redo())).bytes);
        }
        costs
    };
    let (few, many) = (costs(10), costs(50_000));
    let list = size_of::<usize>() * (50_000 - 10);
    let mut more = few[..4].iter().zip(&many).map(|(few, many)| many - few);
    assert!(more.all(|more| more <= list), "{few:?} {many:?}");
    // Taking back and doing again need no memory at all.
    assert_eq!((&few[4..], &many[4..]), (&[0; 8][..], &[0; 8][..]));
    assert!(few.iter().max().unwrap() < &8192, "{few:?}");
}

#[test]
fn taking_insertions_back_needs_no_memory() {
    let mut document = document(1_000);
    let position = dvec3(0.5, 1.0, 0.0);
    document
        .apply(Edit::InsertPoint { at: 500, position })
        .unwrap();
    document.apply(Edit::RemovePoint { at: 20 }).unwrap();
    document
        .apply(Edit::InsertOrientation {
            point: 7,
            at: 1,
            orientation: None,
        })
        .unwrap();
    for _ in 0..3 {
        let cost = cost(|| {
            for _ in 0..3 {
                assert!(document.undo());
            }
            for _ in 0..3 {
                assert!(document.redo());
            }
        });
        assert_eq!((cost.bytes, cost.left), (0, 0));
    }
}

#[test]
fn without_history_ten_thousand_edits_leave_nothing_behind() {
    let mut document = document(100).without_history();
    let mut run = |rounds: std::ops::Range<usize>| {
        for round in rounds {
            for edit in edits(round % 100, round) {
                document.apply(edit).unwrap();
            }
        }
    };
    run(0..100);
    let cost = cost(|| run(100..10_000));
    assert_eq!(cost.left, 0);
}

#[test]
fn a_drag_of_ten_thousand_moves_keeps_one_record() {
    let mut document = document(100);
    document.begin_step();
    for edit in edits(50, 0) {
        document.apply(edit).unwrap();
    }
    let cost = cost(|| {
        for round in 1..10_000 {
            for edit in edits(50, round) {
                document.apply(edit).unwrap();
            }
        }
    });
    assert_eq!(cost.left, 0);
}

#[test]
fn large_steps_do_not_pile_up() {
    let large = || {
        let mut path = document(50_000).path().clone();
        path.closed = true;
        Box::new(path)
    };
    let mut document = document(50_000);
    // Each keeps the path that was there before, some 17 MB.
    for _ in 0..8 {
        document.apply(Edit::ReplacePath(large())).unwrap();
    }
    let cost = cost(|| {
        for _ in 0..40 {
            document.apply(Edit::ReplacePath(large())).unwrap();
        }
    });
    let left = cost.left;
    assert!(left < vides::limits::MAX_HISTORY_BYTES as isize, "{left}");
}

/// What a person drags among ten thousand points, or takes back, costs a fraction of a picture.
#[test]
fn timed_an_edit_with_its_undo_takes_less_than_a_fifth_of_a_millisecond() {
    let mut document = document(10_000);
    let fastest = |act: &mut dyn FnMut(usize)| {
        let rounds = (0..200).map(|round| {
            let begin = Instant::now();
            act(round);
            begin.elapsed()
        });
        rounds.min().unwrap_or_default()
    };
    let moved = |round: usize| {
        let position = dvec3(5000.0, 1.0 + round as f64, 0.0);
        Edit::set(At::Point(5000), "position", position)
    };
    let undone = fastest(&mut |round| {
        document.apply(moved(round)).unwrap();
        assert!(document.undo());
    });
    let inserted = fastest(&mut |round| {
        let position = dvec3(0.5, 1.0 + round as f64, 0.0);
        document
            .apply(Edit::InsertPoint { at: 5000, position })
            .unwrap();
        assert!(document.undo());
    });
    document.begin_step();
    let dragged = fastest(&mut |round| document.apply(moved(round)).unwrap());
    println!("set and undone {undone:?}, inserted and undone {inserted:?}, dragged {dragged:?}");
    let most = Duration::from_micros(200);
    assert!(undone < most && inserted < most && dragged < most);
}
