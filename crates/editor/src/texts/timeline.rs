//! Texts of the timeline's ruler, keys and graph.

use super::texts;

texts! {
    Timeline {
        unit, unit_tip, seconds, frames, all_sections, keys, key, key_at, slow_past, slow_past_hint,
        no_slow_past, rest, rest_hint, no_rest, no_rest_hint, key_tip, moved, copy_of, sections,
        section, first_stays, no_copy, along, along_tip, height, limit, move_keys,
        move_meaning, tracks, tracks_of, channel_of, path_of, keys_selected, is_pinned, position,
        rotation, scale, visible, zoom, roll, colour, intensity, cone, weights, aim_weight,
        deformation, step, linear, ramp, sine, parabolic, catmull_rom, hermite, tcb, cubic,
        euler_linear, euler_catmull_rom, manner_hint, before, after, beyond, holds, repeats,
        back_and_forth, goes_on, track_mouse, track_meaning, beside_keys, beside_meaning,
        graph_of_keys, graph_switch, graph_tip, curve_tip, read_only, time_stays, number_stays,
        tangent, smooth_hint, mirrored_hint, corner_hint, graph_mouse, graph_meaning,
        keys_clipboard, turns_lost, clipboard_meaning, no_keys_selected, keys_copied, keys_pasted,
        no_keys, keys_not_pasted, as_many_nodes, fits_no_channel, pin_to, pin_hint, no_marker,
        no_markers, home_keys, home_meaning, marker, new_marker, marker_name, marker_tip,
        rename_marker, remove_marker, remove_marker_hint, marker_mouse, marker_meaning, zoom_mouse,
        zoom_meaning, drag_mouse, drag_meaning,
    }
}
