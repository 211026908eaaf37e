//! SIMD vectors of doubles.
//!
//! The sampling code is written once, over the trait [`Vector`], and compiled for each kind of
//! processor (`path::dispatch` chooses): `f64` is the plain version, the reference of the
//! tests, [`Sse2`] is what every x86-64 processor has, [`Avx2`] adds fused multiplication,
//! `Neon` is what every 64-bit ARM processor has. (AVX-512 was slower than AVX2.) Everything is
//! forced inline, since a function that is called would be compiled for the plainest processor.
//! `fearless_simd` would not do: it has nothing between plain code and SSE 4.2, so plain x86-64
//! would lose its vectors, and cannot store rows of ten.

#![allow(unsafe_code)]

/// What polynomials are computed with: a number, a vector of them, or either with its derivative.
pub(crate) trait Number: Copy {
    fn splat(value: f64) -> Self;
    fn add(self, other: Self) -> Self;
    fn sub(self, other: Self) -> Self;
    fn mul(self, other: Self) -> Self;
    /// `self`·b + c, in one rounding where the processor supports that.
    fn mul_add(self, b: Self, c: Self) -> Self;
}

pub(crate) trait Vector: Number {
    const LANES: usize;
    /// The first [`Self::LANES`] numbers of a slice.
    fn load(from: &[f64]) -> Self;
    fn store(self, to: &mut [f64]);
    fn div(self, other: Self) -> Self;
    fn sqrt(self) -> Self;
    fn min(self, other: Self) -> Self;
    fn max(self, other: Self) -> Self;
    /// Writes [`Self::LANES`] records of ten numbers, row k holding the k-th number of each.
    fn store_records(rows: [Self; 10], to: &mut [f64]);
}

/// A vector and its derivative.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Dual<V> {
    pub value: V,
    pub slope: V,
}

impl<V: Vector> Number for Dual<V> {
    #[inline(always)]
    fn splat(value: f64) -> Self {
        Self {
            value: V::splat(value),
            slope: V::splat(0.0),
        }
    }
    #[inline(always)]
    fn add(self, other: Self) -> Self {
        Self {
            value: self.value.add(other.value),
            slope: self.slope.add(other.slope),
        }
    }
    #[inline(always)]
    fn sub(self, other: Self) -> Self {
        Self {
            value: self.value.sub(other.value),
            slope: self.slope.sub(other.slope),
        }
    }
    #[inline(always)]
    fn mul(self, other: Self) -> Self {
        Self {
            value: self.value.mul(other.value),
            slope: self.slope.mul_add(other.value, self.value.mul(other.slope)),
        }
    }
    #[inline(always)]
    fn mul_add(self, b: Self, c: Self) -> Self {
        let slope = self.value.mul_add(b.slope, c.slope);
        Self {
            value: self.value.mul_add(b.value, c.value),
            slope: self.slope.mul_add(b.value, slope),
        }
    }
}

/// Has the processor fetch values that will be read soon, where it can be told so.
#[inline(always)]
pub(crate) fn fetch<T>(values: &[T]) {
    #[cfg(all(target_arch = "x86_64", not(miri)))]
    for at in (0..size_of_val(values)).step_by(64) {
        use std::arch::x86_64::{_MM_HINT_T0, _mm_prefetch};
        // SAFETY: the address lies within the slice, and fetching reads nothing.
        unsafe { _mm_prefetch::<_MM_HINT_T0>(values.as_ptr().byte_add(at).cast()) }
    }
    #[cfg(not(all(target_arch = "x86_64", not(miri))))]
    let _ = values;
}

/// An array of the values of an expression, as `[0, 1, 2].map(|i| …)` gives it. A closure is a
/// separate function, compiled for the plainest processor, and what it does with vectors becomes
/// a call for each operation. This is written out where it stands.
macro_rules! each {
    ($name:ident in [$($each:expr),*] => $value:expr) => {
        [$({ let $name = $each; $value }),*]
    };
}
pub(crate) use each;

/// The polynomial with `coefficients` (lowest first) at `x`.
#[inline(always)]
#[must_use]
pub(crate) fn horner<V: Number, const N: usize>(coefficients: &[f64; N], x: V) -> V {
    let mut sum = V::splat(coefficients[N - 1]);
    for k in (0..N - 1).rev() {
        sum = sum.mul_add(x, V::splat(coefficients[k]));
    }
    sum
}

/// [`horner`] for several vectors at once, whose chains of operations run beside each other.
#[inline(always)]
#[must_use]
pub(crate) fn horner_each<V: Number, const N: usize, const U: usize>(
    coefficients: &[f64; N],
    x: &[V; U],
) -> [V; U] {
    let mut sums = [V::splat(coefficients[N - 1]); U];
    for k in (0..N - 1).rev() {
        let coefficient = V::splat(coefficients[k]);
        for u in 0..U {
            sums[u] = sums[u].mul_add(x[u], coefficient);
        }
    }
    sums
}

/// Operations on one number.
macro_rules! by_itself {
    ($($name:ident($this:ident $(, $other:ident)*) => $value:expr;)*) => {
        $(
            #[inline(always)]
            fn $name(self $(, $other: Self)*) -> Self {
                let $this = self;
                $value
            }
        )*
    };
}

impl Number for f64 {
    #[inline(always)]
    fn splat(value: f64) -> Self {
        value
    }
    by_itself! {
        add(a, b) => a + b;
        sub(a, b) => a - b;
        mul(a, b) => a * b;
        // Two roundings: the fused operation would be a call into the library.
        mul_add(a, b, c) => a * b + c;
    }
}

impl Vector for f64 {
    const LANES: usize = 1;
    #[inline(always)]
    fn load(from: &[f64]) -> Self {
        from[0]
    }
    #[inline(always)]
    fn store(self, to: &mut [f64]) {
        to[0] = self;
    }
    by_itself! {
        div(a, b) => a / b;
        sqrt(a) => a.sqrt();
        min(a, b) => if a < b { a } else { b };
        max(a, b) => if a > b { a } else { b };
    }
    #[inline(always)]
    fn store_records(rows: [Self; 10], to: &mut [f64]) {
        to[..10].copy_from_slice(&rows);
    }
}

/// What a kind of vector has an instruction for, named with what it is given. (Whether one is unsafe
/// depends on it and on the compiler.)
#[cfg(any(target_arch = "x86_64", target_arch = "aarch64"))]
macro_rules! lane_by_lane {
    ($($name:ident($this:ident $(, $other:ident)*) => $value:expr;)*) => {
        $(
            #[inline(always)]
            #[allow(unused_unsafe)]
            fn $name(self $(, $other: Self)*) -> Self {
                let Self($this) = self;
                $(let Self($other) = $other;)*
                // SAFETY: the type's owner promises the instruction set.
                Self(unsafe { $value })
            }
        )*
    };
}

/// A vector of one number.
#[cfg(any(target_arch = "x86_64", target_arch = "aarch64"))]
macro_rules! of_one_number {
    ($splat:ident) => {
        #[inline(always)]
        #[allow(unused_unsafe)]
        fn splat(value: f64) -> Self {
            // SAFETY: the type's owner promises the instruction set.
            Self(unsafe { $splat(value) })
        }
    };
}

/// A vector from memory and to it.
#[cfg(any(target_arch = "x86_64", target_arch = "aarch64"))]
macro_rules! in_memory {
    ($lanes:literal, $load:ident, $store:ident) => {
        const LANES: usize = $lanes;
        #[inline(always)]
        fn load(from: &[f64]) -> Self {
            let from = &from[..$lanes];
            // SAFETY: the slice has just been found long enough.
            Self(unsafe { $load(from.as_ptr()) })
        }
        #[inline(always)]
        fn store(self, to: &mut [f64]) {
            let to = &mut to[..$lanes];
            // SAFETY: the slice has just been found long enough.
            unsafe { $store(to.as_mut_ptr(), self.0) }
        }
    };
}

#[cfg(target_arch = "x86_64")]
pub(crate) use x86_64::{Avx2, Sse2};

#[cfg(target_arch = "x86_64")]
mod x86_64 {
    use super::{Number, Vector};
    use std::arch::x86_64::*;

    /// Two numbers: every x86-64 processor.
    #[derive(Debug, Clone, Copy)]
    pub(crate) struct Sse2(__m128d);

    /// Four numbers. A value of this type may only be computed with in code
    /// that is compiled for AVX2 and FMA and runs on a processor with both.
    #[derive(Debug, Clone, Copy)]
    pub(crate) struct Avx2(__m256d);

    impl Number for Sse2 {
        of_one_number!(_mm_set1_pd);
        lane_by_lane! {
            add(a, b) => _mm_add_pd(a, b);
            sub(a, b) => _mm_sub_pd(a, b);
            mul(a, b) => _mm_mul_pd(a, b);
            mul_add(a, b, c) => _mm_add_pd(_mm_mul_pd(a, b), c);
        }
    }

    impl Vector for Sse2 {
        in_memory!(2, _mm_loadu_pd, _mm_storeu_pd);
        lane_by_lane! {
            div(a, b) => _mm_div_pd(a, b);
            sqrt(a) => _mm_sqrt_pd(a);
            min(a, b) => _mm_min_pd(a, b);
            max(a, b) => _mm_max_pd(a, b);
        }
        #[inline(always)]
        fn store_records(rows: [Self; 10], to: &mut [f64]) {
            let to = &mut to[..20];
            let p = to.as_mut_ptr();
            for k in (0..10).step_by(2) {
                let (a, b) = (rows[k].0, rows[k + 1].0);
                // SAFETY: SSE2 is part of x86-64; 10 + k + 1 ≤ 19.
                unsafe {
                    _mm_storeu_pd(p.add(k), _mm_unpacklo_pd(a, b));
                    _mm_storeu_pd(p.add(10 + k), _mm_unpackhi_pd(a, b));
                }
            }
        }
    }

    impl Number for Avx2 {
        of_one_number!(_mm256_set1_pd);
        lane_by_lane! {
            add(a, b) => _mm256_add_pd(a, b);
            sub(a, b) => _mm256_sub_pd(a, b);
            mul(a, b) => _mm256_mul_pd(a, b);
            mul_add(a, b, c) => _mm256_fmadd_pd(a, b, c);
        }
    }

    impl Vector for Avx2 {
        in_memory!(4, _mm256_loadu_pd, _mm256_storeu_pd);
        lane_by_lane! {
            div(a, b) => _mm256_div_pd(a, b);
            sqrt(a) => _mm256_sqrt_pd(a);
            min(a, b) => _mm256_min_pd(a, b);
            max(a, b) => _mm256_max_pd(a, b);
        }
        #[inline(always)]
        fn store_records(rows: [Self; 10], to: &mut [f64]) {
            let to = &mut to[..40];
            let p = to.as_mut_ptr();
            for k in (0..10).step_by(2) {
                let (a, b) = (rows[k].0, rows[k + 1].0);
                // SAFETY: the type's owner promises the instruction set; 30 + k + 1 ≤ 39.
                unsafe {
                    _mm256_storeu2_m128d(p.add(20 + k), p.add(k), _mm256_unpacklo_pd(a, b));
                    _mm256_storeu2_m128d(p.add(30 + k), p.add(10 + k), _mm256_unpackhi_pd(a, b));
                }
            }
        }
    }
}

#[cfg(target_arch = "aarch64")]
pub(crate) use aarch64::Neon;

#[cfg(target_arch = "aarch64")]
mod aarch64 {
    use super::{Number, Vector};
    use std::arch::aarch64::*;

    /// Two numbers: every 64-bit ARM processor.
    #[derive(Debug, Clone, Copy)]
    pub(crate) struct Neon(float64x2_t);

    impl Number for Neon {
        of_one_number!(vdupq_n_f64);
        lane_by_lane! {
            add(a, b) => vaddq_f64(a, b);
            sub(a, b) => vsubq_f64(a, b);
            mul(a, b) => vmulq_f64(a, b);
            mul_add(a, b, c) => vfmaq_f64(c, a, b);
        }
    }

    impl Vector for Neon {
        in_memory!(2, vld1q_f64, vst1q_f64);
        lane_by_lane! {
            div(a, b) => vdivq_f64(a, b);
            sqrt(a) => vsqrtq_f64(a);
            min(a, b) => vbslq_f64(vcltq_f64(a, b), a, b);
            max(a, b) => vbslq_f64(vcgtq_f64(a, b), a, b);
        }
        #[inline(always)]
        #[allow(unused_unsafe)]
        fn store_records(rows: [Self; 10], to: &mut [f64]) {
            let to = &mut to[..20];
            for k in (0..10).step_by(2) {
                let (Self(a), Self(b)) = (rows[k], rows[k + 1]);
                // SAFETY: NEON is part of 64-bit ARM.
                let (first, second) = unsafe { (vzip1q_f64(a, b), vzip2q_f64(a, b)) };
                Self(first).store(&mut to[k..]);
                Self(second).store(&mut to[10 + k..]);
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Every operation lane by lane against `f64`.
    #[inline(always)]
    fn check<V: Vector>() {
        let a: Vec<f64> = (0..V::LANES).map(|k| 1.5 + k as f64).collect();
        let b: Vec<f64> = (0..V::LANES).map(|k| 4.0 - 1.25 * k as f64).collect();
        let (va, vb) = (V::load(&a), V::load(&b));
        type Plain = fn(f64, f64) -> f64;
        let results: [(V, Plain); 8] = [
            (va.add(vb), |a, b| a + b),
            (va.sub(vb), |a, b| a - b),
            (va.mul(vb), |a, b| a * b),
            (va.div(vb), |a, b| a / b),
            (va.mul_add(vb, V::splat(0.5)), |a, b| a * b + 0.5),
            (va.sqrt(), |a, _| a.sqrt()),
            (va.min(vb), f64::min),
            (va.max(vb), f64::max),
        ];
        for (index, (found, expected)) in results.into_iter().enumerate() {
            let mut lanes = vec![0.0; V::LANES];
            found.store(&mut lanes);
            for k in 0..V::LANES {
                assert_eq!(
                    lanes[k],
                    expected(a[k], b[k]),
                    "operation {index}, lane {k}"
                );
            }
        }
        let mut rows = [V::splat(0.0); 10];
        for (r, row) in rows.iter_mut().enumerate() {
            let lanes: Vec<f64> = (0..V::LANES).map(|k| (10 * k + r) as f64).collect();
            *row = V::load(&lanes);
        }
        let mut room = vec![-1.0; 10 * V::LANES + 3];
        V::store_records(rows, &mut room[1..][..10 * V::LANES]);
        for (k, number) in room[1..][..10 * V::LANES].iter().enumerate() {
            assert_eq!(*number, k as f64);
        }
        assert_eq!(room.iter().filter(|number| **number == -1.0).count(), 3);
    }

    #[test]
    fn the_plain_vector_computes() {
        check::<f64>();
    }

    #[cfg(target_arch = "aarch64")]
    #[test]
    fn two_numbers_at_once_compute_as_the_plain_one() {
        check::<Neon>();
    }

    #[cfg(target_arch = "x86_64")]
    #[test]
    fn wide_vectors_compute_as_the_plain_one() {
        #[target_feature(enable = "avx2,fma")]
        fn avx2() {
            check::<Avx2>();
        }
        check::<Sse2>();
        if std::arch::is_x86_feature_detected!("avx2") && std::arch::is_x86_feature_detected!("fma")
        {
            // SAFETY: the processor has just been asked for both features.
            unsafe { avx2() }
        }
    }
}
