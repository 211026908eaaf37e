//! The edits.

use glam::{DMat4, DVec3};
use vides_engine::deform::{Bounds, Deformation};
use vides_engine::scene::{Keep, Node, Part, Scene};
use vides_engine::tools::block::Fit;

use super::info::Info;
use vides_engine::path::{CameraPath, Orientation, Space, Tangents, Up};
use vides_engine::property::{Value, find};

/// A change of a document. Points, orientations, segments and presets count from 0.
#[derive(Debug, Clone, PartialEq)]
pub enum Edit {
    /// Inserts a support point before point `at`, or after the last. All but the name is copied
    /// from the predecessor (at 0 the successor); an absolute target at the new position becomes
    /// relative, with the predecessor's direction. The new point becomes current.
    InsertPoint {
        /// Number the new point will have.
        at: usize,
        /// Where it lies.
        position: DVec3,
    },
    /// Appends a point to an open path along the curve's end tangent, as far as the last segment is
    /// long, clamped to the movement space. It becomes current.
    AppendAfterLast,
    /// The same before the first point.
    PrependBeforeFirst,
    /// Inserts points on the curve of a segment, at equal arc lengths ("Pos.+" is one point). All
    /// but the name is copied from the segment's first point. The first new one becomes current.
    DivideSegment {
        /// The segment.
        segment: usize,
        /// 1…[`vides_engine::limits::MAX_DIVISION`] new points.
        points: usize,
    },
    /// Inserts a point on the curve at the nearest whole frame. Curve, pace, views and zoom stay as
    /// they are: its neighbours get custom values where needed. It becomes current.
    InsertOnCurve {
        /// From 1 to the number of frames.
        frame: f64,
    },
    /// Fixes the frames of all moving sections from the first orientation of one point to the last
    /// of another, so that the range has exactly `frames` poses, shared anew by the time that each
    /// takes at its speed ([`vides_engine::path::fit_frames::fit_frames`]). All points
    /// of a closed path mean its whole way.
    FitFrames {
        /// The first point.
        first: usize,
        /// The last point.
        last: usize,
        /// The frames.
        frames: usize,
    },
    /// Removes a point, not the last two; its predecessor, else the new first point, becomes
    /// current.
    RemovePoint {
        /// The point.
        at: usize,
    },
    /// Renumbers a point; those between the two places shift by one. It becomes current.
    MovePoint {
        /// The point.
        from: usize,
        /// The number that it will have.
        to: usize,
    },
    /// Sets a property, see [`crate::properties`]. A point moves with its relative targets, and is
    /// refused where one of its absolute targets lies; aiming at something ends looking along the
    /// path; else as [`Edit::SetOrientation`].
    Set {
        /// The owner.
        place: At,
        /// Its key in files.
        property: &'static str,
        /// The value; [`Value::Unset`] is what a new one has.
        value: Value,
    },
    /// Inserts an orientation before orientation `at`, or after the last. It becomes current.
    InsertOrientation {
        /// The point.
        point: usize,
        /// Number the new orientation will have.
        at: usize,
        /// None copies the one before it, or else the first. Rolls are wrapped into (−180, 180].
        orientation: Option<Orientation>,
    },
    /// Removes an orientation, not the last; its predecessor, else the new first one, becomes
    /// current.
    RemoveOrientation {
        /// The point.
        point: usize,
        /// The orientation.
        at: usize,
    },
    /// Sets all values of an orientation. The velocities and slopes it owned are removed where its
    /// view or zoom changes, its part of another pace where its ten speeds change.
    SetOrientation {
        /// The point.
        point: usize,
        /// The orientation.
        at: usize,
        /// The values; the roll is wrapped into (−180, 180].
        orientation: Orientation,
    },
    /// Makes a target absolute or relative. The view stays, up to rounding.
    SetAbsolute {
        /// The point.
        point: usize,
        /// The orientation.
        at: usize,
        /// Absolute (true) or relative (false).
        absolute: bool,
    },
    /// Replaces the info: title, frame rate, unit, object and so on.
    SetInfo(Box<Info>),
    /// Where the path lies in the world; the scene, too, if it lies there.
    SetSpace {
        /// The new space.
        space: Space,
        /// Whether the path is mapped into the new space. The object never is.
        fit: bool,
    },
    /// Which axis is up; all poses stay.
    ChangeUp(Up),
    /// Edits the path of another node of the scene, or of none. Files do not record this, and by
    /// itself it is no step.
    EditNode(Option<usize>),
    /// Makes a part of the scene what it says ([`Part`]); a path becomes a scene with a camera on it first,
    /// and is a path again where nothing else is left. What depends on it is removed too: tracks
    /// and pins of what is removed, keys that lie where others come. A track of which no key is
    /// left goes, and its last key's value is the node's at rest. Paths are fitted to markers.
    Part(Box<Part>),
    /// Adds nodes behind the others; their parents and aims may be among them, which count on.
    AddNodes(Vec<Node>),
    /// Copies nodes with all that is in them, behind the others. Their names get a number, aims
    /// among them refer to the copies, pins stay with the originals, meshes are shared.
    CopyNodes(Vec<usize>),
    /// Puts a node into another one, or none.
    SetParent {
        /// The node.
        node: usize,
        /// The one that it is in then.
        parent: Option<usize>,
        /// What it keeps.
        keep: Keep,
    },
    /// Gives a marker another name; what is pinned to it stays so.
    RenameMarker {
        /// Its name.
        from: String,
        /// Its new one.
        to: String,
    },
    /// Replaces the scene. The shown camera's path is edited, if it has one.
    ReplaceScene(Box<Scene>),
    /// Replaces the path; its first point becomes current.
    ReplacePath(Box<CameraPath>),
    /// Moves, turns, scales or mirrors points; see [`vides_engine::tools::transform`].
    TransformPoints {
        /// The points.
        points: Vec<usize>,
        /// Must be free of shear.
        matrix: DMat4,
        /// Whether their targets move along.
        with_targets: bool,
    },
    /// Deforms points; see [`vides_engine::tools::transform`].
    DeformPoints {
        /// The points.
        points: Vec<usize>,
        /// The deformation.
        deformation: Deformation,
        /// The box it is relative to; none: the points' own.
        bounds: Option<Bounds>,
        /// Whether their targets are deformed too.
        with_targets: bool,
    },
    /// Inserts a path after a point; its first new point becomes current. See
    /// [`vides_engine::tools::block::insert`].
    InsertPath {
        /// The point.
        at: usize,
        /// The other path.
        block: Box<CameraPath>,
        /// How it is brought to its place.
        fit: Fit,
        /// Whether its targets move along.
        with_targets: bool,
    },
    /// Reverses the path; see [`vides_engine::tools::block::reverse`].
    Reverse,
    /// Repeats the path this many times; see [`vides_engine::tools::block::repeat`].
    Repeat(usize),
}

/// What has a property. Points and orientations count from 0.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum At {
    /// The whole path.
    Path,
    /// A point.
    Point(usize),
    /// An orientation of a point.
    View(usize, usize),
    /// A node of the scene, where nothing moves it.
    Node(usize),
}

impl Edit {
    /// Sets a property, see [`Edit::Set`].
    pub fn set(place: At, property: &'static str, value: impl Into<Value>) -> Self {
        Self::Set {
            place,
            property,
            value: value.into(),
        }
    }

    /// The edits that give a point the preset or the custom parameters that `shape` sets: custom
    /// tangents, which would hide them, are removed first.
    pub fn shaped(path: &CameraPath, at: usize, shape: Self) -> impl Iterator<Item = Self> + use<> {
        let point = path.points.get(at);
        let hides = point.is_some_and(|point| point.tangents.is_some());
        let without = hides.then(|| Self::set(At::Point(at), "tangents", None::<Tangents>));
        without.into_iter().chain([shape])
    }

    /// Whether it is refused where no path is edited.
    pub(super) fn needs_path(&self) -> bool {
        match self {
            Self::Set {
                place: At::Path,
                property,
                ..
            } => find(Info::PROPERTIES, property).is_none(),
            Self::Set {
                place: At::Node(_), ..
            }
            | Self::EditNode(_)
            | Self::ReplaceScene(_)
            | Self::SetInfo(_)
            | Self::SetSpace { .. }
            | Self::Part(_)
            | Self::AddNodes(_)
            | Self::CopyNodes(_)
            | Self::SetParent { .. }
            | Self::RenameMarker { .. } => false,
            _ => true,
        }
    }
}

/// The current point and its current orientation, counted from 0.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Selection {
    /// The point.
    pub point: usize,
    /// Its orientation.
    pub orientation: usize,
}

impl Selection {
    /// A selection of this point and orientation.
    #[must_use]
    pub const fn at(point: usize, orientation: usize) -> Self {
        Self { point, orientation }
    }
}
