//! The camera's picture where the host draws it, in a window of its own that covers ours: what is
//! shown above it must be known, to be cut out there.

use egui::{Context, Id, LayerId, Order, Rect};

use crate::state::Editor;

/// Where the host draws, in points of the window.
#[derive(Clone, Debug, PartialEq)]
pub struct HostPane {
    /// The picture.
    pub picture: Rect,
    /// What is shown above it, at least in part.
    pub above: Vec<Rect>,
}

impl Editor {
    /// Where the host draws what the camera sees; `None` if that is hidden or the editor draws it.
    #[must_use]
    pub fn host_pane(&self) -> Option<&HostPane> {
        self.host_pane.as_ref()
    }

    /// The host cannot draw what the camera sees: the editor does.
    pub fn draw_pane_itself(&mut self) {
        self.host_view.fills_pane = false;
        self.host_pane = None;
    }
}

impl HostPane {
    /// Adds the sub-windows, menus and hints that lie above the pane's own layer.
    pub(crate) fn add_what_lies_above(&mut self, context: &Context, layer: Id) {
        let own = LayerId::new(Order::Middle, layer);
        context.memory(|memory| {
            // If the pane's layer is not shown, all others lie above the pane.
            let is_pane = memory.areas().is_visible(&own);
            let above = (memory.layer_ids())
                .skip_while(|&layer| is_pane && layer != own)
                .skip(usize::from(is_pane))
                .filter(|layer| layer.order > Order::Background);
            let shown = above.filter(|layer| memory.areas().is_visible(layer));
            let rects = shown.filter_map(|layer| memory.area_rect(layer.id));
            self.above
                .extend(rects.filter(|rect| rect.intersects(self.picture)));
        });
    }
}
