//! The frames along the timeline: from frames to the screen and back, the part of them that is
//! seen, and the steps of a ruler.

use std::ops::Range;

use egui::Rangef;

/// The least frames between the ends of the rail.
const LEAST: f64 = 1.0;

/// The margin on each side, as a share of what is shown.
const ROOM: f64 = 0.05;

/// Signs nearer to one another than this are one, in points.
pub(super) const APART: f32 = 3.0;

/// A press this near to a key means it.
pub(super) const REACH: f32 = 6.0;

/// How far beyond the rail something still shows, in points.
const BEYOND: f32 = 8.0;

/// The frames at the two ends of the rail, where not all are seen.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Seen {
    pub(crate) first: f64,
    pub(crate) last: f64,
}

impl Seen {
    /// As much, moved as far as a frame needs; `pages`: so that what follows it is seen.
    pub(super) fn showing(self, frame: f64, pages: bool) -> Self {
        let span = self.last - self.first;
        let first = match frame {
            frame if frame < self.first || pages && frame > self.last => frame,
            frame if frame > self.last => frame - span,
            _ => return self,
        };
        let last = first + span;
        Self { first, last }
    }

    /// This range within `frames` frames from `begin` on; `None` if all of them are visible.
    fn within(self, begin: f64, frames: f64) -> Option<Self> {
        let span = (self.last - self.first).max(LEAST);
        if !(span < frames && self.first.is_finite()) {
            return None;
        }
        let first = self.first.clamp(begin, begin + frames - span);
        let last = first + span;
        Some(Self { first, last })
    }

    /// The same, with each frame `by` more.
    fn counted(self, by: f64) -> Self {
        let (first, last) = (self.first + by, self.last + by);
        Self { first, last }
    }
}

/// From frames to the screen.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Axis {
    pub(super) rail: Rangef,
    /// The first frame.
    begin: f64,
    /// From the first frame to the last one, at least 1.
    frames: f32,
    /// What is behind this frame lies at it.
    end: f64,
    seen: Option<Seen>,
}

impl Axis {
    /// All frames from a first to a last one, or a part of them.
    #[allow(clippy::cast_possible_truncation)]
    pub(super) fn new(rail: Rangef, (begin, last): (f64, f64), seen: Option<Seen>) -> Self {
        let frames = ((last - begin) as f32).max(1.0);
        let seen = seen.and_then(|seen| seen.within(begin, f64::from(frames)));
        let end = begin + f64::from(frames);
        Self {
            rail,
            begin,
            frames,
            end,
            seen,
        }
    }

    /// The same with each frame counted as `by` more, for what ends at `end`.
    pub(super) fn counted(&self, by: f64, end: f64) -> Self {
        Self {
            begin: self.begin + by,
            end: end.max(self.end + by),
            seen: self.seen.map(|seen| seen.counted(by)),
            ..*self
        }
    }

    /// What is behind the last frame lies at it.
    pub(super) fn x_of(&self, frame: f64) -> f32 {
        self.place(frame.min(self.end))
    }

    /// The same for frames before the first and behind the last one, too.
    #[allow(clippy::cast_possible_truncation)]
    pub(super) fn place(&self, frame: f64) -> f32 {
        let share = (frame - self.first()) / (self.last() - self.first());
        (f64::from(self.rail.min) + f64::from(self.rail.span()) * share) as f32
    }

    /// The frame there, a whole one or not, perhaps beyond the ends.
    pub(super) fn frame(&self, x: f32) -> f64 {
        self.first() + f64::from(x - self.rail.min) * self.frames_per_point()
    }

    pub(super) fn frames_per_point(&self) -> f64 {
        (self.last() - self.first()) / f64::from(self.rail.span().max(1.0))
    }

    /// The frame at the left end of the rail.
    pub(super) fn first(&self) -> f64 {
        self.seen.map_or(self.begin, |seen| seen.first)
    }

    /// The frame at the right end of the rail.
    pub(super) fn last(&self) -> f64 {
        let all = self.begin + f64::from(self.frames);
        self.seen.map_or(all, |seen| seen.last)
    }

    /// The keys that are to be seen: where their sign stands, and which ones share it.
    pub(super) fn signs(&self, frames: &[f64]) -> Vec<(f32, Range<usize>)> {
        let ends = self.rail.expand(REACH);
        let last = self.frame(ends.max);
        let first = self.frame(ends.min);
        let mut at = frames.partition_point(|&key| key < first);
        let mut all = Vec::new();
        while let Some(&frame) = frames.get(at).filter(|&&key| key <= last) {
            let x = self.place(frame);
            let next = self.frame(x + APART);
            let end = at + frames[at..].partition_point(|&key| key < next).max(1);
            all.push((x, at..end));
            at = end;
        }
        all
    }

    /// The key that is nearest, if one is near.
    pub(super) fn nearest(&self, frames: &[f64], x: f32) -> Option<usize> {
        let frame = self.frame(x);
        let behind = frames.partition_point(|&key| key < frame);
        let around = [behind.checked_sub(1), Some(behind)].into_iter().flatten();
        let away = |at: &usize| (self.place(frames[*at]) - x).abs();
        let known = around.filter(|&at| at < frames.len());
        let near = known.min_by(|a, b| away(a).total_cmp(&away(b)));
        near.filter(|at| away(at) <= REACH)
    }

    pub(super) fn shows_all(&self) -> bool {
        self.seen.is_none()
    }

    /// Whether this frame is visible.
    pub(super) fn sees(&self, x: f32) -> bool {
        self.rail.expand(BEYOND).contains(x)
    }

    /// The part of the rail that stands for what is seen, if that is not all.
    #[allow(clippy::cast_possible_truncation)]
    pub(super) fn part(&self) -> Option<Rangef> {
        let seen = self.seen?;
        let x = |frame: f64| {
            let share = (frame - self.begin) / f64::from(self.frames);
            self.rail.min + self.rail.span() * share as f32
        };
        Some(Rangef::new(x(seen.first), x(seen.last)))
    }

    /// With `factor` times as many frames, of which the one at `x` stays there.
    pub(super) fn zoomed(&self, x: f32, factor: f64) -> Option<Seen> {
        let frames = f64::from(self.frames);
        let wanted = (self.last() - self.first()) * factor;
        let factor = wanted.max(LEAST.min(frames)) / (self.last() - self.first());
        let stays = self.frame(x);
        let to = |frame: f64| stays + (frame - stays) * factor;
        let (first, last) = (to(self.first()), to(self.last()));
        Seen { first, last }.within(self.begin, frames)
    }

    /// With all frames between two visible, and a small margin.
    pub(super) fn between(&self, first: f64, last: f64) -> Option<Seen> {
        let more = (ROOM * (last - first)).max(LEAST);
        let (first, last) = (first - more, last + more);
        Seen { first, last }.within(self.begin, f64::from(self.frames))
    }

    /// Moved by a number of points.
    pub(super) fn moved(&self, by: f32) -> Option<Seen> {
        let by = f64::from(by) * self.frames_per_point();
        let (first, last) = (self.first() - by, self.last() - by);
        Seen { first, last }.within(self.begin, f64::from(self.frames))
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

#[allow(clippy::cast_precision_loss)]
pub(crate) fn as_frame(frame: usize) -> f64 {
    frame as f64
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
        let all = Axis::new(Rangef::new(152.0, 1180.0), (1.0, 724.0), None);
        let part = Axis::new(all.rail, (1.0, 724.0), all.zoomed(500.0, 0.1));
        assert!(!part.shows_all());
        for axis in [all, part] {
            for frame in [1.0, 2.0, 354.0, 724.0] {
                let x = axis.x_of(frame);
                assert!((axis.frame(x) - frame).abs() < 1e-3, "{frame}");
                assert!((axis.place(frame) - x).abs() < 1e-3, "{frame}");
            }
            // What is behind the end is shown at it.
            assert_eq!(axis.x_of(1e9), axis.x_of(724.0));
        }
        assert_eq!(all.x_of(1e9), 1180.0);
    }

    /// A path that begins at frame 21 of a scene of the frames −9 to 190.
    #[test]
    fn a_path_is_counted_along_the_axis_of_its_scene() {
        let all = Axis::new(Rangef::new(100.0, 1100.0), (-9.0, 190.5), None);
        assert_eq!((all.x_of(-9.0), all.x_of(190.5)), (100.0, 1100.0));
        let part = Axis::new(all.rail, (-9.0, 190.5), all.zoomed(500.0, 0.3));
        for axis in [all, part] {
            let of_path = axis.counted(-20.0, 300.0);
            for frame in [1.0, 40.0, 170.5] {
                let x = axis.x_of(frame + 20.0);
                assert!((of_path.x_of(frame) - x).abs() < 1e-3, "{frame}");
                assert!((of_path.frame(x) - frame).abs() < 1e-3, "{frame}");
            }
            // What goes on behind the scene's end is not piled up there.
            assert!(of_path.x_of(250.0) > axis.x_of(190.5) + 100.0);
            assert_eq!(of_path.x_of(300.0), of_path.x_of(1e9));
        }
    }

    /// What is under the pointer stays there, within the ends of the film.
    #[test]
    fn a_part_is_zoomed_about_a_place_and_moved() {
        let mut axis = Axis::new(Rangef::new(100.0, 1100.0), (1.0, 1001.0), None);
        assert_eq!(axis.zoomed(300.0, 1.25), None);
        let stays = axis.frame(300.0);
        let with = |axis: Axis, seen| Axis::new(axis.rail, (1.0, 1001.0), seen);
        for _ in 0..60 {
            axis = with(axis, axis.zoomed(300.0, 0.8));
            assert!((axis.frame(300.0) - stays).abs() < 1e-6);
        }
        assert!((axis.last() - axis.first() - LEAST).abs() < 1e-9);
        for _ in 0..20 {
            axis = with(axis, axis.zoomed(300.0, 1.25));
        }
        let there = axis.frame(600.0);
        axis = with(axis, axis.moved(40.0));
        assert!((axis.frame(640.0) - there).abs() < 1e-6);
        for (by, end) in [(1e6, 1.0), (-1e6, 1001.0)] {
            let moved = with(axis, axis.moved(by));
            let at = if by > 0.0 {
                moved.first()
            } else {
                moved.last()
            };
            assert!((at - end).abs() < 1e-9, "{at}");
            assert!((moved.last() - moved.first() - axis.last() + axis.first()).abs() < 1e-9);
        }
        for _ in 0..100 {
            axis = with(axis, axis.zoomed(300.0, 1.25));
        }
        assert!(axis.shows_all());
        assert_eq!(axis.part(), None);
        // A path that became shorter than what was seen of it.
        let seen = Seen {
            first: 500.0,
            last: 700.0,
        };
        assert!(Axis::new(axis.rail, (1.0, 150.0), Some(seen)).shows_all());
        let shorter = Axis::new(axis.rail, (1.0, 400.0), Some(seen));
        assert_eq!((shorter.first(), shorter.last()), (200.0, 400.0));
    }
}
