//! The formulas of deformations: their kinds, and how many numbers they take.

use std::ops::Range;

/// Control points of the lattice, 4×4×4.
pub const LATTICE: usize = 64;

/// What is computed; two pairs share a kind's name and differ in how many numbers they take.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Formula {
    /// `axis a`: r(u) = 1 + (a−1)(1−u²); a = 2 is the lecture's 2−u².
    Bulge,
    /// `axis r0 r1`: r linear from end to end.
    Taper,
    /// `axis angle`.
    Twist,
    /// `axis angle`: 0 is the identity, the middle stays.
    Bend,
    /// `axis_u axis_v u0 v0 phi_min phi_max` (lecture).
    Polar,
    /// 64 points, first index fastest.
    Lattice,
}

pub(super) const FORMULAS: [Formula; 6] = [
    Formula::Bulge,
    Formula::Taper,
    Formula::Twist,
    Formula::Bend,
    Formula::Polar,
    Formula::Lattice,
];

impl Formula {
    pub(super) const fn kind(self) -> &'static str {
        match self {
            Self::Bulge | Self::Taper => "taper",
            Self::Twist => "twist",
            Self::Bend | Self::Polar => "bend",
            Self::Lattice => "free-form",
        }
    }

    /// How many of the parameters are axes; they come first.
    pub(super) const fn axes(self) -> usize {
        match self {
            Self::Lattice => 0,
            Self::Polar => 2,
            _ => 1,
        }
    }

    /// The parameters behind the axes, which can change in time: name, index, width.
    pub(super) const fn channels(self) -> &'static [(&'static str, usize, usize)] {
        match self {
            Self::Bulge => &[("a", 1, 1)],
            Self::Taper => &[("r0", 1, 1), ("r1", 2, 1)],
            Self::Twist | Self::Bend => &[("angle", 1, 1)],
            Self::Polar => &[
                ("u0", 2, 1),
                ("v0", 3, 1),
                ("phi_min", 4, 1),
                ("phi_max", 5, 1),
            ],
            Self::Lattice => &[("points", 0, 3 * LATTICE)],
        }
    }

    pub(super) fn range(self, name: &str) -> Option<Range<usize>> {
        let mut all = self.channels().iter();
        let &(_, at, width) = all.find(|channel| channel.0 == name)?;
        Some(at..at + width)
    }

    pub(super) fn count(self) -> usize {
        let numbers: usize = self.channels().iter().map(|channel| channel.2).sum();
        self.axes() + numbers
    }
}

/// How many numbers a kind of deformation takes.
#[doc(hidden)]
pub fn counts(kind: &str) -> impl Iterator<Item = usize> + Clone {
    let of_kind = FORMULAS
        .into_iter()
        .filter(move |formula| formula.kind() == kind);
    of_kind.map(Formula::count)
}
