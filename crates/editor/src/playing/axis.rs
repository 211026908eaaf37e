//! The frames along the timeline: from frames to the screen and back, and the steps of a ruler.

use egui::Rangef;

/// From frames to the screen.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Axis {
    pub(super) rail: Rangef,
    /// From the first frame to the last one, at least 1.
    pub(super) frames: f32,
}

impl Axis {
    #[allow(clippy::cast_precision_loss)]
    pub(super) fn new(rail: Rangef, frames: usize) -> Self {
        let frames = (frames as f32 - 1.0).max(1.0);
        Self { rail, frames }
    }

    pub(super) fn x(&self, frame: f32) -> f32 {
        let share = ((frame - 1.0) / self.frames).min(1.0);
        self.rail.min + self.rail.span() * share
    }

    #[allow(clippy::cast_possible_truncation)]
    pub(super) fn x_of(&self, frame: f64) -> f32 {
        self.x(frame as f32)
    }

    /// The frame there, a whole one or not, perhaps beyond the ends.
    pub(super) fn frame(&self, x: f32) -> f64 {
        1.0 + f64::from(x - self.rail.min) * self.frames_per_point()
    }

    pub(super) fn frames_per_point(&self) -> f64 {
        f64::from(self.frames) / f64::from(self.rail.span().max(1.0))
    }
}

/// The least of 1, 2, 5, 10, 20 … times a power of ten that is not below `least`, and how many
/// parts its small steps make.
pub(super) fn step(least: f64) -> (f64, u32) {
    let least = least.clamp(1e-9, 1e15);
    let power = 10.0_f64.powf(least.log10().floor());
    let steps = [(1.0, 5), (2.0, 4), (5.0, 5), (10.0, 5)];
    let all = steps.map(|(part, parts)| (part * power, parts));
    let fits = all
        .into_iter()
        .find(|&(step, _)| step >= least * (1.0 - 1e-9));
    fits.unwrap_or((10.0 * power, 5))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn steps_are_one_two_or_five_and_never_too_small() {
        for (least, expected) in [
            (1.0, 1.0),
            (1.01, 2.0),
            (3.0, 5.0),
            (5.1, 10.0),
            (0.03, 0.05),
            (0.2, 0.2),
            (1234.0, 2000.0),
        ] {
            let (found, _) = step(least);
            assert!((found / expected - 1.0).abs() < 1e-9, "{least}: {found}");
        }
        for odd in [0.0, -1.0, f64::INFINITY, f64::MIN_POSITIVE] {
            let (found, parts) = step(odd);
            assert!(found.is_finite() && found > 0.0 && parts > 0, "{odd}");
        }
    }

    #[test]
    fn the_screen_leads_back_to_the_frame() {
        let axis = Axis::new(Rangef::new(152.0, 1180.0), 724);
        for frame in [1.0, 2.0, 354.0, 724.0] {
            assert!(
                (axis.frame(axis.x_of(frame)) - frame).abs() < 1e-3,
                "{frame}"
            );
        }
        // What is behind the end is shown at it.
        assert_eq!(axis.x(1e9), 1180.0);
    }
}
