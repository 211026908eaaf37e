//! Texts of the movement window.

use super::texts;

texts! {
    Space {
        name, size, size_tip, rotate, rotate_tip, tilt, tilt_tip, circle_edge_on, position_at,
        target_at, offset_at, tangent_at, roll_at, aim_here, aim_all_here, empty_hint, nodes_hint,
        draw_hint, several_hint, all_points, click_mouse, click_meaning, box_mouse, box_meaning,
        one_keys, one_meaning, tool_keys, tool_meaning, turn_hint, scale_hint, handle_mouse,
        handle_meaning, list_keys, list_meaning, axis_keys, axis_meaning, node_mouse, node_meaning,
        pivot_keys_name, pivot_meaning, way_mouse, way_meaning, tool_hint, moved_by, turned_by,
        scaled_by, scaled_along, nudged, own_axis, needs_nodes, path_moves_it, pivot_of_flat,
        pivot_too_long, pivot_moved, pivot_keys, node_hint, key_hint, needs_several, corner_mouse,
        corner_meaning, drag_hint, in_plane, only_along, edge_on, on_line, rolling, roll_hint,
        tangent_hint, before, after, tangent_mouse, tangent_meaning, make_closed, make_open,
        scene_last_tip, play, pause, play_tip, timeline, timeline_tip, frame_number, frame_tip,
        second, second_tip, of, last_frame, last_frame_tip, duration, duration_tip, times, times_fixed, times_fixed_tip, times_follow, times_follow_tip, rate, rate_tip, rate_unit, again, again_tip, only_selected,
        only_selected_tip, pace, pace_tip, loop_keys, loop_meaning, too_many_frames, speed_graph,
        plot, plot_tip, plot_distance, plot_clearance, plot_speed, plot_acceleration, plot_turning,
        plot_roll, plot_zoom, plot_distance_tip, plot_clearance_tip, plot_speed_tip,
        plot_acceleration_tip, plot_turning_tip, plot_roll_tip, plot_zoom_tip, speed_graph_tip,
        speed_graph_switch, speed_graph_keys, speed_graph_meaning, section_border,
        section_border_tip, camera_whole, camera_whole_tip, camera_menu, camera_corner,
        camera_border, camera_beside, camera_beside_tip, camera_place_keys, camera_place_meaning,
        camera_aspect, camera_aspect_tip, safe_frame, safe_frame_tip, free_view, fly_tip, fly_mouse,
        fly_meaning, fly_back, fly_back_tip, camera_view, camera_view_tip, camera_picture,
        close_camera_view, camera_at_frame, camera_at_key, millimetres, shift_mouse, shift_meaning,
        whole_mouse, whole_meaning, move_keys, move_meaning, target_keys, target_meaning, roll_keys,
        roll_meaning, turn_keys, turn_meaning, size_keys, size_meaning, next_keys, next_meaning,
        play_keys, play_meaning, camera_keys, camera_meaning, menu_keys, menu_meaning, facing_mouse,
        facing_meaning, snap_mouse, snap_meaning, fine_mouse, fine_meaning, escape_keys,
        escape_meaning, host_view, no_host_view, host_view_refused, same_view, take_over,
        take_over_tip, take_over_here, take_over_here_tip, begin_with, begin_view, begin_open,
        begin_open_tip, one_outside, some_outside, outside_tip, view_menu, view_menu_tip,
        view_oblique, view_oblique_tip, wireframe, wireframe_tip, sliders, sliders_tip, view_reset,
        view_front, view_right, view_above,
    }
}
