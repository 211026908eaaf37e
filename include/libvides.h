/*
 * libvides: camera paths through space
 *
 * A path has a few points, each with one or more views (orientations); the library
 * computes every camera pose in between. Link with -lvides -lm.
 * cbindgen makes this file from the library's source.
 *
 * Where to begin
 *
 *   v_editor_open()   opens the editor window beside your program's own
 *   v_path_load()     reads a path; v_path_new() makes one
 *   v_path_sample()   returns all poses, v_path_pose() one
 *   v_scene_load()    reads a scene of objects, lights and cameras
 *   v_haupt()         the call of 1994
 *
 * Conventions
 *
 * - Status. Functions that return int, except v_fd(), v_timeout() and v_dispatch(),
 *   return V_OK (0) or one of V_ERR_...; v_last_error() returns the reason. Any may
 *   return V_ERR_MEMORY, V_ERR_LIMIT or V_ERR_INTERNAL; with numbers, texts or structs
 *   V_ERR_ARGUMENT or V_ERR_RANGE; with a pointer V_ERR_NULL or V_ERR_ARGUMENT; with a
 *   capacity or a struct that begins with size V_ERR_SIZE; with a handle V_ERR_HANDLE,
 *   with a V_SCENE also V_ERR_BUSY, with a V_EDITOR also V_ERR_CLOSED. Each comment
 *   lists the others, and causes that are not obvious. A void function reports an error
 *   by v_last_error() only.
 * - Results are written through pointers, and only on success.
 * - NULL fails with V_ERR_NULL, unless the comment allows it. Where a function gets
 *   several values, each result may be NULL.
 * - Texts are UTF-8, zero-terminated; a file is a name as for open().
 * - Arrays. A function that fills in your array or text of capacity elements or bytes
 *   also writes how many there are (of a text without its zero). If they do not fit,
 *   it writes only that number and fails with V_ERR_SIZE; with NULL and capacity 0 it
 *   writes only that number, which must not be NULL.
 * - Structs that begin with size may grow at their end in later versions. Set size to
 *   sizeof the struct before any call, even if the library fills in the rest. That of
 *   an earlier 1.x may be shorter; any other size fails with V_ERR_SIZE. v_..._init()
 *   sets it, and the defaults. v_editor_options_init() is a macro in C; the function, for
 *   other languages (ctypes, JNI, bindgen), fills in the struct of version 1.0.
 * - Ownership. The library copies what it is given. It keeps only the pointers given
 *   to v_haupt(), and the callbacks and user pointers of v_editor_open(),
 *   v_register_interpolation() and v_set_progress(). You free the paths, scenes and
 *   editors that you get, with v_path_free(), v_scene_free() and v_editor_close(), and
 *   the lists of the 1994 interface. Texts and arrays that it returns belong to it; a
 *   text is never NULL.
 * - Memory. If it runs out while a text is parsed, or a file is opened or written, the
 *   program may end instead; the old file is unchanged.
 * - Callbacks may call any function, except where its comment says otherwise.
 * - Threads. A window belongs to the thread that opened it. Every other function may
 *   be called from any thread; calls on the same path or scene are atomic. The library
 *   starts a thread to resolve the name of a remote display, and one, in a program with
 *   Xt, to see whether windows are served; both block all signals, call none of your
 *   functions, and end. A call uses at most 128 KiB of your thread's stack.
 * - X server. If it is missing or goes away, its windows close, v_last_error()
 *   returns the reason, and your program continues.
 * - Counting. Indices count from 0, poses and frames from 1; in the names of properties
 *   and the options of tools everything counts from 1. A frame of a path given as a
 *   double is from 1 to v_path_frame_count(), also between two whole frames.
 * - Units. Lengths are in your world's units, speeds in these per second, angles in
 *   degrees. Coordinates are right-handed, y up unless the path's space says z up.
 */

#ifndef LIBVIDES_H
#define LIBVIDES_H

#include <stddef.h>


/* ---- Version of this header -------------------------------------------------- */

/**
 * v_version() returns the version of the library in use.
 */
#define V_VERSION_MAJOR 1
#define V_VERSION_MINOR 0
#define V_VERSION_PATCH 0


/* ---- Statuses ---------------------------------------------------------------- */

/**
 * v_strerror() describes a status; v_last_error() returns what was wrong in the call.
 *
 * V_OK            done
 * V_ERR_NULL      a pointer that must not be NULL is NULL
 * V_ERR_HANDLE    not a valid handle: freed, of another kind, never made, or a window of
 *                 another thread
 * V_ERR_ARGUMENT  a value is not valid: not finite, a target on the camera, an up vector
 *                 along the view, a text that is not UTF-8, a misaligned pointer
 * V_ERR_RANGE     an index or a value is out of range, or NaN where a range applies
 * V_ERR_SIZE      an array is too small, or the size of a struct is not set
 * V_ERR_LIMIT     more points, orientations, poses or bytes than the library allows
 * V_ERR_MEMORY    out of memory; nothing was changed
 * V_ERR_IO        the operating system refused to read or write a file
 * V_ERR_FORMAT    the contents of a file are not valid; v_last_error() names the place
 * V_ERR_DISPLAY   no window can be opened, or its X server went away
 * V_ERR_BUSY      not possible now, for example within this callback
 * V_ERR_CLOSED    the window is gone (V_GONE_...), or its thread has ended
 * V_ERR_INTERNAL  a fault of the library; the path or scene concerned may be unusable
 *                 from now on, everything else works
 * V_ERR_REFUSED   the user or a callback refused
 */
#define V_OK 0
#define V_ERR_NULL 1
#define V_ERR_HANDLE 2
#define V_ERR_ARGUMENT 3
#define V_ERR_RANGE 4
#define V_ERR_SIZE 5
#define V_ERR_LIMIT 6
#define V_ERR_MEMORY 7
#define V_ERR_IO 8
#define V_ERR_FORMAT 9
#define V_ERR_DISPLAY 10
#define V_ERR_BUSY 11
#define V_ERR_CLOSED 12
#define V_ERR_INTERNAL 13
#define V_ERR_REFUSED 14


/* ---- Constants --------------------------------------------------------------- */

/**
 * Why on_view and on_frame are called.
 *
 * V_VIEW_SELECTED  another point, orientation or camera was selected
 * V_VIEW_EDITED    something is being dragged or was changed
 * V_VIEW_SCRUBBED  another frame was chosen
 * V_VIEW_PLAYED    the window is playing
 * V_VIEW_RESTED    nothing moves any more; ends each series: draw in full quality
 */
#define V_VIEW_SELECTED 0
#define V_VIEW_EDITED 1
#define V_VIEW_SCRUBBED 2
#define V_VIEW_PLAYED 3
#define V_VIEW_RESTED 4

/**
 * Why on_gone is called.
 *
 * V_GONE_BY_USER    the user closed the window
 * V_GONE_WITH_ALL   v_editors_close(0) closed it
 * V_GONE_DESTROYED  it was destroyed from outside or removed from its parent
 * V_GONE_DISPLAY    its X server went away or refused to go on
 * V_GONE_FAULT      a fault inside the library closed it
 */
#define V_GONE_BY_USER 0
#define V_GONE_WITH_ALL 1
#define V_GONE_DESTROYED 2
#define V_GONE_DISPLAY 3
#define V_GONE_FAULT 4

/** Which axis is up. */
#define V_UP_Y 1
#define V_UP_Z 2

/**
 * Kinds of property, and the functions for each.
 *
 * V_PROPERTY_NUMBER   v_path_set_number(), v_scene_set_number()
 * V_PROPERTY_NUMBERS  v_path_set_numbers(), v_scene_set_numbers()
 * V_PROPERTY_TEXT     v_path_set_text(), v_scene_set_text()
 * V_PROPERTY_FLAG     v_path_set_flag(), v_scene_set_flag()
 */
#define V_PROPERTY_NUMBER 0
#define V_PROPERTY_NUMBERS 1
#define V_PROPERTY_TEXT 2
#define V_PROPERTY_FLAG 3

/**
 * How v_path_insert_path() places a block.
 *
 * V_FIT_NONE   unchanged
 * V_FIT_MOVE   moved, so that it begins at the point
 * V_FIT_TURN   also turned, so that it continues in the direction of travel
 * V_FIT_SCALE  moved, turned and scaled, so that it also ends at the next point
 */
#define V_FIT_NONE 0
#define V_FIT_MOVE 1
#define V_FIT_TURN 2
#define V_FIT_SCALE 3

/** The kinds of node. */
#define V_NODE_GROUP 0
#define V_NODE_OBJECT 1
#define V_NODE_LIGHT 2
#define V_NODE_CAMERA 3

/** The kinds of light. */
#define V_LIGHT_DIRECTIONAL 0
#define V_LIGHT_POINT 1
#define V_LIGHT_SPOT 2

/**
 * How a motion continues after its end.
 *
 * V_AFTER_HOLD      holds the last value
 * V_AFTER_REPEAT    starts over; the period is the last frame minus the first, and
 *                   where they meet the last value is used
 * V_AFTER_PINGPONG  goes back and forth
 * V_AFTER_OFFSET    starts over from where it ended
 *
 * Before its start a path continues in the same way. A track holds its first value
 * there, unless you add one of V_BEFORE_...: V_AFTER_REPEAT | V_BEFORE_PINGPONG.
 */
#define V_AFTER_HOLD 0
#define V_AFTER_REPEAT 1
#define V_AFTER_PINGPONG 2
#define V_AFTER_OFFSET 3
#define V_BEFORE_REPEAT 16
#define V_BEFORE_PINGPONG 32
#define V_BEFORE_OFFSET 48

/** What a node keeps when its parent changes. */
#define V_KEEP_PLACE 0
#define V_KEEP_NUMBERS 1

/**
 * Kinds of easing, see v_ease().
 *
 * V_EASE_SINE       the speed rises and falls as a quarter of a sine
 * V_EASE_PARABOLIC  it rises and falls as a straight line
 */
#define V_EASE_SINE 0
#define V_EASE_PARABOLIC 1

/**
 * Conventions of camera axes, all right-handed.
 *
 * V_AXES_OPENGL  x right, y up, z backward
 * V_AXES_OPENCV  x right, y down, z forward
 * V_AXES_ROS     x forward, y left, z up (REP 103)
 * V_AXES_VIDES   x left, y up, z forward: those of nodes (V_NODE_STATE) and of
 *                v_view_from_quat()
 */
#define V_AXES_OPENGL 0
#define V_AXES_OPENCV 1
#define V_AXES_ROS 2
#define V_AXES_VIDES 3

/**
 * Clip coordinates, see v_pose_projection().
 *
 * V_CLIP_OPENGL    y up, depth from -1 (near) to 1 (far)
 * V_CLIP_D3D       y up, depth from 0 to 1: Direct3D, Metal, WebGPU
 * V_CLIP_VULKAN    y down, depth from 0 to 1
 * V_CLIP_REVERSED  added to one of these: swaps near and far, so that a float depth from
 *                  0 is precise far away
 */
#define V_CLIP_OPENGL 0
#define V_CLIP_D3D 1
#define V_CLIP_VULKAN 2
#define V_CLIP_REVERSED 16

/**
 * The order of three turns: the first letter is the axis of the first turn.
 * V_ORDER_XYZ is XYZ in Blender and ZYX in three.js; V_ORDER_ZXY is ZXY in Nuke.
 */
#define V_ORDER_XYZ 0
#define V_ORDER_XZY 1
#define V_ORDER_YXZ 2
#define V_ORDER_YZX 3
#define V_ORDER_ZXY 4
#define V_ORDER_ZYX 5


/* ---- Types ------------------------------------------------------------------- */
/* Handles, values, options. */

/**
 * A handle for a camera path, not an address: using one that was freed or never made,
 * or freeing it twice, is harmless and fails with V_ERR_HANDLE.
 */
typedef struct v_path V_PATH;

/**
 * A mesh: points, and the lines and triangles that connect them; without either, only
 * the points are shown.
 */
struct v_mesh {
    size_t size;
    /** three numbers per point */
    const double *xyz;
    size_t points;
    /** three bytes per point; NULL: no colours */
    const unsigned char *rgb;
    /** two indices per line; NULL: none */
    const unsigned int *lines;
    /** number of indices, even */
    size_t line_ends;
    /** three indices per triangle; NULL: none */
    const unsigned int *triangles;
    /** number of indices, a multiple of 3 */
    size_t corners;
};

typedef struct v_mesh V_MESH;

/**
 * How the camera looks at a point of the path, and how it moves on from there. The
 * window calls an orientation a view.
 */
struct v_orientation {
    size_t size;
    /**
     * not 0: target is a point in the world; 0: an offset from the path's point, of
     * which only the direction matters
     */
    int absolute;
    /** what the camera looks at; must not be the point itself */
    double target[3];
    /**
     * degrees, turns up about the view; any finite number, stored in (-180, 180]
     */
    double roll;
    /** 1 to 2000 */
    double zoom;
    /** of the turning, each from -1 to 1 */
    double tension;
    double continuity;
    double bias;
    /**
     * speed curve of the section that begins here, each from 1 to 100; at 50 the base
     * speeds apply
     */
    double speed[10];
    /** frames that the camera rests here, 0 to 1000000 */
    int hold;
};

typedef struct v_orientation V_ORIENTATION;

/** A camera pose. This layout will never change. */
struct v_pose {
    /** position of the camera */
    double vrp[3];
    /** view direction; length 1 */
    double vpn[3];
    /** up; length 1, perpendicular to vpn */
    double vup[3];
    /**
     * 1 to 2000: focal length in mm of a 36 x 24 mm camera, with a vertical field of
     * view of 2 atan (12 / zoom). For other lenses see v_zoom_from_fov()
     */
    double zoom;
};

typedef struct v_pose V_POSE;

/** What is known of a property. The texts are constant. */
struct v_property {
    size_t size;
    /**
     * its name, with N for a number from 1 or, of nodes, a name: "point.N.view.N.zoom_mm"
     */
    const char *name;
    /** V_PROPERTY_... */
    int kind;
    /** how many numbers it has; 0: any number */
    size_t count;
    /**
     * of its numbers: "degrees", "mm", "frames", "lengths" (of your world), that of a
     * finding, or ""
     */
    const char *unit;
    /** the least and the greatest number, or -INFINITY and INFINITY */
    double least;
    double most;
    /** what a new path or node has, as in a file; "": nothing */
    const char *usual;
    /** what it is */
    const char *about;
};

typedef struct v_property V_PROPERTY;

/** A point or a vector in the cube from -1 to 1 in x, y and z, y up. */
struct v_punkt {
    float x;
    float y;
    float z;
};

typedef struct v_punkt V_PUNKT;

/** The same type by the name that other structs use. */
typedef V_PUNKT V_POS;

/**
 * A camera pose in a list, and the whole list by its first element. The list is
 * circular: first->prev is the last element, whose number is the count, and whose next
 * is the first. A list of one element points to itself.
 *
 * The first element is yours and must outlive the list. Before the first hand-over set
 * its number to -1: no data yet; prev and next have no meaning. VIDES allocates the
 * others with malloc(), so that you or v_free_liste() may free() them. The next list
 * reuses them.
 */
struct interpolparameter {
    /** position of the camera (view reference point) */
    V_POS VRP;
    /** view direction; length 1 */
    V_POS VPN;
    /** up; length 1, perpendicular to VPN */
    V_POS VUP;
    /**
     * 1 to 100, rounded, 100 for any larger. Vertical field of view: 2 atan (12 /
     * zoom)
     */
    int zoom;
    struct interpolparameter *prev;
    struct interpolparameter *next;
    /** 1, 2, 3 ... along the list; in the first element < 0: no data */
    int number;
};

typedef struct interpolparameter interpolparameter;
typedef interpolparameter V_KAMERAPAR;

/** The motion of a camera at a frame. */
struct v_motion {
    size_t size;
    /** along the path since the first frame */
    double distance;
    /** length per second */
    double speed;
    /** degrees per second, rolling included */
    double turning;
    /** 1 / radius; 0 where the camera holds or turns on the spot */
    double curvature;
};

typedef struct v_motion V_MOTION;

/**
 * A handle for a scene (see V_PATH): a tree of nodes that move on one timeline.
 *
 * Inside a function given to v_register_interpolation(), functions that take a V_SCENE
 * fail with V_ERR_BUSY, except v_scene_free(). A text that they return is valid until
 * the same thread's next call that returns one.
 */
typedef struct v_scene V_SCENE;

/** Something that v_path_check() found. It does not grow. */
struct v_finding {
    /** see v_path_check(); the text is constant */
    const char *kind;
    /** where it begins */
    double first_frame;
    /** and where it ends */
    double last_frame;
    /** the point at which the section begins */
    int point;
    /** the orientation with which it begins */
    int orientation;
    /** the worst value */
    double value;
    /** the limit of its kind */
    double limit;
};

typedef struct v_finding V_FINDING;

/**
 * A node at rest. Its local matrix is T(position) T(pivot) R S T(-pivot), its world
 * matrix its parent's times the local one. Lights and cameras look along their own +z
 * axis with +y up and have pivot 0. Values that a kind of node does not have are
 * ignored.
 */
struct v_node {
    size_t size;
    /** V_NODE_... */
    int kind;
    /** parent node; -1: none */
    int parent;
    /** 0 hides the node and its descendants */
    int visible;
    /** lights and cameras: the node at whose pivot it looks; -1: none */
    int aim;
    /** what the node turns and scales about */
    double pivot[3];
    double position[3];
    /** w x y z, of any length but 0 */
    double rotation[4];
    double scale[3];
    /** cameras: 1 to 2000, see V_POSE */
    double zoom;
    /** cameras: degrees, turns up about the view */
    double roll;
    /** lights: V_LIGHT_... */
    int light;
    /** lights and objects: linear red, green, blue, each 0 or more */
    double colour[3];
    /** lights: 0 or more */
    double intensity;
    /** lights: half angles in degrees, inner and outer, 0 to 90 */
    double cone[2];
    /** cameras: > 0 */
    double near_plane;
    /** cameras: > near_plane */
    double far_plane;
};

typedef struct v_node V_NODE;

/**
 * Computes the value of a channel at a frame between its first and last key, from the
 * frames and the values of the keys, width numbers each. It writes width numbers to
 * value and returns V_OK; if it returns anything else, or writes a number that is not
 * finite, the channel steps from key to key.
 */
typedef int (*V_INTERPOLATE)(const double *frames,
                             const double *values,
                             size_t width,
                             size_t keys,
                             double frame,
                             double *value,
                             void *user);

/** A node at a frame. This layout will never change. */
struct v_node_state {
    /** from the node's coordinates to the world's, column by column */
    double matrix[16];
    /** cameras and lights; otherwise all 0 */
    V_POSE pose;
    /** lights and objects */
    double colour[3];
    /** lights */
    double intensity;
    /** lights: half angles in degrees, inner and outer */
    double cone[2];
    /** 1 if the node and all its ancestors are visible, else 0 */
    int visible;
};

typedef struct v_node_state V_NODE_STATE;

/**
 * A handle for an editor window (see V_PATH). On any thread but the one that opened
 * it, its functions fail with V_ERR_HANDLE. Free it even if the user has closed the
 * window.
 */
typedef struct v_editor V_EDITOR;

/**
 * Options of an editor window. What they point to, except user, need only remain valid
 * during v_editor_open(). A callback that is NULL is not called.
 */
struct v_editor_options {
    size_t size;
    /**
     * text after "VIDES" in the title, one line; NULL: the name of the file
     */
    const char *title;
    /**
     * a .vid file to start with and to save to; if it does not exist yet, a new path
     * of that name; NULL: none
     */
    const char *file;
    /**
     * a path to start with; NULL: a new one, or that of file. Not together with file
     */
    const V_PATH *path;
    /**
     * an object to show, at which a new path looks; NULL: that of the path
     */
    const V_MESH *object;
    /**
     * base speeds, see the property "base_speeds". All 0: those of the path; otherwise
     * they are fixed, and those of a loaded file are ignored
     */
    double move_frames;
    double turn_frames;
    double zoom_frames;
    double roll_frames;
    /**
     * name of the X display; NULL: the one that the program's Xt opened last; without
     * Xt, the environment's DISPLAY
     */
    const char *display;
    /**
     * "de" or "en"; NULL: by LC_ALL, LC_MESSAGES, LANG. A language that the user chose
     * in the setup takes precedence
     */
    const char *language;
    /**
     * called when the user hands over the poses, which are valid until it returns; in
     * a scene those of the camera shown, one for each frame of v_scene_frame_range().
     * NULL: no hand-over is possible
     */
    void (*on_poses)(V_EDITOR *editor, const V_POSE *poses, size_t count, void *user);
    /**
     * called before the user closes the window; 0 keeps it open. NULL: it closes
     */
    int (*on_close)(V_EDITOR *editor, void *user);
    /** your pointer, passed to the callbacks */
    void *user;
    /**
     * the space in your world, also for a scene in file: its centre, half of its edge,
     * V_UP_Y or V_UP_Z. With space_half_size 0 it is that of file or path, and V_UP_Z
     * makes z the up axis of a new path
     */
    double space_centre[3];
    double space_half_size;
    int space_up;
    /**
     * called with the camera at the playhead whenever it has changed, at most 60 times
     * a second, even if the window is not visible; reason is V_VIEW_.... The pose is valid
     * until it returns. After a call of more than 30 ms the next one waits as long
     */
    void (*on_view)(V_EDITOR *editor,
                    const V_POSE *pose,
                    double frame,
                    int reason,
                    void *user);
    /**
     * called when the path has changed: after each step, undo and redo, not during a
     * drag or a tool's preview; steps within a sixtieth of a second are combined
     */
    void (*on_change)(V_EDITOR *editor, void *user);
    /**
     * called when the user adds your program's view to the path (Ctrl-Enter): fill in
     * your camera and return 1, or return 0 if you have none. vpn and vup have any
     * length but 0 and are not parallel. NULL: the view of v_editor_set_view()
     */
    int (*on_capture)(V_EDITOR *editor, V_POSE *pose, void *user);
    /**
     * called when the camera pane opens, changes its size in pixels, or closes (window
     * 0, sizes 0). Draw in it what the camera sees, again at each Expose: in the pane,
     * which has the screen's visual, or in a child window of any visual that you create
     * there and that is kept at its size. A pane is never destroyed while the process
     * lives: it and its child, moved to the root window, are unmapped before this is
     * called; when the editor closes, after its window is gone and perhaps its handle
     * freed. Not called when the thread ends, nor without XFIXES or SHAPE. NULL: the
     * editor draws the picture itself
     */
    void (*on_pane)(V_EDITOR *editor,
                    unsigned long window,
                    int width,
                    int height,
                    void *user);
    /**
     * what the window calls your program's view, one line; NULL: "program"
     */
    const char *host_name;
    /**
     * an X window of the display, of any depth, which the editor fills as its child;
     * 0: a top-level window. If it is destroyed, or the editor's window is moved to
     * the root, the editor closes without on_close
     */
    unsigned long parent;
    /** your window, above which window managers keep the editor; 0: none */
    unsigned long transient_for;
    /**
     * name of the program: the first half of WM_CLASS, by which desktops group windows
     * and unsaved work is found again; NULL: that of the running program
     */
    const char *application;
    /**
     * not 0: after a hand-over nothing is unsaved, as always without a file and in a
     * window of v_haupt()
     */
    int hand_over_saves;
    /**
     * for programs that draw the scene themselves: called, like on_view, with the scene's
     * frame at the playhead when that frame or the scene has changed
     */
    void (*on_frame)(V_EDITOR *editor, double frame, int reason, void *user);
    /**
     * what your program's picture shows when the window opens: a new path begins with it
     * and leads to the right, around the middle of the picture. NULL: a new path looks at
     * the object, and on_view is called at once
     */
    const V_POSE *view;
    /**
     * called once, after the window is gone; reason is V_GONE_.... You may free the
     * handle here. Not called when v_editor_close() closes the window or its thread ends
     */
    void (*on_gone)(V_EDITOR *editor, int reason, void *user);
};

typedef struct v_editor_options V_EDITOR_OPTIONS;

/** One point of the wireframe object that v_haupt() shows. */
struct v_objekt_list {
    V_POS pos;
    /** not 0: a line leads here from the point before */
    unsigned short draw;
    /** 1, 2, 3 ... in the order of the array */
    int number;
};

typedef struct v_objekt_list V_OBJEKT_LISTE;

/** The same type by its other name. */
typedef V_OBJEKT_LISTE V_OBJEKT_LIST;

/**
 * A view as defined by PHIGS. The eye is on the side that normal points to, so it
 * looks against normal. Everything except vrp, normal and up is in the view's
 * coordinates u (right), v (up), n (along normal), with the origin at vrp.
 */
struct v_view {
    size_t size;
    /** view reference point, world */
    double vrp[3];
    /** view plane normal, world, any length but 0 */
    double normal[3];
    /** view up vector, world, not parallel to normal */
    double up[3];
    /** projection reference point: the eye (u, v, n) */
    double prp[3];
    /** umin, umax, vmin, vmax on the view plane */
    double window[4];
    /** n of the front plane, less than that of prp */
    double front;
    /** n of the back plane, less than front */
    double back;
    /** n of the view plane */
    double distance;
    /** not 0: perspective; 0: parallel */
    int perspective;
};

typedef struct v_view V_VIEW;

#ifdef __cplusplus
extern "C" {
#endif


/* ---- Errors ------------------------------------------------------------------ */
/* Why a call failed, and what it reports. */

/**
 * Returns why the calling thread's last call failed: one sentence in English, at
 * most 1023 bytes, "" after a success. It names parameters (path, options->title)
 * and counts as this header does. Valid until the same thread's next call of any
 * function except this one, v_last_warning(), v_strerror() and v_version().
 */
const char *v_last_error(void);

/**
 * Returns the warnings of the calling thread's last call of a function whose comment
 * mentions them: sentences in English, at most 1023 bytes, or "". Valid until the
 * same thread's next call of such a function.
 */
const char *v_last_warning(void);

/** Returns the meaning of a status, in English. */
const char *v_strerror(int status);

/** Returns the version of the library in use, as "1.0.0". */
const char *v_version(void);


/* ---- Paths ------------------------------------------------------------------- */
/* Made, copied, loaded, saved. */

/**
 * Makes a new path: two points at (-0.6, 0.2, 0.8) and (0.6, 0.2, 0.8), each with one
 * orientation of v_orientation_init().
 */
int v_path_new(V_PATH **path);

/** Makes an independent copy of a path. */
int v_path_clone(const V_PATH *path, V_PATH **copy);

/**
 * Frees a path. NULL is ignored. A call that uses it in another thread completes.
 */
void v_path_free(V_PATH *path);

/**
 * Reads a path from a .vid file; of a scene, the path of the camera shown: saving that
 * to the same file would lose the rest.
 * V_ERR_IO, V_ERR_FORMAT, V_ERR_ARGUMENT (no camera, or it follows no path).
 */
int v_path_load(const char *file, V_PATH **path);

/**
 * Like v_path_load(), from the text of a .vid file: size bytes.
 * V_ERR_FORMAT.
 */
int v_path_load_from_memory(const char *text, size_t size, V_PATH **path);

/**
 * Saves a path to a .vid file, which is replaced atomically and is on the disk when
 * the call returns. Symbolic links are followed and permissions kept.
 * V_ERR_IO.
 */
int v_path_save(const V_PATH *path, const char *file);

/** Gets the text that v_path_save() would write. */
int v_path_save_to_memory(const V_PATH *path, char *text, size_t capacity,
                          size_t *length);

/**
 * Sets the object shown with a path; NULL: none. The window draws its lines and the
 * edges of its triangles; beyond 1,000,000 points of lines, only points where they
 * end or bend. v_path_check() uses the triangles.
 */
int v_path_set_object(V_PATH *path, const V_MESH *object);

/**
 * Gets the object shown with a path, 0 points without one. The arrays are valid
 * until the same thread's next call of this function.
 */
int v_path_get_object(const V_PATH *path, V_MESH *mesh);


/* ---- Points ------------------------------------------------------------------ */
/* What the curve passes through. */

/**
 * Gets the number of points, at least 2.
 */
int v_path_point_count(const V_PATH *path, int *count);

/**
 * Inserts a point before index at; if at is their number, appends it. It copies all
 * other properties from the point before it, or from the first one; an absolute
 * target equal to its position becomes relative.
 */
int v_path_insert_point(V_PATH *path, int at, const double xyz[3]);

/**
 * Divides a segment with 1 to 10 points on its curve, at equal arc lengths. They
 * copy all other properties from the point before them, so the motion changes;
 * v_path_insert_on_curve() keeps it.
 */
int v_path_divide_segment(V_PATH *path, int segment, int points);

/** Removes a point. The last two cannot be removed. */
int v_path_remove_point(V_PATH *path, int at);

/** Moves a point to another index; the points between shift by one. */
int v_path_move_point(V_PATH *path, int from, int to);


/* ---- Orientations ------------------------------------------------------------ */
/* How the camera looks at a point. */

/**
 * Fills in an orientation: relative target (0, 0, -0.4), roll 0, zoom 24, tension,
 * continuity and bias 0, all speeds 50, hold 0.
 */
void v_orientation_init(V_ORIENTATION *o);

/**
 * Gets the number of orientations of a point, 1 to 10. The camera arrives in the
 * first, turns from one to the next, and leaves in the last.
 */
int v_path_orientation_count(const V_PATH *path, int point, int *count);

/**
 * Inserts an orientation before index at; if at is their number, appends it. NULL
 * copies the one before it, or the first one if at is 0.
 */
int v_path_insert_orientation(V_PATH *path, int point, int at,
                              const V_ORIENTATION *o);

/** Removes an orientation. The only one of a point cannot be removed. */
int v_path_remove_orientation(V_PATH *path, int point, int at);

/**
 * Sets all values of an orientation. Settings that V_ORIENTATION does not have (ease,
 * distance curve, fixed frames, looking ahead, up) are unchanged.
 */
int v_path_set_orientation(V_PATH *path, int point, int at, const V_ORIENTATION *o);

/** Gets the values of an orientation. */
int v_path_get_orientation(const V_PATH *path, int point, int at, V_ORIENTATION *o);

/**
 * Makes the target of an orientation absolute (not 0) or relative (0). The view does
 * not change.
 */
int v_path_set_absolute(V_PATH *path, int point, int at, int absolute);

/**
 * Sets which way is up for an orientation, before its roll.
 *
 * up  "axis"     the up axis of the space, the default
 *     "point"    towards up_point
 *     "path"     towards the position on up_path at the same fraction of its length
 *     "minimal"  starts with the up axis and is carried on without turning about the
 *                view, through all consecutive orientations that have it; on a closed
 *                path, the angle missing at the end is spread over the length
 *     "frenet"   the normal of the curve, only of kind "cubic" without custom tangents
 *     "y", "z"   this axis, whatever the space's up axis
 * Arguments that an up does not need may be NULL. A path has at most 10 different up
 * paths of at most 1000 points.
 */
int v_path_set_up(V_PATH *path, int point, int at, const char *up,
                  const double *up_point, const V_PATH *up_path);

/**
 * Gets the up of an orientation (a constant text), the point of "point" or zeros,
 * and an open path with the curve of "path", which you free, or NULL.
 */
int v_path_get_up(const V_PATH *path, int point, int at, const char **up,
                  double up_point[3], V_PATH **up_path);


/* ---- Spaces ------------------------------------------------------------------ */
/* The scale and the up axis of a path. */

/**
 * Makes a new path in a space, a cube in your world, placed as that of v_path_new()
 * is in its own. half_size is half the length of its edge, up V_UP_Y or V_UP_Z.
 *
 * The properties "space.centre", "space.half_size" and "space.up" change the space
 * of a path or scene, not its coordinates. Base speeds, default limits and the
 * distances below which nothing moves are relative to half_size; nothing is farther
 * than 1e9 times half_size from the centre. In a scene, "space.up" applies to nodes
 * that aim at others; a path in it has its own space.
 */
int v_path_new_in_space(const double centre[3], double half_size, int up,
                        V_PATH **path);

/**
 * Changes the up axis of a path (V_UP_Y, V_UP_Z) without changing any pose. Rolls
 * are then measured from the new axis. Views that track a target or look ahead get
 * the old axis as their up, "y" or "z"; one that equals the new axis becomes "axis".
 */
int v_path_change_up(V_PATH *path, int up);

/**
 * Makes an orientation look like the camera of a pose, for a path with this up axis
 * (V_UP_Y, V_UP_Z): sets a relative target, the pose's vpn, and roll and zoom. The
 * rest of *orientation is unchanged: call v_orientation_init() before. vpn and vup
 * have any length but 0 and are not parallel.
 */
int v_orientation_from_pose(const V_POSE *pose, int up, V_ORIENTATION *orientation);


/* ---- Properties -------------------------------------------------------------- */
/* Values of paths and scenes by their names in .vid files. */

/**
 * Gets what is known of a property of paths, scenes or checks, counted from 0.
 */
int v_property_info(int at, V_PROPERTY *property);

/** Gets the number of properties that v_property_info() knows. */
int v_property_count(int *count);

/**
 * Returns the name of a property of an orientation, counted from 0, for loops:
 * v_path_key(1, 2, "zoom") is "point.2.view.3.zoom"; with orientation -1 one of the
 * point, "point.2.position". Valid until the same thread's next call of this
 * function or v_scene_key(); "" if an argument is not valid.
 */
const char *v_path_key(int point, int orientation, const char *key);

/**
 * Sets a number of a path by its name, atomically.
 *
 * name  a key of .vid files, points and orientations counted from 1: "fps",
 *     "point.2.zoom" (of its first orientation), "point.2.view.3.zoom",
 *     "space.half_size", or a limit of v_path_check(), "check.turning". The unit at
 *     its end may be missing. docs/reference/files.md lists them
 * value  of a limit, INFINITY disables the check
 *
 * These functions fail with V_ERR_RANGE (no such property, or a value out of range)
 * or V_ERR_ARGUMENT (a property of another kind, another invalid value).
 * v_last_error() names the property and counts from 1.
 */
int v_path_set_number(V_PATH *path, const char *name, double value);

/** Gets a number; NaN if it is not set. */
int v_path_get_number(const V_PATH *path, const char *name, double *value);

/**
 * Sets several numbers: "point.2.position", "point.2.own" (tension, continuity,
 * bias), "base_speeds", "point.2.ease" (V_EASE_..., rise, fall, cruise),
 * "point.2.distance" (pairs of time and distance), "space.centre". With count 0 the
 * property is again that of a new path, or no longer set.
 * V_ERR_ARGUMENT (also a wrong count).
 */
int v_path_set_numbers(V_PATH *path, const char *name, const double *values,
                       size_t count);

/** Gets several numbers; none if they are not set. */
int v_path_get_numbers(const V_PATH *path, const char *name, double *values,
                       size_t capacity, size_t *count);

/**
 * Sets a text: "title", "point.2.name", or the name of a choice: "curve",
 * "space.up". Other properties, too, from their text in a .vid file, "[0, 1, 2]";
 * for these "" restores the value of a new path.
 */
int v_path_set_text(V_PATH *path, const char *name, const char *value);

/**
 * Gets a text or a choice; another property as in a .vid file. "" if it is not set.
 */
int v_path_get_text(const V_PATH *path, const char *name, char *value,
                    size_t capacity, size_t *length);

/** Sets a flag, "closed": not 0 or 0. */
int v_path_set_flag(V_PATH *path, const char *name, int value);

/** Gets a flag: 1 or 0. */
int v_path_get_flag(const V_PATH *path, const char *name, int *value);


/* ---- The curve --------------------------------------------------------------- */
/* Where a path leads, whatever its speed. */

/**
 * Gets the length of the whole curve.
 */
int v_path_length(const V_PATH *path, double *length);

/**
 * Gets the length of a segment. Segment n leads from point n to the next; a closed
 * path has one more, from the last point to the first.
 */
int v_path_segment_length(const V_PATH *path, int segment, double *length);

/** Gets the position on a segment at the spline's parameter t, 0 to 1. */
int v_path_curve_point(const V_PATH *path, int segment, double t, double xyz[3]);

/**
 * Gets the position on a segment at the distance s along the curve, from 0 to the
 * segment's length.
 */
int v_path_point_at_length(const V_PATH *path, int segment, double s,
                           double xyz[3]);

/**
 * Gets the tangents of the curve at a point, equal at an end of an open path, and
 * whether they are custom: 1 or 0. The property "tangents" sets them: the
 * derivatives with which the curve reaches and leaves the point, a segment counting
 * 1.
 */
int v_path_get_tangents(const V_PATH *path, int at, double before[3],
                        double after[3], int *own);

/**
 * Inserts a point on the curve where the camera is at a frame, without changing the
 * curve, any pose or the number of frames. It gets the nearest whole frame within
 * the section; a section of one frame becomes two. Neighbours get custom tangents,
 * angular velocities, slopes of zoom and roll, and a part of the old speed profile;
 * such tangents are removed when their point or a neighbour moves alone, unless you
 * set them. *at receives the index.
 *
 * frame  not at a key, not in a pan, not with orientation_mode "barry-goldman"
 */
int v_path_insert_on_curve(V_PATH *path, double frame, int *at);


/* ---- Poses ------------------------------------------------------------------- */
/* The camera at each frame. */

/**
 * Gets the number of sections. A section leads from one orientation to the next, at
 * the same point or at the next one, in the order in which the camera takes them.
 */
int v_path_section_count(const V_PATH *path, int *count);

/**
 * Gets the point and orientation with which a section begins, its first frame, and
 * its number of frames without a hold at its end.
 */
int v_path_section_info(const V_PATH *path, int section, int *point,
                        int *orientation, size_t *first_frame, size_t *frames);

/** Gets the number of frames, at least 1. */
int v_path_frame_count(const V_PATH *path, size_t *frames);

/** Writes all poses to your array. */
int v_path_sample(const V_PATH *path, V_POSE *poses, size_t capacity,
                  size_t *count);

/**
 * Writes count poses of v_path_sample(), from frame first on, to your array.
 */
int v_path_sample_range(const V_PATH *path, size_t first, size_t count,
                        V_POSE *poses);

/**
 * Gets the pose at a frame. At a whole frame it equals that of v_path_sample()
 * exactly.
 */
int v_path_pose(const V_PATH *path, double frame, V_POSE *pose);

/**
 * Gets the poses at count frames, as v_path_pose() does, in any order; ascending ones
 * are fastest. poses must not overlap frames.
 */
int v_path_poses_at(const V_PATH *path, const double *frames, size_t count,
                    V_POSE *poses);

/**
 * Makes a list of all poses, see V_KAMERAPAR. Set the number of first before, to -1
 * if there is no data yet. A list that VIDES made there before is freed when the new
 * one is complete. No other thread may use the list meanwhile.
 */
int v_path_to_list(const V_PATH *path, V_KAMERAPAR *first);

/**
 * Writes all poses to a text file, replaced atomically, one line each: VRP, VPN, VUP
 * (x, y and z each) and zoom, as C prints them by "%3.4f", separated by one space.
 * The decimal sign is a point; minus zero is written as zero. Zoom is the path's, 1
 * to 2000: only the list's int ends at 100.
 * V_ERR_IO.
 */
int v_path_write_ascii(const V_PATH *path, const char *file);

/** Gets the text that v_path_write_ascii() would write. */
int v_path_write_ascii_to_memory(const V_PATH *path, char *text, size_t capacity,
                                 size_t *length);

/**
 * Gets the frame at a time from 0 to (v_path_frame_count() - 1) / fps: 1 + seconds *
 * fps. For the time of a whole frame from v_path_seconds_at_frame(), it is exactly
 * that frame.
 */
int v_path_frame_at_seconds(const V_PATH *path, double seconds, double *frame);

/** Gets the time of a frame: (frame - 1) / fps seconds. */
int v_path_seconds_at_frame(const V_PATH *path, double frame, double *seconds);

/**
 * Gets the motion of the camera at a frame; at a key, that after the key.
 */
int v_path_motion(const V_PATH *path, double frame, V_MOTION *motion);


/* ---- Tools ------------------------------------------------------------------- */
/* Changes of a whole path, checks. */

/**
 * Changes a path by a tool, atomically. docs/reference/command.md lists the options
 * of each with their defaults, tools.md and planning.md what they do.
 *
 * "reverse"  the same poses in reverse order
 * "repeat"   count times, each beginning where the last one ended: times
 * "frames"   fixes the frames from the first pose at one point to the last pose at
 *            another: frames, first, last. Sections share them by what they take at their
 *            speed, at least one each; those with "locked" keep theirs
 * "retime"   speed as fast as the limits of v_path_check() allow, or for a duration with
 *            the lowest peaks: seconds, first, last. Reports "seconds"
 * "steady"   stabilises a recorded flight: period in seconds, within. Reports
 *            "furthest", "turned"
 * "avoid"    leads a path clear of an object: clearance, radius. Reports "parts",
 *            "moved", "inserted", "furthest"
 * "picture"  keeps an object in the picture: margin, what (zoom, distance, view).
 *            Reports "added", "tightest", "loosest"
 * "tour"     replaces the path by one that shows an object: seconds, coverage, distance,
 *            inside, start (without it a closed tour). Reports "coverage", "places",
 *            "distance", "length", "seconds". Takes some seconds and 300 bytes per
 *            triangle for a million of them. From outside, only the side of the normals
 *            counts where neighbouring triangles agree about it
 * "move", "turn", "scale", "mirror"  transform points from first to last
 * "taper", "bulge", "twist", "bend", "free-form"  deform them, in their bounds or in box
 *            (two corners)
 * "orbit", "spiral", "arc", "flyby", "approach", "dolly-zoom", "crane", "pan",
 * "figure-eight"  replace the path by a move, or with put=append add it: around or at
 *            (the target's position or the camera's), radius, height, distance, width,
 *            length, end-radius, end-height, end-distance, headings in degrees (from,
 *            to: 0 towards +z, 90 towards +x; with z up +x and +y), turns, rise, tilt,
 *            zoom, seconds
 *
 * options  lines of name=value ("frames=250\nlast=3", "around=0,1,0"); NULL: none.
 *     Points count from 1, from the first to the last by default; 0 and the last
 *     stand for the whole path, if closed with the way back to the first
 * object  in the coordinates of the path, for "avoid", "picture" and "tour"; NULL:
 *     the path's own
 *
 * v_last_warning() returns what was done, v_last_number() the numbers.
 * V_ERR_ARGUMENT (no such tool, no way, too few seconds: v_last_error() names the
 * place or the least), V_ERR_REFUSED.
 */
int v_path_tool(V_PATH *path, const char *tool, const char *options,
                const V_MESH *object);

/**
 * Changes the path that a node of a scene follows, like v_path_tool(); its pins
 * hold. object NULL: the objects of the scene at the first pose.
 * V_ERR_ARGUMENT (also a node that follows no path), V_ERR_REFUSED.
 */
int v_scene_tool(V_SCENE *scene, int node, const char *tool, const char *options,
                 const V_MESH *object);

/**
 * Gets a number that the calling thread's last tool or v_path_fit_poses() reported.
 * V_ERR_ARGUMENT (no such number).
 */
int v_last_number(const char *name, double *value);

/**
 * Moves, turns, scales and mirrors the points from first_point to last_point, with
 * their custom tangents.
 *
 * matrix  column by column, without shear; its last row is 0 0 0 1
 * with_targets  1: with targets, views and rolls; 0: absolute targets stay in place,
 *     relative ones keep their direction
 * V_ERR_ARGUMENT (shear, or a point at its own target).
 */
int v_path_transform(V_PATH *path, int first_point, int last_point,
                     const double matrix[16], int with_targets);

/**
 * Copies the points from first_point to last_point into a new, open path with the same
 * curve. On a closed path first_point may be after last_point.
 */
int v_path_extract(const V_PATH *path, int first_point, int last_point,
                   V_PATH **block);

/**
 * Inserts a copy of a path, block, which may be the same, after point at. Both keep
 * their curves, the block its targets; where they join, they have one direction.
 * Except with V_FIT_NONE, the block's first point is merged with that point, which
 * keeps its views; with V_FIT_SCALE its last point likewise with the next one. A
 * closed block ends where it begins. Duplicate names get a number.
 * V_ERR_ARGUMENT (no direction, or no length to scale).
 */
int v_path_insert_path(V_PATH *path, int at, const V_PATH *block, int fit);

/**
 * Makes the weighted sum of paths, point by point: positions, curve, targets, roll,
 * zoom and speeds; also fixed frames (rounded), angular velocities and slopes that
 * all have. Paths with fewer points are first resampled by length. The rest comes
 * from the path with the greatest weight. The count weights have the sum 1.
 */
int v_path_blend(V_PATH *const *paths, const double *weights, size_t count,
                 V_PATH **blend);

/**
 * Fits a path of few points to recorded poses: each position within tolerance, each
 * view, up and field of view within angle degrees, at its time. Noise below that is
 * removed. Poses that jerk between whole frames may be missed.
 *
 * seconds  when each pose was taken, in order; NULL: one per frame. Of equal times
 *     the first counts. Times beyond 1e11 count nanoseconds or microseconds
 * count  at least two
 * options  lines of name=value; NULL: none. fps (25); tolerance (a thousandth of the
 *     diagonal of the positions); angle (0.5); points, at most that many, from which
 *     the tolerance follows; robust=yes leaves out outliers, poses farther than the
 *     tolerance from what their neighbours suggest; up (y or z); space, its centre
 *     and half its edge (the smallest cube around the positions, enlarged by a
 *     tenth)
 *
 * v_last_warning() returns points, deviations, holds, gaps, cuts, outliers, and what
 * helps against many points; v_last_number() "tolerance", "left_out" (poses).
 * V_ERR_ARGUMENT (times that run backwards, a view without direction), V_ERR_LIMIT
 * (times that span more than 100,000,000 frames), V_ERR_REFUSED.
 */
int v_path_fit_poses(const V_POSE *poses, const double *seconds, size_t count,
                     const char *options, V_PATH **path);

/**
 * Finds what will look wrong: jerks, flips, collisions. Writes one finding per kind
 * and run of frames to your array, in their order. In parentheses the default
 * limits, for a space of half_size 1; those of lengths are relative to it. The
 * property "check.turning" and so on is the limit, in lengths of your world.
 *
 * "space"         outside the space (0)
 * "cusp"          curve or speed nearly stop (0.02 of the mean)
 * "speed-jump"    at a key, of the mean speed (0.5)
 * "acceleration"  per second squared (10)
 * "view-jump"     degrees at once (1)
 * "turning"       degrees per second (60)
 * "turning-acceleration"  degrees per second squared (300)
 * "half-turn"     degrees from a half turn (0.1)
 * "pole"          degrees from straight up or down (3)
 * "target"        distance (0.05)
 * "clearance"     distance of the object (0.02)
 * "through"       through a triangle of the object
 * "nothing-to-see"  seconds without the object in the picture (1)
 * "zoom"          mm per second (30)
 * "redundant"     times 0.001, 0.1 degrees and 0.1 mm that a key changes (1)
 * "corner"        degrees (60)
 * "jerk"          per second cubed (off)
 * "speed"         per second (off)
 * "crossing"      seconds in which what is seen crosses the picture (off)
 * "backwards"     distance back between points that lead on (0.001)
 *
 * A hold, or a turn on the spot, between sections without an ease counts as a
 * "speed-jump", an "acceleration" or a "turning-acceleration" only if that limit is
 * not the default.
 *
 * object  in the coordinates of the path; NULL: the path's own, if it has one
 * v_last_warning() returns notes: that the camera is always inside the object, and
 * what was ignored (moving objects, the motion of the camera's parent).
 * V_ERR_ARGUMENT (an object without geometry), V_ERR_REFUSED.
 */
int v_path_check(const V_PATH *path, const V_MESH *object, V_FINDING *findings,
                 size_t capacity, size_t *count);

/**
 * Sets the function that the calling thread's long calls (those with V_ERR_REFUSED,
 * except v_editors_close()) call at most ten times a second; NULL, the default:
 * none.
 *
 * progress  share is from 0 to 1, and may fall when another round begins. If it
 *     returns 0, the call fails with V_ERR_REFUSED and changes nothing. In it, a
 *     path or scene in use, such as that of the call, is V_ERR_BUSY. No exception or
 *     longjmp() may leave it
 */
int v_set_progress(int (*progress)(double share, void *user), void *user);


/* ---- Scenes ------------------------------------------------------------------ */
/* Nodes that move on one timeline. */

/**
 * Fills in a node of this kind at the origin: visible, scale 1, rotation 1 0 0 0, no
 * parent, no aim, zoom 24, white, intensity 1, a cone of 20 and 30 degrees, planes
 * at 0.01 and 1000.
 */
void v_node_init(V_NODE *node, int kind);

/**
 * Makes a new scene: one camera, "camera", on the path of v_path_new(), from frame
 * 1.
 */
int v_scene_new(V_SCENE **scene);

/**
 * Reads a scene from a .vid file; one with only a path gives a camera on it.
 *
 * An object is left empty if its mesh file is missing, malformed, or outside the
 * folder of the .vid file once links are followed (v_scene_load_geometry() reads it
 * from anywhere); v_last_warning() reports this, and a mesh that has changed.
 * V_ERR_IO, V_ERR_FORMAT.
 */
int v_scene_load(const char *file, V_SCENE **scene);

/**
 * Like v_scene_load(), from the text of a .vid file: size bytes. Relative names of
 * mesh files are looked up in the current directory.
 * V_ERR_FORMAT.
 */
int v_scene_load_from_memory(const char *text, size_t size, V_SCENE **scene);

/**
 * Gets the text of the .vid file of a scene. The names of mesh files are unchanged.
 */
int v_scene_save_to_memory(const V_SCENE *scene, char *text, size_t capacity,
                           size_t *length);

/**
 * Saves a scene, like v_path_save().
 * V_ERR_IO.
 */
int v_scene_save(const V_SCENE *scene, const char *file);

/** Makes an independent copy of a scene, like v_path_clone(). */
int v_scene_clone(const V_SCENE *scene, V_SCENE **copy);

/** Frees a scene, like v_path_free(). */
void v_scene_free(V_SCENE *scene);


/* ---- Nodes ------------------------------------------------------------------- */
/* Groups, objects, lights and cameras. */

/**
 * Adds a node after the others. *node receives its number; it may be NULL. name is
 * unique in its scene, one line, not empty.
 */
int v_scene_add_node(V_SCENE *scene, const char *name, const V_NODE *values,
                     int *node);

/**
 * Removes a node with all its descendants. The numbers of later nodes decrease;
 * nodes that aimed at a removed one no longer aim. Removing many in a row costs as
 * much as one.
 */
int v_scene_remove_node(V_SCENE *scene, int node);

/**
 * Gets the number of the node with this name.
 * V_ERR_ARGUMENT (no such node).
 */
int v_scene_find_node(const V_SCENE *scene, const char *name, int *node);

/** Gets the name of a node. */
int v_scene_get_name(const V_SCENE *scene, int node, const char **name);

/** Renames a node, see v_scene_add_node(). */
int v_scene_set_name(V_SCENE *scene, int node, const char *name);

/** Gets a node at rest. */
int v_scene_get_node(const V_SCENE *scene, int node, V_NODE *values);

/**
 * Sets the values of a node; its kind does not change. If the parent changes,
 * position, rotation and scale are relative to the old one: the node keeps its place
 * in the world at the scene's first frame. A node that moves can only change to a
 * parent in the same place.
 * V_ERR_ARGUMENT (such as a cycle).
 */
int v_scene_set_node(V_SCENE *scene, int node, const V_NODE *values);

/**
 * Makes a node follow a path; NULL: none. Pose n is shown at the scene's frame
 * start_frame + n - 1. The path moves position, rotation and zoom in the parent's
 * coordinates; a node with a track for one of them cannot have a path. after is
 * V_AFTER_HOLD, V_AFTER_REPEAT or V_AFTER_PINGPONG.
 */
int v_scene_set_path(V_SCENE *scene, int node, const V_PATH *path,
                     double start_frame, int after);

/**
 * Gets a copy of the path that a node follows, and its start_frame and after.
 * V_ERR_ARGUMENT (it follows none).
 */
int v_scene_get_path(const V_SCENE *scene, int node, V_PATH **path,
                     double *start_frame, int *after);

/**
 * Sets a marker at a frame, or moves the one of this name (one line, not empty).
 */
int v_scene_set_marker(V_SCENE *scene, const char *name, double frame);

/**
 * Pins a point of a node's path to a marker; NULL removes the pin. Pins hold when
 * the path changes.
 */
int v_scene_pin(V_SCENE *scene, int node, int point, const char *marker);

/**
 * Returns the name of a property of a node, counted from 0, like v_path_key():
 * v_scene_key(1, "intensity") is "node.2.intensity".
 */
const char *v_scene_key(int node, const char *key);

/**
 * The same functions for scenes. name is "fps", "first_frame", "space.half_size", a
 * limit, or a value of a node at rest by its name or its number from 1:
 * "node.lamp.intensity", "node.2.intensity".
 */
int v_scene_set_number(V_SCENE *scene, const char *name, double value);

/** See v_path_get_number(). */
int v_scene_get_number(const V_SCENE *scene, const char *name, double *value);

/** See v_path_set_numbers(). */
int v_scene_set_numbers(V_SCENE *scene, const char *name, const double *values,
                        size_t count);

/** See v_path_get_numbers(). */
int v_scene_get_numbers(const V_SCENE *scene, const char *name, double *values,
                        size_t capacity, size_t *count);

/** See v_path_set_text(). */
int v_scene_set_text(V_SCENE *scene, const char *name, const char *value);

/** See v_path_get_text(). */
int v_scene_get_text(const V_SCENE *scene, const char *name, char *value,
                     size_t capacity, size_t *length);

/** See v_path_set_flag(). */
int v_scene_set_flag(V_SCENE *scene, const char *name, int value);

/** See v_path_get_flag(). */
int v_scene_get_flag(const V_SCENE *scene, const char *name, int *value);

/**
 * Sets the camera that is shown; -1: the first one on a path, else the first one. The
 * choice follows the node, is removed with it, and is saved.
 * V_ERR_ARGUMENT (no camera).
 */
int v_scene_set_camera(V_SCENE *scene, int node);

/** Gets the camera that is shown; -1: none. */
int v_scene_get_camera(const V_SCENE *scene, int *node);

/**
 * Sets the first and last frame; if first > last, they follow from all paths and
 * keys. They are saved.
 * V_ERR_LIMIT (more than 100000000 frames).
 */
int v_scene_set_range(V_SCENE *scene, double first, double last);

/**
 * Sets the parent of a node; -1: no parent. keep is V_KEEP_PLACE (its place in the
 * world at the scene's first frame) or V_KEEP_NUMBERS (its values, path and tracks).
 * V_ERR_ARGUMENT (such as a cycle).
 */
int v_scene_set_parent(V_SCENE *scene, int node, int parent, int keep);


/* ---- Tracks ------------------------------------------------------------------ */
/* Values by keys. */

/**
 * Sets the keys of a channel, replacing older ones; 0 keys remove the track.
 *
 * channel  "position", "rotation" (w x y z), "scale", "visible" (0 or 1); for cameras
 *     "roll" (degrees) and, unless they follow a path, "zoom" (mm); for lights
 *     "colour", "intensity", "cone"; for objects "colour", "weights" (one per shape)
 *     and "deformation.N.NAME" (N from 0; NAME of v_deform()); for cameras and lights
 *     "aim_weight" (0 to 1); for your own use "value:NAME" or "value:NAME:W" with W
 *     numbers (1 to 16)
 * interpolation  "step", "linear", "ramp", "sine", "parabolic", "catmull-rom",
 *     "hermite", "tcb", "cubic" (not for rotations), "host:NAME"; for rotations also
 *     "euler-linear" and "euler-catmull-rom", with yaw, pitch and roll in degrees per
 *     key. "visible" takes only "step"
 * frames  strictly increasing
 * values  keys x width numbers, key by key
 * shape  "hermite": the tangents before and after each key (2 x width, per frame);
 *     "tcb": tension, continuity and bias of each key; otherwise NULL
 * after  V_AFTER_..., optionally | V_BEFORE_...
 */
int v_scene_set_track(V_SCENE *scene, int node, const char *channel,
                      const char *interpolation, const double *frames,
                      const double *values, const double *shape, size_t keys,
                      int after);

/**
 * Gets the keys of a channel as set. *keys receives their number, 0 if there is no
 * track (*interpolation is then ""). capacity counts keys.
 */
int v_scene_get_track(const V_SCENE *scene, int node, const char *channel,
                      const char **interpolation, size_t capacity, double *frames,
                      double *values, double *shape, size_t *keys, int *after);

/**
 * Registers a function as the interpolation "host:NAME" for all scenes of the
 * process, replacing an older one; NULL removes it. Any thread that evaluates a
 * scene calls it. It must not use scenes, and no longjmp() and no exception may
 * leave it.
 */
int v_register_interpolation(const char *name, V_INTERPOLATE function, void *user);


/* ---- Objects ----------------------------------------------------------------- */
/* Meshes, shapes and deformations. */

/**
 * Sets the geometry of an object. If the object has shapes, the mesh must have as many
 * points as they have.
 */
int v_scene_set_geometry(V_SCENE *scene, int node, const V_MESH *mesh);

/**
 * Reads the geometry of an object from an OBJ, PLY, STL or glTF file, by its
 * extension. A saved .vid file refers to that file, by a relative name if it is in
 * the same folder or below.
 * V_ERR_IO, V_ERR_FORMAT.
 */
int v_scene_load_geometry(V_SCENE *scene, int node, const char *file);

/**
 * Adds a shape to an object: other positions for all its points, with weight 0 at
 * first. The channel "weights" has one number per shape; the mesh itself gets the
 * remainder to 1.
 *
 * rgb  three bytes per point; NULL: the colours of the mesh
 */
int v_scene_add_shape(V_SCENE *scene, int node, const char *name, const double *xyz,
                      const unsigned char *rgb, size_t points);

/**
 * Adds a deformation (see v_deform()) to an object, after the others. *at receives its
 * number and may be NULL. box NULL: the bounds of the geometry at rest.
 */
int v_scene_add_deformation(V_SCENE *scene, int node, const char *kind,
                            const double *parameters, size_t count,
                            const double box[6], int *at);

/**
 * Removes a deformation with its tracks. The numbers of later deformations decrease,
 * in the names of channels too.
 */
int v_scene_remove_deformation(V_SCENE *scene, int node, int at);

/**
 * Deforms points in place. u, v, w run from -1 to 1 along the sides of the box (min x
 * y z, max x y z); along a side of length 0 points do not move. Axes are 0, 1, 2.
 * Angles are degrees in u, v, w, stretched with a box that is not a cube. Tracks can
 * animate the names in parentheses.
 *
 * "taper"      axis a (a): the other two times 1 + (a-1)(1-u^2)
 * "taper"      axis r0 r1 (r0 r1): from r0 at one end to r1 at the other
 * "twist"      axis angle (angle): about the axis, from 0 to angle
 * "bend"       axis angle (angle): about the axis; the middle does not move
 * "bend"       axis_u axis_v u0 v0 phi_min phi_max (the last four): u becomes
 *              the angle about (u0, v0), v - v0 the distance from it
 * "free-form"  64 points, 3 numbers each (points): a Bezier volume over the box,
 *              the first index fastest; (-1, -1, -1), (-1/3, -1, -1) ... is the
 *              identity. Points outside the box do not move
 */
int v_deform(const char *kind, const double *parameters, size_t count,
             const double box[6], double *xyz, size_t points);


/* ---- Contents ---------------------------------------------------------------- */
/* What has been set in a scene. */

/**
 * Gets how many there are of a scene's "nodes", "markers" or "pins" (node is then
 * ignored), or of a node's "tracks", "shapes" or "deformations".
 * V_ERR_ARGUMENT (no such thing; no object).
 */
int v_scene_count(const V_SCENE *scene, int node, const char *what, int *count);

/** Gets the channel of a node's track, for v_scene_get_track(). */
int v_scene_get_channel(const V_SCENE *scene, int node, int at,
                        const char **channel);

/** Gets a marker; they are sorted by name. */
int v_scene_get_marker(const V_SCENE *scene, int at, const char **name,
                       double *frame);

/**
 * Removes a marker and its pins.
 * V_ERR_ARGUMENT (no such marker).
 */
int v_scene_remove_marker(V_SCENE *scene, const char *name);

/** Gets a pin of v_scene_pin(); they are sorted by node and point. */
int v_scene_get_pin(const V_SCENE *scene, int at, int *node, int *point,
                    const char **marker);

/**
 * Gets the geometry of an object at rest; 0 points if it has none. The arrays are
 * valid until the scene is changed or freed.
 * V_ERR_ARGUMENT (no object).
 */
int v_scene_get_geometry(const V_SCENE *scene, int node, V_MESH *mesh);

/**
 * Gets the name of an object's shape, its points and, if it has its own (*coloured 1),
 * their colours. capacity and *points count points.
 * V_ERR_ARGUMENT (no object).
 */
int v_scene_get_shape(const V_SCENE *scene, int node, int at, const char **name,
                      double *xyz, unsigned char *rgb, size_t capacity,
                      size_t *points, int *coloured);

/**
 * Removes a shape of an object. The numbers of later shapes decrease; the others keep
 * their weights, also in a track of the channel "weights".
 * V_ERR_ARGUMENT (no object).
 */
int v_scene_remove_shape(V_SCENE *scene, int node, int at);

/**
 * Gets the kind, parameters and box of an object's deformation. A box of 1 1 1 -1 -1
 * -1 stands for the bounds of the geometry: give v_scene_add_deformation() NULL then.
 * V_ERR_ARGUMENT (no object).
 */
int v_scene_get_deformation(const V_SCENE *scene, int node, int at,
                            const char **kind, double *parameters, size_t capacity,
                            size_t *count, double box[6]);


/* ---- Evaluation -------------------------------------------------------------- */
/* The scene at a frame. */

/**
 * Gets the first and last frame: those of v_scene_set_range(), otherwise those of all
 * paths and keys; 1 and 1 if nothing moves.
 */
int v_scene_frame_range(const V_SCENE *scene, double *first, double *last);

/**
 * Gets the states of all nodes at any finite frame, in the order of their numbers.
 *
 * If a "host:" interpolation is not registered, fails or returns a number that is
 * not finite, its channel steps from key to key; v_last_warning() reports it, also
 * after the functions below.
 */
int v_scene_evaluate(const V_SCENE *scene, double frame, V_NODE_STATE *states,
                     size_t capacity, size_t *count);

/**
 * Gets count states of one node, at the frames first, first + frame_step and so on.
 */
int v_scene_sample(const V_SCENE *scene, int node, double first, double frame_step,
                   V_NODE_STATE *states, size_t count);

/**
 * Gets the value of a channel at a frame, with or without a track, and the number of
 * its components.
 */
int v_scene_value(const V_SCENE *scene, int node, const char *channel, double frame,
                  double *values, size_t capacity, size_t *width);

/**
 * Gets the points of an object at a frame, morphed and deformed, in the coordinates
 * of the node, and their colours, morphed likewise (unchanged if the mesh has none).
 * capacity and *points count points.
 */
int v_scene_vertices(const V_SCENE *scene, int node, double frame, double *xyz,
                     unsigned char *rgb, size_t capacity, size_t *points);

/**
 * Writes a scene in another program's format. Each file is replaced atomically. A
 * missing folder is created only for colmap, inside an existing one.
 *
 * format  gltf, glb, usda, blender, paraview, vtk, nerfstudio, transforms,
 *     instant-ngp, cameras, supersplat, tum, euroc, kitti, matrices, open3d, colmap
 *     (a folder), osg, chan, html, ascii, csv, json or vid; NULL: by the name of the
 *     file
 * options  lines of name=value ("fps=30\nnode=camera"); NULL: none. The names are
 *     node, clip, frames, fps, times, start, size, up, scale, as, tolerance, angle,
 *     compact, digits and rotation-order; `vides convert --help` explains them.
 *
 * v_last_warning() lists what the format cannot hold, one per line.
 * V_ERR_ARGUMENT (also no such node, a host interpolation that fails), V_ERR_FORMAT
 * (a folder that holds what would be read first), V_ERR_IO.
 */
int v_scene_export(const V_SCENE *scene, const char *file, const char *format,
                   const char *options);

/**
 * Reads another program's file, or a folder of files, as a scene. Poses become a
 * path fitted with few points; with "as=keys", or fewer than three poses, a camera
 * with one key each.
 *
 * format  as for v_scene_export(), without blender, vtk and html, and also record3d
 *     and polycam; paraview as v_scene_export() writes it, no code is run. NULL: by
 *     the content
 * options  as for v_scene_export()
 *
 * v_last_warning() lists ignored parts of the file, and how well a path fits.
 * V_ERR_IO, V_ERR_FORMAT.
 */
int v_scene_import(const char *file, const char *format, const char *options,
                   V_SCENE **scene);


/* ---- Windows ----------------------------------------------------------------- */
/* An editor beside your own program. */

/**
 * Fills in the default options: space_up V_UP_Y, everything else NULL or 0.
 */
void v_editor_options_init(V_EDITOR_OPTIONS *options);

/**
 * Like v_editor_options_init(), for a struct of size bytes; size becomes what was
 * filled in. A struct shorter than in version 1.0 is unchanged.
 */
void v_editor_options_init_sized(V_EDITOR_OPTIONS *options, size_t size);

/**
 * Opens an editor window and returns at once; see v_fd() for how your program serves
 * it. options NULL: the defaults. Call it from the thread that runs the event loop.
 *
 * The callbacks run there, also while your program shows a modal dialog. No
 * longjmp() and no exception may leave them; an exception that does ends the
 * program, after a line on standard error that names the callback. When the thread
 * ends, its window is closed, with a line on standard error.
 * V_ERR_HANDLE (of path), V_ERR_IO and V_ERR_FORMAT (of file), V_ERR_DISPLAY.
 */
int v_editor_open(const V_EDITOR_OPTIONS *options, V_EDITOR **editor);

/**
 * Closes a window without asking, and frees its handle: on the thread that opened
 * it, or on any once the window is gone. Inside the window's own callbacks it closes
 * when they have returned. on_gone is not called. Unsaved work is offered at the
 * next start of the program. NULL is ignored.
 */
int v_editor_close(V_EDITOR *editor);

/**
 * Gets a copy of the path in a window; in a scene, that of the camera shown.
 * V_ERR_ARGUMENT (no camera, or it follows no path).
 */
int v_editor_get_path(const V_EDITOR *editor, V_PATH **path);

/**
 * Replaces the path in a window, in one step that the user can undo, with its space,
 * title, comment and so on, and its object if it has one. Base speeds given when the
 * window was opened are kept. In a scene it replaces the path of the camera shown,
 * which is then edited. The playhead stays if it can.
 * V_ERR_ARGUMENT (no camera, or it follows no path).
 */
int v_editor_set_path(V_EDITOR *editor, const V_PATH *path);


/* ---- Windows and your picture ------------------------------------------------ */
/* What both show. */

/**
 * Shows your program's camera as a ghost, which the user can add to the path as a
 * point; NULL hides it. vpn and vup have any length but 0.
 *
 * Changes that a callback makes with the functions of this section or with
 * v_editor_set_path() cause no further callbacks.
 */
int v_editor_set_view(V_EDITOR *editor, const V_POSE *pose);

/**
 * Gets the frame at the playhead, for v_path_pose(); in a scene a frame of the scene,
 * for v_scene_evaluate().
 */
int v_editor_get_frame(const V_EDITOR *editor, double *frame);

/**
 * Moves the playhead to a frame; in a scene one of the scene, within
 * v_scene_frame_range(). The orientation that the camera comes from becomes current.
 */
int v_editor_set_frame(V_EDITOR *editor, double frame);

/**
 * Plays the flight from the playhead, or from the beginning if that is at the end,
 * even if the window is not visible; 0 stops.
 */
int v_editor_play(V_EDITOR *editor, int play);

/**
 * Makes an orientation current.
 * V_ERR_ARGUMENT (no path is edited).
 */
int v_editor_select(V_EDITOR *editor, int point, int orientation);

/** Replaces the object shown, in one step; NULL removes it. */
int v_editor_set_object(V_EDITOR *editor, const V_MESH *object);

/**
 * Sets the text after "VIDES" in the window's title, one line; NULL: the name of the
 * file.
 */
int v_editor_set_title(V_EDITOR *editor, const char *title);

/** Gets whether closing a window would lose work: 1 or 0. */
int v_editor_is_modified(const V_EDITOR *editor, int *modified);

/**
 * Marks the contents of a window as saved, after your program has kept them.
 */
int v_editor_mark_saved(V_EDITOR *editor);

/**
 * Saves the contents of a window to a .vid file, which it edits from then on. NULL:
 * its own file.
 * V_ERR_ARGUMENT (no file yet, or changed by another program), V_ERR_IO.
 */
int v_editor_save(V_EDITOR *editor, const char *file);

/**
 * Raises a window above all others, if the desktop allows it.
 * V_ERR_DISPLAY.
 */
int v_editor_raise(V_EDITOR *editor);

/**
 * Closes all windows that this thread has open, also those of v_haupt(), for your
 * program's Quit. You still free the handles with v_editor_close().
 *
 * ask  0: without asking; unsaved work is offered at the next start. Otherwise each
 *     window in turn asks about unsaved work and then calls on_close or ende, until
 *     all are closed or one refuses; meanwhile all are served
 *
 * Meanwhile the call handles the events, timers and inputs of a program with Xt, in
 * the context that this thread ran last; no longjmp() and no exception may leave
 * their callbacks. A second call raises the window that asks.
 * V_ERR_REFUSED (the windows before that one are closed), V_ERR_BUSY (within a
 * callback, or while an earlier call asks), V_ERR_DISPLAY, V_ERR_LIMIT (no
 * descriptors).
 */
int v_editors_close(int ask);

/**
 * Gets a copy of the scene in a window; if the window has only a path, a scene with a
 * camera on it.
 */
int v_editor_get_scene(const V_EDITOR *editor, V_SCENE **scene);

/**
 * Replaces the scene in a window, in one step that the user can undo, with its
 * space, title, comment and so on, and its wireframe object if it has one.
 *
 * If the new scene has a node with the name of the edited one and a path, that path
 * is edited; otherwise that of the camera shown, if it has one, with the base speeds
 * given when the window was opened. A scene with nothing but one camera on a path is
 * treated as that path. A drag in progress ends. The playhead stays
 * if it can.
 */
int v_editor_set_scene(V_EDITOR *editor, const V_SCENE *scene);

/**
 * Undoes the last step of a window, like Ctrl-Z: up to 10,000 steps, and 256 MiB.
 * V_ERR_ARGUMENT (nothing to undo).
 */
int v_editor_undo(V_EDITOR *editor);

/**
 * Redoes the step that was undone last, like Ctrl-Y.
 * V_ERR_ARGUMENT (nothing to redo).
 */
int v_editor_redo(V_EDITOR *editor);

/**
 * Begins a group of changes in a window, yours and the user's, that the user undoes
 * as one step. It replaces a group begun before; loading another document ends it.
 */
int v_editor_begin_step(V_EDITOR *editor);

/** Ends the group of v_editor_begin_step(); does nothing without one. */
int v_editor_end_step(V_EDITOR *editor);

/**
 * Gets the current point and orientation.
 * V_ERR_ARGUMENT (no path is edited).
 */
int v_editor_get_selection(const V_EDITOR *editor, int *point, int *orientation);

/** Gets whether a window is playing: 1 or 0. */
int v_editor_is_playing(const V_EDITOR *editor, int *playing);


/* ---- Event loop -------------------------------------------------------------- */
/* How your program serves its windows. */

/**
 * Returns the descriptor to watch with select(), poll() or the like; when it is
 * readable, call v_dispatch(). It stays the same and open as long as the thread
 * lives; never read or close it. Returns -1 if the system has no more descriptors.
 *
 * The functions of this section concern the calling thread's windows. A program with
 * an Xt or Motif main loop needs none of them, unless it processes XtIMXEvent only.
 * Any other program, also one that runs Xt under its own select(), watches this
 * descriptor or calls v_main_loop(). If no loop serves a window, a hint appears on
 * standard error.
 */
int v_fd(void);

/**
 * Returns the milliseconds after which v_dispatch() has something to do even without
 * input, and v_fd() becomes readable; -1: no limit.
 */
int v_timeout(void);

/**
 * Does all pending work for the windows without waiting; callbacks run inside it.
 * Returns the number of open windows; if one was destroyed, or its X server went
 * away, v_last_error() returns the reason. Inside a callback it serves only windows
 * whose callbacks are not running.
 */
int v_dispatch(void);

/**
 * Serves the windows until the last one is closed. Returns at once without windows.
 * V_ERR_BUSY (inside a callback), V_ERR_DISPLAY (a window was destroyed or its X
 * server went away; after all have closed), V_ERR_LIMIT (no descriptors).
 */
int v_main_loop(void);

/**
 * Lets an XtAppContext run by this thread serve its windows; needed only for one
 * created after a window was opened.
 * V_ERR_ARGUMENT (no Xt, or no such context).
 */
int v_set_app_context(void *app_context);


/* ---- The interface of 1994 --------------------------------------------------- */
/* Unchanged since. */

/**
 * Opens an editor window and returns at once. Each call opens another, independent
 * window, on the display that the program's Xt opened last; without Xt, on DISPLAY.
 * A program with an Xt or Motif main loop needs nothing more; others see v_fd() and
 * v_main_loop(). Unsaved work is offered at the program's next start; for your own
 * Quit see v_editors_close().
 *
 * move_speed, orient_speed, zoom_speed, winkel_speed  poses at speed 50 for moving
 *     by 1, turning by 180 degrees, zooming from 1 to 100, rolling by 90 degrees;
 *     100 replaces one that is not finite and > 0. Those of a loaded file are
 *     ignored
 * interpol_liste  first element of the list that receives the poses, see
 *     V_KAMERAPAR, or NULL. It must outlive the window; several windows may share
 *     it. Its number is read at each hand-over: < 0 means no data (any more)
 * anzahl_objekt, objekt  points of an object to show, at which the new path looks;
 *     NULL or a number <= 0: none
 * rueck  called when the user hands over poses, with the list and its count; may be
 *     NULL. The list is unchanged until the next hand-over; if interpol_liste is
 *     NULL, until rueck returns
 * ende  called before the user closes the window; 0 keeps it open; may be NULL
 *
 * Call it from the thread that runs the event loop; rueck and ende run there, by the
 * rules of v_editor_open(). Errors, and a window that closes because its thread
 * ends, are reported in a line on standard error that begins with "vides:", and by
 * v_last_error().
 */
void v_haupt(float move_speed, float orient_speed, float zoom_speed,
             float winkel_speed, V_KAMERAPAR *interpol_liste, int anzahl_objekt,
             V_OBJEKT_LIST *objekt, void (*rueck)(V_KAMERAPAR *daten, int anzahl),
             int (*ende)(void));

/**
 * Frees all elements of a list except the first, which is yours, and sets its number
 * to -1 (no data). A list that VIDES did not make, or whose links and numbers were
 * changed, stays unchanged; v_last_error() returns the reason. NULL and lists with
 * number < 0 are ignored. No other thread may use the list meanwhile.
 */
void v_free_liste(V_KAMERAPAR *first);


/* ---- Toolbox ----------------------------------------------------------------- */
/* Formulas without a path. */

/**
 * Gets the spherical linear interpolation from a (t = 0) to b (t = 1) by the shorter
 * arc, at any finite t.
 *
 * Quaternions are w, x, y, z, not zero; they are normalized. The identity is a
 * camera that looks along (0, 0, 1) with (0, 1, 0) up. Results may be the same
 * arrays as arguments.
 */
int v_quat_slerp(const double a[4], const double b[4], double t, double q[4]);

/**
 * Gets the quaternion of a camera that looks along vpn with vup up, of any length
 * but 0, not parallel.
 */
int v_quat_from_view(const double vpn[3], const double vup[3], double q[4]);

/** Gets the view direction and up vector of a quaternion. */
int v_view_from_quat(const double q[4], double vpn[3], double vup[3]);

/**
 * Gets the quaternion at the time when on a smooth curve through orientations (Barry
 * and Goldman 1988), whose ends are made by reflection.
 *
 * keys  count quaternions, four doubles each
 * key_times  the time of each key, strictly increasing
 * count  at least 2
 * when  from the first time to the last
 */
int v_quat_spline(const double *keys, const double *key_times, int count,
                  double when, double q[4]);

/**
 * Like v_quat_spline(), on a cubic spherical curve. tcb has tension, continuity and
 * bias of each key, from -1 to 1; NULL: all zero.
 */
int v_quat_tcb_spline(const double *keys, const double *key_times,
                      const double *tcb, int count, double when, double q[4]);

/**
 * Gets, at u from 0 to 1, the speed and the fraction of the distance on the speed
 * curve of a section: ten speeds from 1 to 100 at u = 0, 1/9, ... 1, smoothly
 * joined, never leaving 1 to 100. (On a path, where the adjacent speed equals that
 * of the section, the acceleration is joined, too.)
 *
 * before, after  the adjacent speed of the section before and after; NULL: no
 *     section
 */
int v_speed_curve(const double speed[10], const double *before, const double *after,
                  double u, double *speed_at_u, double *distance_fraction);

/**
 * Gets distance and speed of an ease at t, from 0 to 1: the fraction of the distance
 * covered, 0 to 1, and its derivative.
 *
 * kind  V_EASE_...
 * rise, fall  fractions of the time for speeding up and slowing down, not negative,
 *     together at most 1
 */
int v_ease(int kind, double rise, double fall, double t, double *distance,
           double *speed);

/**
 * Gets the matrix from world coordinates to the canonical volume of a view: 16
 * numbers, row by row, for column vectors. In a parallel projection, x and y are then
 * from -1 to 1, z 0 in the front plane and -1 in the back plane; in a perspective
 * projection, |x| and |y| at most z, and z 1 in the back plane.
 * V_ERR_ARGUMENT (up parallel to normal), V_ERR_RANGE (prp not in front of the front
 * plane, back plane not behind it, empty window).
 */
int v_view_matrix(const V_VIEW *view, double m[16]);

/**
 * Gets the perspective view of a camera in a pose. aspect is the picture's width
 * divided by its height; 0 < front < back are the planes' distances from the camera.
 */
int v_view_from_pose(const V_POSE *pose, double aspect, double front, double back,
                     V_VIEW *view);

/**
 * Returns the vertical field of view, in degrees, of a lens of zoom mm and a picture
 * height mm high: 2 atan (height / (2 zoom)). For the zoom of a V_POSE, height is
 * 24. NaN, with the reason in v_last_error(), unless both are finite and > 0.
 */
double v_fov_from_zoom(double zoom, double height);

/**
 * Returns the focal length in mm that gives a picture height mm high the vertical
 * field of view fov, in degrees: the inverse of v_fov_from_zoom(). NaN, with the
 * reason in v_last_error(), unless height is finite and > 0 and fov between 0 and
 * 180, both excluded.
 */
double v_zoom_from_fov(double fov, double height);

/**
 * Gets the matrix of a camera: 16 numbers, column by column, for column vectors.
 *
 * convention  the camera's axes, V_AXES_...
 * to_world  0: world to camera (the view matrix), with V_AXES_OPENGL that of
 *     gluLookAt(), for glLoadMatrixd(). Otherwise camera to world: the columns are the
 *     axes and vrp
 */
int v_pose_matrix(const V_POSE *pose, int convention, int to_world, double m[16]);

/**
 * Gets the pose of a camera from its matrix, the inverse of v_pose_matrix(). For a
 * matrix of glGetDoublev(GL_MODELVIEW_MATRIX), read before the object's own
 * transformations, use V_AXES_OPENGL and to_world 0. A scale common to all axes is
 * removed, and the axes are made perpendicular.
 *
 * m  its last row is 0, 0, 0, 1
 * zoom  of the pose, finite and > 0; from a vertical angle: v_zoom_from_fov(angle,
 *     24)
 * V_ERR_ARGUMENT (a matrix that mirrors, shears, projects or is not finite).
 */
int v_pose_from_matrix(const double m[16], int convention, int to_world,
                       double zoom, V_POSE *pose);

/**
 * Gets the orientation of a camera as three angles. At 0, 0, 0 the camera's axes lie
 * along the world's. It is turned about the fixed axes of the world in the order of
 * the letters: V_ORDER_XYZ is Rz Ry Rx for column vectors. Positive angles are
 * counter-clockwise, seen against the axis. With V_AXES_VIDES and V_ORDER_ZXY they
 * are pitch (positive looks down), yaw and roll in a world with y up.
 *
 * convention  V_AXES_...; Blender and glTF use V_AXES_OPENGL
 * order  V_ORDER_...
 * angles  degrees about x, y and z. The second turn is within -90 to 90, the others
 *     within -180 to 180. If it is 90 or -90, the others turn about the same axis and
 *     share its angle
 */
int v_pose_to_euler(const V_POSE *pose, int convention, int order,
                    double angles[3]);

/**
 * Gets the pose of a camera at position vrp, turned by three angles: the inverse of
 * v_pose_to_euler(). Any finite angles are valid; zoom is finite and > 0.
 */
int v_pose_from_euler(const double vrp[3], const double angles[3], int convention,
                      int order, double zoom, V_POSE *pose);

/**
 * Gets the projection matrix of a camera, for its zoom, to be applied after the view
 * matrix of V_AXES_OPENGL: 16 numbers, column by column, for column vectors (row by
 * row for row vectors, as Direct3D uses them).
 *
 * aspect  width of the picture divided by its height
 * near_plane  distance of the front plane, > 0
 * far_plane  distance of the back plane, > near_plane; INFINITY: no back plane
 * convention  V_CLIP_..., optionally | V_CLIP_REVERSED
 */
int v_pose_projection(const V_POSE *pose, double aspect, double near_plane,
                      double far_plane, int convention, double m[16]);

#ifdef __cplusplus
}
#endif

/* ---- Structs that begin with size -------------------------------------------- */

/* Tells the library which fields the program knows. */
#define v_editor_options_init(options) \
    v_editor_options_init_sized(options, sizeof(V_EDITOR_OPTIONS))

#endif  /* LIBVIDES_H */
