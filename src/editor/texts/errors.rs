//! What could not be done.

use super::texts;

texts! {
    /// What could not be done.
    Errors {
        no_number: "{0}: “{1}” is not a number", "{0}: „{1}“ ist keine Zahl";
        out_of_range: "{0} must lie between {1} and {2}", "{0} muss zwischen {1} und {2} liegen";
    }
}
