/*
 * The library's functions in the order of the header: what they answer (see
 * every.h), which status to fit arguments, and whether windows are needed.
 */
#ifndef FUNCTIONS_H
#define FUNCTIONS_H

#include "every.h"

/* Draws arguments for the function of this name and calls it; its answer. */
#define CALL(name) int call_##name(void)

#define EACH_FUNCTION(F) \
    F(v_last_error, TEXT, V_OK, 0) \
    F(v_last_warning, TEXT, V_OK, 0) \
    F(v_strerror, TEXT, V_OK, 0) \
    F(v_version, TEXT, V_OK, 0) \
    F(v_haupt, NOTHING, V_OK, 1) \
    F(v_free_liste, NOTHING, V_OK, 0) \
    F(v_fd, COUNT, V_OK, 0) \
    F(v_timeout, COUNT, V_OK, 0) \
    F(v_dispatch, COUNT, V_OK, 0) \
    F(v_main_loop, STATUS, V_OK, 0) \
    F(v_set_app_context, STATUS, V_ERR_ARGUMENT, 0) \
    F(v_path_new, STATUS, V_OK, 0) \
    F(v_path_clone, STATUS, V_OK, 0) \
    F(v_path_free, NOTHING, V_OK, 0) \
    F(v_path_load, STATUS, V_OK, 0) \
    F(v_path_load_from_memory, STATUS, V_OK, 0) \
    F(v_path_save, STATUS, V_OK, 0) \
    F(v_path_point_count, STATUS, V_OK, 0) \
    F(v_path_insert_point, STATUS, V_OK, 0) \
    F(v_path_divide_segment, STATUS, V_OK, 0) \
    F(v_path_remove_point, STATUS, V_OK, 0) \
    F(v_path_set_position, STATUS, V_OK, 0) \
    F(v_path_get_position, STATUS, V_OK, 0) \
    F(v_path_set_tcb, STATUS, V_OK, 0) \
    F(v_path_use_preset, STATUS, V_OK, 0) \
    F(v_path_get_tcb, STATUS, V_OK, 0) \
    F(v_path_set_preset, STATUS, V_OK, 0) \
    F(v_path_get_preset, STATUS, V_OK, 0) \
    F(v_orientation_init, NOTHING, V_OK, 0) \
    F(v_path_orientation_count, STATUS, V_OK, 0) \
    F(v_path_insert_orientation, STATUS, V_OK, 0) \
    F(v_path_remove_orientation, STATUS, V_OK, 0) \
    F(v_path_set_orientation, STATUS, V_OK, 0) \
    F(v_path_get_orientation, STATUS, V_OK, 0) \
    F(v_path_set_absolute, STATUS, V_OK, 0) \
    F(v_path_set_base_frames, STATUS, V_OK, 0) \
    F(v_path_get_base_frames, STATUS, V_OK, 0) \
    F(v_path_set_closed, STATUS, V_OK, 0) \
    F(v_path_get_closed, STATUS, V_OK, 0) \
    F(v_path_set_modes, STATUS, V_OK, 0) \
    F(v_path_get_modes, STATUS, V_OK, 0) \
    F(v_path_set_title, STATUS, V_OK, 0) \
    F(v_path_get_title, STATUS, V_OK, 0) \
    F(v_path_set_comment, STATUS, V_OK, 0) \
    F(v_path_get_comment, STATUS, V_OK, 0) \
    F(v_path_set_fps, STATUS, V_OK, 0) \
    F(v_path_get_fps, STATUS, V_OK, 0) \
    F(v_path_set_first_frame, STATUS, V_OK, 0) \
    F(v_path_get_first_frame, STATUS, V_OK, 0) \
    F(v_path_set_space, STATUS, V_OK, 0) \
    F(v_path_get_space, STATUS, V_OK, 0) \
    F(v_space_init, NOTHING, V_OK, 0) \
    F(v_space_init_sized, NOTHING, V_OK, 0) \
    F(v_path_new_in_space, STATUS, V_OK, 0) \
    F(v_path_change_up, STATUS, V_OK, 0) \
    F(v_orientation_from_pose, STATUS, V_OK, 0) \
    F(v_path_set_object, STATUS, V_OK, 0) \
    F(v_path_set_curve, STATUS, V_OK, 0) \
    F(v_path_get_curve, STATUS, V_OK, 0) \
    F(v_path_set_tangents, STATUS, V_OK, 0) \
    F(v_path_get_tangents, STATUS, V_OK, 0) \
    F(v_path_insert_on_curve, STATUS, -2, 0) \
    F(v_ease, STATUS, V_OK, 0) \
    F(v_path_set_ease, STATUS, V_OK, 0) \
    F(v_path_get_ease, STATUS, V_OK, 0) \
    F(v_path_set_distance, STATUS, V_OK, 0) \
    F(v_path_set_frames, STATUS, V_OK, 0) \
    F(v_path_get_frames, STATUS, V_OK, 0) \
    F(v_path_set_frames_locked, STATUS, V_OK, 0) \
    F(v_path_get_frames_locked, STATUS, V_OK, 0) \
    F(v_path_fit_frames, STATUS, -2, 0) \
    F(v_path_set_ahead, STATUS, V_OK, 0) \
    F(v_path_set_up, STATUS, V_OK, 0) \
    F(v_path_from_move, STATUS, V_OK, 0) \
    F(v_path_from_move_in_space, STATUS, V_OK, 0) \
    F(v_path_transform, STATUS, -2, 0) \
    F(v_path_deform, STATUS, -2, 0) \
    F(v_path_extract, STATUS, V_OK, 0) \
    F(v_path_insert_path, STATUS, -2, 0) \
    F(v_path_reverse, STATUS, V_OK, 0) \
    F(v_path_repeat, STATUS, V_OK, 0) \
    F(v_path_blend, STATUS, -2, 0) \
    F(v_path_fit_poses, STATUS, V_OK, 0) \
    F(v_path_fit_poses_in_space, STATUS, V_OK, 0) \
    F(v_path_fit_poses_robust, STATUS, V_OK, 0) \
    F(v_path_check, STATUS, V_OK, 0) \
    F(v_path_set_limit, STATUS, V_OK, 0) \
    F(v_path_get_limit, STATUS, V_OK, 0) \
    F(v_path_length, STATUS, V_OK, 0) \
    F(v_path_segment_length, STATUS, V_OK, 0) \
    F(v_path_curve_point, STATUS, V_OK, 0) \
    F(v_path_point_at_length, STATUS, V_OK, 0) \
    F(v_path_section_count, STATUS, V_OK, 0) \
    F(v_path_section_info, STATUS, V_OK, 0) \
    F(v_path_frame_count, STATUS, V_OK, 0) \
    F(v_path_sample, STATUS, V_OK, 0) \
    F(v_path_sample_range, STATUS, V_OK, 0) \
    F(v_path_pose, STATUS, V_OK, 0) \
    F(v_path_poses_at, STATUS, V_OK, 0) \
    F(v_path_to_list, STATUS, V_OK, 0) \
    F(v_path_write_ascii, STATUS, V_OK, 0) \
    F(v_path_write_ascii_to_memory, STATUS, V_OK, 0) \
    F(v_path_frame_at_seconds, STATUS, V_OK, 0) \
    F(v_path_seconds_at_frame, STATUS, V_OK, 0) \
    F(v_path_motion, STATUS, V_OK, 0) \
    F(v_node_init, NOTHING, V_OK, 0) \
    F(v_scene_new, STATUS, V_OK, 0) \
    F(v_scene_load, STATUS, V_OK, 0) \
    F(v_scene_save, STATUS, V_OK, 0) \
    F(v_scene_clone, STATUS, V_OK, 0) \
    F(v_scene_free, NOTHING, V_OK, 0) \
    F(v_scene_node_count, STATUS, V_OK, 0) \
    F(v_scene_add_node, STATUS, V_OK, 0) \
    F(v_scene_remove_node, STATUS, V_OK, 0) \
    F(v_scene_find_node, STATUS, V_OK, 0) \
    F(v_scene_get_name, STATUS, V_OK, 0) \
    F(v_scene_set_name, STATUS, V_OK, 0) \
    F(v_scene_get_node, STATUS, V_OK, 0) \
    F(v_scene_set_node, STATUS, V_OK, 0) \
    F(v_scene_set_path, STATUS, V_OK, 0) \
    F(v_scene_get_path, STATUS, V_OK, 0) \
    F(v_scene_set_marker, STATUS, V_OK, 0) \
    F(v_scene_pin, STATUS, V_OK, 0) \
    F(v_scene_set_space, STATUS, V_OK, 0) \
    F(v_scene_get_space, STATUS, V_OK, 0) \
    F(v_scene_set_track, STATUS, V_OK, 0) \
    F(v_scene_get_track, STATUS, V_OK, 0) \
    F(v_register_interpolation, STATUS, V_OK, 0) \
    F(v_scene_set_geometry, STATUS, V_OK, 0) \
    F(v_scene_load_geometry, STATUS, V_OK, 0) \
    F(v_scene_add_shape, STATUS, V_OK, 0) \
    F(v_scene_add_deformation, STATUS, V_OK, 0) \
    F(v_scene_remove_deformation, STATUS, V_OK, 0) \
    F(v_deform, STATUS, V_OK, 0) \
    F(v_scene_frame_range, STATUS, V_OK, 0) \
    F(v_scene_evaluate, STATUS, V_OK, 0) \
    F(v_scene_sample, STATUS, V_OK, 0) \
    F(v_scene_value, STATUS, V_OK, 0) \
    F(v_scene_vertices, STATUS, V_OK, 0) \
    F(v_editor_options_init, NOTHING, V_OK, 0) \
    F(v_editor_options_init_sized, NOTHING, V_OK, 0) \
    F(v_editor_open, STATUS, V_OK, 1) \
    F(v_editor_close, STATUS, V_OK, 1) \
    F(v_editor_get_path, STATUS, V_OK, 1) \
    F(v_editor_set_path, STATUS, V_OK, 1) \
    F(v_editor_set_view, STATUS, V_OK, 1) \
    F(v_editor_get_frame, STATUS, V_OK, 1) \
    F(v_editor_set_frame, STATUS, V_OK, 1) \
    F(v_editor_play, STATUS, V_OK, 1) \
    F(v_editor_select, STATUS, V_OK, 1) \
    F(v_editor_set_object, STATUS, V_OK, 1) \
    F(v_editor_set_title, STATUS, V_OK, 1) \
    F(v_editor_is_modified, STATUS, V_OK, 1) \
    F(v_editor_save, STATUS, V_OK, 1) \
    F(v_editor_raise, STATUS, V_OK, 1) \
    F(v_editors_close, STATUS, V_OK, 1) \
    F(v_editor_get_scene, STATUS, V_OK, 1) \
    F(v_editor_set_scene, STATUS, V_OK, 1) \
    F(v_quat_slerp, STATUS, V_OK, 0) \
    F(v_quat_from_view, STATUS, V_OK, 0) \
    F(v_view_from_quat, STATUS, V_OK, 0) \
    F(v_quat_spline, STATUS, V_OK, 0) \
    F(v_quat_tcb_spline, STATUS, V_OK, 0) \
    F(v_speed_curve, STATUS, V_OK, 0) \
    F(v_view_matrix, STATUS, V_OK, 0) \
    F(v_view_from_pose, STATUS, V_OK, 0) \
    F(v_pose_gl_matrix, STATUS, V_OK, 0) \
    F(v_fov_from_zoom, NOTHING, V_OK, 0) \
    F(v_zoom_from_fov, NOTHING, V_OK, 0) \
    F(v_pose_matrix, STATUS, V_OK, 0) \
    F(v_pose_projection, STATUS, V_OK, 0)

#define DECLARED(name, answers, normally, display) CALL(name);
EACH_FUNCTION(DECLARED)

#endif
