//! What lies under the things that move, kept as pixels.
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
pub(super) struct Under {
    /// The fingerprints layer by layer, as it was painted last.
    hashes: Vec<u64>,
    /// Pixels, and the fingerprint of what they show.
    pixels: Option<(u64, Box<[u32; SIDE * SIDE]>)>,
}

impl Under {
    /// Begins a tile, whose ground is one colour: how many layers are in it
    /// then, and below which one its pixels should be kept, if any.
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
        if let Some((hash, pixels)) = &self.pixels
            && let Some(at) = steps.iter().position(|step| step.hash == *hash)
        {
            tile.pixels().copy_from_slice(&**pixels);
            return (at + 1, None);
        }
        tile.pixels().fill(ground);
        (0, Some(same).filter(|&same| same > 0))
    }

    /// Keeps a tile as it is below a layer, the `count`th of the steps.
    pub(super) fn keep(&mut self, steps: &[Step], count: usize, tile: &mut Tile) {
        let Some(last) = count.checked_sub(1).and_then(|at| steps.get(at)) else {
            return;
        };
        let (hash, pixels) = self
            .pixels
            .get_or_insert_with(|| (0, Box::new([0; SIDE * SIDE])));
        *hash = last.hash;
        pixels.copy_from_slice(tile.pixels());
    }

    /// Gives the pixels' memory back.
    pub(super) fn rest(&mut self) {
        self.pixels = None;
    }
}
