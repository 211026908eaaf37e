//! Splits long runs of shapes. egui merges consecutive shapes with the same clip rectangle, such as
//! a whole panel, into one mesh. If one number changed, the whole mesh would change and be sorted
//! again.

use egui::epaint::ClippedShape;

const PIECE: usize = 4;

/// Makes egui tessellate only a few shapes into each mesh: every other piece gets a clip rectangle
/// that is larger by an invisible hundred-thousandth of a pixel. Call it before tessellating.
pub(super) fn in_pieces(shapes: &mut [ClippedShape]) {
    let mut rest = shapes;
    while let Some(first) = rest.first() {
        let clip = first.clip_rect;
        let row = rest.iter().take_while(|shape| shape.clip_rect == clip);
        // A clip rectangle with NaN does not even equal itself.
        let count = row.count().max(1);
        let (row, behind) = rest.split_at_mut(count);
        for piece in row.chunks_mut(PIECE).skip(1).step_by(2) {
            for shape in piece {
                shape.clip_rect.max.x = clip.max.x.next_up();
            }
        }
        rest = behind;
    }
}
