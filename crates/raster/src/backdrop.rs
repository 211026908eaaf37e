//! Saved pixels below moving things. During a drag, the same few layers change in the same tiles,
//! and most of such a tile is below them. So a tile that is painted a second time saves its pixels
//! below the lowest changed layer, and the next painting starts there.

use super::tile::{SIDE, Tile};

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Step {
    pub(super) hash: u64,
    pub(super) layer: u32,
}

#[derive(Default)]
pub(super) struct Backdrop {
    /// The hash after each layer, as last painted.
    hashes: Vec<u64>,
    /// Saved pixels and the hash of what they show.
    pixels: Option<(u64, Box<[u32; SIDE * SIDE]>)>,
}

impl Backdrop {
    /// Starts a tile from its saved pixels or from `ground`. Returns how many layers it then
    /// contains, and after how many to save it, if at all.
    pub(super) fn begin(
        &mut self,
        steps: &[Step],
        ground: u32,
        tile: &mut Tile,
    ) -> (usize, Option<usize>) {
        let before = self.hashes.iter().copied();
        let now = steps.iter().map(|step| step.hash);
        let same = before.zip(now).take_while(|(a, b)| a == b).count();
        self.hashes.clear();
        self.hashes.extend(steps.iter().map(|step| step.hash));
        let kept = self.pixels.as_ref().and_then(|(hash, pixels)| {
            let at = steps.iter().position(|step| step.hash == *hash)?;
            tile.pixels().copy_from_slice(&**pixels);
            Some(at + 1)
        });
        if kept.is_none() {
            tile.pixels().fill(ground);
        }
        let painted = kept.unwrap_or(0);
        (painted, (same > painted).then_some(same))
    }

    pub(super) fn keep(&mut self, hash: u64, tile: &mut Tile) {
        let nothing = || (0, Box::new([0; SIDE * SIDE]));
        let (kept, pixels) = self.pixels.get_or_insert_with(nothing);
        *kept = hash;
        pixels.copy_from_slice(tile.pixels());
    }

    /// The tile shows only its ground.
    pub(super) fn pass_over(&mut self) {
        self.hashes.clear();
    }

    /// The tile's pixels are lost.
    pub(super) fn forget(&mut self) {
        self.hashes.clear();
        self.pixels = None;
    }

    pub(super) fn trim(&mut self) {
        self.pixels = None;
    }
}
