//! Noise on recordings of which one knows what they are.

use super::super::*;
use super::recordings::{Event, Flight, Noise, PLAIN, Recording, from_clean, made, recorded};
use super::{TOLERANCE, turned};
use crate::limits::MAX_HOLD;
use crate::path::Timeline;
use crate::path::test_support::Random;

/// A rest is as long as it was, though no point may rest so long.
#[test]
fn a_rest_has_any_length() {
    let hold = f64::from(MAX_HOLD);
    for frames in [hold - 1.0, hold, hold + 1.0, hold + 2.0, 3.5 * hold] {
        for moves in [false, true] {
            let step = |k: usize| {
                f64::from(u8::from(moves)) * 0.1 * (k.min(20) + k.saturating_sub(21)) as f64
            };
            let poses: Vec<Pose> = (0..40)
                .map(|k| turned([step(k), 0.0, 0.0], 0.2, 0.0))
                .collect();
            let when = |k: usize| k as f64 + if k > 20 { frames - 1.0 } else { 0.0 };
            let seconds: Vec<f64> = (0..40).map(when).collect();
            let fitted = made(&poses, &seconds, 1.0, &TOLERANCE.into());
            let count = Timeline::new(&fitted.path).unwrap().frame_count().unwrap();
            assert_eq!(count as f64, 39.0 + frames, "{frames} {moves}");
            let report = fitted.report;
            assert!(
                report.points < 20 && report.position.greatest < 0.01,
                "{report}"
            );
            assert!(report.lens.greatest < 1e-3, "{report}");
        }
    }
}
