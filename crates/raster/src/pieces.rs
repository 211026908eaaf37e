//! Long rows of shapes in pieces.
//!
//! egui makes one mesh of all shapes in a row that are cut at the same
//! rectangle: a whole panel. If one number in it changes, the mesh does, and all
//! of it would be sorted anew. In pieces only a few shapes are.

use egui::epaint::ClippedShape;

const PIECE: usize = 4;

/// Sees that egui makes meshes of a few shapes each: of two pieces in a row one
/// is cut a hundred-thousandth of a pixel farther out, which nobody sees. To be
/// called before egui makes triangles of the shapes.
pub(super) fn in_pieces(shapes: &mut [ClippedShape]) {
    let mut rest = shapes;
    while let Some(first) = rest.first() {
        let clip = first.clip_rect;
        let row = rest.iter().take_while(|shape| shape.clip_rect == clip);
        // A clip with NaN is not even equal to itself.
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
