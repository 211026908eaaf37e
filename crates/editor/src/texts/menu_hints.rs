//! Tooltips of the entries of all menus.

use super::texts;

texts! {
    MenuHints {
        new, load, import, load_object, save, save_as, recent, quit, undo, redo, append, prepend,
        close, open, copy_orientation, copy_points, cut, paste, remove_nodes, all_nodes, copy_nodes,
        cut_nodes, paste_nodes, paste_orientation, select_all, speeds, space, add_object, add_light,
        add_camera, add_group, aim_here, aim_all_here, aim_all, export, hand_over, hands_over,
        colours, display, as_system, dark, light, load_setup, save_setup, keys, view_reset,
        view_along,
    }
}
