//! The scene in which a path is edited: everything but the path of that one node.
//!
//! Where no node is edited, a stand-in path lasts as long as the scene and refuses edits. A record
//! of the history exchanges all of it at once ([`super::change`]).

use std::collections::VecDeque;
use std::mem::swap;
use std::sync::Arc;
use std::sync::atomic::{AtomicU64, Ordering};

use vides_engine::scene::{FollowPath, Part, Scene};

use super::normalise::{move_into, normalise};
use super::vid::alone::alone;
use super::vid::comments;
use crate::error::{Invalid, OutOfRange, Refused, Result, can_allocate, vec_with_room};
use vides_engine::limits::MAX_FRAMES;
use vides_engine::path::fit_frames::fit_frames;
use vides_engine::path::{CameraPath, Timeline};

/// A scene, and the node whose path is edited.
#[derive(Debug, Clone)]
pub struct EditedScene {
    /// Holds the edited path as it was when the node was chosen.
    scene: Arc<Scene>,
    number: u64,
    meshes: u64,
    pins: Pins,
    /// The newest changes: the number before, and the one node that differs since; none: more.
    changed: VecDeque<(u64, Option<usize>)>,
    numbering: u64,
    /// The newest nodes that came or went: the numbering before, and their places.
    renumbered: VecDeque<(u64, Moved)>,
}

#[derive(Debug, Clone)]
enum Moved {
    Came(Vec<usize>),
    Went(Vec<usize>),
}

/// Changes that are remembered.
const REMEMBERED: usize = 32;

/// The path of another node, or a stand-in, and its pins.
pub(super) fn other_path(scene: &Scene, node: Option<usize>) -> Result<(CameraPath, Pins)> {
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
    let pins = Pins::of(scene, node)?;
    Ok((path, pins))
}

/// A scene set up to edit the path of a node, and that path.
pub(super) fn edit(scene: Scene, node: Option<usize>) -> Result<(EditedScene, CameraPath)> {
    let (path, pins) = other_path(&scene, node)?;
    Ok((EditedScene::new(scene, pins)?, path))
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
    fn new(scene: Scene, pins: Pins) -> Result<Self> {
        can_allocate(size_of::<Scene>() + 64)?;
        let mut changed = VecDeque::new();
        changed.try_reserve_exact(REMEMBERED)?;
        Ok(Self {
            scene: Arc::new(scene),
            number: fresh_revision(),
            meshes: fresh_revision(),
            pins,
            changed,
            numbering: fresh_revision(),
            renumbered: VecDeque::new(),
        })
    }

    /// The scene of a path alone, which is edited.
    pub(super) fn of_path(path: CameraPath) -> Result<Self> {
        let scene = Scene::of_path(path)?;
        let pins = Pins::of(&scene, Some(0))?;
        Self::new(scene, pins)
    }

    /// Exchanges a part of the scene.
    pub(super) fn exchange(&mut self, part: &mut Part) -> Result<()> {
        if Arc::get_mut(&mut self.scene).is_none() {
            // A copy of the document has it, too.
            can_allocate(self.scene.heap_size())?;
        }
        let node = part.node();
        Arc::make_mut(&mut self.scene).exchange(part)?;
        match part {
            // What is to be removed has come.
            Part::Remove(places) => {
                self.pins.node = self.pins.node.map(|node| came(places, node));
                self.renumber(places, Moved::Came);
            }
            Part::Insert(list) => {
                self.pins.node = self.pins.node.and_then(|node| went(list.places(), node));
                self.renumber(list.places(), Moved::Went);
            }
            _ => {}
        }
        if matches!(part, Part::Insert(_) | Part::Remove(_) | Part::Mesh { .. }) {
            self.meshes = fresh_revision();
        }
        self.renew(node);
        Ok(())
    }

    fn renumber(&mut self, places: &[usize], moved: fn(Vec<usize>) -> Moved) {
        let before = std::mem::replace(&mut self.numbering, fresh_revision());
        if self.renumbered.len() == REMEMBERED {
            self.renumbered.pop_front();
        }
        let mut copy = Vec::new();
        let room = copy.try_reserve_exact(places.len()).is_ok();
        if room && self.renumbered.try_reserve(1).is_ok() {
            copy.extend_from_slice(places);
            self.renumbered.push_back((before, moved(copy)));
        } else {
            // Nobody can tell what came before.
            self.renumbered.clear();
        }
    }

    /// Changes whenever nodes come or go, and so get other numbers.
    #[must_use]
    pub const fn numbering(&self) -> u64 {
        self.numbering
    }

    /// The numbers that nodes have now which had these when [`EditedScene::numbering`] was `since`;
    /// none for those that have gone. None at all: it was in another scene, or too long ago.
    #[must_use]
    pub fn renumbered(&self, nodes: &[usize], since: u64) -> Option<Vec<Option<usize>>> {
        let mut all: Vec<Option<usize>> = nodes.iter().copied().map(Some).collect();
        if since == self.numbering {
            return Some(all);
        }
        let begin = self.renumbered.iter().position(|moved| moved.0 == since)?;
        for (_, moved) in self.renumbered.range(begin..) {
            for node in &mut all {
                *node = node.and_then(|node| match moved {
                    Moved::Came(places) => Some(came(places, node)),
                    Moved::Went(places) => went(places, node),
                });
            }
        }
        Some(all)
    }

    /// Exchanges the pins, with the number of the node whose path is edited.
    pub(super) fn exchange_pins(&mut self, pins: &mut Pins) {
        swap(&mut self.pins, pins);
        if self.pins.node != pins.node {
            self.renew(self.pins.node.or(pins.node));
        }
    }

    fn renew(&mut self, changed: Option<usize>) {
        if self.changed.len() == REMEMBERED {
            self.changed.pop_front();
        }
        self.changed.push_back((self.number, changed));
        self.number = fresh_revision();
    }

    /// Brings a copy of the present scene up to date, which was one when [`EditedScene::number`] was
    /// `since`: where single nodes have changed by taking over those.
    ///
    /// # Errors
    /// As [`EditedScene::replace_path`].
    pub fn update(&self, copy: &mut Scene, since: u64, path: &CameraPath) -> Result<()> {
        let begin = self.changed.iter().position(|change| change.0 == since);
        let newer = match begin {
            Some(begin) => self.changed.range(begin..),
            None => self.changed.range(..0),
        };
        let known = since == self.number || begin.is_some();
        if known && newer.clone().all(|(_, node)| node.is_some()) {
            for &(_, node) in newer {
                node.map_or(Ok(()), |node| copy.take_over(node, &self.scene))?;
            }
            return self.replace_path(copy, path);
        }
        *copy = self.with(path)?;
        Ok(())
    }

    /// The scene; the edited path in it is as it was when the node was chosen.
    #[must_use]
    pub fn scene(&self) -> &Scene {
        &self.scene
    }

    /// The number of the node whose path is edited, if any.
    #[must_use]
    pub const fn node(&self) -> Option<usize> {
        self.pins.node
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

    /// Approximate bytes that a copy of the scene takes.
    pub(super) fn weight(&self) -> usize {
        self.scene.heap_size()
    }

    /// The edited node's path as it is now with what follows it; none: the scene has it so.
    pub(super) fn present_path(&self, path: &CameraPath) -> Result<Option<FollowPath>> {
        let (Some(node), Some(follow)) = (self.node(), self.follow()) else {
            return Ok(None);
        };
        if follow.path() == path && self.pins.are_those_of(&self.scene, node) {
            return Ok(follow.held(&self.pins())?);
        }
        let (start, beyond) = (follow.start_frame(), follow.extrapolation());
        let follow = FollowPath::new(path.try_clone()?, start, beyond)?;
        Ok(Some(follow.held(&self.pins())?.unwrap_or(follow)))
    }

    /// The points of the edited path that are pinned, each with its marker.
    pub fn pinned(&self) -> impl Iterator<Item = (usize, String)> + use<'_> {
        self.pins.there()
    }

    pub(super) fn pins_there(&self) -> impl Iterator<Item = (usize, String)> + use<'_> {
        self.pins.there()
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

    /// The pins with that of a point set or removed.
    pub(super) fn pins_with(&self, point: usize, marker: Option<String>) -> Result<Pins> {
        let mut pins = vec_with_room(self.pins.all.len() + 1)?;
        let other = |pin: &&Pinned| pin.parked != 0 || pin.point != point;
        pins.extend(self.pins.all.iter().filter(other).cloned());
        pins.extend(marker.map(|marker| Pinned {
            point,
            marker,
            parked: 0,
        }));
        pins.sort_by_key(|pin| pin.point);
        Ok(self.pins.with(pins))
    }

    /// The pins with those to a marker at another one, or without them; none: they stay.
    pub(super) fn pins_renamed(&self, marker: &str, to: Option<&str>) -> Result<Option<Pins>> {
        if self.pins.all.iter().all(|pin| pin.marker != marker) {
            return Ok(None);
        }
        let mut pins = vec_with_room(self.pins.all.len())?;
        pins.extend(self.pins.all.iter().filter_map(|pin| {
            let mut pin = pin.clone();
            if pin.marker == marker {
                to?.clone_into(&mut pin.marker);
            }
            Some(pin)
        }));
        Ok(Some(self.pins.with(pins)))
    }

    fn follow(&self) -> Option<&FollowPath> {
        self.scene.nodes()[self.node()?].path()
    }

    /// The path's first frame in the scene, unless a pin determines it.
    pub(super) fn start_frame(&self) -> f64 {
        let follow = self.follow().map(FollowPath::start_frame);
        follow.unwrap_or_else(|| self.scene.frame_range().0)
    }

    /// Replaces the edited node's path in `scene`, a copy of this scene.
    ///
    /// # Errors
    /// As [`FollowPath::new`].
    pub fn replace_path(&self, scene: &mut Scene, path: &CameraPath) -> Result<()> {
        if let (Some(node), Some(follow)) = (self.node(), self.follow())
            && (scene.nodes()[node].path().map(FollowPath::path) != Some(path)
                || !self.pins.are_those_of(scene, node)
                || scene.path_held_by_pins(node)?.is_some())
        {
            let (start, beyond) = (follow.start_frame(), follow.extrapolation());
            let follow = FollowPath::new(path.try_clone()?, start, beyond)?;
            scene.set_pinned_path(node, follow, self.pins.there())?;
        }
        Ok(())
    }

    pub(super) fn pins(&self) -> Vec<(usize, f64)> {
        let there = self.pins.there();
        let pins = there.filter_map(|(point, name)| Some((point, self.scene.marker(&name)?)));
        pins.collect()
    }

    pub(super) const fn pins_mut(&mut self) -> &mut Pins {
        &mut self.pins
    }

    /// The pins of a path of `count` points that takes the place of this one; `number` is the one
    /// that a point gets in it. Pins of points that it lacks go.
    pub(super) fn pins_in(&self, count: usize, number: impl Fn(usize) -> usize) -> Result<Pins> {
        let mut pins = vec_with_room(self.pins.all.len())?;
        let there = self.pins.there().map(|(point, marker)| Pinned {
            point: number(point),
            marker,
            parked: 0,
        });
        pins.extend(there.filter(|pin| pin.point < count));
        pins.sort_by_key(|pin: &Pinned| pin.point);
        Ok(self.pins.with(pins))
    }

    pub(super) fn with(&self, path: &CameraPath) -> Result<Scene> {
        can_allocate(self.scene.heap_size())?;
        let mut scene = Scene::clone(&self.scene);
        self.replace_path(&mut scene, path)?;
        Ok(scene)
    }
}

/// The node whose path is edited, if any; points of the path and the markers at which they are
/// reached. Pins follow inserted and removed points; undoing a removal restores them.
#[derive(Debug, Clone)]
pub(super) struct Pins {
    node: Option<usize>,
    all: Vec<Pinned>,
}

#[derive(Debug, Clone)]
struct Pinned {
    point: usize,
    marker: String,
    /// The removal that took its point away; 0: it is there. See [`comments::Comments`].
    parked: u64,
}

impl Pins {
    fn of(scene: &Scene, node: Option<usize>) -> Result<Self> {
        let mine = || scene.pins().iter().filter(|pin| Some(pin.node) == node);
        let mut pins = vec_with_room(mine().count())?;
        pins.extend(mine().map(|pin| Pinned {
            point: pin.point,
            marker: pin.marker.clone(),
            parked: 0,
        }));
        Ok(Self { node, all: pins })
    }

    const fn with(&self, all: Vec<Pinned>) -> Self {
        Self {
            node: self.node,
            all,
        }
    }

    fn there(&self) -> impl Iterator<Item = (usize, String)> + '_ {
        let there = self.all.iter().filter(|pin| pin.parked == 0);
        there.map(|pin| (pin.point, pin.marker.clone()))
    }

    fn are_those_of(&self, scene: &Scene, node: usize) -> bool {
        let theirs = scene.pins().iter().filter(|pin| pin.node == node);
        theirs
            .map(|pin| (pin.point, pin.marker.clone()))
            .eq(self.there())
    }

    pub(super) fn insert_points(&mut self, at: usize, count: usize, removal: u64) {
        for pin in &mut self.all {
            comments::insert_points(&mut pin.point, &mut pin.parked, at, count, removal);
        }
        self.all.sort_by_key(|pin| pin.point);
    }

    pub(super) fn remove_points(&mut self, at: usize, count: usize, removal: u64) {
        for pin in &mut self.all {
            comments::remove_points(&mut pin.point, &mut pin.parked, at, count, removal);
        }
    }
}

/// The next [`crate::Document::revision`]: unique but unordered, so relaxed ordering is enough.
pub(super) fn fresh_revision() -> u64 {
    static NEXT: AtomicU64 = AtomicU64::new(1);
    NEXT.fetch_add(1, Ordering::Relaxed)
}

/// The number that a node has when others have come to these places, in rising order.
pub(super) fn came(places: &[usize], node: usize) -> usize {
    // How many come to places before it, each of which puts it one further.
    let (mut low, mut high) = (0, places.len());
    while low < high {
        let middle = low.midpoint(high);
        if places[middle] <= node + middle {
            low = middle + 1;
        } else {
            high = middle;
        }
    }
    node + low
}

/// The number that a node has when those at these places, in rising order, have gone.
pub(super) fn went(places: &[usize], node: usize) -> Option<usize> {
    let before = places.partition_point(|&place| place < node);
    (places.get(before) != Some(&node)).then_some(node - before)
}

#[cfg(test)]
#[path = "edited_scene_tests.rs"]
mod tests;
