//! What the curve and the views of a section ask of its pace: derivatives by the share of the way
//! on a grid, and what the limits make of them.

use glam::{DQuat, DVec3};

use crate::error::{Error, Invalid, Result, vec_with_room};
use crate::math::quaternion::{continue_sign, log};
use crate::path::section_sampler::{Along, SectionSampler};
use crate::path::{CameraPath, Target, Timeline};
use crate::tools::check::{FindingKind, Limits, OFF};

/// Limits for one second, in units of `half_size`, radians and millimetres; infinite: none.
#[derive(Debug, Clone, Copy)]
pub(super) struct Bounds {
    pub speed: f64,
    pub acceleration: f64,
    pub jerk: f64,
    pub turning: f64,
    pub turning_acceleration: f64,
    pub zoom: f64,
    /// Least seconds in which a thing crosses the picture; 0: none.
    pub crossing: f64,
}

/// The limits that a pace is planned by.
const KINDS: [FindingKind; 7] = [
    FindingKind::Speed,
    FindingKind::Acceleration,
    FindingKind::Jerk,
    FindingKind::Turning,
    FindingKind::TurningAcceleration,
    FindingKind::Zoom,
    FindingKind::Crossing,
];

impl Bounds {
    /// Those of a check.
    ///
    /// # Errors
    /// [`Error::Argument`] for a limit of 0, or without any limit.
    pub(super) fn new(limits: &Limits) -> Result<Self> {
        for kind in KINDS {
            if !(limits.get(kind) > 0.0) {
                return Err(Invalid::PaceLimit(kind.name()).into());
            }
        }
        if KINDS.iter().all(|kind| limits.get(*kind) == OFF) {
            return Err(Invalid::NoPaceLimit.into());
        }
        let [
            speed,
            acceleration,
            jerk,
            turning,
            turning_acceleration,
            zoom,
            crossing,
        ] = KINDS.map(|kind| limits.get(kind));
        Ok(Self {
            speed,
            acceleration,
            jerk,
            turning: turning.to_radians(),
            turning_acceleration: turning_acceleration.to_radians(),
            zoom,
            crossing: if crossing == OFF { 0.0 } else { crossing },
        })
    }

    /// Those of a pace `slower` times as slow: as this one's time stretched by it.
    pub(super) fn stretched(&self, slower: f64) -> Self {
        Self {
            speed: self.speed / slower,
            acceleration: self.acceleration / slower.powi(2),
            jerk: self.jerk / slower.powi(3),
            turning: self.turning / slower,
            turning_acceleration: self.turning_acceleration / slower.powi(2),
            zoom: self.zoom / slower,
            crossing: self.crossing * slower,
        }
    }

    /// Less of the limits of rates and of changes by these shares, for what keys do not follow.
    pub(super) fn with_margin(&self, [rates, changes]: [f64; 2]) -> Self {
        let (rates, changes) = (1.0 - rates, 1.0 - changes);
        Self {
            speed: self.speed * rates,
            acceleration: self.acceleration * changes,
            jerk: self.jerk * changes,
            turning: self.turning * rates,
            turning_acceleration: self.turning_acceleration * changes,
            zoom: self.zoom * rates,
            crossing: self.crossing / rates,
        }
    }

    /// The greatest dφ/dt at a place, and the limit that makes it so.
    pub(super) fn rate(&self, at: &Ask) -> (f64, FindingKind) {
        let way = at.tangent.length();
        let mut least = (f64::INFINITY, FindingKind::Speed);
        for (rate, kind) in [
            (self.speed / way, FindingKind::Speed),
            (
                (self.acceleration / at.bend.length()).sqrt(),
                FindingKind::Acceleration,
            ),
            (self.turning / at.turn.length(), FindingKind::Turning),
            (self.zoom / at.zoom, FindingKind::Zoom),
            (1.0 / (self.crossing * at.crossing), FindingKind::Crossing),
        ] {
            if rate < least.0 {
                least = (rate, kind);
            }
        }
        least
    }
}

/// Derivatives by φ at a place: way by `half_size`, turning in radians, zoom in mm, and how many
/// widths of the picture what is seen moves across it.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Ask {
    pub tangent: DVec3,
    pub bend: DVec3,
    pub turn: DVec3,
    pub twist: DVec3,
    pub zoom: f64,
    pub crossing: f64,
}

impl Ask {
    /// On the parabola through three of them, x of the way from the first to the last.
    fn between([from, middle, to]: [&Self; 3], x: f64) -> Self {
        let weights = [
            (2.0 * x - 1.0) * (x - 1.0),
            4.0 * x * (1.0 - x),
            x * (2.0 * x - 1.0),
        ];
        let number = |f: fn(&Self) -> f64| {
            (weights[0] * f(from) + weights[1] * f(middle) + weights[2] * f(to)).max(0.0)
        };
        let vector = |f: fn(&Self) -> DVec3| {
            weights[0] * f(from) + weights[1] * f(middle) + weights[2] * f(to)
        };
        Self {
            tangent: vector(|ask| ask.tangent),
            bend: vector(|ask| ask.bend),
            turn: vector(|ask| ask.turn),
            twist: vector(|ask| ask.twist),
            zoom: number(|ask| ask.zoom),
            crossing: number(|ask| ask.crossing),
        }
    }
}

/// One section that moves.
#[derive(Debug)]
pub(super) struct Course {
    /// Its number in the timeline, and the point and orientation with which it begins.
    pub section: usize,
    pub point: usize,
    pub orientation: usize,
    /// Whether the camera rests before it.
    pub rests: bool,
    pub frames: usize,
    /// dφ/du at both ends as it is.
    pub slopes: [f64; 2],
    pub curve_time: f64,
    /// At `2 * cells + 1` even shares.
    asks: Vec<Ask>,
}

impl Course {
    pub(super) fn new(
        path: &CameraPath,
        timeline: &Timeline,
        sampler: &SectionSampler,
        cells: usize,
    ) -> Result<Self> {
        let (number, frames) = sampler.number_and_frames();
        let section = timeline.section(number);
        let from = &path.points[section.point].orientations[section.orientation];
        let mut asks = measured(path, from.target, sampler, cells)?;
        let mut cells = cells;
        while cells < MOST_CELLS && asks.windows(3).step_by(2).any(is_coarse) {
            cells *= 2;
            asks = measured(path, from.target, sampler, cells)?;
        }
        sharpened(&mut asks, path.space.half_size, sampler)?;
        Ok(Self {
            section: number,
            point: section.point,
            orientation: section.orientation,
            rests: from.hold > 0,
            frames,
            slopes: sampler.end_slopes(),
            curve_time: section.duration(),
            asks,
        })
    }

    pub(super) fn cells(&self) -> usize {
        self.asks.len() / 2
    }

    pub(super) fn node(&self, node: usize) -> &Ask {
        &self.asks[2 * node]
    }

    pub(super) fn middle(&self, cell: usize) -> &Ask {
        &self.asks[2 * cell + 1]
    }

    pub(super) fn end(&self) -> &Ask {
        &self.asks[self.asks.len() - 1]
    }

    /// At any share φ.
    pub(super) fn at(&self, phi: f64) -> Ask {
        let cells = self.cells();
        let x = (phi * cells as f64).clamp(0.0, cells as f64);
        let k = (x as usize).min(cells - 1);
        let [from, middle, to] = [0, 1, 2].map(|next| &self.asks[2 * k + next]);
        Ask::between([from, middle, to], x - k as f64)
    }

    /// An error of this section.
    pub(super) fn refused(&self, share: f64, kind: FindingKind) -> Error {
        Invalid::PaceRests {
            point: self.point,
            orientation: self.orientation,
            share,
            limit: kind.name(),
        }
        .into()
    }
}

/// Cells of a section at most, where a view or a curve turns sharply.
const MOST_CELLS: usize = 1024;

/// Whether a grid misses what is between two of its nodes.
fn is_coarse(asks: &[Ask]) -> bool {
    let [from, middle, to] = asks else {
        return false;
    };
    let misses = |f: fn(&Ask) -> DVec3, least: f64| {
        let (a, b) = (f(from), f(to));
        let off = (f(middle) - 0.5 * (a + b)).length();
        off > 0.03 * (a.length() + b.length()) * 0.5 + least
    };
    let way = from.tangent.length();
    misses(|ask| ask.bend, 0.05 * way) || misses(|ask| ask.turn, 0.02)
}

/// Places at which what is still coarse is looked at.
const WITHIN: usize = 16;

/// Where a cell is as narrow as can be and still coarse, its bend is everywhere as great as
/// anywhere in it.
fn sharpened(asks: &mut [Ask], half: f64, sampler: &SectionSampler) -> Result<()> {
    let cells = asks.len() / 2;
    for cell in 0..cells {
        let here = &mut asks[2 * cell..2 * cell + 3];
        if !is_coarse(here) {
            continue;
        }
        let share = |k: usize| (cell as f64 + k as f64 / WITHIN as f64) / cells as f64;
        let shares: [f64; WITHIN] = std::array::from_fn(share);
        let mut most = 0.0_f64;
        sampler.along(&shares, &mut |along| {
            most = most.max(along.bend.length() / half)
        })?;
        for ask in here {
            let bend = ask.bend.length();
            if bend > 0.0 && bend < most {
                ask.bend *= most / bend;
            }
        }
    }
    Ok(())
}

/// Derivatives at the nodes of a number of cells and between them.
fn measured(
    path: &CameraPath,
    target: Target,
    sampler: &SectionSampler,
    cells: usize,
) -> Result<Vec<Ask>> {
    let half = path.space.half_size;
    let count = 2 * cells + 1;
    let step = 1.0 / (count - 1) as f64;
    let mut shares = vec_with_room(count)?;
    shares.extend((0..count).map(|k| if k + 1 == count { 1.0 } else { k as f64 * step }));
    let mut all: Vec<Along> = vec_with_room(count)?;
    sampler.along(&shares, &mut |along| all.push(along))?;
    let mut turned: Vec<DVec3> = vec_with_room(count)?;
    let mut last = all[0].turn;
    for along in &mut all[1..] {
        along.turn = continue_sign(last, along.turn).0;
        turned.push(2.0 * log(along.turn * last.conjugate()) / step);
        last = along.turn;
    }
    // Rounding turns nothing.
    if turned.iter().all(|turn| turn.length() < 1e-6) {
        turned.fill(DVec3::ZERO);
    }
    let mut asks: Vec<Ask> = vec_with_room(count)?;
    for (k, along) in all.iter().enumerate() {
        // A cusp between two places turns the way as much as it does from the one to the other.
        let mean = if k == 0 || k + 1 == count {
            DVec3::ZERO
        } else {
            (all[k + 1].tangent - all[k - 1].tangent) / (2.0 * step)
        };
        let bend = if along.bend.length() < mean.length() {
            mean
        } else {
            along.bend
        };
        // Turns of the halves beside it; at an end that of the two next to it.
        let near = k.clamp(1, count - 2);
        let (before, after) = (turned[near - 1], turned[near]);
        let twist = (after - before) / step;
        let turn = 0.5 * (before + after) + twist * ((k as f64 - near as f64) * step);
        let depth = path.depth(Some(target), along.place);
        // What is seen goes along with the view; across the picture it moves the other way.
        let sideways = along.tangent + turn.cross(along.view * depth);
        let sideways = sideways.reject_from_normalized(along.view).length();
        let width = 36.0 / along.zoom * depth;
        asks.push(Ask {
            tangent: along.tangent / half,
            bend: bend / half,
            turn,
            twist,
            zoom: along.zoom_slope.abs(),
            // At the thing itself there is no picture of it.
            crossing: if width > 1e-9 * half && sideways > 1e-9 * width {
                sideways / width
            } else {
                0.0
            },
        });
    }
    Ok(asks)
}

/// The turn of one quaternion to another.
pub(super) fn turned(a: DQuat, b: DQuat) -> DVec3 {
    2.0 * log(continue_sign(a, b).0 * a.conjugate())
}
