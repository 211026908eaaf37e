//! The grid of tiles, and the areas that changed.

use super::area::Area;
use super::tile::{PixelRect, SIDE};

/// A rectangle of tiles; x1 and y1 are exclusive.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) struct Tiles {
    pub(super) x0: usize,
    pub(super) y0: usize,
    pub(super) x1: usize,
    pub(super) y1: usize,
}

impl Tiles {
    /// The tiles that contain these pixels of the target; none if `cut` is empty.
    pub(super) fn of(cut: PixelRect) -> Self {
        if cut.is_empty() {
            return Self::default();
        }
        let tile = |at: i32| at.max(0) as usize / SIDE;
        Self {
            x0: tile(cut.x0),
            y0: tile(cut.y0),
            x1: tile(cut.x1 - 1) + 1,
            y1: tile(cut.y1 - 1) + 1,
        }
    }

    pub(super) fn width(self) -> usize {
        self.x1 - self.x0
    }

    pub(super) fn count(self) -> usize {
        self.width() * (self.y1 - self.y0)
    }

    /// The tiles, row by row.
    #[inline]
    pub(super) fn each(self) -> impl Iterator<Item = (usize, usize)> {
        (self.y0..self.y1).flat_map(move |y| (self.x0..self.x1).map(move |x| (x, y)))
    }

    /// A tile's index among these, row by row.
    #[inline]
    pub(super) fn index(self, x: usize, y: usize) -> Option<usize> {
        (x >= self.x0 && x < self.x1 && y >= self.y0 && y < self.y1)
            .then(|| (y - self.y0) * self.width() + (x - self.x0))
    }
}

#[inline]
pub(super) fn pixels_of(x: usize, y: usize) -> PixelRect {
    let side = SIDE as i32;
    let (x, y) = (x as i32 * side, y as i32 * side);
    PixelRect {
        x0: x,
        y0: y,
        x1: x + side,
        y1: y + side,
    }
}

/// Merges changed tiles: neighbours in a row, then equal rows.
#[derive(Default)]
pub(super) struct Areas {
    whole: Vec<Area>,
    /// Where in `whole` the current row of tiles begins.
    row: usize,
    before: Vec<usize>,
    now: Vec<usize>,
}

impl Areas {
    pub(super) fn add(&mut self, cut: PixelRect) {
        let area = Area {
            x: cut.x0 as u32,
            y: cut.y0 as u32,
            width: (cut.x1 - cut.x0) as u32,
            height: (cut.y1 - cut.y0) as u32,
        };
        match self.whole[self.row..].last_mut() {
            Some(last) if last.x + last.width == area.x => last.width += area.width,
            _ => self.whole.push(area),
        }
    }

    pub(super) fn end_row(&mut self) {
        let row = self.whole.split_off(self.row);
        self.now.clear();
        for area in row {
            let above = self.before.iter().copied().find(|&i| {
                let above = self.whole[i];
                above.x == area.x && above.width == area.width && above.y + above.height == area.y
            });
            match above {
                Some(i) => {
                    self.whole[i].height += area.height;
                    self.now.push(i);
                }
                None => {
                    self.now.push(self.whole.len());
                    self.whole.push(area);
                }
            }
        }
        std::mem::swap(&mut self.before, &mut self.now);
        self.row = self.whole.len();
    }

    pub(super) fn into_areas(self) -> Vec<Area> {
        self.whole
    }
}
