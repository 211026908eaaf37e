//! The records behind the edits. Applying a record swaps its values in and returns the record that
//! undoes it, so that undo and redo are one operation and restore every bit.

use glam::DVec3;

use super::around::Around;
use super::info::Info;
use super::vid::Comments;
use crate::error::{Result, vec_with_room};
use crate::path::{
    BaseSpeeds, CameraPath, CurveKind, CurveParameters, Orientation, OrientationMode, Own, Plan,
    Space, SupportPoint, Tangents, Target, Tcb, UpVector, ZoomMode,
};

/// The state that records change.
#[derive(Debug)]
pub(super) struct Content {
    pub(super) path: CameraPath,
    pub(super) around: Option<Box<Around>>,
    pub(super) info: Info,
    /// Number of orientations of all points.
    pub(super) orientations: usize,
    pub(super) comments: Comments,
}

impl Content {
    pub(super) fn new(path: CameraPath, info: Info) -> Self {
        let orientations = count_orientations(&path.points);
        Self {
            path,
            around: None,
            info,
            orientations,
            comments: Comments::default(),
        }
    }
}

pub(super) fn count_orientations(points: &[SupportPoint]) -> usize {
    points.iter().map(|point| point.orientations.len()).sum()
}

/// An exchange of values; its indices have been checked.
#[derive(Debug)]
pub(super) enum Change {
    Position {
        at: usize,
        position: DVec3,
    },
    Name {
        at: usize,
        name: Option<String>,
    },
    Curve {
        at: usize,
        curve: CurveParameters,
    },
    Orientation {
        point: usize,
        at: usize,
        orientation: Orientation,
    },
    Preset {
        preset: usize,
        tcb: Tcb,
    },
    Speeds(BaseSpeeds),
    Closed(bool),
    CurveKind(CurveKind),
    /// A whole point, orientations included.
    Point {
        at: usize,
        point: SupportPoint,
    },
    Tangents {
        at: usize,
        tangents: Option<Tangents>,
    },
    /// One after the other, each on the result of those before it.
    Several(Vec<Change>),
    Modes(OrientationMode, ZoomMode),
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
    /// A path, and the removal that took its points away.
    Path(Box<CameraPath>, u64),
    /// As `Path`, with the scene around it.
    Scene(Option<Box<Around>>, Box<CameraPath>, u64),
}

impl Change {
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
            Self::Tangents { tangents, .. } => tangents.is_some(),
            Self::CurveKind(_) | Self::Path(..) | Self::MovePoint { .. } => true,
            _ => false,
        }
    }

    /// Reserves memory for applying. Undo and redo need none, since vectors of a path never shrink.
    pub(super) fn reserve(&self, content: &mut Content) -> Result<()> {
        let points = &mut content.path.points;
        match self {
            Self::InsertPoints { points: new, .. } => points.try_reserve(new.len())?,
            Self::InsertOrientation { point, .. } => {
                points[*point].orientations.try_reserve_exact(1)?;
            }
            // Only the first one inserts; the others exchange values.
            Self::Several(changes) => {
                if let Some(first) = changes.first() {
                    first.reserve(content)?;
                }
            }
            _ => {}
        }
        Ok(())
    }

    pub(super) fn is_idle(&self, content: &Content) -> bool {
        let path = &content.path;
        match self {
            Self::Position { at, position } => same_vector(path.points[*at].position, *position),
            Self::Name { at, name } => path.points[*at].name == *name,
            Self::Curve { at, curve } => match (path.points[*at].curve, *curve) {
                (CurveParameters::Preset(a), CurveParameters::Preset(b)) => a == b,
                (CurveParameters::Own(a), CurveParameters::Own(b)) => same_tcb(a, b),
                _ => false,
            },
            Self::Orientation {
                point,
                at,
                orientation,
            } => same_orientation(&path.points[*point].orientations[*at], orientation),
            Self::Preset { preset, tcb } => same_tcb(path.presets[*preset], *tcb),
            // Base speeds are > 0, so there is no −0.
            Self::Speeds(speeds) => path.speeds == *speeds,
            Self::Closed(closed) => path.closed == *closed,
            Self::CurveKind(curve) => path.curve == *curve,
            Self::Tangents { at, tangents } => same_tangents(path.points[*at].tangents, *tangents),
            Self::Point { at, point } => {
                let there = &path.points[*at];
                let mut views = there.orientations.iter().zip(&point.orientations);
                same_vector(there.position, point.position)
                    && there.name == point.name
                    && there.curve == point.curve
                    && same_tangents(there.tangents, point.tangents)
                    && there.orientations.len() == point.orientations.len()
                    && views.all(|(a, b)| same_orientation(a, b))
            }
            Self::Several(changes) => changes.iter().all(|change| change.is_idle(content)),
            Self::Modes(orientation, zoom) => {
                path.orientation_mode == *orientation && path.zoom_mode == *zoom
            }
            Self::Space(space) => {
                same_vector(path.space.centre, space.centre) && path.space == *space
            }
            Self::MovePoint { from, to } => from == to,
            _ => false,
        }
    }

    pub(super) fn apply(self, content: &mut Content) -> Self {
        let path = &mut content.path;
        match self {
            Self::Position { at, position } => Self::Position {
                at,
                position: std::mem::replace(&mut path.points[at].position, position),
            },
            Self::Name { at, name } => Self::Name {
                at,
                name: std::mem::replace(&mut path.points[at].name, name),
            },
            Self::Curve { at, curve } => Self::Curve {
                at,
                curve: std::mem::replace(&mut path.points[at].curve, curve),
            },
            Self::Orientation {
                point,
                at,
                orientation,
            } => Self::Orientation {
                point,
                at,
                orientation: std::mem::replace(
                    &mut path.points[point].orientations[at],
                    orientation,
                ),
            },
            Self::Preset { preset, tcb } => Self::Preset {
                preset,
                tcb: std::mem::replace(&mut path.presets[preset], tcb),
            },
            Self::Speeds(speeds) => Self::Speeds(std::mem::replace(&mut path.speeds, speeds)),
            Self::Closed(closed) => Self::Closed(std::mem::replace(&mut path.closed, closed)),
            Self::CurveKind(curve) => Self::CurveKind(std::mem::replace(&mut path.curve, curve)),
            Self::Point { at, mut point } => {
                let there = &mut path.points[at];
                content.orientations += point.orientations.len();
                content.orientations -= there.orientations.len();
                std::mem::swap(there, &mut point);
                Self::Point { at, point }
            }
            Self::Tangents { at, tangents } => Self::Tangents {
                at,
                tangents: std::mem::replace(&mut path.points[at].tangents, tangents),
            },
            Self::Several(mut changes) => {
                for change in &mut changes {
                    let one = std::mem::replace(change, Self::Closed(false));
                    *change = one.apply(content);
                }
                changes.reverse();
                Self::Several(changes)
            }
            Self::Modes(orientation, zoom) => Self::Modes(
                std::mem::replace(&mut path.orientation_mode, orientation),
                std::mem::replace(&mut path.zoom_mode, zoom),
            ),
            Self::Space(space) => Self::Space(std::mem::replace(&mut path.space, space)),
            Self::InsertPoints {
                at,
                mut points,
                removal,
            } => {
                let count = points.len();
                content.comments.insert_points(at, count, removal);
                if let Some(around) = &mut content.around {
                    around.pins_mut().insert_points(at, count, removal);
                }
                content.orientations += count_orientations(&points);
                path.points.splice(at..at, points.drain(..));
                Self::RemovePoints {
                    at,
                    count,
                    room: points,
                }
            }
            Self::RemovePoints {
                at,
                count,
                mut room,
            } => {
                room.extend(path.points.drain(at..at + count));
                content.orientations -= count_orientations(&room);
                let removal = content.comments.remove_points(at, count);
                if let Some(around) = &mut content.around {
                    around.pins_mut().remove_points(at, count, removal);
                }
                Self::InsertPoints {
                    at,
                    points: room,
                    removal,
                }
            }
            Self::MovePoint { from, to } => {
                // The insertion reuses the room of the removed point.
                let point = path.points.remove(from);
                path.points.insert(to, point);
                let removal = content.comments.remove_points(from, 1);
                content.comments.insert_points(to, 1, removal);
                if let Some(around) = &mut content.around {
                    around.pins_mut().remove_points(from, 1, removal);
                    around.pins_mut().insert_points(to, 1, removal);
                }
                Self::MovePoint { from: to, to: from }
            }
            Self::InsertOrientation {
                point,
                at,
                orientation,
                removal,
            } => {
                content.comments.insert_orientation(point, at, removal);
                path.points[point].orientations.insert(at, orientation);
                content.orientations += 1;
                Self::RemoveOrientation { point, at }
            }
            Self::RemoveOrientation { point, at } => {
                content.orientations -= 1;
                Self::InsertOrientation {
                    point,
                    at,
                    orientation: path.points[point].orientations.remove(at),
                    removal: content.comments.remove_orientation(point, at),
                }
            }
            Self::Info(mut info) => {
                std::mem::swap(&mut content.info, &mut info);
                Self::Info(info)
            }
            Self::Path(mut other, removal) => {
                let old = content.comments.remove_points(0, path.points.len());
                content.comments.insert_points(0, 0, removal);
                std::mem::swap(path, &mut other);
                content.orientations = count_orientations(&path.points);
                Self::Path(other, old)
            }
            Self::Scene(mut around, path, removal) => {
                std::mem::swap(&mut content.around, &mut around);
                match Self::Path(path, removal).apply(content) {
                    Self::Path(path, removal) => Self::Scene(around, path, removal),
                    other => other,
                }
            }
        }
    }

    /// Tells `plan` what applying it makes out of date.
    pub(super) fn announce(&self, plan: &mut Plan) {
        match self {
            Self::Name { .. } | Self::Info(_) => {}
            Self::Position { at, .. } | Self::Curve { at, .. } | Self::Tangents { at, .. } => {
                plan.point_changed(*at)
            }
            Self::Orientation { point, .. } => plan.point_changed(*point),
            _ => plan.all_changed(),
        }
    }

    /// Whether both exchange the same value, so that within a step the older one suffices.
    pub(super) fn is_at_place_of(&self, other: &Self) -> bool {
        match (self, other) {
            (Self::Position { at: a, .. }, Self::Position { at: b, .. })
            | (Self::Name { at: a, .. }, Self::Name { at: b, .. })
            | (Self::Curve { at: a, .. }, Self::Curve { at: b, .. })
            | (Self::Tangents { at: a, .. }, Self::Tangents { at: b, .. })
            | (Self::Preset { preset: a, .. }, Self::Preset { preset: b, .. }) => a == b,
            (
                Self::Orientation {
                    point: p, at: a, ..
                },
                Self::Orientation {
                    point: q, at: b, ..
                },
            ) => (p, a) == (q, b),
            (Self::Speeds(_), Self::Speeds(_))
            | (Self::Closed(_), Self::Closed(_))
            | (Self::CurveKind(_), Self::CurveKind(_))
            | (Self::Modes(..), Self::Modes(..))
            | (Self::Space(_), Self::Space(_))
            | (Self::Info(_), Self::Info(_)) => true,
            _ => false,
        }
    }

    /// Whether it changes the numbers of other places.
    pub(super) fn renumbers(&self) -> bool {
        if let Self::Several(changes) = self {
            return changes.iter().any(Self::renumbers);
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
        )
    }

    /// Approximate bytes of memory.
    pub(super) fn weight(&self) -> usize {
        let beyond = match self {
            Self::Name { name, .. } => name.as_ref().map_or(0, String::len),
            Self::InsertPoints { points, .. } => weigh(points),
            Self::RemovePoints { room, .. } => room.capacity() * size_of::<SupportPoint>(),
            Self::Info(info) => info.title.len() + info.comment.len() + size_of_val(&*info.object),
            Self::Path(path, _) => weigh(&path.points),
            Self::Scene(around, path, _) => {
                weigh(&path.points) + around.as_ref().map_or(0, |around| around.weight())
            }
            Self::Point { point, .. } => weigh(std::slice::from_ref(point)),
            Self::Several(changes) => changes.iter().map(Self::weight).sum(),
            _ => 0,
        };
        size_of::<Self>() + beyond
    }
}

fn weigh(points: &[SupportPoint]) -> usize {
    let owned = points
        .iter()
        .flat_map(|point| &point.orientations)
        .filter(|orientation| !orientation.own.is_empty())
        .count();
    size_of_val(points)
        + count_orientations(points) * size_of::<Orientation>()
        + owned * size_of::<Own>()
}

/// Bitwise equality: 0 and −0 differ.
fn same_number(a: f64, b: f64) -> bool {
    a.to_bits() == b.to_bits()
}

fn same_vector(a: DVec3, b: DVec3) -> bool {
    a.to_array().map(f64::to_bits) == b.to_array().map(f64::to_bits)
}

fn same_tangents(a: Option<Tangents>, b: Option<Tangents>) -> bool {
    match (a, b) {
        (None, None) => true,
        (Some(a), Some(b)) => same_vector(a.before, b.before) && same_vector(a.after, b.after),
        _ => false,
    }
}

fn same_tcb(a: Tcb, b: Tcb) -> bool {
    same_number(a.tension, b.tension)
        && same_number(a.continuity, b.continuity)
        && same_number(a.bias, b.bias)
}

fn same_orientation(a: &Orientation, b: &Orientation) -> bool {
    let same_target = match (a.target, b.target) {
        (Target::Absolute(a), Target::Absolute(b)) | (Target::Relative(a), Target::Relative(b)) => {
            same_vector(a, b)
        }
        _ => false,
    };
    // Zoom and speeds are ≥ 1, so `==` is bitwise there.
    same_target
        && same_number(a.roll, b.roll)
        && same_tcb(a.turning, b.turning)
        && a.zoom == b.zoom
        && a.speeds == b.speeds
        && a.hold == b.hold
        && a.own.is_same(&b.own)
}
