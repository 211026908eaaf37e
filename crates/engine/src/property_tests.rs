use std::collections::HashSet;

use glam::DVec3;

use super::*;
use crate::limits;
use crate::path::{Orientation, OrientationOverrides, Pace, Space, UpVector};

/// Every key of the views of a path.
fn keys() -> Vec<&'static str> {
    let views = Orientation::PROPERTIES.iter().flat_map(|row| row.keys);
    let own = OrientationOverrides::PROPERTIES
        .iter()
        .flat_map(|row| row.keys);
    views.chain(own).copied().collect()
}

#[test]
fn no_two_fields_have_one_key() {
    let all = keys();
    let different: HashSet<_> = all.iter().collect();
    assert_eq!(different.len(), all.len());
    assert!(find(Orientation::PROPERTIES, "zoom_mm").is_some());
    assert!(find(OrientationOverrides::PROPERTIES, "zoom_mm").is_none());
}

#[test]
fn what_is_set_is_read_and_the_rest_stays() {
    let new = Orientation::default();
    let value = |kind| match kind {
        Kind::Number => Value::Number(33.0),
        Kind::Whole => Value::Whole(33),
        Kind::Switch => Value::Switch(true),
        Kind::Speeds => Value::Speeds([33.0; limits::SPEEDS]),
        Kind::Shape => Value::Shape(Tcb::new(0.3, 0.3, 0.3)),
        Kind::Nested => Value::Switch(true),
    };
    for row in Orientation::PROPERTIES {
        let mut changed = new.clone();
        (row.set)(&mut changed, value(row.kind));
        for other in Orientation::PROPERTIES {
            let moved = std::ptr::eq(row, other) && row.kind != Kind::Nested;
            assert_eq!((other.same)(&new, &changed), !moved, "{:?}", other.keys);
        }
        let read = (row.value)(&changed);
        assert_eq!(read, (row.kind != Kind::Nested).then_some(value(row.kind)));
        let mut taken = new.clone();
        (row.take)(&mut taken, &changed);
        assert!(taken.same_bits(&changed));
        // Of another kind: nothing happens.
        let odd = match row.kind {
            Kind::Switch => Value::Whole(1),
            _ => Value::Switch(true),
        };
        (row.set)(&mut taken, odd);
        assert!(taken.same_bits(&changed));
    }
}

#[test]
fn bounds_hold_and_what_lies_beyond_is_refused() {
    for row in Orientation::PROPERTIES {
        let Some((low, high)) = row.range else {
            continue;
        };
        let check = |number: f64| {
            let mut orientation = Orientation::default();
            let value = match row.kind {
                Kind::Whole => Value::Whole(number as u32),
                _ => Value::Number(number),
            };
            (row.set)(&mut orientation, value);
            (row.check)(&orientation, Space::default())
        };
        assert!(check(low).is_ok() && check(high).is_ok(), "{:?}", row.keys);
        assert!(check(high + 1.0).is_err(), "{:?}", row.keys);
        if row.kind == Kind::Number {
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
