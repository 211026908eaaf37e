//! The keyboard's shortcuts, and who has the keyboard.

use egui::{Context, Id, Key, Modifiers};

/// To be called at the end of each pass: remembers whether a text is typed.
///
/// egui takes the keyboard away from a text on Escape before anybody sees the
/// key; without this Escape would leave the text and close its window at once.
pub(super) fn remember_typing(context: &Context) {
    let typing = context.text_edit_focused();
    context.data_mut(|data| data.insert_temp(typing_id(), typing));
}

/// Whether a text was being typed when this pass began.
pub(super) fn was_typing(context: &Context) -> bool {
    let typing = context.data(|data| data.get_temp(typing_id()));
    typing.unwrap_or(false) || context.text_edit_focused()
}

/// Whether Escape was pressed and nobody but a window has use for it. Nobody
/// else sees it then.
pub(super) fn take_escape(context: &Context) -> bool {
    !was_typing(context)
        && !egui::Popup::is_any_open(context)
        && !context.egui_is_using_pointer()
        && context.input_mut(|input| input.consume_key(Modifiers::NONE, Key::Escape))
}

fn typing_id() -> Id {
    Id::unique("typing")
}
