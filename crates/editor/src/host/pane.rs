//! The camera's picture where the host draws it, in a separate window that covers ours: what is
//! shown above it must be known, to be cut out there.

use egui::{Context, Id, LayerId, Order};

use crate::state::host::HostPane;

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
