//! How parts are exchanged ([`super::part`]).

use std::mem::swap;

use super::channel::Channel;
use super::marker::{Marker, Pin};
use super::motion::{FollowPath, check_frame};
use super::node::{Kind, Node, check_node_name};
use super::node_list::NodeList;
use super::part::{Part, Rest};
use super::scene::{Scene, check_numbers, copy, taken};
use super::time::Extrapolation;
use super::track::Track;
use crate::error::{Error, Invalid, OutOfRange, Place, Result, TooMany, can_allocate};
use crate::limits::{MAX_MARKERS, MAX_PINS};

impl Scene {
    /// Exchanges a part of the scene for `part`, which is what the scene had there afterwards.
    ///
    /// # Errors
    /// What is wrong with it, with node, channel and key; nothing has changed then.
    pub fn exchange(&mut self, part: &mut Part) -> Result<()> {
        match part {
            Part::Insert(list) => {
                let places = self.insert_nodes(list)?;
                *part = Part::Remove(places);
                Ok(())
            }
            Part::Remove(places) => {
                can_allocate(size_of::<NodeList>())?;
                *part = Part::Insert(Box::new(self.remove_nodes(places)?));
                Ok(())
            }
            Part::Name { node, name } => self.exchange_name(*node, name),
            Part::Rest { node, rest } => self.exchange_rest(*node, rest),
            Part::Links { node, parent, aim } => self.exchange_links(*node, parent, aim),
            Part::Path { node, path } => self.exchange_path(*node, path),
            Part::Start {
                node,
                start_frame,
                beyond,
            } => self.exchange_start(*node, start_frame, beyond),
            Part::Marker { name, frame } => self.exchange_marker(name, frame),
            Part::Pin {
                node,
                point,
                marker,
            } => self.exchange_pin(*node, *point, marker),
            Part::Camera(camera) => {
                let old = self.camera();
                self.set_camera(*camera)?;
                *camera = old;
                Ok(())
            }
            Part::Range(range) => {
                let old = self.range();
                self.set_range(*range)?;
                *range = old;
                Ok(())
            }
            Part::Track {
                node,
                channel,
                track,
            } => self.exchange_track(*node, channel, track),
            Part::Keys {
                node,
                channel,
                remove,
                put,
            } => {
                let (gone, come) = (remove.len(), put.len());
                let numbers = |track: &Track| {
                    let each = 1 + track.key_numbers().iter().sum::<usize>();
                    (track.numbers_kept() + each * come).saturating_sub(each * gone)
                };
                self.with_track(*node, channel, numbers, |track| track.splice(remove, put))
            }
            Part::Manner {
                node,
                channel,
                manner,
            } => {
                let shape = manner.shape.len();
                let numbers = |track: &Track| track.numbers_kept() - track.shape().len() + shape;
                self.with_track(*node, channel, numbers, |track| {
                    track.exchange_manner(manner)
                })
            }
            of_object => {
                let at = of_object.node().unwrap_or_default();
                let done = self.exchange_of_object(of_object);
                done.map_err(|error| match self.nodes().get(at) {
                    Some(node) => error.at(Place::Node((&node.name).into())),
                    None => error,
                })
            }
        }
    }

    /// The same for what an object has; errors do not name its node.
    pub(super) fn exchange_of_object(&mut self, part: &mut Part) -> Result<()> {
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
        let done = node.exchange_of_object(part);
        self.numbers = self.numbers - before + node.keys.numbers();
        done
    }

    fn at_node(&self, at: usize) -> impl Fn(Error) -> Error + use<'_> {
        move |error| error.at(Place::Node((&self.nodes()[at].name).into()))
    }

    fn exchange_name(&mut self, at: usize, name: &mut String) -> Result<()> {
        let old = &self.node(at)?.name;
        check_node_name(name)?;
        let to = match self.place_of(name) {
            Ok(place) if self.names[place] == at => return Ok(()),
            Ok(_) => return Err(taken(name)),
            Err(place) => place,
        };
        let (Ok(from) | Err(from)) = self.place_of(old);
        swap(&mut self.nodes.one(at, &self.order).name, name);
        self.names.remove(from);
        self.names.insert(to - usize::from(to > from), at);
        Ok(())
    }

    fn exchange_rest(&mut self, at: usize, rest: &mut Rest) -> Result<()> {
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
        swap(&mut node.pivot, &mut rest.pivot);
        swap(&mut node.rest, &mut rest.values);
        if node.kind.looks() {
            swap(&mut node.kind, &mut rest.kind);
        }
        Ok(())
    }

    fn exchange_links(
        &mut self,
        at: usize,
        parent: &mut Option<usize>,
        aim: &mut Option<usize>,
    ) -> Result<()> {
        let node = self.node(at)?;
        let old = (node.parent, node.aim);
        let wrong = if aim.is_some() && !node.kind.looks() {
            Some(Invalid::CannotAim)
        } else if *aim == Some(at) {
            Some(Invalid::AimsAtItself)
        } else {
            None
        };
        if let Some(wrong) = wrong {
            return Err(self.at_node(at)(wrong.into()));
        }
        if *parent != old.0 {
            self.check_parent(at, *parent)?;
        }
        self.link(at, *parent, *aim)?;
        (*parent, *aim) = old;
        Ok(())
    }

    fn exchange_path(&mut self, at: usize, path: &mut Option<Box<FollowPath>>) -> Result<()> {
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
        swap(&mut self.nodes.one(at, &self.order).path, path);
        Ok(())
    }

    fn exchange_start(
        &mut self,
        at: usize,
        start: &mut f64,
        beyond: &mut Extrapolation,
    ) -> Result<()> {
        let node = self.node(at)?;
        if node.path().is_none() {
            return Err(Invalid::NoPathOf((&node.name).into()).into());
        }
        check_frame(*start).map_err(self.at_node(at))?;
        if *beyond == Extrapolation::Offset {
            return Err(self.at_node(at)(Invalid::PathWithOffset.into()));
        }
        let node = self.nodes.one(at, &self.order);
        if let Some(path) = node.path.as_deref_mut() {
            path.exchange_start(start, beyond);
        }
        Ok(())
    }

    fn exchange_marker(&mut self, name: &mut String, frame: &mut Option<f64>) -> Result<()> {
        check_node_name(name).map_err(|error| error.at(Place::Marker))?;
        if let Some(frame) = *frame {
            check_frame(frame)?;
        }
        match (self.marker_place(name), *frame) {
            (Ok(at), Some(new)) => {
                *frame = Some(std::mem::replace(&mut self.markers[at].frame, new));
            }
            (Ok(at), None) => {
                if self.pins.iter().any(|pin| pin.marker == *name) {
                    return Err(Invalid::Pinned((&*name).into()).into());
                }
                let marker = self.markers.remove(at);
                (*name, *frame) = (marker.name, Some(marker.frame));
            }
            (Err(_), None) => {}
            (Err(_), Some(_)) if self.markers.len() >= MAX_MARKERS => {
                return Err(TooMany::Markers.into());
            }
            (Err(at), Some(new)) => {
                self.markers.try_reserve(1)?;
                let name = copy(name)?;
                self.markers.insert(at, Marker { name, frame: new });
                *frame = None;
            }
        }
        Ok(())
    }

    fn exchange_pin(
        &mut self,
        node: usize,
        point: usize,
        marker: &mut Option<String>,
    ) -> Result<()> {
        self.check_path_point(node, point)?;
        if let Some(name) = marker.as_deref().filter(|name| self.marker(name).is_none()) {
            return Err(Invalid::NoMarker(name.into()).into());
        }
        let place = self
            .pins
            .binary_search_by_key(&(node, point), |pin| (pin.node, pin.point));
        match (place, marker.take()) {
            (Ok(at), Some(new)) => {
                *marker = Some(std::mem::replace(&mut self.pins[at].marker, new));
            }
            (Ok(at), None) => *marker = Some(self.pins.remove(at).marker),
            (Err(_), None) => {}
            (Err(_), Some(_)) if self.pins.len() >= MAX_PINS => return Err(TooMany::Pins.into()),
            (Err(at), Some(new)) => {
                self.pins.try_reserve(1)?;
                self.pins.insert(
                    at,
                    Pin {
                        node,
                        point,
                        marker: new,
                    },
                );
            }
        }
        Ok(())
    }

    fn exchange_track(
        &mut self,
        at: usize,
        channel: &Channel,
        track: &mut Option<Box<Track>>,
    ) -> Result<()> {
        let node = self.node(at)?;
        let new = track.as_deref();
        if let Some(new) = new {
            if !new.channel().same_as(channel) {
                return Err(Invalid::NotThatChannel {
                    channel: (&channel).into(),
                    given: (&new.channel()).into(),
                }
                .into());
            }
            node.check_track(new).map_err(self.at_node(at))?;
        }
        let old = node.keys.track(channel).map_or(0, Track::numbers_kept);
        let numbers = self.numbers - old + new.map_or(0, Track::numbers_kept);
        check_numbers(numbers)?;
        can_allocate(size_of::<Track>())?;
        let node = self.nodes.one(at, &self.order);
        node.keys.exchange(channel, track)?;
        self.numbers = numbers;
        Ok(())
    }

    /// Changes a track that is there and has so many numbers then.
    fn with_track(
        &mut self,
        at: usize,
        channel: &Channel,
        numbers: impl FnOnce(&Track) -> usize,
        change: impl FnOnce(&mut Track) -> Result<()>,
    ) -> Result<()> {
        let node = self.node(at)?;
        let Some(old) = node.keys.track(channel) else {
            return Err(Invalid::NoTrack {
                node: (&node.name).into(),
                channel: (&channel).into(),
            }
            .into());
        };
        let others = self.numbers - old.numbers_kept();
        check_numbers(others + numbers(old))?;
        let Some(track) = self.nodes.one(at, &self.order).keys.track_mut(channel) else {
            return Ok(());
        };
        let done = change(track).map_err(|error| track.at_channel(error));
        self.numbers = others + track.numbers_kept();
        done.map_err(self.at_node(at))
    }

    /// Takes over one node from a scene of as many. What is prepared of its path stays.
    ///
    /// # Errors
    /// [`Error::Range`] if one of them has no such node.
    pub fn take_over(&mut self, at: usize, from: &Self) -> Result<()> {
        let mut new = from.node(at)?.clone();
        if self.node(at)?.path == new.path {
            new.path = self.nodes.one(at, &self.order).path.take();
        }
        *self.nodes.one(at, &self.order) = new;
        self.numbers = from.numbers;
        Ok(())
    }
}

impl Scene {
    /// Whether an exchange would change nothing.
    #[must_use]
    pub fn has(&self, part: &Part) -> bool {
        let of = |at: usize| self.nodes().get(at);
        match part {
            Part::Insert(list) => list.nodes().is_empty(),
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
