//! From an edit of the scene to its records: what must go along with the part that is exchanged.
//!
//! The path that is edited lives beside the scene ([`super::edited_scene`]), which has it as it was
//! when its node was chosen. Where an edit needs it as it is now, it is put there first.

use vides_engine::scene::{
    Channel, FollowPath, Keep, KeyList, Kind, Node, NodeList, Part, Rest, Scene, Track, Warnings,
};

use super::change::{Change, IDLE, Prepared, State, Whole};
use super::edit::Selection;
use super::edited_scene::{EditedScene, Pins, other_path};
use super::whole::replaced;
use crate::error::{Error, Invalid, Result, can_allocate, vec_with_room};
use vides_engine::path::CameraPath;

/// The records of an edit, and the scene as they find it.
struct Steps<'a> {
    state: &'a State,
    edited: &'a EditedScene,
    changes: Vec<Change>,
    selection: Option<Selection>,
}

/// The record of an edit of a scene; a path becomes one first.
pub(super) fn prepare(
    state: &State,
    edit: impl FnOnce(&mut Edits<'_, '_>) -> Result<()>,
) -> Result<Prepared> {
    let fresh = match &state.edited_scene {
        Some(_) => None,
        None => Some(EditedScene::of_path(state.path.try_clone()?)?),
    };
    let Some(edited) = fresh.as_ref().or(state.edited_scene.as_deref()) else {
        return Ok((IDLE, None));
    };
    let mut steps = Steps {
        state,
        edited,
        changes: Vec::new(),
        selection: None,
    };
    edit(&mut Edits(&mut steps))?;
    let (mut changes, selection) = (steps.changes, steps.selection);
    if changes.iter().all(|change| change.has(edited.scene())) {
        return Ok((IDLE, None));
    }
    if let Some(fresh) = fresh {
        changes.try_reserve(1)?;
        changes.insert(0, Change::scene(Some(fresh), &state.comments)?);
    }
    let change = match changes.len() {
        1 => changes.remove(0),
        _ => Change::Several(changes),
    };
    Ok((change, selection))
}

/// What edits of scenes do.
pub(super) struct Edits<'a, 'b>(&'a mut Steps<'b>);

impl Edits<'_, '_> {
    fn scene(&self) -> &Scene {
        self.0.edited.scene()
    }

    fn push(&mut self, change: Change) -> Result<()> {
        self.0.changes.try_reserve(1)?;
        self.0.changes.push(change);
        Ok(())
    }

    fn exchange(&mut self, part: Part) -> Result<()> {
        self.push(Change::Part(part, 0))
    }

    /// Exchanges the pins of the edited path.
    fn push_pins(&mut self, pins: Pins) -> Result<()> {
        self.push(Change::Whole(Whole {
            pins: Some(pins),
            ..Whole::default()
        }))
    }

    /// Exchanges a part, with all that must go along.
    pub(super) fn part(&mut self, part: Part) -> Result<()> {
        let edited = self.0.edited.node();
        match part {
            Part::Remove(which) => self.remove(which),
            Part::Path { node, path } if edited == Some(node) => self.edited_path(node, path),
            Part::Path { node, path } => {
                let count = path.as_ref().map_or(0, |path| path.path().points.len());
                self.unpin(|pin, at| pin == node && at >= count)?;
                self.exchange(Part::Path { node, path })
            }
            Part::Pin {
                node,
                point,
                marker,
            } if edited == Some(node) => {
                // The scene knows the path as it was.
                self.0
                    .edited
                    .check_pin(&self.0.state.path, point, marker.as_deref())?;
                let old = self.0.edited.pins_there().find(|pin| pin.0 == point);
                if old.map(|pin| pin.1) == marker {
                    return Ok(());
                }
                let pins = self.0.edited.pins_with(point, marker)?;
                self.push_pins(pins)
            }
            Part::Marker { name, frame: None } => {
                self.unpin_from(&name)?;
                self.exchange(Part::Marker { name, frame: None })
            }
            Part::Keys {
                node,
                channel,
                remove,
                put,
            } => self.keys(node, channel, remove, put),
            Part::RemoveShape { node, at } => {
                if self.scene().object(node)?.shapes().len() == 1 {
                    self.without_track(node, Channel::Weights)?;
                }
                self.exchange(Part::RemoveShape { node, at })
            }
            Part::RemoveDeformation { node, at } => {
                let tracks = self.scene().node(node)?.tracks_of(at);
                let channels: Vec<Channel> = tracks.map(|track| track.channel().clone()).collect();
                for channel in channels {
                    self.without_track(node, channel)?;
                }
                self.exchange(Part::RemoveDeformation { node, at })
            }
            other => self.exchange(other),
        }
    }

    fn without_track(&mut self, node: usize, channel: Channel) -> Result<()> {
        if self.scene().node(node)?.keys().track(&channel).is_none() {
            return Ok(());
        }
        self.exchange(Part::track(node, channel, None)?)
    }

    /// Frees points of paths in the scene by node and number.
    fn unpin(&mut self, which: impl Fn(usize, usize) -> bool) -> Result<()> {
        let pins = self.scene().pins().iter();
        let mut free = vec_with_room(pins.len())?;
        free.extend(
            pins.map(|pin| (pin.node, pin.point))
                .filter(|pin| which(pin.0, pin.1)),
        );
        for (node, point) in free {
            self.exchange(Part::Pin {
                node,
                point,
                marker: None,
            })?;
        }
        Ok(())
    }

    fn unpin_from(&mut self, marker: &str) -> Result<()> {
        self.pins_renamed(marker, None)
    }

    /// Pins all that is pinned to a marker to another one, or frees it.
    fn pins_renamed(&mut self, marker: &str, to: Option<&str>) -> Result<()> {
        let pins = self
            .scene()
            .pins()
            .iter()
            .filter(|pin| pin.marker == marker);
        let mut pinned = vec_with_room(pins.clone().count())?;
        pinned.extend(pins.map(|pin| (pin.node, pin.point)));
        for (node, point) in pinned {
            let marker = to.map(str::to_owned);
            self.exchange(Part::Pin {
                node,
                point,
                marker,
            })?;
        }
        match self.0.edited.pins_renamed(marker, to)? {
            Some(pins) => self.push_pins(pins),
            None => Ok(()),
        }
    }

    /// Gives a marker another name.
    pub(super) fn rename_marker(&mut self, from: String, to: String) -> Result<()> {
        let scene = self.scene();
        let frame = scene.marker(&from);
        let frame = frame.ok_or_else(|| Invalid::NoMarker((&from).into()))?;
        if from == to {
            return Ok(());
        }
        if scene.marker(&to).is_some() {
            return Err(Invalid::MarkerTwice((&to).into()).into());
        }
        let name = to.clone();
        self.exchange(Part::Marker {
            name,
            frame: Some(frame),
        })?;
        self.pins_renamed(&from, Some(&to))?;
        self.exchange(Part::Marker {
            name: from,
            frame: None,
        })
    }

    /// Keys that lie where others come give way. If none is left, the last one's value stays.
    fn keys(
        &mut self,
        node: usize,
        channel: Channel,
        mut remove: Vec<usize>,
        put: KeyList,
    ) -> Result<()> {
        let of = self.scene().node(node)?;
        let Some(track) = of.keys().track(&channel) else {
            return self.exchange(Part::Keys {
                node,
                channel,
                remove,
                put,
            });
        };
        let frames = track.frames();
        let mut come: Vec<usize> = vec_with_room(put.len())?;
        for frame in &put.frames {
            let at = frames.partition_point(|key| key < frame);
            come.extend(frames.get(at).filter(|key| *key == frame).map(|_| at));
        }
        remove.try_reserve(come.len())?;
        remove.extend(come);
        remove.sort_unstable();
        remove.dedup();
        let none_left = put.is_empty() && remove.len() == frames.len();
        if none_left && remove.last() == Some(&(frames.len() - 1)) {
            let rest = at_rest(of, node, track)?;
            self.exchange(Part::track(node, channel, None)?)?;
            return rest.map_or(Ok(()), |rest| self.exchange(rest));
        }
        self.exchange(Part::Keys {
            node,
            channel,
            remove,
            put,
        })
    }

    /// Puts the edited path into the scene as it is now.
    fn synchronise(&mut self) -> Result<()> {
        let (edited, path) = (self.0.edited, &self.0.state.path);
        let Some(node) = edited.node() else {
            return Ok(());
        };
        let Some(follow) = edited.present_path(path)? else {
            return Ok(());
        };
        self.unpin(|pin, _| pin == node)?;
        self.exchange(Part::path(node, Some(follow))?)?;
        for (point, marker) in self.0.edited.pins_there() {
            self.exchange(Part::Pin {
                node,
                point,
                marker: Some(marker),
            })?;
        }
        Ok(())
    }

    /// Edits the path of another node.
    pub(super) fn edit_node(&mut self, node: Option<usize>) -> Result<()> {
        if self.0.edited.node() == node {
            return Ok(());
        }
        self.synchronise()?;
        self.other_node(node)
    }

    fn other_node(&mut self, node: Option<usize>) -> Result<()> {
        let (path, pins) = other_path(self.scene(), node)?;
        self.0.state.info.check(path.space)?;
        can_allocate(size_of::<CameraPath>())?;
        self.0.selection = Some(Selection::default());
        self.push(Change::Edited(Box::new(path), pins))
    }

    fn edited_path(&mut self, node: usize, path: Option<Box<FollowPath>>) -> Result<()> {
        let Some(follow) = path else {
            self.synchronise()?;
            self.other_node(None)?;
            self.unpin(|pin, _| pin == node)?;
            for (point, _) in self.0.edited.pins_there() {
                let marker = None;
                self.exchange(Part::Pin {
                    node,
                    point,
                    marker,
                })?;
            }
            return self.exchange(Part::Path { node, path: None });
        };
        self.exchange(Part::Start {
            node,
            start_frame: follow.start_frame(),
            beyond: follow.extrapolation(),
        })?;
        let path = follow.path().try_clone()?;
        let (change, selection) = replaced(self.0.state, path, |point| point)?;
        self.0.selection = selection;
        self.push(change)
    }

    fn remove(&mut self, which: Vec<usize>) -> Result<()> {
        let gone = self.scene().with_all_in(&which)?;
        if self.0.edited.node().is_some_and(|node| gone[node]) {
            self.synchronise()?;
            let mut left = self.scene().nodes().iter().enumerate();
            let camera = left.find(|(at, node)| {
                !gone[*at] && matches!(node.kind, Kind::Camera(_)) && node.path().is_some()
            });
            self.other_node(camera.map(|(at, _)| at))?;
        }
        self.exchange(Part::Remove(which))
    }

    /// Puts nodes behind the others; they count on from there.
    pub(super) fn add(&mut self, nodes: Vec<Node>) -> Result<()> {
        can_allocate(size_of::<NodeList>())?;
        let list = NodeList::behind(self.scene(), nodes)?;
        self.exchange(Part::Insert(Box::new(list)))
    }

    /// Copies nodes with all that is in them. Aims among them go along; pins stay.
    pub(super) fn copy(&mut self, which: &[usize]) -> Result<()> {
        let within = self.scene().with_all_in(which)?;
        let (scene, edited) = (self.scene(), self.0.edited);
        let count = scene.nodes().len();
        let mut places: Vec<usize> = vec_with_room(count)?;
        places.extend((0..count).filter(|&at| within[at]));
        let bytes = places.iter().map(|&at| scene.nodes()[at].heap_size());
        can_allocate(bytes.sum())?;
        let copied = |at: usize| places.binary_search(&at).map_or(at, |place| count + place);
        let mut nodes: Vec<Node> = vec_with_room(places.len())?;
        let mut names = std::collections::HashSet::new();
        for &at in &places {
            let mut node = scene.nodes()[at].clone();
            node.name = new_name(scene, &names, &node.name);
            names.insert(node.name.clone());
            node.parent = node.parent.map(copied);
            node.aim = node.aim.map(copied);
            if edited.node() == Some(at)
                && let Some(path) = edited.present_path(&self.0.state.path)?
            {
                node.set_path(Some(path))?;
            }
            nodes.push(node);
        }
        self.add(nodes)
    }

    /// Puts a node into another one.
    pub(super) fn parent(&mut self, node: usize, parent: Option<usize>, keep: Keep) -> Result<()> {
        let old = self.scene().node(node)?;
        let (aim, name) = (old.aim, &old.name);
        if keep == Keep::Way {
            let parts = match self.0.edited.present_path(&self.0.state.path)? {
                Some(_) => self
                    .0
                    .edited
                    .with(&self.0.state.path)?
                    .way_in(node, parent)?,
                None => self.scene().way_in(node, parent)?,
            };
            return parts.into_iter().try_for_each(|part| self.part(part));
        }
        if keep == Keep::Place {
            let place = |error: vides_engine::Error| {
                error.at(vides_engine::error::Place::Node(name.into()))
            };
            let rest = if self.0.edited.present_path(&self.0.state.path)?.is_some() {
                let scene = self.0.edited.with(&self.0.state.path)?;
                scene.rest_in(node, parent).map_err(place)?
            } else {
                self.scene().rest_in(node, parent).map_err(place)?
            };
            can_allocate(size_of::<Rest>())?;
            let rest = Box::new(rest);
            self.exchange(Part::Rest { node, rest })?;
        }
        self.exchange(Part::Links { node, parent, aim })
    }
}

/// A name that no node has: this one with a number.
pub(super) fn new_name(
    scene: &Scene,
    others: &std::collections::HashSet<String>,
    name: &str,
) -> String {
    let stem = name.rsplit_once(' ').filter(|(_, number)| {
        !number.is_empty() && number.bytes().all(|byte| byte.is_ascii_digit())
    });
    let stem = stem.map_or(name, |(stem, _)| stem);
    let names = (2_u32..).map(|number| format!("{stem} {number}"));
    let mut free = names.filter(|name| scene.find(name).is_none() && !others.contains(name));
    free.next().unwrap_or_default()
}

/// The part that gives a node the value of a track's last key at rest; none for the host's own.
fn at_rest(of: &Node, node: usize, track: &Track) -> Result<Option<Part>> {
    let last = track.ends().1;
    let key = &track.values()[(track.frames().len() - 1) * track.width()..];
    let mut rest = Rest::of(of);
    let values = &mut rest.values;
    match (track.channel(), key, &of.kind) {
        (Channel::Rotation, ..) => {
            values.rotation = track.rotation(last, &mut Warnings::default());
        }
        (Channel::Weights, ..) => {
            let weights = key.to_vec();
            return Ok(Some(Part::Weights { node, weights }));
        }
        (Channel::Deformation { at, parameter }, _, Kind::Object(object)) => {
            let (mut deformation, bounds) = object.deformations()[*at].clone();
            if let Some(numbers) = deformation.channel_mut(parameter) {
                numbers.copy_from_slice(key);
            }
            return Ok(Some(Part::Deformation {
                node,
                at: *at,
                deformation,
                bounds,
            }));
        }
        _ if values.set(track.channel(), key) => {}
        _ => return Ok(None),
    }
    can_allocate(size_of::<Rest>()).map_err(Error::from)?;
    let rest = Box::new(rest);
    Ok(Some(Part::Rest { node, rest }))
}

/// The paths of nodes other than the edited one that their pins require.
pub(super) fn held_by_pins(edited: &EditedScene) -> Result<Vec<Change>> {
    let mut held = Vec::new();
    let pins = edited.scene().pins().chunk_by(|a, b| a.node == b.node);
    for node in pins.map(|pins| pins[0].node) {
        if edited.node() != Some(node)
            && let Some(path) = edited.scene().path_held_by_pins(node)?
        {
            held.try_reserve(1)?;
            held.push(Change::Part(Part::path(node, Some(path))?, 0));
        }
    }
    Ok(held)
}

/// A scene of nothing but a camera on a path is that path.
pub(super) fn path_again(state: &State, edited: &EditedScene) -> Result<Vec<Change>> {
    let mut steps = Steps {
        state,
        edited,
        changes: Vec::new(),
        selection: None,
    };
    Edits(&mut steps).edit_node(Some(0))?;
    Edits(&mut steps).push(Change::scene(None, &state.comments)?)?;
    Ok(steps.changes)
}
