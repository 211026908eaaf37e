//! The structs that C sees. Their layout is a promise; the C tests compare those of 1994 with the
//! thesis's declarations. cbindgen emits a type where a function first needs it, so the functions
//! determine the order in the header.

// Some names are used by the header only.
#![allow(dead_code)]

use std::ffi::{c_char, c_int, c_ulong, c_ushort, c_void};
use std::mem::offset_of;

use super::scene_types::V_MESH;
use crate::path::Pose;

/// A point or a vector in the cube from -1 to 1 in x, y and z, y up.
#[repr(C)]
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct v_punkt {
    pub x: f32,
    pub y: f32,
    pub z: f32,
}

pub type V_PUNKT = v_punkt;

/// The same type by the name that other structs use.
pub type V_POS = V_PUNKT;

/// One point of the wireframe object that v_haupt() shows.
#[repr(C)]
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct v_objekt_list {
    pub pos: V_POS,
    /// not 0: a line leads here from the point before
    pub draw: c_ushort,
    /// 1, 2, 3 ... in the order of the array
    pub number: c_int,
}

pub type V_OBJEKT_LISTE = v_objekt_list;

/// The same type by its other name.
pub type V_OBJEKT_LIST = V_OBJEKT_LISTE;

/// A camera pose in a list, and the whole list by its first element. The list is
/// circular: first->prev is the last element, whose number is the count, and whose next
/// is the first. A list of one element points to itself.
///
/// The first element is yours and must outlive the list. Before the first hand-over set
/// its number to -1: no data yet; prev and next have no meaning. VIDES allocates the
/// others with malloc(), so that you or v_free_liste() may free() them. The next list
/// reuses them.
#[repr(C)]
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct interpolparameter {
    /// position of the camera (view reference point)
    pub VRP: V_POS,
    /// view direction; length 1
    pub VPN: V_POS,
    /// up; length 1, perpendicular to VPN
    pub VUP: V_POS,
    /// 1 to 100, rounded, 100 for any larger. Vertical field of view: 2 atan (12 /
    /// zoom)
    pub zoom: c_int,
    pub prev: *mut interpolparameter,
    pub next: *mut interpolparameter,
    /// 1, 2, 3 ... along the list; in the first element < 0: no data
    pub number: c_int,
}

pub type V_KAMERAPAR = interpolparameter;

pub struct v_path {
    _private: (),
}

/// ==== Types: handles, values, options ====
///
/// A handle for a camera path, not an address: using one that was freed or never made,
/// or freeing it twice, is harmless and fails with V_ERR_HANDLE.
pub type V_PATH = v_path;

/// A camera pose. This layout will never change.
#[repr(C)]
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct v_pose {
    /// position of the camera
    pub vrp: [f64; 3],
    /// view direction; length 1
    pub vpn: [f64; 3],
    /// up; length 1, perpendicular to vpn
    pub vup: [f64; 3],
    /// 1 to 2000: focal length in mm of a 36 x 24 mm camera, with a vertical field of
    /// view of 2 atan (12 / zoom). For other lenses see v_zoom_from_fov()
    pub zoom: f64,
}

pub type V_POSE = v_pose;

/// How the camera looks at a point of the path, and how it moves on from there. The
/// window calls an orientation a view.
#[repr(C)]
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct v_orientation {
    pub size: usize,
    /// not 0: target is a point in the world; 0: an offset from the path's point, of
    /// which only the direction matters
    pub absolute: c_int,
    /// what the camera looks at; must not be the point itself
    pub target: [f64; 3],
    /// degrees, turns up about the view; any finite number, stored in (-180, 180]
    pub roll: f64,
    /// 1 to 2000
    pub zoom: f64,
    /// of the turning, each from -1 to 1
    pub tension: f64,
    pub continuity: f64,
    pub bias: f64,
    /// speed curve of the section that begins here, each from 1 to 100; at 50 the base
    /// speeds apply
    pub speed: [f64; 10],
    /// frames that the camera rests here, 0 to 1000000
    pub hold: c_int,
}

pub type V_ORIENTATION = v_orientation;

/// A view as defined by PHIGS. The eye is on the side that normal points to, so it
/// looks against normal. Everything except vrp, normal and up is in the view's
/// coordinates u (right), v (up), n (along normal), with the origin at vrp.
#[repr(C)]
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct v_view {
    pub size: usize,
    /// view reference point, world
    pub vrp: [f64; 3],
    /// view plane normal, world, any length but 0
    pub normal: [f64; 3],
    /// view up vector, world, not parallel to normal
    pub up: [f64; 3],
    /// projection reference point: the eye (u, v, n)
    pub prp: [f64; 3],
    /// umin, umax, vmin, vmax on the view plane
    pub window: [f64; 4],
    /// n of the front plane, less than that of prp
    pub front: f64,
    /// n of the back plane, less than front
    pub back: f64,
    /// n of the view plane
    pub distance: f64,
    /// not 0: perspective; 0: parallel
    pub perspective: c_int,
}

pub type V_VIEW = v_view;

pub struct v_editor {
    _private: (),
}

/// A handle for an editor window (see V_PATH). On any thread but the one that opened
/// it, its functions fail with V_ERR_HANDLE. Free it even if the user has closed the
/// window.
pub type V_EDITOR = v_editor;

/// ==== Constants ====
///
/// Why on_view and on_frame are called.
///
/// V_VIEW_SELECTED  another point, orientation or camera was selected
/// V_VIEW_EDITED    something is being dragged or was changed
/// V_VIEW_SCRUBBED  another frame was chosen
/// V_VIEW_PLAYED    the window is playing
/// V_VIEW_RESTED    nothing moves any more; ends each series: draw in full quality
pub const V_VIEW_SELECTED: c_int = 0;
pub const V_VIEW_EDITED: c_int = 1;
pub const V_VIEW_SCRUBBED: c_int = 2;
pub const V_VIEW_PLAYED: c_int = 3;
pub const V_VIEW_RESTED: c_int = 4;

/// Why on_gone is called.
///
/// V_GONE_BY_USER    the user closed the window
/// V_GONE_WITH_ALL   v_editors_close(0) closed it
/// V_GONE_DESTROYED  it was destroyed from outside or removed from its parent
/// V_GONE_DISPLAY    its X server went away or refused to go on
/// V_GONE_FAULT      a fault inside the library closed it
pub const V_GONE_BY_USER: c_int = 0;
pub const V_GONE_WITH_ALL: c_int = 1;
pub const V_GONE_DESTROYED: c_int = 2;
pub const V_GONE_DISPLAY: c_int = 3;
pub const V_GONE_FAULT: c_int = 4;

/// Which axis is up.
pub const V_UP_Y: c_int = 1;
pub const V_UP_Z: c_int = 2;

/// Options of an editor window. What they point to, except user, need only remain valid
/// during v_editor_open(). A callback that is NULL is not called.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct v_editor_options {
    pub size: usize,
    /// text after "VIDES" in the title, one line; NULL: the name of the file
    pub title: *const c_char,
    /// a .vid file to start with and to save to; if it does not exist yet, a new path
    /// of that name; NULL: none
    pub file: *const c_char,
    /// a path to start with; NULL: a new one, or that of file. Not together with file
    pub path: *const V_PATH,
    /// an object to show, at which a new path looks; NULL: that of the path
    pub object: *const V_MESH,
    /// base speeds, see the property "base_speeds". All 0: those of the path; otherwise
    /// they are fixed, and those of a loaded file are ignored
    pub move_frames: f64,
    pub turn_frames: f64,
    pub zoom_frames: f64,
    pub roll_frames: f64,
    /// name of the X display; NULL: the one that the program's Xt opened last; without
    /// Xt, the environment's DISPLAY
    pub display: *const c_char,
    /// "de" or "en"; NULL: by LC_ALL, LC_MESSAGES, LANG. A language that the user chose
    /// in the setup takes precedence
    pub language: *const c_char,
    /// called when the user hands over the poses, which are valid until it returns; in
    /// a scene those of the camera shown, one for each frame of v_scene_frame_range().
    /// NULL: no hand-over is possible
    pub on_poses: Option<
        unsafe extern "C" fn(
            editor: *mut V_EDITOR,
            poses: *const V_POSE,
            count: usize,
            user: *mut c_void,
        ),
    >,
    /// called before the user closes the window; 0 keeps it open. NULL: it closes
    pub on_close: Option<unsafe extern "C" fn(editor: *mut V_EDITOR, user: *mut c_void) -> c_int>,
    /// your pointer, passed to the callbacks
    pub user: *mut c_void,
    /// the space in your world, also for a scene in file: its centre, half of its edge,
    /// V_UP_Y or V_UP_Z. With space_half_size 0 it is that of file or path, and V_UP_Z
    /// makes z the up axis of a new path
    pub space_centre: [f64; 3],
    pub space_half_size: f64,
    pub space_up: c_int,
    /// called with the camera at the playhead whenever it has changed, at most 60 times
    /// a second, even if the window is not visible; reason is V_VIEW_.... The pose is valid
    /// until it returns. After a call of more than 30 ms the next one waits as long
    pub on_view: Option<
        unsafe extern "C" fn(
            editor: *mut V_EDITOR,
            pose: *const V_POSE,
            frame: f64,
            reason: c_int,
            user: *mut c_void,
        ),
    >,
    /// called when the path has changed: after each step, undo and redo, not during a
    /// drag or a tool's preview; steps within a sixtieth of a second are combined
    pub on_change: Option<unsafe extern "C" fn(editor: *mut V_EDITOR, user: *mut c_void)>,
    /// called when the user adds your program's view to the path (Ctrl-Enter): fill in
    /// your camera and return 1, or return 0 if you have none. vpn and vup have any
    /// length but 0 and are not parallel. NULL: the view of v_editor_set_view()
    pub on_capture: Option<
        unsafe extern "C" fn(editor: *mut V_EDITOR, pose: *mut V_POSE, user: *mut c_void) -> c_int,
    >,
    /// called when the camera pane opens, changes its size in pixels, or closes (window
    /// 0, sizes 0). Draw in it what the camera sees, again at each Expose: in the pane,
    /// which has the screen's visual, or in a child window of any visual that you create
    /// there and that is kept at its size. A pane is never destroyed while the process
    /// lives: it and its child, moved to the root window, are unmapped before this is
    /// called; when the editor closes, after its window is gone and perhaps its handle
    /// freed. Not called when the thread ends, nor without XFIXES or SHAPE. NULL: the
    /// editor draws the picture itself
    pub on_pane: Option<
        unsafe extern "C" fn(
            editor: *mut V_EDITOR,
            window: c_ulong,
            width: c_int,
            height: c_int,
            user: *mut c_void,
        ),
    >,
    /// what the window calls your program's view, one line; NULL: "program"
    pub host_name: *const c_char,
    /// an X window of the display, of any depth, which the editor fills as its child;
    /// 0: a top-level window. If it is destroyed, or the editor's window is moved to
    /// the root, the editor closes without on_close
    pub parent: c_ulong,
    /// your window, above which window managers keep the editor; 0: none
    pub transient_for: c_ulong,
    /// name of the program: the first half of WM_CLASS, by which desktops group windows
    /// and unsaved work is found again; NULL: that of the running program
    pub application: *const c_char,
    /// not 0: after a hand-over nothing is unsaved, as always without a file and in a
    /// window of v_haupt()
    pub hand_over_saves: c_int,
    /// for programs that draw the scene themselves: called, like on_view, with the scene's
    /// frame at the playhead when that frame or the scene has changed
    pub on_frame: Option<
        unsafe extern "C" fn(editor: *mut V_EDITOR, frame: f64, reason: c_int, user: *mut c_void),
    >,
    /// what your program's picture shows when the window opens: a new path begins with it
    /// and leads to the right, around the middle of the picture. NULL: a new path looks at
    /// the object, and on_view is called at once
    pub view: *const V_POSE,
    /// called once, after the window is gone; reason is V_GONE_.... You may free the
    /// handle here. Not called when v_editor_close() closes the window or its thread ends
    pub on_gone:
        Option<unsafe extern "C" fn(editor: *mut V_EDITOR, reason: c_int, user: *mut c_void)>,
}

pub type V_EDITOR_OPTIONS = v_editor_options;

// A pose is filled in place in the host's memory.
const _: () = {
    assert!(size_of::<v_pose>() == 80 && size_of::<Pose>() == 80);
    assert!(align_of::<v_pose>() == align_of::<Pose>());
    assert!(offset_of!(v_pose, vrp) == offset_of!(Pose, vrp));
    assert!(offset_of!(v_pose, vpn) == offset_of!(Pose, vpn));
    assert!(offset_of!(v_pose, vup) == offset_of!(Pose, vup));
    assert!(offset_of!(v_pose, zoom) == offset_of!(Pose, zoom));
};

const _: () = assert!(crate::limits::SPEEDS == 10);
