//! How a scene comes to have a part ([`super::part`]).

use std::sync::Arc;

use super::channel::Channel;
use super::marker::{Marker, Pin};
use super::motion::{FollowPath, check_frame};
use super::node::{Kind, Node, check_node_name};
use super::part::{Part, Rest};
use super::scene::{Scene, check_numbers, copy, taken};
use super::time::Extrapolation;
use super::track::Track;
use crate::error::{Error, Invalid, OutOfRange, Place, Result, TooMany};
use crate::limits::{MAX_MARKERS, MAX_PINS};

impl Scene {
    /// Makes a part of the scene what `part` says.
    ///
    /// # Errors
    /// What is wrong with it, with node, channel and key; nothing has changed then.
    pub fn apply(&mut self, part: Part) -> Result<()> {
        match part {
            Part::Remove(which) => self.remove_nodes(&which),
            Part::Name { node, name } => self.put_name(node, name),
            Part::Rest { node, rest } => self.put_rest(node, *rest),
            Part::Links { node, parent, aim } => self.put_links(node, parent, aim),
            Part::Path { node, path } => self.put_path(node, path),
            Part::Start {
                node,
                start_frame,
                beyond,
            } => self.put_start(node, start_frame, beyond),
            Part::Marker { name, frame } => self.put_marker(name, frame),
            Part::Pin {
                node,
                point,
                marker,
            } => self.put_pin(node, point, marker),
            Part::Camera(camera) => self.set_camera(camera),
            Part::Range(range) => self.set_range(range),
            Part::Track {
                node,
                channel,
                track,
            } => self.put_track(node, &channel, track),
            Part::Keys {
                node,
                channel,
                remove,
                put,
            } => self.change_track(node, &channel, |track| track.with_keys(&remove, &put)),
            Part::Manner {
                node,
                channel,
                manner,
            } => self.change_track(node, &channel, |track| track.with_manner(*manner)),
            of_object => {
                let at = of_object.node().unwrap_or_default();
                let done = self.apply_to_object(of_object);
                done.map_err(|error| match self.nodes().get(at) {
                    Some(node) => error.at(Place::Node((&node.name).into())),
                    None => error,
                })
            }
        }
    }

    /// The same for what an object has; errors do not name its node.
    pub(super) fn apply_to_object(&mut self, part: Part) -> Result<()> {
        let Some(at) = part.node() else {
            return Ok(());
        };
        self.object(at)?;
        let old = &self.nodes[at];
        let before = old.keys.numbers();
        if matches!(part, Part::InsertShape { .. })
            && let Some(track) = old.keys.track(&Channel::Weights)
        {
            check_numbers(self.numbers + 3 * track.frames().len())?;
        }
        let node = self.nodes.one(at, &self.order);
        let done = node.apply_to_object(part);
        self.numbers = self.numbers - before + node.keys.numbers();
        done
    }

    fn at_node(&self, at: usize) -> impl Fn(Error) -> Error + use<'_> {
        move |error| error.at(Place::Node((&self.nodes()[at].name).into()))
    }

    fn put_name(&mut self, at: usize, name: String) -> Result<()> {
        let old = &self.node(at)?.name;
        check_node_name(&name)?;
        let to = match self.place_of(&name) {
            Ok(place) if self.names[place] == at => return Ok(()),
            Ok(_) => return Err(taken(&name)),
            Err(place) => place,
        };
        let (Ok(from) | Err(from)) = self.place_of(old);
        self.nodes.one(at, &self.order).name = name;
        let names = Arc::make_mut(&mut self.names);
        names.remove(from);
        names.insert(to - usize::from(to > from), at);
        Ok(())
    }

    fn put_rest(&mut self, at: usize, mut rest: Rest) -> Result<()> {
        let node = self.node(at)?;
        if node.kind.looks() {
            if std::mem::discriminant(&node.kind) != std::mem::discriminant(&rest.kind) {
                return Err(Invalid::KindStays {
                    node: (&node.name).into(),
                    kind: node.kind.name(),
                }
                .into());
            }
        } else {
            rest.kind = Kind::Group;
        }
        let new = Node {
            name: copy(&node.name)?,
            kind: rest.kind.clone(),
            aim: node.aim,
            pivot: rest.pivot,
            rest: rest.values,
            ..Node::default()
        };
        new.check().map_err(self.at_node(at))?;
        let node = self.nodes.one(at, &self.order);
        (node.pivot, node.rest) = (rest.pivot, rest.values);
        if node.kind.looks() {
            node.kind = rest.kind;
        }
        Ok(())
    }

    fn put_links(&mut self, at: usize, parent: Option<usize>, aim: Option<usize>) -> Result<()> {
        let node = self.node(at)?;
        let wrong = if aim.is_some() && !node.kind.looks() {
            Some(Invalid::CannotAim)
        } else if aim == Some(at) {
            Some(Invalid::AimsAtItself)
        } else {
            None
        };
        if let Some(wrong) = wrong {
            return Err(self.at_node(at)(wrong.into()));
        }
        if parent != node.parent {
            self.check_parent(at, parent)?;
        }
        self.link(at, parent, aim)
    }

    fn put_path(&mut self, at: usize, path: Option<Arc<FollowPath>>) -> Result<()> {
        let node = self.node(at)?;
        let new = path.as_deref();
        let count = new.map_or(0, |path| path.path().points.len());
        let mut pins = self.pins.iter().filter(|pin| pin.node == at);
        if let Some(pin) = pins.find(|pin| pin.point >= count) {
            return Err(OutOfRange::NoPathPoint {
                node: (&node.name).into(),
                point: pin.point,
                count,
            }
            .into());
        }
        if new.is_some() {
            node.check_path()?;
        }
        self.nodes.one(at, &self.order).path = path;
        Ok(())
    }

    fn put_start(&mut self, at: usize, start: f64, beyond: Extrapolation) -> Result<()> {
        let node = self.node(at)?;
        if node.path().is_none() {
            return Err(Invalid::NoPathOf((&node.name).into()).into());
        }
        check_frame(start).map_err(self.at_node(at))?;
        if beyond == Extrapolation::Offset {
            return Err(self.at_node(at)(Invalid::PathWithOffset.into()));
        }
        let node = self.nodes.one(at, &self.order);
        if let Some(path) = &mut node.path {
            Arc::make_mut(path).set_start(start, beyond);
        }
        Ok(())
    }

    fn put_marker(&mut self, name: String, frame: Option<f64>) -> Result<()> {
        check_node_name(&name).map_err(|error| error.at(Place::Marker))?;
        if let Some(frame) = frame {
            check_frame(frame)?;
        }
        match (self.marker_place(&name), frame) {
            (Ok(at), Some(frame)) => self.markers[at].frame = frame,
            (Ok(at), None) => {
                if self.pins.iter().any(|pin| pin.marker == name) {
                    return Err(Invalid::Pinned((&name).into()).into());
                }
                self.markers.remove(at);
            }
            (Err(_), None) => {}
            (Err(_), Some(_)) if self.markers.len() >= MAX_MARKERS => {
                return Err(TooMany::Markers.into());
            }
            (Err(at), Some(frame)) => self.markers.insert(at, Marker { name, frame }),
        }
        Ok(())
    }

    fn put_pin(&mut self, node: usize, point: usize, marker: Option<String>) -> Result<()> {
        self.check_path_point(node, point)?;
        if let Some(name) = marker.as_deref().filter(|name| self.marker(name).is_none()) {
            return Err(Invalid::NoMarker(name.into()).into());
        }
        let place = self
            .pins
            .binary_search_by_key(&(node, point), |pin| (pin.node, pin.point));
        match (place, marker) {
            (Ok(at), Some(marker)) => self.pins[at].marker = marker,
            (Ok(at), None) => drop(self.pins.remove(at)),
            (Err(_), None) => {}
            (Err(_), Some(_)) if self.pins.len() >= MAX_PINS => return Err(TooMany::Pins.into()),
            (Err(at), Some(marker)) => self.pins.insert(
                at,
                Pin {
                    node,
                    point,
                    marker,
                },
            ),
        }
        Ok(())
    }

    fn put_track(&mut self, at: usize, channel: &Channel, track: Option<Arc<Track>>) -> Result<()> {
        let node = self.node(at)?;
        if let Some(new) = &track {
            if !new.channel().same_as(channel) {
                return Err(Invalid::NotThatChannel {
                    channel: channel.into(),
                    given: (&new.channel()).into(),
                }
                .into());
            }
            node.check_track(new).map_err(self.at_node(at))?;
        }
        let old = node.keys.track(channel).map_or(0, Track::numbers_kept);
        let new = track.as_deref().map_or(0, Track::numbers_kept);
        let numbers = self.numbers - old + new;
        check_numbers(numbers)?;
        let keys = &mut self.nodes.one(at, &self.order).keys;
        match track {
            Some(track) => keys.set(track)?,
            None => drop(keys.remove(channel)),
        }
        self.numbers = numbers;
        Ok(())
    }

    /// Puts another track in the place of one that is there.
    fn change_track(
        &mut self,
        at: usize,
        channel: &Channel,
        change: impl FnOnce(&Track) -> Result<Track>,
    ) -> Result<()> {
        let node = self.node(at)?;
        let Some(old) = node.keys.track(channel) else {
            return Err(Invalid::NoTrack {
                node: (&node.name).into(),
                channel: channel.into(),
            }
            .into());
        };
        let new = change(old).map_err(|error| self.at_node(at)(old.at_channel(error)))?;
        let numbers = self.numbers - old.numbers_kept() + new.numbers_kept();
        check_numbers(numbers)?;
        self.nodes.one(at, &self.order).keys.set(Arc::new(new))?;
        self.numbers = numbers;
        Ok(())
    }

    /// Becomes another scene. What is prepared of nodes stays where these are the same.
    pub fn become_scene(&mut self, other: &Self) {
        if self.ids != other.ids || *self.order != *other.order {
            self.clone_from(other);
            return;
        }
        for (at, node) in other.nodes.shared().enumerate() {
            if !Arc::ptr_eq(node, self.nodes.get_shared(at)) {
                self.nodes.put(at, Arc::clone(node), &self.order);
            }
        }
        self.names = Arc::clone(&other.names);
        self.markers.clone_from(&other.markers);
        self.pins.clone_from(&other.pins);
        (self.numbers, self.camera, self.range) = (other.numbers, other.camera, other.range);
        self.space = other.space;
    }
}

impl Scene {
    /// Whether it has a part already.
    #[must_use]
    pub fn has(&self, part: &Part) -> bool {
        let of = |at: usize| self.nodes().get(at);
        match part {
            Part::Remove(places) => places.is_empty(),
            Part::Name { node, name } => of(*node).is_some_and(|node| node.name == *name),
            Part::Rest { node, rest } => {
                of(*node).is_some_and(|node| same_rest(&Rest::of(node), rest))
            }
            Part::Links { node, parent, aim } => {
                of(*node).is_some_and(|node| (node.parent, node.aim) == (*parent, *aim))
            }
            Part::Path { node, path: None } => of(*node).is_some_and(|node| node.path.is_none()),
            Part::Track {
                node,
                channel,
                track: None,
            } => of(*node).is_some_and(|node| node.keys.track(channel).is_none()),
            Part::Keys { remove, put, .. } => remove.is_empty() && put.is_empty(),
            Part::Marker { name, frame } => {
                self.marker(name).map(f64::to_bits) == frame.map(f64::to_bits)
            }
            Part::Pin {
                node,
                point,
                marker,
            } => {
                let mut pins = self.pins.iter();
                let pin = pins.find(|pin| (pin.node, pin.point) == (*node, *point));
                pin.map(|pin| &pin.marker) == marker.as_ref()
            }
            Part::MoveDeformation { from, to, .. } => from == to,
            Part::Camera(camera) => self.camera() == *camera,
            Part::Range(range) => {
                let bits = |range: (f64, f64)| (range.0.to_bits(), range.1.to_bits());
                self.range().map(bits) == range.map(bits)
            }
            _ => false,
        }
    }
}

/// Bit by bit, so that −0 is not 0.
fn same_rest(a: &Rest, b: &Rest) -> bool {
    let numbers = |rest: &Rest| {
        let values = &rest.values;
        let mut all = rest.pivot.to_array().to_vec();
        all.extend(values.position.to_array());
        all.extend(values.rotation.to_array());
        all.extend(values.scale.to_array());
        all.extend(values.colour);
        all.extend(values.cone);
        all.extend([
            values.zoom,
            values.roll,
            values.intensity,
            values.aim_weight,
        ]);
        all.into_iter().map(f64::to_bits).collect::<Vec<_>>()
    };
    a.kind == b.kind && a.values.visible == b.values.visible && numbers(a) == numbers(b)
}
