//! Which way is up at the orientations of a path and along its sections (`docs/theory/path.md`, which way
//! is up), where it is not the up axis. A minimal up depends on the way to it, so all are
//! computed at once, from the curve and the views alone, before there are frames.

use std::sync::Arc;

use glam::DVec3;

use super::ahead::{self, Follow, Look, Rail, TransportedFrame, UpAlong};
use super::arc_length::ArcLength;
use super::camera_path::{CameraPath, Orientation, Target};
use super::frenet::Normals;
use super::own::Overrides;
use super::space::{Space, Up};
use super::up::UpVector;
use crate::error::{Result, can_allocate, try_arc, vec_with_room};
use crate::math::orientation::up_from_roll;
use crate::math::rotation_minimising::{
    chord, perpendicular, shortest, signed_angle, step, turned,
};

const SAME_DIRECTION: f64 = 1e-12;

/// Steps are halved until the twist of a section changes by less.
const TWIST: f64 = 1e-7;

/// Steps of a section at first and at most. (More would only be asked for where the view jumps.)
const STEPS: [usize; 2] = [16, 4096];

/// What decides whether a section between two orientations follows a rule.
pub(super) struct End<'a> {
    pub target: Target,
    pub view: DVec3,
    pub roll: f64,
    pub own: &'a Overrides,
}

/// The look that a section keeps all the way, if both ends have the same look and the same up.
pub(super) fn look_between(from: &End<'_>, to: &End<'_>, upright: Up) -> Option<Look> {
    let look = common_look(from, to)?;
    let same = look != Look::Still || from.roll == to.roll;
    (same && from.own.up.same(&to.own.up, upright)).then_some(look)
}

/// The look that both ends have, whatever their ups and rolls.
pub(super) fn common_look(from: &End<'_>, to: &End<'_>) -> Option<Look> {
    match (from.own.ahead, to.own.ahead) {
        (None, None) => {}
        (Some(a), Some(b)) if a == b => return Some(Look::Ahead(a)),
        _ => return None,
    }
    match (from.target, to.target) {
        (Target::Absolute(a), Target::Absolute(b)) if a == b => Some(Look::Target(a)),
        (Target::Relative(_), Target::Relative(_))
            if (from.view - to.view).length() <= SAME_DIRECTION =>
        {
            Some(Look::Still)
        }
        _ => None,
    }
}

#[derive(Debug, Clone)]
pub(super) struct Alignment {
    /// Up before the roll of each orientation, in y-up axes; `None` where it is an axis.
    ups: Vec<Option<DVec3>>,
    /// For each section, if it carries its up.
    pub(super) carried: Vec<Option<Arc<TransportedFrame>>>,
    normals: Option<Arc<Normals>>,
}

struct Place<'a> {
    point: usize,
    last: bool,
    orientation: &'a Orientation,
    view: DVec3,
}

impl Place<'_> {
    fn end(&self) -> End<'_> {
        End {
            target: self.orientation.target,
            view: self.view,
            roll: self.orientation.roll,
            own: &self.orientation.own,
        }
    }
}

/// Whether some orientation has another up than an axis.
#[must_use]
pub fn any(path: &CameraPath) -> bool {
    let mut all = path.points.iter().flat_map(|point| &point.orientations);
    all.any(|orientation| !orientation.own.up.is_level())
}

/// Up for a view, rolled from a reference; without one, from the up axis.
pub(super) fn rolled(view: DVec3, reference: Option<DVec3>, roll: f64) -> DVec3 {
    match reference {
        None => up_from_roll(view, roll),
        Some(up) => turned(up, view, roll),
    }
}

impl Alignment {
    /// For a path some of whose ups are not an axis.
    pub(super) fn new(path: &CameraPath, rail: &Arc<Rail>) -> Result<Self> {
        let count = path.points.iter().map(|p| p.orientations.len()).sum();
        let mut places = vec_with_room(count)?;
        let mut frenet = false;
        for (point, here) in path.points.iter().enumerate() {
            for (at, orientation) in here.orientations.iter().enumerate() {
                frenet |= orientation.own.up == UpVector::Frenet;
                places.push(Place {
                    point,
                    last: at + 1 == here.orientations.len(),
                    orientation,
                    view: ahead::view(path, point, at),
                });
            }
        }
        let mut normals = None;
        if frenet
            && let Some(found) = Normals::new(&rail.chain.curves, &rail.chain.starts, path.closed)?
        {
            normals = Some(try_arc(found)?);
        }
        let mut alignment = Self {
            ups: vec_with_room(count)?,
            carried: vec_with_room(count)?,
            normals,
        };
        alignment.ups.resize(count, None);
        alignment.carried.resize(count, None);
        let minimal = |at: usize| places[at].orientation.own.up == UpVector::Minimal;
        // A closed path is entered outside the runs of minimal ups.
        let begin = (0..count).find(|&at| !minimal(at));
        let around = begin.is_none() && path.closed;
        let begin = if path.closed { begin.unwrap_or(0) } else { 0 };
        let mut before: Option<(usize, DVec3)> = None;
        for k in 0..count + usize::from(around) {
            let at = (begin + k) % count;
            let carried = match before {
                Some((from, up)) if minimal(from) && minimal(at) => {
                    Some(alignment.carry(&places, (from, up), at, (path, rail))?)
                }
                _ => None,
            };
            if k == count {
                if let Some(arrived) = carried {
                    alignment.close(&places, arrived, (path, rail))?;
                }
                break;
            }
            let last = before.map(|(from, up)| {
                let Place {
                    view, orientation, ..
                } = &places[from];
                turned(up, *view, orientation.roll.to_radians())
            });
            let up = match carried {
                Some(up) => up,
                None => alignment.up_of(&places[at], last, (path, rail)),
            };
            before = Some((at, up));
            if !places[at].orientation.own.up.is_level() {
                alignment.ups[at] = Some(path.space.up.upright(up));
            }
        }
        Ok(alignment)
    }

    /// Up before the roll of an orientation that carries none; where it has none, the last one.
    fn up_of(
        &self,
        place: &Place<'_>,
        last: Option<DVec3>,
        (path, rail): (&CameraPath, &Rail),
    ) -> DVec3 {
        let here = path.points[place.point].position;
        let axis = path.space.up.world(DVec3::Y);
        let (segments, start) = (rail.chain.curves.len(), rail.chain.starts[place.point]);
        let toward = match &place.orientation.own.up {
            UpVector::Axis => return path.space.up.level_axes(place.view).1,
            UpVector::Fixed(axis) => return axis.level_axes(place.view).1,
            UpVector::Minimal => Some(axis),
            UpVector::Point(point) => Some(*point - here),
            UpVector::Path(up) if rail.chain.length() > 0.0 => {
                Some(up.place(start / rail.chain.length()) - here)
            }
            UpVector::Path(up) => Some(up.place(0.0) - here),
            UpVector::Frenet => match &self.normals {
                Some(normals) if place.point < segments => {
                    normals.up(place.point, (0.0, 0.0), place.view)
                }
                Some(normals) => normals.up(segments - 1, (1.0, 1.0), place.view),
                None => Some(axis),
            },
        };
        toward
            .and_then(|up| perpendicular(up, place.view))
            .or_else(|| perpendicular(last?, place.view))
            .unwrap_or_else(|| path.space.up.level_axes(place.view).1)
    }

    /// The up with which a minimal one reaches the orientation `to`.
    fn carry(
        &mut self,
        places: &[Place<'_>],
        (from, up): (usize, DVec3),
        to: usize,
        (path, rail): (&CameraPath, &Arc<Rail>),
    ) -> Result<DVec3> {
        let (a, b) = (&places[from], &places[to]);
        let segment = a
            .last
            .then_some(a.point)
            .filter(|&segment| segment < rail.chain.curves.len());
        let look = look_between(&a.end(), &b.end(), path.space.up);
        let length =
            segment.map(|segment| rail.chain.starts[segment + 1] - rail.chain.starts[segment]);
        let (Some(look), Some(segment), Some(length)) =
            (look, segment, length.filter(|length| *length > 0.0))
        else {
            return Ok(shortest(up, a.view, b.view));
        };
        let follow = Follow {
            rail: rail.clone(),
            segment: Some((segment, length)),
            look,
            still: path.space.up.upright(a.view),
            up: None,
            level: path.space.up,
            roll: [0.0; 4],
        };
        let nodes = carried(&follow, (segment, length), (a.view, up))?;
        let (view, up) = nodes[nodes.len() - 1];
        let turn = [0.0; 2];
        self.carried[from] = Some(try_arc(TransportedFrame { nodes, turn })?);
        Ok(shortest(up, view, b.view))
    }

    /// Spreads the angle that is missing at the end of a closed path over its length.
    fn close(
        &mut self,
        places: &[Place<'_>],
        arrived: DVec3,
        (path, rail): (&CameraPath, &Rail),
    ) -> Result<()> {
        let axes = path.space.up;
        let Some(first) = self.ups[0].map(|up| axes.world(up)) else {
            return Ok(());
        };
        let missing = signed_angle(arrived, first, places[0].view);
        if !(rail.chain.length() > 0.0) {
            return Ok(());
        }
        let turn = |point: usize| missing * rail.chain.starts[point] / rail.chain.length();
        for (at, place) in places.iter().enumerate() {
            let view = axes.upright(place.view);
            self.ups[at] = self.ups[at].map(|up| turned(up, view, turn(place.point)));
            if let Some(carried) = &mut self.carried[at] {
                can_allocate(size_of::<TransportedFrame>() + 2 * size_of::<usize>())?;
                Arc::make_mut(carried).turn = [turn(place.point), turn(place.point + 1)];
            }
        }
        Ok(())
    }

    /// Whether the curve is straight all the way.
    pub(super) fn has_no_normals(&self) -> bool {
        self.normals.is_none()
    }

    /// Up before the roll of an orientation, in y-up axes; `None` where it is an axis.
    pub(super) fn up(&self, slot: usize) -> Option<DVec3> {
        self.ups[slot]
    }

    /// The up along the section from an orientation, if it follows a rule; `moves`: on the curve.
    pub(super) fn along(
        &self,
        slot: usize,
        rule: &UpVector,
        moves: bool,
        space: Space,
    ) -> Option<UpAlong> {
        let key = || self.ups[slot].map(|up| UpAlong::Key(space.up.world(up)));
        match rule {
            UpVector::Axis | UpVector::Fixed(_) => None,
            _ if !moves => key(),
            UpVector::Point(point) => Some(UpAlong::Point(*point)),
            UpVector::Path(path) => Some(UpAlong::Path(path.clone())),
            UpVector::Minimal => self.carried[slot].clone().map(UpAlong::Minimal),
            UpVector::Frenet => match &self.normals {
                Some(normals) => Some(UpAlong::Frenet(normals.clone())),
                None => Some(UpAlong::Key(space.up.world(DVec3::Y))),
            },
        }
    }
}

/// Directions and ups at equal steps of a segment's parameter, halved until the twist settles.
fn carried(
    follow: &Follow,
    way: (usize, f64),
    (view, up): (DVec3, DVec3),
) -> Result<Vec<(DVec3, DVec3)>> {
    let arc = ArcLength::new(&follow.rail.chain.curves[way.0])?;
    let ahead = matches!(follow.look, Look::Ahead(distance) if distance > 0.0);
    let seen =
        |t: f64| follow.look_direction(way, t, if ahead { arc.length_at(t) / way.1 } else { t });
    let [mut steps, most] = STEPS;
    // Directions at the ends and in the middle of each step.
    let mut views: Vec<Option<DVec3>> = vec_with_room(2 * steps + 1)?;
    views.extend((0..=2 * steps).map(|k| seen(k as f64 / (2 * steps) as f64)));
    let mut last: Option<DVec3> = None;
    loop {
        let mut nodes = vec_with_room(steps + 1)?;
        let first = views[0].unwrap_or(view);
        let mut here = (first, shortest(up, view, first));
        nodes.push(here);
        for k in 0..steps {
            let [middle, next] = [1, 2].map(|half| views[2 * k + half]);
            // Where there is no direction the last one holds.
            if let Some(next) = next {
                let chord = chord(here.0, middle.unwrap_or(next), next);
                here = (next, step(here.1, here.0, next, chord));
            }
            nodes.push(here);
        }
        if last.is_some_and(|last| (last - here.1).length() < TWIST) || steps >= most {
            return Ok(nodes);
        }
        last = Some(here.1);
        steps *= 2;
        let mut finer = vec_with_room(2 * steps + 1)?;
        finer.extend((0..=2 * steps).map(|k| match k % 2 {
            0 => views[k / 2],
            _ => seen(k as f64 / (2 * steps) as f64),
        }));
        views = finer;
    }
}
