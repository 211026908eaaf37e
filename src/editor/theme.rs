//! Fonts, colours, distances.

/// Gives a context our look.
pub(super) fn apply(context: &egui::Context) {
    context.all_styles_mut(|style| style.visuals.text_cursor.blink = false);
}
