//! The limits beyond which a check reports something.

use super::kinds::{COUNT, FindingKind, OFF, ROWS};
use crate::error::{Invalid, Result};
use crate::property::{SameBits, Stored};

impl FindingKind {
    /// The kind of this name.
    ///
    /// # Errors
    /// [`crate::Error::Argument`] if it does not exist.
    pub fn parse(name: &str) -> Result<Self> {
        let found = Self::all().find(|kind| kind.name() == name);
        found.ok_or_else(|| Invalid::NoCheck(name.into()).into())
    }
}

/// The limits of all kinds.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Limits([f64; COUNT]);

impl Default for Limits {
    fn default() -> Self {
        Self::NEW
    }
}

impl SameBits for Limits {
    fn same_bits(&self, other: &Self) -> bool {
        self.0[..].same_bits(&other.0[..])
    }
}

impl Stored for Limits {}

impl Limits {
    /// The defaults.
    pub const NEW: Self = {
        let (mut limits, mut at) = ([0.0; COUNT], 0);
        while at < COUNT {
            limits[at] = ROWS[at].1.default;
            at += 1;
        }
        Self(limits)
    };

    /// The limit of a kind.
    #[must_use]
    pub const fn get(&self, kind: FindingKind) -> f64 {
        self.0[kind as usize]
    }

    /// Sets a limit; [`OFF`]: disables the kind.
    ///
    /// # Errors
    /// [`crate::Error::Argument`] or [`crate::Error::Range`]; nothing is changed then.
    pub fn set(&mut self, kind: FindingKind, limit: f64) -> Result<()> {
        if limit.is_nan() {
            return Err(Invalid::LimitNan(kind.name()).into());
        }
        if limit != OFF {
            kind.limit().check(limit, 1.0)?;
        }
        self.0[kind as usize] = limit;
        Ok(())
    }

    /// Those that differ from the defaults.
    pub fn changed(&self) -> impl Iterator<Item = (FindingKind, f64)> {
        FindingKind::all()
            .zip(self.0)
            .filter(|(kind, limit)| kind.limit().default.to_bits() != limit.to_bits())
    }
}
