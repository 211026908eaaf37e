//! The choice of vectors: code over [`vector::Vector`] is compiled once for every processor and
//! once for those with AVX2 and fused multiplication (every 64-bit ARM has that); they agree to
//! rounding. All that is called from here must be forced inline, since a separate function would
//! be compiled for the plainest processor. `--cfg vides_no_simd` leaves only the first, to measure
//! and to test it.

use super::hermite::Cubic;
use crate::math::vector;

/// A function that calls one generic over [`vector::Vector`] with the widest vectors of this
/// processor.
macro_rules! widest {
    ($visible:vis fn $outer:ident = $function:path; ($($name:ident: $type:ty),*) -> $result:ty) => {
        $visible fn $outer($($name: $type),*) -> $result {
            use $function as inner;
            #[cfg(all(target_arch = "x86_64", not(vides_no_simd)))]
            #[target_feature(enable = "avx2,fma")]
            fn avx2($($name: $type),*) -> $result {
                inner::<vector::Avx2>($($name),*)
            }
            #[cfg(all(target_arch = "x86_64", not(vides_no_simd)))]
            if std::arch::is_x86_feature_detected!("avx2") && std::arch::is_x86_feature_detected!("fma") {
                // SAFETY: the processor has just been asked for both features.
                #[allow(unsafe_code)]
                return unsafe { avx2($($name),*) };
            }
            #[cfg(target_arch = "x86_64")]
            return inner::<vector::Sse2>($($name),*);
            #[cfg(all(target_arch = "aarch64", not(vides_no_simd)))]
            return inner::<vector::Neon>($($name),*);
            #[cfg(not(any(target_arch = "x86_64", all(target_arch = "aarch64", not(vides_no_simd)))))]
            return inner::<f64>($($name),*);
        }
    };
}
pub(crate) use widest;

widest! { pub(super) fn length = super::arc_length::length; (curve: &Cubic) -> f64 }
