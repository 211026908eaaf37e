//! Texts of the setup file.

use super::texts;

texts! {
    Setup {
        loaded, saved, not_loaded, not_saved, ignored,
    }
}
