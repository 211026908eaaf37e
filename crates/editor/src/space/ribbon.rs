//! The ribbon along the curve, which leans towards up and so shows the roll; its fringe points
//! where the camera looks (wished for in the thesis's chapter 8).
//!
//! A drag changes few sections. So the ribbon is kept in pieces of a few sections, and a piece is
//! made again only where its poses changed.

use std::ops::Range;
use std::sync::Arc;

use egui::{Color32, Mesh, Painter, Shape};
use glam::DVec3;
use vides_document::Document;
use vides_document::error::Result;
use vides_engine::path::{Change, Pose, Sampler, Timeline};
use vides_raster::Lines;

use super::cameras::Camera;
use super::scene::{Look, LookKey, THIN};
use super::strokes::Strokes;
use crate::setup::Element;

/// Width of the ribbon and length of its fringe, in units of the space's `half_size`.
const WIDTH: f64 = 0.07;
const FRINGE: f64 = 0.11;

/// Most poses of the ribbon.
const POSES: usize = 1200;

/// Up to this many frames, sampling all costs less than [`POSES`] one by one.
const ALL_AT_ONCE: usize = 4 * POSES;

/// Frames that are sampled together.
const TOGETHER: usize = 512;

/// On a path of more points the ribbon waits for the end of a drag.
const MANY_POINTS: usize = 2000;

/// Most pieces that it is kept in.
const PIECES: usize = 32;

/// Distances between steps of the ribbon and between threads of its fringe, in points.
const STEP: f64 = 6.0;
const THREAD: f64 = 22.0;

#[derive(Clone, Copy, Debug, PartialEq)]
struct Rib {
    camera: Camera,
    /// A section or the path begins here.
    begins: bool,
}

impl Rib {
    fn ends(&self, half_size: f64) -> [DVec3; 2] {
        let foot = self.camera.position;
        [foot, foot + self.camera.up * (WIDTH * half_size)]
    }
}

#[derive(Debug)]
struct Piece {
    /// The last one is the first one of the next piece.
    ribs: Range<usize>,
    made: Option<(Arc<Mesh>, Arc<Lines>)>,
}

/// The ribbon's poses, and what was made of them. They are counted from the beginning of each
/// section, so that a section which a change does not reach keeps its part.
#[derive(Debug, Default)]
pub(crate) struct Ribbon {
    revision: Option<u64>,
    ribs: Vec<Rib>,
    pieces: Vec<Piece>,
    seen: Option<LookKey>,
    /// Those of the path before, to copy from.
    before: Vec<Rib>,
    /// The sections that `ribs` come from; of each, every `stride`th frame.
    sections: Vec<Section>,
    stride: usize,
    /// Kept for their allocation.
    poses: Vec<Pose>,
}

/// A section in which something changes.
#[derive(Debug)]
struct Section {
    /// See [`Sampler::fingerprints`].
    fingerprint: u64,
    /// Its poses between its two keys.
    ribs: Range<usize>,
}

impl Ribbon {
    /// Brings the poses up to date; fails for want of memory or with too many frames.
    pub(super) fn update(&mut self, document: &Document) -> Result<()> {
        let revision = document.revision();
        if self.revision == Some(revision) {
            return Ok(());
        }
        std::mem::swap(&mut self.ribs, &mut self.before);
        self.ribs.clear();
        let (old, sections) = (
            std::mem::take(&mut self.pieces),
            std::mem::take(&mut self.sections),
        );
        if document.in_step() && document.path().points.len() > MANY_POINTS {
            self.revision = None;
            return Ok(());
        }
        self.revision = Some(revision);
        let sampler = document.sampler()?;
        document.timeline(|timeline| self.collect(timeline, sampler, sections))??;
        self.divide(old);
        Ok(())
    }

    /// Makes `ribs`; those of sections that are as before are copied.
    fn collect(
        &mut self,
        timeline: &Timeline,
        sampler: &Sampler,
        mut old: Vec<Section>,
    ) -> Result<()> {
        let last = sampler.frame_count();
        // A power of two, so that one frame more does not shift all others.
        let stride = last.div_ceil(POSES).next_power_of_two();
        let moving = (0..timeline.section_count())
            .map(|section| (timeline.section(section), sampler.first_frame(section)))
            .filter(|(section, _)| section.change != Change::Nothing);
        let sections = if timeline.section_count() < POSES {
            timeline.section_count()
        } else {
            0
        };
        if self.stride != stride {
            (self.stride, old) = (stride, Vec::new());
        }
        self.ribs.try_reserve(last / stride + sections + 2)?;
        self.sections.try_reserve(sections)?;
        #[allow(clippy::cast_precision_loss)]
        let rib = |frame: usize, begins: bool| -> Result<Rib> {
            let camera = sampler.pose(frame as f64)?.into();
            Ok(Rib { camera, begins })
        };
        self.ribs.push(rib(1, true)?);
        let mut end = 1;
        let mut old = old.into_iter();
        for ((section, first), fingerprint) in moving.zip(sampler.fingerprints()).take(sections) {
            end = first + section.frames - 1;
            let start = self.ribs.len();
            match old.next().filter(|old| old.fingerprint == fingerprint) {
                Some(old) => self.ribs.extend_from_slice(&self.before[old.ribs]),
                None => {
                    let frames = (first - 1 + stride..end).step_by(stride);
                    self.between(sampler, frames, end)?;
                }
            }
            let ribs = start..self.ribs.len();
            self.sections.push(Section { fingerprint, ribs });
            self.ribs.push(rib(end, true)?);
        }
        // The rest: all frames of a path with very many sections, else a hold at the last key.
        for frame in (end + stride..last).step_by(stride) {
            self.ribs.push(rib(frame, false)?);
        }
        if end < last {
            self.ribs.push(rib(last, true)?);
        }
        Ok(())
    }

    /// Adds poses of a section that ends at frame `end`; in a short path many are sampled at once.
    fn between(
        &mut self,
        sampler: &Sampler,
        frames: impl Iterator<Item = usize>,
        end: usize,
    ) -> Result<()> {
        let together = sampler.frame_count() <= ALL_AT_ONCE;
        let poses = &mut self.poses;
        let (mut from, mut to) = (0, 0);
        for frame in frames {
            #[allow(clippy::cast_precision_loss)]
            let pose = if together {
                if frame >= to {
                    (from, to) = (frame, end.min(frame + TOGETHER));
                    poses.try_reserve(to - from)?;
                    poses.resize(to - from, Pose::default());
                    sampler.sample(from, poses)?;
                }
                poses[frame - from]
            } else {
                sampler.pose(frame as f64)?
            };
            self.ribs.push(Rib {
                camera: pose.into(),
                begins: false,
            });
        }
        Ok(())
    }

    /// Divides the ribs into pieces; a piece that was there before stays as it is.
    fn divide(&mut self, old: Vec<Piece>) {
        let begins = (0..self.ribs.len()).filter(|&at| self.ribs[at].begins);
        let sections = begins.clone().count();
        let each = sections.div_ceil(PIECES).max(1);
        let starts = begins.step_by(each);
        let ends = starts.clone().skip(1).chain([self.ribs.len() - 1]);
        let mut old = old.into_iter();
        for (start, end) in starts.zip(ends).filter(|(start, end)| start < end) {
            let ribs = start..end + 1;
            let same = old
                .next()
                .filter(|piece| self.before[piece.ribs.clone()] == self.ribs[ribs.clone()]);
            let made = same.and_then(|piece| piece.made);
            self.pieces.push(Piece { ribs, made });
        }
    }

    #[cfg(test)]
    pub(super) fn poses(&self) -> impl ExactSizeIterator<Item = Camera> {
        self.ribs.iter().map(|rib| rib.camera)
    }

    /// Paints all surfaces, and above them all lines.
    pub(super) fn paint(&mut self, painter: &Painter, look: &Look<'_>) {
        let made = self.made(look);
        let surfaces = made.iter().filter(|(mesh, _)| !mesh.is_empty());
        painter.extend(surfaces.map(|(mesh, _)| Shape::Mesh(Arc::clone(mesh))));
        let lines = made.iter().filter(|(_, all)| !all.lines.is_empty());
        painter.extend(lines.map(|(_, all)| Lines::shape(all, look.viewport)));
    }

    /// The surface and the lines of each piece.
    fn made(&mut self, look: &Look<'_>) -> Vec<&(Arc<Mesh>, Arc<Lines>)> {
        let Some(color) = look.of(Element::Ribbon) else {
            return Vec::new();
        };
        let seen = Some(look.key());
        if self.seen != seen {
            self.pieces.iter_mut().for_each(|piece| piece.made = None);
            self.seen = seen;
        }
        let ribs = &self.ribs;
        let made = self.pieces.iter_mut().map(|piece| {
            let ribs = &ribs[piece.ribs.clone()];
            &*piece.made.get_or_insert_with(|| make(ribs, look, color))
        });
        made.collect()
    }
}

fn make(ribs: &[Rib], look: &Look<'_>, color: Color32) -> (Arc<Mesh>, Arc<Lines>) {
    let mut strokes = Strokes::new(look.projection, look.viewport);
    let mut mesh = Mesh::default();
    let surface = color.gamma_multiply(0.13);
    let (edge, fringe) = (color.gamma_multiply(0.5), color.gamma_multiply(0.6));
    let half_size = look.projection.space().half_size;
    let mut last: Option<[DVec3; 2]> = None;
    // On the screen: since the last thread of the fringe, and since the section began.
    let (mut since_thread, mut since_begin) = (f64::INFINITY, 0.0);
    for (at, rib) in ribs.iter().enumerate() {
        let ends = rib.ends(half_size);
        let ends_piece = at + 1 == ribs.len();
        if let Some(before) = last {
            let way = [0, 1].map(|k| look.projection.image_of_way(ends[k] - before[k]));
            let way = way[0].length().max(way[1].length());
            let long = rib.begins && since_begin + way >= THREAD;
            if way < STEP && !long && !ends_piece {
                continue;
            }
            since_thread += way;
            since_begin += way;
            strokes.line(before[1], ends[1], THIN, edge);
            add_quad(&mut mesh, look, before, ends, surface);
            if long {
                since_thread = f64::INFINITY;
            }
        }
        if rib.begins {
            since_begin = 0.0;
        }
        // Not at the end: there the next piece begins with one, or a camera stands.
        if since_thread >= THREAD && !ends_piece {
            since_thread = 0.0;
            let tip = ends[1] + rib.camera.view * (FRINGE * half_size);
            strokes.line(ends[1], tip, THIN, fringe);
        }
        last = Some(ends);
    }
    (Arc::new(mesh), Arc::new(strokes.finish()))
}

fn add_quad(
    mesh: &mut Mesh,
    look: &Look<'_>,
    before: [DVec3; 2],
    ends: [DVec3; 2],
    color: Color32,
) {
    let corners = [before[0], before[1], ends[1], ends[0]].map(|p| look.projection.pos(p));
    if !corners.iter().any(|&corner| look.viewport.contains(corner)) {
        return;
    }
    let Ok(first) = u32::try_from(mesh.vertices.len()) else {
        return;
    };
    for corner in corners {
        mesh.colored_vertex(corner, color);
    }
    mesh.add_triangle(first, first + 1, first + 2);
    mesh.add_triangle(first, first + 2, first + 3);
}

#[cfg(test)]
#[path = "ribbon_tests.rs"]
mod tests;
