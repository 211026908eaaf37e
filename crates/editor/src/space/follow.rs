//! The space follows the hand between two passes of egui.
//!
//! A mouse tells a hundred times a second and more where it is. Panels, bars and
//! output field need not be made anew each time: nobody reads numbers so fast. So
//! while something is dragged most motions change the path and what the movement
//! window shows, and a pass of the whole follows now and then. The camera's picture
//! ([`crate::Editor::follow_by_camera`]) lies between.

use std::ops::Range;

use egui::epaint::ClippedShape;
use egui::{Context, Event, LayerId, Painter, Pos2, RawInput, Rect};

use super::{draw, pointer};
use crate::state::Editor;

/// Where the space was painted in the last pass.
#[derive(Clone, Debug)]
pub(super) struct Canvas {
    pub(super) layer: LayerId,
    pub(super) viewport: Rect,
    /// Which of the layer's shapes these are. The layer is the lowest one, so
    /// they have the same numbers among all.
    pub(super) shapes: Range<usize>,
}

/// Takes input that is nothing but motion in a drag; none if only a pass of
/// egui can take it. To be given to that, too.
pub(crate) fn follow(
    editor: &mut Editor,
    context: &Context,
    input: &RawInput,
) -> Option<Vec<ClippedShape>> {
    let to = only_motion(&input.events)?;
    let window = |input: &RawInput| {
        let scale = input.viewport().native_pixels_per_point;
        (input.screen_rect, scale, input.focused, input.system_theme)
    };
    if context.input(|last| window(&last.raw) != window(input)) {
        return None;
    }
    if !editor.space.pointer.moves() || editor.playing.is_playing() {
        return None;
    }
    let canvas = editor.space.canvas.clone()?;
    let atlas = || context.fonts(|fonts| fonts.font_image_size());
    let before = atlas();
    pointer::motion(editor, context, canvas.viewport, to);
    let painter = Painter::new(context.clone(), canvas.layer, canvas.viewport);
    draw(editor, &painter, canvas.viewport);
    let shapes = context.graphics_mut(|layers| layers.drain(&[], &Default::default()));
    // A number of a point that was not shown before may have made the picture
    // of all letters larger: only a pass hands over the new one.
    (atlas() == before).then_some(shapes)
}

/// Where motions lead to, if the events are nothing else.
fn only_motion(events: &[Event]) -> Option<Pos2> {
    let mut to = None;
    for event in events {
        let Event::PointerMoved(at) = event else {
            return None;
        };
        to = Some(*at);
    }
    to
}
