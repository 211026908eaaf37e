//! The movement window: the path in space, and the mouse in it (thesis chapter
//! 6, A.3).

use super::state::Editor;

/// What the movement window remembers.
#[derive(Debug)]
pub(super) struct Space {
    /// Rotation about the y axis, degrees.
    pub(super) rotation: f64,
    /// Tilt, degrees.
    pub(super) tilt: f64,
    /// Size of the cube: 1 fills the window.
    pub(super) size: f64,
}

impl Default for Space {
    fn default() -> Self {
        Self {
            rotation: 28.0,
            tilt: 20.0,
            size: 1.0,
        }
    }
}

/// Shows the movement window in all the room that is left.
pub(super) fn show(editor: &mut Editor, ui: &mut egui::Ui) {
    let _ = (&editor.space, ui);
}
