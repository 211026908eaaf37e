//! Arc length of a cubic and its inverse (thesis 5.1).
//!
//! |P′(t)| is fitted at 16 Chebyshev nodes over pieces that are halved until the fit is exact to
//! rounding, then integrated term by term. Cusps and reversals only need more pieces: where the
//! speed has a kink, a piece's part of the length shrinks with the square of its width.

use glam::DVec3;

use super::hermite::Cubic;
use crate::error::Result;
use crate::math::chebyshev::{self, NODES};
use crate::math::vector::{Vector, each, horner, horner_each};

/// Error allowed to a piece, as a share of the whole length.
const TOLERANCE: f64 = 4e-15;

/// Halvings at the most: beyond, a piece is narrower than the rounding of t.
const MAX_HALVINGS: u32 = 50;

/// Half the width of a piece that is not halved any more.
const NARROW: f64 = f64::EPSILON / 4.0;

/// A piece whose speeds differ by more than this factor is searched: Newton's steps could leave it.
const EVEN: f64 = 4.0;

/// A Newton step below this is the last: on an even piece the error left is about its square.
const SETTLED: f64 = 1e-8;

/// Error of x of a good guess, that one of Newton's steps takes below rounding.
const POLISHED: f64 = 1e-9;

/// Vectors inverted side by side: as many as keep the processor busy while each step waits for the
/// one before it.
const BESIDE: usize = 4;

/// Room for the lanes of as many of any vectors.
const MAX_LANES: usize = 16;

/// A piece of the curve with its length as a polynomial in x ∈ [−1, 1].
#[derive(Debug, Clone, Copy)]
pub(super) struct Piece {
    middle: f64,
    half: f64,
    start: f64,
    length: f64,
    /// ds/dx in powers of x.
    speed: [f64; NODES],
    /// s − start in powers of x.
    distance: [f64; NODES + 1],
    /// First guess of x in powers of (s − start)/length.
    guess: [f64; 6],
    even: bool,
}

/// ds/dx at the nodes of the piece [`middle − half`, `middle + half`].
#[inline(always)]
fn speeds<V: Vector>(curve: &Cubic, middle: f64, half: f64) -> [f64; NODES] {
    let (a, b, c) = (3.0 * curve.a, 2.0 * curve.b, curve.c);
    let mut speeds = [0.0; NODES];
    for j in (0..NODES).step_by(V::LANES) {
        let t = V::splat(half).mul_add(V::load(&chebyshev::POINTS[j..]), V::splat(middle));
        let x = horner(&[c.x, b.x, a.x], t);
        let y = horner(&[c.y, b.y, a.y], t);
        let z = horner(&[c.z, b.z, a.z], t);
        let square = x.mul_add(x, y.mul_add(y, z.mul(z)));
        square.sqrt().mul(V::splat(half)).store(&mut speeds[j..]);
    }
    speeds
}

/// A fit that misses the speed at a piece's end by more than this, as a share of the whole length,
/// has missed a reversal between the end and the node next to it: no node sees such a kink, and the
/// last coefficients are small. A miss by δ makes the length wrong by δ·ε/2, where ε, at most
/// 0.005, lies between kink and end; so this is enough for [`TOLERANCE`], and far above rounding.
const END_TOLERANCE: f64 = 1e-12;

/// Whether the fit of a piece is exact to rounding: its last coefficients, and both ends.
#[inline(always)]
fn fits(curve: &Cubic, middle: f64, half: f64, series: &[f64; NODES], tolerance: f64) -> bool {
    if chebyshev::tail(series) > tolerance {
        return false;
    }
    let (mut even, mut odd) = (0.0, 0.0);
    for pair in series.chunks_exact(2) {
        even += pair[0];
        odd += pair[1];
    }
    let missed = |t: f64, fitted: f64| {
        let derivative = (3.0 * curve.a * t + 2.0 * curve.b) * t + curve.c;
        (derivative.length() * half - fitted).abs()
    };
    let allowed = tolerance * (END_TOLERANCE / TOLERANCE);
    missed(middle - half, even - odd) <= allowed && missed(middle + half, even + odd) <= allowed
}

/// ∫ over [−1, 1] of a Chebyshev series: of its even polynomials.
#[inline(always)]
#[allow(clippy::cast_precision_loss)]
fn integral(series: &[f64; NODES]) -> f64 {
    let mut sum = 0.0;
    for k in (0..NODES).step_by(2).rev() {
        sum += series[k] * (2.0 / (1.0 - (k * k) as f64));
    }
    sum
}

/// Pieces of an interval that are halved until each is good enough, one after the other.
pub(super) struct Halving {
    start: f64,
    half: f64,
    /// Half the width of the narrowest piece.
    least: f64,
    /// Which of how often halved pieces is looked at, and which one follows.
    here: (u64, u32),
    following: (u64, u32),
}

impl Halving {
    #[inline(always)]
    pub(super) fn new(start: f64, end: f64, least: f64) -> Self {
        Self {
            start,
            half: 0.5 * (end - start),
            least,
            here: (0, 0),
            following: (0, 0),
        }
    }

    /// Middle and half width of the next piece.
    #[inline(always)]
    #[allow(clippy::cast_precision_loss)]
    pub(super) fn next(&mut self) -> Option<(f64, f64)> {
        let (piece, halvings) = self.following;
        if piece >> halvings != 0 {
            return None;
        }
        self.here = self.following;
        // Behind a right half the piece follows that lies beside both halves.
        let up = (piece + 1).trailing_zeros().min(halvings);
        self.following = ((piece + 1) >> up, halvings - up);
        let half = self.half * f64::from_bits(u64::from(1023 - halvings) << 52);
        Some((self.start + (2 * piece + 1) as f64 * half, half))
    }

    /// Goes on with the two halves of the piece; false where they are too narrow.
    #[inline(always)]
    pub(super) fn halve(&mut self, half: f64) -> bool {
        let (piece, halvings) = self.here;
        let wide = half / 2.0 >= self.least && halvings < MAX_HALVINGS;
        if wide {
            self.following = (2 * piece, halvings + 1);
        }
        wide
    }
}

/// A curve whose derivative is below this everywhere is enlarged before it is measured: the square
/// of its speed would lose digits, and the halving go on to the narrowest piece.
pub(super) const TINY: f64 = 1e-120;

/// By 2⁶⁰⁰, which is exact and brings the least number to 1e-143, whose square is still normal.
const ENLARGED: f64 = f64::from_bits((1023 + 600) << 52);

/// The curve enlarged, if it is [`TINY`].
#[inline(always)]
fn enlarged(curve: &Cubic) -> Option<Cubic> {
    let size = |v: DVec3| v.abs().max_element();
    let largest = size(curve.a).max(size(curve.b)).max(size(curve.c));
    (largest < TINY && largest > 0.0).then(|| Cubic {
        a: curve.a * ENLARGED,
        b: curve.b * ENLARGED,
        c: curve.c * ENLARGED,
        // Where it lies has nothing to do with its length.
        ..*curve
    })
}

/// The length of a curve, when its inverse is not needed.
#[must_use]
#[inline(always)]
pub(super) fn length<V: Vector>(curve: &Cubic) -> f64 {
    let large = enlarged(curve);
    let scale = if large.is_some() { ENLARGED } else { 1.0 };
    let curve = large.as_ref().unwrap_or(curve);
    // Only pieces take memory.
    measure::<V>(curve, None).unwrap_or_default() / scale
}

/// Measures a curve that is not [`TINY`]: fills `pieces`, where they are wanted, in the order of t
/// and gives the length.
#[inline(always)]
pub(super) fn measure<V: Vector>(
    curve: &Cubic,
    mut pieces: Option<&mut Vec<Piece>>,
) -> Result<f64> {
    let mut halving = Halving::new(0.0, 1.0, NARROW);
    let mut tolerance = -1.0;
    let mut total = 0.0;
    while let Some((middle, half)) = halving.next() {
        let values = speeds::<V>(curve, middle, half);
        let series = chebyshev::series::<V>(&values);
        let length = integral(&series);
        if tolerance < 0.0 {
            if length == 0.0 {
                return Ok(0.0);
            }
            tolerance = TOLERANCE * length;
        }
        if !fits(curve, middle, half, &series, tolerance) && halving.halve(half) {
            continue;
        }
        let start = total;
        total += length;
        let Some(pieces) = &mut pieces else {
            continue;
        };
        let speed = chebyshev::powers::<V>(&series);
        let mut distance = [0.0; NODES + 1];
        for j in 0..NODES {
            #[allow(clippy::cast_precision_loss)]
            let power = (j + 1) as f64;
            distance[j + 1] = speed[j] / power;
        }
        distance[0] = -horner::<f64, { NODES + 1 }>(&distance, -1.0);
        let (mut low, mut high) = (f64::INFINITY, 0.0f64);
        for value in values {
            low = low.min(value);
            high = high.max(value);
        }
        let first = horner::<f64, NODES>(&speed, -1.0);
        let last = horner::<f64, NODES>(&speed, 1.0);
        let even = low.min(first).min(last) * EVEN > high;
        let guess = if even {
            inverse_guess(
                length,
                [first, last],
                [slope(&speed, -1.0), slope(&speed, 1.0)],
            )
        } else {
            [0.0; 6]
        };
        pieces.try_reserve(1)?;
        pieces.push(Piece {
            middle,
            half,
            start,
            length,
            speed,
            distance,
            guess,
            even,
        });
    }
    Ok(total)
}

/// Derivative of a polynomial in powers of x.
#[inline(always)]
#[allow(clippy::cast_precision_loss)]
fn slope(powers: &[f64; NODES], x: f64) -> f64 {
    let mut sum = 0.0;
    for k in (1..NODES).rev() {
        sum = sum * x + k as f64 * powers[k];
    }
    sum
}

/// First guess of x by the share of the length: a quintic with the right derivatives at both ends.
#[inline(always)]
fn inverse_guess(length: f64, speed: [f64; 2], slope: [f64; 2]) -> [f64; 6] {
    let first = |k: usize| length / speed[k];
    let second = |k: usize| -first(k) * first(k) * slope[k] / speed[k];
    let (m0, m1, a0, a1) = (first(0), first(1), second(0), second(1));
    [
        -1.0,
        m0,
        0.5 * a0,
        20.0 - 6.0 * m0 - 4.0 * m1 - 1.5 * a0 + 0.5 * a1,
        -30.0 + 8.0 * m0 + 7.0 * m1 + 1.5 * a0 - a1,
        12.0 - 3.0 * (m0 + m1) + 0.5 * (a1 - a0),
    ]
}

impl Piece {
    pub(super) fn start_share(&self, length: f64) -> f64 {
        self.start / length
    }

    /// Whether one of Newton's steps takes an error of the parameter below rounding.
    pub(super) fn settles(&self, error: f64) -> bool {
        self.even && error <= POLISHED * self.half
    }

    /// x at the length `s` from the piece's start: Newton's method between bounds that close in.
    fn search(&self, s: f64) -> f64 {
        let (mut low, mut high) = (-1.0, 1.0);
        let mut x = (2.0 * s / self.length - 1.0).clamp(low, high);
        for _ in 0..200 {
            let error = horner::<f64, { NODES + 1 }>(&self.distance, x) - s;
            if error == 0.0 {
                break;
            }
            if error > 0.0 {
                high = x;
            } else {
                low = x;
            }
            let slope = horner::<f64, NODES>(&self.speed, x);
            let step = x - error / slope;
            let next = if step > low && step < high {
                step
            } else {
                0.5 * (low + high)
            };
            if next == x || next <= low || next >= high {
                break;
            }
            x = next;
        }
        x
    }
}

/// Writes to `parameters` those of ascending `lengths`. `pieces` must not be empty.
#[inline(always)]
pub(super) fn invert<V: Vector>(pieces: &[Piece], lengths: &[f64], parameters: &mut [f64]) {
    let mut from = 0;
    let mut piece = 0;
    while from < lengths.len() {
        while piece + 1 < pieces.len() && lengths[from] >= pieces[piece + 1].start {
            piece += 1;
        }
        let mut to = lengths.len();
        if piece + 1 < pieces.len() {
            let end = pieces[piece + 1].start;
            to = from + 1;
            while to < lengths.len() && lengths[to] < end {
                to += 1;
            }
        }
        invert_within::<V>(
            &pieces[piece],
            &lengths[from..to],
            &mut parameters[from..to],
        );
        from = to;
    }
}

/// [`invert`] for lengths that all lie in one piece.
#[inline(always)]
fn invert_within<V: Vector>(piece: &Piece, lengths: &[f64], parameters: &mut [f64]) {
    let lanes = BESIDE * V::LANES;
    let mut from = 0;
    while from < lengths.len() {
        let count = lanes.min(lengths.len() - from);
        let mut s = [0.0; MAX_LANES];
        for k in 0..lanes {
            s[k] = lengths[from + k.min(count - 1)] - piece.start;
        }
        let mut x = [0.0; MAX_LANES];
        let mut arrived = [false; MAX_LANES];
        if piece.even {
            newton::<V>(piece, &s, &mut x, &mut arrived);
        }
        for k in 0..count {
            if !arrived[k] {
                x[k] = piece.search(s[k]);
            }
        }
        for k in 0..count {
            parameters[from + k] = piece.middle + piece.half * x[k];
        }
        from += count;
    }
}

/// Newton's steps from a good guess, for vectors whose operations run beside each other;
/// `arrived` gets the lanes that converged. Two steps are the rule, a third serves only the lanes
/// that need it, so that no lane depends on the others.
#[inline(always)]
fn newton<V: Vector>(
    piece: &Piece,
    s: &[f64; MAX_LANES],
    x: &mut [f64; MAX_LANES],
    arrived: &mut [bool; MAX_LANES],
) {
    let scale = V::splat(1.0 / piece.length);
    let s = each!(k in [0, 1, 2, 3] => V::load(&s[k * V::LANES..]));
    let mut at = horner_each(&piece.guess, &each!(k in [0, 1, 2, 3] => s[k].mul(scale)));
    step(piece, &s, &mut at);
    let second = step(piece, &s, &mut at);
    store_all(at, x);
    if settled(second, arrived) {
        return;
    }
    let (mut third_x, mut third_arrived) = ([0.0; MAX_LANES], [false; MAX_LANES]);
    let third = step(piece, &s, &mut at);
    store_all(at, &mut third_x);
    settled(third, &mut third_arrived);
    for k in 0..BESIDE * V::LANES {
        if !arrived[k] {
            (x[k], arrived[k]) = (third_x[k], third_arrived[k]);
        }
    }
}

/// One of Newton's steps, kept within the piece; gives the squares of the changes.
#[inline(always)]
fn step<V: Vector, const U: usize>(piece: &Piece, s: &[V; U], at: &mut [V; U]) -> [V; U] {
    let (low, high) = (V::splat(-1.0), V::splat(1.0));
    let distance = horner_each(&piece.distance, at);
    let speed = horner_each(&piece.speed, at);
    let mut squares = *at;
    for k in 0..U {
        let change = distance[k].sub(s[k]).div(speed[k]);
        at[k] = at[k].sub(change).max(low).min(high);
        squares[k] = change.mul(change);
    }
    squares
}

/// One of Newton's steps for parameters of a piece at `lengths` from the start of the curve.
#[inline(always)]
pub(super) fn polish<V: Vector, const U: usize>(
    piece: &Piece,
    lengths: &[V; U],
    parameters: &mut [V; U],
) {
    let (middle, half) = (V::splat(piece.middle), V::splat(piece.half));
    let larger = V::splat(1.0 / piece.half);
    let (mut s, mut x) = (*lengths, *parameters);
    for k in 0..U {
        s[k] = s[k].sub(V::splat(piece.start));
        x[k] = x[k].sub(middle).mul(larger);
    }
    step(piece, &s, &mut x);
    for k in 0..U {
        parameters[k] = middle.add(half.mul(x[k]));
    }
}

/// Which lanes need no further step, and whether none does.
#[inline(always)]
fn settled<V: Vector>(squares: [V; BESIDE], lanes: &mut [bool; MAX_LANES]) -> bool {
    let mut values = [0.0; MAX_LANES];
    store_all(squares, &mut values);
    let mut all = true;
    for k in 0..BESIDE * V::LANES {
        lanes[k] = values[k] < SETTLED * SETTLED;
        all &= lanes[k];
    }
    all
}

#[inline(always)]
fn store_all<V: Vector>(values: [V; BESIDE], to: &mut [f64; MAX_LANES]) {
    for k in 0..BESIDE {
        values[k].store(&mut to[k * V::LANES..]);
    }
}

/// A cubic together with its arc length.
#[derive(Debug, Clone)]
pub struct ArcLength {
    pieces: Vec<Piece>,
    length: f64,
    /// What the pieces are enlarged by; 1 except for a tiny curve.
    scale: f64,
}

impl ArcLength {
    /// Measures a curve.
    ///
    /// # Errors
    /// [`crate::Error::Memory`].
    pub fn new(curve: &Cubic) -> Result<Self> {
        let mut pieces = Vec::new();
        let large = enlarged(curve);
        let scale = if large.is_some() { ENLARGED } else { 1.0 };
        let length = measure::<f64>(large.as_ref().unwrap_or(curve), Some(&mut pieces))? / scale;
        Ok(Self {
            pieces,
            length,
            scale,
        })
    }

    /// The whole length, in the units of the points.
    #[must_use]
    pub const fn length(&self) -> f64 {
        self.length
    }

    /// Length from the start to the parameter `t` in [0, 1].
    #[must_use]
    pub fn length_at(&self, t: f64) -> f64 {
        if t >= 1.0 {
            return self.length;
        }
        let after = self
            .pieces
            .partition_point(|piece| piece.middle - piece.half <= t);
        let Some(piece) = after.checked_sub(1).and_then(|i| self.pieces.get(i)) else {
            return 0.0;
        };
        let x = ((t - piece.middle) / piece.half).clamp(-1.0, 1.0);
        let within = horner::<f64, { NODES + 1 }>(&piece.distance, x);
        (piece.start + within.clamp(0.0, piece.length)) / self.scale
    }

    /// Parameter in [0, 1] at the length `s`, clamped to the curve; 0 on a curve without length.
    #[must_use]
    pub fn parameter_at(&self, s: f64) -> f64 {
        if !(s > 0.0) || self.pieces.is_empty() {
            return 0.0;
        }
        if s >= self.length {
            return 1.0;
        }
        let mut t = [0.0];
        invert::<f64>(&self.pieces, &[s * self.scale], &mut t);
        t[0].clamp(0.0, 1.0)
    }
}

#[cfg(test)]
#[path = "arc_length_tests.rs"]
mod tests;
