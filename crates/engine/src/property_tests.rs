use std::collections::HashSet;

use glam::{DQuat, DVec3};

use super::*;
use crate::limits;
use crate::path::{
    BaseFrames, CameraPath, Ease, EaseKind, Orientation, OrientationOverrides, Pace, PacePart,
    PaceSource, Pose, Sampler, Space, SupportPoint, Tcb, Timeline, TurningPart, UpPath, UpVector,
};
use crate::scene::Values;

/// A value of a kind that differs from that of a new one.
fn value(kind: Kind) -> Value {
    let part = PacePart {
        of: PaceSource::Speeds {
            speeds: [33.0; limits::SPEEDS],
            slopes: [0.0, 7.0],
        },
        from: 0.0,
        to: 0.5,
    };
    let ease = Ease {
        kind: EaseKind::Parabolic,
        rise: 0.3,
        fall: 0.3,
        cruise: 33.0,
    };
    match kind {
        Kind::Number => Value::Number(33.0),
        Kind::Whole => Value::Whole(3),
        Kind::Switch => Value::Switch(true),
        Kind::Choice(names) => Value::Choice(names[1]),
        Kind::Text => Value::Text("three".to_owned()),
        Kind::Place => Value::Place(DVec3::splat(0.3)),
        Kind::Vector => Value::Vector(DVec3::splat(0.3)),
        Kind::Rotation => Value::Rotation(DQuat::from_xyzw(0.5, 0.5, 0.5, 0.5)),
        Kind::Colour => Value::Colour([0.3; 3]),
        Kind::Cone => Value::Cone([3.0, 33.0]),
        Kind::Pair(names) => Value::Pair(names, [DVec3::X, DVec3::Y]),
        Kind::Speeds => Value::Speeds([33.0; limits::SPEEDS]),
        Kind::Shape => Value::Shape(Tcb::new(0.3, 0.3, 0.3)),
        Kind::Presets => Value::Presets([Tcb::new(0.3, 0.3, 0.3); limits::PRESETS]),
        Kind::BaseFrames => Value::BaseFrames(BaseFrames {
            zoom: 3.0,
            ..BaseFrames::NEW
        }),
        Kind::Ease => Value::Ease(ease),
        Kind::Distance => Value::Distance([[0.0, 0.0], [0.3, 0.5], [1.0, 1.0]].into()),
        Kind::Part => Value::Part(part),
        Kind::Turning => Value::Turning(TurningPart {
            control: [DQuat::IDENTITY; 4],
            from: 0.3,
            to: 1.0,
        }),
        Kind::UpPath => Value::UpPath(UpPath::of(&CameraPath::default()).unwrap()),
        Kind::Nested => Value::Unset,
    }
}

fn each_key_is_its_own<T: Table + Clone + SameBits>() {
    let all: Vec<_> = T::PROPERTIES.iter().flat_map(|row| row.keys).collect();
    let different: HashSet<_> = all.iter().collect();
    assert_eq!(different.len(), all.len());
    for row in T::PROPERTIES {
        assert!(row.keys.is_empty() || row.keys.len() == row.kinds.len());
        for (key, &kind) in row.keys.iter().zip(row.kinds) {
            let mut changed = T::NEW;
            let given = match (value(kind), row.range) {
                (Value::Switch(on), _) => Value::Switch((row.value)(&T::NEW) != Value::Switch(on)),
                (Value::Number(_), Some((low, high))) => Value::Number(0.5 * (low + high)),
                (given, _) => given,
            };
            let mut exchanged = given.clone();
            assert!((row.exchange)(&mut changed, &mut exchanged), "{key}");
            assert!((row.check)(&changed, Space::NEW).is_ok(), "{key}");
            assert_eq!((row.value)(&changed), given);
            assert_eq!(row.key_of(&given), Some(*key));
            for other in T::PROPERTIES {
                let moved = std::ptr::eq(row, other);
                assert_eq!((other.same)(&T::NEW, &changed), !moved, "{key}");
            }
            let mut taken = T::NEW;
            (row.take)(&mut taken, &changed);
            assert!(taken.same_bits(&changed));
            // Exchanged again it is as before; of another kind, nothing happens.
            assert!((row.exchange)(&mut changed, &mut exchanged));
            assert!(changed.same_bits(&T::NEW) && exchanged == given, "{key}");
            let odd = Value::Pair(["", ""], [DVec3::ZERO; 2]);
            let odd = if row.key_of(&value(Kind::Switch)).is_some() || matches!(kind, Kind::Pair(_))
            {
                Value::Number(1.0)
            } else {
                odd
            };
            assert!(!(row.exchange)(&mut changed, &mut odd.clone()), "{key}");
            assert!(changed.same_bits(&T::NEW));
        }
    }
}

#[test]
fn what_is_set_is_read_and_the_rest_stays() {
    each_key_is_its_own::<CameraPath>();
    each_key_is_its_own::<BaseFrames>();
    each_key_is_its_own::<SupportPoint>();
    each_key_is_its_own::<Orientation>();
    each_key_is_its_own::<OrientationOverrides>();
    each_key_is_its_own::<Values>();
}

#[test]
fn bounds_hold_and_what_lies_beyond_is_refused() {
    for row in Orientation::PROPERTIES {
        let (Some((low, high)), [kind]) = (row.range, row.kinds) else {
            continue;
        };
        let check = |number: f64| {
            let mut orientation = Orientation::default();
            let mut value = match kind {
                Kind::Whole => Value::Whole(number as i64),
                _ => Value::Number(number),
            };
            (row.exchange)(&mut orientation, &mut value);
            (row.check)(&orientation, Space::default())
        };
        assert!(check(low).is_ok() && check(high).is_ok(), "{:?}", row.keys);
        assert!(check(high + 1.0).is_err(), "{:?}", row.keys);
        if *kind == Kind::Number {
            assert!(check(low.next_down()).is_err() && check(f64::NAN).is_err());
        }
    }
}

#[test]
fn zeros_of_both_signs_differ() {
    let mut own = OrientationOverrides::NEW;
    own.ahead = Some(0.0);
    let mut other = own.clone();
    assert!(own.same_bits(&other));
    other.ahead = Some(-0.0);
    assert!(own == other && !own.same_bits(&other));
    let up = |x| OrientationOverrides {
        up: UpVector::Point(DVec3::new(x, 1.0, 0.0)),
        ..OrientationOverrides::NEW
    };
    assert!(up(0.0) == up(-0.0) && !up(0.0).same_bits(&up(-0.0)));
    let distance = |x| OrientationOverrides {
        pace: Pace::Distance([[x, 0.0], [1.0, 1.0]].into()),
        ..OrientationOverrides::NEW
    };
    assert!(distance(0.0) == distance(-0.0) && !distance(0.0).same_bits(&distance(-0.0)));
}

#[test]
fn a_copy_keeps_what_holds_anywhere() {
    let mut own = OrientationOverrides {
        ahead: Some(1.0),
        frames: 7,
        locked: true,
        zoom_slope: Some(2.0),
        ..OrientationOverrides::NEW
    };
    for row in OrientationOverrides::PROPERTIES {
        (row.for_a_copy)(&mut own);
    }
    let expected = OrientationOverrides {
        ahead: Some(1.0),
        ..OrientationOverrides::NEW
    };
    assert!(own.same_bits(&expected));
}

/// Lengths of the segments, frames of the sections, poses.
type Computed = (Vec<u64>, Vec<usize>, Vec<Pose>);

fn computed(path: &CameraPath) -> Computed {
    let timeline = Timeline::new(path).unwrap();
    let sampler = Sampler::new(path, &timeline).unwrap();
    let mut poses = vec![Pose::default(); sampler.frame_count()];
    sampler.sample(1, &mut poses).unwrap();
    let lengths = (0..path.segment_count()).map(|k| timeline.segment_length(k).to_bits());
    let frames = (0..timeline.section_count()).map(|k| timeline.section(k).frames);
    (lengths.collect(), frames.collect(), poses)
}

fn nothing_else_changes<T: Table>(of: impl Fn(&mut CameraPath, &mut dyn FnMut(&mut T))) {
    let mut path = CameraPath::default();
    let mut third = SupportPoint::new(DVec3::new(0.0, -0.5, 0.1));
    third.orientations[0].roll = 30.0;
    third.orientations[0].zoom = 90.0;
    path.points.push(third);
    let before = computed(&path);
    for row in T::PROPERTIES {
        for &kind in row.kinds.iter().filter(|_| !row.keys.is_empty()) {
            let mut changed = path.clone();
            of(&mut changed, &mut |of| {
                (row.exchange)(of, &mut value(kind));
            });
            let after = computed(&changed);
            assert!(
                row.affects >= Affects::Curve || after.0 == before.0,
                "{row:?}"
            );
            assert!(
                row.affects >= Affects::Frames || after.1 == before.1,
                "{row:?}"
            );
            assert!(
                row.affects >= Affects::Views || after.2 == before.2,
                "{row:?}"
            );
        }
    }
}

#[test]
fn what_a_row_does_not_affect_stays() {
    nothing_else_changes::<CameraPath>(|path, change| change(path));
    nothing_else_changes::<BaseFrames>(|path, change| change(&mut path.base_frames));
    nothing_else_changes::<SupportPoint>(|path, change| change(&mut path.points[1]));
    nothing_else_changes::<Orientation>(|path, change| change(&mut path.points[1].orientations[0]));
    nothing_else_changes::<OrientationOverrides>(|path, change| {
        let own = &mut path.points[1].orientations[0].own;
        *own = own.with(change).unwrap();
    });
}
