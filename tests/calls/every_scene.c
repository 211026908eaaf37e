/* The functions of scenes and deformations: see every.h. */
#include <string.h>

#include "functions.h"
#include "scene_things.h"
#include "things.h"

#define NODES 3
#define POINTS 4

static V_SCENE *scene;

static const double twist[] = {2, 30}, box[] = {-1, -1, -1, 1, 1, 1};

V_SCENE *a_scene(void)
{
    static const double xyz[3 * POINTS] = {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0};
    static const double frames[] = {1, 11}, way[] = {0, 0, 0, 1, 2, 3};
    static const unsigned corners[] = {0, 1, 2, 0, 2, 3};
    V_NODE node;
    V_MESH mesh;

    make_stale(scene);
    v_scene_free(scene);
    scene = NULL;
    v_scene_new(&scene);
    v_node_init(&node, V_NODE_OBJECT);
    v_scene_add_node(scene, "sheet", &node, NULL);
    v_node_init(&node, V_NODE_LIGHT);
    node.parent = 1;
    v_scene_add_node(scene, "lamp", &node, NULL);
    memset(&mesh, 0, sizeof mesh);
    mesh.size = sizeof mesh;
    mesh.xyz = xyz;
    mesh.points = POINTS;
    mesh.triangles = corners;
    mesh.corners = 6;
    v_scene_set_geometry(scene, 1, &mesh);
    v_scene_add_shape(scene, 1, "flat", xyz, NULL, POINTS);
    v_scene_add_deformation(scene, 1, "twist", twist, 2, box, NULL);
    v_scene_set_track(scene, 1, "position", "linear", frames, way, NULL, 2, V_AFTER_HOLD);
    v_scene_set_marker(scene, "meet", 20);
    return handle(scene);
}

int a_node(void) { return whole(0, NODES - 1); }

/* One of these, or as often as `wild` says one that will not do. */
static const char *one_of(const char *const *fit, int count)
{
    static const char *const odd[] = {"", "\377", "a\nb", "host:", "value:", "deformation.9.x",
                                      "position.", "spline", NULL};
    if (chance(wild)) {
        frame->unfit = 1;
        return text(odd[below(9)]);
    }
    return text(fit[below((unsigned)count)]);
}

const char *a_name(void)
{
    static const char *const names[] = {"wheel", "\xc3\xbc", "a b"};
    return one_of(names, 3);
}

static const V_NODE *a_node_struct(void)
{
    V_NODE node;
    int i;

    v_node_init(&node, V_NODE_OBJECT);
    if (chance(wild)) {
        frame->unfit = 1;
        node.size = below(800);
    }
    if (chance(wild)) {
        frame->unfit = 1;
        node.kind = (int)below(9) - 2;
    }
    for (i = 0; i < 3; i++) {
        node.pivot[i] = number(-1, 1);
        node.position[i] = number(-1, 1);
        node.scale[i] = number(0.5, 2);
    }
    node.rotation[1] = number(-1, 1);
    node.visible = whole(0, 1);
    if (chance(wild)) {
        frame->unfit = 1;
        node.parent = (int)below(6) - 2;
    }
    return given("V_NODE", &node, sizeof node);
}

const V_MESH *a_mesh(void)
{
    static const unsigned lines[] = {0, 1, 2, 3};
    V_MESH mesh;

    memset(&mesh, 0, sizeof mesh);
    mesh.size = sizeof mesh;
    mesh.points = POINTS;
    mesh.xyz = numbers(3 * POINTS, -1, 1);
    mesh.lines = lines;
    mesh.line_ends = 4;
    if (chance(wild)) {
        frame->unfit = 1;
        mesh.line_ends = 3;
    }
    if (chance(wild)) {
        frame->unfit = 1;
        mesh.size = below(200);
    }
    return given("V_MESH", &mesh, sizeof mesh);
}

static int interpolate(const double *frames, const double *values, size_t width, size_t keys,
                       double at, double *value, void *user)
{
    size_t i;
    (void)frames, (void)keys, (void)at, (void)user;
    for (i = 0; i < width; i++)
        value[i] = values[i];
    return V_OK;
}

CALL(v_node_init)
{
    V_NODE *node = result(sizeof *node, 0);
    v_node_init(node, whole(V_NODE_GROUP, V_NODE_CAMERA));
    return 0;
}

/* A scene that a call gives is kept until the next one: a call ends with its own
 * function. */
static V_SCENE *made_last;

static void drop_made(void)
{
    make_stale(made_last);
    v_scene_free(made_last);
    made_last = NULL;
}

static int gave(V_SCENE **made, int status)
{
    if (status == V_OK)
        made_last = *made;
    return status;
}

CALL(v_scene_new)
{
    V_SCENE **made = result(sizeof *made, 0);
    drop_made();
    return gave(made, v_scene_new(made));
}

CALL(v_scene_load)
{
    const char *file = a_file("a.vid");
    V_SCENE **made = result(sizeof *made, 0);
    drop_made();
    return gave(made, v_scene_load(file, made));
}

CALL(v_scene_load_from_memory)
{
    static const char fit[] = "version = 1\n[[point]]\nposition = [0.0, 0.0, 0.0]\n"
                              "[[point.orientation]]\noffset = [0.0, 0.0, -1.0]\n"
                              "[[point]]\nposition = [1.0, 0.0, 0.0]\n"
                              "[[point.orientation]]\noffset = [0.0, 0.0, -1.0]\n";
    const char *lines = given("text", fit, sizeof fit - 1);
    V_SCENE **made = result(sizeof *made, 0);
    drop_made();
    return gave(made, v_scene_load_from_memory(lines, sizeof fit - 1, made));
}

CALL(v_scene_save_to_memory)
{
    const V_SCENE *from = a_scene();
    char *lines = result(50000, 0);
    return v_scene_save_to_memory(from, lines, 50000, result(sizeof(size_t), 0));
}

CALL(v_scene_save)
{
    const V_SCENE *from = a_scene();
    return v_scene_save(from, a_file("b.vid"));
}

CALL(v_scene_clone)
{
    const V_SCENE *from = a_scene();
    V_SCENE **made = result(sizeof *made, 0);
    drop_made();
    return gave(made, v_scene_clone(from, made));
}

CALL(v_scene_free)
{
    V_SCENE *gone = a_scene();
    if (gone == scene) {
        make_stale(scene);
        scene = NULL;
    }
    v_scene_free(gone);
    return 0;
}

CALL(v_scene_add_node)
{
    V_SCENE *to = a_scene();
    const char *name = a_name();
    const V_NODE *values = a_node_struct();
    return v_scene_add_node(to, name, values, result(sizeof(int), 1));
}

CALL(v_scene_remove_node)
{
    V_SCENE *from = a_scene();
    return v_scene_remove_node(from, a_node());
}

CALL(v_scene_find_node)
{
    static const char *const names[] = {"camera", "sheet", "lamp"};
    const V_SCENE *in = a_scene();
    const char *name = one_of(names, 3);
    return v_scene_find_node(in, name, result(sizeof(int), 0));
}

CALL(v_scene_get_name)
{
    const V_SCENE *of = a_scene();
    int node = a_node();
    return v_scene_get_name(of, node, result(sizeof(char *), 0));
}

CALL(v_scene_set_name)
{
    V_SCENE *of = a_scene();
    int node = a_node();
    return v_scene_set_name(of, node, a_name());
}

CALL(v_scene_get_node)
{
    const V_SCENE *of = a_scene();
    int node = a_node();
    V_NODE values;

    v_node_init(&values, V_NODE_GROUP);
    if (chance(wild)) {
        frame->unfit = 1;
        values.size++;
    }
    return v_scene_get_node(of, node, given("V_NODE", &values, sizeof values));
}

CALL(v_scene_set_node)
{
    V_SCENE *of = a_scene();
    return v_scene_set_node(of, whole(1, 1), a_node_struct());
}

CALL(v_scene_set_path)
{
    V_SCENE *of = a_scene();
    int node = whole(0, 0);
    const V_PATH *path = chance(20) ? NULL : a_path();
    double start = number(-100, 100);
    return v_scene_set_path(of, node, path, start, whole(V_AFTER_HOLD, V_AFTER_PINGPONG));
}

CALL(v_scene_get_path)
{
    const V_SCENE *of = a_scene();
    int node = whole(0, 0);
    V_PATH **path = result(sizeof *path, 1);
    double *start = result(sizeof *start, 1);
    int status = v_scene_get_path(of, node, path, start, result(sizeof(int), 1));

    if (status == V_OK && path != NULL)
        frame->made_path = *path;
    return status;
}

CALL(v_scene_set_marker)
{
    V_SCENE *of = a_scene();
    const char *name = a_name();
    return v_scene_set_marker(of, name, number(-100, 100));
}

CALL(v_scene_pin)
{
    static const char *const names[] = {"meet", NULL};
    V_SCENE *of = a_scene();
    int node = whole(0, 0), point = whole(0, 1);
    return v_scene_pin(of, node, point, one_of(names, 2));
}

CALL(v_scene_set_track)
{
    static const char *const channels[] = {"position", "scale", "value:wind:3", "colour"};
    static const char *const ways[] = {"step", "linear", "ramp", "sine", "catmull-rom", "cubic"};
    V_SCENE *of = a_scene();
    int node = whole(1, 1), keys = 1 + (int)below(5);
    const char *channel = one_of(channels, 4), *way = one_of(ways, 6);
    const double *frames = increasing(keys), *values = numbers(3 * keys, 0, 1);
    return v_scene_set_track(of, node, channel, way, frames, values, NULL, (size_t)keys,
                             whole(V_AFTER_HOLD, V_AFTER_OFFSET));
}

CALL(v_scene_get_track)
{
    static const char *const channels[] = {"position", "rotation", "deformation.0.angle"};
    const V_SCENE *of = a_scene();
    int node = whole(1, 1);
    const char *channel = one_of(channels, 3);
    const char **way = result(sizeof *way, 1);
    double *frames = result(2 * sizeof(double), 1), *values = result(8 * sizeof(double), 1);
    size_t *keys = result(sizeof *keys, 1);
    int *after = result(sizeof *after, 1);
    return too_small(v_scene_get_track(of, node, channel, way, 2, frames, values, NULL, keys, after),
                     keys, 2);
}

CALL(v_register_interpolation)
{
    const char *name = a_name();
    return v_register_interpolation(name, chance(50) ? interpolate : NULL, NULL);
}

CALL(v_scene_set_geometry)
{
    V_SCENE *of = a_scene();
    int node = whole(1, 1);
    return v_scene_set_geometry(of, node, a_mesh());
}

CALL(v_scene_load_geometry)
{
    V_SCENE *of = a_scene();
    int node = whole(1, 1);
    return v_scene_load_geometry(of, node, a_file("a.obj"));
}

CALL(v_scene_add_shape)
{
    V_SCENE *of = a_scene();
    int node = whole(1, 1);
    const char *name = a_name();
    const double *xyz = numbers(3 * POINTS, -1, 1);
    static const unsigned char grey[3 * POINTS] = {9, 9, 9};
    const unsigned char *rgb = chance(50) ? NULL : given("rgb", grey, sizeof grey);
    return v_scene_add_shape(of, node, name, xyz, rgb, POINTS);
}

/* A deformation of two numbers. */
static const char *a_kind(const double **parameters)
{
    static const char *const kinds[] = {"taper", "twist", "bend"};
    double two[2];

    two[0] = below(3);
    two[1] = number(-1, 2);
    *parameters = given("parameters", two, sizeof two);
    return one_of(kinds, 3);
}

CALL(v_scene_add_deformation)
{
    V_SCENE *of = a_scene();
    int node = whole(1, 1);
    const double *parameters;
    const char *kind = a_kind(&parameters);
    const double *bounds = chance(30) ? NULL : given("box", box, sizeof box);
    return v_scene_add_deformation(of, node, kind, parameters, 2, bounds, result(sizeof(int), 1));
}

CALL(v_scene_remove_deformation)
{
    V_SCENE *of = a_scene();
    int node = whole(1, 1);
    return v_scene_remove_deformation(of, node, whole(0, 0));
}

CALL(v_deform)
{
    const double *parameters;
    const char *kind = a_kind(&parameters);
    const double *bounds = given("box", box, sizeof box);
    double xyz[6] = {0.5, 0.25, 0, -1, 0, 1};
    xyz[0] = number(-1, 1);
    return v_deform(kind, parameters, 2, bounds, given("points", xyz, sizeof xyz), 2);
}

CALL(v_scene_frame_range)
{
    const V_SCENE *of = a_scene();
    double *first = result(sizeof *first, 1);
    return v_scene_frame_range(of, first, result(sizeof *first, 1));
}

CALL(v_scene_evaluate)
{
    const V_SCENE *of = a_scene();
    double at = number(-50, 500);
    V_NODE_STATE *states = result(NODES * sizeof *states, 1);
    size_t *count = result(sizeof *count, 1);
    return too_small(v_scene_evaluate(of, at, states, NODES, count), count, NODES);
}

CALL(v_scene_sample)
{
    const V_SCENE *of = a_scene();
    int node = a_node();
    double first = number(-50, 500), step = number(-2, 2);
    return v_scene_sample(of, node, first, step, result(5 * sizeof(V_NODE_STATE), 0), 5);
}

CALL(v_scene_value)
{
    static const char *const channels[] = {"position", "scale", "weights", "deformation.0.angle"};
    const V_SCENE *of = a_scene();
    int node = whole(1, 1);
    const char *channel = one_of(channels, 4);
    double at = number(-50, 500);
    double *values = result(3 * sizeof *values, 1);
    size_t *width = result(sizeof *width, 1);
    return too_small(v_scene_value(of, node, channel, at, values, 3, width), width, 3);
}

CALL(v_scene_vertices)
{
    const V_SCENE *of = a_scene();
    int node = whole(1, 1);
    double at = number(-50, 500);
    double *xyz = result(3 * POINTS * sizeof *xyz, 1);
    size_t *points = result(sizeof *points, 1);
    return too_small(v_scene_vertices(of, node, at, xyz, result(3 * POINTS, 1), POINTS, points), points, POINTS);
}

/* NULL, or one that will do. */
static const char *a_choice(const char *const *of, int count)
{
    return chance(50) ? text(NULL) : one_of(of, count);
}

CALL(v_scene_export)
{
    static const char *const formats[] = {"csv", "json", "ascii", "vid"};
    static const char *const options[] = {"", "fps=50", "up=z\nscale=2\n"};
    const V_SCENE *of = a_scene();
    const char *file = a_file("out.csv");
    const char *format = a_choice(formats, 4);
    /* A .vid file holds all of a scene, of which nothing can be chosen. */
    int some = format == NULL || strcmp(format, "vid") != 0;
    return v_scene_export(of, file, format, a_choice(options, some ? 3 : 1));
}

CALL(v_scene_import)
{
    static const char *const formats[] = {"vid"};
    static const char *const options[] = {"", "as=keys", "tolerance=0.1\nangle=1"};
    const char *file = a_file("a.vid");
    const char *format = a_choice(formats, 1);
    const char *how = a_choice(options, 3);
    V_SCENE **made = result(sizeof *made, 0);
    drop_made();
    return gave(made, v_scene_import(file, format, how, made));
}

CALL(v_editor_get_scene)
{
    const V_EDITOR *editor = an_editor();
    V_SCENE **copy = result(sizeof *copy, 0);
    drop_made();
    return gave(copy, v_editor_get_scene(editor, copy));
}

CALL(v_editor_set_scene)
{
    V_EDITOR *editor = an_editor();
    return v_editor_set_scene(editor, a_scene());
}
