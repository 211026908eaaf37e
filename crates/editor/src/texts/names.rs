//! The names of the texts of panels and sub-windows that need no code.

use super::texts;

texts! {
    /// Texts of the colour window.
    Colours {
        title, red, green, blue, reset, reset_hint, reset_all, reset_all_hint, of_theme,
    }
}

texts! {
    /// Texts of the window that shows a rotation by quaternions and by Euler angles.
    Compare {
        menu, menu_hint, title, no_keys, of, straight_hint, smooth_hint, quaternions, angles,
        use_these, use_these_of, use_hint, in_use, angle, largest, graph,
    }
}

texts! {
    /// What could not be done, and why.
    Errors {
        no_number, no_unit, not_whole, out_of_range, memory, frames, refused, cannot_load,
        cannot_save, cannot_write, cannot_hand_over, cannot_list, not_found, permission,
        is_directory, not_directory, not_regular, full, read_only, long_name, too_large, not_here,
        system, interrupted,
    }
}

texts! {
    /// Texts of the file windows.
    Files {
        load_path, save_path, load_object, add_object, export, load_setup, save_setup, load_block,
        save_block, import, block, one_file, not_here, folder, folder_hint, up, up_hint, home,
        home_hint, contents, name, name_hint, filter, filter_hint, patterns,
        order, by_name, by_date, by_size, all_files, kind_opened, kind_paths, kind_formats, kind_setups, kind_objects, format, format_hint, hidden,
        hidden_hint, load, take_hint, overwrite_hint, cancel_hint, save, write, cancel, reading,
        empty, more, no_name, exists, overwrite, proposal, poses,
    }
}

texts! {
    /// Texts on how well a path follows recorded poses.
    Fit {
        position, view, lens, position_graph, view_graph, go_there, recording, rate, found, hold,
        holds, gap, gaps, cut, cuts, outlier, outliers, repeated, repeated_times, times_in,
        nanoseconds, microseconds, better, better_hint, robust, robust_hint,
    }
}

texts! {
    /// Texts of the window that lists keys and mouse actions.
    Help {
        title, search, search_hint, mouse, left_button, left_meaning, middle_button, middle_meaning, right_button,
        right_meaning, held_letters, held_meaning, vup_tip, vup_meaning, empty, empty_meaning,
        wheel, wheel_meaning, context, context_meaning, drop, drop_meaning, shortcuts, absolute,
        copy, paste, menus, open_menu, first_menu, arrows, arrows_meaning, letter, letter_meaning,
        squares, squares_meaning, on_way, on_way_meaning, way_key, way_key_meaning, several,
        several_meaning, rename, rename_meaning, put_into, put_into_meaning, remove_meaning,
        copy_meaning, clipboard_meaning, all_meaning, tree, tree_meaning, fields, drag,
        drag_meaning, click, click_meaning, enter, enter_meaning, escape, escape_meaning, up_down,
        up_down_meaning, tab, tab_meaning,
    }
}

texts! {
    /// Texts of the menu bar.
    Menu {
        file, edit, output, settings, help, new, load, save, save_as, load_object, import, quit,
        undo, redo, add_point, add_copy, add_keeping, add_points, remove_point, remove_points,
        append, prepend, close, add_orientation, remove_orientation, copy_orientation, copy_points,
        cut, remove_nodes, all_nodes, copy_nodes, cut_nodes, paste, paste_orientation, speeds,
        space, add_object, add_light, add_camera, add_group, aim_all, export, hand_over, hands_over,
        nobody_takes, colours, display, load_setup, save_setup, as_system, dark, light,
        close_window, keys, control, shift, insert, delete, page_up, page_down,
    }
}

texts! {
    /// Tooltips of the entries of all menus.
    MenuHints {
        new, load, import, load_object, save, save_as, recent, quit, undo, redo, append, prepend,
        close, open, copy_orientation, copy_points, cut, paste, remove_nodes, all_nodes, copy_nodes,
        cut_nodes, paste_nodes, paste_orientation, select_all, speeds, space, add_object, add_light,
        add_camera, add_group, aim_here, aim_all_here, aim_all, export, hand_over, hands_over,
        colours, display, as_system, dark, light, load_setup, save_setup, keys, view_reset,
        view_along,
    }
}

texts! {
    /// Texts of the orientation panel.
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

texts! {
    /// Texts of the output field.
    Output {
        point, position, view, roll, zoom, handed_over, written, loaded, at_rate, too_large, saved,
        copied,
        nothing_copied, points_copied, points_pasted, points_removed, nothing_to_cut, no_points,
        not_pasted, nothing_to_undo, half_turn, at_target, over_target, length_changed, path_length_changed,
        nothing_to_redo,
    }
}

texts! {
    /// Texts of the list of points.
    PointsList {
        heading, fold, unfold, point, view, name, hint,
    }
}

texts! {
    /// Texts of the panel of position and curve.
    Position {
        heading, curve, add, add_hint, add_many_hint, copy_hint, copy_many_hint, only_keep_hint,
        only_copy_hint, remove, remove_hint, previous_hint, next_hint, count, coordinate,
        coordinate_hint, shape_hint, next_shape_hint, add_here, add_orientation_here, new_point,
        new_orientation, add_here_hint,
        is_a_key, outside, preset, own, choice, choice_hint, change, change_hint, kind,
        tcb, tcb_hint, centripetal, centripetal_hint, chordal, chordal_hint, cubic, cubic_hint,
        linear, linear_hint, tangents, own_tangents, own_tangents_hint, by_shape, by_shape_hint,
        smooth, smooth_hint, mirrored, mirrored_hint, corner, corner_hint, keeps_motion,
        keeps_motion_hint, in_place_of_tangents, no_shape_kind, how_many, how_many_hint, last_point,
        two_remain, too_many, too_many_orientations, on_target, too_far, closed_has_no_ends,
        no_room, no_direction,
    }
}

texts! {
    /// Texts of the questions.
    Questions {
        unsaved, before_close, before_load, before_new, before_restore, changed, changed_since,
        newer, newer_unsaved, keep, keep_hint, reload, reload_hint, save_as, save_as_hint,
        this_path, save, discard, cancel, save_hint, discard_hint, cancel_hint, upright,
        which_upright, y_up, y_up_hint, z_up, z_up_hint, outside, names_outside, read_outside,
        read_outside_hint, leave_outside, leave_outside_hint, losses, lossy, write_hint,
    }
}

texts! {
    /// Texts about unsaved work that is kept and offered.
    Recovery {
        title, question, restore_hint, discard_hint, picture, scene, unreadable, date, restore,
        discard, discard_now, later, later_hint, just_now, minutes, hours, days, restored, broken,
        not_kept,
    }
}

texts! {
    /// Texts of the list of a scene's nodes.
    Scene {
        title, below, below_hint, edit_hint, by_keys, still, group, object, light, camera, no_path,
        runs_by_keys, keys_to_path, keys_to_path_hint, became_path, list, row_hint, name,
        needs_name, filter, filter_hint, not_found, fold, unfold, hide, show, eye_hint,
        eye_key_hint, goes_along, shown_camera, shown_camera_hint, keeps_way, other_parent,
        one_moves, several_move, go_along, go_along_hint, keep_way, keep_way_hint, nothing_copied,
        nodes_copied, nodes_pasted, pasted_without_aim, no_nodes, nodes_not_pasted, aims_lost,
        aim_became_views, no_camera, at_frame,
    }
}

texts! {
    /// Texts of the setup file.
    Setup {
        loaded, saved, not_loaded, not_saved, ignored,
    }
}

texts! {
    /// Texts of the movement window.
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
        roll_meaning, turn_keys, turn_meaning, size_keys, size_meaning, frame_keys,
        frame_meaning, next_keys, next_meaning,
        play_keys, play_meaning, camera_keys, camera_meaning, menu_keys, menu_meaning, facing_mouse,
        facing_meaning, snap_mouse, snap_meaning, fine_mouse, fine_meaning, escape_keys,
        escape_meaning, host_view, no_host_view, host_view_refused, same_view, take_over,
        take_over_tip, take_over_here, take_over_here_tip, begin_with, begin_view, begin_open,
        begin_open_tip, drop_here, drop_kinds, begin_by_click, begin_next,
        begin_example, begin_example_tip, begin_recording, begin_recording_tip, no_path, one_outside, some_outside, outside_tip, view_menu, view_menu_tip,
        view_oblique, view_oblique_tip, wireframe, wireframe_tip, sliders, sliders_tip, view_reset,
        view_front, view_right, view_above,
    }
}

texts! {
    /// Texts of the space window.
    SpaceWindow {
        title, centre, centre_hint, half_size, half_size_hint, unit, unit_hint, up, up_hint, path,
        keep, keep_hint, fit, fit_hint, to_object, to_object_hint, no_object, to_path, to_path_hint,
        apply, apply_hint, ok, ok_hint,
    }
}

texts! {
    /// Texts of the speed-curve window.
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

texts! {
    /// Texts of the timing of a view and its section.
    Timing {
        heading, frames, one_frame, no_frames, end, length, length_label, hold, hold_hint,
        hold_unit,
    }
}

texts! {
    /// Texts of the timeline's ruler, keys and graph.
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

texts! {
    /// Texts of the zoom panel.
    Zoom {
        heading, slider, value, hint, sensor, sensor_hint, lens, lens_hint, angle_hint,
    }
}
