/*
 * What can be set in a scene can be read: a copy made of nothing but what the
 * functions give is the same file. The camera and the range that are shown,
 * another parent, and what goes: shapes, markers.
 */
#include "check.h"

static char *text_of(const V_SCENE *scene)
{
    size_t length = 0;
    char *text;
    OK(v_scene_save_to_memory(scene, NULL, 0, &length));
    text = malloc(length + 1);
    OK(v_scene_save_to_memory(scene, text, length + 1, &length));
    return text;
}

static V_NODE get(const V_SCENE *scene, int at)
{
    V_NODE node;
    v_node_init(&node, V_NODE_GROUP);
    OK(v_scene_get_node(scene, at, &node));
    return node;
}

static int add(V_SCENE *scene, const char *name, int kind, int parent)
{
    V_NODE node;
    int at = -1;
    v_node_init(&node, kind);
    node.parent = parent;
    OK(v_scene_add_node(scene, name, &node, &at));
    return at;
}

static const double xyz[] = {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, -0.0};
static const double high[] = {0, 0, 2, 1, 0, 2, 1, 1, 2, 0, 1, 2};
static const double two[] = {1, 11.5};

/* A scene with all that a host can set in one. */
static V_SCENE *everything(void)
{
    static const unsigned char rgb[] = {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 255};
    static const unsigned char colours[] = {9, 8, 7, 6, 5, 4, 3, 2, 1, 0, 255, 254};
    static const unsigned lines[] = {0, 1}, corners[] = {0, 1, 2, 0, 2, 3};
    static const double twist[] = {1, 90}, taper[] = {0, 1, 0.5}, box[] = {-1, 0, -1, 1, 2, 3};
    static const double weights[] = {0, 0.25, 0.5, 1, 2, 3}, way[] = {0, 0, 0, 4, 0, 0};
    static const double slopes[] = {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12}, zooms[] = {24, 50};
    static const double tcb[] = {-1, 0.5, 1, 0, -0.0, 0.25};
    static const double centre[] = {1, 2, 3}, one = 90;
    V_SCENE *scene = NULL;
    V_PATH *path = new_path();
    V_MESH mesh;
    V_NODE node;
    int car, sheet, lamp, late, eye;
    OK(v_scene_new(&scene));
    OK(set_scene_space(scene, centre, 2, V_UP_Z));
    car = add(scene, "car", V_NODE_GROUP, -1);
    sheet = add(scene, "sheet", V_NODE_OBJECT, car);
    lamp = add(scene, "lamp", V_NODE_LIGHT, car);
    late = add(scene, "late", V_NODE_GROUP, -1);
    eye = add(scene, "eye", V_NODE_CAMERA, -1);
    node = get(scene, sheet);
    node.pivot[1] = -0.0;
    node.rotation[2] = 1.0 / 3;
    node.visible = 0;
    OK(v_scene_set_node(scene, sheet, &node));
    node = get(scene, lamp);
    node.light = V_LIGHT_SPOT;
    node.intensity = 3;
    node.aim = late;
    OK(v_scene_set_node(scene, lamp, &node));
    /* In one that stands further down. */
    OK(v_scene_set_parent(scene, car, late, V_KEEP_NUMBERS));
    memset(&mesh, 0, sizeof mesh);
    mesh.size = sizeof mesh;
    mesh.xyz = xyz;
    mesh.points = 4;
    mesh.rgb = rgb;
    mesh.lines = lines;
    mesh.line_ends = 2;
    mesh.triangles = corners;
    mesh.corners = 6;
    OK(v_scene_set_geometry(scene, sheet, &mesh));
    OK(v_scene_add_shape(scene, sheet, "high", high, NULL, 4));
    OK(v_scene_add_shape(scene, sheet, "", xyz, NULL, 4));
    OK(v_scene_add_shape(scene, sheet, "again", high, colours, 4));
    OK(v_scene_add_deformation(scene, sheet, "twist", twist, 2, box, NULL));
    OK(v_scene_add_deformation(scene, sheet, "taper", taper, 3, NULL, NULL));
    OK(v_scene_set_track(scene, sheet, "weights", "linear", two, weights, NULL, 2,
                         V_AFTER_REPEAT | V_BEFORE_PINGPONG));
    OK(v_scene_set_track(scene, sheet, "deformation.0.angle", "step", two, &one, NULL, 1, 0));
    OK(v_scene_set_track(scene, sheet, "position", "hermite", two, way, slopes, 2, 0));
    OK(v_scene_set_track(scene, sheet, "value:wind:3", "tcb", two, way, tcb, 2, 0));
    OK(v_scene_set_track(scene, eye, "zoom", "linear", two, zooms, NULL, 2, V_AFTER_OFFSET));
    OK(v_scene_set_path(scene, late, path, 3.5, V_AFTER_PINGPONG));
    OK(v_scene_set_marker(scene, "meet", 12));
    OK(v_scene_set_marker(scene, "again", 0.1));
    OK(v_scene_pin(scene, 0, 1, "meet"));
    OK(v_scene_pin(scene, late, 0, "again"));
    OK(v_scene_set_text(scene, "title", "everything"));
    OK(v_scene_set_text(scene, "comment", "In\ntwo lines"));
    OK(v_scene_set_number(scene, "fps", 24));
    OK(v_scene_set_number(scene, "first_frame", -7));
    OK(v_scene_set_number(scene, "check.turning", 7));
    OK(v_scene_set_number(scene, "check.pole", INFINITY));
    OK(v_scene_set_camera(scene, eye));
    OK(v_scene_set_range(scene, -0.5, 40));
    v_path_free(path);
    return scene;
}

static void copy_object(const V_SCENE *from, V_SCENE *to, int at)
{
    V_MESH mesh;
    const char *text = NULL;
    char name[300];
    double points[12], parameters[192], box[6];
    unsigned char rgb[12];
    size_t count = 0;
    int all = 0, coloured = -1, k;
    mesh.size = sizeof mesh;
    OK(v_scene_get_geometry(from, at, &mesh));
    if (mesh.points > 0)
        OK(v_scene_set_geometry(to, at, &mesh));
    OK(v_scene_count(from, at, "shapes", &all));
    for (k = 0; k < all; k++) {
        OK(v_scene_get_shape(from, at, k, &text, points, rgb, 4, &count, &coloured));
        strcpy(name, text);
        OK(v_scene_add_shape(to, at, name, points, coloured ? rgb : NULL, count));
    }
    OK(v_scene_count(from, at, "deformations", &all));
    for (k = 0; k < all; k++) {
        OK(v_scene_get_deformation(from, at, k, &text, parameters, 192, &count, box));
        strcpy(name, text);
        OK(v_scene_add_deformation(to, at, name, parameters, count, box[0] > box[3] ? NULL : box,
                                   NULL));
    }
}

static void copy_motion(const V_SCENE *from, V_SCENE *to, int at)
{
    double frames[8], values[64], shape[64], start = 0;
    const char *text = NULL;
    char channel[300], by[300];
    size_t keys = 0;
    V_PATH *path = NULL;
    int all = 0, after = 0, k;
    if (v_scene_get_path(from, at, &path, &start, &after) == V_OK) {
        OK(v_scene_set_path(to, at, path, start, after));
        v_path_free(path);
    }
    OK(v_scene_count(from, at, "tracks", &all));
    for (k = 0; k < all; k++) {
        OK(v_scene_get_channel(from, at, k, &text));
        strcpy(channel, text);
        OK(v_scene_get_track(from, at, channel, &text, 8, frames, values, shape, &keys, &after));
        strcpy(by, text);
        OK(v_scene_set_track(to, at, channel, by, frames, values, shape, keys, after));
    }
}

static void copy_rest(const V_SCENE *from, V_SCENE *to)
{
    static const char *const limits[] = {"check.space", "check.turning", "check.pole",
        "check.jerk"};
    const char *name = NULL;
    char title[300], comment[300];
    double centre[3], half_size = 0, frame = 0, limit = 0, first = 0, last = 0, fps = 0, number = 0;
    int up = 0, all = 0, node = -1, point = -1, k;
    size_t length = 0;
    OK(get_scene_space(from, centre, &half_size, &up));
    OK(set_scene_space(to, centre, half_size, up));
    OK(v_scene_count(from, 0, "markers", &all));
    for (k = 0; k < all; k++) {
        OK(v_scene_get_marker(from, k, &name, &frame));
        strcpy(title, name);
        OK(v_scene_set_marker(to, title, frame));
    }
    OK(v_scene_count(from, 0, "pins", &all));
    for (k = 0; k < all; k++) {
        OK(v_scene_get_pin(from, k, &node, &point, &name));
        strcpy(title, name);
        OK(v_scene_pin(to, node, point, title));
    }
    OK(v_scene_get_text(from, "title", title, sizeof title, &length));
    OK(v_scene_set_text(to, "title", title));
    OK(v_scene_get_text(from, "comment", comment, sizeof comment, &length));
    OK(v_scene_set_text(to, "comment", comment));
    OK(v_scene_get_number(from, "fps", &fps));
    OK(v_scene_set_number(to, "fps", fps));
    OK(v_scene_get_number(from, "first_frame", &number));
    OK(v_scene_set_number(to, "first_frame", number));
    for (k = 0; k < 4; k++) {
        OK(v_scene_get_number(from, limits[k], &limit));
        OK(v_scene_set_number(to, limits[k], limit));
    }
    OK(v_scene_get_camera(from, &node));
    OK(v_scene_set_camera(to, node));
    OK(v_scene_frame_range(from, &first, &last));
    OK(v_scene_set_range(to, first, last));
}

static V_SCENE *copied(const V_SCENE *from)
{
    V_SCENE *to = NULL;
    const char *name = NULL;
    char own[300];
    int nodes = 0, at;
    OK(v_scene_new(&to));
    OK(v_scene_remove_node(to, 0));
    OK(v_scene_count(from, 0, "nodes", &nodes));
    for (at = 0; at < nodes; at++) {
        V_NODE node = get(from, at);
        node.parent = node.aim = -1;
        OK(v_scene_get_name(from, at, &name));
        strcpy(own, name);
        OK(v_scene_add_node(to, own, &node, NULL));
        if (node.kind == V_NODE_OBJECT)
            copy_object(from, to, at);
        copy_motion(from, to, at);
    }
    for (at = 0; at < nodes; at++) {
        V_NODE node = get(from, at);
        OK(v_scene_set_parent(to, at, node.parent, V_KEEP_NUMBERS));
        OK(v_scene_set_node(to, at, &node));
    }
    copy_rest(from, to);
    return to;
}

static void what_is_set_is_read(void)
{
    V_SCENE *scene = everything(), *copy = copied(scene);
    char *one = text_of(scene), *other = text_of(copy);
    CHECK(strcmp(one, other) == 0);
    CHECK(strstr(one, "camera = \"eye\"") && strstr(one, "range = [-0.5, 40.0]"));
    free(one);
    free(other);
    v_scene_free(copy);
    v_scene_free(scene);
}

static void places_that_are_none(void)
{
    V_SCENE *scene = everything();
    const char *text = NULL;
    int number = 0, kind;
    double frame = 0, numbers[6];
    size_t count = 0;
    V_MESH mesh;
    for (kind = -1; kind <= 4; kind += 5) {
        STATUS(V_ERR_RANGE, v_scene_get_channel(scene, 2, kind, &text));
        STATUS(V_ERR_RANGE, v_scene_get_marker(scene, kind, &text, &frame));
        STATUS(V_ERR_RANGE, v_scene_get_pin(scene, kind, &number, &number, &text));
        STATUS(V_ERR_RANGE, v_scene_get_shape(scene, 2, kind, &text, NULL, NULL, 0, &count, NULL));
        STATUS(V_ERR_RANGE, v_scene_get_deformation(scene, 2, kind, NULL, NULL, 0, NULL, NULL));
        STATUS(V_ERR_RANGE, v_scene_remove_shape(scene, 2, kind));
    }
    STATUS(V_ERR_RANGE, v_scene_get_marker(scene, 2, &text, &frame));
    CHECK(strcmp(v_last_error(), "there is no marker 2 among 2, counted from 0") == 0);
    STATUS(V_ERR_RANGE, v_scene_count(scene, 6, "tracks", &number));
    STATUS(V_ERR_ARGUMENT, v_scene_get_path(scene, 1, NULL, &frame, &number));
    STATUS(V_ERR_ARGUMENT, v_scene_count(scene, 0, "shapes", &number));
    CHECK(strcmp(v_last_error(), "\"camera\" is no object") == 0);
    STATUS(V_ERR_ARGUMENT, v_scene_count(scene, 0, "deformations", &number));
    mesh.size = sizeof mesh;
    STATUS(V_ERR_ARGUMENT, v_scene_get_geometry(scene, 0, &mesh));
    mesh.size = 3;
    STATUS(V_ERR_SIZE, v_scene_get_geometry(scene, 2, &mesh));
    STATUS(V_ERR_NULL, v_scene_get_geometry(scene, 2, NULL));
    /* Too little room: only how much is needed. */
    numbers[0] = 77;
    STATUS(V_ERR_SIZE, v_scene_get_shape(scene, 2, 0, &text, numbers, NULL, 2, &count, NULL));
    CHECK(count == 4 && numbers[0] == 77);
    STATUS(V_ERR_SIZE, v_scene_get_deformation(scene, 2, 1, &text, numbers, 2, &count, NULL));
    CHECK(count == 3 && numbers[0] == 77);
    /* Nothing is wanted, and all that is not there. */
    OK(v_scene_get_marker(scene, 0, NULL, NULL));
    OK(v_scene_get_pin(scene, 0, NULL, NULL, NULL));
    OK(v_scene_get_shape(scene, 2, 0, NULL, NULL, NULL, 0, NULL, NULL));
    OK(v_scene_get_deformation(scene, 2, 0, NULL, NULL, 0, NULL, NULL));
    OK(v_scene_get_path(scene, 0, NULL, NULL, NULL));
    STATUS(V_ERR_ARGUMENT, v_scene_count(scene, 0, "wheels", &number));
    CHECK(strstr(v_last_error(), "no \"wheels\"; known: nodes, markers") != NULL);
    v_scene_free(scene);
}

static void what_is_shown(void)
{
    V_SCENE *scene = NULL;
    double first = 0, last = 0, end = 0;
    int eye, shown = -7;
    OK(v_scene_new(&scene));
    OK(v_scene_frame_range(scene, &first, &end));
    eye = add(scene, "eye", V_NODE_CAMERA, -1);
    add(scene, "car", V_NODE_GROUP, -1);
    OK(v_scene_get_camera(scene, &shown));
    CHECK(shown == 0);
    OK(v_scene_set_camera(scene, eye));
    STATUS(V_ERR_ARGUMENT, v_scene_set_camera(scene, 2));
    CHECK(strcmp(v_last_error(), "\"car\" is no camera") == 0);
    STATUS(V_ERR_RANGE, v_scene_set_camera(scene, 3));
    STATUS(V_ERR_RANGE, v_scene_set_camera(scene, -2));
    OK(v_scene_get_camera(scene, &shown));
    CHECK(shown == eye);
    OK(v_scene_set_range(scene, 2.5, 8));
    STATUS(V_ERR_ARGUMENT, v_scene_set_range(scene, 1, INFINITY));
    STATUS(V_ERR_ARGUMENT, v_scene_set_range(scene, NAN, 2));
    STATUS(V_ERR_RANGE, v_scene_set_range(scene, -2e9, 2));
    STATUS(V_ERR_LIMIT, v_scene_set_range(scene, 0, 1e8));
    OK(v_scene_frame_range(scene, &first, &last));
    CHECK(first == 2.5 && last == 8);
    /* A node before it goes, then it goes. */
    OK(v_scene_remove_node(scene, 0));
    OK(v_scene_get_camera(scene, &shown));
    CHECK(shown == 0);
    OK(v_scene_set_camera(scene, 0));
    OK(v_scene_remove_node(scene, 0));
    OK(v_scene_get_camera(scene, &shown));
    CHECK(shown == -1);
    OK(v_scene_set_range(scene, 1, 0));
    OK(v_scene_frame_range(scene, &first, &last));
    CHECK(first == 1 && last == 1 && end > 1);
    v_scene_free(scene);
}

/* v_path_load() takes the path of the camera that is shown. */
static void the_path_that_is_shown(void)
{
    V_SCENE *scene = everything();
    V_PATH *path = new_path(), *loaded = NULL;
    char *text = text_of(scene);
    double place[3] = {0.125, 0, 0}, found[3];
    int other;
    /* The one that is chosen moves by keys. */
    STATUS(V_ERR_ARGUMENT, v_path_load_from_memory(text, strlen(text), &loaded));
    free(text);
    OK(set_position(path, 0, place));
    other = add(scene, "other", V_NODE_CAMERA, -1);
    OK(v_scene_set_path(scene, other, path, 5, V_AFTER_HOLD));
    OK(v_scene_set_camera(scene, other));
    text = text_of(scene);
    OK(v_path_load_from_memory(text, strlen(text), &loaded));
    OK(get_position(loaded, 0, found));
    CHECK(memcmp(place, found, sizeof place) == 0);
    free(text);
    v_path_free(loaded);
    v_path_free(path);
    v_scene_free(scene);
}

static double x_of(const V_SCENE *scene, int node)
{
    V_NODE_STATE state;
    OK(v_scene_sample(scene, node, 1, 1, &state, 1));
    return state.matrix[12];
}

static void another_parent(void)
{
    V_SCENE *scene = NULL;
    V_NODE node;
    int car, wheel;
    OK(v_scene_new(&scene));
    car = add(scene, "car", V_NODE_GROUP, -1);
    wheel = add(scene, "wheel", V_NODE_OBJECT, -1);
    node = get(scene, car);
    node.position[0] = 5;
    OK(v_scene_set_node(scene, car, &node));
    node.position[0] = 2;
    node.kind = V_NODE_OBJECT;
    OK(v_scene_set_node(scene, wheel, &node));
    OK(v_scene_set_parent(scene, wheel, car, V_KEEP_NUMBERS));
    node = get(scene, wheel);
    CHECK(node.parent == car && node.position[0] == 2);
    NEAR(x_of(scene, wheel), 7, 1e-12);
    OK(v_scene_set_parent(scene, wheel, -1, V_KEEP_PLACE));
    node = get(scene, wheel);
    CHECK(node.parent == -1);
    NEAR(node.position[0], 7, 1e-12);
    NEAR(x_of(scene, wheel), 7, 1e-12);
    STATUS(V_ERR_RANGE, v_scene_set_parent(scene, wheel, 3, V_KEEP_NUMBERS));
    STATUS(V_ERR_RANGE, v_scene_set_parent(scene, wheel, -2, V_KEEP_NUMBERS));
    STATUS(V_ERR_RANGE, v_scene_set_parent(scene, 3, -1, V_KEEP_NUMBERS));
    STATUS(V_ERR_RANGE, v_scene_set_parent(scene, wheel, car, 2));
    STATUS(V_ERR_ARGUMENT, v_scene_set_parent(scene, car, car, V_KEEP_PLACE));
    STATUS(V_ERR_ARGUMENT, v_scene_set_parent(scene, car, car, V_KEEP_NUMBERS));
    OK(v_scene_set_parent(scene, wheel, car, V_KEEP_NUMBERS));
    STATUS(V_ERR_ARGUMENT, v_scene_set_parent(scene, car, wheel, V_KEEP_NUMBERS));
    /* What follows a path can only go along. */
    STATUS(V_ERR_ARGUMENT, v_scene_set_parent(scene, 0, car, V_KEEP_PLACE));
    OK(v_scene_set_parent(scene, 0, car, V_KEEP_NUMBERS));
    v_scene_free(scene);
}

static void what_goes(void)
{
    V_SCENE *scene = everything();
    const char *text = NULL;
    double values[6], frames[2];
    size_t keys = 0;
    int count = -1;
    OK(v_scene_remove_shape(scene, 2, 1));
    OK(v_scene_count(scene, 2, "shapes", &count));
    CHECK(count == 2);
    OK(v_scene_get_shape(scene, 2, 1, &text, NULL, NULL, 0, &keys, NULL));
    CHECK(strcmp(text, "again") == 0 && keys == 4);
    OK(v_scene_get_track(scene, 2, "weights", &text, 2, frames, values, NULL, &keys, NULL));
    CHECK(keys == 2 && values[0] == 0 && values[1] == 0.5 && values[2] == 1 && values[3] == 3);
    OK(v_scene_remove_shape(scene, 2, 0));
    OK(v_scene_remove_shape(scene, 2, 0));
    OK(v_scene_count(scene, 2, "tracks", &count));
    CHECK(count == 3);
    OK(v_scene_remove_marker(scene, "meet"));
    STATUS(V_ERR_ARGUMENT, v_scene_remove_marker(scene, "meet"));
    CHECK(strcmp(v_last_error(), "there is no marker \"meet\"") == 0);
    OK(v_scene_count(scene, 0, "markers", &count));
    CHECK(count == 1);
    OK(v_scene_count(scene, 0, "pins", &count));
    CHECK(count == 1);
    STATUS(V_ERR_RANGE, v_scene_set_number(scene, "fps", 0));
    STATUS(V_ERR_RANGE, v_scene_set_number(scene, "fps", NAN));
    STATUS(V_ERR_ARGUMENT, v_scene_set_text(scene, "title", "two\nlines"));
    STATUS(V_ERR_RANGE, v_scene_set_number(scene, "check.weather", 1));
    STATUS(V_ERR_ARGUMENT, v_scene_set_number(scene, "check.turning", NAN));
    OK(v_scene_get_number(scene, "fps", &values[0]));
    CHECK(values[0] == 24);
    v_scene_free(scene);
}

/* Comments of a file stay where a program changes its scene and saves it. */
static void comments_stay(void)
{
    static const char text[] = "# head\nversion = 1\n\n"
                               "# the car\n[[node]]\nname = \"car\"\nkind = \"group\"\n\n"
                               "# the eye\n[[node]]\nname = \"eye\"\nkind = \"camera\" # of all\n";
    V_SCENE *scene = NULL;
    char *saved;
    OK(v_scene_load_from_memory(text, strlen(text), &scene));
    add(scene, "lamp", V_NODE_LIGHT, -1);
    saved = text_of(scene);
    CHECK(strncmp(saved, "# head\n", 7) == 0);
    CHECK(strstr(saved, "# the car\n[[node]]\nname = \"car\"\n") != NULL);
    CHECK(strstr(saved, "# the eye\n[[node]]\nname = \"eye\"\n") != NULL);
    free(saved);
    OK(v_scene_remove_node(scene, 0));
    saved = text_of(scene);
    CHECK(strstr(saved, "# the car") == NULL);
    CHECK(strstr(saved, "# the eye\n[[node]]\nname = \"eye\"\n") != NULL);
    CHECK(strstr(saved, "kind = \"camera\" # of all\n") != NULL);
    free(saved);
    v_scene_free(scene);
}

int main(void)
{
    what_is_set_is_read();
    places_that_are_none();
    what_is_shown();
    the_path_that_is_shown();
    another_parent();
    what_goes();
    comments_stay();
    return failures != 0;
}
