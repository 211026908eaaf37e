//! Texts about unsaved work that is kept and offered.

use super::texts;

texts! {
    Recovery {
        title, question, restore_hint, discard_hint, picture, scene, unreadable, date, restore,
        discard, discard_now, later, later_hint, just_now, minutes, hours, days, restored, broken,
        not_kept,
    }
}
