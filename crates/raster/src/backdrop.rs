//! What lies behind the things that move, kept as pixels.
//!
//! While something is dragged, few layers change, in the same tiles again and
//! again, and most of what such a tile shows lies below them and stays. So a
//! tile that is painted a second time keeps its pixels as they were below the
//! lowest layer that changed, and its next painting begins there.

use super::tile::{SIDE, Tile};

/// One layer in a tile.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Step {
    /// Fingerprint of the tile up to this layer.
    pub(super) hash: u64,
    /// The layer's number, from below.
    pub(super) layer: u32,
}

/// What is kept of one tile.
#[derive(Default)]
pub(super) struct Backdrop {
    /// The fingerprints layer by layer, as it was painted last.
    hashes: Vec<u64>,
    /// Pixels, and the fingerprint of what they show.
    pixels: Option<(u64, Box<[u32; SIDE * SIDE]>)>,
}

impl Backdrop {
    /// Begins a tile, whose ground is one colour: how many layers are in it
    /// then, and after how many its pixels should be kept, if they should.
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

    /// Nothing but its ground is in the tile.
    pub(super) fn pass_over(&mut self) {
        self.hashes.clear();
    }

    /// Nothing that was painted is there any more.
    pub(super) fn forget(&mut self) {
        self.hashes.clear();
        self.pixels = None;
    }

    /// Gives the pixels' memory back.
    pub(super) fn rest(&mut self) {
        self.pixels = None;
    }
}
