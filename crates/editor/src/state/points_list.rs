//! What the list of points remembers.

use vides_document::Selection;

#[derive(Debug, Default)]
pub(crate) struct PointsList {
    /// `None`: by the width of the window.
    pub(crate) open: Option<bool>,
    pub(crate) rows: Vec<Row>,
    /// The revision that the rows show.
    pub(crate) made_of: Option<u64>,
    pub(crate) renaming: Option<Renaming>,
    /// The point that is being dragged to another place.
    pub(crate) dragged: Option<usize>,
    /// The selection when it was last shown.
    pub(crate) shown: Option<Selection>,
    /// Where to scroll while something is dragged.
    pub(crate) wanted: Option<f32>,
    /// Top and bottom of what the scroll area has shown.
    pub(crate) seen: (f32, f32),
}

/// The name of a point that is being typed.
#[derive(Debug)]
pub(crate) struct Renaming {
    pub(crate) point: usize,
    pub(crate) name: NameField,
}

/// A point, or an orientation of one that has several.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Row {
    pub(crate) at: Selection,
    pub(crate) is_point: bool,
}

/// A name that is being typed in its row.
#[derive(Debug)]
pub(crate) struct NameField {
    pub(crate) text: String,
    /// It does not have the keyboard yet.
    pub(crate) fresh: bool,
}
