//! Texts of the window that lists keys and mouse actions.

use super::texts;

texts! {
    Help {
        title, mouse, left_button, left_meaning, middle_button, middle_meaning, right_button,
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
