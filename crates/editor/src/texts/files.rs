//! Texts of the file windows.

use super::texts;

texts! {
    Files {
        load_path, save_path, load_object, add_object, export, load_setup, save_setup, load_block,
        save_block, import, block, one_file, not_here, folder, folder_hint, up, up_hint, home,
        home_hint, contents, name, name_hint, filter, filter_hint, format, format_hint, hidden,
        hidden_hint, load, take_hint, overwrite_hint, cancel_hint, save, write, cancel, reading,
        empty, more, no_name, exists, overwrite, proposal, poses,
    }
}
