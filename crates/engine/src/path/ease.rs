//! Speeding up, cruising and slowing down (Kolb, Computergraphik II, 9.2.1, corrected: the
//! parabola's acceleration for a way of 1 in a time of 1 is 4, the sine's speed in the middle is
//! π/2). Distances are closed forms, good to 1e-15.

use std::f64::consts::{FRAC_PI_2, PI};

use super::checks::check_curve_speed;
use crate::error::{OutOfRange, Result};
use crate::property::named::named;
use crate::property::same_bits::SameBits;

named! {
    /// How the speed rises and falls.
    pub enum EaseKind {
        /// As a quarter of a sine.
        #[default]
        Sine = "sine",
        /// As a straight line: the distance is a parabola.
        Parabolic = "parabolic",
    }
}

/// Speeding up, cruising and slowing down.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Ease {
    /// How the speed rises and falls.
    pub kind: EaseKind,
    /// Share of the time for speeding up, ≥ 0.
    pub rise: f64,
    /// Share of the time for slowing down, ≥ 0; with `rise` at most 1.
    pub fall: f64,
    /// The cruising speed, 1…100.
    pub cruise: f64,
}

impl SameBits for Ease {
    fn same_bits(&self, other: &Self) -> bool {
        self.numbers()[..].same_bits(&other.numbers()[..])
    }
}

impl Ease {
    /// Everything in range.
    ///
    /// # Errors
    /// [`crate::Error::Range`].
    pub fn check(&self) -> Result<()> {
        // 0.7 and 0.3 may add up to a little more than 1.
        let fits = self.rise >= 0.0
            && self.fall >= 0.0
            && self.rise + self.fall <= 1.0 + 4.0 * f64::EPSILON;
        if !fits {
            return Err(OutOfRange::EaseShares.into());
        }
        check_curve_speed(self.cruise)
    }

    /// All that defines it.
    pub(super) fn numbers(&self) -> [f64; 4] {
        let kind = f64::from(u8::from(self.kind == EaseKind::Parabolic));
        [kind, self.rise, self.fall, self.cruise]
    }

    /// Mean speed of a rise or a fall, as a share of the cruising speed.
    fn mean_of_rise(&self) -> f64 {
        match self.kind {
            EaseKind::Sine => 2.0 / PI,
            EaseKind::Parabolic => 0.5,
        }
    }

    /// Mean speed over the whole time, as a share of the cruising speed.
    fn area(&self) -> f64 {
        1.0 - (self.rise + self.fall) * (1.0 - self.mean_of_rise())
    }

    /// Mean speed over the whole time.
    #[must_use]
    pub fn mean(&self) -> f64 {
        self.cruise * self.area()
    }

    /// Way gone in the first share `x` of a rise that lasts `length`, at a cruising speed of 1.
    fn risen(&self, x: f64, length: f64) -> f64 {
        match self.kind {
            EaseKind::Sine => {
                let half = (x * FRAC_PI_2 / 2.0).sin();
                length * (4.0 / PI) * half * half
            }
            EaseKind::Parabolic => length * 0.5 * x * x,
        }
    }

    /// Share of the way at the share `t` of the time, 0 ≤ t ≤ 1; exact at both ends.
    #[must_use]
    pub fn distance(&self, t: f64) -> f64 {
        let area = self.area();
        let gone = if t < self.rise {
            self.risen(t / self.rise, self.rise)
        } else if 1.0 - t < self.fall {
            area - self.risen((1.0 - t) / self.fall, self.fall)
        } else {
            self.risen(1.0, self.rise) + (t - self.rise)
        };
        if t >= 1.0 {
            1.0
        } else {
            (gone / area).clamp(0.0, 1.0)
        }
    }

    /// Speed at the share `t` of the time, as a share of the cruising speed.
    fn shape(&self, t: f64) -> f64 {
        let x = if t < self.rise {
            t / self.rise
        } else if 1.0 - t < self.fall {
            (1.0 - t) / self.fall
        } else {
            1.0
        };
        match self.kind {
            EaseKind::Sine => (x * FRAC_PI_2).sin(),
            EaseKind::Parabolic => x,
        }
    }

    /// Derivative of [`Self::distance`].
    #[must_use]
    pub fn slope(&self, t: f64) -> f64 {
        self.shape(t) / self.area()
    }

    /// Speed at the share `t` of the time.
    #[must_use]
    pub fn speed(&self, t: f64) -> f64 {
        self.cruise * self.shape(t)
    }

    /// Derivative of [`Self::speed`] at the share `t`; 0 where a rise ends or a fall begins.
    #[must_use]
    pub fn acceleration(&self, t: f64) -> f64 {
        let (x, change) = if t < self.rise {
            (t / self.rise, 1.0 / self.rise)
        } else if 1.0 - t < self.fall {
            ((1.0 - t) / self.fall, -1.0 / self.fall)
        } else {
            return 0.0;
        };
        let slope = match self.kind {
            EaseKind::Sine => FRAC_PI_2 * (x * FRAC_PI_2).cos(),
            EaseKind::Parabolic => 1.0,
        };
        self.cruise * slope * change
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::path::test_support::Random;

    fn random(random: &mut Random) -> Ease {
        let rise = if random.unit() < 0.2 {
            0.0
        } else {
            random.unit()
        };
        let fall = if random.unit() < 0.2 {
            1.0 - rise
        } else {
            (1.0 - rise) * random.unit()
        };
        let kind = if random.unit() < 0.5 {
            EaseKind::Sine
        } else {
            EaseKind::Parabolic
        };
        Ease {
            kind,
            rise,
            fall,
            cruise: 1.0 + 99.0 * random.unit(),
        }
    }

    /// ∫ of the speed by the rule of Gauss and Legendre with 8 nodes, over
    /// pieces between which it has a corner.
    fn quadrature(ease: &Ease, to: f64) -> f64 {
        const NODES: [(f64, f64); 4] = [
            (0.1834346424956498, 0.3626837833783620),
            (0.5255324099163290, 0.3137066458778873),
            (0.7966664774136267, 0.2223810344533745),
            (0.9602898564975363, 0.1012285362903763),
        ];
        let corners = [
            0.0,
            ease.rise.min(to),
            (1.0 - ease.fall).min(to).max(0.0),
            to,
        ];
        let mut sum = 0.0;
        for pair in corners.windows(2) {
            let (middle, half) = ((pair[0] + pair[1]) / 2.0, (pair[1] - pair[0]) / 2.0);
            for (x, weight) in NODES {
                let speed = |x: f64| ease.speed(middle + half * x);
                sum += half * weight * (speed(x) + speed(-x));
            }
        }
        sum
    }

    #[test]
    fn distance_and_mean_are_the_integrals_of_the_speed() {
        let mut numbers = Random(21);
        for _ in 0..20_000 {
            let ease = random(&mut numbers);
            ease.check().unwrap();
            let whole = quadrature(&ease, 1.0);
            assert!(
                (ease.mean() - whole).abs() < 1e-14 * whole.max(1.0),
                "{ease:?}"
            );
            let t = numbers.unit();
            let expected = quadrature(&ease, t) / whole;
            assert!((ease.distance(t) - expected).abs() < 1e-14, "{ease:?} {t}");
            assert!(
                (ease.slope(t) - ease.speed(t) / whole).abs() < 1e-13 * ease.slope(0.5).max(1.0)
            );
        }
    }

    #[test]
    fn the_lectures_own_curves() {
        // ease_sin(t) = (sin(πt − π/2) + 1)/2, slope π/2 in the middle; the
        // parabola 2t² with acceleration 4, slope 2 in the middle.
        let ease = |kind| Ease {
            kind,
            rise: 0.5,
            fall: 0.5,
            cruise: 50.0,
        };
        for k in 0..=1000 {
            let t = f64::from(k) / 1000.0;
            let sine = ((PI * t - FRAC_PI_2).sin() + 1.0) / 2.0;
            assert!((ease(EaseKind::Sine).distance(t) - sine).abs() < 1e-15);
            let parabola = if t < 0.5 {
                2.0 * t * t
            } else {
                1.0 - 2.0 * (1.0 - t) * (1.0 - t)
            };
            assert!((ease(EaseKind::Parabolic).distance(t) - parabola).abs() < 1e-15);
        }
        assert!((ease(EaseKind::Sine).slope(0.5) - FRAC_PI_2).abs() < 1e-15);
        assert_eq!(ease(EaseKind::Parabolic).slope(0.5), 2.0);
        // Of a way of 1 in a time of 1: the parabola's is 4, the sine's π²/2 at the start.
        let [sine, parabola] = [EaseKind::Sine, EaseKind::Parabolic].map(ease);
        assert_eq!(parabola.acceleration(0.2) / parabola.mean(), 4.0);
        assert_eq!(parabola.acceleration(0.7) / parabola.mean(), -4.0);
        assert!((sine.acceleration(0.0) / sine.mean() - PI * PI / 2.0).abs() < 1e-14);
        assert_eq!(ease(EaseKind::Sine).slope(0.0), 0.0);
        assert!(ease(EaseKind::Sine).slope(1.0).abs() < 1e-15);
    }

    #[test]
    fn it_goes_on_from_0_to_1() {
        let mut numbers = Random(22);
        for _ in 0..2_000 {
            let ease = random(&mut numbers);
            assert_eq!((ease.distance(0.0), ease.distance(1.0)), (0.0, 1.0));
            let mut last = 0.0;
            for k in 1..=500 {
                let now = ease.distance(f64::from(k) / 500.0);
                assert!(now >= last, "{ease:?}");
                last = now;
            }
        }
        let bad = |rise, fall, cruise| {
            Ease {
                kind: EaseKind::Sine,
                rise,
                fall,
                cruise,
            }
            .check()
            .is_err()
        };
        assert!(bad(-0.1, 0.0, 50.0) && bad(0.6, 0.5, 50.0) && bad(f64::NAN, 0.0, 50.0));
        assert!(bad(0.1, 0.0, 0.5) && bad(0.1, 0.0, f64::NAN) && !bad(0.7, 0.3, 1.0));
    }
}
