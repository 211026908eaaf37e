//! One section that has frames, prepared once for whatever is asked of it: poses, many at a time by
//! [`super::fill`], its motion by [`super::motion`], and derivatives along its way.

use std::sync::OnceLock;
use std::sync::atomic::AtomicBool;

use glam::{DQuat, DVec3};

use super::arc_length::{Piece, invert};
use super::hermite::{Cubic, end_direction};
use super::pose::Pose;
use super::space::Space;
use super::tables::{Tables, build_widest};
use super::timing::Timing;
use super::turning::Turning;
use crate::error::Result;
use crate::math::monotone_cubic::{slope, value};
use crate::math::orientation::quaternion_from_view;
use crate::math::vector;

/// What a section has at a share φ of its way: derivatives are by φ.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Along {
    pub place: DVec3,
    pub tangent: DVec3,
    /// Second derivative of the place; it is perpendicular to the tangent.
    pub bend: DVec3,
    pub view: DVec3,
    pub turn: DQuat,
    pub zoom: f64,
    pub zoom_slope: f64,
}

#[derive(Debug, Clone, Copy)]
pub(super) struct ArcLengthCurve {
    pub curve: Cubic,
    pub length: f64,
}

impl ArcLengthCurve {
    /// The curve's parameter at a share φ of the way; `pieces` are its own.
    pub(super) fn parameter(&self, pieces: &[Piece], phi: f64) -> f64 {
        if !(phi > 0.0) || pieces.is_empty() {
            return 0.0;
        }
        if phi >= 1.0 {
            return 1.0;
        }
        let mut t = [0.0];
        invert::<f64>(pieces, &[phi * self.length], &mut t);
        t[0].clamp(0.0, 1.0)
    }
}

#[derive(Debug)]
pub(crate) struct SectionSampler {
    /// Its number in the timeline.
    pub(super) section: usize,
    /// Number of the last pose before its own: the key in which it begins.
    pub(super) start: usize,
    /// Its frames, ≥ 1; the last one is the key in which it ends.
    pub(super) frames: usize,
    /// None where the speed is constant.
    pub(super) speed: Option<Box<[Timing]>>,
    /// Where the camera moves; None where it stays at `position`.
    pub(super) way: Option<ArcLengthCurve>,
    pub(super) position: DVec3,
    /// In the y-up axes of `space`.
    pub(super) turning: Turning,
    /// The path's; where a target is tracked its `up` is what the roll is measured against.
    pub(super) space: Space,
    /// Zoom in powers of φ.
    pub(super) zoom: [f64; 4],
    /// What fast sampling prepares once, if the section has many frames or is filled again.
    pub(super) tables: OnceLock<Box<[Tables]>>,
    /// Whether it has been filled before.
    pub(super) filled: AtomicBool,
}

impl SectionSampler {
    /// The same for sections with the same poses, wherever in the path.
    pub(super) fn fingerprint(&self) -> u64 {
        let mut fingerprint = Fingerprint::default();
        fingerprint.add([self.frames as f64]);
        if let Some(speed) = &self.speed {
            speed[0].each_number(&mut |numbers| fingerprint.add(numbers));
        }
        match &self.way {
            None => fingerprint.add(self.position.to_array()),
            Some(ArcLengthCurve { curve, length }) => {
                fingerprint.add([*length]);
                let all = [curve.a, curve.b, curve.c, curve.d, curve.end];
                all.into_iter().for_each(|v| fingerprint.add(v.to_array()));
            }
        }
        let quaternions = |fingerprint: &mut Fingerprint, all: &[DQuat]| {
            all.iter().for_each(|q| fingerprint.add(q.to_array()));
        };
        match &self.turning {
            Turning::Bezier(control) => {
                fingerprint.add([1.0]);
                quaternions(&mut fingerprint, control);
            }
            Turning::Part(control, ends) => {
                fingerprint.add([6.0]);
                quaternions(&mut fingerprint, control);
                fingerprint.add(*ends);
            }
            Turning::Arc(ends) => {
                fingerprint.add([2.0]);
                quaternions(&mut fingerprint, ends);
            }
            Turning::BarryGoldman(keys, knots) => {
                fingerprint.add([3.0]);
                quaternions(&mut fingerprint, keys);
                fingerprint.add(*knots);
            }
            Turning::Kept(view, up) => {
                fingerprint.add([4.0]);
                fingerprint.add(view.to_array());
                fingerprint.add(up.to_array());
            }
            Turning::Follow(follow) => {
                fingerprint.add([7.0]);
                fingerprint.add(follow.roll);
                // What is seen, wherever it turns.
                for k in 0..=8 {
                    let (view, up) = follow.view_at(f64::from(k) / 8.0);
                    fingerprint.add(view.to_array());
                    fingerprint.add(up.to_array());
                }
            }
            Turning::Tracked(target, roll) => {
                fingerprint.add([5.0]);
                fingerprint.add(target.to_array());
                fingerprint.add(*roll);
            }
        }
        fingerprint.add(self.zoom);
        fingerprint.add([self.space.up.index() as f64, self.space.half_size]);
        fingerprint.0
    }

    /// Has the processor fetch what it keeps, all at once instead of one after the other.
    pub(super) fn fetch(&self) {
        vector::fetch(std::slice::from_ref(self));
        if let Some(tables) = self.tables.get() {
            tables[0].fetch();
        }
    }

    /// Has the processor fetch the second next section and what the next ones keep, while the one
    /// before them is filled: many sections are more than the caches hold. Of the second next it is
    /// what tells where its tables are, of the next one, where that is there by then, the tables
    /// themselves.
    pub(super) fn fetch_next(next: &[Self]) {
        vector::fetch(next.get(1..2).unwrap_or_default());
        let kept = |at: usize| next.get(at)?.tables.get();
        if let Some(tables) = kept(1) {
            vector::fetch(tables);
        }
        if let Some(tables) = kept(0) {
            tables[0].fetch();
        }
    }

    /// φ at `u` = frame / frames: share of the way and of the curve time.
    pub(super) fn phi(&self, u: f64) -> f64 {
        self.speed.as_ref().map_or(u, |speed| speed[0].fraction(u))
    }

    /// Derivative of the zoom by φ.
    pub(super) fn zoom_slope(&self, phi: f64) -> f64 {
        slope(&self.zoom, phi)
    }

    /// Roll at φ of a tracked section in radians, and its derivative; else zeros.
    pub(super) fn turning_slope(&self, phi: f64) -> (f64, f64) {
        match &self.turning {
            Turning::Tracked(_, roll) => (value(roll, phi), slope(roll, phi)),
            Turning::Follow(follow) => (value(&follow.roll, phi), slope(&follow.roll, phi)),
            _ => (0.0, 0.0),
        }
    }

    /// Its number in the timeline and its frames.
    pub(crate) const fn number_and_frames(&self) -> (usize, usize) {
        (self.section, self.frames)
    }

    /// Derivative of the share of the way by the share of the time, at the beginning and the end.
    pub(crate) fn end_slopes(&self) -> [f64; 2] {
        [0.0, 1.0].map(|u| self.speed.as_ref().map_or(1.0, |speed| speed[0].slope(u)))
    }

    /// What it needs to be sampled; kept from now on.
    pub(super) fn prepared(&self) -> Result<&Tables> {
        if let Some(tables) = self.tables.get() {
            return Ok(&tables[0]);
        }
        let mut tables = Tables::default();
        build_widest(&mut tables, self)?;
        self.keep(&tables)
    }

    /// Keeps a copy of its tables.
    pub(super) fn keep(&self, tables: &Tables) -> Result<&Tables> {
        let kept = tables.kept()?;
        Ok(&self.tables.get_or_init(|| kept)[0])
    }

    /// What changes at some shares φ of the way and of the curve time.
    pub(crate) fn along(&self, shares: &[f64], see: &mut dyn FnMut(Along)) -> Result<()> {
        let pieces = &self.prepared()?.arc;
        let place = |phi: f64| self.place(pieces, phi);
        let up = self.space.up;
        for &phi in shares {
            let (view, level) = self.turning.view_at(phi, &place, self.space);
            let (view, level) = (up.world(view), up.world(level));
            let (mut tangent, mut bend) = (DVec3::ZERO, DVec3::ZERO);
            if let Some(way) = &self.way {
                let (curve, length) = (&way.curve, way.length);
                let t = way.parameter(pieces, phi);
                let (first, second) = (curve.derivative(t), curve.second_derivative(t));
                let speed = first.length();
                let direction = end_direction(curve, phi > 0.5);
                let direction = if speed > 1e-9 * length {
                    first / speed
                } else {
                    direction.unwrap_or(DVec3::X)
                };
                tangent = direction * length;
                let across = second - direction * direction.dot(second);
                // A straight curve may stop and go on; any other has a kink where it stops.
                let straight = across.length() <= 1e-9 * second.length();
                bend = if straight {
                    DVec3::ZERO
                } else {
                    across * (length / speed).powi(2)
                };
            }
            see(Along {
                place: place(phi),
                tangent,
                bend,
                view,
                turn: quaternion_from_view(view, level),
                zoom: value(&self.zoom, phi),
                zoom_slope: self.zoom_slope(phi),
            });
        }
        Ok(())
    }

    pub(super) fn place(&self, pieces: &[Piece], phi: f64) -> DVec3 {
        self.way.as_ref().map_or(self.position, |way| {
            way.curve.point(way.parameter(pieces, phi))
        })
    }

    /// The pose at φ where there is no polynomial for it: the view follows the way, or has no
    /// direction.
    pub(super) fn pose(&self, tables: &Tables, phi: f64) -> Pose {
        let place = |phi: f64| self.place(&tables.arc, phi);
        let (view, up) = self.turning.view_at(phi, &place, self.space);
        let (view, up) = (self.space.up.world(view), self.space.up.world(up));
        Pose {
            vrp: place(phi).to_array(),
            vpn: view.to_array(),
            vup: up.to_array(),
            zoom: value(&self.zoom, phi),
        }
    }
}

/// A fingerprint of numbers, by their bits and their order.
#[derive(Default)]
struct Fingerprint(u64);

impl Fingerprint {
    fn add<const N: usize>(&mut self, numbers: [f64; N]) {
        for number in numbers {
            // Both halves of the product: every bit reaches every other. The digits are those of π.
            let word = self.0.rotate_left(29) ^ number.to_bits() ^ 0x2438_6A88_85A3_08D3;
            let product = u128::from(word) * 0x1319_8A2E_0370_7345;
            self.0 = (product as u64) ^ ((product >> 64) as u64);
        }
    }
}
