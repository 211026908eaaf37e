//! One primitive, sorted into the tiles that it touches.

use egui::epaint::Primitive;
use egui::{ClippedPrimitive, Mesh, Rect};

use super::grid::{Tiles, pixels_of};
use super::hash::{mix, pair};
use super::lines::Lines;
use super::stroke::Stroke;
use super::texture::Textures;
use super::tile::{Cut, Tile};
use super::triangle;

/// No further item.
const END: u32 = u32::MAX;

/// What a primitive puts into one tile.
#[derive(Clone, Copy)]
struct Cell {
    /// The first and the last of its items in `links`.
    first: u32,
    last: u32,
    /// The fingerprint of all of it.
    hash: u64,
}

/// An item of a tile, and the next one.
#[derive(Clone, Copy)]
struct Link {
    item: u32,
    next: u32,
}

/// A primitive's items by tile.
pub(super) struct Layer {
    clip: Cut,
    tiles: Tiles,
    cells: Vec<Cell>,
    links: Vec<Link>,
}

/// What a primitive is for us.
pub(super) enum Kind<'a> {
    Mesh(&'a Mesh),
    Lines(&'a Lines, Rect),
}

impl<'a> Kind<'a> {
    pub(super) fn of(primitive: &'a ClippedPrimitive) -> Option<Self> {
        match &primitive.primitive {
            Primitive::Mesh(mesh) => Some(Self::Mesh(mesh)),
            Primitive::Callback(callback) => {
                let lines = Lines::of(callback)?;
                Some(Self::Lines(lines, callback.rect))
            }
        }
    }
}

/// A rectangle in points as whole pixels of the target.
fn cut(rect: Rect, pixels_per_point: f32, target: Cut) -> Cut {
    let pixel = |at: f32| (at * pixels_per_point).round();
    let within = |at: f32, end: i32| at.clamp(0.0, end as f32) as i32;
    Cut {
        x0: within(pixel(rect.min.x), target.x1),
        y0: within(pixel(rect.min.y), target.y1),
        x1: within(pixel(rect.max.x), target.x1),
        y1: within(pixel(rect.max.y), target.y1),
    }
}

impl Layer {
    pub(super) fn new(
        primitive: &ClippedPrimitive,
        textures: &Textures,
        pixels_per_point: f32,
        target: Cut,
    ) -> Self {
        let mut clip = cut(primitive.clip_rect, pixels_per_point, target);
        let mut layer = Self {
            clip,
            tiles: Tiles::default(),
            cells: Vec::new(),
            links: Vec::new(),
        };
        match Kind::of(primitive) {
            None => {}
            Some(Kind::Mesh(mesh)) => {
                let Some(texture) = textures.get(mesh.texture_id) else {
                    return layer;
                };
                layer.open(clip, texture.generation);
                layer.sort_mesh(mesh, pixels_per_point);
            }
            Some(Kind::Lines(lines, rect)) => {
                clip = clip.and(cut(rect, pixels_per_point, target));
                layer.open(clip, 0);
                layer.sort_lines(lines, pixels_per_point);
            }
        }
        layer
    }

    fn open(&mut self, clip: Cut, seed: u64) {
        self.clip = clip;
        self.tiles = Tiles::of(clip);
        let empty = Cell {
            first: END,
            last: END,
            hash: seed,
        };
        self.cells.resize(self.tiles.count(), empty);
    }

    fn sort_mesh(&mut self, mesh: &Mesh, pixels_per_point: f32) {
        for item in 0..mesh.indices.len() / 3 {
            let Some(corners) = triangle::corners(mesh, item, pixels_per_point) else {
                continue;
            };
            let bounds = self.clip.and(triangle::bounds(&corners));
            let tiles = Tiles::of(bounds);
            let Some(edges) = triangle::edges(&corners) else {
                continue;
            };
            let hash = corners.iter().fold(0, |hash, corner| {
                let place = (corner.x as u32 as u64) << 32 | corner.y as u32 as u64;
                let color = u64::from(u32::from_ne_bytes(corner.color.to_array()));
                mix(mix(mix(hash, place), pair(corner.u, corner.v)), color)
            });
            for y in tiles.y0..tiles.y1 {
                for x in tiles.x0..tiles.x1 {
                    let within = bounds.and(pixels_of(x, y));
                    if edges.iter().all(|edge| edge.touches(within)) {
                        self.add(x, y, item as u32, hash);
                    }
                }
            }
        }
    }

    fn sort_lines(&mut self, lines: &Lines, pixels_per_point: f32) {
        for (item, line) in lines.lines.iter().enumerate() {
            let Some(stroke) = Stroke::new(line, pixels_per_point) else {
                continue;
            };
            let bounds = self.clip.and(stroke.bounds());
            let tiles = Tiles::of(bounds);
            let hash = mix(
                mix(pair(line.from.x, line.from.y), pair(line.to.x, line.to.y)),
                u64::from(line.width.to_bits()) << 32
                    | u64::from(u32::from_ne_bytes(line.color.to_array())),
            );
            for y in tiles.y0..tiles.y1 {
                for x in tiles.x0..tiles.x1 {
                    if stroke.touches(bounds.and(pixels_of(x, y))) {
                        self.add(x, y, item as u32, hash);
                    }
                }
            }
        }
    }

    fn add(&mut self, x: usize, y: usize, item: u32, hash: u64) {
        let Some(index) = self.tiles.index(x, y) else {
            return;
        };
        let link = self.links.len() as u32;
        self.links.push(Link { item, next: END });
        let cell = &mut self.cells[index];
        if cell.first == END {
            // How the clip cuts this tile is part of what is seen.
            let within = self.clip.and(pixels_of(x, y));
            let word = |a: i32, b: i32| (a as u32 as u64) << 32 | b as u32 as u64;
            cell.hash = mix(
                mix(cell.hash, word(within.x0, within.y0)),
                word(within.x1, within.y1),
            );
            cell.first = link;
        } else {
            self.links[cell.last as usize].next = link;
        }
        cell.last = link;
        cell.hash = mix(cell.hash, hash);
    }

    /// Continues the fingerprint of a tile.
    pub(super) fn hash(&self, x: usize, y: usize, hash: u64) -> u64 {
        match self.tiles.index(x, y).map(|index| self.cells[index]) {
            Some(cell) if cell.first != END => mix(hash, cell.hash),
            _ => hash,
        }
    }

    /// Paints what the primitive puts into the tile at (x, y).
    pub(super) fn paint(
        &self,
        (x, y): (usize, usize),
        primitive: &ClippedPrimitive,
        textures: &Textures,
        pixels_per_point: f32,
        tile: &mut Tile,
    ) {
        let Some(index) = self.tiles.index(x, y) else {
            return;
        };
        let within = self.clip.and(pixels_of(x, y));
        let mut next = self.cells[index].first;
        let items = std::iter::from_fn(|| {
            let link = self.links.get(next as usize)?;
            next = link.next;
            Some(link.item as usize)
        });
        match Kind::of(primitive) {
            None => {}
            Some(Kind::Mesh(mesh)) => {
                let Some(texture) = textures.get(mesh.texture_id) else {
                    return;
                };
                for item in items {
                    if let Some(corners) = triangle::corners(mesh, item, pixels_per_point) {
                        triangle::paint(tile, &corners, texture, within);
                    }
                }
            }
            Some(Kind::Lines(lines, _)) => {
                for item in items {
                    let line = lines.lines.get(item);
                    if let Some(stroke) = line.and_then(|l| Stroke::new(l, pixels_per_point)) {
                        stroke.paint(tile, within);
                    }
                }
            }
        }
    }
}
