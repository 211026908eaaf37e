//! Quaternions and orientations, polynomials, views and projections, and SIMD vectors (`vector`).
//! All of it can be tested against closed forms without a path, and uses no other part of the
//! library but its errors and limits.
//!
//! The vectors are private: code for AVX2 may only run where the processor has been asked for it,
//! as `path::dispatch` does.
//!
//! ```compile_fail,E0603
//! use vides_engine::math::vector::Vector;
//! ```

pub(crate) mod chebyshev;
pub mod euler;
pub mod monotone_cubic;
pub mod orientation;
pub mod quaternion;
pub mod rotation_minimising;
pub mod transform;
pub(crate) mod vector;
pub mod view;
