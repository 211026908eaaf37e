//! Equality bit by bit.

use std::sync::Arc;

use glam::{DQuat, DVec3};

/// Equality bit by bit: 0 and −0 differ.
pub trait SameBits {
    /// Whether no bit differs.
    fn same_bits(&self, other: &Self) -> bool;
}

impl<T: SameBits> SameBits for Vec<T> {
    fn same_bits(&self, other: &Self) -> bool {
        self[..].same_bits(&other[..])
    }
}

impl<T: SameBits> SameBits for Option<T> {
    fn same_bits(&self, other: &Self) -> bool {
        match (self, other) {
            (Some(a), Some(b)) => a.same_bits(b),
            (None, None) => true,
            _ => false,
        }
    }
}

impl<T: SameBits> SameBits for [T] {
    fn same_bits(&self, other: &Self) -> bool {
        self.len() == other.len() && self.iter().zip(other).all(|(a, b)| a.same_bits(b))
    }
}

impl<T: SameBits, const N: usize> SameBits for [T; N] {
    fn same_bits(&self, other: &Self) -> bool {
        self[..].same_bits(&other[..])
    }
}

macro_rules! same_bits {
    ($($type:ty: |$a:ident| $numbers:expr;)*) => { $(
        impl SameBits for $type {
            fn same_bits(&self, other: &Self) -> bool {
                let numbers = |$a: &Self| $numbers;
                numbers(self) == numbers(other)
            }
        }
    )* };
}

same_bits! {
    f64: |a| a.to_bits();
    bool: |a| *a;
    u32: |a| *a;
    i32: |a| *a;
    DVec3: |a| a.to_array().map(f64::to_bits);
    DQuat: |a| a.to_array().map(f64::to_bits);
}

impl SameBits for String {
    fn same_bits(&self, other: &Self) -> bool {
        self == other
    }
}

impl<T: SameBits + ?Sized> SameBits for Arc<T> {
    fn same_bits(&self, other: &Self) -> bool {
        Self::ptr_eq(self, other) || (**self).same_bits(other)
    }
}
