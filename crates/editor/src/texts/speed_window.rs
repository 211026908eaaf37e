//! Texts of the speed-curve window.

use super::texts;

texts! {
    SpeedWindow {
        title, section, end_of_path, frames, frames_hint, seconds, locked, locked_hint,
        nothing_changes, pace, ten, ten_hint, sine, sine_hint, parabolic, parabolic_hint, distance,
        distance_hint, graph, graph_speed, graph_speed_hint, graph_distance, graph_distance_hint,
        graph_acceleration, graph_acceleration_hint, rise, rise_hint, fall, fall_hint, cruise,
        cruise_hint, rise_end, fall_start, percent, way_graph, way_graph_hint, way_key, way_at,
        which_key, key_time, key_time_hint, key_way, key_way_hint, new_key, new_key_hint,
        remove_key, remove_key_hint, speed, constant, constant_hint, ease_in, ease_in_hint,
        ease_out, ease_out_hint, both, both_hint, copy, copy_hint, copied, paste, paste_hint, reset,
        reset_hint, base, base_hint, base_move, base_move_hint, base_turn, base_turn_hint,
        base_zoom, base_zoom_hint, base_roll, base_roll_hint, hold, hold_hint, fps, fps_hint,
    }
}
