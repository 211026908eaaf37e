//! How the curve, the turning and the zoom of a whole path run.

use crate::property::choices;

choices! {
    /// How the camera turns between its orientations (`docs/path.md`, orientation curve).
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
    /// How the curve leads through its points (`docs/path.md`, position curve).
    pub enum CurveKind {
        /// Kochanek and Bartels, by tension, continuity and bias.
        #[default]
        Tcb = "tcb",
        /// Cubic spline: the second derivative is continuous too.
        Cubic = "cubic",
        /// Straight from point to point.
        Linear = "linear",
    }
}

choices! {
    /// How the zoom runs between its keys (`docs/path.md`, zoom).
    pub enum ZoomMode {
        /// Monotone cubic (Fritsch and Carlson 1980).
        #[default]
        Smooth = "smooth",
        /// Straight lines, as in the thesis.
        Linear = "linear",
    }
}
