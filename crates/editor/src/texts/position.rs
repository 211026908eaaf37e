//! Texts of the panel of position and curve.

use super::texts;

texts! {
    Position {
        heading, curve, add, add_hint, add_many_hint, copy_hint, copy_many_hint, only_keep_hint,
        only_copy_hint, remove, remove_hint, previous_hint, next_hint, count, coordinate,
        coordinate_hint, shape_hint, next_shape_hint, add_here, add_orientation_here, add_here_hint,
        is_a_key, outside, in_between, preset, own, choice, choice_hint, change, change_hint, kind,
        tcb, tcb_hint, centripetal, centripetal_hint, chordal, chordal_hint, cubic, cubic_hint,
        linear, linear_hint, tangents, own_tangents, own_tangents_hint, by_shape, by_shape_hint,
        smooth, smooth_hint, mirrored, mirrored_hint, corner, corner_hint, keeps_motion,
        keeps_motion_hint, in_place_of_tangents, no_shape_kind, how_many, how_many_hint, last_point,
        two_remain, too_many, too_many_orientations, on_target, too_far, closed_has_no_ends,
        no_room, no_direction,
    }
}
