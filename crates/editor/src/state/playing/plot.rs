//! What the graph shows beside the pace.

use vides_engine::tools::profile::Quantity;

/// What the graph shows, one over the other.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Shown {
    pub(crate) pace: bool,
    pub(crate) quantities: [bool; Quantity::ALL.len()],
}

/// A quantity along the path.
#[derive(Debug)]
pub(crate) struct Curve {
    pub(crate) quantity: Quantity,
    /// Frame and value.
    pub(crate) values: Vec<(f64, f64)>,
}

#[derive(Debug, Default)]
pub(crate) struct Plot {
    /// The revision of the path, what is shown, the most poses.
    pub(crate) of: Option<(u64, Shown, usize)>,
    pub(crate) curves: Vec<Curve>,
}
