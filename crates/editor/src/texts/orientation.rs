//! Texts of the orientation panel.

use super::texts;

texts! {
    Orientation {
        heading, at_place, in_direction, along_way, add, add_hint, remove, remove_hint, absolute,
        absolute_hint, relative, relative_hint, ahead, ahead_hint, whole, whole_hint, distance,
        distance_hint, previous_hint, next_hint, count, target, target_hint, direction,
        direction_hint, roll, roll_hint, up, up_hint, up_axis, up_axis_hint, up_place,
        up_place_hint, up_path, up_path_hint, up_minimal, up_minimal_hint, up_frenet,
        up_frenet_hint, up_y, up_z, up_fixed_hint, up_at, up_at_hint, own_turning, own_turning_hint,
        own_slope, own_slope_hint, at_most, one_remains, only_one, all_aimed, on_position,
    }
}
