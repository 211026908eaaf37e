//! Texts of the timing of a view and its section.

use super::texts;

texts! {
    Timing {
        heading, frames, one_frame, no_frames, end, length, length_label, hold, hold_hint,
        hold_unit,
    }
}
