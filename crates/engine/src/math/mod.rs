//! Quaternions, orientations, polynomials, views and SIMD vectors (`vector`), testable without a
//! path. Of the rest of the library only errors and limits are used.
//!
//! The vectors are private: AVX2 may only run where `path::dispatch` has found it.
//!
//! ```compile_fail,E0603
//! use vides_engine::math::vector::Vector;
//! ```

pub mod camera;
pub(crate) mod chebyshev;
pub mod euler;
pub mod monotone_cubic;
pub mod orientation;
pub mod quaternion;
pub mod rotation_minimising;
pub mod transform;
pub(crate) mod tridiagonal;
pub(crate) mod vector;
pub mod view;
