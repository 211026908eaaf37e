//! What edits cost, counted in allocations: moving one point of many must not
//! touch the others, and a document without history must keep nothing.

#[path = "common/counting.rs"]
mod counting;

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

#[test]
fn changing_one_point_costs_the_same_however_many_there_are() {
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
    let few = costs(10);
    assert_eq!(few, costs(50_000));
    // Taking back and doing again need no memory at all.
    assert_eq!(few[4..], [0; 8]);
    assert!(few.iter().max().unwrap() < &4096, "{few:?}");
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
    assert_eq!((cost.bytes, cost.left), (0, 0));
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
