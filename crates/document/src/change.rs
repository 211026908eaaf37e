//! The records behind the edits. Applying a record exchanges its values with those of the document,
//! so that it undoes itself: undo and redo are one operation and restore every bit.

use std::mem::{swap, take};

use super::edited_scene::{EditedScene, Pins};
use super::info::Info;
use super::vid::Comments;
use crate::error::{Result, can_allocate, vec_with_room};
use crate::path::{
    CameraPath, Orientation, OrientationOverrides, Plan, Space, SupportPoint, UpVector,
};
use vides_engine::property::{Affects, Property, SameBits, Value};
use vides_engine::scene::{Part, Scene};

/// The state that records change.
#[derive(Debug)]
pub(super) struct State {
    pub(super) path: CameraPath,
    pub(super) edited_scene: Option<Box<EditedScene>>,
    pub(super) info: Info,
    /// Number of orientations of all points.
    pub(super) orientations: usize,
    pub(super) comments: Comments,
}

impl State {
    pub(super) fn new(path: CameraPath, info: Info) -> Self {
        let orientations = count_orientations(&path.points);
        Self {
            path,
            edited_scene: None,
            info,
            orientations,
            comments: Comments::default(),
        }
    }

    /// Renumbers what is attached to points; see [`Comments::insert_points`].
    fn points_inserted(&mut self, at: usize, count: usize, removal: u64) {
        let node = self.node();
        self.comments.insert_points(node, at, count, removal);
        if let Some(edited) = &mut self.edited_scene {
            edited.pins_mut().insert_points(at, count, removal);
        }
    }

    /// The same for removed points; returns the number of the removal.
    fn points_removed(&mut self, at: usize, count: usize) -> u64 {
        let removal = self.comments.remove_points(self.node(), at, count);
        if let Some(edited) = &mut self.edited_scene {
            edited.pins_mut().remove_points(at, count, removal);
        }
        removal
    }

    /// The node whose path is edited; none: there is no scene, or no path is.
    pub(super) fn node(&self) -> Option<usize> {
        self.edited_scene.as_ref().and_then(|edited| edited.node())
    }

    fn swap_path(&mut self, path: &mut CameraPath) {
        swap(&mut self.path, path);
        self.orientations = count_orientations(&self.path.points);
    }
}

pub(super) fn count_orientations(points: &[SupportPoint]) -> usize {
    points.iter().map(|point| point.orientations.len()).sum()
}

/// An exchange of values; its indices have been checked.
#[derive(Debug)]
pub(super) enum Change {
    /// A property of the path.
    OfPath(&'static Property<CameraPath>, Value),
    /// A property of a point.
    OfPoint(usize, &'static Property<SupportPoint>, Value),
    Orientation {
        point: usize,
        at: usize,
        orientation: Orientation,
    },
    /// A whole point, orientations included.
    Point {
        at: usize,
        point: SupportPoint,
    },
    /// One after the other, each on the result of those before it.
    Several(Vec<Change>),
    Space(Space),
    InsertPoints {
        at: usize,
        points: Vec<SupportPoint>,
        /// The removal that took them away, see [`Comments`]; 0: they are new.
        removal: u64,
    },
    /// `room` has capacity for `count` points, so that undoing an insertion needs no memory.
    RemovePoints {
        at: usize,
        count: usize,
        room: Vec<SupportPoint>,
    },
    MovePoint {
        from: usize,
        to: usize,
    },
    InsertOrientation {
        point: usize,
        at: usize,
        orientation: Orientation,
        removal: u64,
    },
    RemoveOrientation {
        point: usize,
        at: usize,
    },
    Info(Box<Info>),
    /// A path, its pins, and the removal that took its points away.
    Path(Box<CameraPath>, Pins, u64),
    /// A path with its scene, which has the pins, and all comments.
    Scene(Option<Box<EditedScene>>, Box<CameraPath>, Comments),
    /// The scene of the path, which stays, and all comments.
    SceneOf(Option<Box<EditedScene>>, Comments),
    /// A part of the scene, and the removal that took nodes away.
    Part(Part, u64),
    /// The pins of the edited path.
    Pins(Pins),
    /// Another node whose path is edited.
    Edited(Box<Exchange>),
}

/// A node whose path is edited, with that path.
#[derive(Debug)]
pub(super) struct Exchange {
    pub(super) node: Option<usize>,
    pub(super) path: CameraPath,
    pub(super) pins: Pins,
}

impl Change {
    pub(super) fn scene(edited: Option<EditedScene>, comments: &Comments) -> Result<Self> {
        can_allocate(size_of::<EditedScene>())?;
        let comments = match edited {
            Some(_) => comments.in_scene()?,
            None => comments.of_path_alone()?,
        };
        Ok(Self::SceneOf(edited.map(Box::new), comments))
    }

    /// Whether this scene is as it makes it.
    pub(super) fn has(&self, scene: &Scene) -> bool {
        matches!(self, Self::Part(part, _) if scene.has(part))
    }

    /// Whether it changes the scene, and what its pins or its paths are.
    pub(super) fn of_scene(&self) -> [bool; 2] {
        match self {
            Self::Several(changes) => changes
                .iter()
                .map(Self::of_scene)
                .fold([false; 2], |a, b| [a[0] || b[0], a[1] || b[1]]),
            Self::Part(part, _) => {
                let pins = matches!(
                    part,
                    Part::Marker { .. } | Part::Pin { .. } | Part::Path { .. } | Part::Start { .. }
                );
                [true, pins]
            }
            Self::SceneOf(..) | Self::Edited(_) => [true, false],
            _ => [false; 2],
        }
    }

    pub(super) fn remove_point(at: usize) -> Result<Self> {
        Ok(Self::RemovePoints {
            at,
            count: 1,
            room: vec_with_room(1)?,
        })
    }

    /// Whether it may leave an orientation without a defined up vector, which must be refused.
    pub(super) fn may_undefine_ups(&self) -> bool {
        let demands = |o: &Orientation| matches!(o.own.up, UpVector::Frenet | UpVector::Path(_));
        let shapes = |point: &SupportPoint| {
            point.tangents.is_some() || point.orientations.iter().any(demands)
        };
        match self {
            Self::Several(changes) => changes.iter().any(Self::may_undefine_ups),
            Self::Orientation { orientation, .. } | Self::InsertOrientation { orientation, .. } => {
                demands(orientation)
            }
            Self::Point { point, .. } => shapes(point),
            Self::InsertPoints { points, .. } => points.iter().any(shapes),
            Self::OfPoint(_, row, value) => row.key() == "tangents" && *value != Value::Unset,
            Self::OfPath(row, _) => row.key() == "curve",
            Self::Path(..) | Self::MovePoint { .. } | Self::Edited(_) => true,
            _ => false,
        }
    }

    /// Reserves memory for applying. Undo and redo need none, since vectors of a path never shrink.
    pub(super) fn reserve(&self, state: &mut State) -> Result<()> {
        let points = &mut state.path.points;
        match self {
            Self::InsertPoints { points: new, .. } => points.try_reserve(new.len())?,
            Self::InsertOrientation { point, .. } => {
                points[*point].orientations.try_reserve_exact(1)?;
            }
            // Only the first one inserts; the others exchange values.
            Self::Several(changes) => {
                if let Some(first) = changes.first() {
                    first.reserve(state)?;
                }
            }
            _ => {}
        }
        Ok(())
    }

    pub(super) fn is_idle(&self, state: &State) -> bool {
        let path = &state.path;
        match self {
            Self::Orientation {
                point,
                at,
                orientation,
            } => path.points[*point].orientations[*at].same_bits(orientation),
            Self::Point { at, point } => path.points[*at].same_bits(point),
            Self::Several(changes) => changes.iter().all(|change| change.is_idle(state)),
            Self::Space(space) => path.space.same_bits(space),
            Self::MovePoint { from, to } => from == to,
            _ => false,
        }
    }

    /// Exchanges its values with those of the document; it then undoes itself.
    ///
    /// # Errors
    /// What is wrong with a part of the scene; nothing has changed then.
    pub(super) fn apply(&mut self, state: &mut State, plan: &mut Plan) -> Result<()> {
        self.announce(plan);
        self.exchange(state)
    }

    fn exchange(&mut self, state: &mut State) -> Result<()> {
        match self {
            Self::Several(changes) => {
                return exchange_all(changes, |change| change.exchange(state));
            }
            Self::Part(part, removal) => {
                if let Some(edited) = &mut state.edited_scene {
                    edited.exchange(part)?;
                }
                match part {
                    // What is to be removed has come, and the other way round.
                    Part::Remove(places) => state.comments.insert_nodes(places, *removal),
                    Part::Insert(list) => *removal = state.comments.remove_nodes(list.places()),
                    _ => {}
                }
            }
            Self::Pins(pins) => {
                if let Some(edited) = &mut state.edited_scene {
                    swap(edited.pins_mut(), pins);
                }
            }
            Self::SceneOf(scene, comments) => {
                swap(&mut state.edited_scene, scene);
                swap(&mut state.comments, comments);
            }
            Self::Edited(other) => {
                if let Some(edited) = &mut state.edited_scene {
                    swap(edited.pins_mut(), &mut other.pins);
                    edited.exchange_node(&mut other.node);
                }
                state.swap_path(&mut other.path);
            }
            Self::Scene(scene, path, comments) => {
                swap(&mut state.edited_scene, scene);
                swap(&mut state.comments, comments);
                state.swap_path(path);
            }
            of_path => of_path.exchange_in_path(state),
        }
        Ok(())
    }

    fn exchange_in_path(&mut self, state: &mut State) {
        let node = state.node();
        let path = &mut state.path;
        match self {
            Self::OfPath(row, value) => {
                (row.exchange)(path, value);
            }
            Self::OfPoint(at, row, value) => {
                (row.exchange)(&mut path.points[*at], value);
            }
            Self::Orientation {
                point,
                at,
                orientation,
            } => swap(&mut path.points[*point].orientations[*at], orientation),
            Self::Point { at, point } => {
                swap(&mut path.points[*at], point);
                state.orientations -= point.orientations.len();
                state.orientations += path.points[*at].orientations.len();
            }
            Self::Space(space) => swap(&mut path.space, space),
            Self::InsertPoints {
                at,
                points,
                removal,
            } => {
                let (at, count, mut room) = (*at, points.len(), take(points));
                state.orientations += count_orientations(&room);
                path.points.splice(at..at, room.drain(..));
                state.points_inserted(at, count, *removal);
                *self = Self::RemovePoints { at, count, room };
            }
            Self::RemovePoints { at, count, room } => {
                let (at, mut points) = (*at, take(room));
                points.extend(path.points.drain(at..at + *count));
                state.orientations -= count_orientations(&points);
                *self = Self::InsertPoints {
                    at,
                    points,
                    removal: state.points_removed(at, *count),
                };
            }
            Self::MovePoint { from, to } => {
                // The insertion reuses the room of the removed point.
                let point = path.points.remove(*from);
                path.points.insert(*to, point);
                let removal = state.points_removed(*from, 1);
                state.points_inserted(*to, 1, removal);
                swap(from, to);
            }
            Self::InsertOrientation {
                point,
                at,
                orientation,
                removal,
            } => {
                let (point, at) = (*point, *at);
                state.comments.insert_orientation(node, point, at, *removal);
                let orientations = &mut path.points[point].orientations;
                orientations.insert(at, take(orientation));
                state.orientations += 1;
                *self = Self::RemoveOrientation { point, at };
            }
            Self::RemoveOrientation { point, at } => {
                state.orientations -= 1;
                *self = Self::InsertOrientation {
                    point: *point,
                    at: *at,
                    orientation: path.points[*point].orientations.remove(*at),
                    removal: state.comments.remove_orientation(node, *point, *at),
                };
            }
            Self::Info(info) => swap(&mut state.info, info),
            Self::Path(other, pins, removal) => {
                if let Some(edited) = &mut state.edited_scene {
                    swap(edited.pins_mut(), pins);
                }
                let count = path.points.len();
                let removed = state.comments.remove_points(node, 0, count);
                state.comments.insert_points(node, 0, 0, *removal);
                *removal = removed;
                state.swap_path(other);
            }
            Self::Several(_)
            | Self::Scene(..)
            | Self::SceneOf(..)
            | Self::Part(..)
            | Self::Pins(_)
            | Self::Edited(_) => {}
        }
    }

    /// Tells `plan` what applying it makes out of date.
    fn announce(&self, plan: &mut Plan) {
        match self {
            Self::Info(_) | Self::Part(..) | Self::SceneOf(..) | Self::Pins(_) => {}
            Self::Several(changes) => changes.iter().for_each(|change| change.announce(plan)),
            Self::OfPath(row, _) if row.affects == Affects::Nothing => {}
            Self::OfPoint(_, row, _) if row.affects == Affects::Nothing => {}
            Self::OfPoint(at, ..) => plan.point_changed(*at),
            Self::Orientation { point, .. } => plan.point_changed(*point),
            _ => plan.all_changed(),
        }
    }

    /// Whether both exchange the same value, so that within a step the older one suffices.
    pub(super) fn is_at_place_of(&self, other: &Self) -> bool {
        match (self, other) {
            (Self::OfPath(a, _), Self::OfPath(b, _)) => a.key() == b.key(),
            (Self::OfPoint(p, a, _), Self::OfPoint(q, b, _)) => (p, a.key()) == (q, b.key()),
            (
                Self::Orientation {
                    point: p, at: a, ..
                },
                Self::Orientation {
                    point: q, at: b, ..
                },
            ) => (p, a) == (q, b),
            (Self::Space(_), Self::Space(_)) | (Self::Info(_), Self::Info(_)) => true,
            _ => false,
        }
    }

    /// Whether it changes the numbers of other places.
    pub(super) fn renumbers(&self) -> bool {
        if let Self::Several(changes) = self {
            return changes.iter().any(Self::renumbers);
        }
        if let Self::Part(part, _) = self {
            return !part.is_value();
        }
        matches!(
            self,
            Self::InsertPoints { .. }
                | Self::RemovePoints { .. }
                | Self::MovePoint { .. }
                | Self::InsertOrientation { .. }
                | Self::RemoveOrientation { .. }
                | Self::Path(..)
                | Self::Scene(..)
                | Self::SceneOf(..)
                | Self::Edited(_)
        )
    }

    /// Approximate bytes of memory.
    pub(super) fn weight(&self) -> usize {
        let beyond = match self {
            Self::OfPoint(.., Value::Text(text)) => text.len(),
            Self::InsertPoints { points, .. } => weigh(points),
            Self::RemovePoints { room, .. } => room.capacity() * size_of::<SupportPoint>(),
            Self::Info(info) => info.title.len() + info.comment.len() + info.object.bytes(),
            Self::Path(path, ..) => weigh(&path.points),
            Self::Scene(scene, path, _) => {
                weigh(&path.points) + scene.as_ref().map_or(0, |scene| scene.weight())
            }
            Self::SceneOf(scene, _) => scene.as_ref().map_or(0, |scene| scene.weight()),
            Self::Part(part, _) => part.heap_size(),
            Self::Edited(other) => size_of::<Exchange>() + weigh(&other.path.points),
            Self::Point { point, .. } => weigh(std::slice::from_ref(point)),
            Self::Several(changes) => changes.iter().map(Self::weight).sum(),
            _ => 0,
        };
        size_of::<Self>() + beyond
    }
}

/// Exchanges one after the other, or none if one cannot be; they then stand in reverse.
pub(super) fn exchange_all<T>(
    changes: &mut [T],
    mut exchange: impl FnMut(&mut T) -> Result<()>,
) -> Result<()> {
    for at in 0..changes.len() {
        if let Err(error) = exchange(&mut changes[at]) {
            // What was exchanged can be again.
            for done in changes[..at].iter_mut().rev() {
                let _ = exchange(done);
            }
            return Err(error);
        }
    }
    changes.reverse();
    Ok(())
}

fn weigh(points: &[SupportPoint]) -> usize {
    let owned = points
        .iter()
        .flat_map(|point| &point.orientations)
        .filter(|orientation| !orientation.own.is_empty())
        .count();
    size_of_val(points)
        + count_orientations(points) * size_of::<Orientation>()
        + owned * size_of::<OrientationOverrides>()
}
