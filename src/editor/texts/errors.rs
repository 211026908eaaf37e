//! What could not be done.

use super::texts;

texts! {
    /// What could not be done.
    Errors {
        something: "This cannot be done: {0}", "Das geht nicht: {0}";
    }
}
