//! The scene in which a path is edited: everything but the path of that one node.
//!
//! Where no node is edited, a stand-in path lasts as long as the scene and refuses edits.

use std::sync::atomic::{AtomicU64, Ordering};

use vides_engine::scene::{FollowPath, Node, Part, Scene};

use super::normalise::{move_into, normalise};
use super::vid::alone::alone;
use crate::error::{Invalid, OutOfRange, Refused, Result};
use vides_engine::limits::MAX_FRAMES;
use vides_engine::path::fit_frames::fit_frames;
use vides_engine::path::{CameraPath, Timeline};

/// A scene, and the node whose path is edited.
#[derive(Debug, Clone)]
pub struct EditedScene {
    /// Holds the edited path as it was when the node was chosen.
    scene: Scene,
    /// The node whose path is edited, if any.
    node: Option<usize>,
    /// Points of that path with the markers at which they are reached, in the order of the points.
    pins: Vec<(usize, String)>,
    number: u64,
    meshes: u64,
}

/// The path of another node, or a stand-in.
fn path_of(scene: &Scene, node: Option<usize>) -> Result<CameraPath> {
    let mut path = match node {
        Some(at) => {
            let node = scene.node(at)?;
            let follow = node
                .path()
                .ok_or_else(|| Refused::NoPathOf((&node.name).into()))?;
            follow.path().try_clone()?
        }
        None => stand_in(scene)?,
    };
    normalise(&mut path)?;
    Ok(path)
}

/// The pins of a node.
fn pins_of(scene: &Scene, node: Option<usize>) -> Vec<(usize, String)> {
    let mine = scene.pins().iter().filter(|pin| Some(pin.node) == node);
    mine.map(|pin| (pin.point, pin.marker.clone())).collect()
}

/// A scene set up to edit the path of a node, and that path.
pub(super) fn edit(scene: Scene, node: Option<usize>) -> Result<(EditedScene, CameraPath)> {
    let path = path_of(&scene, node)?;
    Ok((EditedScene::new(scene, node), path))
}

/// A scene as first edited: the shown camera's path, if it has one.
pub(super) fn as_shown(scene: Scene) -> Result<(EditedScene, CameraPath)> {
    let shown = scene.shown_camera();
    let node = shown.filter(|&at| scene.nodes()[at].path().is_some());
    edit(scene, node)
}

fn stand_in(scene: &Scene) -> Result<CameraPath> {
    let (first, last) = scene.frame_range();
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)]
    let frames = ((last - first).floor() as usize + 1).clamp(2, MAX_FRAMES);
    let mut path = CameraPath::try_new()?;
    move_into(&mut path, scene.space())?;
    let timeline = Timeline::new(&path)?;
    for fixed in fit_frames(&path, &timeline, 0, path.points.len() - 1, frames)? {
        let view = &mut path.points[fixed.point].orientations[fixed.orientation];
        view.own = view.own.with(|own| own.frames = fixed.frames)?;
    }
    Ok(path)
}

impl EditedScene {
    fn new(scene: Scene, node: Option<usize>) -> Self {
        Self {
            pins: pins_of(&scene, node),
            scene,
            node,
            number: fresh_revision(),
            meshes: fresh_revision(),
        }
    }

    /// The scene of a path alone, which is edited.
    pub(super) fn of_path(path: &CameraPath) -> Result<Self> {
        Ok(Self::new(Scene::of_path(path.try_clone()?)?, Some(0)))
    }

    /// Makes a part of the scene what it says.
    pub(super) fn apply(&mut self, part: Part) -> Result<()> {
        let of_meshes = matches!(part, Part::Remove(_) | Part::Mesh { .. });
        let edited = self.node.map(|node| self.scene.ids()[node]);
        self.scene.apply(part)?;
        self.node = edited.and_then(|id| self.scene.number_of(id));
        self.renew(of_meshes);
        Ok(())
    }

    /// Adds nodes behind the others.
    pub(super) fn add(&mut self, nodes: Vec<Node>) -> Result<()> {
        self.scene.add_all(nodes)?;
        self.renew(true);
        Ok(())
    }

    fn renew(&mut self, meshes: bool) {
        self.number = fresh_revision();
        if meshes {
            self.meshes = self.number;
        }
    }

    /// Puts the edited path into the scene as it is now.
    pub(super) fn synchronise(&mut self, path: &CameraPath) -> Result<()> {
        self.scene = self.with(path)?;
        self.renew(false);
        Ok(())
    }

    /// Edits the path of another node, which it returns, or a stand-in for none.
    pub(super) fn choose(&mut self, node: Option<usize>) -> Result<CameraPath> {
        let path = path_of(&self.scene, node)?;
        (self.node, self.pins) = (node, pins_of(&self.scene, node));
        self.renew(false);
        Ok(path)
    }

    /// Brings a copy of the scene up to date. What is prepared of nodes that are the same stays.
    ///
    /// # Errors
    /// As [`FollowPath::new`].
    pub fn update(&self, copy: &mut Scene, path: &CameraPath) -> Result<()> {
        let edited = self
            .node
            .and_then(|node| copy.number_of(self.scene.ids()[node]));
        let known = edited.and_then(|node| copy.nodes()[node].path().cloned());
        copy.become_scene(&self.scene);
        self.put_path(copy, path, known)
    }

    /// The scene; the edited path in it is as it was when the node was chosen.
    #[must_use]
    pub fn scene(&self) -> &Scene {
        &self.scene
    }

    /// The number of the node whose path is edited, if any.
    #[must_use]
    pub const fn node(&self) -> Option<usize> {
        self.node
    }

    /// Unique to this scene: equal numbers mean that all but the edited path is equal.
    #[must_use]
    pub const fn number(&self) -> u64 {
        self.number
    }

    /// As [`EditedScene::number`], of the nodes' numbers and meshes alone.
    #[must_use]
    pub const fn meshes(&self) -> u64 {
        self.meshes
    }

    pub(super) fn is_path_alone(&self) -> bool {
        alone(&self.scene).is_some()
    }

    /// About how many bytes it takes that another one does not share.
    pub(super) fn heap_size_without(&self, other: Option<&Self>) -> usize {
        if other.is_some_and(|other| std::ptr::eq(self, other)) {
            return 0;
        }
        let names = self.pins.iter().map(|pin| pin.1.len());
        let pins = size_of_val(&self.pins[..]) + names.sum::<usize>();
        let none = Scene::new();
        let other = other.map_or(&none, |other| &other.scene);
        size_of::<Self>() + pins + self.scene.heap_size_without(other)
    }

    /// The points of the edited path that are pinned, each with its marker.
    pub fn pinned(&self) -> impl Iterator<Item = (usize, String)> + use<'_> {
        self.pins.iter().cloned()
    }

    pub(super) fn check_pin(
        &self,
        path: &CameraPath,
        point: usize,
        marker: Option<&str>,
    ) -> Result<()> {
        let count = path.points.len();
        if point >= count {
            let nodes = self.scene.nodes();
            let name = self.node().map_or("", |node| &nodes[node].name);
            return Err(OutOfRange::NoPathPoint {
                node: name.into(),
                point,
                count,
            }
            .into());
        }
        match marker.filter(|marker| self.scene.marker(marker).is_none()) {
            Some(marker) => Err(Invalid::NoMarker(marker.into()).into()),
            None => Ok(()),
        }
    }

    /// Pins a point of the edited path to a marker, or frees it.
    pub(super) fn pin(&mut self, point: usize, marker: Option<String>) {
        self.pins.retain(|pin| pin.0 != point);
        self.pins.extend(marker.map(|marker| (point, marker)));
        self.pins.sort_by_key(|pin| pin.0);
    }

    /// The pins to a marker go to another one, or go.
    pub(super) fn rename_pins(&mut self, marker: &str, to: Option<&str>) {
        self.pins.retain_mut(|pin| {
            if pin.1 == marker {
                match to {
                    Some(to) => to.clone_into(&mut pin.1),
                    None => return false,
                }
            }
            true
        });
    }

    /// Pins follow points that have other numbers now, or none.
    pub(super) fn renumber_pins(&mut self, number: impl Fn(usize) -> Option<usize>) {
        self.pins.retain_mut(|pin| match number(pin.0) {
            Some(new) => {
                pin.0 = new;
                true
            }
            None => false,
        });
        self.pins.sort_by_key(|pin| pin.0);
    }

    fn follow(&self) -> Option<&FollowPath> {
        self.scene.nodes()[self.node()?].path()
    }

    /// The path's first frame in the scene, unless a pin determines it.
    pub(super) fn start_frame(&self) -> f64 {
        let follow = self.follow().map(FollowPath::start_frame);
        follow.unwrap_or_else(|| self.scene.frame_range().0)
    }

    /// Puts the edited path into `scene`, a copy of this scene; `known`: as it was in it before.
    fn put_path(
        &self,
        scene: &mut Scene,
        path: &CameraPath,
        known: Option<FollowPath>,
    ) -> Result<()> {
        let (Some(node), Some(follow)) = (self.node(), self.follow()) else {
            return Ok(());
        };
        let there = scene.nodes()[node].path().map(FollowPath::path);
        if there == Some(path)
            && pins_of(scene, Some(node)) == self.pins
            && scene.path_held_by_pins(node)?.is_none()
        {
            return Ok(());
        }
        let (start, beyond) = (follow.start_frame(), follow.extrapolation());
        let same = |known: &FollowPath| {
            known.path() == path && (known.start_frame(), known.extrapolation()) == (start, beyond)
        };
        let follow = match known.filter(same) {
            Some(known) => known,
            None => FollowPath::new(path.try_clone()?, start, beyond)?,
        };
        Ok(scene.set_pinned_path(node, follow, self.pinned())?)
    }

    /// The pinned points of the edited path, with their frames.
    pub(super) fn pins(&self) -> Vec<(usize, f64)> {
        let pins = self.pins.iter();
        let pins = pins.filter_map(|(point, name)| Some((*point, self.scene.marker(name)?)));
        pins.collect()
    }

    /// The scene with the edited path as it is now.
    pub(super) fn with(&self, path: &CameraPath) -> Result<Scene> {
        let mut scene = self.scene.clone();
        self.put_path(&mut scene, path, None)?;
        Ok(scene)
    }
}

/// The next [`crate::Document::revision`]: unique but unordered, so relaxed ordering is enough.
pub(super) fn fresh_revision() -> u64 {
    static NEXT: AtomicU64 = AtomicU64::new(1);
    NEXT.fetch_add(1, Ordering::Relaxed)
}

#[cfg(test)]
#[path = "edited_scene_tests.rs"]
mod tests;
