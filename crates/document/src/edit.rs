//! The edits: what each one means.

use glam::{DMat4, DVec3};
use vides_engine::deform::{Bounds, Deformation};
use vides_engine::scene::Scene;
use vides_engine::tools::block::Fit;

use super::info::Info;
use crate::path::{
    BaseSpeeds, CameraPath, CurveKind, Orientation, OrientationMode, Space, Tangents, Tcb, ZoomMode,
};

/// One change of a document. Points, orientations, segments and presets are
/// counted from 0. [`super::Document::apply`] does it.
#[derive(Debug, Clone, PartialEq)]
pub enum Edit {
    /// A new support point before the one that is number `at` now; `at` = their
    /// number appends. Everything but its name is copied from the predecessor
    /// (at 0 from the successor); an absolute target that would lie on the new
    /// position becomes relative with the predecessor's direction. It becomes
    /// current.
    InsertPoint {
        /// Number that the new point will have.
        at: usize,
        /// Where it lies.
        position: DVec3,
    },
    /// A new point behind the last one of an open path: along the curve's end
    /// tangent, as far as the last segment is long, kept in the movement
    /// space. It becomes current.
    AppendAfterLast,
    /// The same before the first point.
    PrependBeforeFirst,
    /// New points on the curve of a segment, at equal arc lengths (`Pos.+` is
    /// one point). Everything but the name is copied from the point in which
    /// the segment begins. The first new one becomes current.
    DivideSegment {
        /// The segment.
        segment: usize,
        /// 1…[`vides_engine::limits::MAX_DIVISION`] new points.
        points: usize,
    },
    /// A new point on the curve where the camera is at a frame, at the nearest
    /// whole one: curve, pace, views and zoom stay what they are. What it would
    /// change around it its neighbours own from then on. It becomes current.
    InsertOnCurve {
        /// From 1 to the number of frames.
        frame: f64,
    },
    /// Tangents of its own for a point, or none.
    SetTangents {
        /// The point.
        at: usize,
        /// The tangents.
        tangents: Option<Tangents>,
    },
    /// How the curve leads through the points.
    SetCurveKind(CurveKind),
    /// Fixed frames for all moving sections from the first orientation of one
    /// point to the last one of another, so that there are exactly so many from
    /// the first pose to the last. All points of a closed path are its whole way.
    FitFrames {
        /// The first point.
        first: usize,
        /// The last point.
        last: usize,
        /// The frames.
        frames: usize,
    },
    /// Takes a point away; its predecessor becomes current, for the first the
    /// new first. Two always remain.
    RemovePoint {
        /// The point.
        at: usize,
    },
    /// Gives a point another number: it keeps its orientations with their speed
    /// curves, and those between the two places move up by one. It becomes current.
    MovePoint {
        /// The point.
        from: usize,
        /// The number that it will have.
        to: usize,
    },
    /// Moves a point: absolute targets stay, relative ones go along. Refused
    /// where an absolute target of its own lies.
    SetPosition {
        /// The point.
        at: usize,
        /// Where to.
        position: DVec3,
    },
    /// Names a point; one line, at most [`vides_engine::limits::MAX_NAME_BYTES`].
    SetName {
        /// The point.
        at: usize,
        /// Its name; none or empty takes it away.
        name: Option<String>,
    },
    /// Own tension, continuity and bias for a point ("Eigendef.").
    SetOwn {
        /// The point.
        at: usize,
        /// The values, each in [−1, 1].
        tcb: Tcb,
    },
    /// A preset for a point ("Standard n").
    UsePreset {
        /// The point.
        at: usize,
        /// 0…9.
        preset: usize,
    },
    /// Changes a preset, and with it every point that uses it.
    SetPreset {
        /// 0…9.
        preset: usize,
        /// The values, each in [−1, 1].
        tcb: Tcb,
    },
    /// A new orientation before the one that is number `at` now; `at` = their
    /// number appends. It becomes current.
    InsertOrientation {
        /// The point.
        point: usize,
        /// Number that the new orientation will have.
        at: usize,
        /// None copies the one before it (at 0 the first). Its roll may be any
        /// finite number and is brought into (−180, 180].
        orientation: Option<Orientation>,
    },
    /// Takes an orientation away; its predecessor becomes current, else the
    /// new first. One always remains.
    RemoveOrientation {
        /// The point.
        point: usize,
        /// The orientation.
        at: usize,
    },
    /// Changes every value of an orientation. Where its view or its zoom changes,
    /// velocities and slopes that it owned before go; where its ten speeds change,
    /// a part of another pace goes.
    SetOrientation {
        /// The point.
        point: usize,
        /// The orientation.
        at: usize,
        /// The values; the roll may be any finite number and is brought into
        /// (−180, 180].
        orientation: Orientation,
    },
    /// Makes a target absolute or relative. The view stays, to rounding.
    SetAbsolute {
        /// The point.
        point: usize,
        /// The orientation.
        at: usize,
        /// Absolute (true) or relative (false).
        absolute: bool,
    },
    /// The base speeds, each finite and > 0.
    SetSpeeds(BaseSpeeds),
    /// Joins the last point to the first by one more segment, or opens it.
    SetClosed(bool),
    /// How the camera turns and how the zoom runs.
    SetModes(OrientationMode, ZoomMode),
    /// Title, comment, frames per second, unit and object.
    SetInfo(Box<Info>),
    /// Where the path lies in the world.
    SetSpace {
        /// The new space.
        space: Space,
        /// Whether the path goes along, so that it lies in the new space as it did in
        /// the old one; else its numbers stay. The object's do always.
        fit: bool,
    },
    /// The path of another node of the scene is edited from now on; none: of no node.
    /// That changes nothing that a file would have.
    EditNode(Option<usize>),
    /// Another scene in place of what there is. The path of the camera that is shown is
    /// edited, if it has one.
    ReplaceScene(Box<Scene>),
    /// Another path in place of this one; its first point becomes current.
    ReplacePath(Box<CameraPath>),
    /// Moves, turns, scales or mirrors points; see [`vides_engine::tools::transform`].
    TransformPoints {
        /// The points.
        points: Vec<usize>,
        /// Without shear.
        matrix: DMat4,
        /// Whether what their cameras see goes along.
        with_targets: bool,
    },
    /// Deforms points; see [`vides_engine::tools::transform`].
    DeformPoints {
        /// The points.
        points: Vec<usize>,
        /// The deformation.
        deformation: Deformation,
        /// The box that it is relative to; none: that of the points.
        bounds: Option<Bounds>,
        /// Whether their targets are deformed too.
        with_targets: bool,
    },
    /// Puts another path in behind a point; see [`vides_engine::tools::block::insert`].
    /// Its first new point becomes current.
    InsertPath {
        /// The point.
        at: usize,
        /// The other path.
        block: Box<CameraPath>,
        /// How it is brought to its place.
        fit: Fit,
        /// Whether its targets go along.
        with_targets: bool,
    },
    /// Turns the way round; see [`vides_engine::tools::block::reverse`].
    Reverse,
    /// The way so many times; see [`vides_engine::tools::block::repeat`].
    Repeat(usize),
}
