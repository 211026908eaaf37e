//! Texts of the colour window.

use super::texts;

texts! {
    Colours {
        title, red, green, blue, reset, reset_hint, reset_all, reset_all_hint, of_theme,
    }
}
