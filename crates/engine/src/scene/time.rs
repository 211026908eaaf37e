//! What is shown before the first frame of a motion and after its last.

use crate::property::choices;

choices! {
    /// How a motion goes on beyond its own frames.
    pub enum Extrapolation {
        /// The first or the last value stays.
        #[default]
        Hold = "hold",
        /// Starts over; the period is the last frame less the first, the last value counts at the
        /// seam.
        Repeat = "repeat",
        /// Back and forth.
        PingPong = "pingpong",
        /// As `Repeat`, each time from where the last round ended.
        Offset = "offset",
    }
}

/// The frame in `first`…`last` shown at `frame`, and for [`Extrapolation::Offset`] the rounds
/// before it.
#[must_use]
pub fn local_frame(
    frame: f64,
    first: f64,
    last: f64,
    before: Extrapolation,
    after: Extrapolation,
) -> (f64, f64) {
    if frame >= first && frame <= last {
        return (frame, 0.0);
    }
    let extrapolation = if frame < first { before } else { after };
    let period = last - first;
    let held = if frame < first { first } else { last };
    if extrapolation == Extrapolation::Hold || !(period > 0.0) {
        return (held, 0.0);
    }
    let into = frame - first;
    match extrapolation {
        Extrapolation::Hold => (held, 0.0),
        Extrapolation::PingPong => {
            let place = into.rem_euclid(2.0 * period);
            let place = if place > period {
                2.0 * period - place
            } else {
                place
            };
            ((first + place).clamp(first, last), 0.0)
        }
        Extrapolation::Repeat | Extrapolation::Offset => {
            let place = into.rem_euclid(period);
            let local = if place == 0.0 {
                last
            } else {
                (first + place).min(last)
            };
            let rounds = if extrapolation == Extrapolation::Offset {
                ((into - (local - first)) / period).round()
            } else {
                0.0
            };
            (local, rounds)
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use Extrapolation::{Hold, Offset, PingPong, Repeat};

    #[test]
    fn inside_nothing_changes() {
        for beyond in [Hold, Repeat, PingPong, Offset] {
            for frame in [10.0, 12.5, 20.0] {
                assert_eq!(local_frame(frame, 10.0, 20.0, beyond, beyond), (frame, 0.0));
            }
            assert_eq!(local_frame(7.0, 3.0, 3.0, beyond, beyond), (3.0, 0.0));
        }
    }

    #[test]
    fn beyond_the_ends() {
        let at = |frame, beyond| local_frame(frame, 10.0, 20.0, beyond, beyond);
        assert_eq!(at(-3.0, Hold), (10.0, 0.0));
        assert_eq!(at(33.0, Hold), (20.0, 0.0));
        // 17, 27, 37 are one place; the seams at 0, 30, 40 show the last frame.
        assert_eq!(at(27.0, Repeat), (17.0, 0.0));
        assert_eq!(at(-3.0, Repeat), (17.0, 0.0));
        for seam in [-10.0, 0.0, 30.0, 40.0] {
            assert_eq!(at(seam, Repeat), (20.0, 0.0));
        }
        assert_eq!(at(23.0, PingPong), (17.0, 0.0));
        assert_eq!(at(33.0, PingPong), (13.0, 0.0));
        assert_eq!(at(7.0, PingPong), (13.0, 0.0));
        assert_eq!(at(30.0, PingPong), (10.0, 0.0));
        assert_eq!(at(23.0, Offset), (13.0, 1.0));
        assert_eq!(at(30.0, Offset), (20.0, 1.0));
        assert_eq!(at(30.5, Offset), (10.5, 2.0));
        assert_eq!(at(7.0, Offset), (17.0, -1.0));
        assert_eq!(at(0.0, Offset), (20.0, -2.0));
    }

    #[test]
    fn each_side_has_its_own() {
        assert_eq!(local_frame(5.0, 10.0, 20.0, PingPong, Hold), (15.0, 0.0));
        assert_eq!(local_frame(25.0, 10.0, 20.0, PingPong, Hold), (20.0, 0.0));
    }

    #[test]
    fn names_lead_back() {
        for beyond in [Hold, Repeat, PingPong, Offset] {
            assert_eq!(Extrapolation::named(beyond.name()), Some(beyond));
        }
        assert_eq!(Extrapolation::named("loop"), None);
    }
}
