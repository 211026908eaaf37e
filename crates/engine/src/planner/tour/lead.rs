//! The way of a tour through the places of the views that are taken.

use glam::DVec3;

use super::flight::{Flight, Stop};
use super::places::{self, View};
use super::round::{Roads, round};
use super::seen::Set;
use super::{CLEAR, Work};
use crate::error::{Result, vec_with_room};
use crate::limits::MAX_ORIENTATIONS;
use crate::path::{CameraPath, Space};

impl Work<'_> {
    /// The way through the places of views that are taken.
    pub(super) fn flight(&self, roads: &Roads, chosen: &[(View, Set)]) -> Result<Flight> {
        let mut stops: Vec<(usize, Vec<DVec3>)> = vec_with_room(chosen.len() + 1)?;
        if let Some(start) = self.request.start {
            let mut first = vec_with_room(1)?;
            // In an object that may be where the camera is: then towards a place that is shown.
            let ahead = places::ahead(&self.bounds, start);
            let near = ahead.distance(start) < self.least;
            first.push(
                chosen
                    .first()
                    .filter(|_| near)
                    .map_or(ahead, |(view, _)| view.target),
            );
            stops.push((roads.places.len() - 1, first));
        }
        for (view, _) in chosen {
            match stops.iter_mut().find(|(at, _)| *at == view.at) {
                Some((_, targets)) if targets.len() < MAX_ORIENTATIONS => {
                    targets.try_reserve(1)?;
                    targets.push(view.target);
                }
                Some(_) => {}
                None => {
                    let mut targets = vec_with_room(1)?;
                    targets.push(view.target);
                    stops.push((view.at, targets));
                }
            }
        }
        let mut far = vec_with_room(stops.len())?;
        for (at, _) in &stops {
            let (all, _) = roads.from(*at)?;
            let mut row = vec_with_room(stops.len())?;
            row.extend(stops.iter().map(|(to, _)| all[*to]));
            far.push(row);
        }
        let closed = self.request.start.is_none() && stops.len() > 2;
        let order = round(&far, closed)?;
        let mut flight = Flight {
            stops: Vec::new(),
            closed,
        };
        for (k, &here) in order.iter().enumerate() {
            let (at, targets) = &mut stops[here];
            let (at, mut targets) = (*at, std::mem::take(targets));
            self.sort_round(roads.places[at], &mut targets);
            flight.stops.try_reserve(1)?;
            flight.stops.push(Stop {
                place: roads.places[at],
                targets,
            });
            let next = match order.get(k + 1) {
                Some(next) => *next,
                None if closed => order[0],
                None => break,
            };
            if self.request.stills {
                continue;
            }
            let way = roads.way(at, stops[next].0)?;
            flight.stops.try_reserve(way.len())?;
            flight
                .stops
                .extend(way.iter().take(way.len() - 1).map(|via| Stop {
                    place: roads.places[*via],
                    targets: Vec::new(),
                }));
        }
        Ok(flight)
    }

    /// Sorts views from one place by their headings, beginning behind the widest gap.
    fn sort_round(&self, eye: DVec3, targets: &mut [DVec3]) {
        let heading = |target: &DVec3| {
            let way = self.request.up.upright(*target - eye);
            way.x.atan2(way.z)
        };
        targets.sort_by(|a, b| heading(a).total_cmp(&heading(b)));
        let count = targets.len();
        let gap = |at: &usize| {
            let before = (at + count - 1) % count;
            let turn = heading(&targets[*at]) - heading(&targets[before]);
            turn.rem_euclid(std::f64::consts::TAU)
        };
        let widest = (0..count).rev().max_by(|a, b| gap(a).total_cmp(&gap(b)));
        targets.rotate_left(widest.unwrap_or(0));
    }

    pub(super) fn path(&self, mut flight: Flight) -> Result<CameraPath> {
        if !self.request.stills {
            let share = if self.request.inside { 0.0 } else { CLEAR[1] };
            let clear = (share * self.surface.distance).max(self.least);
            if self.request.inside {
                flight.turn(self.request.up)?;
            }
            flight.clear(self.tree, clear, self.watch)?;
            flight.look(self.request.up, self.request.inside)?;
        }
        let places = flight.reach()?;
        let places = places.iter().copied();
        let corners = [self.bounds.min(), self.bounds.max()];
        let own = Space::around(places.clone().chain(corners), self.request.up)?;
        let given = self.request.space.filter(|space| {
            let holds =
                |place: DVec3| (place - space.centre).abs().max_element() <= 0.98 * space.half_size;
            space.up == self.request.up && places.clone().all(holds)
        });
        let space = given.unwrap_or(own);
        if self.request.stills {
            flight.stills(space)
        } else {
            flight.path(space)
        }
    }
}
