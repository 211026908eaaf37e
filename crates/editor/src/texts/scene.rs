//! Texts of the list of a scene's nodes.

use super::texts;

texts! {
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
