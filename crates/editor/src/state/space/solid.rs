//! The faces of objects as they were seen last.

use std::sync::Arc;

use egui::{Color32, Rect};
use glam::{DMat4, DVec3};
use vides_document::Object;
use vides_engine::scene::Mesh;
use vides_raster::Surfaces;

/// The picture that was made last.
#[derive(Debug, Default)]
pub(crate) struct Solid {
    pub(crate) made: Option<Key>,
    pub(crate) object: Object,
    /// When it last was another, in seconds of the context.
    pub(crate) changed: f64,
    pub(crate) quick: bool,
    pub(crate) sight: Option<Sight>,
    pub(crate) number: u64,
}

/// What is seen of all faces.
#[derive(Clone, Debug)]
pub(crate) struct Sight {
    pub(crate) eye: Eye,
    pub(crate) surfaces: Arc<Surfaces>,
    /// The lines on the faces, those behind faces left out.
    pub(crate) edges: Arc<Vec<[DVec3; 2]>>,
    /// Tells it from all others of its [`Solid`].
    pub(crate) number: u64,
}

/// All that a picture depends on.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Key {
    pub(crate) eye: Eye,
    pub(crate) colours: [Color32; 2],
    /// The address of what [`Solid::object`] holds.
    pub(crate) object: *const Mesh,
    /// The scene, and where its objects are.
    pub(crate) scene: Option<(u64, Vec<f64>)>,
}

/// How a picture is seen.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Eye {
    /// From coordinates of the path, or of the world, to pixels of the screen and nearness, times w.
    pub(crate) matrix: DMat4,
    /// Where w is less, it is behind the viewer.
    pub(crate) front: f64,
    /// What lies this much behind a face is on it: absolute, and as a share of its nearness.
    pub(crate) slack: [f64; 2],
    /// From where the viewer's light comes, see `space::projection::lights`.
    pub(crate) lights: [DVec3; 2],
    /// The picture, in points, and its pixels.
    pub(crate) rect: Rect,
    pub(crate) pixels_per_point: f64,
    /// In the coordinates of the path, not of the world.
    pub(crate) of_path: bool,
}
