//! What the movement window remembers, and the parts of a drag there.

pub(crate) mod solid;

use std::sync::Arc;

use egui::{PointerButton, Pos2};
use glam::{DAffine3, DQuat, DVec2, DVec3};
use vides_document::{Edit, Object};
use vides_engine::path::CameraPath;
use vides_engine::scene::Channel;
use vides_raster::Lines;

use crate::setup::View;
use crate::space::cameras::KeyCameras;
use crate::space::projection::Axis;
use crate::space::ribbon::Ribbon;
use crate::space::scene::{LookKey, PathLines};
use crate::space::seconds::Seconds;
use crate::space::typed::Typed;
use crate::state::space::solid::Solid;

/// What one tangent does while the user drags the opposite one.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) enum Joint {
    /// It turns along and keeps its length.
    #[default]
    Smooth,
    /// It becomes the same.
    Mirrored,
    /// It stays.
    Corner,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Side {
    Before,
    After,
}

/// Something that can be dragged.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Handle {
    /// The tip of the current VUP arrow.
    Vup,
    /// The tip of the current VPN arrow: the target.
    Vpn,
    Point(usize),
    /// A control point of the box that a tool deforms.
    Control(usize),
    /// The end of a tangent that the current point owns.
    Tangent(Side),
    /// The pivot of a selected node.
    Node(usize),
    /// A key on the way of a selected node, from 0.
    Key(usize, usize),
}

/// The coordinates in which something moves.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct DragConstraint {
    /// The axis across the plane in which it moves.
    pub(crate) fixed: Axis,
    /// The only axis of that plane along which it moves, if any.
    pub(crate) along: Option<Axis>,
    /// The axis across the plane that was meant, if that is seen edge-on.
    pub(crate) edge_on: Option<Axis>,
}

/// What a part of a drag changes of nodes.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum NodeChange {
    /// Numbers of channels, see [`crate::Editor::set_channel`].
    Values(Vec<(usize, Channel, Vec<f64>)>),
    /// A node's pivot goes there, in its own coordinates; the node stays.
    Pivot(usize, DVec3),
    /// The value of a key of a node's position.
    Key(usize, usize, DVec3),
}

/// What is held, as it was when it was taken.
#[derive(Clone, Debug)]
pub(crate) struct Held {
    pub(crate) grip: Grip,
    /// The one whose axes hold first.
    pub(crate) all: Vec<Start>,
    /// In the first one's parent.
    pub(crate) middle: DVec3,
}

/// What is held.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Grip {
    /// All selected nodes.
    Nodes,
    /// The pivot of the current one.
    Pivot,
    /// A key of a node's position, from 0.
    Key(usize, usize),
}

/// A node as it was when it was taken.
#[derive(Clone, Debug)]
pub(crate) struct Start {
    pub(crate) node: usize,
    pub(crate) parent: Option<usize>,
    /// From its parent's coordinates into those of the space.
    pub(crate) world: DAffine3,
    pub(crate) pivot: DVec3,
    pub(crate) position: DVec3,
    pub(crate) rotation: DQuat,
    /// Yaw, pitch and roll in degrees, if its keys have them.
    pub(crate) angles: Option<[f64; 3]>,
    pub(crate) scale: DVec3,
}

/// A part of a drag, by mouse or keys; a whole drag is one step of the history.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Gesture {
    /// A button goes down, perhaps on a handle.
    Press(Option<Handle>),
    Begin,
    Move(Handle, Edit),
    /// Changes all that is selected at once; the words describe it.
    Transform(Edit, String),
    /// Changes nodes; the words describe it.
    Nodes(NodeChange, String),
    /// There is no such motion.
    Refused(&'static str),
    End,
    Cancel,
}

#[derive(Clone, Copy, Debug)]
pub(crate) struct PointerPress {
    pub(crate) button: PointerButton,
    pub(crate) pressed: Pos2,
    pub(crate) now: Pos2,
    pub(crate) what: Option<Handle>,
    /// Where that was at first.
    pub(crate) from: DVec3,
    pub(crate) freedom: DragConstraint,
    /// From the pointer to where fine dragging takes it to be.
    pub(crate) lag: DVec2,
    pub(crate) snaps: bool,
    /// The other tangent stays, whatever `joint` says.
    pub(crate) alone: bool,
    pub(crate) joint: Joint,
    pub(crate) view: View,
    /// Shifts the view instead of turning it.
    pub(crate) shifts: bool,
    /// Draws a box that selects points.
    pub(crate) boxes: bool,
    /// Adds to what is selected.
    pub(crate) adds: bool,
    pub(crate) moved: bool,
}

#[derive(Debug)]
pub(crate) struct Drawing(pub(crate) Vec<DVec3>);

#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct PointMenu {
    pub(crate) at: Pos2,
    /// It is about the current point, else about the view.
    pub(crate) of_point: bool,
    /// The corner of the object that lies there.
    pub(crate) corner: Option<DVec3>,
}

/// The lines made last, and what they were made of.
#[derive(Debug, Default)]
pub(crate) struct Nodes {
    pub(crate) made: Option<(LookKey, (u64, u64), f64)>,
    pub(crate) lines: Arc<Lines>,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Kind {
    Move,
    Turn,
    Scale,
}

/// A modal transform at work: a step of the document is open.
#[derive(Clone, Debug)]
pub(crate) struct Transform {
    pub(crate) kind: Kind,
    /// The button that holds a handle.
    pub(crate) held: Option<PointerButton>,
    /// How far the pointer has gone, and where it is taken to have begun.
    pub(crate) way: DVec2,
    pub(crate) from: DVec2,
    /// Where the pointer was last.
    pub(crate) last: Option<DVec2>,
    pub(crate) snaps: bool,
    pub(crate) axis: Option<Axis>,
    /// The axis is the node's own: its letter came twice.
    pub(crate) own: bool,
    pub(crate) typed: Typed,
    /// Nodes in place of points.
    pub(crate) nodes: Option<Box<Held>>,
    pub(crate) points: Vec<usize>,
    /// The current point, and where it was.
    pub(crate) current: (usize, DVec3),
    /// The middle of all at first.
    pub(crate) middle: DVec3,
}

#[derive(Debug, Default)]
pub(crate) struct PointerController {
    pub(crate) hold: Option<Box<PointerPress>>,
    /// What was typed since the button went down.
    pub(crate) typed: Typed,
    /// Keys that move something are down; a step of the document is open.
    pub(crate) nudging: bool,
    /// A transform is at work; a step of the document is open.
    pub(crate) transform: Option<Transform>,
    /// Where the first screen's path begins, while the second click is awaited.
    pub(crate) begun: Option<DVec3>,
    /// The left button draws a line.
    pub(crate) drawing: Option<Drawing>,
    pub(crate) hover: Option<Handle>,
    /// The handle around several points that lies under the pointer.
    pub(crate) meant: Option<Kind>,
    /// How the arrow or the square under the pointer would drag the current point.
    pub(crate) arrow: Option<DragConstraint>,
    /// The pointer is in the movement window.
    pub(crate) over: bool,
    /// Where the last right click asks for a menu, and of what.
    pub(crate) menu: Option<(Pos2, Option<Handle>)>,
    /// Where the last click was, and whether a node lay there.
    pub(crate) clicked: Option<(Pos2, bool)>,
}

/// The object that is loaded, and the new path that would look at it.
#[derive(Clone, Debug)]
pub(crate) struct Around(pub(crate) Object, pub(crate) CameraPath);

/// The movement window's own state.
#[derive(Debug, Default)]
pub(crate) struct MovementWindow {
    pub(crate) pointer: PointerController,
    pub(crate) lines: PathLines,
    pub(crate) key_cameras: KeyCameras,
    pub(crate) seconds: Seconds,
    /// A file has been opened: its flight is brought into view.
    pub(crate) opened: bool,
    pub(crate) ribbon: Ribbon,
    pub(crate) nodes: Nodes,
    /// The objects' faces, in the space and in the camera's picture.
    pub(crate) solid: Solid,
    pub(crate) seen_solid: Solid,
    pub(crate) menu: PointMenu,
    /// The view before one of its numbers was dragged.
    pub(crate) view_before: Option<View>,
    /// The corner of the object that is lit under the pointer, or the place on a face there.
    pub(crate) pointed: Option<DVec3>,
}
