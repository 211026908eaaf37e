//! What the tests of the curves share: random numbers and points, an affine map,
//! and a comparison that tells both sides.

use glam::{DMat3, DMat4, DVec3};
use proptest::prelude::*;

use super::hermite::BasisMatrix;

/// Random numbers where millions are wanted: xorshift64*.
pub(crate) struct Random(pub(crate) u64);

impl Random {
    /// In [0, 1).
    pub(crate) fn unit(&mut self) -> f64 {
        self.0 ^= self.0 >> 12;
        self.0 ^= self.0 << 25;
        self.0 ^= self.0 >> 27;
        (self.0.wrapping_mul(0x2545_F491_4F6C_DD1D) >> 11) as f64 / (1u64 << 53) as f64
    }
}

/// A point with each coordinate below `range` in magnitude.
pub(crate) fn vector(range: f64) -> impl Strategy<Value = DVec3> {
    prop::array::uniform3(-range..range).prop_map(DVec3::from_array)
}

/// Equal within `tolerance` times the wanted size, or `tolerance` below 1.
#[track_caller]
pub(crate) fn assert_near(got: DVec3, want: DVec3, tolerance: f64) {
    let error = (got - want).abs().max_element();
    assert!(
        error <= tolerance * want.abs().max_element().max(1.0),
        "got {got}, want {want}, error {error:e}"
    );
}

/// An affine map that keeps neither angles nor lengths nor orientation.
pub(crate) fn map(p: DVec3) -> DVec3 {
    let linear = DMat3::from_cols_array(&[0.5, -1.0, 0.25, 2.0, 0.75, -0.5, 1.0, 0.0, -1.5]);
    linear * p + DVec3::new(3.0, -2.0, 0.5)
}

/// The product of two matrices given by rows.
pub(crate) fn product(a: &BasisMatrix, b: &BasisMatrix) -> BasisMatrix {
    // glam reads columns where these are rows: (AB)ᵀ = BᵀAᵀ.
    (DMat4::from_cols_array_2d(b) * DMat4::from_cols_array_2d(a)).to_cols_array_2d()
}
