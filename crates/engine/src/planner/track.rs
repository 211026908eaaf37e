//! Few keys of a given distance that follow a pace and hold the limits.
//!
//! The keys are joined by a monotone cubic whose slopes are those of the parabola through three
//! keys. Between two keys the acceleration therefore runs straight from 2c₀ − c₁ to 2c₁ − c₀, c being
//! those of the parabolas: a jump would swing out by its own size. So the acceleration is smoothed
//! first, over less than a frame, by exp(−|t|/τ), of which keys at even distances swing out
//! nowhere.

use super::course::{Ask, Bounds, Course};
use super::frames::Paced;
use crate::error::{Result, vec_with_room};
use crate::limits::MAX_DISTANCE_KEYS;
use crate::math::monotone_cubic::{cubic, slope, slopes, value};
use crate::tools::check::FindingKind;

/// A pace as a function of time, in even steps: share of the way, its rate and its change.
#[derive(Debug)]
pub(super) struct Wanted {
    /// Seconds between two steps.
    step: f64,
    phi: Vec<f64>,
    rate: Vec<f64>,
    /// Between two steps.
    change: Vec<f64>,
}

/// Steps for a frame, and at least and most for a section.
const STEPS: usize = 20;
const FEWEST: usize = 120;
const MOST: usize = 6000;

impl Wanted {
    /// The pace of squared rates on an even grid, in so many frames.
    pub(super) fn new(xs: &[f64], frames: usize, fps: f64) -> Result<Self> {
        let count = (STEPS * frames).clamp(FEWEST, MOST);
        let cells = xs.len() - 1;
        let share = 1.0 / cells as f64;
        let cell = |k: usize| 2.0 * share / (xs[k].sqrt() + xs[k + 1].sqrt());
        let all: f64 = (0..cells).map(cell).sum();
        let step = all / count as f64;
        let mut wanted = Self {
            step: frames as f64 / fps / count as f64,
            phi: vec_with_room(count + 1)?,
            rate: vec_with_room(count + 1)?,
            change: vec_with_room(count)?,
        };
        let (mut k, mut begin) = (0, 0.0);
        for at in 0..=count {
            let time = at as f64 * step;
            while k + 1 < cells && begin + cell(k) < time {
                begin += cell(k);
                k += 1;
            }
            let (from, length) = (xs[k].sqrt(), cell(k));
            let t = (time - begin).clamp(0.0, length);
            let change = (xs[k + 1] - xs[k]) / (2.0 * share);
            wanted
                .phi
                .push(k as f64 * share + t * (from + 0.5 * t * change));
            wanted.rate.push(from + t * change);
        }
        wanted.phi[count] = 1.0;
        let pairs = wanted
            .rate
            .windows(2)
            .map(|pair| (pair[1] - pair[0]) / wanted.step);
        wanted.change.extend(pairs);
        Ok(wanted)
    }

    /// Its change smoothed over some steps; ends and their rates stay.
    fn smoothed(&self, over: f64) -> Result<Self> {
        let count = self.change.len();
        let mut change = vec_with_room(count)?;
        change.extend_from_slice(&self.change);
        let keep = (-1.0 / over).exp();
        for backwards in [false, true] {
            let index = |k: usize| if backwards { count - 1 - k } else { k };
            // Mirrored at the ends.
            let before = ((8.0 * over) as usize).min(count - 1);
            let mut state = change[index(before)];
            for k in (0..before).rev() {
                state += (1.0 - keep) * (change[index(k)] - state);
            }
            for k in 0..count {
                state += (1.0 - keep) * (change[index(k)] - state);
                change[index(k)] = state;
            }
        }
        // What the ends lack now, as a straight line.
        let n = count as f64;
        let duration = n * self.step;
        let lost: f64 = self
            .change
            .iter()
            .zip(&change)
            .map(|(a, b)| a - b)
            .sum::<f64>()
            / n;
        let moment = |all: &[f64]| -> f64 {
            let at = |(k, c): (usize, &f64)| c * (n - k as f64 - 0.5) / n;
            all.iter().enumerate().map(at).sum::<f64>() / n
        };
        let lean = 12.0 * (moment(&self.change) - moment(&change) - 0.5 * lost);
        for (k, change) in change.iter_mut().enumerate() {
            *change += lost + lean * (0.5 - (k as f64 + 0.5) / n);
        }
        let mut made = Self {
            step: self.step,
            phi: vec_with_room(count + 1)?,
            rate: vec_with_room(count + 1)?,
            change,
        };
        let (mut phi, mut rate) = (0.0, self.rate[0]);
        for change in &made.change {
            made.phi.push(phi);
            made.rate.push(rate);
            phi += self.step * (rate + 0.5 * self.step * change);
            rate += self.step * change;
        }
        made.phi.push(1.0);
        made.rate.push(self.rate[count]);
        debug_assert!(duration > 0.0);
        Ok(made)
    }

    /// Steps around the few greatest jumps of the change, as far apart as the smoothing halves them;
    /// empty where there are none, or too many.
    fn around_jumps(
        &self,
        course: &Course,
        bounds: &Bounds,
        fps: f64,
        over: f64,
    ) -> Result<Vec<usize>> {
        let count = self.change.len();
        let window = ((1.0 / fps / self.step) as usize).clamp(2, count / 4);
        let mut jumps = vec_with_room(count)?;
        for k in 0..count - window {
            let ask = course.at(self.phi[k + window / 2]);
            jumps.push((self.change[k + window] - self.change[k]).abs() * weight(&ask, bounds));
        }
        let mut places: Vec<f64> = vec_with_room(JUMPS + 1)?;
        while places.len() <= JUMPS {
            let greatest = (0..jumps.len()).max_by(|a, b| jumps[*a].total_cmp(&jumps[*b]));
            let Some(at) = greatest.filter(|at| jumps[*at] > LEAST_JUMP) else {
                break;
            };
            // The middle of what changes there.
            let (mut sum, mut all) = (0.0, 0.0);
            for k in at..at + window {
                let step = (self.change[k + 1] - self.change[k]).abs();
                sum += step * (k + 1) as f64;
                all += step;
            }
            places.push(sum / all);
            let (from, to) = (at.saturating_sub(2 * window), at + 2 * window);
            jumps[from..to.min(count - window)].fill(0.0);
        }
        let mut at: Vec<usize> = vec_with_room(MAX_DISTANCE_KEYS + 2)?;
        if places.is_empty() || places.len() > JUMPS {
            return Ok(at);
        }
        let beside = [5, 5, 4, 3][places.len() - 1];
        let apart = over * std::f64::consts::LN_2;
        for place in places {
            for k in -beside..=beside {
                let step = (place + f64::from(k) * apart).round();
                if step > 0.0 && step < count as f64 {
                    at.push(step as usize);
                }
            }
        }
        at.sort_unstable();
        let least = (0.7 * apart).max(1.0) as usize;
        let mut last = 0;
        at.retain(|step| {
            let fits = *step >= last + least && *step + least <= count;
            if fits {
                last = *step;
            }
            fits
        });
        at.insert(0, 0);
        at.push(count);
        Ok(at)
    }
}

/// As many jumps of the change have keys around them, if they are this share of the limit.
const JUMPS: usize = 4;
const LEAST_JUMP: f64 = 0.2;

/// Keys, and how near they come to the limits: the greatest share of one and its kind.
#[derive(Debug, Clone)]
pub(super) struct Track {
    pub keys: Vec<[f64; 2]>,
    pub worst: (f64, FindingKind),
    /// The pace that it follows.
    pub xs: Vec<f64>,
    pub frames: usize,
}

/// Keys with the greatest share of a limit and its kind.
type Keys = (Vec<[f64; 2]>, (f64, FindingKind));

/// Worse than any.
const NOT_YET: (f64, FindingKind) = (f64::INFINITY, FindingKind::Speed);

impl Default for Track {
    fn default() -> Self {
        Self {
            keys: Vec::new(),
            worst: NOT_YET,
            xs: Vec::new(),
            frames: 0,
        }
    }
}

/// Smoothing that is tried, in frames.
const OVER: [f64; 3] = [0.4, 1.0, 2.5];

/// Jump of the speed from section to section, in shares of what a frame of acceleration is.
const JUMP: f64 = 0.01;

/// Keys within the limits, as few as hold them, else those that come nearest.
pub(super) fn track(pace: &Paced, course: &Course, bounds: &Bounds, fps: f64) -> Result<Track> {
    let wanted = Wanted::new(&pace.xs, pace.frames, fps)?;
    let mut best = Track::default();
    best.xs.try_reserve(pace.xs.len())?;
    for over in OVER {
        let steps = over / fps / wanted.step;
        let smooth = wanted.smoothed(steps)?;
        let last = wanted.change.len();
        let mut plain = vec_with_room(MAX_DISTANCE_KEYS)?;
        plain.extend([0, last / 4, last / 2, last - last / 4, last]);
        let jumps = wanted.around_jumps(course, bounds, fps, steps)?;
        // Even in what is left, which follows smooth changes best.
        let [even, evenly] = [filled(&jumps)?, filled(&plain)?];
        for at in [even, evenly, jumps, plain] {
            if at.is_empty() || best.worst.0 <= 1.0 {
                continue;
            }
            let found = follow(&smooth, at, course, bounds, fps)?;
            if found.1.0 < best.worst.0 {
                (best.keys, best.worst) = found;
            }
        }
        if best.worst.0 <= 1.0 {
            break;
        }
    }
    best.xs.extend_from_slice(&pace.xs);
    best.frames = pace.frames;
    Ok(best)
}

/// These steps with the widest gaps between them halved, as many as keys may be.
fn filled(at: &[usize]) -> Result<Vec<usize>> {
    let mut all = vec_with_room(MAX_DISTANCE_KEYS.max(at.len()))?;
    all.extend_from_slice(at);
    while !all.is_empty() && all.len() < MAX_DISTANCE_KEYS {
        let gaps = all.windows(2).map(|pair| pair[1] - pair[0]).enumerate();
        let Some((widest, gap)) = gaps
            .max_by_key(|(_, gap)| *gap)
            .filter(|widest| widest.1 > 1)
        else {
            break;
        };
        all.insert(widest + 1, all[widest] + gap / 2);
    }
    Ok(all)
}

/// Keys put in where they miss most, until they hold the limits.
fn follow(
    wanted: &Wanted,
    mut at: Vec<usize>,
    course: &Course,
    bounds: &Bounds,
    fps: f64,
) -> Result<Keys> {
    let last = wanted.change.len();
    let mut asks: Vec<Ask> = vec_with_room(last + 1)?;
    asks.extend(wanted.phi.iter().map(|phi| course.at(*phi)));
    let mut best: Keys = (Vec::new(), NOT_YET);
    loop {
        let fitted = Fitted::new(wanted, &at);
        let (worst, order) = fitted.judge(wanted, &at, &asks, bounds, fps);
        if worst.0 < best.1.0 {
            best = (fitted.copied(at.len())?, worst);
        }
        if worst.0 <= 1.0 || at.len() == MAX_DISTANCE_KEYS {
            break;
        }
        let Some(gap) = order else {
            break;
        };
        at.insert(gap + 1, (at[gap] + at[gap + 1]) / 2);
    }
    if best.1.0 <= 1.0 {
        let mut k = at.len() - 2;
        while k > 0 && at.len() > 5 {
            let key = at.remove(k);
            let fitted = Fitted::new(wanted, &at);
            let (worst, _) = fitted.judge(wanted, &at, &asks, bounds, fps);
            if worst.0 <= 1.0 {
                best = (fitted.copied(at.len())?, worst);
            } else {
                at.insert(k, key);
            }
            k -= 1;
        }
    }
    Ok(best)
}

/// Keys at some steps of a pace, with their cubics.
struct Fitted {
    keys: [[f64; 2]; MAX_DISTANCE_KEYS],
    slopes: [f64; MAX_DISTANCE_KEYS],
}

impl Fitted {
    fn copied(&self, count: usize) -> Result<Vec<[f64; 2]>> {
        let mut keys = vec_with_room(count)?;
        keys.extend_from_slice(&self.keys[..count]);
        Ok(keys)
    }

    fn new(wanted: &Wanted, at: &[usize]) -> Self {
        let all = wanted.change.len();
        let time = all as f64 * wanted.step;
        let mut keys = [[0.0; 2]; MAX_DISTANCE_KEYS];
        for (key, &step) in keys.iter_mut().zip(at) {
            *key = [step as f64 / all as f64, wanted.phi[step]];
        }
        let last = at.len() - 1;
        keys[last] = [1.0, 1.0];
        // The keys next to the ends so that the parabolas there have the rates asked for.
        if at.len() >= 5 {
            let ends = [
                ([0, 1, 2], wanted.rate[0] * time),
                ([last, last - 1, last - 2], wanted.rate[all] * time),
            ];
            for ([end, next, third], rate) in ends {
                let h0 = (keys[next][0] - keys[end][0]).abs();
                let h1 = (keys[third][0] - keys[next][0]).abs();
                let rise = (keys[third][1] - keys[end][1]).abs();
                let share = h1 / (h0 + h1);
                let first = h0 * (rate * share + rise * h0 / (h0 + h1).powi(2));
                let sign = if end == 0 { 1.0 } else { -1.0 };
                if first > 0.0 && first < rise {
                    keys[next][1] = keys[end][1] + sign * first;
                }
            }
        }
        let mut made = Self {
            keys,
            slopes: [0.0; MAX_DISTANCE_KEYS],
        };
        let (mut steps, mut rises) = ([0.0; MAX_DISTANCE_KEYS], [0.0; MAX_DISTANCE_KEYS]);
        for (k, pair) in made.keys[..=last].windows(2).enumerate() {
            steps[k] = pair[1][0] - pair[0][0];
            rises[k] = pair[1][1] - pair[0][1];
        }
        slopes(
            &steps[..last],
            &rises[..last],
            false,
            &mut made.slopes[..=last],
        );
        made
    }

    /// The greatest share of a limit, and the gap between keys that misses the pace most.
    fn judge(
        &self,
        wanted: &Wanted,
        at: &[usize],
        asks: &[Ask],
        bounds: &Bounds,
        fps: f64,
    ) -> ((f64, FindingKind), Option<usize>) {
        let all = wanted.change.len();
        let time = all as f64 * wanted.step;
        let mut worst = (0.0, FindingKind::Speed);
        let mut see = |share: f64, kind: FindingKind| {
            if share > worst.0 || share.is_nan() {
                worst = (if share.is_nan() { f64::INFINITY } else { share }, kind);
            }
        };
        let mut missed = (0.0, None);
        for (k, pair) in at.windows(2).enumerate() {
            let ([from, low], [to, high]) = (self.keys[k], self.keys[k + 1]);
            let step = to - from;
            if high <= low {
                see(f64::INFINITY, FindingKind::Acceleration);
            }
            let way = cubic(low, high - low, step, self.slopes[k], self.slopes[k + 1]);
            let mut off = 0.0_f64;
            for at in pair[0]..=pair[1] {
                let x = (at as f64 / all as f64 - from) / step;
                let rate = slope(&way, x) / (step * time);
                let change = (6.0 * way[3] * x + 2.0 * way[2]) / (step * time).powi(2);
                let ask = &asks[at];
                judge(ask, rate, change, bounds, &mut see);
                let right = wanted.change[at.min(pair[1] - 1).max(pair[0])];
                let weight = weight(ask, bounds);
                let ahead = (value(&way, x) - wanted.phi[at]).abs() * weight * fps * fps;
                let rates = (rate - wanted.rate[at]).abs() * weight * fps;
                off = off.max((change - right).abs() * weight + rates + 0.1 * ahead);
            }
            let splits = pair[1] - pair[0] > 1;
            if splits && off > missed.0 {
                missed = (off, Some(k));
            }
        }
        let last = at.len() - 1;
        for (slope, (rate, ask)) in [self.slopes[0], self.slopes[last]]
            .into_iter()
            .zip([(wanted.rate[0], &asks[0]), (wanted.rate[all], &asks[all])])
        {
            let jump = (slope / time - rate).abs() * weight(ask, bounds) * fps;
            see(jump / JUMP, FindingKind::Acceleration);
        }
        (worst, missed.1)
    }
}

/// How much a change of the rate counts, as a share of the limits of changes; else of rates.
fn weight(ask: &Ask, bounds: &Bounds) -> f64 {
    let way = ask.tangent.length() / bounds.acceleration;
    let turn = ask.turn.length() / bounds.turning_acceleration;
    let changes = way.max(turn);
    if changes > 0.0 {
        return changes;
    }
    let (rate, _) = bounds.rate(ask);
    0.1 / rate.min(1e12)
}

/// The shares of all limits at a place.
pub(super) fn judge(
    ask: &Ask,
    rate: f64,
    change: f64,
    bounds: &Bounds,
    see: &mut dyn FnMut(f64, FindingKind),
) {
    let x = rate * rate;
    let moved = ask.tangent * change + ask.bend * x;
    let turned = ask.turn * change + ask.twist * x;
    see(
        ask.tangent.length() * rate / bounds.speed,
        FindingKind::Speed,
    );
    see(
        moved.length() / bounds.acceleration,
        FindingKind::Acceleration,
    );
    see(
        ask.turn.length() * rate / bounds.turning,
        FindingKind::Turning,
    );
    see(
        turned.length() / bounds.turning_acceleration,
        FindingKind::TurningAcceleration,
    );
    see(ask.zoom * rate / bounds.zoom, FindingKind::Zoom);
    see(ask.crossing * rate * bounds.crossing, FindingKind::Crossing);
}
