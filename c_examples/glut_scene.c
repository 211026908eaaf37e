/*
 * glut_scene: a scene of moving things, drawn with OpenGL.
 *
 *     cc -o glut_scene glut_scene.c -lvides -lm -lglut -lGL -lX11
 *
 * A car drives along its keys, its wheels turn, an arm of three parts swings, and a
 * camera looks at the car wherever it is. The program builds all of it, shows it in an
 * editor, and draws the state of every node at the frame of the editor's playhead,
 * whether that is played, scrubbed or changed; it fills the camera's picture within the
 * editor, too. The space key gives the car's way another
 * interpolation, s shows the spot lights' cones or not, Escape ends. "glut_scene FILE.vid"
 * draws the scene of a file instead, through the camera that it shows; "glut_scene --save
 * FILE.vid" writes the car's scene and ends.
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <GL/freeglut.h>
#include <GL/glx.h>

#include <libvides.h>

#define TICK 8 /* milliseconds */

static V_SCENE *scene;
static V_EDITOR *editor;
static int car;
static int floor_seen; /* the car's: a file's scene brings its own */
static double frame = 1.0;
static Window pane; /* of this program's, in the editor's window; None: there is none */
static int pane_width, pane_height;
static int way;        /* which interpolation the car's way has */
static int cones = 1;
static const char *const ways[] = {"catmull-rom", "linear", "tcb"};

static void check(int status)
{
    if (status != V_OK) {
        fprintf(stderr, "glut_scene: %s\n", v_last_error());
        exit(1);
    }
}

/* The corners and sides of a box, and the rim and spokes of a wheel. */
static const unsigned sides[36] = {
    0, 3, 1, 0, 2, 3, 4, 7, 6, 4, 5, 7, 0, 5, 4, 0, 1, 5,
    2, 7, 3, 2, 6, 7, 0, 6, 2, 0, 4, 6, 1, 7, 5, 1, 3, 7
};
static const double rim[39] = {
    0, 0.03, 0, 0, 0.025981, 0.015, 0, 0.015, 0.025981, 0, 0, 0.03,
    0, -0.015, 0.025981, 0, -0.025981, 0.015, 0, -0.03, 0, 0, -0.025981, -0.015,
    0, -0.015, -0.025981, 0, 0, -0.03, 0, 0.015, -0.025981, 0, 0.025981, -0.015,
    0, 0, 0
};
static const unsigned spokes[30] = {
    0, 1, 1, 2, 2, 3, 3, 4, 4, 5, 5, 6, 6, 7, 7, 8, 8, 9, 9, 10, 10, 11, 11, 0,
    12, 0, 12, 4, 12, 8
};

static int add(const char *name, int kind, int parent, double x, double y, double z,
               const V_NODE *values)
{
    V_NODE node;
    int number;

    v_node_init(&node, kind);
    if (values != NULL)
        node = *values;
    node.parent = parent;
    node.position[0] = x;
    node.position[1] = y;
    node.position[2] = z;
    check(v_scene_add_node(scene, name, &node, &number));
    return number;
}

/* A box from -width to width, from 0 to height and from -depth to depth. */
static void shape_box(int node, double width, double height, double depth)
{
    double xyz[24];
    V_MESH mesh;
    int i;

    for (i = 0; i < 8; i++) {
        xyz[3 * i] = i & 1 ? width : -width;
        xyz[3 * i + 1] = i & 2 ? height : 0.0;
        xyz[3 * i + 2] = i & 4 ? depth : -depth;
    }
    memset(&mesh, 0, sizeof mesh);
    mesh.size = sizeof mesh;
    mesh.xyz = xyz;
    mesh.points = 8;
    mesh.triangles = sides;
    mesh.corners = 36;
    check(v_scene_set_geometry(scene, node, &mesh));
}

static void shape_wheel(int node)
{
    V_MESH mesh;

    memset(&mesh, 0, sizeof mesh);
    mesh.size = sizeof mesh;
    mesh.xyz = rim;
    mesh.points = 13;
    mesh.lines = spokes;
    mesh.line_ends = 30;
    check(v_scene_set_geometry(scene, node, &mesh));
}

/* The keys of the car: where it is and how it is turned. */
static void drive(void)
{
    static const double frames[] = {1, 26, 51, 76};
    static const double places[] = {
        -0.8, 0, -0.3, -0.3, 0, 0.2, 0.2, 0, -0.1, 0.8, 0, 0.3
    };
    static const double turns[] = {
        0.92388, 0, 0.382683, 0, 0.773342, 0, 0.633989, 0,
        0.738423, 0, 0.674338, 0, 0.881675, 0, 0.471858, 0
    };
    static const double tense[12]; /* tension, continuity and bias of each key: 0 */
    const double *shape = way == 2 ? tense : NULL;

    check(v_scene_set_track(scene, car, "position", ways[way], frames, places, shape, 4,
                            V_AFTER_HOLD));
    check(v_scene_set_track(scene, car, "rotation", ways[way], frames, turns, shape, 4,
                            V_AFTER_HOLD));
}

static void build(void)
{
    static const double round[] = {1, 26}, angles[] = {0, 0, 0, 0, 1440, 0};
    static const double quarters[] = {1, 26, 51, 76};
    static const double bends[] = {0, 20, 0, 0, -30, 0, 0, 45, 0, 0, 20, 0};
    static const double halves[] = {1, 38.5, 76};
    static const double turns[] = {
        1, 0, 0, 0, 0.315322, 0, 0.948985, 0, 0.801144, 0, -0.598472, 0
    };
    static const double thirds[] = {1, 38, 76}, zooms[] = {24, 40, 24}, rolls[] = {0, 10, 0};
    static const double places[] = {-0.4, 0.5, 1.4, 0, 0.35, 1.1, 0.6, 0.6, 1.5};
    static const char *const wheels[] = {
        "wheel front left", "wheel front right", "wheel rear left", "wheel rear right"
    };
    V_NODE node;
    int body, arm, forearm, hand, wheel, camera, i;

    check(v_scene_new(&scene));
    check(v_scene_remove_node(scene, 0)); /* the camera on a path that it begins with */
    car = add("car", V_NODE_GROUP, -1, 0, 0, 0, NULL);
    drive();
    v_node_init(&node, V_NODE_OBJECT);
    node.colour[0] = 0.7;
    node.colour[1] = node.colour[2] = 0.1;
    body = add("body", V_NODE_OBJECT, car, 0, 0.06, 0, &node);
    shape_box(body, 0.06, 0.07, 0.14);
    for (i = 0; i < 4; i++) {
        wheel = add(wheels[i], V_NODE_OBJECT, car, i % 2 ? -0.07 : 0.07, 0.03,
                    i < 2 ? 0.09 : -0.09, NULL);
        shape_wheel(wheel);
        /* Four turns a second, for ever: angles count on where quaternions would not. */
        check(v_scene_set_track(scene, wheel, "rotation", "euler-linear", round, angles, NULL,
                                2, V_AFTER_OFFSET));
    }
    v_node_init(&node, V_NODE_LIGHT);
    node.light = V_LIGHT_SPOT;
    node.intensity = 2.0;
    node.cone[0] = 15.0;
    node.cone[1] = 25.0;
    add("headlight left", V_NODE_LIGHT, body, 0.04, 0.03, 0.141, &node);
    add("headlight right", V_NODE_LIGHT, body, -0.04, 0.03, 0.141, &node);

    v_node_init(&node, V_NODE_OBJECT);
    node.colour[0] = 0.8;
    node.colour[1] = 0.7;
    node.colour[2] = 0.1;
    arm = add("arm", V_NODE_OBJECT, -1, 0.4, 0, -0.4, &node);
    shape_box(arm, 0.03, 0.25, 0.03);
    forearm = add("forearm", V_NODE_OBJECT, arm, 0, 0.25, 0, &node);
    shape_box(forearm, 0.02, 0.2, 0.02);
    check(v_scene_set_track(scene, forearm, "rotation", "euler-catmull-rom", quarters, bends,
                            NULL, 4, V_AFTER_REPEAT));
    v_node_init(&node, V_NODE_OBJECT);
    node.pivot[1] = 0.02;
    hand = add("hand", V_NODE_OBJECT, forearm, 0, 0.2, 0, &node);
    shape_box(hand, 0.03, 0.08, 0.01);
    check(v_scene_set_track(scene, hand, "rotation", "linear", halves, turns, NULL, 3,
                            V_AFTER_PINGPONG));

    v_node_init(&node, V_NODE_LIGHT);
    node.rotation[0] = 0.9;
    node.rotation[1] = 0.4;
    node.intensity = 0.8;
    add("sun", V_NODE_LIGHT, -1, 0, 0, 0, &node);
    v_node_init(&node, V_NODE_CAMERA);
    node.aim = car;
    camera = add("camera", V_NODE_CAMERA, -1, 0, 0.5, 1.6, &node);
    check(v_scene_set_track(scene, camera, "position", "cubic", thirds, places, NULL, 3,
                            V_AFTER_HOLD));
    check(v_scene_set_track(scene, camera, "zoom", "ramp", thirds, zooms, NULL, 3,
                            V_AFTER_HOLD));
    check(v_scene_set_track(scene, camera, "roll", "sine", thirds, rolls, NULL, 3,
                            V_AFTER_HOLD));
    check(v_scene_set_marker(scene, "at the arm", 51.0));
    floor_seen = 1;
}

/* Memory that grows with what is asked of it. */
static void *room(void **had, size_t *bytes, size_t wanted)
{
    if (*bytes < wanted) {
        *had = realloc(*had, wanted);
        if (*had == NULL) {
            fprintf(stderr, "glut_scene: there is no memory for %lu bytes\n",
                    (unsigned long)wanted);
            exit(1);
        }
        *bytes = wanted;
    }
    return *had;
}

/* How bright a triangle is, by which way it faces in its own coordinates. */
static double shade(const double *a, const double *b, const double *c)
{
    double p[3], q[3], normal[3], length;
    int i;

    for (i = 0; i < 3; i++) {
        p[i] = b[i] - a[i];
        q[i] = c[i] - a[i];
    }
    for (i = 0; i < 3; i++)
        normal[i] = p[(i + 1) % 3] * q[(i + 2) % 3] - p[(i + 2) % 3] * q[(i + 1) % 3];
    length = sqrt(normal[0] * normal[0] + normal[1] * normal[1] + normal[2] * normal[2]);
    return length > 0.0 ? 0.65 + (0.1 * normal[0] + 0.25 * normal[1] + 0.08 * normal[2]) / length
                        : 0.65;
}

/* An object: its triangles, its lines, or where it has neither, its points. */
static void draw_object(int node, const double *colour)
{
    static void *memory;
    static size_t bytes;
    const double *xyz, *corner[3];
    size_t points, i, j;
    double light;
    V_MESH mesh;

    mesh.size = sizeof mesh;
    check(v_scene_get_geometry(scene, node, &mesh));
    check(v_scene_vertices(scene, node, frame, NULL, NULL, 0, &points));
    if (points == 0)
        return;
    xyz = room(&memory, &bytes, 3 * points * sizeof *xyz);
    check(v_scene_vertices(scene, node, frame, memory, NULL, points, NULL));
    glBegin(GL_TRIANGLES);
    for (i = 0; i + 2 < mesh.corners; i += 3) {
        for (j = 0; j < 3; j++)
            corner[j] = xyz + 3 * mesh.triangles[i + j];
        light = shade(corner[0], corner[1], corner[2]);
        glColor3d(light * colour[0], light * colour[1], light * colour[2]);
        for (j = 0; j < 3; j++)
            glVertex3dv(corner[j]);
    }
    glEnd();
    glColor3d(0.6 * colour[0], 0.6 * colour[1], 0.6 * colour[2]);
    glBegin(GL_LINES);
    for (i = 0; i < mesh.line_ends; i++)
        glVertex3dv(xyz + 3 * mesh.lines[i]);
    glEnd();
    glBegin(GL_POINTS);
    for (i = 0; i < points && mesh.corners == 0 && mesh.line_ends == 0; i++)
        glVertex3dv(xyz + 3 * i);
    glEnd();
}

/* Four lines along the outer cone of a light, in its own coordinates. */
static void draw_cone(const V_NODE_STATE *state)
{
    double radius = 0.3 * tan(state->cone[1] * 3.14159265358979 / 180.0);
    int i;

    glColor3d(1.0, 1.0, 0.6);
    glBegin(GL_LINES);
    for (i = 0; i < 4; i++) {
        glVertex3d(0.0, 0.0, 0.0);
        glVertex3d(i & 1 ? radius : -radius, i & 2 ? radius : -radius, 0.3);
    }
    glEnd();
}

static void draw_floor(void)
{
    int i;

    glColor3d(0.3, 0.3, 0.35);
    glBegin(GL_LINES);
    for (i = -10; i <= 10; i++) {
        glVertex3d(0.1 * i, 0.0, -1.0);
        glVertex3d(0.1 * i, 0.0, 1.0);
        glVertex3d(-1.0, 0.0, 0.1 * i);
        glVertex3d(1.0, 0.0, 0.1 * i);
    }
    glEnd();
}

/* What the shown camera sees, in the window that GL draws in. */
static void draw_scene(int width, int height)
{
    static void *memory;
    static size_t bytes;
    V_NODE_STATE *states;
    V_NODE node;
    double view[16], projection[16];
    int count, camera, i;

    check(v_scene_count(scene, 0, "nodes", &count));
    check(v_scene_get_camera(scene, &camera));
    glViewport(0, 0, width, height);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    if (camera < 0)
        return;
    states = room(&memory, &bytes, count * sizeof *states);
    check(v_scene_evaluate(scene, frame, states, count, NULL));
    v_node_init(&node, V_NODE_CAMERA);
    check(v_scene_get_node(scene, camera, &node));
    check(v_pose_matrix(&states[camera].pose, V_AXES_OPENGL, 0, view));
    check(v_pose_projection(&states[camera].pose, (double)width / height, node.near_plane,
                            node.far_plane, V_CLIP_OPENGL, projection));
    glMatrixMode(GL_PROJECTION);
    glLoadMatrixd(projection);
    glMatrixMode(GL_MODELVIEW);
    glLoadMatrixd(view);
    if (floor_seen)
        draw_floor();
    for (i = 0; i < count; i++) {
        check(v_scene_get_node(scene, i, &node));
        if (!states[i].visible)
            continue;
        glPushMatrix();
        glMultMatrixd(states[i].matrix);
        if (node.kind == V_NODE_OBJECT)
            draw_object(i, states[i].colour);
        else if (cones && node.kind == V_NODE_LIGHT && node.light == V_LIGHT_SPOT)
            draw_cone(&states[i]);
        glPopMatrix();
    }
}

static void display(void)
{
    draw_scene(glutGet(GLUT_WINDOW_WIDTH), glutGet(GLUT_WINDOW_HEIGHT));
    glutSwapBuffers();
}

/* Redraws both pictures: GLUT draws its window once it is visible, the editor at once. */
static void redraw(void)
{
    Display *server = glXGetCurrentDisplay();
    GLXDrawable window = glXGetCurrentDrawable();

    glutPostRedisplay();
    if (pane != None) {
        glXMakeCurrent(server, pane, glXGetCurrentContext());
        draw_scene(pane_width, pane_height);
        glXSwapBuffers(server, pane);
        glXMakeCurrent(server, window, glXGetCurrentContext());
    }
}

/* The camera's picture in the editor has opened, has another size, or has closed (window
 * 0): in it lies a window of the same kind as GLUT's own. */
static void on_pane(V_EDITOR *of, unsigned long window, int width, int height, void *user)
{
    Display *server = glXGetCurrentDisplay();
    XWindowAttributes like;
    XSetWindowAttributes own;

    (void)of, (void)user;
    pane_width = width;
    pane_height = height;
    if (window != 0 && pane == None) {
        XGetWindowAttributes(server, glXGetCurrentDrawable(), &like);
        own.border_pixel = 0;
        own.colormap = like.colormap;
        pane = XCreateWindow(server, window, 0, 0, width, height, 0, like.depth, InputOutput,
                             like.visual, CWBorderPixel | CWColormap, &own);
        XMapWindow(server, pane);
    } else if (window == 0 && pane != None) {
        XDestroyWindow(server, pane);
        pane = None;
    }
    redraw();
}

/* The scene in the editor is another one. */
static void on_change(V_EDITOR *of, void *user)
{
    V_SCENE *changed;

    (void)user;
    if (v_editor_get_scene(of, &changed) == V_OK) {
        v_scene_free(scene);
        scene = changed;
    }
    redraw();
}

/* The editor's playhead has moved, or what stands there is being changed. */
static void on_frame(V_EDITOR *of, double at, int reason, void *user)
{
    frame = at;
    if (reason == V_VIEW_EDITED)
        on_change(of, user);
    else
        redraw();
}

/* GLUT watches no descriptor: a timer serves the editor. */
static void tick(int unused)
{
    v_dispatch();
    glutTimerFunc(TICK, tick, unused);
}

static void key(unsigned char character, int x, int y)
{
    (void)x, (void)y;
    if (character == 27)
        exit(0);
    if (character == 's') {
        cones = !cones;
        redraw();
    }
    /* The editor may have taken the car away, or renamed it. */
    if (character == ' ' && v_scene_find_node(scene, "car", &car) == V_OK) {
        way = (way + 1) % 3;
        drive();
        if (v_editor_set_scene(editor, scene) != V_OK)
            fprintf(stderr, "glut_scene: %s\n", v_last_error());
        glutSetWindowTitle(ways[way]);
        redraw();
    }
}

int main(int argc, char **argv)
{
    V_EDITOR_OPTIONS options;

    if (argc == 2)
        check(v_scene_load(argv[1], &scene));
    else
        build();
    if (argc == 3 && strcmp(argv[1], "--save") == 0) {
        check(v_scene_save(scene, argv[2]));
        return 0;
    }
    glutInit(&argc, argv);
    glutInitDisplayMode(GLUT_DOUBLE | GLUT_RGB | GLUT_DEPTH);
    glutInitWindowSize(600, 400);
    glutCreateWindow("glut_scene");
    glEnable(GL_DEPTH_TEST);
    glutDisplayFunc(display);
    glutKeyboardFunc(key);

    v_editor_options_init(&options);
    options.title = "glut_scene";
    options.on_frame = on_frame;
    options.on_change = on_change;
    options.on_pane = on_pane;
    check(v_editor_open(&options, &editor));
    check(v_editor_set_scene(editor, scene));
    glutTimerFunc(TICK, tick, 0);
    glutMainLoop();
    return 0;
}
