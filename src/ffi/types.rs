//! The structs that C sees. Their layout is a promise; the C tests compare those of 1994 with the
//! thesis's declarations. cbindgen emits a type where a function first needs it, so the functions
//! determine the order in the header.

// Some names are used by the header only.
#![allow(dead_code)]

use std::ffi::{c_char, c_int, c_ulong, c_ushort, c_void};
use std::mem::offset_of;

use super::scene_types::V_MESH;
use crate::path::Pose;

/// ==== The types of the interface of 1994 ====
///
/// A point or a vector in the movement space, the cube from -1 to 1 in x, y
/// and z: right-handed, y up.
#[repr(C)]
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct v_punkt {
    pub x: f32,
    pub y: f32,
    pub z: f32,
}

pub type V_PUNKT = v_punkt;

/// The same type under the name that the other structs use.
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

/// The same type under its other name.
pub type V_OBJEKT_LIST = V_OBJEKT_LISTE;

/// One camera pose in a list of them, and the whole list by its first element.
///
/// The first element is the host's; it must outlive the list. Before the first
/// hand-over the host sets its number to -1: no data yet, and prev and next
/// mean nothing. VIDES makes the other elements with malloc(), one each, so
/// that the host may free() them; v_free_liste() does that, too. The next list uses
/// them again as far as it goes.
///
/// The list is closed both ways: first->prev is the last element, whose number
/// is the count, and the last one's next is the first. A list of one element
/// points to itself.
#[repr(C)]
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct interpolparameter {
    /// position of the camera (view reference point)
    pub VRP: V_POS,
    /// view direction, along which the camera looks; length 1
    pub VPN: V_POS,
    /// up; length 1, perpendicular to VPN
    pub VUP: V_POS,
    /// 1 to 100, rounded, and 100 for any zoom beyond; the vertical field of view
    /// is 2 atan (12 / zoom)
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

/// ==== The types of the new interface ====
///
/// A camera path, by a handle. It is no address: a handle that was freed, freed
/// twice, or never made gives V_ERR_HANDLE and does no harm. Whoever made it
/// frees it with v_path_free().
pub type V_PATH = v_path;

/// One camera pose. This layout will never change.
#[repr(C)]
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct v_pose {
    /// position of the camera
    pub vrp: [f64; 3],
    /// view direction, along which the camera looks; length 1
    pub vpn: [f64; 3],
    /// up; length 1, perpendicular to vpn
    pub vup: [f64; 3],
    /// 1 to 2000: focal length in mm of a 36 x 24 mm camera, so that the
    /// vertical field of view is 2 atan (12 / zoom); v_zoom_from_fov() converts
    /// from any other
    pub zoom: f64,
}

pub type V_POSE = v_pose;

/// How the camera looks from a support point, and how it goes on from there.
///
/// A struct that begins with size may grow at its end in later versions. Set
/// size to sizeof the struct before any call, also where the library fills in
/// the rest; v_orientation_init() does it. A host compiled with
/// an earlier 1.x may have a shorter one; any other value is V_ERR_SIZE.
#[repr(C)]
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct v_orientation {
    /// sizeof (V_ORIENTATION)
    pub size: usize,
    /// not 0: target is a point of the world; 0: an offset from the support
    /// point, of which only the direction counts
    pub absolute: c_int,
    /// what the camera looks at; not the support point itself
    pub target: [f64; 3],
    /// degrees, turns the up vector about the view direction; any finite
    /// number, kept in (-180, 180]
    pub roll: f64,
    /// 1 to 2000
    pub zoom: f64,
    /// of the turning, each -1 to 1
    pub tension: f64,
    pub continuity: f64,
    pub bias: f64,
    /// speed curve of the section that begins here, each 1 to 100; at 50 the
    /// base speeds hold
    pub speed: [f64; 10],
    /// frames for which the camera rests here, 0 to 1000000
    pub hold: c_int,
}

pub type V_ORIENTATION = v_orientation;

/// A view as PHIGS describes it. The eye is on the side to which normal points,
/// so the view goes against it. All but vrp, normal and up is in the view's own
/// coordinates u (right), v (up), n (along normal), with the origin in vrp.
///
/// Set size to sizeof (V_VIEW) before any call, see V_ORIENTATION.
#[repr(C)]
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct v_view {
    /// sizeof (V_VIEW)
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
    /// n of the front plane, less than prp's
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

/// ==== Editor windows ====
///
/// An editor window, by a handle (see V_PATH). It belongs to the thread that
/// opened it: from any other its functions answer V_ERR_HANDLE. Whoever opened
/// it frees it with v_editor_close(), also after the user has closed it.
pub type V_EDITOR = v_editor;

/// ==== Reasons of callbacks ====
///
/// Why on_view and on_frame are called: another point or orientation became current, or
/// another camera is shown; something is being dragged or was changed; another frame was
/// chosen; it plays; nothing moves any more (the last of a row of the others: time for the
/// good picture).
pub const V_VIEW_SELECTED: c_int = 0;
pub const V_VIEW_EDITED: c_int = 1;
pub const V_VIEW_SCRUBBED: c_int = 2;
pub const V_VIEW_PLAYED: c_int = 3;
pub const V_VIEW_RESTED: c_int = 4;

/// ==== What stands upright ====
///
/// Which axis is up.
pub const V_UP_Y: c_int = 1;
pub const V_UP_Z: c_int = 2;

/// A movement space: a cube in the host's world, see v_path_set_space().
/// v_space_init() fills in the space of a new path.
///
/// Set size to sizeof (V_SPACE) before any call, see V_ORIENTATION.
#[repr(C)]
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct v_space {
    /// sizeof (V_SPACE)
    pub size: usize,
    /// its centre, in the host's world
    pub centre: [f64; 3],
    /// half the length of its edge, 1e-30 to 1e30
    pub half_size: f64,
    /// which axis is up, V_UP_Y or V_UP_Z
    pub up: c_int,
}

pub type V_SPACE = v_space;

/// Limits of a pace, 0: none. Lengths count in half sizes of the space, as in
/// v_path_check(). v_limits_init() fills in those that a check has unless told.
///
/// Set size to sizeof (V_LIMITS) before any call, see V_ORIENTATION.
#[repr(C)]
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct v_limits {
    /// sizeof (V_LIMITS)
    pub size: usize,
    /// half sizes a second
    pub speed: f64,
    /// half sizes a second squared, in any direction
    pub acceleration: f64,
    /// half sizes a second cubed, the third difference at whole frames
    pub jerk: f64,
    /// degrees a second
    pub turning: f64,
    /// degrees a second squared
    pub turning_acceleration: f64,
    /// mm a second
    pub zoom: f64,
    /// least seconds in which what is in the middle of the picture would cross it
    pub crossing: f64,
}

pub type V_LIMITS = v_limits;

/// What a tour shows an object with, see v_path_tour(). v_tour_init() fills in what is
/// usual.
///
/// Set size to sizeof (V_TOUR) before any call, see V_ORIENTATION.
#[repr(C)]
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct v_tour {
    /// sizeof (V_TOUR)
    pub size: usize,
    /// how long the flight takes, > 0
    pub seconds: f64,
    /// the share, by area, that is shown of the surface that can be seen: > 0, at most 1
    pub coverage: f64,
    /// how far the camera is from what it shows; 0: found
    pub distance: f64,
    /// not 0: in the object's free space, not around it
    pub inside: c_int,
    /// not 0: it begins at start; else it is a closed round
    pub has_start: c_int,
    /// where it begins
    pub start: [f64; 3],
    /// which axis is up, V_UP_Y or V_UP_Z
    pub up: c_int,
}

pub type V_TOUR = v_tour;

/// How an editor window is opened. v_editor_options_init() fills in defaults;
/// what is pointed to need not live longer than the call of v_editor_open(),
/// but for user.
///
/// Set size to sizeof (V_EDITOR_OPTIONS) before any call, see V_ORIENTATION.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct v_editor_options {
    /// sizeof (V_EDITOR_OPTIONS)
    pub size: usize,
    /// what follows "VIDES" in the title, UTF-8, one line; NULL: the file's
    /// name
    pub title: *const c_char,
    /// a .vid file to start with, and to be saved to; one that does not exist
    /// yet is a new path of that name; NULL: none
    pub file: *const c_char,
    /// a path to start with, copied; NULL: a new one, or that of file. Not
    /// both
    pub path: *const V_PATH,
    /// an object to be shown, copied; NULL: that of the path
    pub object: *const V_MESH,
    /// frames for a way of one half size and so on, see v_path_set_base_frames().
    /// All 0: those of the path. Else they are the host's: the window keeps them and
    /// ignores a loaded file's
    pub move_frames: f64,
    pub turn_frames: f64,
    pub zoom_frames: f64,
    pub roll_frames: f64,
    /// name of the X display; NULL: the environment's DISPLAY
    pub display: *const c_char,
    /// "de" or "en"; NULL: the environment's, by LC_ALL, LC_MESSAGES, LANG.
    /// A language that the user has chosen in the setup counts before both
    pub language: *const c_char,
    /// called when the user hands over the poses; they are the library's and
    /// valid until it returns. Of a scene they are those of the camera that is shown,
    /// one for each frame of v_scene_frame_range(). NULL: nothing can be handed over
    pub on_poses: Option<
        unsafe extern "C" fn(
            editor: *mut V_EDITOR,
            poses: *const V_POSE,
            count: usize,
            user: *mut c_void,
        ),
    >,
    /// called before the user closes the window; 0 keeps it open. NULL: it
    /// closes
    pub on_close: Option<unsafe extern "C" fn(editor: *mut V_EDITOR, user: *mut c_void) -> c_int>,
    /// the host's, handed on to the callbacks
    pub user: *mut c_void,
    /// the movement space in the host's world: its centre, half of its edge, and
    /// which axis is up, V_UP_Y or V_UP_Z; of a scene in file, too. Half size 0: that of
    /// file or path, and V_UP_Z makes z upright in a new path
    pub space_centre: [f64; 3],
    pub space_half_size: f64,
    pub space_up: c_int,
    /// called with the camera at the playhead whenever that has changed, whether or
    /// not the window is seen (it may be covered, iconified, on another desktop, or in
    /// a parent that is not shown): sixty times a second at most, what came meanwhile
    /// is one call. frame counts from 1. reason is one of V_VIEW_.... The pose is the
    /// library's and valid until it returns. After a call of more than 30 ms the next
    /// one waits as long; the last pose always comes. NULL: none
    pub on_view: Option<
        unsafe extern "C" fn(
            editor: *mut V_EDITOR,
            pose: *const V_POSE,
            frame: f64,
            reason: c_int,
            user: *mut c_void,
        ),
    >,
    /// called when the path in the window has changed: after each step, undo and
    /// redo too, not while a drag goes on; steps of one sixtieth of a second are one
    /// call. Seen or not, as on_view. NULL: none
    pub on_change: Option<unsafe extern "C" fn(editor: *mut V_EDITOR, user: *mut c_void)>,
    /// "take over the view": the host fills in its own camera and returns 1; 0: it
    /// has none. vpn and vup of any length but 0, not parallel. NULL: that of
    /// v_editor_set_view() is taken
    pub on_capture: Option<
        unsafe extern "C" fn(editor: *mut V_EDITOR, pose: *mut V_POSE, user: *mut c_void) -> c_int,
    >,
    /// the camera pane opened, changed its size in pixels, or closed (window 0, sizes
    /// 0). The host draws in it what the camera sees, and again at each Expose: in a
    /// child of any visual that it makes there, which is kept at the pane's size, or
    /// in the pane itself, which is of the screen's own visual. A pane is never
    /// destroyed while the process lives. When it closes it is unmapped, a child in
    /// it is put out to the root window, unmapped, and then this is called; when the
    /// editor closes, after its window is gone, in v_editor_close() too. Then the
    /// editor's handle may be freed already; at the end of a thread nobody is called.
    /// On a server without XFIXES or SHAPE there is no pane. NULL: the editor draws
    /// itself
    pub on_pane: Option<
        unsafe extern "C" fn(
            editor: *mut V_EDITOR,
            window: c_ulong,
            width: c_int,
            height: c_int,
            user: *mut c_void,
        ),
    >,
    /// what the window calls the host's view, UTF-8, one line; NULL: "program"
    pub host_name: *const c_char,
    /// an X window of the display to live in, of any depth: the editor is its child
    /// and fills it; 0: a top-level window. If it is destroyed, or the editor's window
    /// is put out to the root, the editor is closed without asking on_close, and what
    /// was unsaved is offered at the next start. V_ERR_ARGUMENT if it is no window
    pub parent: c_ulong,
    /// the host's window that the editor's belongs to, above which a window manager
    /// keeps it; 0: none. V_ERR_ARGUMENT if it is no window
    pub transient_for: c_ulong,
    /// what the program is called: the first half of WM_CLASS, by which a desktop
    /// groups its windows, and unsaved work finds back to it; UTF-8; NULL: the name of the running program
    pub application: *const c_char,
    /// not 0: after a hand-over nothing is unsaved. So it is without a file, too,
    /// and in a window of v_haupt()
    pub hand_over_saves: c_int,
    /// for a host that draws the scene itself, by v_editor_get_scene() and
    /// v_scene_evaluate(): called with the scene's frame at the playhead, and why
    /// (V_VIEW_...), after that or the scene has changed; when as on_view. NULL:
    /// nobody is
    pub on_frame: Option<
        unsafe extern "C" fn(editor: *mut V_EDITOR, frame: f64, reason: c_int, user: *mut c_void),
    >,
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
