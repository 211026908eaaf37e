//! Texts of the space window.

use super::texts;

texts! {
    SpaceWindow {
        title, centre, centre_hint, half_size, half_size_hint, unit, unit_hint, up, up_hint, path,
        keep, keep_hint, fit, fit_hint, to_object, to_object_hint, no_object, to_path, to_path_hint,
        apply, apply_hint, ok, ok_hint,
    }
}
