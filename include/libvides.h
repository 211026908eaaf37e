/*
 * libvides: camera paths through space
 *
 * A path leads through a few support points. Each has one or more orientations
 * of the camera; the library makes every pose in between. Link with
 * -lvides -lm. This file is made by cbindgen from the library's source.
 *
 * What holds for all functions:
 *
 * - Those that return int return a status, V_OK (0) if all went well. What was
 *   wrong is then told by v_last_error(). Each comment names the statuses that
 *   its function may return; V_ERR_INTERNAL may come from any.
 * - Results are written through pointers, and only if all went well.
 * - A pointer must not be NULL where the comment does not say that it may; it
 *   gives V_ERR_NULL. The library keeps no pointer that it is given, but those
 *   of v_haupt() and the callbacks and user of v_editor_open() and
 *   v_register_interpolation().
 * - Whoever makes a path or a scene or opens an editor window frees it. Nothing else that
 *   the library returns needs to be freed, but the lists of the interface of
 *   1994.
 * - Every function may be called from within callbacks, and from any thread if
 *   it does not concern windows. Several threads may read and change one
 *   path or scene at once: each call sees it as it is between two others. Windows belong to
 *   the thread that opened them.
 * - The library starts no thread for its own work. One looks up the name of another
 *   machine whose display was asked for, and in a program with Xt one looks whether
 *   windows are served until that is known. They take no signal of the program's,
 *   call none of its functions, and end by themselves.
 * - An X server that goes away, or that never was there, does a program no
 *   harm: its windows are gone, v_last_error() tells, the program goes on.
 * - Points, orientations, segments, sections and presets are counted from 0,
 *   poses from 1. Angles are degrees. Right-handed, y up.
 */

#ifndef LIBVIDES_H
#define LIBVIDES_H

#include <stddef.h>


/* ---- Version of this header -------------------------------------------------- */

/**
 * v_version() tells that of the library that runs.
 */
#define V_VERSION_MAJOR 1
#define V_VERSION_MINOR 0
#define V_VERSION_PATCH 0


/* ---- Statuses ---------------------------------------------------------------- */

/**
 * What every function that returns a status answers. v_strerror() puts each
 * into words, v_last_error() tells what was wrong in the call itself.
 *
 * V_OK            done
 * V_ERR_NULL      a pointer is NULL that must not be
 * V_ERR_HANDLE    the handle is none: freed, of another kind, or never made; or
 *                 it is a window's of another thread
 * V_ERR_ARGUMENT  a value that makes no sense: not a finite number, a target
 *                 on the camera itself, an up vector along the view, a
 *                 pointer that is not aligned for its type
 * V_ERR_RANGE     an index or a value outside its range (NaN where there is one)
 * V_ERR_SIZE      an array too small, or a struct whose size is not set
 * V_ERR_LIMIT     more points, orientations or poses than the library takes
 * V_ERR_MEMORY    out of memory; nothing was changed
 * V_ERR_IO        the operating system refused to read or write a file
 * V_ERR_FORMAT    the contents of a file are not what they should be
 * V_ERR_DISPLAY   no window can be opened, or its X server went away
 * V_ERR_BUSY      not possible at this moment, as from within this callback
 * V_ERR_CLOSED    the window is gone: its user has closed it, it was destroyed from
 *                 outside, its X server went away, or the thread that opened it has
 *                 ended; v_last_error() says which
 * V_ERR_INTERNAL  a fault of the library; the path concerned may be unusable
 *                 from now on, everything else goes on
 * V_ERR_REFUSED   a user said no
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


/* ---- Reasons of callbacks ---------------------------------------------------- */

/**
 * Why on_view and on_frame are called: another point or orientation became current, or
 * another camera is shown; something is being dragged or was changed; another frame was
 * chosen; it plays; nothing moves any more (the last of a row of the others: time for the
 * good picture).
 */
#define V_VIEW_SELECTED 0
#define V_VIEW_EDITED 1
#define V_VIEW_SCRUBBED 2
#define V_VIEW_PLAYED 3
#define V_VIEW_RESTED 4


/* ---- What stands upright ----------------------------------------------------- */

/**
 * Which axis is up.
 */
#define V_UP_Y 1
#define V_UP_Z 2


/* ---- Modes, see v_path_set_modes() ------------------------------------------- */

/**
 * V_ORIENTATION_TCB            smooth turning with limited speeds; the default
 * V_ORIENTATION_BARRY_GOLDMAN  smooth turning, the curve of Barry and Goldman
 * V_ORIENTATION_SLERP          straight from orientation to orientation
 * V_ZOOM_SMOOTH                smooth and without overshoot; the default
 * V_ZOOM_LINEAR                straight from value to value
 */
#define V_ORIENTATION_TCB 0
#define V_ORIENTATION_BARRY_GOLDMAN 1
#define V_ORIENTATION_SLERP 2
#define V_ZOOM_SMOOTH 0
#define V_ZOOM_LINEAR 1


/* ---- Kinds of easing, see v_ease() ------------------------------------------- */

/**
 * V_EASE_SINE       the speed rises and falls as a quarter of a sine
 * V_EASE_PARABOLIC  it rises and falls as a straight line
 */
#define V_EASE_SINE 0
#define V_EASE_PARABOLIC 1


/* ---- How a block is put in, see v_path_insert_path() ------------------------- */

/**
 * V_FIT_NONE   as it lies
 * V_FIT_MOVE   moved, so that it begins where the path is
 * V_FIT_TURN   turned too, so that it goes on in the direction of travel
 * V_FIT_SCALE  moved, turned and scaled, so that it also ends at the next point
 */
#define V_FIT_NONE 0
#define V_FIT_MOVE 1
#define V_FIT_TURN 2
#define V_FIT_SCALE 3


/* ---- Kinds of nodes, and how motions go on ----------------------------------- */

/**
 * The kinds of node.
 */
#define V_NODE_GROUP 0
#define V_NODE_OBJECT 1
#define V_NODE_LIGHT 2
#define V_NODE_CAMERA 3

/** The kinds of light. */
#define V_LIGHT_DIRECTIONAL 0
#define V_LIGHT_POINT 1
#define V_LIGHT_SPOT 2

/**
 * How a motion goes on when it is over: its end stays; all over again (the
 * period is the last frame less the first, at the seam the last value counts);
 * back and forth; all over again from where it ended.
 *
 * A path does the same before it begins. A track holds its first value there,
 * unless one of V_BEFORE_... is added: V_AFTER_REPEAT | V_BEFORE_PINGPONG.
 */
#define V_AFTER_HOLD 0
#define V_AFTER_REPEAT 1
#define V_AFTER_PINGPONG 2
#define V_AFTER_OFFSET 3
#define V_BEFORE_REPEAT 16
#define V_BEFORE_PINGPONG 32
#define V_BEFORE_OFFSET 48

/**
 * What a node keeps that gets another parent, see v_scene_set_parent().
 */
#define V_KEEP_PLACE 0
#define V_KEEP_NUMBERS 1

/**
 * By what v_path_keep_in_picture() keeps an object in the picture: the zoom, moving the
 * camera along its view, turning the camera.
 */
#define V_PICTURE_ZOOM 0
#define V_PICTURE_DISTANCE 1
#define V_PICTURE_VIEW 2


/* ---- Axes of a camera, see v_pose_matrix() ----------------------------------- */

/**
 * All are right-handed.
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


/* ---- Clip coordinates, see v_pose_projection() ------------------------------- */

/**
 * V_CLIP_OPENGL    y up, depth from -1 (near) to 1 (far)
 * V_CLIP_D3D       y up, depth from 0 to 1: Direct3D, Metal, WebGPU
 * V_CLIP_VULKAN    y down, depth from 0 to 1
 * V_CLIP_REVERSED  added to one of them: near and far change places, so that depth
 *                  in float stays exact far away (with depth from 0)
 */
#define V_CLIP_OPENGL 0
#define V_CLIP_D3D 1
#define V_CLIP_VULKAN 2
#define V_CLIP_REVERSED 16


/* ---- The types of the interface of 1994 -------------------------------------- */

/**
 * A point or a vector in the movement space, the cube from -1 to 1 in x, y
 * and z: right-handed, y up.
 */
struct v_punkt {
    float x;
    float y;
    float z;
};

typedef struct v_punkt V_PUNKT;

/** The same type under the name that the other structs use. */
typedef V_PUNKT V_POS;

/**
 * One camera pose in a list of them, and the whole list by its first element.
 *
 * The first element is the host's; it must outlive the list. Before the first
 * hand-over the host sets its number to -1: no data yet, and prev and next
 * mean nothing. VIDES makes the other elements with malloc(), one each, so
 * that the host may free() them; v_free_liste() does that, too. The next list uses
 * them again as far as it goes.
 *
 * The list is closed both ways: first->prev is the last element, whose number
 * is the count, and the last one's next is the first. A list of one element
 * points to itself.
 */
struct interpolparameter {
    /** position of the camera (view reference point) */
    V_POS VRP;
    /** view direction, along which the camera looks; length 1 */
    V_POS VPN;
    /** up; length 1, perpendicular to VPN */
    V_POS VUP;
    /**
     * 1 to 100, rounded, and 100 for any zoom beyond; the vertical field of view
     * is 2 atan (12 / zoom)
     */
    int zoom;
    struct interpolparameter *prev;
    struct interpolparameter *next;
    /** 1, 2, 3 ... along the list; in the first element < 0: no data */
    int number;
};

typedef struct interpolparameter V_KAMERAPAR;

/** One point of the wireframe object that v_haupt() shows. */
struct v_objekt_list {
    V_POS pos;
    /** not 0: a line leads here from the point before */
    unsigned short draw;
    /** 1, 2, 3 ... in the order of the array */
    int number;
};

typedef struct v_objekt_list V_OBJEKT_LISTE;

/** The same type under its other name. */
typedef V_OBJEKT_LISTE V_OBJEKT_LIST;


/* ---- The types of the new interface ------------------------------------------ */

/**
 * A camera path, by a handle. It is no address: a handle that was freed, freed
 * twice, or never made gives V_ERR_HANDLE and does no harm. Whoever made it
 * frees it with v_path_free().
 */
typedef struct v_path V_PATH;

/**
 * How the camera looks from a support point, and how it goes on from there.
 *
 * A struct that begins with size may grow at its end in later versions. Set
 * size to sizeof the struct before any call, also where the library fills in
 * the rest; v_orientation_init() does it. A host compiled with
 * an earlier 1.x may have a shorter one; any other value is V_ERR_SIZE.
 */
struct v_orientation {
    /** sizeof (V_ORIENTATION) */
    size_t size;
    /**
     * not 0: target is a point of the world; 0: an offset from the support
     * point, of which only the direction counts
     */
    int absolute;
    /** what the camera looks at; not the support point itself */
    double target[3];
    /**
     * degrees, turns the up vector about the view direction; any finite
     * number, kept in (-180, 180]
     */
    double roll;
    /** 1 to 2000 */
    double zoom;
    /** of the turning, each -1 to 1 */
    double tension;
    double continuity;
    double bias;
    /**
     * speed curve of the section that begins here, each 1 to 100; at 50 the
     * base speeds hold
     */
    double speed[10];
    /** frames for which the camera rests here, 0 to 1000000 */
    int hold;
};

typedef struct v_orientation V_ORIENTATION;

/**
 * Points, and what connects them: with neither lines nor triangles points
 * alone.
 *
 * Set size to sizeof (V_MESH) before any call, see V_ORIENTATION.
 */
struct v_mesh {
    /** sizeof (V_MESH) */
    size_t size;
    /** three numbers a point */
    const double *xyz;
    size_t points;
    /** three bytes a point; NULL: no colours */
    const unsigned char *rgb;
    /** two indices a line; NULL: none */
    const unsigned int *lines;
    /** number of indices, even */
    size_t line_ends;
    /** three indices a triangle; NULL: none */
    const unsigned int *triangles;
    /** number of indices, a multiple of 3 */
    size_t corners;
};

typedef struct v_mesh V_MESH;

/**
 * A movement space: a cube in the host's world, see v_path_set_space().
 * v_space_init() fills in the space of a new path.
 *
 * Set size to sizeof (V_SPACE) before any call, see V_ORIENTATION.
 */
struct v_space {
    /** sizeof (V_SPACE) */
    size_t size;
    /** its centre, in the host's world */
    double centre[3];
    /** half the length of its edge, 1e-30 to 1e30 */
    double half_size;
    /** which axis is up, V_UP_Y or V_UP_Z */
    int up;
};

typedef struct v_space V_SPACE;

/** One camera pose. This layout will never change. */
struct v_pose {
    /** position of the camera */
    double vrp[3];
    /** view direction, along which the camera looks; length 1 */
    double vpn[3];
    /** up; length 1, perpendicular to vpn */
    double vup[3];
    /**
     * 1 to 2000: focal length in mm of a 36 x 24 mm camera, so that the
     * vertical field of view is 2 atan (12 / zoom); v_zoom_from_fov() converts
     * from any other
     */
    double zoom;
};

typedef struct v_pose V_POSE;

/**
 * How a camera moves at a frame, see v_path_motion(). The library fills it in.
 *
 * Set size to sizeof (V_MOTION) before any call, see V_ORIENTATION.
 */
struct v_motion {
    /** sizeof (V_MOTION) */
    size_t size;
    /** length of the way since the first frame */
    double distance;
    /** length of the way in a second */
    double speed;
    /** degrees in a second by which the camera turns, rolling included */
    double turning;
    /**
     * of the way: 1 by the radius of its circle; 0 where the camera rests or turns on
     * the spot
     */
    double curvature;
};

typedef struct v_motion V_MOTION;

/**
 * A node at rest. Its local matrix is T(position) T(pivot) R S T(-pivot), its
 * world matrix that of its parent times the local one. Lights and cameras look
 * along their own +z axis, +y up, and have pivot 0. What another kind of node
 * does not have is not looked at.
 *
 * Set size to sizeof (V_NODE) before any call, see V_ORIENTATION;
 * v_node_init() does it.
 */
struct v_node {
    /** sizeof (V_NODE) */
    size_t size;
    /** V_NODE_GROUP, V_NODE_OBJECT, V_NODE_LIGHT or V_NODE_CAMERA */
    int kind;
    /** the node that it is in; -1: none */
    int parent;
    /** 0 hides it and all that is in it */
    int visible;
    /** lights and cameras: the node to whose pivot it looks; -1: none */
    int aim;
    /** the point that stays when the node turns and scales */
    double pivot[3];
    double position[3];
    /** w x y z, of any length but 0 */
    double rotation[4];
    double scale[3];
    /** cameras: 1 to 2000, see V_POSE */
    double zoom;
    /** cameras: degrees, turns up about the view */
    double roll;
    /** lights: V_LIGHT_DIRECTIONAL, V_LIGHT_POINT or V_LIGHT_SPOT */
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


/* ---- Scenes ------------------------------------------------------------------ */

/**
 * Everything that moves on one timeline, by a handle (see V_PATH): a tree of
 * nodes. Whoever made it frees it with v_scene_free(). Nodes are numbered from 0.
 *
 * Within a function of v_register_interpolation() those that take a V_SCENE, but
 * v_scene_free(), answer V_ERR_BUSY.
 */
typedef struct v_scene V_SCENE;

/**
 * Computes the value of a channel at a frame between its first and its last key:
 * frames of the keys, their values key by key, width numbers each. Writes width
 * numbers to value and returns V_OK; any other answer, or a number that is not
 * finite, and the channel steps from key to key.
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
    /** from the node's coordinates into the world's, column by column */
    double matrix[16];
    /** cameras and lights; of others all 0 */
    V_POSE pose;
    /** lights and objects */
    double colour[3];
    /** lights */
    double intensity;
    /** lights: half angles in degrees, inner and outer */
    double cone[2];
    /** 1 if it and all that it is in is to be seen, else 0 */
    int visible;
};

typedef struct v_node_state V_NODE_STATE;

/** Something that v_path_check() found. It does not grow. */
struct v_finding {
    /** its kind, see v_path_check(); the text is the library's and stays */
    const char *kind;
    /** poses counted from 1, where it begins */
    double first_frame;
    /** and where it ends */
    double last_frame;
    /** the support point at which the section begins */
    int point;
    /** the orientation of that point with which it begins */
    int orientation;
    /** the worst value */
    double value;
    /** the limit of its kind */
    double limit;
};

typedef struct v_finding V_FINDING;

/**
 * Limits of a pace, 0: none. Lengths count in half sizes of the space, as in
 * v_path_check(). v_limits_init() fills in those that a check has unless told.
 *
 * Set size to sizeof (V_LIMITS) before any call, see V_ORIENTATION.
 */
struct v_limits {
    /** sizeof (V_LIMITS) */
    size_t size;
    /** half sizes a second */
    double speed;
    /** half sizes a second squared, in any direction */
    double acceleration;
    /** half sizes a second cubed, the third difference at whole frames */
    double jerk;
    /** degrees a second */
    double turning;
    /** degrees a second squared */
    double turning_acceleration;
    /** mm a second */
    double zoom;
    /**
     * least seconds in which what is in the middle of the picture would cross it
     */
    double crossing;
};

typedef struct v_limits V_LIMITS;

/**
 * What a tour shows an object with, see v_path_tour(). v_tour_init() fills in what is
 * usual.
 *
 * Set size to sizeof (V_TOUR) before any call, see V_ORIENTATION.
 */
struct v_tour {
    /** sizeof (V_TOUR) */
    size_t size;
    /** how long the flight takes, > 0 */
    double seconds;
    /**
     * the share, by area, that is shown of the surface that can be seen: > 0, at most 1
     */
    double coverage;
    /** how far the camera is from what it shows; 0: found */
    double distance;
    /** not 0: in the object's free space, not around it */
    int inside;
    /** not 0: it begins at start; else it is a closed round */
    int has_start;
    /** where it begins */
    double start[3];
    /** which axis is up, V_UP_Y or V_UP_Z */
    int up;
};

typedef struct v_tour V_TOUR;


/* ---- Editor windows ---------------------------------------------------------- */

/**
 * An editor window, by a handle (see V_PATH). It belongs to the thread that
 * opened it: from any other its functions answer V_ERR_HANDLE. Whoever opened
 * it frees it with v_editor_close(), also after the user has closed it.
 */
typedef struct v_editor V_EDITOR;

/**
 * How an editor window is opened. v_editor_options_init() fills in defaults;
 * what is pointed to need not live longer than the call of v_editor_open(),
 * but for user.
 *
 * Set size to sizeof (V_EDITOR_OPTIONS) before any call, see V_ORIENTATION.
 */
struct v_editor_options {
    /** sizeof (V_EDITOR_OPTIONS) */
    size_t size;
    /**
     * what follows "VIDES" in the title, UTF-8, one line; NULL: the file's
     * name
     */
    const char *title;
    /**
     * a .vid file to start with, and to be saved to; one that does not exist
     * yet is a new path of that name; NULL: none
     */
    const char *file;
    /**
     * a path to start with, copied; NULL: a new one, or that of file. Not
     * both
     */
    const V_PATH *path;
    /** an object to be shown, copied; NULL: that of the path */
    const V_MESH *object;
    /**
     * frames for a way of one half size and so on, see v_path_set_base_frames().
     * All 0: those of the path. Else they are the host's: the window keeps them and
     * ignores a loaded file's
     */
    double move_frames;
    double turn_frames;
    double zoom_frames;
    double roll_frames;
    /** name of the X display; NULL: the environment's DISPLAY */
    const char *display;
    /**
     * "de" or "en"; NULL: the environment's, by LC_ALL, LC_MESSAGES, LANG.
     * A language that the user has chosen in the setup counts before both
     */
    const char *language;
    /**
     * called when the user hands over the poses; they are the library's and
     * valid until it returns. Of a scene they are those of the camera that is shown,
     * one for each frame of v_scene_frame_range(). NULL: nothing can be handed over
     */
    void (*on_poses)(V_EDITOR *editor, const V_POSE *poses, size_t count, void *user);
    /**
     * called before the user closes the window; 0 keeps it open. NULL: it
     * closes
     */
    int (*on_close)(V_EDITOR *editor, void *user);
    /** the host's, handed on to the callbacks */
    void *user;
    /**
     * the movement space in the host's world: its centre, half of its edge, and
     * which axis is up, V_UP_Y or V_UP_Z; of a scene in file, too. Half size 0: that of
     * file or path, and V_UP_Z makes z upright in a new path
     */
    double space_centre[3];
    double space_half_size;
    int space_up;
    /**
     * called with the camera at the playhead whenever that has changed, whether or
     * not the window is seen (it may be covered, iconified, on another desktop, or in
     * a parent that is not shown): sixty times a second at most, what came meanwhile
     * is one call. frame counts from 1. reason is one of V_VIEW_.... The pose is the
     * library's and valid until it returns. After a call of more than 30 ms the next
     * one waits as long; the last pose always comes. NULL: none
     */
    void (*on_view)(V_EDITOR *editor,
                    const V_POSE *pose,
                    double frame,
                    int reason,
                    void *user);
    /**
     * called when the path in the window has changed: after each step, undo and
     * redo too, not while a drag goes on; steps of one sixtieth of a second are one
     * call. Seen or not, as on_view. NULL: none
     */
    void (*on_change)(V_EDITOR *editor, void *user);
    /**
     * "take over the view": the host fills in its own camera and returns 1; 0: it
     * has none. vpn and vup of any length but 0, not parallel. NULL: that of
     * v_editor_set_view() is taken
     */
    int (*on_capture)(V_EDITOR *editor, V_POSE *pose, void *user);
    /**
     * the camera pane opened, changed its size in pixels, or closed (window 0, sizes
     * 0). The host draws in it what the camera sees, and again at each Expose: in a
     * child of any visual that it makes there, which is kept at the pane's size, or
     * in the pane itself, which is of the screen's own visual. A pane is never
     * destroyed while the process lives. When it closes it is unmapped, a child in
     * it is put out to the root window, unmapped, and then this is called; when the
     * editor closes, after its window is gone, in v_editor_close() too. Then the
     * editor's handle may be freed already; at the end of a thread nobody is called.
     * On a server without XFIXES or SHAPE there is no pane. NULL: the editor draws
     * itself
     */
    void (*on_pane)(V_EDITOR *editor,
                    unsigned long window,
                    int width,
                    int height,
                    void *user);
    /**
     * what the window calls the host's view, UTF-8, one line; NULL: "program"
     */
    const char *host_name;
    /**
     * an X window of the display to live in, of any depth: the editor is its child
     * and fills it; 0: a top-level window. If it is destroyed, or the editor's window
     * is put out to the root, the editor is closed without asking on_close, and what
     * was unsaved is offered at the next start. V_ERR_ARGUMENT if it is no window
     */
    unsigned long parent;
    /**
     * the host's window that the editor's belongs to, above which a window manager
     * keeps it; 0: none. V_ERR_ARGUMENT if it is no window
     */
    unsigned long transient_for;
    /**
     * what the program is called: the first half of WM_CLASS, by which a desktop
     * groups its windows, and unsaved work finds back to it; UTF-8; NULL: the name of the running program
     */
    const char *application;
    /**
     * not 0: after a hand-over nothing is unsaved. So it is without a file, too,
     * and in a window of v_haupt()
     */
    int hand_over_saves;
    /**
     * for a host that draws the scene itself, by v_editor_get_scene() and
     * v_scene_evaluate(): called with the scene's frame at the playhead, and why
     * (V_VIEW_...), after that or the scene has changed; when as on_view. NULL:
     * nobody is
     */
    void (*on_frame)(V_EDITOR *editor, double frame, int reason, void *user);
};

typedef struct v_editor_options V_EDITOR_OPTIONS;

/**
 * A view as PHIGS describes it. The eye is on the side to which normal points,
 * so the view goes against it. All but vrp, normal and up is in the view's own
 * coordinates u (right), v (up), n (along normal), with the origin in vrp.
 *
 * Set size to sizeof (V_VIEW) before any call, see V_ORIENTATION.
 */
struct v_view {
    /** sizeof (V_VIEW) */
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
    /** n of the front plane, less than prp's */
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


/* ---- Errors, warnings, the version of the library ---------------------------- */

/**
 * What went wrong in the calling thread's last call of the library: one
 * sentence in English, UTF-8, "" after a success. Never NULL. Of a sentence
 * longer than 1023 bytes the middle is left out. It calls parameters as this
 * header does (path, options->title) and counts as it does: points,
 * orientations and so on from 0, which it says; frames from 1. The text belongs to the
 * library and is valid until the same thread's next call of any function but
 * this one, v_last_warning(), v_strerror() and v_version().
 * Any thread; from callbacks too.
 */
const char *v_last_error(void);

/**
 * What the calling thread's last call that can warn has to say besides its success:
 * sentences in English, UTF-8, "" if there is nothing. Functions that can warn say so.
 * Never NULL. Of a sentence too long for 1023 bytes in all the middle is left out. The
 * text belongs to the library and is valid until the same thread's next call of a
 * function that can warn.
 * Any thread; from callbacks too.
 */
const char *v_last_warning(void);

/**
 * What a status means, in English. Never NULL; the text is constant.
 * Any thread; from callbacks too.
 */
const char *v_strerror(int status);

/**
 * The version of the library that runs, as "1.0.0". Never NULL; constant.
 * Any thread; from callbacks too.
 */
const char *v_version(void);


/* ---- The interface of 1994 --------------------------------------------------- */

/**
 * Opens an editor window for a camera path and returns at once; the window
 * then works side by side with the host, in the host's own event loop. Every
 * call opens another window, independent of all others. A host with an Xt or
 * Motif main loop has nothing more to do; for any other see v_fd() and
 * v_main_loop().
 *
 * move_speed, orient_speed, zoom_speed, winkel_speed  poses at speed 50 for a
 *     way of length 1, for turning by 180 degrees, for the zoom from 1 to
 *     100, for rolling by 90 degrees; finite and > 0, else 100 is taken. They
 *     stand in this window: those of a file that is loaded are ignored
 * interpol_liste  first element of the list that takes the poses, see
 *     V_KAMERAPAR; the host's, must outlive the window; may be NULL. Its
 *     number is read anew at each hand-over: < 0 says that there are no data
 *     (any more). The same element may be given to several windows
 * anzahl_objekt, objekt  points of an object to be shown; copied during the
 *     call; NULL or a number <= 0 for none
 * rueck  called when the user hands over poses, with the list and its count;
 *     may be NULL. The list is not touched again before the next hand-over.
 *     With interpol_liste NULL its elements are VIDES's and valid until rueck
 *     returns
 * ende   called before the user closes the window; 0 keeps it open; may be
 *     NULL
 *
 * rueck and ende run on the thread that called v_haupt(), inside the host's
 * event loop, and may call any function of the library. They may come while the
 * host is in a modal dialog of its own, whose loop serves the window, too. They
 * return to their caller: no longjmp() and no exception may leave them. An exception that does
 * ends the program, after a line on standard error that names the callback.
 * What is wrong with the arguments, or that no window can be opened, is said
 * in one line on standard error, which begins "vides:", by v_last_error(), and
 * in the window if there is one. The window belongs to this thread and is
 * closed when it ends, which such a line says, too.
 * From the thread that runs the event loop; from callbacks too.
 */
void v_haupt(float move_speed,
             float orient_speed,
             float zoom_speed,
             float winkel_speed,
             V_KAMERAPAR *interpol_liste,
             int anzahl_objekt,
             V_OBJEKT_LIST *objekt,
             void (*rueck)(V_KAMERAPAR *daten, int anzahl),
             int (*ende)(void));

/**
 * Frees all elements of a list but the first, which is the host's, and sets
 * the first one's number to -1 (no data). Only a list that VIDES made and that
 * is still linked and numbered as it was made is freed: otherwise nothing is
 * changed, and v_last_error() tells. A list without data (number < 0) and NULL
 * are no error; nothing happens.
 * Any thread, if no other uses the list meanwhile; from callbacks too.
 */
void v_free_liste(V_KAMERAPAR *first);


/* ---- The host's event loop --------------------------------------------------- */

/**
 * A host with an Xt or Motif main loop needs none of these: its windows are
 * served by it, also where it asks XtAppPending() first, unless it takes
 * XtIMXEvent only. Any other host, also one with Xt under a select() of its own,
 * watches one descriptor among its own, or calls v_main_loop(). All of them
 * concern the windows that the calling thread has opened. A host that does
 * nothing of the kind finds a hint on standard error.
 *
 * The descriptor to be watched with select(), poll() or the like: when it is
 * readable, call v_dispatch(). It stays the same and open as long as the
 * thread lives, with and without windows; it is the library's: never read or
 * close it. -1 if the system gives no more descriptors; v_last_error() tells.
 * The thread that opens the windows; from callbacks too.
 */
int v_fd(void);

/**
 * Milliseconds until v_dispatch() has something to do even if nobody touches
 * a window: the longest time to wait for the descriptor; -1 if there is no
 * limit. Who waits for v_fd() alone misses nothing, since it becomes readable
 * at that time.
 * The thread that opens the windows; from callbacks too.
 */
int v_timeout(void);

/**
 * Does everything that there is to do for the windows at the moment, and
 * never waits. Callbacks run within it. How many windows are open; one that was
 * destroyed, or whose X server went away, is not among them, and v_last_error() tells.
 * From within a callback it serves all windows but those whose callbacks run.
 * The thread that opens the windows; from callbacks too.
 */
int v_dispatch(void);

/**
 * Serves the windows until the last one is closed, and sleeps in between; for
 * a host that does nothing else meanwhile. Returns at once without windows.
 * The thread that opens the windows. V_ERR_BUSY from within a callback;
 * V_ERR_DISPLAY if a window was destroyed or its X server went away, when the others
 * are closed, too; V_ERR_LIMIT without descriptors.
 */
int v_main_loop(void);

/**
 * Has the windows of this thread served by an Xt application context, an
 * XtAppContext that this thread runs. Only needed by a host that makes its
 * context after it has opened a window: v_haupt() and v_editor_open() find all
 * contexts that are there.
 * The thread that opens the windows; from callbacks too. V_ERR_NULL,
 * V_ERR_ARGUMENT (no Xt in this program, or no such context), V_ERR_LIMIT.
 */
int v_set_app_context(void *app_context);


/* ---- Paths ------------------------------------------------------------------- */

/**
 * A new path: two support points at (-0.6, 0.2, 0.8) and (0.6, 0.2, 0.8), each
 * with one orientation as v_orientation_init() makes it. *path is the
 * caller's, to be freed with v_path_free().
 * Any thread; from callbacks too. V_ERR_NULL, V_ERR_MEMORY, V_ERR_LIMIT.
 */
int v_path_new(V_PATH **path);

/**
 * An independent copy of a path. *copy is the caller's, to be freed with
 * v_path_free().
 * Any thread; from callbacks too. V_ERR_NULL, V_ERR_HANDLE, V_ERR_MEMORY,
 * V_ERR_LIMIT.
 */
int v_path_clone(const V_PATH *path, V_PATH **copy);

/**
 * Frees a path; its handle is not valid from now on. NULL is no error. A
 * handle that is not valid does no harm; v_last_error() tells. A call that
 * another thread has under way on this path ends as if it had come before.
 * Any thread; from callbacks too.
 */
void v_path_free(V_PATH *path);

/**
 * Reads a path from a .vid file; of a scene (v_scene_load()) that of the camera
 * that is shown: to save it to that file would lose the rest of the scene. file
 * is a name as open() takes it. *path is the caller's, to be freed with
 * v_path_free().
 * Any thread; from callbacks too. V_ERR_NULL, V_ERR_IO, V_ERR_FORMAT (with
 * line and reason in v_last_error()), V_ERR_ARGUMENT (that camera follows none, or
 * there is none), V_ERR_MEMORY, V_ERR_LIMIT. Memory that
 * runs out while the text itself is read or parsed ends the program.
 */
int v_path_load(const char *file, V_PATH **path);

/**
 * Reads a path from the text of a .vid file in memory, as v_path_load() does; size
 * bytes of UTF-8, a zero behind them is not needed. *path is the caller's, to be freed with v_path_free().
 * Any thread; from callbacks too. V_ERR_NULL, V_ERR_FORMAT (with line and reason
 * in v_last_error()), V_ERR_ARGUMENT (a scene without such a camera), V_ERR_MEMORY,
 * V_ERR_LIMIT. Memory that runs out while the text is parsed ends the program.
 */
int v_path_load_from_memory(const char *text,
                            size_t size,
                            V_PATH **path);

/**
 * Writes a path into a .vid file. Whatever happens, the file is afterwards
 * wholly the old or wholly the new one; when the call returns V_OK the new one
 * is on the disk. A symbolic link is followed, permissions are kept.
 * Any thread; from callbacks too. V_ERR_NULL, V_ERR_HANDLE, V_ERR_IO,
 * V_ERR_MEMORY. Memory that runs out while the file is opened or written may
 * end the program; the old file stays.
 */
int v_path_save(const V_PATH *path, const char *file);

/**
 * The text of a .vid file of a path in memory, ended by zero, as v_path_save() writes it
 * and v_path_load_from_memory() reads it; *length is its bytes without the zero. With a
 * capacity not larger than *length nothing else is written, and the answer is V_ERR_SIZE.
 * text NULL with capacity 0 only asks for *length.
 * Any thread; from callbacks too. V_ERR_NULL, V_ERR_HANDLE, V_ERR_SIZE, V_ERR_LIMIT,
 * V_ERR_MEMORY.
 */
int v_path_save_to_memory(const V_PATH *path,
                          char *text,
                          size_t capacity,
                          size_t *length);


/* ---- Support points ---------------------------------------------------------- */

/**
 * How many support points a path has; at least 2. They are counted from 0.
 * Any thread; from callbacks too. V_ERR_NULL, V_ERR_HANDLE.
 */
int v_path_point_count(const V_PATH *path, int *count);

/**
 * Inserts a support point before the one that is number at now; at = their
 * number appends. It takes all other properties from its predecessor, at 0
 * from its successor; an absolute target equal to the new position becomes
 * relative. Coordinates are finite, at most 1e9 half sizes from the centre of the space.
 * Any thread; from callbacks too. V_ERR_NULL,
 * V_ERR_HANDLE, V_ERR_ARGUMENT, V_ERR_RANGE, V_ERR_LIMIT, V_ERR_MEMORY.
 */
int v_path_insert_point(V_PATH *path,
                        int at,
                        const double xyz[3]);

/**
 * Divides the segment behind support point number segment by 1 to 10 new
 * support points on the curve, at equal arc lengths. They take all other
 * properties from the point before them.
 * Any thread; from callbacks too. V_ERR_NULL,
 * V_ERR_HANDLE, V_ERR_RANGE, V_ERR_LIMIT, V_ERR_MEMORY.
 */
int v_path_divide_segment(V_PATH *path, int segment, int points);

/**
 * Removes a support point. Two always remain.
 * Any thread; from callbacks too. V_ERR_NULL,
 * V_ERR_HANDLE, V_ERR_RANGE.
 */
int v_path_remove_point(V_PATH *path, int at);

/**
 * Moves a support point. Absolute targets stay where they are, relative ones
 * go along; a position equal to an absolute target of the point is refused.
 * Coordinates are finite, at most 1e9 half sizes from the centre of the space.
 * Any thread; from callbacks too. V_ERR_NULL,
 * V_ERR_HANDLE, V_ERR_ARGUMENT, V_ERR_RANGE.
 */
int v_path_set_position(V_PATH *path, int at, const double xyz[3]);

/**
 * Where a support point lies.
 * Any thread; from callbacks too. V_ERR_NULL, V_ERR_HANDLE, V_ERR_RANGE.
 */
int v_path_get_position(const V_PATH *path, int at, double xyz[3]);

/**
 * Gives a support point another number; those between the two places move up or down by
 * one. All that it has goes along.
 * Any thread; from callbacks too. V_ERR_NULL, V_ERR_HANDLE, V_ERR_RANGE, V_ERR_MEMORY.
 */
int v_path_move_point(V_PATH *path,
                      int from,
                      int to);

/**
 * Names a support point: UTF-8, one line of at most 256 bytes; "" is none.
 * Any thread; from callbacks too. V_ERR_NULL, V_ERR_HANDLE, V_ERR_ARGUMENT,
 * V_ERR_RANGE, V_ERR_LIMIT, V_ERR_MEMORY.
 */
int v_path_set_point_name(V_PATH *path, int at, const char *name);

/**
 * The name of a support point, "" if it has none, as v_path_get_title() gives the title.
 * Any thread; from callbacks too. V_ERR_NULL, V_ERR_HANDLE, V_ERR_RANGE, V_ERR_SIZE.
 */
int v_path_get_point_name(const V_PATH *path,
                          int at,
                          char *name,
                          size_t capacity,
                          size_t *length);


/* ---- Tension, continuity and bias of the curve ------------------------------- */

/**
 * Gives a support point its own tension, continuity and bias, each from -1
 * to 1 (Kochanek and Bartels 1984).
 * Any thread; from callbacks too. V_ERR_NULL,
 * V_ERR_HANDLE, V_ERR_RANGE.
 */
int v_path_set_tcb(V_PATH *path,
                   int at,
                   double tension,
                   double continuity,
                   double bias);

/**
 * Lets a support point follow one of the path's presets, 0 to 9.
 * Any thread; from callbacks too. V_ERR_NULL,
 * V_ERR_HANDLE, V_ERR_RANGE.
 */
int v_path_use_preset(V_PATH *path, int at, int preset);

/**
 * Tension, continuity and bias in force at a support point, and the preset
 * that it follows, -1 for its own values. Each result may be NULL.
 * Any thread; from callbacks too. V_ERR_NULL, V_ERR_HANDLE, V_ERR_RANGE.
 */
int v_path_get_tcb(const V_PATH *path, int at, double tcb[3], int *preset);

/**
 * Changes one of the path's ten presets, 0 to 9, and with it every support
 * point that follows it. Each value from -1 to 1.
 * Any thread; from callbacks too. V_ERR_NULL,
 * V_ERR_HANDLE, V_ERR_RANGE.
 */
int v_path_set_preset(V_PATH *path,
                      int preset,
                      double tension,
                      double continuity,
                      double bias);

/**
 * Tension, continuity and bias of a preset, 0 to 9.
 * Any thread; from callbacks too. V_ERR_NULL, V_ERR_HANDLE, V_ERR_RANGE.
 */
int v_path_get_preset(const V_PATH *path, int preset, double tcb[3]);


/* ---- Orientations ------------------------------------------------------------ */

/**
 * Fills in an orientation: size, looking along (0, 0, -1) (relative, target
 * (0, 0, -0.4)), roll 0, zoom 24, tension, continuity and bias 0, all speeds
 * 50, hold 0. NULL does nothing but set v_last_error().
 * Any thread; from callbacks too.
 */
void v_orientation_init(V_ORIENTATION *o);

/**
 * How many orientations a support point has, 1 to 10. They are counted from
 * 0 and taken in this order: the camera comes in the first one, turns from
 * one to the next, and leaves in the last one.
 * Any thread; from callbacks too. V_ERR_NULL, V_ERR_HANDLE, V_ERR_RANGE.
 */
int v_path_orientation_count(const V_PATH *path, int point, int *count);

/**
 * Inserts an orientation before the one that is number at now; at = their
 * number appends. o is copied; NULL copies the orientation before, at 0 the
 * one that was the first.
 * Any thread; from callbacks too. V_ERR_NULL,
 * V_ERR_HANDLE, V_ERR_ARGUMENT, V_ERR_RANGE, V_ERR_SIZE, V_ERR_LIMIT,
 * V_ERR_MEMORY.
 */
int v_path_insert_orientation(V_PATH *path,
                              int point,
                              int at,
                              const V_ORIENTATION *o);

/**
 * Removes an orientation. One always remains.
 * Any thread; from callbacks too. V_ERR_NULL,
 * V_ERR_HANDLE, V_ERR_RANGE.
 */
int v_path_remove_orientation(V_PATH *path, int point, int at);

/**
 * Changes all values of an orientation; o is copied. What an orientation may
 * have besides (ease, given distance, fixed frames, a view along the way)
 * stays.
 * Any thread; from callbacks too. V_ERR_NULL,
 * V_ERR_HANDLE, V_ERR_ARGUMENT, V_ERR_RANGE, V_ERR_SIZE.
 */
int v_path_set_orientation(V_PATH *path, int point, int at, const V_ORIENTATION *o);

/**
 * The values of an orientation. o->size must be set before, for instance by
 * v_orientation_init().
 * Any thread; from callbacks too. V_ERR_NULL, V_ERR_HANDLE, V_ERR_RANGE,
 * V_ERR_SIZE.
 */
int v_path_get_orientation(const V_PATH *path, int point, int at, V_ORIENTATION *o);

/**
 * Makes the target of an orientation absolute (not 0) or relative (0); the
 * view stays as it is.
 * Any thread; from callbacks too. V_ERR_NULL,
 * V_ERR_HANDLE, V_ERR_RANGE.
 */
int v_path_set_absolute(V_PATH *path, int point, int at, int absolute);

/**
 * Lets an orientation look along the way, and no longer at its target. A
 * section between two orientations that look equally far ahead and have the same
 * up follows its way exactly.
 *
 * distance  0: along the tangent; greater: at the place so far ahead on the
 *     curve, behind the end of which it looks on straight; less: no longer
 *     ahead, but in the direction in which it looked, as an offset. At most 1e9
 *     half sizes of the space
 * Any thread; from callbacks too. V_ERR_NULL,
 * V_ERR_HANDLE, V_ERR_ARGUMENT, V_ERR_RANGE, V_ERR_MEMORY.
 */
int v_path_set_ahead(V_PATH *path, int point, int at, double distance);

/**
 * How far along the way an orientation looks ahead, see v_path_set_ahead(); -1 where it
 * looks at its target.
 * Any thread; from callbacks too. V_ERR_NULL, V_ERR_HANDLE, V_ERR_RANGE.
 */
int v_path_get_ahead(const V_PATH *path,
                     int point,
                     int at,
                     double *distance);

/**
 * Which way is up for an orientation, before its roll; with any view. A section
 * between two orientations with the same view and the same up follows both
 * all the way.
 *
 * up  "axis"     the vertical of the space, as in a new path
 *     "point"    towards up_point
 *     "path"     towards the place on up_path at the same share of its length; its
 *                curve is copied, a closed one ends where it begins
 *     "minimal"  never turned about the view: it begins with the vertical and is
 *                carried on through all orientations that have it; what it misses
 *                on a closed path is spread over the length
 *     "frenet"   the normal of the curve; only for curves of kind "cubic" whose
 *                points own no tangents
 *     "y", "z"   this axis, whatever is upright
 * What an up does not need may be NULL. At most 10 different up paths, each with at
 * most 1000 points.
 * Any thread; from callbacks too. V_ERR_NULL,
 * V_ERR_HANDLE, V_ERR_ARGUMENT, V_ERR_RANGE, V_ERR_LIMIT, V_ERR_MEMORY.
 */
int v_path_set_up(V_PATH *path,
                  int point,
                  int at,
                  const char *up,
                  const double *up_point,
                  const V_PATH *up_path);

/**
 * Which way is up for an orientation, as v_path_set_up() takes it: the name, whose text
 * is the library's and stays; up_point, of "point" (else zeros); and *up_path, of "path"
 * (else NULL), an open path with that curve, the caller's, to be freed with
 * v_path_free(). Each result may be NULL.
 * Any thread; from callbacks too. V_ERR_NULL, V_ERR_HANDLE, V_ERR_RANGE,
 * V_ERR_LIMIT, V_ERR_MEMORY.
 */
int v_path_get_up(const V_PATH *path,
                  int point,
                  int at,
                  const char **up,
                  double up_point[3],
                  V_PATH **up_path);


/* ---- What holds for the whole path ------------------------------------------- */

/**
 * Sets how many poses a path has at speed 50, each finite and > 0: for a way of
 * one half size of its space (move), for turning by 180 degrees (turn), for the
 * zoom from 1 to 100 (zoom), for rolling by 90 degrees (roll). v_haupt() calls
 * them its speeds.
 * Any thread; from callbacks too. V_ERR_NULL, V_ERR_HANDLE, V_ERR_ARGUMENT.
 */
int v_path_set_base_frames(V_PATH *path,
                           double move_frames,
                           double turn_frames,
                           double zoom_frames,
                           double roll_frames);

/**
 * The frames of v_path_set_base_frames(). Each result may be NULL.
 * Any thread; from callbacks too. V_ERR_NULL, V_ERR_HANDLE.
 */
int v_path_get_base_frames(const V_PATH *path,
                           double *move_frames,
                           double *turn_frames,
                           double *zoom_frames,
                           double *roll_frames);

/**
 * Joins the last support point to the first by one more segment (not 0), or
 * opens the path (0).
 * Any thread; from callbacks too. V_ERR_NULL,
 * V_ERR_HANDLE.
 */
int v_path_set_closed(V_PATH *path, int closed);

/**
 * Whether a path is closed: 1 or 0.
 * Any thread; from callbacks too. V_ERR_NULL, V_ERR_HANDLE.
 */
int v_path_get_closed(const V_PATH *path, int *closed);

/**
 * Sets how the camera turns between its orientations (V_ORIENTATION_TCB,
 * V_ORIENTATION_BARRY_GOLDMAN, V_ORIENTATION_SLERP) and how the zoom runs
 * (V_ZOOM_SMOOTH, V_ZOOM_LINEAR).
 * Any thread; from callbacks too. V_ERR_NULL,
 * V_ERR_HANDLE, V_ERR_RANGE.
 */
int v_path_set_modes(V_PATH *path, int orientation_mode, int zoom_mode);

/**
 * The modes, see v_path_set_modes(). Each result may be NULL.
 * Any thread; from callbacks too. V_ERR_NULL, V_ERR_HANDLE.
 */
int v_path_get_modes(const V_PATH *path, int *orientation_mode, int *zoom_mode);

/**
 * Sets what a path is called: UTF-8, one line of at most 256 bytes; "" is none.
 * Any thread; from callbacks too. V_ERR_NULL, V_ERR_HANDLE, V_ERR_ARGUMENT,
 * V_ERR_LIMIT, V_ERR_MEMORY.
 */
int v_path_set_title(V_PATH *path, const char *title);

/**
 * What a path is called, ended by zero; *length is its bytes without the zero.
 * With a capacity not larger than *length nothing else is written, and the answer
 * is V_ERR_SIZE. title NULL with capacity 0 only asks for *length.
 * Any thread; from callbacks too. V_ERR_NULL, V_ERR_HANDLE, V_ERR_SIZE.
 */
int v_path_get_title(const V_PATH *path,
                     char *title,
                     size_t capacity,
                     size_t *length);

/**
 * Sets the comment of a path: UTF-8, any lines; "" is none.
 * Any thread; from callbacks too. V_ERR_NULL, V_ERR_HANDLE, V_ERR_ARGUMENT,
 * V_ERR_LIMIT, V_ERR_MEMORY.
 */
int v_path_set_comment(V_PATH *path, const char *comment);

/**
 * The comment of a path, as v_path_get_title() gives the title.
 * Any thread; from callbacks too. V_ERR_NULL, V_ERR_HANDLE, V_ERR_SIZE.
 */
int v_path_get_comment(const V_PATH *path,
                       char *comment,
                       size_t capacity,
                       size_t *length);

/**
 * Sets how many poses are shown in a second, > 0 and at most 100000; it changes no
 * pose. A new path has 25.
 * Any thread; from callbacks too. V_ERR_NULL, V_ERR_HANDLE, V_ERR_RANGE.
 */
int v_path_set_fps(V_PATH *path, double fps);

/**
 * How many poses are shown in a second.
 * Any thread; from callbacks too. V_ERR_NULL, V_ERR_HANDLE.
 */
int v_path_get_fps(const V_PATH *path, double *fps);

/**
 * Sets the number that the first pose has in the user's film; a new path has 1.
 * Files written in other formats count from it; the library itself counts poses
 * from 1.
 * Any thread; from callbacks too. V_ERR_NULL, V_ERR_HANDLE.
 */
int v_path_set_first_frame(V_PATH *path, int number);

/**
 * The number that the first pose has in the user's film.
 * Any thread; from callbacks too. V_ERR_NULL, V_ERR_HANDLE.
 */
int v_path_get_first_frame(const V_PATH *path, int *number);

/**
 * Sets the object that is shown with a path, copied; NULL: none. Its lines and the
 * edges of its triangles are drawn (of more than 1,000,000 points of lines those at
 * which it ends or bends), its triangles are there for v_path_check().
 * Any thread; from callbacks too. V_ERR_NULL (path), V_ERR_SIZE, V_ERR_HANDLE,
 * V_ERR_ARGUMENT, V_ERR_RANGE, V_ERR_LIMIT, V_ERR_MEMORY.
 */
int v_path_set_object(V_PATH *path, const V_MESH *object);

/**
 * The object that is shown with a path, with its triangles if it has any; no points if
 * there is none. What the mesh points to is the library's, and valid until the same
 * thread's next call of this function, or its end. mesh->size must be set before.
 * Any thread; from callbacks too. V_ERR_NULL, V_ERR_HANDLE, V_ERR_SIZE, V_ERR_MEMORY.
 */
int v_path_get_object(const V_PATH *path,
                      V_MESH *mesh);


/* ---- Properties by name ------------------------------------------------------ */

/**
 * Sets a property of a path by its name, as `vides set` does: "closed", "fps",
 * "point.2.position", "point.2.zoom" (of its first orientation),
 * "point.2.view.3.zoom" and so on; the names are those of the keys in .vid files
 * (docs/files.md), with points and orientations counted from 1. value is written as
 * there, "30" or "[0, 1, 2]"; a text needs no quotes, and "" gives back what a new
 * path has. One step, wholly or not at all.
 * Any thread; from callbacks too. V_ERR_NULL, V_ERR_HANDLE, V_ERR_RANGE (no such
 * property, point or orientation), V_ERR_ARGUMENT (no value for it; the message has its
 * name), V_ERR_LIMIT, V_ERR_MEMORY. Memory that runs out while the value itself is
 * parsed ends the program.
 */
int v_path_set_property(V_PATH *path,
                        const char *name,
                        const char *value);

/**
 * The value of a property as it stands in a .vid file, "" if it has none; see
 * v_path_set_property(). value, capacity and *length are as those of
 * v_path_get_title().
 * Any thread; from callbacks too. V_ERR_NULL, V_ERR_HANDLE, V_ERR_SIZE, V_ERR_ARGUMENT,
 * V_ERR_RANGE (no such property), V_ERR_MEMORY.
 */
int v_path_get_property(const V_PATH *path,
                        const char *name,
                        char *value,
                        size_t capacity,
                        size_t *length);


/* ---- Where a path lies ------------------------------------------------------- */

/**
 * The movement space is a cube in the host's world: its centre, half the length of
 * its edge, and the axis that stands upright (V_UP_Y, V_UP_Z). All places,
 * offsets, tangents and lengths of a path are the world's own numbers; only base
 * frames count ways in half sizes, and so do the distances below which nothing
 * moves, so that they mean the same in metres and in angstroms. A new path has
 * (0, 0, 0), 1 and V_UP_Y.
 *
 * Sets the space; the path's numbers stay what they are. The half size is from
 * 1e-30 to 1e30; centre, points and targets may be up to 1e9 half sizes away.
 * Any thread; from callbacks too. V_ERR_NULL, V_ERR_HANDLE, V_ERR_ARGUMENT (a
 * number that is not finite), V_ERR_RANGE.
 */
int v_path_set_space(V_PATH *path,
                     const double centre[3],
                     double half_size,
                     int up);

/**
 * The space of a path. Each result may be NULL.
 * Any thread; from callbacks too. V_ERR_NULL, V_ERR_HANDLE.
 */
int v_path_get_space(const V_PATH *path,
                     double centre[3],
                     double *half_size,
                     int *up);

/**
 * Fills in a space: size, centre (0, 0, 0), half size 1, V_UP_Y. NULL does nothing but
 * set v_last_error(). In C a macro of this name hands the struct's size on to
 * v_space_init_sized(); the function itself, for other languages, fills in the struct
 * of version 1.0.
 * Any thread; from callbacks too.
 */
void v_space_init(V_SPACE *space);

/**
 * As v_space_init(), for a struct that is size bytes long. One shorter than in version
 * 1.0 stays as it is, and v_last_error() says so. What is behind the fields that the
 * library knows is not touched, and size is set to what was filled in.
 * Any thread; from callbacks too.
 */
void v_space_init_sized(V_SPACE *space,
                        size_t size);

/**
 * As v_path_new(), with the path lying in a space as v_path_new()'s lies in its own: as
 * in a new window that is given this space. space may be NULL: as v_path_new(). *path
 * is the caller's, to be freed with v_path_free().
 * Any thread; from callbacks too. V_ERR_NULL, V_ERR_SIZE, V_ERR_ARGUMENT (a number
 * that is not finite), V_ERR_RANGE, V_ERR_MEMORY, V_ERR_LIMIT.
 */
int v_path_new_in_space(const V_SPACE *space,
                        V_PATH **path);

/**
 * Makes another axis stand upright (V_UP_Y, V_UP_Z) and turns nothing that one sees:
 * each pose stays, between frames, too. Rolls are measured against the new axis.
 * Where views track a target or look along the way, their ups become "y" or "z",
 * the axis that was upright (v_path_set_up()); ups "y" or "z" that are upright now
 * become "axis".
 * Any thread; from callbacks too. V_ERR_NULL, V_ERR_HANDLE, V_ERR_RANGE,
 * V_ERR_MEMORY.
 */
int v_path_change_up(V_PATH *path,
                     int up);

/**
 * How an orientation must be to look as a camera does in a pose, such as the
 * host's own: relative, target the pose's vpn, and its roll and zoom; all else in
 * *orientation stays, so that v_orientation_init() must have filled it in before.
 * up is the upright axis of the path that it is for (V_UP_Y, V_UP_Z). vpn and vup
 * may have any length but zero; vup need not be perpendicular to vpn, but not
 * parallel.
 * Any thread; from callbacks too. V_ERR_NULL, V_ERR_SIZE, V_ERR_ARGUMENT,
 * V_ERR_RANGE (zoom, up).
 */
int v_orientation_from_pose(const V_POSE *pose, int up, V_ORIENTATION *orientation);


/* ---- Kind of the curve, tangents --------------------------------------------- */

/**
 * Sets how the curve leads through the points: "tcb" by tension, continuity
 * and bias (Kochanek and Bartels 1984; the default), "cubic" as a cubic spline
 * with a continuous second derivative, "linear" straight. Tangents that points
 * own hold in each.
 * Any thread; from callbacks too. V_ERR_NULL,
 * V_ERR_HANDLE, V_ERR_RANGE.
 */
int v_path_set_curve(V_PATH *path, const char *kind);

/**
 * How the curve leads through the points, see v_path_set_curve(). The text is
 * the library's and stays.
 * Any thread; from callbacks too. V_ERR_NULL, V_ERR_HANDLE.
 */
int v_path_get_curve(const V_PATH *path, const char **kind);

/**
 * Gives a support point tangents of its own: the derivatives with which the
 * curve reaches it (before) and leaves it (after), a segment counting 1. Both
 * NULL: none of its own, those by the kind of the curve again. Each coordinate
 * is finite and at most 1e9 half sizes of the space.
 * Any thread; from callbacks too. V_ERR_NULL,
 * V_ERR_HANDLE, V_ERR_ARGUMENT, V_ERR_RANGE.
 */
int v_path_set_tangents(V_PATH *path,
                        int at,
                        const double before[3],
                        const double after[3]);

/**
 * The tangents with which the curve passes a support point, and whether they
 * are its own (1) or not (0). At an end of an open path both are that of the
 * one side. Setting what this gives changes no bit of the curve (of a cubic
 * spline no more than rounding). Each result may be NULL.
 * Any thread; from callbacks too. V_ERR_NULL, V_ERR_HANDLE, V_ERR_RANGE.
 */
int v_path_get_tangents(const V_PATH *path,
                        int at,
                        double before[3],
                        double after[3],
                        int *own);

/**
 * Inserts a support point on the curve where the camera is at a frame, and
 * keeps the motion: the curve, every pose and the number of frames stay. It
 * comes to lie at the nearest whole frame within the section (in a section of
 * one frame where it is asked for, and there are two then). So that nothing
 * changes, the points beside it own their tangents from then on, and
 * orientations their angular velocity, their slopes of zoom and roll, and a
 * part of the old pace.
 *
 * frame  from 1 to the number of frames, not at a key and not in a pan; the
 *     orientation mode must not be V_ORIENTATION_BARRY_GOLDMAN
 * at     the number of the new point; may be NULL
 * Any thread; from callbacks too. V_ERR_NULL,
 * V_ERR_HANDLE, V_ERR_ARGUMENT, V_ERR_RANGE, V_ERR_LIMIT, V_ERR_MEMORY.
 */
int v_path_insert_on_curve(V_PATH *path, double frame, int *at);


/* ---- Pace -------------------------------------------------------------------- */

/**
 * Speeding up, cruising and slowing down as a function.
 *
 * kind  V_EASE_SINE or V_EASE_PARABOLIC
 * rise, fall  shares of the time for speeding up and slowing down, not
 *     negative, together at most 1
 * t     from 0 to 1
 * distance  the share of the way at t, 0 to 1
 * speed     its derivative
 * Each result may be NULL.
 * Any thread; from callbacks too. V_ERR_ARGUMENT, V_ERR_RANGE.
 */
int v_ease(int kind,
           double rise,
           double fall,
           double t,
           double *distance,
           double *speed);

/**
 * Lets the section that begins with an orientation speed up, cruise and slow
 * down, in place of its ten speeds or a given distance.
 *
 * kind  V_EASE_SINE, V_EASE_PARABOLIC, or -1: the ten speeds again, the other
 *     values are not looked at
 * rise, fall  shares of the time, as in v_ease()
 * cruise  the cruising speed, 1 to 100
 * Any thread; from callbacks too. V_ERR_NULL,
 * V_ERR_HANDLE, V_ERR_ARGUMENT, V_ERR_RANGE, V_ERR_MEMORY.
 */
int v_path_set_ease(V_PATH *path,
                    int point,
                    int at,
                    int kind,
                    double rise,
                    double fall,
                    double cruise);

/**
 * How the section that begins with an orientation eases, see v_path_set_ease();
 * kind -1 and zeros where it does not. Each result may be NULL.
 * Any thread; from callbacks too. V_ERR_NULL, V_ERR_HANDLE, V_ERR_RANGE.
 */
int v_path_get_ease(const V_PATH *path,
                    int point,
                    int at,
                    int *kind,
                    double *rise,
                    double *fall,
                    double *cruise);

/**
 * Gives the section that begins with an orientation its distance as a function
 * of time, in place of its ten speeds or an ease: keys joined smoothly, without
 * going back.
 *
 * time_way  pairs (share of the time, share of the way), from 0, 0 to 1, 1, both
 *     increasing
 * keys      how many pairs, 2 to 32; 0: the ten speeds again, time_way is not
 *     looked at
 * Any thread; from callbacks too. V_ERR_NULL,
 * V_ERR_HANDLE, V_ERR_ARGUMENT, V_ERR_RANGE, V_ERR_MEMORY.
 */
int v_path_set_distance(V_PATH *path,
                        int point,
                        int at,
                        const double *time_way,
                        size_t keys);

/**
 * The given distance of the section that begins with an orientation: as many pairs as
 * *keys says, see v_path_set_distance(); 0 where none is given. capacity is the number of
 * pairs that there is room for; with too little nothing is written but *keys, and the
 * answer is V_ERR_SIZE. time_way NULL with capacity 0 only asks for *keys.
 * Any thread; from callbacks too. V_ERR_NULL, V_ERR_HANDLE, V_ERR_RANGE, V_ERR_SIZE.
 */
int v_path_get_distance(const V_PATH *path,
                        int point,
                        int at,
                        double *time_way,
                        size_t capacity,
                        size_t *keys);


/* ---- Fixed frames ------------------------------------------------------------ */

/**
 * Gives the section that begins with an orientation so many frames, whatever
 * its length; 0: by its length again. A section in which nothing changes has
 * none all the same.
 * Any thread; from callbacks too. V_ERR_NULL,
 * V_ERR_HANDLE, V_ERR_RANGE, V_ERR_MEMORY.
 */
int v_path_set_frames(V_PATH *path, int point, int at, size_t frames);

/**
 * The fixed frames of the section that begins with an orientation; 0: by length.
 * Any thread; from callbacks too. V_ERR_NULL, V_ERR_HANDLE, V_ERR_RANGE.
 */
int v_path_get_frames(const V_PATH *path, int point, int at, size_t *frames);

/**
 * Whether the section that begins with an orientation keeps its frames where
 * v_path_fit_frames() brings a whole to a number of frames; 0: no.
 * Any thread; from callbacks too. V_ERR_NULL, V_ERR_HANDLE, V_ERR_RANGE,
 * V_ERR_MEMORY.
 */
int v_path_set_frames_locked(V_PATH *path, int point, int at, int locked);

/**
 * Whether the section that begins with an orientation keeps its frames so: 0 or 1.
 * Any thread; from callbacks too. V_ERR_NULL, V_ERR_HANDLE, V_ERR_RANGE.
 */
int v_path_get_frames_locked(const V_PATH *path, int point, int at, int *locked);

/**
 * Fixes the frames of all moving sections from the first orientation of one
 * support point to the last one of another, so that from the first pose to the
 * last there are exactly frames, holds included. Each section has one, the rest
 * goes in proportion to what they had, by largest remainder, ties to the
 * earlier; locked ones keep theirs. With 0 and the last point v_path_frame_count() is then exactly
 * frames, closed paths with the way back to the first point; on a closed path
 * first_point may lie behind last_point. Too few are refused, v_last_error()
 * names the least possible number.
 * Any thread; from callbacks too. V_ERR_NULL,
 * V_ERR_HANDLE, V_ERR_RANGE, V_ERR_MEMORY.
 */
int v_path_fit_frames(V_PATH *path,
                      int first_point,
                      int last_point,
                      size_t frames);


/* ---- The curve --------------------------------------------------------------- */

/**
 * The length of the whole curve, in the units of the positions.
 * Any thread; from callbacks too. V_ERR_NULL, V_ERR_HANDLE, V_ERR_MEMORY.
 */
int v_path_length(const V_PATH *path, double *length);

/**
 * The length of one segment. Segment n leads from support point n to the next;
 * a closed path has one more, from the last to the first.
 * Any thread; from callbacks too. V_ERR_NULL, V_ERR_HANDLE, V_ERR_RANGE,
 * V_ERR_MEMORY.
 */
int v_path_segment_length(const V_PATH *path, int segment, double *length);

/**
 * The point of a segment at t from 0 to 1, the parameter of the spline itself
 * (not of the length).
 * Any thread; from callbacks too. V_ERR_NULL, V_ERR_HANDLE, V_ERR_ARGUMENT,
 * V_ERR_RANGE, V_ERR_MEMORY.
 */
int v_path_curve_point(const V_PATH *path, int segment, double t, double xyz[3]);

/**
 * The point of a segment at the length s from its start, 0 to the segment's
 * length.
 * Any thread; from callbacks too. V_ERR_NULL, V_ERR_HANDLE, V_ERR_ARGUMENT,
 * V_ERR_RANGE, V_ERR_MEMORY.
 */
int v_path_point_at_length(const V_PATH *path,
                           int segment,
                           double s,
                           double xyz[3]);


/* ---- Tools ------------------------------------------------------------------- */

/**
 * A path by a ready-made move, at 25 frames a second. Its numbers stand in the
 * order below, a place as three; those behind count have their defaults. Headings
 * are seen from the target: 0 lies towards +z, 90 towards +x. All its sections have one
 * speed.
 *
 * "orbit"  on a circle round a target
 *     around x y z (0), radius (1), height (0.4), from degrees (0), turns (1),
 *     zoom mm (24), seconds (10)
 * "spiral"  round a target with another radius and height at the end
 *     around x y z (0), radius (1), height (0.4), from degrees (0), turns (1),
 *     zoom mm (24), seconds (10), end-radius (0.5), end-height (1)
 * "arc"  on a part of a circle, from one heading to another
 *     around x y z (0), radius (1), height (0.4), from degrees (-45),
 *     to degrees (45), zoom mm (24), seconds (10)
 * "flyby"  straight past a target that stays in view
 *     around x y z (0), distance (1), height (0.4), from degrees (0),
 *     length (2), zoom mm (24), seconds (10)
 * "approach"  straight towards a target
 *     around x y z (0), distance (1), end-distance (0.4), from degrees (0),
 *     rise degrees (15), zoom mm (24), seconds (10)
 * "dolly-zoom"  towards a target that keeps its size in the picture
 *     around x y z (0), distance (1), end-distance (0.4), from degrees (0),
 *     rise degrees (15), zoom mm (60), seconds (10)
 * "crane"  straight up or down beside a target that stays in view
 *     around x y z (0), radius (1), height (-0.2), end-height (1),
 *     from degrees (0), zoom mm (24), seconds (10)
 * "pan"  turns on the spot
 *     at x y z (0), from degrees (-45), to degrees (45), tilt degrees (0),
 *     zoom mm (24), seconds (10)
 * "figure-eight"  on an eight that lies before the target
 *     around x y z (0), radius (0.7), height (0.4), width (1.2),
 *     from degrees (0), zoom mm (24), seconds (10)
 *
 * *path is the caller's, to be freed with v_path_free().
 * Any thread; from callbacks too. V_ERR_NULL, V_ERR_ARGUMENT, V_ERR_RANGE,
 * V_ERR_LIMIT, V_ERR_MEMORY.
 */
int v_path_from_move(const char *move,
                     const double *parameters,
                     size_t count,
                     V_PATH **path);

/**
 * As v_path_from_move(), in a space: where it has V_UP_Z, headings lie towards +x (0)
 * and +y (90) and heights along z. Lengths behind count have their defaults times its
 * half size, places its centre.
 *
 * space   see v_space_init(); NULL: centre (0, 0, 0), half size 1, V_UP_Y
 * *path is the caller's, to be freed with v_path_free().
 * Any thread; from callbacks too. V_ERR_NULL, V_ERR_SIZE, V_ERR_ARGUMENT,
 * V_ERR_RANGE, V_ERR_LIMIT, V_ERR_MEMORY.
 */
int v_path_from_move_in_space(const char *move,
                              const double *parameters,
                              size_t count,
                              const V_SPACE *space,
                              V_PATH **path);

/**
 * Moves, turns, scales and mirrors the support points from first_point to
 * last_point, tangents that they own with them.
 *
 * matrix  column by column, without shear; its last row is 0 0 0 1
 * with_targets  1: what their cameras see goes along, targets, views and rolls;
 *     0: absolute targets stay, relative ones keep their direction
 * Any thread; from callbacks too. V_ERR_NULL, V_ERR_HANDLE, V_ERR_ARGUMENT (shear,
 * or a point would lie on its own target), V_ERR_RANGE, V_ERR_MEMORY.
 */
int v_path_transform(V_PATH *path,
                     int first_point,
                     int last_point,
                     const double matrix[16],
                     int with_targets);

/**
 * Deforms the support points from first_point to last_point as v_deform() does,
 * tangents that they own with them.
 *
 * box    NULL: that of the points' positions
 * with_targets  1: their targets are deformed too; 0: they stay
 * Any thread; from callbacks too. V_ERR_NULL, V_ERR_HANDLE, V_ERR_ARGUMENT,
 * V_ERR_RANGE, V_ERR_LIMIT, V_ERR_MEMORY.
 */
int v_path_deform(V_PATH *path,
                  int first_point,
                  int last_point,
                  const char *kind,
                  const double *parameters,
                  size_t count,
                  const double box[6],
                  int with_targets);

/**
 * The support points from first_point to last_point as a path of their own, open,
 * with the curve that they have; on a closed path first_point may lie behind
 * last_point. *block is the caller's, to be freed with v_path_free().
 * Any thread; from callbacks too. V_ERR_NULL, V_ERR_HANDLE, V_ERR_RANGE,
 * V_ERR_MEMORY, V_ERR_LIMIT.
 */
int v_path_extract(const V_PATH *path,
                   int first_point,
                   int last_point,
                   V_PATH **block);

/**
 * Puts a path in behind support point at; block stays as it is and may be the same
 * path. Its curve stays, and all other of the path; at the join both ways have one
 * direction. But with V_FIT_NONE its first point becomes one with point at, whose
 * views stay; with V_FIT_SCALE its last one so with the next point. Its targets go
 * along. A closed block ends where it begins. Names that are there already get a
 * number.
 * Any thread; from callbacks too. V_ERR_NULL, V_ERR_HANDLE, V_ERR_ARGUMENT (no
 * direction, or no length to scale), V_ERR_RANGE, V_ERR_LIMIT, V_ERR_MEMORY.
 */
int v_path_insert_path(V_PATH *path, int at, const V_PATH *block, int fit);

/**
 * Turns the way round: the film shows the same poses in reverse order. Views along
 * the way look along the new one.
 * Any thread; from callbacks too. V_ERR_NULL, V_ERR_HANDLE, V_ERR_MEMORY.
 */
int v_path_reverse(V_PATH *path);

/**
 * The way count times, each beginning where the one before ended, its targets with
 * it; a closed path goes round so often.
 * Any thread; from callbacks too. V_ERR_NULL, V_ERR_HANDLE, V_ERR_RANGE,
 * V_ERR_LIMIT, V_ERR_MEMORY.
 */
int v_path_repeat(V_PATH *path, int count);

/**
 * The sum of paths times their weights: positions, curve, targets, roll, zoom and
 * speeds, point by point; paths with different numbers of points are resampled to
 * the largest of them by length first. Fixed frames (rounded), angular velocities
 * and slopes are blended where each path owns them. All else is that of the path
 * with the greatest weight.
 *
 * weights  count numbers with the sum 1
 * *blend is the caller's, to be freed with v_path_free().
 * Any thread; from callbacks too. V_ERR_NULL, V_ERR_HANDLE, V_ERR_ARGUMENT,
 * V_ERR_RANGE, V_ERR_LIMIT, V_ERR_MEMORY.
 */
int v_path_blend(V_PATH *const *paths,
                 const double *weights,
                 size_t count,
                 V_PATH **blend);


/* ---- Sections and poses ------------------------------------------------------ */

/**
 * How many sections a path has. A section is the way from one orientation to
 * the next, be it at the same support point or on to the next point. They are
 * counted from 0 in the order in which the camera takes them.
 * Any thread; from callbacks too. V_ERR_NULL, V_ERR_HANDLE, V_ERR_MEMORY.
 */
int v_path_section_count(const V_PATH *path, int *count);

/**
 * The support point and the orientation with which a section begins, the
 * number (from 1) of the first pose that belongs to it, and how many do; 0 if
 * nothing changes in it. Poses that rest at the section's end are not
 * counted. Each result may be NULL.
 * Any thread; from callbacks too. V_ERR_NULL, V_ERR_HANDLE, V_ERR_RANGE,
 * V_ERR_LIMIT, V_ERR_MEMORY.
 */
int v_path_section_info(const V_PATH *path,
                        int section,
                        int *point,
                        int *orientation,
                        size_t *first_frame,
                        size_t *frames);

/**
 * How many poses the whole path yields; at least 1. They are numbered from 1.
 * Any thread; from callbacks too. V_ERR_NULL, V_ERR_HANDLE, V_ERR_LIMIT,
 * V_ERR_MEMORY.
 */
int v_path_frame_count(const V_PATH *path, size_t *frames);

/**
 * All poses of a path, into the caller's array of capacity elements; *count
 * is how many. With a capacity too small nothing is written but *count, the
 * capacity needed, and the answer is V_ERR_SIZE. poses NULL with capacity 0
 * only asks for *count.
 * Any thread; from callbacks too. V_ERR_NULL, V_ERR_HANDLE, V_ERR_SIZE,
 * V_ERR_LIMIT, V_ERR_MEMORY.
 */
int v_path_sample(const V_PATH *path,
                  V_POSE *poses,
                  size_t capacity,
                  size_t *count);

/**
 * count poses from number first on, 1 to the count of v_path_frame_count(), into
 * the caller's array, each equal to that of v_path_sample(). For hosts that take a
 * long path in pieces.
 * Any thread; from callbacks too. V_ERR_NULL, V_ERR_HANDLE, V_ERR_RANGE (first 0,
 * or not so many poses from there), V_ERR_LIMIT, V_ERR_MEMORY.
 */
int v_path_sample_range(const V_PATH *path,
                        size_t first,
                        size_t count,
                        V_POSE *poses);

/**
 * The pose at one frame, 1 to the count of v_path_frame_count(); between two
 * frames also, as 1.5. At a whole frame it is that of v_path_sample(), bit for bit.
 * Any thread; from callbacks too. V_ERR_NULL, V_ERR_HANDLE, V_ERR_RANGE,
 * V_ERR_LIMIT, V_ERR_MEMORY.
 */
int v_path_pose(const V_PATH *path, double frame, V_POSE *pose);

/**
 * The poses at count frames in any order, each as v_path_pose() gives it: for motion
 * blur, sound, and pictures at the times at which they are shown.
 *
 * frames  each from 1 to the count of v_path_frame_count()
 * poses   room for count of them
 * Any thread; from callbacks too. V_ERR_NULL, V_ERR_HANDLE, V_ERR_RANGE,
 * V_ERR_LIMIT, V_ERR_MEMORY.
 */
int v_path_poses_at(const V_PATH *path,
                    const double *frames,
                    size_t count,
                    V_POSE *poses);

/**
 * All poses of a path as a list in the form of 1994, see V_KAMERAPAR: zooms are whole
 * numbers there, 100 for any beyond. first is
 * the host's and becomes the first element; its number must be set before, to
 * -1 if there are no data yet. A list that VIDES made there before is freed
 * when the new one is complete; any other list is left alone and only
 * forgotten. If the call fails, the old list stays whole.
 * Any thread, if no other uses the list meanwhile; from callbacks too.
 * V_ERR_NULL, V_ERR_HANDLE, V_ERR_LIMIT, V_ERR_MEMORY.
 */
int v_path_to_list(const V_PATH *path,
                   V_KAMERAPAR *first);

/**
 * Writes all poses of a path into a text file: one line for each, with VRP,
 * VPN, VUP (x, y and z each) and zoom as C prints them by "%3.4f", separated
 * by one space; the decimal sign is a point whatever the locale, and minus
 * zero is written as zero. The file is afterwards wholly the old or wholly the
 * new one.
 * Any thread; from callbacks too. V_ERR_NULL, V_ERR_HANDLE, V_ERR_IO,
 * V_ERR_LIMIT, V_ERR_MEMORY. Memory that runs out while the file is opened or
 * written may end the program; the old file stays.
 */
int v_path_write_ascii(const V_PATH *path, const char *file);

/**
 * The lines of v_path_write_ascii() in memory, ended by zero; *length is their
 * bytes without the zero. With a capacity not larger than *length nothing else is
 * written, and the answer is V_ERR_SIZE. text NULL with capacity 0 only asks for
 * *length.
 * Any thread; from callbacks too. V_ERR_NULL, V_ERR_HANDLE, V_ERR_SIZE,
 * V_ERR_LIMIT, V_ERR_MEMORY.
 */
int v_path_write_ascii_to_memory(const V_PATH *path,
                                 char *text,
                                 size_t capacity,
                                 size_t *length);


/* ---- Time and motion --------------------------------------------------------- */

/**
 * The frame that is shown at a time: 1 + seconds * fps (v_path_set_fps()), between two
 * frames too. The first pose is shown at 0 seconds, the last one at
 * (v_path_frame_count() - 1) / fps; other times are none of the path's. What
 * v_path_seconds_at_frame() gives for a whole frame gives that frame again.
 * Any thread; from callbacks too. V_ERR_NULL, V_ERR_HANDLE, V_ERR_RANGE,
 * V_ERR_LIMIT, V_ERR_MEMORY.
 */
int v_path_frame_at_seconds(const V_PATH *path,
                            double seconds,
                            double *frame);

/**
 * The time at which a frame is shown, between two frames too: (frame - 1) / fps, see
 * v_path_frame_at_seconds().
 *
 * frame  from 1 to the count of v_path_frame_count()
 * Any thread; from callbacks too. V_ERR_NULL, V_ERR_HANDLE, V_ERR_RANGE,
 * V_ERR_LIMIT, V_ERR_MEMORY.
 */
int v_path_seconds_at_frame(const V_PATH *path,
                            double frame,
                            double *seconds);

/**
 * How the camera moves at a frame, between two frames too: lengths in the units of the
 * positions, seconds by v_path_set_fps(). At a key it is how the camera goes on from
 * there, at the last frame how it came. motion->size must be set before.
 *
 * frame  from 1 to the count of v_path_frame_count()
 * Any thread; from callbacks too. V_ERR_NULL, V_ERR_HANDLE, V_ERR_SIZE, V_ERR_RANGE,
 * V_ERR_LIMIT, V_ERR_MEMORY.
 */
int v_path_motion(const V_PATH *path,
                  double frame,
                  V_MOTION *motion);


/* ---- Scenes: made, loaded, saved, freed -------------------------------------- */

/**
 * A node of this kind at the origin: visible, scale 1, rotation 1 0 0 0, in
 * none, aiming at none, zoom 24, white, intensity 1, a cone of 20 and 30
 * degrees, planes at 0.01 and 1000. Sets size. A kind that is none stays as it
 * is and is refused where the node is used.
 * Any thread; from callbacks too. NULL does no harm; v_last_error() tells.
 */
void v_node_init(V_NODE *node, int kind);

/**
 * A new scene: one camera, "camera", on the path of v_path_new(), from frame 1
 * on. *scene is the caller's, to be freed with v_scene_free(). For one in a space of
 * the host's world: v_scene_set_space(), then v_scene_set_path() of node 0 with a path
 * of v_path_new_in_space().
 * Any thread; from callbacks too. V_ERR_NULL, V_ERR_MEMORY, V_ERR_LIMIT.
 */
int v_scene_new(V_SCENE **scene);

/**
 * Reads a scene from a .vid file; one with a path alone is that of a camera on
 * it. file is a name as open() takes it. *scene is the caller's, to be freed
 * with v_scene_free().
 *
 * A mesh in a file of its own that is gone or broken leaves its object empty, and one
 * that has changed is taken: the answer is V_OK, and v_last_warning() tells, "" if all are
 * as they were.
 * Any thread; from callbacks too. V_ERR_NULL, V_ERR_IO, V_ERR_FORMAT (with
 * line and reason in v_last_error()), V_ERR_MEMORY, V_ERR_LIMIT. Memory that
 * runs out while the text itself is read or parsed ends the program.
 */
int v_scene_load(const char *file,
                 V_SCENE **scene);

/**
 * Reads a scene from the text of a .vid file in memory, as v_scene_load() does; size bytes
 * of UTF-8, a zero behind them is not needed. Meshes in files of their own are looked for
 * where the program runs, if the text does not name them from the root. *scene is the
 * caller's, to be freed with v_scene_free().
 * Any thread; from callbacks too. V_ERR_NULL, V_ERR_FORMAT (with line and reason in
 * v_last_error()), V_ERR_MEMORY, V_ERR_LIMIT. Memory that runs out while the text is
 * parsed ends the program.
 */
int v_scene_load_from_memory(const char *text,
                             size_t size,
                             V_SCENE **scene);

/**
 * The text of a .vid file of a scene in memory, as v_path_save_to_memory() gives that of a
 * path; names of meshes' files stay as they are.
 * Any thread; from callbacks too. V_ERR_NULL, V_ERR_HANDLE, V_ERR_SIZE, V_ERR_BUSY,
 * V_ERR_LIMIT, V_ERR_MEMORY.
 */
int v_scene_save_to_memory(const V_SCENE *scene,
                           char *text,
                           size_t capacity,
                           size_t *length);

/**
 * Writes a scene into a .vid file, as v_path_save() writes a path: afterwards
 * the file is wholly the old or wholly the new one.
 * Any thread; from callbacks too. V_ERR_NULL, V_ERR_HANDLE, V_ERR_IO,
 * V_ERR_BUSY, V_ERR_LIMIT, V_ERR_MEMORY. Memory that runs out while the file is
 * opened or written may end the program; the old file stays.
 */
int v_scene_save(const V_SCENE *scene, const char *file);

/**
 * An independent copy of a scene; geometry is shared until one of them changes
 * it. *copy is the caller's, to be freed with v_scene_free().
 * Any thread; from callbacks too. V_ERR_NULL, V_ERR_HANDLE, V_ERR_BUSY,
 * V_ERR_MEMORY, V_ERR_LIMIT.
 */
int v_scene_clone(const V_SCENE *scene, V_SCENE **copy);

/**
 * Frees a scene, see v_path_free(). NULL is no error.
 * Any thread; from callbacks too.
 */
void v_scene_free(V_SCENE *scene);


/* ---- Nodes ------------------------------------------------------------------- */

/**
 * How many nodes a scene has.
 * Any thread; from callbacks too. V_ERR_NULL, V_ERR_HANDLE, V_ERR_BUSY.
 */
int v_scene_node_count(const V_SCENE *scene, int *count);

/**
 * Adds a node behind the others; *node is its number (NULL: not wanted). name
 * is unique in its scene: UTF-8, one line, not empty.
 * Any thread; from callbacks too. V_ERR_NULL,
 * V_ERR_HANDLE, V_ERR_SIZE, V_ERR_ARGUMENT, V_ERR_RANGE, V_ERR_LIMIT,
 * V_ERR_BUSY, V_ERR_MEMORY.
 */
int v_scene_add_node(V_SCENE *scene,
                     const char *name,
                     const V_NODE *values,
                     int *node);

/**
 * Removes a node with all that is in it. The numbers behind move up; who aimed
 * at one of them aims at none. Many in a row cost no more than one: count, names
 * and nodes may be asked for in between.
 * Any thread; from callbacks too. V_ERR_NULL,
 * V_ERR_HANDLE, V_ERR_RANGE, V_ERR_BUSY, V_ERR_MEMORY.
 */
int v_scene_remove_node(V_SCENE *scene, int node);

/**
 * The number of the node with this name.
 * Any thread; from callbacks too. V_ERR_NULL, V_ERR_HANDLE, V_ERR_ARGUMENT (no
 * such node), V_ERR_BUSY.
 */
int v_scene_find_node(const V_SCENE *scene, const char *name, int *node);

/**
 * A node's name. The text belongs to the library and is valid until the same
 * thread's next call of a function that gives one of a scene.
 * Any thread; from callbacks too. V_ERR_NULL, V_ERR_HANDLE, V_ERR_RANGE,
 * V_ERR_BUSY.
 */
int v_scene_get_name(const V_SCENE *scene, int node, const char **name);

/**
 * Gives a node another name, see v_scene_add_node().
 * Any thread; from callbacks too. V_ERR_NULL,
 * V_ERR_HANDLE, V_ERR_ARGUMENT, V_ERR_RANGE, V_ERR_LIMIT, V_ERR_BUSY,
 * V_ERR_MEMORY.
 */
int v_scene_set_name(V_SCENE *scene, int node, const char *name);

/**
 * A node at rest. values->size must be set.
 * Any thread; from callbacks too. V_ERR_NULL, V_ERR_HANDLE, V_ERR_SIZE,
 * V_ERR_RANGE, V_ERR_BUSY.
 */
int v_scene_get_node(const V_SCENE *scene, int node, V_NODE *values);

/**
 * Gives a node other values; its kind stays. With another parent it stays where
 * it is in the world at the scene's first frame: position, rotation and scale
 * are taken as of the old parent. A node that moves can only be given to a
 * parent that lies as the old one does.
 * Any thread; from callbacks too. V_ERR_NULL,
 * V_ERR_HANDLE, V_ERR_SIZE, V_ERR_ARGUMENT (cycles among them), V_ERR_RANGE,
 * V_ERR_LIMIT, V_ERR_BUSY, V_ERR_MEMORY.
 */
int v_scene_set_node(V_SCENE *scene, int node, const V_NODE *values);


/* ---- What moves a node ------------------------------------------------------- */

/**
 * Gives a node a path to follow, copied; NULL: none. Its pose n is shown at the
 * scene's frame start_frame + n - 1. after: V_AFTER_HOLD, V_AFTER_REPEAT or
 * V_AFTER_PINGPONG, before the path too. A path moves position, rotation and
 * zoom, in the parent's coordinates; a node that has a track of one of them
 * takes none.
 * Any thread; from callbacks too. V_ERR_NULL,
 * V_ERR_HANDLE, V_ERR_ARGUMENT, V_ERR_RANGE, V_ERR_LIMIT, V_ERR_BUSY,
 * V_ERR_MEMORY.
 */
int v_scene_set_path(V_SCENE *scene,
                     int node,
                     const V_PATH *path,
                     double start_frame,
                     int after);

/**
 * A copy of the path that a node follows. *path is the caller's, to be freed
 * with v_path_free().
 * Any thread; from callbacks too. V_ERR_NULL, V_ERR_HANDLE, V_ERR_ARGUMENT (it
 * follows none), V_ERR_RANGE, V_ERR_LIMIT, V_ERR_BUSY, V_ERR_MEMORY.
 */
int v_scene_get_path(const V_SCENE *scene, int node, V_PATH **path);

/**
 * Sets a marker, or moves the one of this name (UTF-8, one line, not empty).
 * Any thread; from callbacks too. V_ERR_NULL,
 * V_ERR_HANDLE, V_ERR_ARGUMENT, V_ERR_RANGE, V_ERR_LIMIT, V_ERR_BUSY,
 * V_ERR_MEMORY.
 */
int v_scene_set_marker(V_SCENE *scene, const char *name, double frame);

/**
 * Pins a support point of a node's path to a marker; NULL frees it. Pins are
 * kept and saved.
 * Any thread; from callbacks too. V_ERR_NULL,
 * V_ERR_HANDLE, V_ERR_ARGUMENT, V_ERR_RANGE, V_ERR_LIMIT, V_ERR_BUSY,
 * V_ERR_MEMORY.
 */
int v_scene_pin(V_SCENE *scene, int node, int point, const char *marker);

/**
 * Sets the space of a scene, as v_path_set_space() that of a path: up is what stands
 * upright for nodes that aim at others. The numbers of its nodes stay what they are; a
 * path in it has a space of its own.
 * Any thread; from callbacks too. V_ERR_NULL, V_ERR_HANDLE, V_ERR_BUSY,
 * V_ERR_ARGUMENT (a number that is not finite), V_ERR_RANGE.
 */
int v_scene_set_space(V_SCENE *scene,
                      const double centre[3],
                      double half_size,
                      int up);

/**
 * The space of a scene. Each result may be NULL.
 * Any thread; from callbacks too. V_ERR_NULL, V_ERR_HANDLE, V_ERR_BUSY.
 */
int v_scene_get_space(const V_SCENE *scene,
                      double centre[3],
                      double *half_size,
                      int *up);


/* ---- What a scene is called -------------------------------------------------- */

/**
 * Sets what a scene is called: UTF-8, one line of at most 256 bytes; "" is none.
 * Any thread; from callbacks too. V_ERR_NULL, V_ERR_HANDLE, V_ERR_ARGUMENT,
 * V_ERR_LIMIT, V_ERR_BUSY, V_ERR_MEMORY.
 */
int v_scene_set_title(V_SCENE *scene, const char *title);

/**
 * What a scene is called, as v_path_get_title() gives it of a path.
 * Any thread; from callbacks too. V_ERR_NULL, V_ERR_HANDLE, V_ERR_SIZE, V_ERR_BUSY.
 */
int v_scene_get_title(const V_SCENE *scene,
                      char *title,
                      size_t capacity,
                      size_t *length);

/**
 * Sets the comment of a scene: UTF-8, any lines; "" is none.
 * Any thread; from callbacks too. V_ERR_NULL, V_ERR_HANDLE, V_ERR_ARGUMENT,
 * V_ERR_LIMIT, V_ERR_BUSY, V_ERR_MEMORY.
 */
int v_scene_set_comment(V_SCENE *scene, const char *comment);

/**
 * The comment of a scene, as v_path_get_title() gives the title of a path.
 * Any thread; from callbacks too. V_ERR_NULL, V_ERR_HANDLE, V_ERR_SIZE, V_ERR_BUSY.
 */
int v_scene_get_comment(const V_SCENE *scene,
                        char *comment,
                        size_t capacity,
                        size_t *length);

/**
 * Sets how many frames are shown in a second, > 0 and at most 100000; nothing moves
 * elsewhere by it. A new scene has 25.
 * Any thread; from callbacks too. V_ERR_NULL, V_ERR_HANDLE, V_ERR_RANGE, V_ERR_BUSY.
 */
int v_scene_set_fps(V_SCENE *scene,
                    double fps);

/**
 * How many frames are shown in a second.
 * Any thread; from callbacks too. V_ERR_NULL, V_ERR_HANDLE, V_ERR_BUSY.
 */
int v_scene_get_fps(const V_SCENE *scene, double *fps);

/**
 * Sets the number that people see for the scene's frame 1; a new scene has 1. What the
 * functions here take and give is the scene's frame.
 * Any thread; from callbacks too. V_ERR_NULL, V_ERR_HANDLE, V_ERR_BUSY.
 */
int v_scene_set_first_frame(V_SCENE *scene,
                            int number);

/**
 * The number that people see for the scene's frame 1.
 * Any thread; from callbacks too. V_ERR_NULL, V_ERR_HANDLE, V_ERR_BUSY.
 */
int v_scene_get_first_frame(const V_SCENE *scene, int *number);

/**
 * Sets the limit of a kind of finding, see v_path_check(); it is kept in the file.
 * INFINITY: that kind is not looked for.
 * Any thread; from callbacks too. V_ERR_NULL, V_ERR_HANDLE, V_ERR_ARGUMENT (no such
 * kind), V_ERR_RANGE, V_ERR_BUSY.
 */
int v_scene_set_limit(V_SCENE *scene, const char *kind, double limit);

/**
 * The limit of a kind of finding, see v_path_check(); INFINITY: not looked for.
 * Any thread; from callbacks too. V_ERR_NULL, V_ERR_HANDLE, V_ERR_ARGUMENT, V_ERR_BUSY.
 */
int v_scene_get_limit(const V_SCENE *scene,
                      const char *kind,
                      double *limit);


/* ---- What is shown of a scene ------------------------------------------------ */

/**
 * Chooses the camera that is shown; -1: the first on a path, else the first. The choice
 * is kept in the file, stays with its node and goes with it.
 * Any thread; from callbacks too. V_ERR_NULL, V_ERR_HANDLE, V_ERR_ARGUMENT (no camera),
 * V_ERR_RANGE, V_ERR_BUSY.
 */
int v_scene_set_camera(V_SCENE *scene,
                       int node);

/**
 * The camera that is shown; -1: there is none.
 * Any thread; from callbacks too. V_ERR_NULL, V_ERR_HANDLE, V_ERR_BUSY.
 */
int v_scene_get_camera(const V_SCENE *scene, int *node);

/**
 * Chooses the first and the last frame of a scene; first > last: those of all paths and
 * keys. v_scene_frame_range() gives what holds. It is kept in the file.
 * Any thread; from callbacks too. V_ERR_NULL, V_ERR_HANDLE, V_ERR_ARGUMENT (a number
 * that is not finite), V_ERR_RANGE, V_ERR_LIMIT (more than 100000000 frames), V_ERR_BUSY.
 */
int v_scene_set_range(V_SCENE *scene,
                      double first,
                      double last);

/**
 * Puts a node into another one, or into none (-1).
 *
 * keep  V_KEEP_PLACE: it stays where it is in the world at the scene's first frame, as by
 *     v_scene_set_node(); V_KEEP_NUMBERS: its numbers, path and tracks stay, and it goes
 *     along with its new parent
 * Any thread; from callbacks too. V_ERR_NULL, V_ERR_HANDLE, V_ERR_ARGUMENT (cycles among
 * them), V_ERR_RANGE, V_ERR_LIMIT, V_ERR_BUSY, V_ERR_MEMORY.
 */
int v_scene_set_parent(V_SCENE *scene,
                       int node,
                       int parent,
                       int keep);


/* ---- Tracks ------------------------------------------------------------------ */

/**
 * Sets the keys of a channel in place of older ones; with 0 keys there is none
 * any more.
 *
 * channel: "position", "rotation" (w x y z), "scale", "visible" (0 or 1); of
 * cameras "roll" (degrees) and, unless they follow a path, which has its own, "zoom"
 * (mm, as in V_POSE); of lights "colour", "intensity", "cone"; of objects
 * "colour", "weights" (one for each shape) and "deformation.N.NAME" (N from 0;
 * NAME as v_deform() lists them); of cameras and lights "aim_weight" (0 to 1);
 * and "value:NAME" or "value:NAME:W", W numbers (1 to 16) for the host.
 *
 * interpolation: "step", "linear", "ramp", "sine", "parabolic", "catmull-rom",
 * "hermite", "tcb", "cubic" (not of rotations), "host:NAME"; of rotations also
 * "euler-linear" and "euler-catmull-rom", with three numbers a key: yaw, pitch
 * and roll in degrees. "visible" takes "step" alone.
 *
 * frames: strictly increasing. values: keys x width numbers, key by key. shape:
 * for "hermite" each key's tangent before and after it (2 x width, per frame);
 * for "tcb" tension, continuity and bias; else NULL. after: what follows the
 * last key, V_AFTER_..., and what goes before the first one, V_BEFORE_...
 * Any thread; from callbacks too. V_ERR_NULL,
 * V_ERR_HANDLE, V_ERR_ARGUMENT, V_ERR_RANGE, V_ERR_LIMIT, V_ERR_BUSY,
 * V_ERR_MEMORY.
 */
int v_scene_set_track(V_SCENE *scene,
                      int node,
                      const char *channel,
                      const char *interpolation,
                      const double *frames,
                      const double *values,
                      const double *shape,
                      size_t keys,
                      int after);

/**
 * The keys of a channel as they were set; *keys is how many, 0 if there is no
 * track (then *interpolation is ""). capacity is the number of keys that
 * frames, values and shape have room for; each of them may be NULL, as any
 * other result. The text belongs to the library and is valid until the same
 * thread's next call of a function that gives one of a scene.
 * Any thread; from callbacks too. V_ERR_NULL, V_ERR_HANDLE, V_ERR_ARGUMENT,
 * V_ERR_RANGE, V_ERR_LIMIT, V_ERR_SIZE (more keys than room), V_ERR_BUSY.
 */
int v_scene_get_track(const V_SCENE *scene,
                      int node,
                      const char *channel,
                      const char **interpolation,
                      size_t capacity,
                      double *frames,
                      double *values,
                      double *shape,
                      size_t *keys,
                      int *after);

/**
 * Makes a function known as the interpolation "host:NAME" of every scene of the
 * process, in place of an older one; NULL takes it away. name is NAME, with or
 * without "host:". It is called by
 * whatever thread evaluates a scene, must not use scenes itself, and returns to its
 * caller: no longjmp() and no exception may leave it.
 * Any thread; from callbacks too. V_ERR_NULL, V_ERR_ARGUMENT, V_ERR_LIMIT,
 * V_ERR_MEMORY.
 */
int v_register_interpolation(const char *name, V_INTERPOLATE function, void *user);


/* ---- Objects ----------------------------------------------------------------- */

/**
 * Sets the geometry of an object, copied. A mesh has as many points as the
 * object's shapes, if it has any.
 * Any thread; from callbacks too. V_ERR_NULL,
 * V_ERR_HANDLE, V_ERR_SIZE, V_ERR_ARGUMENT, V_ERR_RANGE, V_ERR_LIMIT,
 * V_ERR_BUSY, V_ERR_MEMORY.
 */
int v_scene_set_geometry(V_SCENE *scene, int node, const V_MESH *mesh);

/**
 * Reads the geometry of an object from an OBJ, PLY, STL or glTF file, by the ending
 * of its name. A .vid file then names that file, relative to itself if it lies beside or below
 * it, in the place of points; v_scene_load() reads it again.
 * Any thread; from callbacks too. V_ERR_NULL, V_ERR_HANDLE, V_ERR_IO, V_ERR_FORMAT,
 * V_ERR_ARGUMENT, V_ERR_RANGE, V_ERR_LIMIT, V_ERR_BUSY, V_ERR_MEMORY.
 */
int v_scene_load_geometry(V_SCENE *scene,
                          int node,
                          const char *file);

/**
 * Adds a shape to an object: other places for all its points. Its weight is 0;
 * the channel "weights" has one number for each shape, and the mesh takes what
 * is left of 1.
 * Any thread; from callbacks too. V_ERR_NULL,
 * V_ERR_HANDLE, V_ERR_ARGUMENT, V_ERR_RANGE, V_ERR_LIMIT, V_ERR_BUSY,
 * V_ERR_MEMORY.
 */
int v_scene_add_shape(V_SCENE *scene,
                      int node,
                      const char *name,
                      const double *xyz,
                      size_t points);

/**
 * Adds a deformation (see v_deform()) to an object, behind the others; *at is
 * its number (NULL: not wanted). box NULL: the bounds of the geometry at rest.
 * Any thread; from callbacks too. V_ERR_NULL,
 * V_ERR_HANDLE, V_ERR_ARGUMENT, V_ERR_RANGE, V_ERR_LIMIT, V_ERR_BUSY,
 * V_ERR_MEMORY.
 */
int v_scene_add_deformation(V_SCENE *scene,
                            int node,
                            const char *kind,
                            const double *parameters,
                            size_t count,
                            const double box[6],
                            int *at);

/**
 * Removes a deformation with its tracks. The numbers behind move up, in the
 * names of channels too.
 * Any thread; from callbacks too. V_ERR_NULL,
 * V_ERR_HANDLE, V_ERR_ARGUMENT, V_ERR_RANGE, V_ERR_BUSY, V_ERR_MEMORY.
 */
int v_scene_remove_deformation(V_SCENE *scene, int node, int at);

/**
 * Deforms points in place. u, v, w run from -1 to 1 along the box (min x y z,
 * max x y z); a flat side gives coordinate 0 and stays. Axes are 0, 1, 2, angles
 * degrees in u, v, w: in a box that is no cube what is turned is stretched as the box
 * is. In parentheses the names of what can move, see v_scene_set_track().
 *
 * "taper"      axis a (a): the other two times 1 + (a-1)(1-u^2)
 * "taper"      axis r0 r1 (r0 r1): from r0 at one end to r1 at the other
 * "twist"      axis angle (angle): about the axis, from 0 to angle
 * "bend"       axis angle (angle): about the axis; the middle stays
 * "bend"       axis_u axis_v u0 v0 phi_min phi_max (the last four): u becomes
 *              the angle about (u0, v0), v - v0 the distance from it
 * "free-form"  64 points, 3 numbers each (points): a Bezier volume over the box,
 *              the first index fastest; (-1, -1, -1), (-1/3, -1, -1) ... is the
 *              identity. Points outside the box stay
 *
 * Any thread; from callbacks too. V_ERR_NULL, V_ERR_ARGUMENT, V_ERR_RANGE,
 * V_ERR_LIMIT, V_ERR_MEMORY.
 */
int v_deform(const char *kind,
             const double *parameters,
             size_t count,
             const double box[6],
             double *xyz,
             size_t points);


/* ---- What has been set in a scene -------------------------------------------- */

/**
 * The frame at which a node's path begins, and what comes before it and after it, see
 * v_scene_set_path(). Each result may be NULL.
 * Any thread; from callbacks too. V_ERR_NULL, V_ERR_HANDLE, V_ERR_ARGUMENT (it
 * follows none), V_ERR_RANGE, V_ERR_BUSY.
 */
int v_scene_get_start(const V_SCENE *scene,
                      int node,
                      double *start_frame,
                      int *after);

/**
 * How many tracks a node has.
 * Any thread; from callbacks too. V_ERR_NULL, V_ERR_HANDLE, V_ERR_RANGE, V_ERR_BUSY.
 */
int v_scene_track_count(const V_SCENE *scene,
                        int node,
                        int *count);

/**
 * The channel of a node's track, for v_scene_get_track(); at counts from 0. The text
 * belongs to the library and is valid until the same thread's next call of a function that
 * gives one of a scene.
 * Any thread; from callbacks too. V_ERR_NULL, V_ERR_HANDLE, V_ERR_RANGE, V_ERR_BUSY.
 */
int v_scene_get_channel(const V_SCENE *scene,
                        int node,
                        int at,
                        const char **channel);

/**
 * How many markers a scene has.
 * Any thread; from callbacks too. V_ERR_NULL, V_ERR_HANDLE, V_ERR_BUSY.
 */
int v_scene_marker_count(const V_SCENE *scene, int *count);

/**
 * A marker, in the order of their names, counted from 0. Each result may be NULL; the text
 * as of v_scene_get_channel().
 * Any thread; from callbacks too. V_ERR_NULL, V_ERR_HANDLE, V_ERR_RANGE, V_ERR_BUSY.
 */
int v_scene_get_marker(const V_SCENE *scene,
                       int at,
                       const char **name,
                       double *frame);

/**
 * Removes a marker with its pins.
 * Any thread; from callbacks too. V_ERR_NULL, V_ERR_HANDLE, V_ERR_ARGUMENT (no such
 * marker), V_ERR_BUSY.
 */
int v_scene_remove_marker(V_SCENE *scene, const char *name);

/**
 * How many points of paths are pinned to markers.
 * Any thread; from callbacks too. V_ERR_NULL, V_ERR_HANDLE, V_ERR_BUSY.
 */
int v_scene_pin_count(const V_SCENE *scene, int *count);

/**
 * A pin, in the order of nodes and points, counted from 0: what v_scene_pin() was given.
 * Each result may be NULL; the text as of v_scene_get_channel().
 * Any thread; from callbacks too. V_ERR_NULL, V_ERR_HANDLE, V_ERR_RANGE, V_ERR_BUSY.
 */
int v_scene_get_pin(const V_SCENE *scene,
                    int at,
                    int *node,
                    int *point,
                    const char **marker);

/**
 * The geometry of an object at rest, as it was set or read from a file; no points if there
 * is none. What the mesh points to is the library's, and valid until the scene is changed or
 * freed. mesh->size must be set before.
 * Any thread; from callbacks too. V_ERR_NULL, V_ERR_HANDLE, V_ERR_SIZE, V_ERR_ARGUMENT (no
 * object), V_ERR_RANGE, V_ERR_BUSY.
 */
int v_scene_get_geometry(const V_SCENE *scene,
                         int node,
                         V_MESH *mesh);

/**
 * How many shapes an object has.
 * Any thread; from callbacks too. V_ERR_NULL, V_ERR_HANDLE, V_ERR_ARGUMENT (no object),
 * V_ERR_RANGE, V_ERR_BUSY.
 */
int v_scene_shape_count(const V_SCENE *scene,
                        int node,
                        int *count);

/**
 * A shape of an object, counted from 0: its name, and its points, three numbers each;
 * capacity counts points, *points is how many there are. Each result may be NULL; the text
 * as of v_scene_get_channel().
 * Any thread; from callbacks too. V_ERR_NULL, V_ERR_HANDLE, V_ERR_SIZE (more points than
 * room; *points is written), V_ERR_ARGUMENT (no object), V_ERR_RANGE, V_ERR_BUSY.
 */
int v_scene_get_shape(const V_SCENE *scene,
                      int node,
                      int at,
                      const char **name,
                      double *xyz,
                      size_t capacity,
                      size_t *points);

/**
 * Removes a shape of an object. The numbers behind move up; the others keep their weights,
 * in a track of the channel "weights" too.
 * Any thread; from callbacks too. V_ERR_NULL, V_ERR_HANDLE, V_ERR_ARGUMENT (no object),
 * V_ERR_RANGE, V_ERR_BUSY, V_ERR_MEMORY.
 */
int v_scene_remove_shape(V_SCENE *scene,
                         int node,
                         int at);

/**
 * How many deformations an object has.
 * Any thread; from callbacks too. V_ERR_NULL, V_ERR_HANDLE, V_ERR_ARGUMENT (no object),
 * V_ERR_RANGE, V_ERR_BUSY.
 */
int v_scene_deformation_count(const V_SCENE *scene,
                              int node,
                              int *count);

/**
 * A deformation of an object, counted from 0: its kind, its parameters as they were given
 * (*count is how many), and its box. Where it goes by the bounds of the geometry, box is
 * 1 1 1 -1 -1 -1, which no other is: give v_scene_add_deformation() NULL then. Each result
 * may be NULL; the text as of v_scene_get_channel().
 * Any thread; from callbacks too. V_ERR_NULL, V_ERR_HANDLE, V_ERR_SIZE (more parameters than
 * room; *count is written), V_ERR_ARGUMENT (no object), V_ERR_RANGE, V_ERR_BUSY.
 */
int v_scene_get_deformation(const V_SCENE *scene,
                            int node,
                            int at,
                            const char **kind,
                            double *parameters,
                            size_t capacity,
                            size_t *count,
                            double box[6]);


/* ---- The scene at a frame ---------------------------------------------------- */

/**
 * The first and the last frame: those of v_scene_set_range(), else of all paths and keys;
 * 1 and 1 if nothing moves.
 * Each result may be NULL.
 * Any thread; from callbacks too. V_ERR_NULL, V_ERR_HANDLE, V_ERR_ARGUMENT,
 * V_ERR_BUSY.
 */
int v_scene_frame_range(const V_SCENE *scene,
                        double *first,
                        double *last);

/**
 * The states of all nodes at a frame, any finite number, by the nodes' numbers.
 * *count (NULL: not wanted) is how many. states NULL: only that.
 *
 * A channel whose interpolation is the host's and is not registered, fails or
 * gives no finite number steps from key to key: the rest plays, the answer is
 * V_OK, and v_last_warning() tells, "" if there was none.
 * Any thread; from callbacks too. V_ERR_NULL, V_ERR_HANDLE, V_ERR_SIZE (fewer
 * than the nodes; *count is written), V_ERR_ARGUMENT, V_ERR_RANGE, V_ERR_LIMIT, V_ERR_BUSY,
 * V_ERR_MEMORY.
 */
int v_scene_evaluate(const V_SCENE *scene,
                     double frame,
                     V_NODE_STATE *states,
                     size_t capacity,
                     size_t *count);

/**
 * count states of one node, at the frames first, first + frame_step and so on. What
 * v_scene_evaluate() says of a host's interpolation holds here too.
 * Any thread; from callbacks too. V_ERR_NULL, V_ERR_HANDLE, V_ERR_ARGUMENT,
 * V_ERR_RANGE, V_ERR_LIMIT, V_ERR_BUSY, V_ERR_MEMORY.
 */
int v_scene_sample(const V_SCENE *scene,
                   int node,
                   double first,
                   double frame_step,
                   V_NODE_STATE *states,
                   size_t count);

/**
 * The numbers of a channel (see v_scene_set_track()) at a frame, with or without
 * a track; *width (NULL: not wanted) is how many. values NULL: only that. What
 * v_scene_evaluate() says of a host's interpolation holds here too.
 * Any thread; from callbacks too. V_ERR_NULL, V_ERR_HANDLE, V_ERR_SIZE (fewer
 * than the channel has; *width is written), V_ERR_ARGUMENT, V_ERR_RANGE, V_ERR_LIMIT, V_ERR_BUSY,
 * V_ERR_MEMORY.
 */
int v_scene_value(const V_SCENE *scene,
                  int node,
                  const char *channel,
                  double frame,
                  double *values,
                  size_t capacity,
                  size_t *width);

/**
 * The points of an object at a frame, morphed and deformed, in the node's own
 * coordinates: three numbers each, capacity counts points; *points (NULL: not
 * wanted) is how many. xyz NULL: only that. What v_scene_evaluate() says of a
 * host's interpolation holds here too.
 * Any thread; from callbacks too. V_ERR_NULL, V_ERR_HANDLE, V_ERR_SIZE (more
 * points than room; *points is written), V_ERR_ARGUMENT (no object), V_ERR_RANGE, V_ERR_BUSY,
 * V_ERR_MEMORY.
 */
int v_scene_vertices(const V_SCENE *scene,
                     int node,
                     double frame,
                     double *xyz,
                     size_t capacity,
                     size_t *points);

/**
 * Writes a scene in the format of another program: gltf, glb, usda, blender,
 * paraview, vtk, nerfstudio, transforms, cameras, tum, kitti, colmap (a folder), osg, chan,
 * html, ascii, csv, json or vid; format NULL: the one that the file's name tells. options are
 * lines name=value ("fps=30\nnode=camera"), NULL: none; the names are node, frames, fps, start,
 * size, up, scale, as, tolerance, angle, compact, digits and rotation-order, as `vides convert
 * --help` explains them; of two alike the last counts, and one that a format has no use for is
 * ignored. Each file is afterwards wholly the old or wholly the new one; a missing folder is made
 * only for colmap, in one that is there.
 *
 * What the format cannot hold is left out: the answer is V_OK, and v_last_warning()
 * tells, a line each, "" if nothing is.
 * Any thread; from callbacks too. V_ERR_NULL, V_ERR_HANDLE, V_ERR_BUSY, V_ERR_ARGUMENT (format,
 * options, no such node, a host interpolation that fails), V_ERR_RANGE (frames, fps), V_ERR_FORMAT
 * (a folder that holds what would be read first), V_ERR_IO, V_ERR_LIMIT, V_ERR_MEMORY.
 * Memory that runs out while a file is opened or written may end the program; the old file
 * stays.
 */
int v_scene_export(const V_SCENE *scene,
                   const char *file,
                   const char *format,
                   const char *options);

/**
 * Reads the file of another program, or a folder of COLMAP's, as a scene: one of gltf, glb,
 * usda, nerfstudio, transforms, cameras, tum, kitti, colmap, osg, chan, paraview (what
 * v_scene_export() wrote; nothing is run), ascii, csv, json and vid; format NULL: the one that
 * the content shows. options as of v_scene_export(). Poses become a path of few points, fitted,
 * or with "as=keys", or fewer than three, a camera with a key for each. *scene is the caller's, to be freed
 * with v_scene_free().
 *
 * What is not taken, and how well a path fits, is told by v_last_warning() beside V_OK, a line
 * each, "" if there is nothing to tell.
 * Any thread; from callbacks too. V_ERR_NULL, V_ERR_ARGUMENT (format, options), V_ERR_IO,
 * V_ERR_FORMAT (with place and reason in v_last_error()), V_ERR_RANGE, V_ERR_LIMIT,
 * V_ERR_MEMORY. Memory that runs out while the file is parsed may end the program.
 */
int v_scene_import(const char *file,
                   const char *format,
                   const char *options,
                   V_SCENE **scene);


/* ---- Paths from recorded poses, checks --------------------------------------- */

/**
 * A path of few support points that passes recorded poses: each position within
 * tolerance, each view, up and field of view within angle degrees, at its time, and as
 * smoothly as they do. Noise of up to half of that is taken out.
 *
 * seconds  when each pose was taken, increasing; NULL: one a frame
 * count    at least three
 * fps      frames in a second of the path
 * The space is the smallest round the positions, with a tenth to spare, and V_UP_Y.
 * *path is the caller's, to be freed with v_path_free().
 * Any thread; from callbacks too. V_ERR_NULL, V_ERR_ARGUMENT (poses that are no
 * path: all the same, a number that is not finite, a view without direction),
 * V_ERR_RANGE, V_ERR_LIMIT, V_ERR_MEMORY.
 */
int v_path_fit_poses(const V_POSE *poses,
                     const double *seconds,
                     size_t count,
                     double fps,
                     double tolerance,
                     double angle,
                     V_PATH **path);

/**
 * As v_path_fit_poses(), in a space: what stands upright there does so for rolls and ups.
 *
 * space   see v_space_init(). With half_size 0 only its up counts, and it is the
 *     smallest round the positions, as with NULL
 * *path is the caller's, to be freed with v_path_free().
 * Any thread; from callbacks too. V_ERR_NULL, V_ERR_SIZE, V_ERR_ARGUMENT, V_ERR_RANGE,
 * V_ERR_LIMIT, V_ERR_MEMORY.
 */
int v_path_fit_poses_in_space(const V_POSE *poses,
                              const double *seconds,
                              size_t count,
                              double fps,
                              double tolerance,
                              double angle,
                              const V_SPACE *space,
                              V_PATH **path);

/**
 * As v_path_fit_poses_in_space(), but poses that are off by more than the tolerance
 * from what those around them say are left out; the others are met.
 *
 * left_out  how many are; may be NULL
 * v_last_warning() then says how many and which is the first, "" if none is.
 * *path is the caller's, to be freed with v_path_free().
 * Any thread; from callbacks too. V_ERR_NULL, V_ERR_SIZE, V_ERR_ARGUMENT, V_ERR_RANGE,
 * V_ERR_LIMIT, V_ERR_MEMORY.
 */
int v_path_fit_poses_robust(const V_POSE *poses,
                            const double *seconds,
                            size_t count,
                            double fps,
                            double tolerance,
                            double angle,
                            const V_SPACE *space,
                            size_t *left_out,
                            V_PATH **path);

/**
 * Looks for what will look wrong in the film. Of each kind there is one finding for
 * each run of frames, in the order of the frames. Lengths count in half sizes of the
 * space:
 *
 * "space"         the camera is outside the space by more than the limit (0)
 * "cusp"          curve or pace nearly stop in a section (0.02 of the mean)
 * "speed-jump"    at a key, in shares of the mean speed (0.5)
 * "acceleration"  in half sizes a second squared (10)
 * "view-jump"     degrees at once (1)
 * "turning"       degrees a second (60)
 * "turning-acceleration"  degrees a second squared (300)
 * "half-turn"     degrees from a half turn, that might go either way (0.1)
 * "pole"          degrees from straight up or down, below the limit (3)
 * "target"        the target is nearer than the limit (0.05)
 * "clearance"     the object is nearer than the limit (0.02)
 * "through"       the way leads through a triangle of the object
 * "nothing-to-see"  nothing of the object in the picture, seconds (1)
 * "zoom"          mm a second (30)
 * "redundant"     the poses would be the same without a key: they change by less than
 *                 so many times 0.001 half sizes, 0.1 degrees and 0.1 mm (1)
 * "corner"        degrees by which the way turns at a point (60)
 * "jerk"          in half sizes a second cubed, the third difference of the places at
 *                 whole frames (off unless a limit is set)
 * "speed"         in half sizes a second (off unless a limit is set)
 * "crossing"      seconds in which what is in the middle of the picture, as far away as
 *                 the target (or the middle of the space), would cross it; below the
 *                 limit (off unless one is set)
 *
 * object  what the camera must not come near to, in the coordinates of the path;
 *     NULL: the path's own object with its faces, if it has one
 * findings  room for capacity of them; *count is how many there are. With a
 *     capacity too small nothing else is written and the answer is V_ERR_SIZE;
 *     findings NULL with capacity 0 only asks for *count
 * v_last_warning() then has notes, "" if there are none: that the camera is inside
 * the object all the time, and what was not looked at (objects that move, what
 * a parent adds to the camera).
 * Any thread; from callbacks too. V_ERR_NULL, V_ERR_HANDLE, V_ERR_SIZE,
 * V_ERR_ARGUMENT (an object without geometry), V_ERR_RANGE, V_ERR_LIMIT,
 * V_ERR_MEMORY.
 */
int v_path_check(const V_PATH *path,
                 const V_MESH *object,
                 V_FINDING *findings,
                 size_t capacity,
                 size_t *count);

/**
 * Sets the limit of a kind of finding, see v_path_check(); it is kept in the file.
 * INFINITY: that kind is not looked for.
 * Any thread; from callbacks too. V_ERR_NULL, V_ERR_HANDLE, V_ERR_ARGUMENT (no such
 * kind), V_ERR_RANGE.
 */
int v_path_set_limit(V_PATH *path, const char *kind, double limit);

/**
 * The limit of a kind of finding, see v_path_check(); INFINITY: not looked for.
 * Any thread; from callbacks too. V_ERR_NULL, V_ERR_HANDLE, V_ERR_ARGUMENT.
 */
int v_path_get_limit(const V_PATH *path, const char *kind, double *limit);


/* ---- Planning ---------------------------------------------------------------- */

/**
 * Fills in the limits that a check has unless told (v_path_check()): acceleration 10,
 * turning 60, turning_acceleration 300, zoom 30, and no others. NULL does nothing but
 * set v_last_error(). In C a macro of this name hands the struct's size on to
 * v_limits_init_sized(); the function itself, for other languages, fills in the struct
 * of version 1.0.
 * Any thread; from callbacks too.
 */
void v_limits_init(V_LIMITS *limits);

/**
 * As v_limits_init(), for a struct that is size bytes long. One shorter than in version
 * 1.0 stays as it is, and v_last_error() says so. What is behind the fields that the
 * library knows is not touched, and size is set to what was filled in.
 * Any thread; from callbacks too.
 */
void v_limits_init_sized(V_LIMITS *limits,
                         size_t size);

/**
 * Computes the pace anew from the first orientation of one support point to the last
 * of another, as fast as the limits allow; the curve and the views stay where they
 * were in place. The way rests at the ends of an open path, where keys are held, and
 * where curve or view have a kink; v_last_warning() names these. What is beside the
 * points keeps its pace. Sections get fixed frames, a given distance and a curve time
 * of their own.
 *
 * limits  see v_limits_init(); NULL: the path's own, see v_path_set_limit()
 * first_point, last_point  0 and the last: all, closed paths with the way back to
 *     the first point; on a closed path first_point may lie behind last_point
 * seconds  0: as few as the limits allow; else exactly so many, to a whole frame, with
 *     the lowest peaks; as everywhere those of the poses: at the path's end the last
 *     one has a frame, too
 * Any thread; from callbacks too. V_ERR_NULL, V_ERR_HANDLE, V_ERR_SIZE,
 * V_ERR_ARGUMENT (no limit, one that is not positive, too few seconds: v_last_error()
 * names the least), V_ERR_RANGE, V_ERR_LIMIT, V_ERR_MEMORY.
 */
int v_path_retime(V_PATH *path,
                  const V_LIMITS *limits,
                  int first_point,
                  int last_point,
                  double seconds);

/**
 * A recorded flight without the shaking of a hand: places, views and zoom go through a low pass
 * without a lag, at whole frames, and become a path of few support points again, as
 * v_path_fit_poses() makes one, of as many frames. The first and the last pose stay. Names of
 * points, targets and modes go; a closed path comes back open. v_last_warning() says how far
 * it went from what it was.
 *
 * seconds  half of a movement that takes so long there and back stays, hardly anything of
 *     quicker ones; greater than 0 and at most 2,000 frames
 * within   no place goes farther than so; 0: no bound
 * Any thread; from callbacks too. V_ERR_NULL, V_ERR_HANDLE, V_ERR_ARGUMENT (a path that
 * does not move, no path within the bound), V_ERR_RANGE, V_ERR_LIMIT, V_ERR_MEMORY.
 */
int v_path_steady(V_PATH *path,
                  double seconds,
                  double within);

/**
 * Leads the way clear of an object: where the camera, or a sphere around it, comes nearer
 * than the clearance, or goes through it, points are moved as little as possible and as
 * few put in as it takes; points that were clear stay, but for those within a closed
 * part of the object between others outside. Frames and targets stay. v_last_warning()
 * has a line for each part that changed, "" if the way was clear.
 *
 * object  in the coordinates of the path; NULL: the path's own
 * clearance, radius  in the path's units; the clearance greater than 0, the radius of the
 *     sphere 0 or greater
 * Any thread; from callbacks too. V_ERR_NULL, V_ERR_HANDLE, V_ERR_SIZE, V_ERR_ARGUMENT
 * (no way round: v_last_error() names the frame and the place; an object without
 * geometry), V_ERR_RANGE, V_ERR_LIMIT, V_ERR_MEMORY.
 */
int v_path_avoid(V_PATH *path,
                 const V_MESH *object,
                 double clearance,
                 double radius);

/**
 * Keeps an object whole in the picture less margin, at every frame and between: by the
 * zoom or the distance as large as that allows and the path's limits of zoom, or of
 * speed and acceleration (see v_path_set_limit()), let it change; by turning no more
 * than it takes. Frames and pace stay. Where keys do not hold it points are added.
 * The path stays as it is where that cannot be.
 *
 * object  in the coordinates of the path; NULL: the path's own, with the objects of
 *     its scene
 * margin  the share of the picture's width and height (36 x 24 mm) that stays free at
 *     each side, from 0 to below 0.5
 * what  V_PICTURE_ZOOM, V_PICTURE_DISTANCE or V_PICTURE_VIEW
 * Any thread; from callbacks too. V_ERR_NULL, V_ERR_HANDLE, V_ERR_ARGUMENT (no object,
 * or where it cannot be whole, with the frame), V_ERR_RANGE, V_ERR_SIZE, V_ERR_LIMIT,
 * V_ERR_MEMORY.
 */
int v_path_keep_in_picture(V_PATH *path,
                           const V_MESH *object,
                           double margin,
                           int what);

/**
 * Fills in a tour of 60 seconds that shows 0.95, from outside at a distance that is
 * found, as a closed round, with V_UP_Y. NULL does nothing but set v_last_error(). In C
 * a macro of this name hands the struct's size on to v_tour_init_sized(); the function
 * itself, for other languages, fills in the struct of version 1.0.
 * Any thread; from callbacks too.
 */
void v_tour_init(V_TOUR *tour);

/**
 * As v_tour_init(), for a struct that is size bytes long. One shorter than in version
 * 1.0 stays as it is, and v_last_error() says so. What is behind the fields that the
 * library knows is not touched, and size is set to what was filled in.
 * Any thread; from callbacks too.
 */
void v_tour_init_sized(V_TOUR *tour,
                       size_t size);

/**
 * A flight that shows an object which nobody has planned for: the fewest places found
 * from where so much of its surface is seen, a short round through them that keeps
 * clear of it, at a pace within the limits of a check (v_path_check()), 25 frames a
 * second.
 *
 * object  its triangles count. From outside only the side that normals point to counts
 *     where neighbouring triangles agree about it, else either does
 * tour  NULL: as v_tour_init() has it
 * coverage  the share that is shown of what can be seen; may be NULL
 * v_last_warning() then has two lines: places, coverage, length and seconds; what stays
 * unseen, and why.
 * *path is the caller's, to be freed with v_path_free(). It takes about 300 pictures'
 * time, for a million triangles some seconds, and about 300 bytes a triangle.
 * Any thread; from callbacks too. V_ERR_NULL, V_ERR_SIZE, V_ERR_ARGUMENT (no surface, no
 * free place, too few seconds: v_last_error() names the least), V_ERR_RANGE,
 * V_ERR_LIMIT, V_ERR_MEMORY.
 */
int v_path_tour(const V_MESH *object,
                const V_TOUR *tour,
                V_PATH **path,
                double *coverage);


/* ---- Opening and closing windows --------------------------------------------- */

/**
 * The options' defaults: size, space_up V_UP_Y, and everything else NULL or 0. NULL
 * does nothing but set v_last_error(). In C a macro of this name hands the struct's size
 * on to v_editor_options_init_sized(); the function itself, for other languages
 * (ctypes, JNI, bindgen), fills in all that version 1.0 has: the whole struct.
 * Any thread; from callbacks too.
 */
void v_editor_options_init(V_EDITOR_OPTIONS *options);

/**
 * As v_editor_options_init(), for a struct that is size bytes long. One shorter than
 * in version 1.0 stays as it is, and v_last_error() says so. What is behind the fields
 * that the library knows is not touched, and size is set to what was filled in.
 * Any thread; from callbacks too.
 */
void v_editor_options_init_sized(V_EDITOR_OPTIONS *options,
                                 size_t size);

/**
 * Opens an editor window and returns at once; how it is served then, see
 * v_fd(). options may be NULL for the defaults. *editor is the caller's, to be
 * freed with v_editor_close().
 *
 * The callbacks run on the thread that opened the window, inside the
 * host's event loop, and may call any function of the library. They may come
 * while the host is in a modal dialog of its own, whose loop serves the window,
 * too. They return to their caller: no longjmp() and no exception may leave them. An exception that
 * does ends the program, after a line on standard error that names the callback.
 * The window belongs to this thread and is closed when it ends, which a line on
 * standard error says.
 * The thread that runs the event loop; from callbacks too. V_ERR_NULL,
 * V_ERR_SIZE, V_ERR_HANDLE (of path), V_ERR_ARGUMENT, V_ERR_RANGE, V_ERR_IO and
 * V_ERR_FORMAT (of file), V_ERR_DISPLAY, V_ERR_LIMIT, V_ERR_MEMORY.
 */
int v_editor_open(const V_EDITOR_OPTIONS *options,
                  V_EDITOR **editor);

/**
 * Closes a window without asking anybody, and frees its handle. From within
 * its own callbacks it closes when they have returned. NULL is no error.
 * The thread that opened it, or any once the window is gone; from callbacks
 * too. V_ERR_HANDLE.
 */
int v_editor_close(V_EDITOR *editor);

/**
 * A copy of the path as it is in the window now; of a scene that of the camera that is
 * shown (v_scene_get_camera()). *path is the caller's, to be freed with v_path_free().
 * The thread that opened the window; from callbacks too. V_ERR_NULL,
 * V_ERR_HANDLE, V_ERR_CLOSED, V_ERR_ARGUMENT (no camera, or it follows no path),
 * V_ERR_MEMORY, V_ERR_LIMIT.
 */
int v_editor_get_path(const V_EDITOR *editor,
                      V_PATH **path);

/**
 * Shows another path in a window, in one step that the user can take back.
 * path is copied, with its space, title, comment and so on; its object, too, if it
 * has one. Base speeds that were given when the window was opened stay. In a
 * scene it takes the place of the path of the camera that is shown, which is
 * edited then.
 * The thread that opened the window; from callbacks too. V_ERR_NULL,
 * V_ERR_HANDLE, V_ERR_CLOSED, V_ERR_ARGUMENT (no camera, or it follows no path),
 * V_ERR_MEMORY.
 */
int v_editor_set_path(V_EDITOR *editor, const V_PATH *path);


/* ---- The window and the host's own picture ----------------------------------- */

/**
 * Shows the host's camera in a window, as a ghost in the movement space that the
 * user can take over into the path. NULL: no more. vpn and vup may have any length
 * but 0.
 *
 * What a callback changes by these functions or by v_editor_set_path(), that
 * callbacks are not called for.
 * The thread that opened the window; from callbacks too. V_ERR_HANDLE,
 * V_ERR_CLOSED, V_ERR_NULL (editor), V_ERR_ARGUMENT, V_ERR_RANGE.
 */
int v_editor_set_view(V_EDITOR *editor, const V_POSE *pose);

/**
 * The frame at the playhead, from 1: v_path_pose() of it is what the camera there
 * sees. It lies between two frames where the user has gone there. In a scene it is
 * the scene's frame, as v_scene_evaluate() takes it.
 * The thread that opened the window; from callbacks too. V_ERR_NULL,
 * V_ERR_HANDLE, V_ERR_CLOSED, V_ERR_MEMORY, V_ERR_LIMIT.
 */
int v_editor_get_frame(const V_EDITOR *editor, double *frame);

/**
 * The playhead goes to a frame, from 1 to v_path_frame_count(), also between two,
 * and stays there. The orientation from which the camera comes there is current
 * then. In a scene it is a frame of the scene, any from the first to the last one
 * of v_scene_frame_range(), whatever is selected.
 * The thread that opened the window; from callbacks too. V_ERR_NULL,
 * V_ERR_HANDLE, V_ERR_CLOSED, V_ERR_RANGE, V_ERR_MEMORY, V_ERR_LIMIT.
 */
int v_editor_set_frame(V_EDITOR *editor, double frame);

/**
 * Plays the flight from the playhead on, at the end from the beginning; play 0:
 * no more. It begins when the window is served next, and goes on whether or not
 * that is seen.
 * The thread that opened the window; from callbacks too. V_ERR_NULL,
 * V_ERR_HANDLE, V_ERR_CLOSED.
 */
int v_editor_play(V_EDITOR *editor, int play);

/**
 * Makes an orientation of a point current, both counted from 0.
 * The thread that opened the window; from callbacks too. V_ERR_NULL,
 * V_ERR_HANDLE, V_ERR_CLOSED, V_ERR_ARGUMENT (no path is edited), V_ERR_RANGE.
 */
int v_editor_select(V_EDITOR *editor, int point, int orientation);

/**
 * Shows another object, copied, in one step that the user can take back. NULL:
 * none.
 * The thread that opened the window; from callbacks too. V_ERR_NULL (editor),
 * V_ERR_SIZE, V_ERR_HANDLE, V_ERR_CLOSED, V_ERR_ARGUMENT, V_ERR_RANGE,
 * V_ERR_LIMIT, V_ERR_MEMORY.
 */
int v_editor_set_object(V_EDITOR *editor, const V_MESH *object);

/**
 * Sets what follows "VIDES" in the window's title, UTF-8, one line (control
 * characters are shown as spaces); NULL: the file's name.
 * The thread that opened the window; from callbacks too. V_ERR_NULL (editor),
 * V_ERR_HANDLE, V_ERR_CLOSED, V_ERR_ARGUMENT, V_ERR_MEMORY.
 */
int v_editor_set_title(V_EDITOR *editor, const char *title);

/**
 * Whether there is work in a window that would be lost with it: *modified is 1 or 0.
 * The thread that opened the window; from callbacks too. V_ERR_NULL,
 * V_ERR_HANDLE, V_ERR_CLOSED.
 */
int v_editor_is_modified(const V_EDITOR *editor,
                         int *modified);

/**
 * Saves the path of a window as a .vid file, whatever is there, which the window
 * edits from then on. NULL: its own file, unless another program has changed that
 * meanwhile.
 * The thread that opened the window; from callbacks too. V_ERR_NULL (editor),
 * V_ERR_HANDLE, V_ERR_CLOSED, V_ERR_ARGUMENT (no file yet, or changed by others),
 * V_ERR_IO, V_ERR_MEMORY.
 */
int v_editor_save(V_EDITOR *editor, const char *file);

/**
 * Brings a window before all others, if the desktop lets it.
 * The thread that opened the window; from callbacks too. V_ERR_NULL,
 * V_ERR_HANDLE, V_ERR_CLOSED, V_ERR_DISPLAY.
 */
int v_editor_raise(V_EDITOR *editor);

/**
 * Closes all windows of this thread, those of v_haupt(), too: for the host's own
 * Quit. ask not 0: each window asks about unsaved work, then on_close or ende, one
 * after the other; all are served until the last is closed or somebody says no.
 * Handles are freed by v_editor_close() nevertheless.
 * The thread that opens the windows. V_ERR_REFUSED (the windows before that one are
 * closed), V_ERR_BUSY from within a callback, V_ERR_DISPLAY, V_ERR_LIMIT without
 * descriptors.
 */
int v_editors_close(int ask);

/**
 * A copy of the scene as it is in the window now; of a path alone that of a camera on
 * it. *scene is the caller's, to be freed with v_scene_free().
 * The thread that opened the window; from callbacks too. V_ERR_NULL, V_ERR_HANDLE,
 * V_ERR_CLOSED, V_ERR_MEMORY, V_ERR_LIMIT.
 */
int v_editor_get_scene(const V_EDITOR *editor,
                       V_SCENE **scene);

/**
 * Shows another scene in a window, in one step that the user can take back. scene is
 * copied, with its space, title, comment and so on; its wireframe object, too, if it has
 * one. The space of the options is that of what the window began with.
 * The path that is edited stays so where its node is there under its name and follows
 * one; else that of the camera that is shown is edited then, if it has one, with the base
 * speeds that were given when the window was opened. One camera on a path and nothing
 * else is that path. A drag of the user's ends where it has come to. The playhead stays
 * at its frame, if the scene has that. A scene like the one before is a step, too.
 * The thread that opened the window; from callbacks too. V_ERR_NULL, V_ERR_HANDLE,
 * V_ERR_CLOSED, V_ERR_BUSY, V_ERR_ARGUMENT, V_ERR_RANGE, V_ERR_MEMORY, V_ERR_LIMIT.
 */
int v_editor_set_scene(V_EDITOR *editor,
                       const V_SCENE *scene);


/* ---- Steps of a window ------------------------------------------------------- */

/**
 * Takes back the last step of a window, as the user does by Ctrl-Z. A window keeps the last
 * 10,000 steps, and of what they have changed 256 MiB.
 * The thread that opened the window; from callbacks too. V_ERR_NULL,
 * V_ERR_HANDLE, V_ERR_CLOSED, V_ERR_ARGUMENT (there is none).
 */
int v_editor_undo(V_EDITOR *editor);

/**
 * Does again what was taken back last, as the user does by Ctrl-Y.
 * The thread that opened the window; from callbacks too. V_ERR_NULL,
 * V_ERR_HANDLE, V_ERR_CLOSED, V_ERR_ARGUMENT (there is none).
 */
int v_editor_redo(V_EDITOR *editor);

/**
 * Begins what the user can take back at once: all that is changed in a window, by whomever,
 * until v_editor_end_step(). One that was begun before is forgotten; another document in the
 * window ends it.
 * The thread that opened the window; from callbacks too. V_ERR_NULL,
 * V_ERR_HANDLE, V_ERR_CLOSED.
 */
int v_editor_begin_step(V_EDITOR *editor);

/**
 * Ends what v_editor_begin_step() has begun; without that it does nothing.
 * The thread that opened the window; from callbacks too. V_ERR_NULL,
 * V_ERR_HANDLE, V_ERR_CLOSED, V_ERR_MEMORY (the steps stay apart).
 */
int v_editor_end_step(V_EDITOR *editor);

/**
 * The point that is current and its orientation, both counted from 0, see
 * v_editor_select(). Each result may be NULL.
 * The thread that opened the window; from callbacks too. V_ERR_NULL,
 * V_ERR_HANDLE, V_ERR_CLOSED, V_ERR_ARGUMENT (no path of its scene is edited).
 */
int v_editor_get_selection(const V_EDITOR *editor, int *point, int *orientation);

/**
 * Whether a window plays the flight, see v_editor_play(): *playing is 1 or 0.
 * The thread that opened the window; from callbacks too. V_ERR_NULL,
 * V_ERR_HANDLE, V_ERR_CLOSED.
 */
int v_editor_is_playing(const V_EDITOR *editor, int *playing);


/* ---- Toolbox: quaternions ---------------------------------------------------- */

/**
 * Quaternions are w, x, y, z. What goes in is brought to length 1; V_ERR_ARGUMENT
 * if it is zero or not finite. The camera that is not turned looks along
 * (0, 0, 1) with (0, 1, 0) up. Results may be the same arrays as arguments.
 *
 * Spherical linear interpolation from a (t = 0) to b (t = 1) by the shorter
 * way; any finite t.
 * Any thread; from callbacks too. V_ERR_NULL, V_ERR_ARGUMENT.
 */
int v_quat_slerp(const double a[4], const double b[4], double t, double q[4]);

/**
 * The quaternion of a camera that looks along vpn with vup up. Both may have
 * any length but zero; vup need not be perpendicular to vpn, but not parallel.
 * Any thread; from callbacks too. V_ERR_NULL, V_ERR_ARGUMENT.
 */
int v_quat_from_view(const double vpn[3], const double vup[3], double q[4]);

/**
 * View direction and up vector of a quaternion. Each result may be NULL.
 * Any thread; from callbacks too. V_ERR_NULL, V_ERR_ARGUMENT.
 */
int v_view_from_quat(const double q[4], double vpn[3], double vup[3]);

/**
 * A smooth curve through orientations (Barry and Goldman 1988), its ends by
 * reflection, at the time when.
 *
 * keys   count quaternions, four doubles each
 * key_times  the time of each key, strictly increasing
 * count  at least 2
 * when   from the first time to the last
 * Any thread; from callbacks too. V_ERR_NULL, V_ERR_ARGUMENT, V_ERR_RANGE,
 * V_ERR_LIMIT, V_ERR_MEMORY.
 */
int v_quat_spline(const double *keys,
                  const double *key_times,
                  int count,
                  double when,
                  double q[4]);

/**
 * As v_quat_spline(), by a cubic spherical curve with tension, continuity and
 * bias.
 *
 * tcb  three doubles for each key, tension, continuity and bias, each from
 *     -1 to 1; NULL for all zero
 * Any thread; from callbacks too. V_ERR_NULL, V_ERR_ARGUMENT, V_ERR_RANGE,
 * V_ERR_LIMIT, V_ERR_MEMORY.
 */
int v_quat_tcb_spline(const double *keys,
                      const double *key_times,
                      const double *tcb,
                      int count,
                      double when,
                      double q[4]);


/* ---- Toolbox: speed curve ---------------------------------------------------- */

/**
 * The speed curve of one section: ten speeds from 1 to 100 at u = 0, 1/9, ... 1,
 * smoothly joined, never leaving 1 to 100.
 *
 * before, after  the facing speeds of the neighbouring sections; NULL where
 *     there is none
 * u    from 0 to 1
 * speed_at_u         the speed there
 * distance_fraction  how much of the way is done there, 0 to 1
 * Each result may be NULL.
 * Any thread; from callbacks too. V_ERR_NULL, V_ERR_ARGUMENT, V_ERR_RANGE.
 */
int v_speed_curve(const double speed[10],
                  const double *before,
                  const double *after,
                  double u,
                  double *speed_at_u,
                  double *distance_fraction);


/* ---- Toolbox: views ---------------------------------------------------------- */

/**
 * The matrix that takes world coordinates into the canonical volume of a view:
 * 16 numbers by rows, for column vectors, m times (x, y, z, 1). In a parallel
 * projection x and y are then from -1 to 1 and z is 0 in the front plane and
 * -1 in the back plane; in a perspective |x| and |y| are at most z, and z is 1
 * in the back plane.
 * Any thread; from callbacks too. V_ERR_NULL, V_ERR_SIZE, V_ERR_ARGUMENT (up
 * parallel to normal), V_ERR_RANGE (prp not before the front plane, back plane
 * not behind it, empty window).
 */
int v_view_matrix(const V_VIEW *view, double m[16]);

/**
 * The perspective view that a camera has in a pose. aspect is the picture's
 * width by its height; front and back are the distances of the planes before
 * the camera, 0 < front < back. view->size must be set before.
 * Any thread; from callbacks too. V_ERR_NULL, V_ERR_SIZE, V_ERR_ARGUMENT,
 * V_ERR_RANGE.
 */
int v_view_from_pose(const V_POSE *pose,
                     double aspect,
                     double front,
                     double back,
                     V_VIEW *view);

/**
 * The matrix of a camera in a pose as gluLookAt() makes it, to be given to
 * glLoadMatrixd(): 16 numbers by columns, world to eye, looking along -z.
 * Any thread; from callbacks too. V_ERR_NULL, V_ERR_ARGUMENT, V_ERR_RANGE.
 */
int v_pose_gl_matrix(const V_POSE *pose, double m[16]);

/**
 * The vertical field of view, in degrees, of a lens of zoom mm before a picture
 * that is height mm high: 2 atan (height / (2 zoom)). The zoom of a V_POSE goes with
 * the height 24.
 *
 * zoom, height  finite and > 0
 * Any thread; from callbacks too. NaN, and v_last_error() says why, for anything else.
 */
double v_fov_from_zoom(double zoom,
                       double height);

/**
 * The lens in mm that gives a picture height mm high the vertical field of view fov:
 * height / (2 tan (fov / 2)). With the height 24 it is the zoom of a V_POSE.
 *
 * fov     in degrees, between 0 and 180, both left out
 * height  finite and > 0
 * Any thread; from callbacks too. NaN, and v_last_error() says why, for anything else.
 */
double v_zoom_from_fov(double fov,
                       double height);

/**
 * The matrix of a camera in a pose, for programs whose cameras have other axes than
 * OpenGL's: 16 numbers by columns, for column vectors.
 *
 * convention  the camera's axes, V_AXES_...
 * to_world    0: from world coordinates into the camera's (the view matrix); with
 *     V_AXES_OPENGL that of v_pose_gl_matrix(), bit for bit. Else from the camera's
 *     into the world's: its columns are the axes and vrp
 * Any thread; from callbacks too. V_ERR_NULL, V_ERR_ARGUMENT, V_ERR_RANGE.
 */
int v_pose_matrix(const V_POSE *pose, int convention, int to_world, double m[16]);

/**
 * The projection of a camera in a pose, behind the view matrix of v_pose_gl_matrix(),
 * which looks along -z, whatever the convention: 16 numbers by columns, for column
 * vectors (the same numbers by rows, for row vectors, as Direct3D takes them). Of the
 * pose only the zoom counts: vertically 2 atan (12 / zoom) are seen.
 *
 * aspect      the picture's width by its height
 * near_plane  distance of the front plane, > 0
 * far_plane   that of the back plane, > near_plane; INFINITY: there is none
 * convention  V_CLIP_..., | V_CLIP_REVERSED
 * Any thread; from callbacks too. V_ERR_NULL, V_ERR_RANGE.
 */
int v_pose_projection(const V_POSE *pose,
                      double aspect,
                      double near_plane,
                      double far_plane,
                      int convention,
                      double m[16]);

#ifdef __cplusplus
}
#endif

/* ---- Structs that begin with size -------------------------------------------- */

/* Tells the library which fields the program knows. */
#define v_editor_options_init(options) \
    v_editor_options_init_sized(options, sizeof(V_EDITOR_OPTIONS))
#define v_space_init(space) v_space_init_sized(space, sizeof(V_SPACE))
#define v_limits_init(limits) v_limits_init_sized(limits, sizeof(V_LIMITS))
#define v_tour_init(tour) v_tour_init_sized(tour, sizeof(V_TOUR))

#endif  /* LIBVIDES_H */
