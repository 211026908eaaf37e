//! What could not be done, and why.

use super::texts;

texts! {
    Errors {
        no_number, no_unit, not_whole, out_of_range, memory, frames, refused, cannot_load,
        cannot_save, cannot_write, cannot_hand_over, cannot_list, not_found, permission,
        is_directory, not_directory, not_regular, full, read_only, long_name, too_large, not_here,
        system, interrupted,
    }
}
