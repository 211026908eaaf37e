//! The orientations of the whole path as small cameras (wished for in the thesis's chapter 8), with
//! [`super::ribbon`] between them.

use std::sync::Arc;

use egui::Color32;
use glam::{DVec2, DVec3};
use vides_document::Document;
use vides_engine::math::orientation;
use vides_engine::math::view::HALF_FILM_HEIGHT;
use vides_engine::path::{Pose, ahead};
use vides_raster::Lines;

use super::projection::to_pos;
use super::scene::{Look, LookKey, THIN};
use super::strokes::Strokes;
use crate::setup::Element;

/// Length of a camera's edges: in points, and at most in units of the space's `half_size`.
const CAMERA: [f64; 2] = [26.0, 0.16];

/// Cameras nearer than this to the last one are left out, in points.
const APART: f64 = 14.0;

/// How much of their colour those of other points have.
const FADED: f32 = 0.45;

/// Width by height of the picture of a drawn camera.
const ASPECT: f64 = 1.5;

#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Camera {
    pub(crate) position: DVec3,
    pub(crate) view: DVec3,
    pub(crate) up: DVec3,
    pub(crate) zoom: f64,
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

impl From<Camera> for Pose {
    fn from(camera: Camera) -> Self {
        Self {
            vrp: camera.position.to_array(),
            vpn: camera.view.to_array(),
            vup: camera.up.to_array(),
            zoom: camera.zoom,
        }
    }
}

impl Camera {
    pub(crate) fn at(document: &Document, point: usize, number: usize) -> Option<Self> {
        let index = point;
        let point = document.path().points.get(index)?;
        let orientation = point.orientations.get(number)?;
        Some(Self {
            position: point.position,
            view: ahead::view(document.path(), index, number),
            up: document.up(index, number).ok()?,
            zoom: orientation.zoom,
        })
    }

    /// The corners of its picture, each `length` away, counterclockwise from the upper right.
    fn corners(&self, length: f64) -> [DVec3; 4] {
        [[1.0, 1.0], [-1.0, 1.0], [-1.0, -1.0], [1.0, -1.0]]
            .map(|[x, y]| self.position + orientation::unit(self.ray(x, y, ASPECT)) * length)
    }

    /// Half the height of its picture at distance 1.
    pub(super) fn half_height(&self) -> f64 {
        HALF_FILM_HEIGHT / self.zoom
    }

    /// The direction, of any length, to a place of its picture, from −1 to 1 to the right and up.
    pub(super) fn ray(&self, x: f64, y: f64, aspect: f64) -> DVec3 {
        let high = self.half_height();
        let right = self.view.cross(self.up);
        self.view + right * (x * high * aspect) + self.up * (y * high)
    }
}

/// Draws a camera with edges of `points`: its pyramid, and a small roof that shows what is up.
pub(super) fn camera(
    strokes: &mut Strokes<'_>,
    look: &Look<'_>,
    camera: &Camera,
    points: f64,
    width: f32,
    color: Color32,
) {
    let length = (points / look.projection.scale()).min(CAMERA[1] * points / CAMERA[0]);
    let corners = camera.corners(length * look.projection.space().half_size);
    for k in 0..4 {
        strokes.line(camera.position, corners[k], width, color);
        strokes.line(corners[k], corners[(k + 1) % 4], width, color);
    }
    // A little above the picture, so that the two are told apart.
    let [right, left] = [corners[0], corners[1]];
    let wide = left.distance(right);
    let roof = |share: f64, up: f64| left.lerp(right, share) + camera.up * (wide * up);
    let [left, ridge, right] = [roof(0.28, 0.08), roof(0.5, 0.3), roof(0.72, 0.08)];
    strokes.line(left, ridge, width, color);
    strokes.line(ridge, right, width, color);
    strokes.line(right, left, width, color);
}

/// Small cameras of all points but the current one; made again only when others are seen.
#[derive(Debug, Default)]
pub(crate) struct KeyCameras {
    seen: Option<LookKey>,
    cameras: Vec<Camera>,
    /// Those of this pass, kept for their allocation.
    now: Vec<Camera>,
    lines: Arc<Lines>,
}

impl KeyCameras {
    pub(super) fn update(&mut self, document: &Document, look: &Look<'_>) -> &Arc<Lines> {
        self.now.clear();
        if look.shown.has(Element::Cameras) {
            collect(document, look, &mut self.now);
        }
        let seen = Some(look.key());
        if self.now != self.cameras || self.seen != seen {
            let mut strokes = Strokes::in_space(look);
            let color = look.colours.of(Element::Cameras).gamma_multiply(FADED);
            for seen in &self.now {
                camera(&mut strokes, look, seen, CAMERA[0], THIN, color);
            }
            self.lines = Arc::new(strokes.finish());
            std::mem::swap(&mut self.cameras, &mut self.now);
            self.seen = seen;
        }
        &self.lines
    }
}

/// The first camera of each point but the current one, if in sight and not too near another.
fn collect(document: &Document, look: &Look<'_>, cameras: &mut Vec<Camera>) {
    let selection = document.selection();
    let viewport = look.viewport.expand(40.0);
    let mut last: Option<DVec2> = None;
    for (index, point) in document.path().points.iter().enumerate() {
        let image = look.projection.image(point.position);
        let current = index == selection.point;
        if !current && last.is_some_and(|last| last.distance(image) < APART) {
            continue;
        }
        if !viewport.contains(to_pos(image)) {
            continue;
        }
        last = Some(image);
        // Only the first: several at one point would hide each other.
        if !current {
            cameras.extend(Camera::at(document, index, 0));
        }
    }
}

/// The current orientation as a camera that stands out.
pub(super) fn current_key(document: &Document, look: &Look<'_>) -> Lines {
    let mut strokes = Strokes::new(look.projection, look.viewport);
    let selection = document.selection();
    if look.shown.has(Element::Cameras)
        && let Some(seen) = Camera::at(document, selection.point, selection.orientation)
    {
        let color = look.colours.of(Element::Segment);
        camera(&mut strokes, look, &seen, CAMERA[0] * 1.15, 1.4, color);
    }
    strokes.finish()
}
