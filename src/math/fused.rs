//! a·b + c in one rounding where the processor has it, in two elsewhere.
//!
//! The sampling code is written once, generic over this, and compiled once
//! for each kind of processor: calling `f64::mul_add` without the instruction
//! would cost a library call.

/// A way to compute a·b + c.
pub trait MultiplyAdd: Copy {
    /// a·b + c.
    fn mul_add(a: f64, b: f64, c: f64) -> f64;
}

/// Two operations, two roundings: every processor.
#[derive(Debug, Clone, Copy)]
pub struct Separate;

/// One fused operation. Use it only in code compiled for a processor that
/// has the instruction.
#[derive(Debug, Clone, Copy)]
pub struct Fused;

impl MultiplyAdd for Separate {
    #[inline(always)]
    fn mul_add(a: f64, b: f64, c: f64) -> f64 {
        a * b + c
    }
}

impl MultiplyAdd for Fused {
    #[inline(always)]
    fn mul_add(a: f64, b: f64, c: f64) -> f64 {
        a.mul_add(b, c)
    }
}

/// The polynomial with `coefficients` (lowest first) at `x`.
#[inline(always)]
#[must_use]
pub fn horner<M: MultiplyAdd, const N: usize>(coefficients: &[f64; N], x: f64) -> f64 {
    let mut sum = coefficients[N - 1];
    let mut k = N - 1;
    while k > 0 {
        k -= 1;
        sum = M::mul_add(sum, x, coefficients[k]);
    }
    sum
}
