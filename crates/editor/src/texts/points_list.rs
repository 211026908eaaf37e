//! Texts of the list of points.

use super::texts;

texts! {
    PointsList {
        heading, fold, unfold, point, view, name, hint,
    }
}
