//! One primitive, sorted into the tiles it touches.

use egui::epaint::Primitive;
use egui::{ClippedPrimitive, Color32, Mesh, Rect};

use super::grid::{Tiles, pixels_of};
use super::hash::{bits, mix, pair};
use super::key::{Key, to_pixels_clipped};
use super::lines::Lines;
use super::quad::Quad;
use super::rounded_rect::RoundedRect;
use super::rounded_rect_painter::RoundedRectPainter;
use super::stroke::{self, Stroke};
use super::surfaces::Surfaces;
use super::texture::{Texture, Textures};
use super::tile::{FULL, Ink, PixelRect, Tile, pixel};
use super::triangle::{self, Corner};

/// Seeds the hash of a tile covered by one colour.
const GROUND: u64 = 1;

/// Flag in an item: this triangle and the next make a [`Quad`].
const QUAD: u32 = 1 << 31;

/// Flags in an item that is a line: joined at its start, at its end.
const JOINED: [u32; 2] = [1 << 31, 1 << 30];

/// Ends the list of items.
const END: u32 = u32::MAX;

/// A primitive's contribution to one tile.
#[derive(Clone, Copy)]
struct Cell {
    first: u32,
    last: u32,
    hash: u64,
    /// This colour covers the whole tile below the items.
    ground: Option<u32>,
}

impl Cell {
    const EMPTY: Self = Self {
        first: END,
        last: END,
        hash: 0,
        ground: None,
    };
}

#[derive(Clone, Copy)]
struct Link {
    item: u32,
    next: u32,
}

#[inline(always)]
fn word(a: i32, b: i32) -> u64 {
    u64::from(a as u32) << 32 | u64::from(b as u32)
}

pub(super) struct Layer {
    pub(super) key: Key,
    tiles: Tiles,
    cells: Vec<Cell>,
    links: Vec<Link>,
}

/// A primitive's contribution to a tile, as [`Layer::part`] reports it.
#[derive(Clone, Copy)]
pub(super) struct Part {
    pub(super) hash: u64,
    /// The colour that covers everything below.
    pub(super) ground: Option<u32>,
    /// Whether there are items above that.
    pub(super) items: bool,
}

pub(super) enum Shape<'a> {
    Mesh(&'a Mesh),
    Lines(&'a Lines),
    Surfaces(&'a Surfaces),
    RoundedRect(&'a RoundedRect),
}

impl<'a> Shape<'a> {
    pub(super) fn of(primitive: &'a ClippedPrimitive) -> Option<Self> {
        match &primitive.primitive {
            Primitive::Mesh(mesh) => Some(Self::Mesh(mesh)),
            Primitive::Callback(callback) => {
                let content = &callback.callback;
                let lines = Lines::of(callback).map(Self::Lines);
                let lines = lines.or_else(|| content.downcast_ref().map(Self::Surfaces));
                lines.or_else(|| content.downcast_ref().map(Self::RoundedRect))
            }
        }
    }
}

#[inline(always)]
fn hash_of(hash: u64, corner: &Corner) -> u64 {
    let place = mix(hash, word(corner.x, corner.y));
    mix(
        mix(place, pair(corner.u, corner.v)),
        u64::from(bits(corner.color)),
    )
}

/// A pixel rectangle that contains the whole primitive.
fn extent(primitive: &ClippedPrimitive, pixels_per_point: f32, target: PixelRect) -> PixelRect {
    let mut extent = Rect::NOTHING;
    match Shape::of(primitive) {
        None => {}
        Some(Shape::Mesh(mesh)) => {
            for vertex in &mesh.vertices {
                extent.extend_with(vertex.pos);
            }
        }
        Some(Shape::Lines(lines)) => {
            let mut widest = 0.0_f32;
            for line in &lines.lines {
                extent.extend_with(line.from);
                extent.extend_with(line.to);
                widest = widest.max(line.width);
            }
            extent = extent.expand(0.5 * widest);
        }
        Some(Shape::Surfaces(surfaces)) => return surfaces.bounds().intersect(target),
        Some(Shape::RoundedRect(rounded_rect)) => extent = rounded_rect.rect,
    }
    // A line is at least a pixel wide, and its bounds are rounded outwards.
    to_pixels_clipped(
        extent.expand(4.0 / pixels_per_point),
        pixels_per_point,
        target,
    )
}

impl Layer {
    /// Sorts a primitive into tiles, reusing the buffers of `memory`.
    pub(super) fn new(
        key: Key,
        primitive: &ClippedPrimitive,
        textures: &Textures,
        pixels_per_point: f32,
        target: PixelRect,
        memory: Option<Self>,
    ) -> Self {
        let (mut cells, mut links) = memory.map_or_else(Default::default, |l| (l.cells, l.links));
        links.clear();
        cells.clear();
        // Cells cover only the primitive's extent: most layers fill a small part of their clip
        // rectangle.
        let tiles = Tiles::of(
            key.clip()
                .intersect(extent(primitive, pixels_per_point, target)),
        );
        cells.resize(tiles.count(), Cell::EMPTY);
        let mut layer = Self {
            key: key.settled(),
            tiles,
            cells,
            links,
        };
        match Shape::of(primitive) {
            None => {}
            Some(Shape::Mesh(mesh)) => {
                if let Some(texture) = textures.get(mesh.texture_id) {
                    layer.sort_mesh(mesh, texture, pixels_per_point, target);
                }
            }
            Some(Shape::Lines(lines)) => layer.sort_lines(lines, pixels_per_point),
            Some(Shape::Surfaces(surfaces)) => layer.sort_surfaces(surfaces),
            Some(Shape::RoundedRect(rounded_rect)) => {
                layer.sort_rounded_rect(rounded_rect, pixels_per_point, target)
            }
        }
        layer
    }

    fn sort_mesh(
        &mut self,
        mesh: &Mesh,
        texture: &Texture,
        pixels_per_point: f32,
        target: PixelRect,
    ) {
        let count = mesh.indices.len() / 3;
        let corners = |item: usize| triangle::corners(mesh, item, pixels_per_point);
        // The next triangle's corners, if already computed.
        let mut known = None;
        let mut item = 0;
        while item < count {
            if known.is_none()
                && let Some(quad) = Quad::of_egui(mesh, item, pixels_per_point)
            {
                self.add_quad(item as u32 | QUAD, &quad, texture, target);
                item += 2;
                continue;
            }
            let this = known.take().unwrap_or_else(|| corners(item));
            let following = corners(item + 1);
            let number = item;
            item += 1;
            let Some(this) = this else { continue };
            if let Some(next) = following
                && let Some(quad) = Quad::new(&this, &next)
            {
                item += 1;
                self.add_quad(number as u32 | QUAD, &quad, texture, target);
                continue;
            }
            known = Some(following);
            let bounds = self.key.clip().intersect(triangle::bounds(&this));
            if bounds.is_empty() {
                continue;
            }
            let Some(edges) = triangle::edges(&this) else {
                continue;
            };
            let hash = this.iter().fold(texture.generation, hash_of);
            let tiles = Tiles::of(bounds);
            let single = tiles.count() == 1;
            for (x, y) in tiles.each() {
                let within = bounds.intersect(pixels_of(x, y));
                if single || edges.iter().all(|edge| edge.touches(within)) {
                    self.add(x, y, number as u32, hash);
                }
            }
        }
    }

    fn add_quad(&mut self, item: u32, quad: &Quad, texture: &Texture, target: PixelRect) {
        let bounds = self.key.clip().intersect(quad.bounds());
        let hash = hash_of(hash_of(texture.generation ^ 1, &quad.low), &quad.high);
        let ground = quad.ink(texture).and_then(|ink| ink.opaque());
        for (x, y) in Tiles::of(bounds).each() {
            match ground {
                Some(color) if bounds.contains(pixels_of(x, y).intersect(target)) => {
                    self.hide(x, y, color);
                }
                _ => self.add(x, y, item, hash),
            }
        }
    }

    fn sort_rounded_rect(
        &mut self,
        rounded_rect: &RoundedRect,
        pixels_per_point: f32,
        target: PixelRect,
    ) {
        let Some(painter) = RoundedRectPainter::new(rounded_rect, pixels_per_point) else {
            return;
        };
        let bounds = self.key.clip().intersect(painter.bounds());
        let hash = painter.hash();
        let ground = Ink::new(painter.fill()).opaque();
        for (x, y) in Tiles::of(bounds).each() {
            let within = bounds.intersect(pixels_of(x, y));
            if !painter.fills(within) {
                self.add(x, y, 0, hash);
            } else if let Some(color) = ground
                && within == pixels_of(x, y).intersect(target)
            {
                self.hide(x, y, color);
            } else if painter.fill() != Color32::TRANSPARENT {
                self.add(x, y, 0, hash);
            }
        }
    }

    fn hide(&mut self, x: usize, y: usize, color: u32) {
        if let Some(index) = self.tiles.index(x, y) {
            self.cells[index] = Cell {
                ground: Some(color),
                hash: mix(GROUND, u64::from(color)),
                ..Cell::EMPTY
            };
        }
    }

    fn sort_lines(&mut self, lines: &Lines, pixels_per_point: f32) {
        let lines = &lines.lines;
        let mut goes_on = false;
        for (item, line) in lines.iter().enumerate() {
            let next = lines.get(item + 1);
            let before = goes_on;
            goes_on = next.is_some_and(|next| stroke::joined(line, next, pixels_per_point));
            let joints = [before, goes_on];
            let Some(stroke) = Stroke::new(line, joints, pixels_per_point) else {
                continue;
            };
            let bounds = self.key.clip().intersect(stroke.bounds());
            if bounds.is_empty() {
                continue;
            }
            let hash = mix(
                mix(pair(line.from.x, line.from.y), pair(line.to.x, line.to.y)),
                u64::from(line.width.to_bits()) << 32 | u64::from(bits(line.color)),
            );
            // Joints change how the ends are painted.
            let hash = match joints {
                [false, false] => hash,
                [a, b] => mix(hash, u64::from(a) << 1 | u64::from(b)),
            };
            let bits = [0, 1].map(|end| if joints[end] { JOINED[end] } else { 0 });
            let item = item as u32 | bits[0] | bits[1];
            let tiles = Tiles::of(bounds);
            if tiles.count() == 1 {
                self.add(tiles.x0, tiles.y0, item, hash);
                continue;
            }
            for (x, y) in tiles.each() {
                if stroke.touches(bounds.intersect(pixels_of(x, y))) {
                    self.add(x, y, item, hash);
                }
            }
        }
    }

    fn sort_surfaces(&mut self, surfaces: &Surfaces) {
        for (x, y) in self.tiles.each() {
            let within = self.key.clip().intersect(pixels_of(x, y));
            let mut seen = false;
            let mut hash = 2;
            for (_, _, row) in surfaces.rows(within) {
                seen |= row.iter().any(|&color| color != Color32::TRANSPARENT);
                let words = row.chunks(2).map(|two| match two {
                    [a, b] => u64::from(bits(*a)) << 32 | u64::from(bits(*b)),
                    rest => rest.iter().map(|&color| u64::from(bits(color))).sum(),
                });
                hash = words.fold(hash, mix);
            }
            if seen {
                self.add(x, y, 0, hash);
            }
        }
    }

    #[inline]
    fn add(&mut self, x: usize, y: usize, item: u32, hash: u64) {
        let Some(index) = self.tiles.index(x, y) else {
            return;
        };
        let link = self.links.len() as u32;
        self.links.push(Link { item, next: END });
        let cell = &mut self.cells[index];
        if cell.first == END {
            // How the clip rectangle cuts this tile is part of its look.
            let within = self.key.clip().intersect(pixels_of(x, y));
            cell.hash = mix(cell.hash, word(within.x0, within.y0));
            cell.hash = mix(cell.hash, word(within.x1, within.y1));
            cell.first = link;
        } else {
            self.links[cell.last as usize].next = link;
        }
        cell.last = link;
        cell.hash = mix(cell.hash, hash);
    }

    /// Marks the target's tiles that this layer contributes to.
    pub(super) fn note(&self, all: Tiles, touched: &mut [bool]) {
        for (cell, (x, y)) in self.cells.iter().zip(self.tiles.each()) {
            if (cell.first != END || cell.ground.is_some())
                && let Some(touched) = all.index(x, y).and_then(|at| touched.get_mut(at))
            {
                *touched = true;
            }
        }
    }

    pub(super) fn trim(&mut self) {
        self.cells.shrink_to_fit();
        self.links.shrink_to_fit();
    }

    pub(super) fn reaches(&self, y: usize) -> bool {
        (self.tiles.y0..self.tiles.y1).contains(&y)
    }

    #[inline]
    pub(super) fn part(&self, (x, y): (usize, usize)) -> Option<Part> {
        let cell = self.cells.get(self.tiles.index(x, y)?)?;
        let items = cell.first != END;
        (items || cell.ground.is_some()).then_some(Part {
            hash: cell.hash,
            ground: cell.ground,
            items,
        })
    }

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
        let within = self.key.clip().intersect(pixels_of(x, y));
        let mut next = self.cells[index].first;
        let items = std::iter::from_fn(|| {
            let link = self.links.get(next as usize)?;
            next = link.next;
            Some(link.item)
        });
        match Shape::of(primitive) {
            None => {}
            Some(Shape::Mesh(mesh)) => {
                let Some(texture) = textures.get(mesh.texture_id) else {
                    return;
                };
                let corners = |item| triangle::corners(mesh, item, pixels_per_point);
                for item in items {
                    let number = (item & !QUAD) as usize;
                    if item & QUAD != 0
                        && let Some(quad) = Quad::of_egui(mesh, number, pixels_per_point)
                    {
                        quad.paint(tile, texture, within);
                        continue;
                    }
                    let Some(this) = corners(number) else {
                        continue;
                    };
                    if item & QUAD == 0 {
                        triangle::paint(tile, &this, texture, within);
                    } else if let Some(next) = corners(number + 1)
                        && let Some(quad) = Quad::new(&this, &next)
                    {
                        quad.paint(tile, texture, within);
                    }
                }
            }
            Some(Shape::Lines(lines)) => {
                for item in items {
                    let joints = JOINED.map(|end| item & end != 0);
                    let number = (item & !(JOINED[0] | JOINED[1])) as usize;
                    if let Some(line) = lines.lines.get(number)
                        && let Some(stroke) = Stroke::new(line, joints, pixels_per_point)
                    {
                        stroke.paint(tile, within);
                    }
                }
            }
            Some(Shape::Surfaces(surfaces)) if next != END => {
                for (y, x, row) in surfaces.rows(within) {
                    let to = x + row.len() as i32;
                    for (below, &color) in tile.span(y, x, to).iter_mut().zip(row) {
                        *below = match color.a() {
                            0 => continue,
                            255 => pixel(color),
                            _ => Ink::new(color).over_translucent(*below, FULL),
                        };
                    }
                }
            }
            Some(Shape::Surfaces(_)) => {}
            Some(Shape::RoundedRect(rounded_rect)) => {
                if next != END
                    && let Some(painter) = RoundedRectPainter::new(rounded_rect, pixels_per_point)
                {
                    painter.paint(tile, within);
                }
            }
        }
    }
}
