//! How the curve, the turning and the zoom of a whole path run.

use crate::property::choices;

choices! {
    /// How the camera turns between its orientations (`docs/theory/path.md`, orientation curve).
    pub enum OrientationMode {
        /// Cubic spherical Bézier curve with limited angular velocities.
        #[default]
        Tcb = "tcb",
        /// Barry and Goldman's curve with knots at the times (thesis 4.4.4).
        BarryGoldman = "barry-goldman",
        /// Great arcs from key to key.
        Slerp = "slerp",
    }
}

choices! {
    /// How the curve leads through its points (`docs/theory/path.md`, position curve).
    pub enum CurveKind {
        /// Kochanek and Bartels, by tension, continuity and bias.
        #[default]
        Tcb = "tcb",
        /// The same over knots that lie apart as the square roots of the chords: without cusps and
        /// loops however close points stand (Yuksel, Schaefer and Keyser 2011).
        Centripetal = "centripetal",
        /// The same over knots that lie apart as the chords are long.
        Chordal = "chordal",
        /// Cubic spline: the second derivative is continuous too.
        Cubic = "cubic",
        /// Straight from point to point.
        Linear = "linear",
    }
}

impl CurveKind {
    /// Straight between points that own no tangents.
    #[must_use]
    pub const fn is_straight(self) -> bool {
        match self {
            Self::Linear => true,
            Self::Tcb | Self::Centripetal | Self::Chordal | Self::Cubic => false,
        }
    }

    /// A spline over all points: each is felt beyond its neighbours.
    #[must_use]
    pub const fn is_spline(self) -> bool {
        match self {
            Self::Cubic => true,
            Self::Tcb | Self::Centripetal | Self::Chordal | Self::Linear => false,
        }
    }

    /// Tension, continuity and bias act.
    #[must_use]
    pub const fn has_shape(self) -> bool {
        match self {
            Self::Tcb | Self::Centripetal | Self::Chordal => true,
            Self::Cubic | Self::Linear => false,
        }
    }
}

choices! {
    /// How the zoom runs between its keys (`docs/theory/path.md`, zoom).
    pub enum ZoomMode {
        /// Monotone cubic (Fritsch and Carlson 1980).
        #[default]
        Smooth = "smooth",
        /// Straight lines, as in the thesis.
        Linear = "linear",
    }
}
