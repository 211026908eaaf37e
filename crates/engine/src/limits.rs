//! Every limit of the library in one place, each with its reason.

/// Support points of one path: far more than a person places, prepared in well under a second.
pub const MAX_POINTS: usize = 100_000;

/// Points of an up path: far more than a person places, and files stay small.
pub const MAX_UP_PATH_POINTS: usize = 1000;

/// Different up paths in one path.
pub const MAX_UP_PATHS: usize = 10;

/// Fewest support points of one path: a curve needs a start and an end.
pub const MIN_POINTS: usize = 2;

/// Orientations at one support point (thesis A.4.2).
pub const MAX_ORIENTATIONS: usize = 10;

/// Presets of one path (thesis A.6.1).
pub const PRESETS: usize = 10;

/// Speeds of one section (thesis 5.2).
pub const SPEEDS: usize = 10;

/// Points that one division of a segment inserts (`Pos.++`, thesis A.4.1).
pub const MAX_DIVISION: usize = 10;

/// The largest magnitude of a coordinate, in units of `half_size`: cubes of differences stay far
/// from overflow, and 1e-7 is still resolved at the far end.
pub const MAX_COORDINATE: f64 = 1e9;

/// The smallest `half_size` of a space: cubes of lengths down to 1e-9 of it stay far from
/// underflow.
pub const MIN_HALF_SIZE: f64 = 1e-30;

/// The largest `half_size` of a space: cubes of the largest coordinates stay far from overflow.
pub const MAX_HALF_SIZE: f64 = 1e30;

/// The slowest speed of a speed curve (thesis A.4.3).
pub const MIN_SPEED: f64 = 1.0;

/// The fastest speed of a speed curve (thesis A.4.3).
pub const MAX_SPEED: f64 = 100.0;

/// The speed at which the base speeds hold exactly (thesis B.2.2).
pub const BASE_SPEED: f64 = 50.0;

/// The smallest zoom (thesis A.4.4).
pub const MIN_ZOOM: f64 = 1.0;

/// The largest zoom: the longest lenses there are. (In the thesis, A.4.4, 100.)
pub const MAX_ZOOM: f64 = 2000.0;

/// The largest zoom of the lists of 1994, and what sliders reach (thesis A.4.4).
pub const MAX_LIST_ZOOM: f64 = 100.0;

/// The change of zoom that `zoom_frames` count frames for: from 1 to 100 (thesis B.2.2).
pub const ZOOM_UNIT: f64 = 99.0;

/// Frames of one path: an hour at 25,000 frames a second, 8 GB of poses; the count fits C's `int`.
pub const MAX_FRAMES: usize = 100_000_000;

/// Frames at which keys or a path are sampled to fit a path to them: eleven hours at 25 a second,
/// and about a gigabyte of memory.
pub const MAX_SAMPLED_FRAMES: usize = 1_000_000;

/// Frames that one key may rest.
pub const MAX_HOLD: u32 = 1_000_000;

/// Bytes of a `.vid` file: any document within the limits here at 24 characters a number; more
/// would only exhaust the memory of a small machine while it is parsed.
pub const MAX_FILE_BYTES: u64 = 972 << 20;

/// Bytes of memory that parsing a piece of a file may take by an estimate, for most far too high:
/// the largest object, written as it is saved, and a little more.
pub const MAX_PARSE_BYTES: usize = 2 << 30;

/// Bytes of memory that a piece of a file may take that is written as VIDES writes it: the largest
/// mesh with its colours. Nothing is saved that would take more.
pub const MAX_TREE_BYTES: usize = 3 << 30;

/// Frames of one section: the first pose of a path belongs to none.
pub const MAX_SECTION_FRAMES: usize = MAX_FRAMES - 1;

/// Keys of one section's given distance: few enough that slopes need no allocation.
pub const MAX_DISTANCE_KEYS: usize = 32;

/// The largest velocity or slope of a key, in degrees or mm a frame: no curve can follow more.
pub const MAX_RATE: f64 = 1e6;

/// Undo steps: more than a day's work by hand.
pub const MAX_HISTORY_STEPS: usize = 10_000;

/// Bytes, about, that the undo steps may hold beyond what they share; the newest is kept whatever
/// its size.
pub const MAX_HISTORY_BYTES: usize = 256 << 20;

/// Points of the wireframe object that a host or a file hands over.
pub const MAX_OBJECT_POINTS: usize = 1_000_000;

/// Orientations of all points of one path: what [`MAX_FILE_BYTES`] holds at 24 characters a number.
pub const MAX_ALL_ORIENTATIONS: usize = 200_000;

/// Frames per second of a film: the fastest cameras there are.
pub const MAX_FPS: f64 = 100_000.0;

/// Bytes of a name, a title or a unit: one line on a screen.
pub const MAX_NAME_BYTES: usize = 256;

/// Bytes of a comment.
pub const MAX_COMMENT_BYTES: usize = 65_536;

/// Control points of one Bézier curve of any degree: de Casteljau costs the square of it.
pub const MAX_BEZIER_POINTS: usize = 1_024;

/// Keys of one quaternion spline handed over in a call.
pub const MAX_KEYS: usize = 1_000_000;

/// Bytes of a text pasted from another program, which might send without end.
pub const MAX_CLIPBOARD_BYTES: usize = 16 << 20;

/// Nodes of one scene: all of them are evaluated for each frame.
pub const MAX_NODES: usize = 100_000;

/// Levels of a scene's tree: far more than a skeleton has; their scales are multiplied.
pub const MAX_LEVELS: usize = 256;

/// Tracks of one node: every channel, and some hundred numbers of the host.
pub const MAX_TRACKS: usize = 1_000;

/// Numbers of all keys of one scene, tangents included: 64 MB.
pub const MAX_SCENE_NUMBERS: usize = 8_000_000;

/// Numbers of one of the host's own channels.
pub const MAX_CHANNEL_WIDTH: usize = 16;

/// The largest tangent of a key, per frame: the largest coordinate within a millionth of a frame.
pub const MAX_TANGENT: f64 = 1e15;

/// Points of an object's mesh.
pub const MAX_MESH_POINTS: usize = 4_000_000;

/// Ends of lines, or corners of triangles, of an object's mesh.
pub const MAX_MESH_CORNERS: usize = 24_000_000;

/// Shapes that an object can take: a face with all its expressions.
pub const MAX_SHAPES: usize = 256;

/// Deformations of one object.
pub const MAX_DEFORMATIONS: usize = 64;

/// Markers on a scene's timeline.
pub const MAX_MARKERS: usize = 10_000;

/// Points of paths that are pinned to markers.
pub const MAX_PINS: usize = 100_000;

/// Interpolations that one process registers: each track looks its own up by name.
pub const MAX_INTERPOLATIONS: usize = 1_000;

/// The least and the greatest distance of a tour, in half diagonals of the object.
pub const TOUR_DISTANCES: [f64; 2] = [1e-3, 1e3];
