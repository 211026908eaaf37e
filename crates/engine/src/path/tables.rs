//! What a section needs to be sampled fast: its arc length, and where it has many frames
//! polynomials of degree 15 in φ for the curve's parameter and the turning. A polynomial is fitted
//! only where it serves more frames than it costs; elsewhere frames are computed one by one.

use super::arc_length::{self, Halving, Piece};
use super::arcs::ShortBezier;
use super::dispatch::widest;
use super::section_sampler::{ArcLengthCurve, SectionSampler};
use super::turning::Turning;
use crate::error::{Result, try_box, vec_with_room};
use crate::math::chebyshev::{self, NODES, SHORT};
use crate::math::vector::{self, Number, Vector, fetch, horner_each};

/// Frames that a fitted piece must serve: about what its nodes cost.
const WORTH: f64 = 32.0;

/// The same for the curve's parameter, whose nodes cost as much as frames computed one by one.
const WORTH_PLACE: f64 = 10.0;

/// Share of the length that a fitted parameter may be wrong by.
const PLACE_TOLERANCE: f64 = 2e-15;

/// What a component of a fitted quaternion may be wrong by.
const TURN_TOLERANCE: f64 = 4e-15;

/// Frames of half a piece that is worth halving so that [`SHORT`] powers are enough: each frame of
/// a long section costs a quarter less, and the pieces little, since they are few.
const LONG: f64 = 512.0;

/// Powers of x on a piece of φ, or None where frames are computed directly.
#[derive(Debug, Clone, Copy)]
pub(super) struct Fit<const COMPONENTS: usize> {
    /// φ at which the piece ends.
    pub end: f64,
    middle: f64,
    scale: f64,
    /// The piece of the arc length whose Newton's step the value still needs.
    pub polish: Option<usize>,
    short: bool,
    pub powers: Option<[[f64; NODES]; COMPONENTS]>,
}

impl<const COMPONENTS: usize> Fit<COMPONENTS> {
    /// x in [−1, 1] at φ.
    #[inline(always)]
    pub(super) fn x<V: Number>(&self, phi: V) -> V {
        phi.sub(V::splat(self.middle)).mul(V::splat(self.scale))
    }

    /// The polynomial with these of its `powers` at several x.
    #[inline(always)]
    pub(super) fn at<V: Number, const U: usize>(
        &self,
        powers: &[f64; NODES],
        x: &[V; U],
    ) -> [V; U] {
        match powers.first_chunk::<SHORT>() {
            Some(powers) if self.short => horner_each(powers, x),
            _ => horner_each(powers, x),
        }
    }
}

#[derive(Debug, Default)]
pub(super) struct Tables {
    pub arc: Vec<Piece>,
    pub place: Vec<Fit<1>>,
    pub turn: Vec<Fit<4>>,
    pub bezier: Option<ShortBezier>,
}

widest! {
    pub(super) fn build_widest = self::build;
    (tables: &mut Tables, section: &SectionSampler) -> Result<()>
}

#[inline(always)]
fn build<V: Vector>(tables: &mut Tables, section: &SectionSampler) -> Result<()> {
    tables.build::<V>(section)
}

impl Tables {
    /// Prepares a section, reusing the memory of these tables.
    #[inline(always)]
    pub(super) fn build<V: Vector>(&mut self, section: &SectionSampler) -> Result<()> {
        self.arc.clear();
        self.place.clear();
        self.turn.clear();
        self.bezier = match &section.turning {
            Turning::Bezier(control) => ShortBezier::new::<V>(control),
            _ => None,
        };
        #[allow(clippy::cast_precision_loss)]
        let frames = section.frames as f64;
        if let Some(way) = &section.way {
            arc_length::measure::<V>(&way.curve, Some(&mut self.arc))?;
            self.fit_place::<V>(way, frames)?;
        }
        if section.turning.is_quaternion() {
            self.fit_turning::<V>(&section.turning, frames)?;
        }
        Ok(())
    }

    /// A copy in as little memory as it takes, all of it allocated in one go: on a path of many
    /// sections the next one's tables lie behind, where the processor has begun to fetch them.
    pub(super) fn kept(&self) -> Result<Box<[Self]>> {
        fn copy<T: Copy>(from: &[T]) -> Result<Vec<T>> {
            let mut copy = vec_with_room(from.len())?;
            copy.extend_from_slice(from);
            Ok(copy)
        }
        try_box(Self {
            arc: copy(&self.arc)?,
            place: copy(&self.place)?,
            turn: copy(&self.turn)?,
            bezier: self.bezier,
        })
    }

    pub(super) fn fetch(&self) {
        fetch(&self.arc);
        fetch(&self.place);
        fetch(&self.turn);
    }

    /// The inverse of the arc length is as smooth as the arc length, so its pieces are tried first.
    #[inline(always)]
    fn fit_place<V: Vector>(&mut self, way: &ArcLengthCurve, frames: f64) -> Result<()> {
        let (least, coarse) = (0.5 * WORTH_PLACE / frames, WORTH / frames);
        for index in 0..self.arc.len() {
            let start = self.arc[index].start_share(way.length);
            let end = match self.arc.get(index + 1) {
                Some(next) => next.start_share(way.length),
                None => 1.0,
            };
            let mut halving = Halving::new(start, end, least);
            while let Some((middle, half)) = halving.next() {
                let (mut powers, mut polish) = (None, None);
                if half >= least {
                    let (fit, tail, error) = self.fit_parameter::<V>(way, middle, half);
                    let piece = &self.arc[index];
                    if !short(&fit) && half > LONG / frames && halving.halve(half) {
                        continue;
                    }
                    if error <= PLACE_TOLERANCE * way.length {
                        powers = Some(fit);
                    } else if half < coarse && piece.settles(tail) {
                        (powers, polish) = (Some(fit), Some(index));
                    } else if halving.halve(half) {
                        continue;
                    }
                }
                push(&mut self.place, middle, half, powers, polish)?;
            }
        }
        // Rounding of the pieces' ends must not leave the last frame outside.
        if let Some(last) = self.place.last_mut() {
            last.end = 1.0;
        }
        Ok(())
    }

    /// The curve's parameter on a piece of φ as a polynomial, its error, and that as a length.
    #[inline(always)]
    fn fit_parameter<V: Vector>(
        &self,
        way: &ArcLengthCurve,
        middle: f64,
        half: f64,
    ) -> ([[f64; NODES]; 1], f64, f64) {
        let (mut s, mut t) = ([0.0; NODES], [0.0; NODES]);
        for k in 0..NODES {
            s[k] = (middle + half * chebyshev::POINTS[k]) * way.length;
        }
        arc_length::invert::<V>(&self.arc, &s, &mut t);
        let mut series = chebyshev::series::<V>(&t);
        let mut fastest = 0.0f64;
        for t in t {
            fastest = fastest.max(way.curve.derivative(t).length());
        }
        let tail = chebyshev::tail(&series);
        chebyshev::shorten(&mut series, 0.5 * PLACE_TOLERANCE * way.length / fastest);
        ([chebyshev::powers::<V>(&series)], tail, tail * fastest)
    }

    #[inline(always)]
    fn fit_turning<V: Vector>(&mut self, turning: &Turning, frames: f64) -> Result<()> {
        let least = 0.5 * WORTH / frames;
        let mut halving = Halving::new(0.0, 1.0, least);
        while let Some((middle, half)) = halving.next() {
            let mut powers = None;
            if half >= least {
                let mut phi = [0.0; NODES];
                for k in 0..NODES {
                    phi[k] = middle + half * chebyshev::POINTS[k];
                }
                let mut values = [[0.0; NODES]; 4];
                quaternions::<V, NODES>(turning, self.bezier.as_ref(), &phi, &mut values);
                let mut fitted = [[0.0; NODES]; 4];
                let mut tail = 0.0f64;
                for k in 0..4 {
                    let mut series = chebyshev::series::<V>(&values[k]);
                    tail = tail.max(chebyshev::tail(&series));
                    chebyshev::shorten(&mut series, TURN_TOLERANCE / 4.0);
                    fitted[k] = chebyshev::powers::<V>(&series);
                }
                let good = tail <= TURN_TOLERANCE;
                let enough = good && (half <= LONG / frames || short(&fitted));
                if !enough && halving.halve(half) {
                    continue;
                }
                powers = good.then_some(fitted);
            }
            push(&mut self.turn, middle, half, powers, None)?;
        }
        Ok(())
    }
}

/// Quaternions at N values of φ, component by component.
#[inline(always)]
pub(super) fn quaternions<V: Vector, const N: usize>(
    turning: &Turning,
    bezier: Option<&ShortBezier>,
    phi: &[f64; N],
    q: &mut [[f64; N]; 4],
) {
    if let Some(bezier) = bezier {
        for k in (0..N).step_by(V::LANES) {
            let value = bezier.at(V::load(&phi[k..]));
            for component in 0..4 {
                value[component].store(&mut q[component][k..]);
            }
        }
        return;
    }
    for k in 0..N {
        if let Some(value) = turning.quaternion(phi[k]) {
            for (component, value) in value.to_array().into_iter().enumerate() {
                q[component][k] = value;
            }
        }
    }
}

/// Whether the first [`SHORT`] powers of each polynomial are all.
fn short<const C: usize>(powers: &[[f64; NODES]; C]) -> bool {
    let nothing = |powers: &[f64; NODES]| powers[SHORT..].iter().all(|power| *power == 0.0);
    powers.iter().all(nothing)
}

fn push<const C: usize>(
    fits: &mut Vec<Fit<C>>,
    middle: f64,
    half: f64,
    powers: Option<[[f64; NODES]; C]>,
    polish: Option<usize>,
) -> Result<()> {
    // Direct pieces side by side are one.
    if let (None, Some(last)) = (&powers, fits.last_mut())
        && last.powers.is_none()
    {
        last.end = middle + half;
        return Ok(());
    }
    fits.try_reserve(1)?;
    fits.push(Fit {
        end: middle + half,
        middle,
        scale: 1.0 / half,
        polish,
        short: powers.as_ref().is_some_and(short),
        powers,
    });
    Ok(())
}
