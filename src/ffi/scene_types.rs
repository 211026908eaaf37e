//! The structs of scenes that C sees; see `types.rs`.

#![allow(dead_code)]

use std::ffi::{c_int, c_uchar, c_uint};
use std::mem::offset_of;

use super::pointers::Growing;
use super::types::V_POSE;
use crate::scene::NodeState;

pub struct v_scene {
    _private: (),
}

/// A handle for a scene (see V_PATH): a tree of nodes that move on one timeline.
///
/// Inside a function given to v_register_interpolation(), functions that take a V_SCENE
/// fail with V_ERR_BUSY, except v_scene_free(). A text that they return is valid until
/// the same thread's next call that returns one.
pub type V_SCENE = v_scene;

/// The kinds of node.
pub const V_NODE_GROUP: c_int = 0;
pub const V_NODE_OBJECT: c_int = 1;
pub const V_NODE_LIGHT: c_int = 2;
pub const V_NODE_CAMERA: c_int = 3;

/// The kinds of light.
pub const V_LIGHT_DIRECTIONAL: c_int = 0;
pub const V_LIGHT_POINT: c_int = 1;
pub const V_LIGHT_SPOT: c_int = 2;

/// How a motion continues after its end.
///
/// V_AFTER_HOLD      holds the last value
/// V_AFTER_REPEAT    starts over; the period is the last frame minus the first, and
///                   where they meet the last value is used
/// V_AFTER_PINGPONG  goes back and forth
/// V_AFTER_OFFSET    starts over from where it ended
///
/// Before its start a path continues in the same way. A track holds its first value
/// there, unless you add one of V_BEFORE_...: V_AFTER_REPEAT | V_BEFORE_PINGPONG.
pub const V_AFTER_HOLD: c_int = 0;
pub const V_AFTER_REPEAT: c_int = 1;
pub const V_AFTER_PINGPONG: c_int = 2;
pub const V_AFTER_OFFSET: c_int = 3;
pub const V_BEFORE_REPEAT: c_int = 16;
pub const V_BEFORE_PINGPONG: c_int = 32;
pub const V_BEFORE_OFFSET: c_int = 48;

/// What a node keeps when its parent changes.
pub const V_KEEP_PLACE: c_int = 0;
pub const V_KEEP_NUMBERS: c_int = 1;

/// A node at rest. Its local matrix is T(position) T(pivot) R S T(-pivot), its world
/// matrix its parent's times the local one. Lights and cameras look along their own +z
/// axis with +y up and have pivot 0. Values that a kind of node does not have are
/// ignored.
#[repr(C)]
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct v_node {
    pub size: usize,
    /// V_NODE_...
    pub kind: c_int,
    /// parent node; -1: none
    pub parent: c_int,
    /// 0 hides the node and its descendants
    pub visible: c_int,
    /// lights and cameras: the node at whose pivot it looks; -1: none
    pub aim: c_int,
    /// what the node turns and scales about
    pub pivot: [f64; 3],
    pub position: [f64; 3],
    /// w x y z, of any length but 0
    pub rotation: [f64; 4],
    pub scale: [f64; 3],
    /// cameras: 1 to 2000, see V_POSE
    pub zoom: f64,
    /// cameras: degrees, turns up about the view
    pub roll: f64,
    /// lights: V_LIGHT_...
    pub light: c_int,
    /// lights and objects: linear red, green, blue, each 0 or more
    pub colour: [f64; 3],
    /// lights: 0 or more
    pub intensity: f64,
    /// lights: half angles in degrees, inner and outer, 0 to 90
    pub cone: [f64; 2],
    /// cameras: > 0
    pub near_plane: f64,
    /// cameras: > near_plane
    pub far_plane: f64,
}

pub type V_NODE = v_node;

/// A node at a frame. This layout will never change.
#[repr(C)]
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct v_node_state {
    /// from the node's coordinates to the world's, column by column
    pub matrix: [f64; 16],
    /// cameras and lights; otherwise all 0
    pub pose: V_POSE,
    /// lights and objects
    pub colour: [f64; 3],
    /// lights
    pub intensity: f64,
    /// lights: half angles in degrees, inner and outer
    pub cone: [f64; 2],
    /// 1 if the node and all its ancestors are visible, else 0
    pub visible: c_int,
}

pub type V_NODE_STATE = v_node_state;

/// A mesh: points, and the lines and triangles that connect them; without either, only
/// the points are shown.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct v_mesh {
    pub size: usize,
    /// three numbers per point
    pub xyz: *const f64,
    pub points: usize,
    /// three bytes per point; NULL: no colours
    pub rgb: *const c_uchar,
    /// two indices per line; NULL: none
    pub lines: *const c_uint,
    /// number of indices, even
    pub line_ends: usize,
    /// three indices per triangle; NULL: none
    pub triangles: *const c_uint,
    /// number of indices, a multiple of 3
    pub corners: usize,
}

pub type V_MESH = v_mesh;

// SAFETY: `repr(C)` with `size` first; numbers only.
unsafe impl Growing for V_NODE {
    const NAME: &'static str = "V_NODE";
    const FIRST: usize = size_of::<V_NODE>();
}

// SAFETY: `repr(C)` with `size` first; pointers and numbers only.
unsafe impl Growing for V_MESH {
    const NAME: &'static str = "V_MESH";
    const FIRST: usize = size_of::<V_MESH>();
}

// States are filled in place in the host's memory.
const _: () = {
    assert!(size_of::<v_node_state>() == size_of::<NodeState>());
    assert!(align_of::<v_node_state>() == align_of::<NodeState>());
    assert!(offset_of!(v_node_state, matrix) == offset_of!(NodeState, matrix));
    assert!(offset_of!(v_node_state, pose) == offset_of!(NodeState, pose));
    assert!(offset_of!(v_node_state, colour) == offset_of!(NodeState, colour));
    assert!(offset_of!(v_node_state, intensity) == offset_of!(NodeState, intensity));
    assert!(offset_of!(v_node_state, cone) == offset_of!(NodeState, cone));
    assert!(offset_of!(v_node_state, visible) == offset_of!(NodeState, visible));
};
