//! What each edit means, one by one (thesis 7.3, A.4).

use glam::{DVec3, dvec3};
use vides::document::{At, Document, Edit, Selection};
use vides::path::{CameraPath, CurveParameters, Orientation, SupportPoint, Target, Tcb};
use vides::{Error, limits};

fn document(points: Vec<SupportPoint>) -> Document {
    let path = CameraPath {
        points: points.into(),
        ..CameraPath::default()
    };
    Document::from_parts(path, vides::document::Info::default()).unwrap()
}

fn line(xs: &[f64]) -> Document {
    document(
        xs.iter()
            .map(|&x| SupportPoint::new(dvec3(x, 0.0, 0.0)))
            .collect(),
    )
}

fn refused(document: &mut Document, edit: Edit) -> String {
    let before = format!("{:?}", document.path());
    let error = document.apply(edit).unwrap_err();
    assert_eq!(format!("{:?}", document.path()), before);
    error.to_string()
}

fn looking_at(target: DVec3) -> Orientation {
    Orientation {
        target: Target::Absolute(target),
        ..Orientation::default()
    }
}

#[test]
fn a_new_document_is_the_path_of_a_new_window() {
    let document = Document::new();
    let path = document.path();
    assert_eq!(path.points.len(), 2);
    assert_eq!(path.points[0].position, dvec3(-0.6, 0.2, 0.8));
    assert_eq!(path.points[1].position, dvec3(0.6, 0.2, 0.8));
    for point in &path.points {
        assert_eq!(point.curve, CurveParameters::Preset(0));
        assert_eq!(point.orientations.len(), 1);
        let orientation = &point.orientations[0];
        assert_eq!(orientation.target, Target::Relative(dvec3(0.0, 0.0, -0.4)));
        assert_eq!((orientation.roll, orientation.zoom), (0.0, 24.0));
        assert_eq!(orientation.speeds, [50.0; 10]);
    }
    let presets: Vec<_> = path
        .presets
        .iter()
        .map(|preset| (preset.tension, preset.continuity, preset.bias))
        .collect();
    let expected = [
        (0.0, 0.0, 0.0),
        (0.3, 0.0, 0.0),
        (0.6, 0.0, 0.0),
        (-0.3, 0.0, 0.0),
        (-0.6, 0.0, 0.0),
        (0.0, -0.5, 0.0),
        (0.0, 0.5, 0.0),
        (0.0, 0.0, 0.5),
        (0.0, 0.0, -0.5),
        (0.0, 0.0, 0.0),
    ];
    assert_eq!(presets, expected);
    assert_eq!(document.selection(), Selection::at(0, 0));
    assert!(!document.is_modified() && !document.can_undo() && !document.can_redo());
}

#[test]
fn moving_leaves_absolute_targets_and_takes_relative_ones_along() {
    let mut points = vec![
        SupportPoint::new(dvec3(0.0, 0.0, 0.0)),
        SupportPoint::new(dvec3(1.0, 0.0, 0.0)),
    ];
    points[0]
        .orientations
        .push(looking_at(dvec3(0.5, 0.5, 0.5)));
    let mut document = document(points);
    let position = dvec3(-0.25, 0.75, 0.125);
    document
        .apply(Edit::set(At::Point(0), "position", position))
        .unwrap();
    let point = &document.path().points[0];
    assert_eq!(point.position, position);
    assert_eq!(
        point.orientations[0].target,
        Target::Relative(dvec3(0.0, 0.0, -0.4))
    );
    assert_eq!(
        point.orientations[1].target,
        Target::Absolute(dvec3(0.5, 0.5, 0.5))
    );
    assert_eq!(
        refused(
            &mut document,
            Edit::set(At::Point(0), "position", dvec3(0.5, 0.5, 0.5))
        ),
        "point 1 must not lie on the target of its orientation 2"
    );
}

#[test]
fn a_new_point_copies_its_predecessor_but_for_the_name() {
    let mut first = SupportPoint::new(dvec3(0.0, 0.0, 0.0));
    first.name = Some("first".to_owned());
    first.curve = CurveParameters::Own(Tcb::new(0.1, 0.2, 0.3));
    first.orientations = vec![
        Orientation {
            roll: 12.0,
            zoom: 35.0,
            turning: Tcb::new(0.4, 0.5, 0.6),
            speeds: [7.0; 10],
            hold: 3,
            ..looking_at(dvec3(0.5, 0.25, 0.0))
        },
        Orientation::default(),
    ];
    let mut last = SupportPoint::new(dvec3(1.0, 0.0, 0.0));
    last.curve = CurveParameters::Preset(4);
    let mut document = document(vec![first.clone(), last.clone()]);

    // Elsewhere than the target: it stays absolute.
    document
        .apply(Edit::InsertPoint {
            at: 1,
            position: dvec3(0.5, 0.0, 0.0),
        })
        .unwrap();
    assert_eq!(document.selection(), Selection::at(1, 0));
    let new = &document.path().points[1];
    assert_eq!(new.name, None);
    assert_eq!(new.curve, first.curve);
    assert_eq!(new.orientations, first.orientations);

    // On the target: relative, in the direction in which the predecessor looks.
    document.undo();
    document
        .apply(Edit::InsertPoint {
            at: 1,
            position: dvec3(0.5, 0.25, 0.0),
        })
        .unwrap();
    let new = &document.path().points[1];
    assert_eq!(
        new.orientations[0].target,
        Target::Relative(dvec3(0.5, 0.25, 0.0))
    );
    assert_eq!(new.orientations[0].roll, 12.0);
    assert_eq!(new.orientations[1], first.orientations[1]);

    // At 0 from the successor, at the end from the last.
    document.undo();
    let at_end = dvec3(0.0, 0.0, 0.5);
    document
        .apply(Edit::InsertPoint {
            at: 2,
            position: at_end,
        })
        .unwrap();
    assert_eq!(document.path().points[2].curve, last.curve);
    document
        .apply(Edit::InsertPoint {
            at: 0,
            position: at_end,
        })
        .unwrap();
    assert_eq!(document.path().points[0].curve, first.curve);
    assert_eq!(
        refused(
            &mut document,
            Edit::InsertPoint {
                at: 5,
                position: at_end
            }
        ),
        "a new point must be put at 1 to 5, not at 6"
    );
}

#[test]
fn removing_makes_the_predecessor_current_and_leaves_two() {
    let mut document = line(&[0.0, 0.1, 0.2, 0.3]);
    let xs = |document: &Document| -> Vec<f64> {
        document
            .path()
            .points
            .iter()
            .map(|point| point.position.x)
            .collect()
    };
    document.select(2, 0).unwrap();
    document.apply(Edit::RemovePoint { at: 2 }).unwrap();
    assert_eq!(xs(&document), [0.0, 0.1, 0.3]);
    assert_eq!(document.selection(), Selection::at(1, 0));
    document.apply(Edit::RemovePoint { at: 0 }).unwrap();
    assert_eq!(xs(&document), [0.1, 0.3]);
    assert_eq!(document.selection(), Selection::at(0, 0));
    assert_eq!(
        refused(&mut document, Edit::RemovePoint { at: 1 }),
        "the last two points of a path cannot be removed"
    );
    document.undo();
    document.undo();
    assert_eq!(document.selection(), Selection::at(2, 0));
}

#[test]
fn orientations_come_and_go_between_one_and_ten() {
    let mut document = Document::new();
    let insert = |at, orientation| Edit::InsertOrientation {
        point: 1,
        at,
        orientation,
    };
    let target = dvec3(0.1, 0.1, 0.1);
    document.apply(insert(0, Some(looking_at(target)))).unwrap();
    assert_eq!(document.selection(), Selection::at(1, 0));
    // None copies the one before, at 0 the first.
    document.apply(insert(1, None)).unwrap();
    document.apply(insert(0, None)).unwrap();
    assert_eq!(document.selection(), Selection::at(1, 0));
    document.apply(insert(4, None)).unwrap();
    let absolute: Vec<_> = document.path().points[1]
        .orientations
        .iter()
        .map(|orientation| orientation.target == Target::Absolute(target))
        .collect();
    assert_eq!(absolute, [true, true, true, false, false]);
    for _ in 5..limits::MAX_ORIENTATIONS {
        document.apply(insert(5, None)).unwrap();
    }
    assert_eq!(
        refused(&mut document, insert(0, None)),
        "a point has at most 10 orientations"
    );
    let remove = |at| Edit::RemoveOrientation { point: 1, at };
    document.apply(remove(4)).unwrap();
    assert_eq!(document.selection(), Selection::at(1, 3));
    document.apply(remove(0)).unwrap();
    assert_eq!(document.selection(), Selection::at(1, 0));
    for _ in 0..7 {
        document.apply(remove(0)).unwrap();
    }
    assert_eq!(
        refused(&mut document, remove(0)),
        "the last orientation of a point cannot be removed"
    );
}

#[test]
fn any_finite_roll_is_kept_between_minus_180_and_180() {
    let mut document = Document::new();
    for (given, kept) in [
        (0.0, 0.0),
        (180.0, 180.0),
        (-180.0, 180.0),
        (190.0, -170.0),
        (-190.0, 170.0),
        (540.0, 180.0),
        (-725.0, -5.0),
    ] {
        let orientation = Orientation {
            roll: given,
            ..Orientation::default()
        };
        document
            .apply(Edit::SetOrientation {
                point: 0,
                at: 0,
                orientation,
            })
            .unwrap();
        assert_eq!(document.path().points[0].orientations[0].roll, kept);
    }
    let bad = Orientation {
        roll: f64::INFINITY,
        ..Orientation::default()
    };
    assert_eq!(
        refused(
            &mut document,
            Edit::SetOrientation {
                point: 0,
                at: 0,
                orientation: bad
            }
        ),
        "the roll must be a finite number"
    );
}

/// Angle between two unit vectors.
fn angle(a: DVec3, b: DVec3) -> f64 {
    2.0 * (a - b).length().atan2((a + b).length())
}

#[test]
fn absolute_and_relative_show_the_same_view() {
    let mut state = 7_u64;
    let mut random = || {
        state = state
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1_442_695_040_888_963_407);
        (state >> 11) as f64 / 2_f64.powi(52) - 1.0
    };
    let mut refusals = 0;
    for round in 0..20_000 {
        let mut vector = |exponents: f64| {
            let scale = 10_f64.powf(exponents * (random() + 1.0) / 2.0 - exponents + 9.0);
            dvec3(random(), random(), random()) * scale
        };
        let position = vector(if round % 2 == 0 { 9.0 } else { 40.0 });
        let other = vector(if round % 3 == 0 { 300.0 } else { 9.0 });
        for target in [Target::Absolute(other), Target::Relative(other)] {
            let mut points = vec![SupportPoint::new(position), SupportPoint::new(position)];
            points[0].orientations[0].target = target;
            let view = points[0].orientations[0].view(position);
            let mut document = document(points);
            let mut switch = |absolute| {
                document.apply(Edit::SetAbsolute {
                    point: 0,
                    at: 0,
                    absolute,
                })?;
                let orientation = &document.path().points[0].orientations[0];
                assert_eq!(absolute, matches!(orientation.target, Target::Absolute(_)));
                Ok::<_, Error>((orientation.target, orientation.view(position)))
            };
            match target {
                Target::Absolute(_) => {
                    let (_, relative) = switch(false).unwrap();
                    assert_eq!(relative, view, "bit for bit");
                    let (_, back) = switch(true).unwrap();
                    assert!(angle(back, view) < 1e-11, "{position} {target:?}");
                }
                Target::Relative(offset) => {
                    let Ok((_, absolute)) = switch(true) else {
                        // Only where the far end of the world is ahead.
                        assert!(position.abs().max_element() > 0.99e9);
                        refusals += 1;
                        continue;
                    };
                    assert!(angle(absolute, view) < 1e-11, "{position} {offset}");
                    let (back, last) = switch(false).unwrap();
                    assert!(angle(last, view) < 1e-11);
                    // Where coordinates allow, the length is kept too.
                    let size = position.abs().max_element();
                    if offset.length() > 1e-3 * size && size + offset.length() < 1e9 {
                        let length = back.offset_from(position).length();
                        assert!((length / offset.length() - 1.0).abs() < 1e-11);
                    }
                }
            }
        }
    }
    assert!(refusals < 20);
}

#[test]
fn at_the_end_of_the_world_there_is_no_absolute_target_ahead() {
    let mut points = vec![SupportPoint::new(dvec3(1e9, 0.0, 0.0)); 2];
    points[0].orientations[0].target = Target::Relative(DVec3::X);
    points[1].orientations[0].target = Target::Relative(DVec3::NEG_X);
    let mut document = document(points);
    let absolute = |point| Edit::SetAbsolute {
        point,
        at: 0,
        absolute: true,
    };
    assert_eq!(
        refused(&mut document, absolute(0)),
        "a target in this direction would lie farther than 1e9 half edges of the space"
    );
    document.apply(absolute(1)).unwrap();
}

#[test]
fn what_is_not_there_is_named() {
    let mut document = Document::new();
    let no_point = "there is no point 3: the path has points 1 to 2";
    let orientation = Orientation::default();
    for edit in [
        Edit::RemovePoint { at: 2 },
        Edit::set(At::Point(2), "position", DVec3::ZERO),
        Edit::set(At::Point(2), "name", String::new()),
        Edit::set(At::Point(2), "own", Tcb::default()),
        Edit::set(At::Point(2), "preset", 0),
        Edit::InsertOrientation {
            point: 2,
            at: 0,
            orientation: None,
        },
        Edit::RemoveOrientation { point: 2, at: 0 },
        Edit::SetOrientation {
            point: 2,
            at: 0,
            orientation: orientation.clone(),
        },
        Edit::SetAbsolute {
            point: 2,
            at: 0,
            absolute: true,
        },
    ] {
        assert_eq!(refused(&mut document, edit), no_point);
    }
    let no_orientation = "there is no orientation 2: point 1 has orientations 1 to 1";
    assert_eq!(
        refused(
            &mut document,
            Edit::SetOrientation {
                point: 0,
                at: 1,
                orientation
            }
        ),
        no_orientation
    );
    assert_eq!(
        document.select(0, 1).unwrap_err().to_string(),
        no_orientation
    );
    assert_eq!(document.select(2, 0).unwrap_err().to_string(), no_point);
    assert_eq!(
        refused(
            &mut document,
            Edit::DivideSegment {
                segment: 1,
                points: 1
            }
        ),
        "no segment begins in the last point of an open path"
    );
    assert_eq!(
        refused(
            &mut document,
            Edit::DivideSegment {
                segment: 2,
                points: 1
            }
        ),
        "there is no segment 3: the path has segments 1 to 1"
    );
    for points in [0, 11] {
        assert_eq!(
            refused(&mut document, Edit::DivideSegment { segment: 0, points }),
            "a segment is divided by 1 to 10 points"
        );
    }
}

#[test]
fn a_straight_segment_is_divided_evenly_and_goes_on_straight() {
    let mut document = line(&[0.0, 0.8]);
    document
        .apply(Edit::DivideSegment {
            segment: 0,
            points: 3,
        })
        .unwrap();
    assert_eq!(document.selection(), Selection::at(1, 0));
    for (point, x) in document.path().points.iter().zip([0.0, 0.2, 0.4, 0.6, 0.8]) {
        assert!((point.position - dvec3(x, 0.0, 0.0)).length() < 1e-12);
    }
    // One segment length on, but not out of the movement space.
    document.apply(Edit::AppendAfterLast).unwrap();
    assert_eq!(document.selection(), Selection::at(5, 0));
    assert!((document.path().points[5].position.x - 1.0).abs() < 1e-12);
    document
        .apply(Edit::set(At::Point(5), "position", dvec3(0.9, 0.0, 0.0)))
        .unwrap();
    document.apply(Edit::AppendAfterLast).unwrap();
    assert_eq!(document.path().points[6].position.x, 1.0);
    assert_eq!(
        refused(&mut document, Edit::AppendAfterLast),
        "there is no room in the movement space beyond the last point"
    );
    document.apply(Edit::PrependBeforeFirst).unwrap();
    assert_eq!(document.selection(), Selection::at(0, 0));
    let first = document.path().points[0].position;
    assert!((first - dvec3(-0.2, 0.0, 0.0)).length() < 1e-12, "{first}");
    document.apply(Edit::set(At::Path, "closed", true)).unwrap();
    assert_eq!(
        refused(&mut document, Edit::AppendAfterLast),
        "a closed path has no ends"
    );
}

#[test]
fn the_ends_of_curves_with_tension_one_have_a_direction_too() {
    let mut document = line(&[0.0, 0.5]);
    for at in 0..2 {
        document
            .apply(Edit::set(At::Point(at), "own", Tcb::new(1.0, 0.0, 0.0)))
            .unwrap();
    }
    document.apply(Edit::AppendAfterLast).unwrap();
    assert!((document.path().points[2].position.x - 1.0).abs() < 1e-12);
    document.apply(Edit::PrependBeforeFirst).unwrap();
    assert!((document.path().points[0].position.x + 0.5).abs() < 1e-12);

    let mut document = line(&[0.5, 0.5]);
    assert_eq!(
        refused(&mut document, Edit::AppendAfterLast),
        "the last segment has no length and so no direction to go on in"
    );
}

#[test]
fn division_is_by_arc_length_also_on_the_closing_segment() {
    let mut document = document(
        [
            dvec3(0.0, 0.0, 0.0),
            dvec3(0.9, 0.1, 0.2),
            dvec3(-0.3, 0.8, -0.5),
            dvec3(0.1, -0.7, 0.6),
        ]
        .into_iter()
        .map(SupportPoint::new)
        .collect(),
    );
    document.apply(Edit::set(At::Path, "closed", true)).unwrap();
    let curve = vides::path::curve::segment(document.path(), 3);
    document
        .apply(Edit::DivideSegment {
            segment: 3,
            points: 10,
        })
        .unwrap();
    assert_eq!(document.path().points.len(), 14);
    assert_eq!(document.selection(), Selection::at(4, 0));
    // Sum of short chords between the parameters nearest to the new points.
    let steps = 200_000;
    let mut lengths = Vec::new();
    let mut length = 0.0;
    let mut next = 4;
    let mut last = curve.point(0.0);
    let mut nearest = f64::INFINITY;
    for step in 1..=steps {
        let point = curve.point(f64::from(step) / f64::from(steps));
        length += (point - last).length();
        last = point;
        if next < 14 {
            let distance = (point - document.path().points[next].position).length();
            if distance < nearest {
                nearest = distance;
            } else if nearest < 1e-4 {
                lengths.push(length);
                next += 1;
                nearest = f64::INFINITY;
            }
        }
    }
    assert_eq!(lengths.len(), 10);
    for (index, at) in lengths.iter().enumerate() {
        let share = at / length * 11.0;
        assert!((share - (index + 1) as f64).abs() < 1e-3, "{share}");
    }
}
