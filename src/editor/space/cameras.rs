//! The orientations of the whole path at a glance, which the thesis wishes for
//! (chapter 8): each of them as a small camera, and between them a ribbon. The
//! ribbon leans the way up is, so that it shows the roll; its fringe points
//! the way the camera looks.

use std::sync::Arc;

use egui::{Color32, Mesh, Painter, Shape};
use glam::{DVec2, DVec3};

use super::projection::to_pos;
use super::scene::{Look, THIN};
use super::strokes::Strokes;
use crate::document::Document;
use crate::editor::setup::Element;
use crate::error::Result;
use crate::math::orientation;
use crate::path::{Change, Pose, Sampler, Timeline};
use crate::raster::Lines;

/// Length of a camera's edges on the screen, in points, and at most in units
/// of the movement space.
const CAMERA: [f64; 2] = [26.0, 0.16];

/// Cameras nearer to each other than this on the screen are left out, in
/// points.
const APART: f64 = 14.0;

/// Half the height of the film in mm, and width by height.
const FILM: [f64; 2] = [12.0, 1.5];

/// Width of the ribbon and length of its fringe, in units of the movement
/// space.
const RIBBON: f64 = 0.07;
const FRINGE: f64 = 0.11;

/// Poses that the ribbon is made of, at most.
const POSES: usize = 1200;

/// Up to so many frames all of them together cost less than [`POSES`] one by one.
const ALL_AT_ONCE: usize = 4 * POSES;

/// On a path of more points the ribbon waits for the end of a drag.
const MANY_POINTS: usize = 2000;

/// Points on the screen from one step of the ribbon to the next, and from one
/// thread of the fringe to the next.
const STEP: f64 = 6.0;
const THREAD: f64 = 22.0;

/// A camera: where it is, along what it looks, what is up, its zoom.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(in crate::editor) struct Camera {
    pub(in crate::editor) position: DVec3,
    pub(in crate::editor) view: DVec3,
    pub(in crate::editor) up: DVec3,
    pub(in crate::editor) zoom: f64,
}

impl From<Pose> for Camera {
    fn from(pose: Pose) -> Self {
        Self {
            position: DVec3::from_array(pose.vrp),
            view: DVec3::from_array(pose.vpn),
            up: DVec3::from_array(pose.vup),
            zoom: pose.zoom,
        }
    }
}

impl Camera {
    /// The camera of an orientation.
    pub(in crate::editor) fn at(document: &Document, point: usize, number: usize) -> Option<Self> {
        let point = document.path().points.get(point)?;
        let orientation = point.orientations.get(number)?;
        let view = orientation.view(point.position);
        Some(Self {
            position: point.position,
            view,
            up: orientation::up_from_roll(view, orientation.roll.to_radians()),
            zoom: orientation.zoom,
        })
    }

    /// The corners of its picture, each so far from it: to the right above,
    /// and on the way round. The wider it sees, the wider and flatter it is.
    fn corners(&self, length: f64) -> [DVec3; 4] {
        let high = FILM[0] / self.zoom;
        let right = self.view.cross(self.up);
        [[1.0, 1.0], [-1.0, 1.0], [-1.0, -1.0], [1.0, -1.0]].map(|[x, y]| {
            let ray = self.view + right * (x * high * FILM[1]) + self.up * (y * high);
            self.position + orientation::unit(ray) * length
        })
    }
}

/// Draws a camera with edges of so many points: its pyramid, and a small roof
/// that shows what is up.
pub(super) fn camera(
    strokes: &mut Strokes<'_>,
    look: &Look<'_>,
    camera: &Camera,
    points: f64,
    width: f32,
    color: Color32,
) {
    let length = (points / look.projection.scale()).min(CAMERA[1] * points / CAMERA[0]);
    let corners = camera.corners(length);
    for k in 0..4 {
        strokes.line(camera.position, corners[k], width, color);
        strokes.line(corners[k], corners[(k + 1) % 4], width, color);
    }
    // The roof stands a little above the picture, so that the two are told apart.
    let [right, left] = [corners[0], corners[1]];
    let wide = left.distance(right);
    let roof = |share: f64, up: f64| left.lerp(right, share) + camera.up * (wide * up);
    let [left, ridge, right] = [roof(0.28, 0.08), roof(0.5, 0.3), roof(0.72, 0.08)];
    strokes.line(left, ridge, width, color);
    strokes.line(ridge, right, width, color);
    strokes.line(right, left, width, color);
}

/// Every orientation of the path as a small camera; the current one stands out.
pub(super) fn keys(document: &Document, look: &Look<'_>) -> Lines {
    let mut strokes = Strokes::new(look.projection, look.room);
    let Some(color) = look.of(Element::Cameras) else {
        return strokes.finish();
    };
    let selection = document.selection();
    let mut last: Option<DVec2> = None;
    for (index, point) in document.path().points.iter().enumerate() {
        let image = look.projection.image(point.position);
        let current = index == selection.point;
        if !current && last.is_some_and(|last| last.distance(image) < APART) {
            continue;
        }
        if !look.room.expand(40.0).contains(to_pos(image)) {
            continue;
        }
        last = Some(image);
        for number in 0..point.orientations.len() {
            if current && number == selection.orientation {
                continue;
            }
            if let Some(seen) = Camera::at(document, index, number) {
                camera(
                    &mut strokes,
                    look,
                    &seen,
                    CAMERA[0],
                    THIN,
                    color.gamma_multiply(0.8),
                );
            }
        }
    }
    if let Some(seen) = Camera::at(document, selection.point, selection.orientation) {
        let color = look.colours.of(Element::Segment);
        camera(&mut strokes, look, &seen, CAMERA[0] * 1.15, 1.4, color);
    }
    strokes.finish()
}

/// One pose of the ribbon.
#[derive(Clone, Copy, Debug)]
struct Rib {
    camera: Camera,
    /// A section begins here, or the path.
    begins: bool,
}

/// The poses that the ribbon is made of, kept as long as the path is the same.
///
/// They are counted from the beginning of each section, so that a section
/// which a change does not reach keeps its part of the ribbon as it is.
#[derive(Debug, Default)]
pub(super) struct Ribbon {
    revision: Option<u64>,
    ribs: Vec<Rib>,
    /// Frames, kept for their memory.
    frames: Vec<Pose>,
}

impl Ribbon {
    /// Brings the poses up to date.
    ///
    /// # Errors
    /// [`crate::Error::Memory`], or [`crate::Error::Limit`] if there are too
    /// many frames; there is no ribbon then.
    pub(super) fn update(&mut self, document: &Document) -> Result<()> {
        let revision = document.revision();
        if self.revision == Some(revision) {
            return Ok(());
        }
        self.ribs.clear();
        if document.in_step() && document.path().points.len() > MANY_POINTS {
            self.revision = None;
            return Ok(());
        }
        self.revision = Some(revision);
        let sampler = document.sampler()?;
        document.timeline(|timeline| self.collect(timeline, sampler))?
    }

    fn collect(&mut self, timeline: &Timeline, sampler: &Sampler) -> Result<()> {
        let last = sampler.frame_count();
        // A power of two, so that one frame more does not shift all others.
        let stride = last.div_ceil(POSES).next_power_of_two();
        let sections = if timeline.section_count() < POSES {
            timeline.section_count()
        } else {
            0
        };
        self.ribs.try_reserve(last / stride + sections + 2)?;
        self.frames.clear();
        if last <= ALL_AT_ONCE {
            self.frames.try_reserve(last)?;
            self.frames.resize(last, Pose::default());
            sampler.sample(1, &mut self.frames)?;
        }
        let (ribs, frames) = (&mut self.ribs, &self.frames);
        let mut add = |frame: usize, begins: bool| -> Result<()> {
            let pose = match frames.get(frame - 1) {
                Some(&pose) => pose,
                #[allow(clippy::cast_precision_loss)]
                None => sampler.pose(frame as f64)?,
            };
            let camera = pose.into();
            ribs.push(Rib { camera, begins });
            Ok(())
        };
        add(1, true)?;
        let mut end = 1;
        for section in 0..sections {
            let count = timeline.section(section).frames;
            if timeline.section(section).change == Change::Nothing {
                continue;
            }
            let first = sampler.first_frame(section);
            end = first + count - 1;
            for frame in (first - 1 + stride..end).step_by(stride) {
                add(frame, false)?;
            }
            add(end, true)?;
        }
        // Of very many sections one sees nothing; and the last key may rest.
        for frame in (end + stride..last).step_by(stride) {
            add(frame, false)?;
        }
        if end < last {
            add(last, true)?;
        }
        Ok(())
    }

    /// The poses that it is made of.
    #[cfg(test)]
    pub(super) fn poses(&self) -> impl ExactSizeIterator<Item = Camera> {
        self.ribs.iter().map(|rib| rib.camera)
    }

    /// Paints it.
    pub(super) fn paint(&self, painter: &Painter, look: &Look<'_>) {
        let Some(color) = look.of(Element::Ribbon) else {
            return;
        };
        let mut strokes = Strokes::new(look.projection, look.room);
        let mut mesh = Mesh::default();
        let surface = color.gamma_multiply(0.13);
        let (edge, fringe) = (color.gamma_multiply(0.5), color.gamma_multiply(0.6));
        let mut last: Option<[DVec3; 2]> = None;
        // On the screen: since the last thread of the fringe, and since the
        // section began.
        let (mut since_thread, mut since_begin) = (f64::INFINITY, 0.0);
        for Rib { camera, begins } in &self.ribs {
            let ends = [camera.position, camera.position + camera.up * RIBBON];
            if let Some(before) = last {
                let way = [0, 1].map(|k| look.projection.image_of_way(ends[k] - before[k]));
                let way = way[0].length().max(way[1].length());
                let long = *begins && since_begin + way >= THREAD;
                if way < STEP && !long {
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
            if *begins {
                since_begin = 0.0;
            }
            if since_thread >= THREAD {
                since_thread = 0.0;
                strokes.line(ends[1], ends[1] + camera.view * FRINGE, THIN, fringe);
            }
            last = Some(ends);
        }
        if !mesh.is_empty() {
            painter.add(Shape::mesh(mesh));
        }
        painter.add(Lines::shape(&Arc::new(strokes.finish()), look.room));
    }
}

/// A piece of the ribbon, if it is seen.
fn add_quad(
    mesh: &mut Mesh,
    look: &Look<'_>,
    before: [DVec3; 2],
    ends: [DVec3; 2],
    color: Color32,
) {
    let corners = [before[0], before[1], ends[1], ends[0]].map(|p| look.projection.pos(p));
    if !corners.iter().any(|&corner| look.room.contains(corner)) {
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
