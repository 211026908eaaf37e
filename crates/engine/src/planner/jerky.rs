//! Paces whose acceleration does not jump: which window to smooth them over, and whole frames again.

use super::super::course::{Bounds, Course};
use super::super::frames::{Paced, Row};
use super::super::reach::{Reach, mixed, seconds};
use super::super::smooth::{Flight, jerk};
use super::super::track::{Knot, knots};
use super::Work;
use crate::error::{Result, vec_with_room};

/// How a pace is smoothed: over a window of seconds, after it was found for smaller limits.
#[derive(Debug, Clone, Copy)]
pub(super) struct Smoothing {
    acceleration: f64,
    speed: f64,
    window: f64,
}

/// The ratio of successive accelerations and speeds that are tried, and their number.
const SMALLER: [f64; 2] = [0.85, 0.92];
const TRIED: [usize; 2] = [16, 24];

/// Stops trying where it takes longer than the best by this factor.
const WORSE: f64 = 1.03;

/// Share of the jerk's limit that a window should reach.
const FULL: [f64; 2] = [0.97, 0.995];

/// The narrowest window, in frames, and the widest, a share of the longest flight from rest to rest:
/// one that only speeds up and slows down has half of its time, and a wider one is of no use.
const NARROWEST: f64 = 0.25;
const WIDEST: f64 = 0.75;

/// Rounds in which sections take whole frames: near a rest about half of what one is slower is made
/// good by its neighbours, so each step goes further than what is missing.
const SETTLED: usize = 40;
const MORE: f64 = 1.4;

/// Rounds in which a window is found.
const ROUNDS: usize = 12;

/// How much faster than the fastest pace a section may be before smoothing: margins do the rest.
const FASTER: f64 = 0.002;

/// What may be missing to whole frames, in frames, where the rest is stretched.
const WHOLE: f64 = 1e-6;

/// Seconds of a section.
fn lasts(section: &[Knot]) -> f64 {
    section.last().map_or(0.0, |knot| knot[0])
}

impl Smoothing {
    /// Limits for the pace to smooth, slower by a factor.
    pub(super) fn bounds(&self, bounds: &Bounds, slower: f64) -> Bounds {
        Bounds {
            acceleration: bounds.acceleration.min(self.acceleration / slower.powi(2)),
            speed: bounds.speed.min(self.speed / slower),
            ..*bounds
        }
    }
}

impl Work<'_> {
    /// Sections that are flown without rest.
    fn runs(&self) -> impl Iterator<Item = std::ops::Range<usize>> {
        let count = self.courses.len();
        let rests = move |k: usize| k == 0 || k == count || self.joints[k].most == 0.0;
        let next = move |from: usize| (from + 1..=count).find(|k| rests(*k)).unwrap_or(count);
        (0..count)
            .filter(move |k| rests(*k))
            .map(move |from| from..next(from))
    }

    /// Knots of each section, smoothed; its times change by that.
    fn smooth(&self, sections: &[Vec<Knot>], window: f64) -> Result<Vec<Vec<Knot>>> {
        let mut all = vec_with_room(sections.len())?;
        for run in self.runs() {
            let mut gains = vec_with_room(run.len())?;
            gains.extend(self.joints[run.clone()].iter().map(|joint| joint.gain));
            let flight = Flight::new(&sections[run], &gains, self.ring)?;
            all.append(&mut flight.cut(&flight.smoothed(window)?)?);
        }
        Ok(all)
    }

    /// The greatest jerk of all sections.
    fn jerk(&self, sections: &[Vec<Knot>]) -> Result<f64> {
        let mut most = 0.0_f64;
        for run in self.runs() {
            let mut courses: Vec<&Course> = vec_with_room(run.len())?;
            courses.extend(&self.courses[run.clone()]);
            most = most.max(jerk(&sections[run], &courses, self.ring, self.request.fps)?);
        }
        Ok(most)
    }

    /// How to smooth for the shortest time within the limit of the jerk; none where there is no
    /// such limit, nowhere to go, or a speed given at an end.
    pub(super) fn smoothing(&self) -> Result<Option<Smoothing>> {
        let count = self.courses.len();
        let ends = [0, count].map(|k| self.joints[k].most > 0.0);
        if self.bounds.jerk.is_infinite() || !self.ring && ends.contains(&true) {
            return Ok(None);
        }
        // The greatest acceleration of the shortest flight without other limits.
        let way = |course: &Course| course.middle(course.cells() / 2).tangent.length();
        let length: f64 = self.courses.iter().map(way).sum();
        let useful = (0.5 * length * self.bounds.jerk.powi(2)).cbrt();
        if !(useful > 0.0 && useful.is_finite()) {
            return Ok(None);
        }
        let mut acceleration = self.bounds.acceleration.min(useful);
        let mut best: Option<(f64, Smoothing)> = None;
        for _ in 0..TRIED[0] {
            let mut least = f64::INFINITY;
            let mut speed = self.bounds.speed;
            for _ in 0..TRIED[1] {
                let Some((time, fastest, found)) = self.tried(acceleration, speed)? else {
                    break;
                };
                if best.is_none_or(|best| time < best.0) {
                    best = Some((time, found));
                }
                if time > WORSE * least {
                    break;
                }
                least = least.min(time);
                speed = SMALLER[1] * fastest.min(speed);
            }
            if best.is_some_and(|best| least > WORSE * best.0) {
                break;
            }
            acceleration *= SMALLER[0];
        }
        Ok(best.map(|best| best.1))
    }

    /// The shortest time with these limits smoothed, the greatest speed before, and how.
    fn tried(&self, acceleration: f64, speed: f64) -> Result<Option<(f64, f64, Smoothing)>> {
        let mut found = Smoothing {
            acceleration,
            speed,
            window: 0.0,
        };
        let most = NARROWEST / self.request.fps;
        found.window = (acceleration / self.bounds.jerk).max(most);
        let reaches = self.reaches(&found.bounds(&self.bounds, 1.0))?;
        let paces = self.row(&reaches, 1.0).fastest()?;
        let mut sections = vec_with_room(paces.len())?;
        let (mut time, mut fastest) = (0.0, 0.0_f64);
        for ((xs, course), reach) in paces.iter().zip(&self.courses).zip(&reaches) {
            let takes = seconds(xs, reach.ramps);
            if !takes.is_finite() {
                return Ok(None);
            }
            time += takes;
            for (node, x) in xs.iter().enumerate() {
                fastest = fastest.max(course.node(node).tangent.length() * x.sqrt());
            }
            sections.push(knots(xs, reach.ramps, takes)?);
        }
        let times = |run: std::ops::Range<usize>| {
            sections[run]
                .iter()
                .map(|section| lasts(section))
                .sum::<f64>()
        };
        let most = most..WIDEST * self.runs().map(times).fold(0.0, f64::max);
        let rests = if self.ring { 0 } else { self.runs().count() };
        let mut window: Option<f64> = None;
        for _ in 0..ROUNDS {
            let smooth = self.smooth(&sections, found.window)?;
            let share = self.jerk(&smooth)? / self.bounds.jerk;
            if share <= FULL[1] && window.is_none_or(|known| found.window < known) {
                window = Some(found.window);
            }
            if (FULL[0]..=FULL[1]).contains(&share) || found.window <= most.start && share <= 1.0 {
                break;
            }
            found.window *= (2.0 * share / (FULL[0] + FULL[1])).clamp(0.25, 2.0);
            found.window = found.window.max(most.start);
            if !(found.window < most.end) {
                break;
            }
        }
        Ok(window.map(|window| {
            found.window = window;
            (time + rests as f64 * window, fastest, found)
        }))
    }

    /// The knots of all sections in their whole frames, smoothed if they are to be; none where they
    /// do not fit yet: then how much longer smoothing makes them has changed.
    pub(super) fn flown(&mut self, paces: &[Paced], slower: f64) -> Result<Option<Vec<Vec<Knot>>>> {
        let fps = self.request.fps;
        let whole = |pace: &Paced| pace.frames as f64 / fps;
        let mut sections = vec_with_room(paces.len())?;
        let Some(smoothing) = self.smoothing else {
            for pace in paces {
                sections.push(knots(&pace.xs, pace.ramps, whole(pace))?);
            }
            return Ok(Some(sections));
        };
        let mut targets = vec_with_room(paces.len())?;
        for pace in paces {
            let takes = seconds(&pace.xs, pace.ramps);
            targets.push(takes);
            sections.push(knots(&pace.xs, pace.ramps, takes)?);
        }
        for _ in 0..SETTLED {
            let mut smooth = self.smooth(&sections, smoothing.window * slower)?;
            let (mut worst, mut fits) = (0.0_f64, true);
            for (k, pace) in paces.iter().enumerate() {
                let takes = smooth[k][smooth[k].len() - 1][0];
                let off = whole(pace) - takes;
                worst = worst.max(off.abs() * fps);
                self.lags[k] = (takes - targets[k]) / slower;
                targets[k] += MORE * off;
                let [least, most] = [&pace.fast, &pace.slow].map(|xs| seconds(xs, pace.ramps));
                fits &=
                    targets[k] >= least * (1.0 - FASTER) / slower && targets[k] <= most * slower;
                let xs = mixed(&pace.fast, &pace.slow, pace.ramps, targets[k])?;
                sections[k] = knots(&xs, pace.ramps, targets[k])?;
            }
            if worst < WHOLE {
                for (section, pace) in smooth.iter_mut().zip(paces) {
                    let last = section.len() - 1;
                    let longer = whole(pace) / section[last][0];
                    for knot in section.iter_mut() {
                        knot[0] *= longer;
                        knot[2] /= longer;
                    }
                    section[last][0] = whole(pace);
                }
                return Ok(Some(smooth));
            }
            if !fits || !worst.is_finite() {
                break;
            }
        }
        Ok(None)
    }

    /// How fast each section may be.
    pub(super) fn reaches(&self, bounds: &Bounds) -> Result<Vec<Reach>> {
        let mut reaches = vec_with_room(self.courses.len())?;
        for (course, margins) in self.courses.iter().zip(&self.margins) {
            reaches.push(Reach::new(course, bounds, margins, self.request.fps)?);
        }
        Ok(reaches)
    }

    /// At first a window takes half of its time beside each rest.
    pub(super) fn start_smooth(&mut self) -> Result<()> {
        self.smoothing = self.smoothing()?;
        self.lags.fill(0.0);
        let Some(smoothing) = self.smoothing else {
            return Ok(());
        };
        if !self.ring {
            let mut ends = vec_with_room(2 * self.courses.len())?;
            ends.extend(self.runs().flat_map(|run| [run.start, run.end - 1]));
            for end in ends {
                self.lags[end] += 0.5 * smoothing.window;
            }
        }
        Ok(())
    }

    /// Not smoothed any more, from the margins of the beginning.
    pub(super) fn start_plain(&mut self) {
        self.smoothing = None;
        self.lags.fill(0.0);
        for margins in &mut self.margins {
            margins.fill(super::LEAST_MARGIN);
        }
    }

    /// Limits of slower paces, before smoothing.
    pub(super) fn slower_bounds(&self, slower: f64) -> Bounds {
        let mut bounds = self.bounds.stretched(slower);
        match &self.smoothing {
            Some(smoothing) => smoothing.bounds(&bounds, slower),
            None => {
                // Jumps of the acceleration leave about this; margins do the rest.
                let jump = bounds.jerk / (1.5 * self.request.fps);
                bounds.acceleration = bounds.acceleration.min(jump);
                bounds
            }
        }
    }

    pub(super) fn row<'b>(&'b self, reaches: &'b [Reach], slower: f64) -> Row<'b> {
        Row {
            reaches,
            joints: &self.joints,
            lags: &self.lags,
            slower,
            ring: self.ring,
            fps: self.request.fps,
        }
    }
}
