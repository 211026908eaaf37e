//! Colours and measures that several parts of the picture share.

/// Width of the picture.
pub(crate) const WIDTH: f64 = 960.0;

/// Height of the picture.
pub(crate) const HEIGHT: f64 = 900.0;

/// Margin at the left and the right.
pub(crate) const MARGIN: f64 = 28.0;

/// Headings and names.
pub(crate) const INK: &str = "#1d2733";

/// Everything that explains.
pub(crate) const QUIET: &str = "#66717e";

/// Thin lines that part and measure.
pub(crate) const HAIR: &str = "#d9dee4";

/// The way: curve, support points, speed.
pub(crate) const WAY: &str = "#1f62b5";

/// The view: cameras, turning.
pub(crate) const VIEW: &str = "#c8541b";

/// The object.
pub(crate) const OBJECT: &str = "#5b6470";
