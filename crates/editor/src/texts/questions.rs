//! Texts of the questions.

use super::texts;

texts! {
    Questions {
        unsaved, before_close, before_load, before_new, before_restore, changed, changed_since,
        newer, newer_unsaved, keep, keep_hint, reload, reload_hint, save_as, save_as_hint,
        this_path, save, discard, cancel, save_hint, discard_hint, cancel_hint, upright,
        which_upright, y_up, y_up_hint, z_up, z_up_hint, outside, names_outside, read_outside,
        read_outside_hint, leave_outside, leave_outside_hint, losses, lossy, write_hint,
    }
}
