//! Few cubic keys in place of one a frame, as near as asked for.
//!
//! From each key as far as the cubic Hermite curve with the motion's own tangents stays near all
//! frames between. Tangents are differences to one side (three points), so that corners and holds
//! stay what they are.

use glam::DQuat;
use vides_document::error::vec_with_room;
use vides_engine::math::quaternion::angle;

use super::keys::{Keys, Way};
use crate::error::Result;
use crate::flight::Flight;

/// The slope per frame at a frame, looking to one side (`way` 1 or −1).
fn slope<const N: usize>(values: &[[f64; N]], at: usize, way: isize) -> [f64; N] {
    let value = |steps: isize| {
        let place = at.checked_add_signed(way * steps)?;
        values.get(place)
    };
    let side = way as f64;
    match (value(1), value(2)) {
        (Some(near), Some(far)) => {
            std::array::from_fn(|k| side * (4.0 * near[k] - far[k] - 3.0 * values[at][k]) / 2.0)
        }
        (Some(near), None) => std::array::from_fn(|k| side * (near[k] - values[at][k])),
        _ => [0.0; N],
    }
}

/// Whether the curve between two keys stays near the frames between.
fn near<const N: usize>(
    values: &[[f64; N]],
    from: usize,
    to: usize,
    most: f64,
    most_degrees: f64,
) -> bool {
    let step = (to - from) as f64;
    // One that turns back within the two frames of a slope must not pass its corner.
    let (leave, reach) = (slope(values, from, 1), slope(values, to, -1));
    (from + 1..to).all(|at| {
        let u = (at - from) as f64 / step;
        let (a, b) = (values[from], values[to]);
        let made: [f64; N] = std::array::from_fn(|k| {
            let (r, s, rise) = (step * leave[k], step * reach[k], b[k] - a[k]);
            let (c2, c3) = (3.0 * rise - 2.0 * r - s, r + s - 2.0 * rise);
            a[k] + ((c3 * u + c2) * u + r) * u
        });
        if N == 4 {
            let q = |v: [f64; N]| DQuat::from_xyzw(v[0], v[1], v[2], v[3]).normalize();
            let (made, wanted) = (q(made), q(values[at]));
            // Halves of turns.
            return made.is_finite() && 2.0 * angle(made, wanted).to_degrees() <= most_degrees;
        }
        let square: f64 = (0..N).map(|k| (made[k] - values[at][k]).powi(2)).sum();
        square <= most * most
    })
}

/// The keys, or none where they would take no less room than one a frame.
pub(super) fn keys<const N: usize>(
    values: &[[f64; N]],
    most: f64,
    most_degrees: f64,
    flight: &Flight<'_>,
) -> Result<Option<Keys>> {
    let last = values.len().saturating_sub(1);
    let mut chosen = vec_with_room(values.len())?;
    chosen.push(0);
    let mut from = 0;
    while from < last {
        let fits = |to: usize| near(values, from, to, most, most_degrees);
        // Doubled until it fails, then halved.
        let (mut good, mut bad) = (from + 1, last + 1);
        let mut reach = 2;
        while from + reach < bad {
            if fits(from + reach) {
                good = from + reach;
                reach *= 2;
            } else {
                bad = from + reach;
            }
        }
        if bad == last + 1 && good < last && fits(last) {
            good = last;
        }
        while good + 1 < bad {
            let middle = good + (bad - good) / 2;
            if fits(middle) {
                good = middle;
            } else {
                bad = middle;
            }
        }
        chosen.push(good);
        from = good;
    }
    if chosen.len() < 2 || 3 * chosen.len() >= values.len() {
        return Ok(None);
    }
    let rate = flight.fps();
    let mut times = vec_with_room(chosen.len())?;
    let mut stored: Vec<f32> = vec_with_room(3 * N * chosen.len())?;
    for &at in &chosen {
        times.push(flight.seconds(at) as f32);
        let sides = [slope(values, at, -1), slope(values, at, 1)];
        let [before, after] = sides.map(|side| side.map(|number| (number * rate) as f32));
        stored.extend(before);
        stored.extend(values[at].map(|number| number as f32));
        stored.extend(after);
    }
    Ok(Some(Keys {
        times,
        values: stored,
        way: Way::Cubic,
    }))
}
