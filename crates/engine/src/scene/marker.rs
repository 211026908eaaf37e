//! Markers of a timeline, and what is pinned to them.

/// A named frame of the timeline.
#[derive(Debug, Clone, PartialEq)]
pub struct Marker {
    /// Unique in its scene, one line, not empty.
    pub name: String,
    /// Any finite number.
    pub frame: f64,
}

/// A point of a node's path that is reached at a marker.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Pin {
    /// The number of the node.
    pub node: usize,
    /// The support point of its path, counted from 0.
    pub point: usize,
    /// The name of the marker.
    pub marker: String,
}
