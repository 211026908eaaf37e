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
    F(v_path_save_to_memory, STATUS, V_OK, 0) \
    F(v_path_point_count, STATUS, V_OK, 0) \
    F(v_path_insert_point, STATUS, V_OK, 0) \
    F(v_path_divide_segment, STATUS, V_OK, 0) \
    F(v_path_remove_point, STATUS, V_OK, 0) \
    F(v_path_move_point, STATUS, V_OK, 0) \
    F(v_orientation_init, NOTHING, V_OK, 0) \
    F(v_path_orientation_count, STATUS, V_OK, 0) \
    F(v_path_insert_orientation, STATUS, V_OK, 0) \
    F(v_path_remove_orientation, STATUS, V_OK, 0) \
    F(v_path_set_orientation, STATUS, V_OK, 0) \
    F(v_path_get_orientation, STATUS, V_OK, 0) \
    F(v_path_set_absolute, STATUS, V_OK, 0) \
    F(v_property_info, STATUS, V_OK, 0) \
    F(v_property_count, STATUS, V_OK, 0) \
    F(v_path_key, NOTHING, V_OK, 0) \
    F(v_path_set_number, STATUS, V_OK, 0) \
    F(v_path_get_number, STATUS, V_OK, 0) \
    F(v_path_set_numbers, STATUS, V_OK, 0) \
    F(v_path_get_numbers, STATUS, V_OK, 0) \
    F(v_path_set_text, STATUS, V_OK, 0) \
    F(v_path_get_text, STATUS, V_OK, 0) \
    F(v_path_set_flag, STATUS, V_OK, 0) \
    F(v_path_get_flag, STATUS, V_OK, 0) \
    F(v_path_new_in_space, STATUS, V_OK, 0) \
    F(v_path_change_up, STATUS, V_OK, 0) \
    F(v_orientation_from_pose, STATUS, V_OK, 0) \
    F(v_path_set_object, STATUS, V_OK, 0) \
    F(v_path_get_object, STATUS, V_OK, 0) \
    F(v_path_get_tangents, STATUS, V_OK, 0) \
    F(v_path_insert_on_curve, STATUS, -2, 0) \
    F(v_ease, STATUS, V_OK, 0) \
    F(v_path_set_up, STATUS, V_OK, 0) \
    F(v_path_get_up, STATUS, V_OK, 0) \
    F(v_path_tool, STATUS, V_OK, 0) \
    F(v_scene_tool, STATUS, V_OK, 0) \
    F(v_last_number, STATUS, -2, 0) \
    F(v_path_transform, STATUS, -2, 0) \
    F(v_path_extract, STATUS, V_OK, 0) \
    F(v_path_insert_path, STATUS, -2, 0) \
    F(v_path_blend, STATUS, -2, 0) \
    F(v_set_progress, STATUS, V_OK, 0) \
    F(v_path_fit_poses, STATUS, V_OK, 0) \
    F(v_path_check, STATUS, V_OK, 0) \
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
    F(v_scene_load_from_memory, STATUS, V_OK, 0) \
    F(v_scene_save_to_memory, STATUS, V_OK, 0) \
    F(v_scene_save, STATUS, V_OK, 0) \
    F(v_scene_clone, STATUS, V_OK, 0) \
    F(v_scene_free, NOTHING, V_OK, 0) \
    F(v_scene_count, STATUS, V_OK, 0) \
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
    F(v_scene_key, NOTHING, V_OK, 0) \
    F(v_scene_set_number, STATUS, V_OK, 0) \
    F(v_scene_get_number, STATUS, V_OK, 0) \
    F(v_scene_set_numbers, STATUS, V_OK, 0) \
    F(v_scene_get_numbers, STATUS, V_OK, 0) \
    F(v_scene_set_text, STATUS, V_OK, 0) \
    F(v_scene_get_text, STATUS, V_OK, 0) \
    F(v_scene_set_flag, STATUS, V_OK, 0) \
    F(v_scene_get_flag, STATUS, V_OK, 0) \
    F(v_scene_set_camera, STATUS, V_OK, 0) \
    F(v_scene_get_camera, STATUS, V_OK, 0) \
    F(v_scene_set_range, STATUS, V_OK, 0) \
    F(v_scene_set_parent, STATUS, V_OK, 0) \
    F(v_scene_set_track, STATUS, V_OK, 0) \
    F(v_scene_get_track, STATUS, V_OK, 0) \
    F(v_register_interpolation, STATUS, V_OK, 0) \
    F(v_scene_set_geometry, STATUS, V_OK, 0) \
    F(v_scene_load_geometry, STATUS, V_OK, 0) \
    F(v_scene_add_shape, STATUS, V_OK, 0) \
    F(v_scene_add_deformation, STATUS, V_OK, 0) \
    F(v_scene_remove_deformation, STATUS, V_OK, 0) \
    F(v_deform, STATUS, V_OK, 0) \
    F(v_scene_get_channel, STATUS, V_OK, 0) \
    F(v_scene_get_marker, STATUS, V_OK, 0) \
    F(v_scene_remove_marker, STATUS, V_OK, 0) \
    F(v_scene_get_pin, STATUS, V_OK, 0) \
    F(v_scene_get_geometry, STATUS, V_OK, 0) \
    F(v_scene_get_shape, STATUS, V_OK, 0) \
    F(v_scene_remove_shape, STATUS, V_OK, 0) \
    F(v_scene_get_deformation, STATUS, V_OK, 0) \
    F(v_scene_frame_range, STATUS, V_OK, 0) \
    F(v_scene_evaluate, STATUS, V_OK, 0) \
    F(v_scene_sample, STATUS, V_OK, 0) \
    F(v_scene_value, STATUS, V_OK, 0) \
    F(v_scene_vertices, STATUS, V_OK, 0) \
    F(v_scene_export, STATUS, V_OK, 0) \
    F(v_scene_import, STATUS, V_OK, 0) \
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
    F(v_editor_mark_saved, STATUS, V_OK, 1) \
    F(v_editor_save, STATUS, V_OK, 1) \
    F(v_editor_raise, STATUS, V_OK, 1) \
    F(v_editors_close, STATUS, V_OK, 1) \
    F(v_editor_get_scene, STATUS, V_OK, 1) \
    F(v_editor_set_scene, STATUS, V_OK, 1) \
    F(v_editor_undo, STATUS, -2, 1) \
    F(v_editor_redo, STATUS, -2, 1) \
    F(v_editor_begin_step, STATUS, V_OK, 1) \
    F(v_editor_end_step, STATUS, V_OK, 1) \
    F(v_editor_get_selection, STATUS, -2, 1) \
    F(v_editor_is_playing, STATUS, V_OK, 1) \
    F(v_quat_slerp, STATUS, V_OK, 0) \
    F(v_quat_from_view, STATUS, V_OK, 0) \
    F(v_view_from_quat, STATUS, V_OK, 0) \
    F(v_quat_spline, STATUS, V_OK, 0) \
    F(v_quat_tcb_spline, STATUS, V_OK, 0) \
    F(v_speed_curve, STATUS, V_OK, 0) \
    F(v_view_matrix, STATUS, V_OK, 0) \
    F(v_view_from_pose, STATUS, V_OK, 0) \
    F(v_fov_from_zoom, NOTHING, V_OK, 0) \
    F(v_zoom_from_fov, NOTHING, V_OK, 0) \
    F(v_pose_matrix, STATUS, V_OK, 0) \
    F(v_pose_from_matrix, STATUS, V_OK, 0) \
    F(v_pose_to_euler, STATUS, V_OK, 0) \
    F(v_pose_from_euler, STATUS, V_OK, 0) \
    F(v_pose_projection, STATUS, V_OK, 0)

#define DECLARED(name, answers, normally, display) CALL(name);
EACH_FUNCTION(DECLARED)

#endif
