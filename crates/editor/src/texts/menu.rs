//! Texts of the menu bar.

use super::texts;

texts! {
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
