//! A depth buffer. Reciprocal depths are linear in the picture, so a triangle is filled row by row
//! with one addition a pixel (Pineda 1988; Blinn, *Hyperbolic interpolation*, 1992). Of a large
//! triangle the tiles are left out in which all is nearer already (Greene, Kass and Miller,
//! *Hierarchical Z-buffer visibility*, 1993): else many that overlap would each be filled.

use crate::error::{Result, vec_with_room};

/// Pixels of a picture of 36 × 24 mm.
pub(super) const SIZE: [usize; 2] = [480, 320];

/// Pixels along the side of a tile; a triangle that is not larger is filled at once.
const TILE: usize = 16;

const TILES: [usize; 2] = [SIZE[0] / TILE, SIZE[1] / TILE];

/// 1 / depth of the nearest at each pixel.
pub(super) struct Depths {
    /// Row by row; 0: nothing.
    nearest: Vec<f64>,
    /// Of each tile a value that none of its pixels is below.
    least: Vec<f64>,
    /// Pixels of each tile that were filled since that was found.
    filled: Vec<usize>,
}

/// A triangle in the picture.
struct Shape {
    corners: [[f64; 3]; 3],
    /// By how much the reciprocal depth grows along a row and from row to row.
    slope: [f64; 2],
    /// The greatest reciprocal depth of a corner.
    nearest: f64,
    /// Columns and rows whose middles may be within: from the first to before the last.
    columns: [usize; 2],
    rows: [usize; 2],
}

impl Shape {
    /// None if it covers no pixel's middle.
    fn new(corners: [[f64; 3]; 3]) -> Option<Self> {
        let [a, b, c] = corners;
        let span = |axis: usize| {
            let low = a[axis].min(b[axis]).min(c[axis]);
            let high = a[axis].max(b[axis]).max(c[axis]);
            [pixel(low + 0.5), pixel(high + 0.5).min(SIZE[axis])]
        };
        let (columns, rows) = (span(0), span(1));
        if columns[0] >= columns[1] || rows[0] >= rows[1] {
            return None;
        }
        let (u, v) = ([b[0] - a[0], b[1] - a[1]], [c[0] - a[0], c[1] - a[1]]);
        let area = u[0] * v[1] - v[0] * u[1];
        let (du, dv) = (b[2] - a[2], c[2] - a[2]);
        let slope = [
            (du * v[1] - dv * u[1]) / area,
            (dv * u[0] - du * v[0]) / area,
        ];
        (slope[0].is_finite() && slope[1].is_finite()).then_some(Self {
            corners,
            slope,
            // Rounding beyond the corners would put an edge-on triangle anywhere.
            nearest: a[2].max(b[2]).max(c[2]),
            columns,
            rows,
        })
    }

    /// The columns of a row that it covers.
    fn span(&self, row: usize) -> [usize; 2] {
        let [a, b, c] = self.corners;
        let y = row as f64 + 0.5;
        let (mut from, mut to) = (f64::INFINITY, f64::NEG_INFINITY);
        for (p, q) in [(a, b), (b, c), (c, a)] {
            if (p[1] > y) != (q[1] > y) {
                let x = p[0] + (y - p[1]) * ((q[0] - p[0]) / (q[1] - p[1]));
                from = from.min(x);
                to = to.max(x);
            }
        }
        let [left, right] = self.columns;
        [pixel(from + 0.5).max(left), pixel(to + 0.5).min(right)]
    }

    /// The reciprocal depth of its plane in the middle of a pixel.
    fn depth(&self, column: usize, row: usize) -> f64 {
        let [a, ..] = self.corners;
        let [x, y] = [column, row].map(|at| at as f64 + 0.5);
        a[2] + self.slope[0] * (x - a[0]) + self.slope[1] * (y - a[1])
    }

    /// Not less than it has at any pixel of a tile.
    fn nearest_in(&self, [column, row]: [usize; 2]) -> f64 {
        let far = |slope: f64| if slope > 0.0 { TILE - 1 } else { 0 };
        let corner = self.depth(
            column * TILE + far(self.slope[0]),
            row * TILE + far(self.slope[1]),
        );
        corner.min(self.nearest)
    }
}

impl Depths {
    pub(super) fn new() -> Result<Self> {
        let tiles = TILES[0] * TILES[1];
        let mut made = Self {
            nearest: vec_with_room(SIZE[0] * SIZE[1])?,
            least: vec_with_room(tiles)?,
            filled: vec_with_room(tiles)?,
        };
        made.nearest.resize(SIZE[0] * SIZE[1], 0.0);
        made.least.resize(tiles, 0.0);
        made.filled.resize(tiles, 0);
        Ok(made)
    }

    pub(super) fn clear(&mut self) {
        self.nearest.fill(0.0);
        self.least.fill(0.0);
        self.filled.fill(0);
    }

    pub(super) fn nearest(&self, column: usize, row: usize) -> f64 {
        self.nearest[row * SIZE[0] + column]
    }

    /// Fills a triangle before the eye.
    pub(super) fn fill(&mut self, corners: [[f64; 3]; 3]) {
        let Some(shape) = Shape::new(corners) else {
            return;
        };
        let size = |[from, end]: [usize; 2]| end - from;
        if size(shape.columns).max(size(shape.rows)) <= TILE {
            for row in shape.rows[0]..shape.rows[1] {
                self.row(&shape, row, shape.span(row));
            }
            return;
        }
        let tiles = |[from, end]: [usize; 2]| from / TILE..end.div_ceil(TILE);
        for down in tiles(shape.rows) {
            let from = shape.rows[0].max(down * TILE);
            let end = shape.rows[1].min((down + 1) * TILE);
            let mut spans = [[0; 2]; TILE];
            for row in from..end {
                spans[row - from] = shape.span(row);
            }
            for across in tiles(shape.columns) {
                let tile = down * TILES[0] + across;
                if shape.nearest_in([across, down]) <= self.least[tile] {
                    continue;
                }
                let [left, right] = [across * TILE, (across + 1) * TILE];
                for row in from..end {
                    let [first, last] = spans[row - from];
                    let span = [first.max(left), last.min(right)];
                    self.row(&shape, row, span);
                    self.filled[tile] += span[1].saturating_sub(span[0]);
                }
                // As often as that costs no more than filling.
                if self.filled[tile] >= TILE * TILE {
                    self.filled[tile] = 0;
                    self.least[tile] = self.least_in(left, down * TILE);
                }
            }
        }
    }

    fn row(&mut self, shape: &Shape, row: usize, [first, end]: [usize; 2]) {
        if first >= end {
            return;
        }
        let mut depth = shape.depth(first, row);
        for cell in &mut self.nearest[row * SIZE[0] + first..row * SIZE[0] + end] {
            *cell = cell.max(depth.min(shape.nearest));
            depth += shape.slope[0];
        }
    }

    fn least_in(&self, left: usize, bottom: usize) -> f64 {
        let rows = (bottom..bottom + TILE).map(|row| row * SIZE[0] + left);
        rows.flat_map(|from| &self.nearest[from..from + TILE])
            .fold(f64::INFINITY, |least, depth| least.min(*depth))
    }
}

/// The whole number below, 0 for less.
#[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)]
pub(super) fn pixel(at: f64) -> usize {
    at as usize
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::path::test_support::Random;

    /// The same as each triangle filled alone, pixel by pixel.
    #[test]
    fn tiles_that_are_left_out_change_no_pixel() {
        let mut random = Random(5);
        let mut depths = Depths::new().unwrap();
        let mut plain = vec![0.0_f64; SIZE[0] * SIZE[1]];
        let mut left_out = 0;
        for k in 0..300 {
            let size = [700.0, 40.0, 12.0][k % 3];
            let at = [0, 1].map(|axis| (SIZE[axis] as f64 - size).max(-100.0) * random.unit());
            let corner = |random: &mut Random| {
                [
                    at[0] + size * random.unit(),
                    at[1] + size * random.unit(),
                    0.5 + random.unit(),
                ]
            };
            let corners = [(); 3].map(|()| corner(&mut random));
            if let Some(shape) = Shape::new(corners) {
                let tiles = (0..TILES[0] * TILES[1]).filter(|tile| {
                    shape.nearest_in([tile % TILES[0], tile / TILES[0]]) <= depths.least[*tile]
                });
                left_out += tiles.count();
                for row in shape.rows[0]..shape.rows[1] {
                    let [from, end] = shape.span(row);
                    for column in from..end {
                        let cell = &mut plain[row * SIZE[0] + column];
                        *cell = cell.max(shape.depth(column, row).min(shape.nearest));
                    }
                }
            }
            depths.fill(corners);
        }
        let apart = depths.nearest.iter().zip(&plain);
        let worst = apart.map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
        assert!(worst < 1e-12, "{worst}");
        assert!(left_out > 10_000, "{left_out}");
    }
}
