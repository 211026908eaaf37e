//! The markers of a scene, and the points of paths that are pinned to them.

use super::marker::{Marker, Pin};
use super::motion::{FollowPath, check_frame};
use super::node::check_node_name;
use super::scene::{Scene, copy};
use crate::error::{Invalid, OutOfRange, Place, Result, TooMany};
use crate::limits::{MAX_MARKERS, MAX_PINS};

impl Scene {
    /// The markers, by name.
    #[must_use]
    pub fn markers(&self) -> &[Marker] {
        &self.markers
    }

    /// Sets a marker, or moves the one of this name and with it the points pinned to it.
    ///
    /// # Errors
    /// What is wrong with name or frame, or as [`super::pins::pinned`]; nothing has changed then.
    pub fn set_marker(&mut self, name: &str, frame: f64) -> Result<()> {
        check_node_name(name).map_err(|error| error.at(Place::Marker))?;
        check_frame(frame)?;
        match self.marker_place(name) {
            Ok(at) => {
                let old = std::mem::replace(&mut self.markers[at].frame, frame);
                if let Err(error) = self.hold_at(name) {
                    self.markers[at].frame = old;
                    return Err(error);
                }
            }
            Err(_) if self.markers.len() >= MAX_MARKERS => {
                return Err(TooMany::Markers.into());
            }
            Err(at) => {
                self.markers.try_reserve(1)?;
                let name = copy(name)?;
                self.markers.insert(at, Marker { name, frame });
            }
        }
        Ok(())
    }

    /// Removes a marker and the pins to it; it need not exist.
    pub fn remove_marker(&mut self, name: &str) {
        self.markers.retain(|marker| marker.name != name);
        self.pins.retain(|pin| pin.marker != name);
    }

    /// Fits every path that is pinned to a marker.
    pub(super) fn hold_at(&mut self, marker: &str) -> Result<()> {
        let mut held: Vec<(usize, FollowPath)> = Vec::new();
        for pin in self.pins.iter().filter(|pin| pin.marker == marker) {
            let node = &self.nodes[pin.node];
            if held.last().is_some_and(|(at, _)| *at == pin.node) {
                continue;
            }
            if let Some(path) = node.path()
                && let Some(path) = self
                    .held_by_pins(pin.node, path)
                    .map_err(|error| error.at(Place::Node((&node.name).into())))?
            {
                held.try_reserve(1)?;
                held.push((pin.node, path));
            }
        }
        // Their nodes follow paths already, so none of these fails.
        held.into_iter()
            .try_for_each(|(at, path)| self.nodes[at].set_path(Some(path)))
    }

    /// The frame of a marker.
    #[must_use]
    pub fn marker(&self, name: &str) -> Option<f64> {
        let at = self.marker_place(name).ok()?;
        Some(self.markers[at].frame)
    }

    pub(super) fn marker_place(&self, name: &str) -> Result<usize, usize> {
        self.markers
            .binary_search_by(|marker| marker.name.as_str().cmp(name))
    }

    /// The pins, by node and point.
    #[must_use]
    pub fn pins(&self) -> &[Pin] {
        &self.pins
    }

    pub(super) fn check_path_point(&self, at: usize, point: usize) -> Result<()> {
        let node = self.node(at)?;
        let count = node.path().map_or(0, |path| path.path().points.len());
        match point < count {
            true => Ok(()),
            false => Err(OutOfRange::NoPathPoint {
                node: (&node.name).into(),
                point,
                count,
            }
            .into()),
        }
    }

    /// Pins a point of a node's path to a marker, or frees it ([`super::pins`]).
    ///
    /// # Errors
    /// [`crate::Error::Range`] for the point, [`crate::Error::Argument`] for the marker,
    /// [`crate::Error::Limit`], or as [`super::pins::pinned`]; nothing has changed then.
    pub fn pin(&mut self, at: usize, point: usize, marker: Option<&str>) -> Result<()> {
        self.check_path_point(at, point)?;
        let place = self
            .pins
            .binary_search_by_key(&(at, point), |pin| (pin.node, pin.point));
        let Some(marker) = marker else {
            if let Ok(place) = place {
                self.pins.remove(place);
            }
            return Ok(());
        };
        if self.marker_place(marker).is_err() {
            return Err(Invalid::NoMarker(marker.into()).into());
        }
        if self.pins.len() >= MAX_PINS {
            return Err(TooMany::Pins.into());
        }
        self.pins.try_reserve(1)?;
        let pin = Pin {
            node: at,
            point,
            marker: copy(marker)?,
        };
        let old = match place {
            Ok(place) => Some(std::mem::replace(&mut self.pins[place], pin)),
            Err(place) => {
                self.pins.insert(place, pin);
                None
            }
        };
        let held = match self.nodes[at].path() {
            Some(path) => self.held_by_pins(at, path),
            None => Ok(None),
        };
        match held {
            Ok(Some(path)) => self.nodes[at].set_path(Some(path)),
            Ok(None) => Ok(()),
            Err(error) => {
                let (Ok(place) | Err(place)) = place;
                match old {
                    Some(old) => self.pins[place] = old,
                    None => drop(self.pins.remove(place)),
                }
                Err(error)
            }
        }
    }
}
