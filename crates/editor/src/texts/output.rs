//! Texts of the output field.

use super::texts;

texts! {
    Output {
        point, position, view, roll, zoom, handed_over, written, loaded, too_large, saved, copied,
        nothing_copied, points_copied, points_pasted, points_removed, nothing_to_cut, no_points,
        not_pasted, nothing_to_undo, half_turn, at_target, over_target, length_changed, path_length_changed,
        nothing_to_redo,
    }
}
