//! The records behind the edits. Applying a record exchanges its values with those of the document,
//! so that it undoes itself: undo and redo are one operation and restore every bit.

use std::mem::swap;

use super::edit::Selection;
use super::edited_scene::{EditedScene, Pins};
use super::info::Info;
use super::normalise::count_orientations;
use super::vid::comments::Comments;
use crate::error::{Result, can_allocate, try_box};
use vides_engine::path::{
    CameraPath, Orientation, OrientationOverrides, Plan, SupportPoint, UpVector,
};
use vides_engine::property::{Affects, Property, SameBits};
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
    /// Checks what the file is to have besides the path, where the path lies and where the scene
    /// does: files are read by the second.
    pub(super) fn check_info(&self, info: &Info) -> Result<()> {
        info.check(self.path.space)?;
        if let Some(edited) = &self.edited_scene {
            info.check(edited.scene().space())?;
        }
        Ok(())
    }

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

    /// Exchanges the path, or if the other one has no points, all but these.
    fn swap_path(&mut self, other: &mut CameraPath) {
        swap(&mut self.path, other);
        if self.path.points.is_empty() {
            swap(&mut self.path.points, &mut other.points);
        } else {
            self.orientations = count_orientations(&self.path.points);
        }
    }
}

/// An exchange of values; its numbers have been checked.
#[derive(Debug)]
pub(super) enum Change {
    /// A point; without orientations all but these.
    Point(usize, SupportPoint),
    /// An orientation by its point and number: whether one goes there, the one that comes, and the
    /// removal that took that away, see [`Comments`]; 0: it is new.
    View([usize; 2], bool, Option<Orientation>, u64),
    /// Points that come there, or, without any, how many go, and the removal. There is room for
    /// these, so that undoing an insertion needs no memory.
    Splice(usize, usize, Vec<SupportPoint>, u64),
    /// A point from one place to another.
    MovePoint(usize, usize),
    Whole(Whole),
    /// The path of another node that is edited, with its pins.
    Edited(Box<CameraPath>, Pins),
    /// A part of the scene, and the removal that took nodes away.
    Part(Part, u64),
    /// One after the other, each on the result of those before it.
    Several(Vec<Change>),
}

/// Whole things, of which those are exchanged that are given.
#[derive(Debug, Default)]
pub(super) struct Whole {
    pub(super) info: Option<Box<Info>>,
    /// One; without points it is the settings of a path.
    pub(super) path: Option<Box<[CameraPath]>>,
    pub(super) pins: Option<Pins>,
    /// With another path or scene.
    pub(super) comments: Option<Comments>,
    /// The scene of the path, which has the pins, too.
    pub(super) scene: Option<Option<Box<EditedScene>>>,
}

impl Change {
    pub(super) fn scene(edited: Option<EditedScene>, comments: &Comments) -> Result<Self> {
        can_allocate(size_of::<EditedScene>())?;
        let comments = match edited {
            Some(_) => comments.in_scene()?,
            None => comments.of_path_alone()?,
        };
        Ok(Self::Whole(Whole {
            comments: Some(comments),
            scene: Some(edited.map(Box::new)),
            ..Whole::default()
        }))
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
            Self::Whole(whole) => [whole.scene.is_some() && whole.path.is_none(), false],
            Self::Edited(..) => [true, false],
            _ => [false; 2],
        }
    }

    pub(super) fn info(info: Box<Info>) -> Self {
        Self::Whole(Whole {
            info: Some(info),
            ..Whole::default()
        })
    }

    /// The settings of the path: all but its points.
    pub(super) fn settings(path: CameraPath) -> Result<Self> {
        Ok(Self::Whole(Whole {
            path: Some(try_box(path)?),
            ..Whole::default()
        }))
    }

    /// Whether it may leave an orientation without a defined up vector, which must be refused.
    pub(super) fn may_undefine_ups(&self) -> bool {
        let demands = |o: &Orientation| matches!(o.own.up, UpVector::Frenet | UpVector::Path(_));
        let shapes = |point: &SupportPoint| {
            point.tangents.is_some() || point.orientations.iter().any(demands)
        };
        match self {
            Self::Several(changes) => changes.iter().any(Self::may_undefine_ups),
            Self::View(_, _, comes, _) => comes.as_ref().is_some_and(demands),
            Self::Point(_, point) => shapes(point),
            Self::Splice(_, _, points, _) => points.iter().any(shapes),
            Self::Whole(whole) => whole.path.is_some(),
            // What there was, and paths that were checked.
            Self::MovePoint(..) | Self::Edited(..) | Self::Part(..) => false,
        }
    }

    /// Reserves memory for applying. Undo and redo need none, since vectors of a path never shrink.
    pub(super) fn reserve(&self, state: &mut State) -> Result<()> {
        let points = &mut state.path.points;
        match self {
            Self::Splice(_, _, new, _) => points.try_reserve(new.len())?,
            Self::View([point, _], false, ..) => {
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
        let points = &state.path.points;
        match self {
            Self::View([point, at], true, Some(view), _) => {
                points[*point].orientations[*at].same_bits(view)
            }
            Self::Point(at, point) => points[*at].same_bits(point),
            Self::Several(changes) => changes.iter().all(|change| change.is_idle(state)),
            Self::MovePoint(from, to) => from == to,
            _ => false,
        }
    }

    /// Exchanges its values with those of the document; it then undoes itself. Tells `plan` what
    /// that makes out of date.
    ///
    /// # Errors
    /// What is wrong with a part of the scene; nothing has changed then.
    pub(super) fn apply(&mut self, state: &mut State, plan: &mut Plan) -> Result<()> {
        let path = &mut state.path;
        match self {
            Self::Several(changes) => {
                return exchange_all(changes, |change| change.apply(state, plan));
            }
            Self::Point(at, point) => {
                let there = &mut path.points[*at];
                if point.orientations.is_empty() {
                    let idle = |row: &Property<SupportPoint>| {
                        row.keys.is_empty()
                            || row.affects == Affects::Nothing
                            || (row.same)(there, point)
                    };
                    if !SupportPoint::PROPERTIES.iter().all(idle) {
                        plan.point_changed(*at);
                    }
                    swap(&mut there.orientations, &mut point.orientations);
                } else {
                    plan.all_changed();
                    state.orientations -= there.orientations.len();
                    state.orientations += point.orientations.len();
                }
                swap(there, point);
            }
            Self::View(..) => self.exchange_view(state, plan),
            Self::Splice(at, gone, points, removal) => {
                plan.all_changed();
                if points.is_empty() {
                    points.extend(path.points.drain(*at..*at + *gone));
                    state.orientations -= count_orientations(points);
                    *removal = state.points_removed(*at, *gone);
                } else {
                    *gone = points.len();
                    state.orientations += count_orientations(points);
                    path.points.splice(*at..*at, points.drain(..));
                    state.points_inserted(*at, *gone, *removal);
                }
            }
            Self::MovePoint(from, to) => {
                plan.all_changed();
                // The insertion reuses the room of the removed point.
                let point = path.points.remove(*from);
                path.points.insert(*to, point);
                let removal = state.points_removed(*from, 1);
                state.points_inserted(*to, 1, removal);
                swap(from, to);
            }
            Self::Whole(whole) => {
                if let Some(scene) = &mut whole.scene {
                    swap(&mut state.edited_scene, scene);
                }
                if let Some(comments) = &mut whole.comments {
                    swap(&mut state.comments, comments);
                }
                if let Some(info) = &mut whole.info {
                    swap(&mut state.info, info);
                }
                if let (Some(edited), Some(pins)) = (&mut state.edited_scene, &mut whole.pins) {
                    edited.exchange_pins(pins);
                }
                if let Some([path]) = whole.path.as_deref_mut() {
                    plan.all_changed();
                    state.swap_path(path);
                }
            }
            Self::Edited(path, pins) => {
                plan.all_changed();
                if let Some(edited) = &mut state.edited_scene {
                    edited.exchange_pins(pins);
                }
                state.swap_path(path);
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
        }
        Ok(())
    }

    fn exchange_view(&mut self, state: &mut State, plan: &mut Plan) {
        let Self::View([point, at], goes, comes, removal) = self else {
            return;
        };
        let node = state.node();
        let views = &mut state.path.points[*point].orientations;
        if let (true, Some(view)) = (*goes, &mut *comes) {
            plan.point_changed(*point);
            swap(&mut views[*at], view);
            return;
        }
        plan.all_changed();
        let comments = &mut state.comments;
        if let Some(view) = comes.take() {
            views.insert(*at, view);
            state.orientations += 1;
            comments.insert_orientation(node, *point, *at, *removal);
        } else {
            *comes = Some(views.remove(*at));
            state.orientations -= 1;
            *removal = comments.remove_orientation(node, *point, *at);
        }
        *goes = comes.is_none();
    }

    /// Whether both exchange the same value, so that within a step the older one suffices.
    pub(super) fn is_at_place_of(&self, other: &Self) -> bool {
        let place = |change: &Self| match change {
            Self::Point(at, point) if point.orientations.is_empty() => Some([*at, usize::MAX]),
            Self::View(place, true, Some(_), _) => Some(*place),
            _ => None,
        };
        match (self, other) {
            (Self::Part(one, _), Self::Part(other, _)) => one.is_at_place_of(other),
            (Self::Whole(one), Self::Whole(other)) => one.given() == other.given(),
            _ => place(self).is_some_and(|here| Some(here) == place(other)),
        }
    }

    /// Whether it changes the numbers of other places.
    pub(super) fn renumbers(&self) -> bool {
        match self {
            Self::Several(changes) => changes.iter().any(Self::renumbers),
            Self::Part(part, _) => !part.is_value(),
            Self::Whole(whole) => whole.comments.is_some(),
            Self::View(_, goes, comes, _) => !goes || comes.is_none(),
            Self::Point(..) => false,
            Self::Splice(..) | Self::MovePoint(..) | Self::Edited(..) => true,
        }
    }

    /// Approximate bytes of memory.
    pub(super) fn weight(&self) -> usize {
        let beyond = match self {
            Self::Point(_, point) => weigh(std::slice::from_ref(point)),
            Self::Splice(_, _, points, _) => {
                let room = points.capacity() - points.len();
                weigh(points) + room * size_of::<SupportPoint>()
            }
            Self::Whole(whole) => whole.weight(),
            Self::Edited(path, _) => weigh_path(path),
            Self::Part(part, _) => part.heap_size(),
            Self::Several(changes) => changes.iter().map(Self::weight).sum(),
            Self::View(..) | Self::MovePoint(..) => 0,
        };
        size_of::<Self>() + beyond
    }
}

impl Whole {
    fn given(&self) -> [bool; 4] {
        let (info, path) = (self.info.is_some(), self.path.is_some());
        [info, path, self.pins.is_some(), self.comments.is_some()]
    }

    fn weight(&self) -> usize {
        let info = |info: &Info| info.title.len() + info.comment.len() + info.object.bytes();
        let scene = self.scene.iter().flatten().map(|scene| scene.weight());
        self.info.as_deref().map_or(0, info)
            + self.path.iter().flatten().map(weigh_path).sum::<usize>()
            + scene.sum::<usize>()
    }
}

/// The record of what changes nothing.
pub(super) const IDLE: Change = Change::Several(Vec::new());

/// The record of an edit, and the selection it sets, if any.
pub(super) type Prepared = (Change, Option<Selection>);

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

fn weigh_path(path: &CameraPath) -> usize {
    size_of::<CameraPath>() + weigh(&path.points)
}

fn weigh(points: &[SupportPoint]) -> usize {
    let owned = points
        .iter()
        .flat_map(|point| &point.orientations)
        .filter(|orientation| !orientation.own.is_empty())
        .count();
    let names = points.iter().filter_map(|point| point.name.as_ref());
    size_of_val(points)
        + names.map(String::len).sum::<usize>()
        + count_orientations(points) * size_of::<Orientation>()
        + owned * size_of::<OrientationOverrides>()
}
