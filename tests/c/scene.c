/*
 * Scenes as a C program uses them: a car with a turning wheel and a headlight, a
 * camera that aims at it; what is set comes back, what is wrong is refused and
 * changes nothing, a host's own interpolation plays.
 */
#include <sys/stat.h>

#include "check.h"

static const char *folder;

static V_SCENE *new_scene(void)
{
    V_SCENE *scene = NULL;
    if (v_scene_new(&scene) != V_OK) {
        fprintf(stderr, "v_scene_new: %s\n", v_last_error());
        exit(2);
    }
    return scene;
}

static int nodes_of(const V_SCENE *scene)
{
    int count = -1;
    OK(v_scene_count(scene, 0, "nodes", &count));
    return count;
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

static V_NODE get(const V_SCENE *scene, int at)
{
    V_NODE node;
    v_node_init(&node, V_NODE_GROUP);
    OK(v_scene_get_node(scene, at, &node));
    return node;
}

static V_NODE_STATE state(const V_SCENE *scene, int node, double frame)
{
    V_NODE_STATE states[64];
    size_t count = 0;
    OK(v_scene_evaluate(scene, frame, states, 64, &count));
    CHECK((int)count == nodes_of(scene));
    return states[node];
}

static void a_new_scene_is_a_camera_on_a_path(void)
{
    V_SCENE *scene = new_scene();
    V_PATH *path = new_path(), *back = NULL;
    V_POSE pose;
    V_NODE_STATE is;
    V_NODE node = get(scene, 0);
    size_t frames = 0, i;
    double first = 0, last = 0;
    int at = -1;
    const char *name = NULL;
    CHECK(nodes_of(scene) == 1 && node.kind == V_NODE_CAMERA);
    CHECK(node.parent == -1 && node.aim == -1 && node.visible == 1 && node.zoom == 24);
    OK(v_scene_get_name(scene, 0, &name));
    CHECK(strcmp(name, "camera") == 0);
    OK(v_scene_find_node(scene, "camera", &at));
    CHECK(at == 0);
    OK(v_path_frame_count(path, &frames));
    OK(v_scene_frame_range(scene, &first, &last));
    CHECK(first == 1 && last == (double)frames);
    for (i = 1; i <= 2 * frames - 1; i++) {
        double frame = 1 + (double)(i - 1) / 2;
        int k;
        OK(v_path_pose(path, frame, &pose));
        is = state(scene, 0, frame);
        for (k = 0; k < 3; k++) {
            NEAR(is.pose.vrp[k], pose.vrp[k], 1e-12);
            NEAR(is.pose.vpn[k], pose.vpn[k], 1e-12);
            NEAR(is.pose.vup[k], pose.vup[k], 1e-12);
            NEAR(is.matrix[12 + k], pose.vrp[k], 1e-12);
            NEAR(is.matrix[8 + k], pose.vpn[k], 1e-12);
            NEAR(is.matrix[4 + k], pose.vup[k], 1e-12);
        }
        NEAR(is.pose.zoom, pose.zoom, 1e-12);
        CHECK(is.visible == 1);
    }
    OK(v_scene_get_path(scene, 0, &back, NULL, NULL));
    OK(v_path_pose(back, 2.5, &pose));
    /* Later, and over again. */
    OK(v_scene_set_path(scene, 0, path, 101, V_AFTER_REPEAT));
    is = state(scene, 0, 102.5);
    NEAR(is.pose.vrp[0], pose.vrp[0], 1e-12);
    is = state(scene, 0, 102.5 + 3 * (double)(frames - 1));
    NEAR(is.pose.vrp[0], pose.vrp[0], 1e-12);
    STATUS(V_ERR_ARGUMENT, v_scene_set_path(scene, 0, path, 1, V_AFTER_OFFSET));
    STATUS(V_ERR_RANGE, v_scene_set_path(scene, 0, path, 1, 4));
    OK(v_scene_set_path(scene, 0, NULL, 1, V_AFTER_HOLD));
    STATUS(V_ERR_ARGUMENT, v_scene_get_path(scene, 0, &back, NULL, NULL));
    v_path_free(back);
    v_path_free(path);
    v_scene_free(scene);
}

static const double two[] = {1, 11};

static void a_car(void)
{
    static const double way[] = {0, 0, 0, 4, 0, 0};
    static const double turns[] = {0, 0, 0, 0, 720, 0};
    V_SCENE *scene = new_scene();
    V_NODE node;
    V_NODE_STATE is, some[3];
    double numbers[4], frames[2], values[6];
    const char *interpolation = NULL;
    size_t keys = 0, width = 0;
    int after = -1, k;
    int car = add(scene, "car", V_NODE_GROUP, -1);
    int wheel = add(scene, "wheel", V_NODE_OBJECT, car);
    int lamp = add(scene, "headlight", V_NODE_LIGHT, car);
    node = get(scene, wheel);
    node.pivot[1] = -1;
    OK(v_scene_set_node(scene, wheel, &node));
    OK(v_scene_set_track(scene, car, "position", "linear", two, way, NULL, 2,
                         V_AFTER_OFFSET | V_BEFORE_PINGPONG));
    OK(v_scene_set_track(scene, wheel, "rotation", "euler-linear", two, turns, NULL, 2,
                         V_AFTER_REPEAT));
    /* Half way: the wheel has turned once, in its place on the car. */
    is = state(scene, wheel, 3.5);
    NEAR(is.matrix[12], 1, 1e-12);
    NEAR(is.matrix[13], -2, 1e-12);
    NEAR(is.matrix[5], -1, 1e-12);
    is = state(scene, lamp, 21);
    NEAR(is.matrix[12], 8, 1e-12);
    is = state(scene, lamp, -1.5);
    NEAR(is.matrix[12], 1, 1e-12);
    CHECK(is.intensity == 1 && is.colour[2] == 1);
    /* The camera looks at the car. */
    OK(v_scene_set_path(scene, 0, NULL, 1, V_AFTER_HOLD));
    node = get(scene, 0);
    node.aim = car;
    node.position[0] = 1;
    node.position[2] = -5;
    OK(v_scene_set_node(scene, 0, &node));
    is = state(scene, 0, 3.5);
    NEAR(is.pose.vpn[2], 1, 1e-15);
    is = state(scene, 0, 1);
    NEAR(is.pose.vpn[0], -1 / sqrt(26), 1e-15);
    OK(v_scene_set_track(scene, 0, "aim_weight", "step", two, two + 0, NULL, 1, V_AFTER_HOLD));
    /* What was set comes back. */
    OK(v_scene_get_track(scene, car, "position", &interpolation, 2, frames, values, NULL, &keys,
                         &after));
    CHECK(keys == 2 && strcmp(interpolation, "linear") == 0);
    CHECK(after == (V_AFTER_OFFSET | V_BEFORE_PINGPONG));
    CHECK(memcmp(frames, two, sizeof two) == 0 && memcmp(values, way, sizeof way) == 0);
    STATUS(V_ERR_SIZE,
           v_scene_get_track(scene, car, "position", NULL, 1, frames, NULL, NULL, &keys, NULL));
    CHECK(keys == 2);
    OK(v_scene_get_track(scene, car, "scale", &interpolation, 0, NULL, NULL, NULL, &keys, NULL));
    CHECK(keys == 0 && interpolation[0] == '\0');
    OK(v_scene_value(scene, wheel, "rotation", 3.5, numbers, 4, &width));
    CHECK(width == 4);
    NEAR(fabs(numbers[1]), 1, 1e-12);
    width = 0;
    STATUS(V_ERR_SIZE, v_scene_value(scene, wheel, "rotation", 3.5, numbers, 3, &width));
    CHECK(width == 4);
    OK(v_scene_set_track(scene, car, "value:wind:2", "linear", two, way + 2, NULL, 2, 0));
    OK(v_scene_value(scene, car, "value:wind", 6, numbers, 4, &width));
    CHECK(width == 2 && numbers[0] == 0 && numbers[1] == 2);
    OK(v_scene_sample(scene, lamp, 1, 2.5, some, 3));
    for (k = 0; k < 3; k++)
        NEAR(some[k].matrix[12], k, 1e-12);
    /* Without a track it is at rest. */
    OK(v_scene_set_track(scene, car, "position", NULL, NULL, NULL, NULL, 0, 0));
    is = state(scene, lamp, 6);
    CHECK(is.matrix[12] == 0);
    v_scene_free(scene);
}

/* Lecture 9.3.2: what points have is blended as their positions are. */
static void colours_morph(void)
{
    static const double xyz[] = {0, 0, 0, 1, 0, 0}, keys[] = {1, 11};
    static const double weights[] = {0, 0, 0.5, 1}; /* of "red", of "plain" */
    static const unsigned char black[] = {0, 0, 40, 0, 0, 0}, red[] = {200, 0, 0, 100, 0, 255};
    V_SCENE *scene = new_scene();
    int sheet = add(scene, "sheet", V_NODE_OBJECT, -1), plain = add(scene, "plain", V_NODE_OBJECT, -1);
    int coloured = -1;
    unsigned char rgb[6] = {1, 2, 3, 4, 5, 6}, got[6];
    V_MESH mesh;
    size_t points = 0;

    memset(&mesh, 0, sizeof mesh);
    mesh.size = sizeof mesh;
    mesh.xyz = xyz;
    mesh.points = 2;
    OK(v_scene_set_geometry(scene, plain, &mesh));
    OK(v_scene_vertices(scene, plain, 1, NULL, rgb, 2, NULL));
    CHECK(rgb[0] == 1 && rgb[5] == 6); /* none to be had */
    mesh.rgb = black;
    OK(v_scene_set_geometry(scene, sheet, &mesh));
    OK(v_scene_add_shape(scene, sheet, "red", xyz, red, 2));
    OK(v_scene_add_shape(scene, sheet, "plain", xyz, NULL, 2));
    OK(v_scene_set_track(scene, sheet, "weights", "linear", keys, weights, NULL, 2, 0));
    /* At frame 6: a quarter of red; what "plain" has is the mesh's. */
    OK(v_scene_vertices(scene, sheet, 6, NULL, rgb, 2, &points));
    CHECK(points == 2 && rgb[0] == 50 && rgb[1] == 0 && rgb[2] == 30 && rgb[3] == 25);
    CHECK(rgb[4] == 0 && rgb[5] == 64);
    rgb[0] = 7;
    STATUS(V_ERR_SIZE, v_scene_vertices(scene, sheet, 6, NULL, rgb, 1, &points));
    CHECK(rgb[0] == 7 && points == 2);
    OK(v_scene_get_shape(scene, sheet, 0, NULL, NULL, got, 2, NULL, &coloured));
    CHECK(coloured == 1 && memcmp(got, red, sizeof red) == 0);
    OK(v_scene_get_shape(scene, sheet, 1, NULL, NULL, NULL, 0, &points, &coloured));
    CHECK(coloured == 0 && points == 2);
    v_scene_free(scene);
}

static void objects_change(void)
{
    static const double xyz[] = {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0};
    static const double high[] = {0, 0, 2, 1, 0, 2, 1, 1, 2, 0, 1, 2};
    static const unsigned corners[] = {0, 1, 2, 0, 2, 3}, wrong[] = {0, 1, 4};
    static const double twist[] = {1, 90}, weight[] = {0, 1};
    double box[6] = {-1, -1, -1, 1, 1, 1}, out[12], p[3] = {0.5, 1, 0};
    V_SCENE *scene = new_scene();
    int sheet = add(scene, "sheet", V_NODE_OBJECT, -1), at = -1;
    size_t points = 0;
    V_MESH mesh;
    memset(&mesh, 0, sizeof mesh);
    STATUS(V_ERR_SIZE, v_scene_set_geometry(scene, sheet, &mesh));
    mesh.size = sizeof mesh;
    mesh.xyz = xyz;
    mesh.points = 4;
    mesh.triangles = corners;
    mesh.corners = 5;
    STATUS(V_ERR_RANGE, v_scene_set_geometry(scene, sheet, &mesh));
    mesh.corners = 3;
    mesh.triangles = wrong;
    STATUS(V_ERR_RANGE, v_scene_set_geometry(scene, sheet, &mesh));
    mesh.corners = 6;
    mesh.triangles = corners;
    STATUS(V_ERR_ARGUMENT, v_scene_set_geometry(scene, 0, &mesh));
    OK(v_scene_set_geometry(scene, sheet, &mesh));
    OK(v_scene_add_shape(scene, sheet, "high", high, NULL, 4));
    STATUS(V_ERR_RANGE, v_scene_add_shape(scene, sheet, "few", high, NULL, 3));
    OK(v_scene_set_track(scene, sheet, "weights", "linear", two, weight, NULL, 2, 0));
    OK(v_scene_vertices(scene, sheet, 6, out, NULL, 4, &points));
    CHECK(points == 4 && out[2] == 1 && out[11] == 1 && out[6] == 1);
    points = 0;
    STATUS(V_ERR_SIZE, v_scene_vertices(scene, sheet, 6, out, NULL, 3, &points));
    CHECK(points == 4);
    STATUS(V_ERR_ARGUMENT, v_scene_vertices(scene, 0, 6, out, NULL, 3, &points));
    /* Twisted in the scene and by itself: the same. */
    OK(v_deform("twist", twist, 2, box, p, 1));
    NEAR(p[0], 0, 1e-15);
    NEAR(p[2], -0.5, 1e-15);
    OK(v_scene_add_deformation(scene, sheet, "twist", twist, 2, box, &at));
    CHECK(at == 0);
    OK(v_scene_set_track(scene, sheet, "weights", NULL, NULL, NULL, NULL, 0, 0));
    OK(v_scene_vertices(scene, sheet, 6, out, NULL, 4, &points));
    NEAR(out[6], 0, 1e-15);
    NEAR(out[8], -1, 1e-15);
    OK(v_scene_set_track(scene, sheet, "deformation.0.angle", "linear", two, weight, NULL, 2, 0));
    OK(v_scene_remove_deformation(scene, sheet, 0));
    STATUS(V_ERR_RANGE, v_scene_remove_deformation(scene, sheet, 0));
    STATUS(V_ERR_RANGE,
           v_scene_set_track(scene, sheet, "deformation.0.angle", "linear", two, weight, NULL, 2, 0));
    STATUS(V_ERR_ARGUMENT, v_deform("shear", twist, 2, box, p, 1));
    STATUS(V_ERR_RANGE, v_deform("twist", twist, 1, box, p, 1));
    box[0] = 2;
    STATUS(V_ERR_ARGUMENT, v_deform("twist", twist, 2, box, p, 1));
    v_scene_free(scene);
}

static V_SCENE *asked_scene;
static int asked;

static int middle(const double *frames, const double *values, size_t width, size_t keys,
                  double frame, double *value, void *user)
{
    size_t i;
    int count = 0;
    asked++;
    if (user != &asked || keys != 2 || frame < frames[0] || frame > frames[1])
        return 1;
    if (v_scene_count(asked_scene, 0, "nodes", &count) != V_ERR_BUSY)
        return 1;
    for (i = 0; i < width; i++)
        value[i] = (values[i] + values[width + i]) / 2;
    return V_OK;
}

static int not_a_number(const double *frames, const double *values, size_t width, size_t keys,
                        double frame, double *value, void *user)
{
    (void)frames, (void)values, (void)width, (void)keys, (void)frame, (void)user;
    value[0] = HUGE_VAL - HUGE_VAL;
    return V_OK;
}

static void a_hosts_interpolation(void)
{
    static const double way[] = {0, 0, 0, 4, 0, 2};
    V_SCENE *scene = new_scene();
    V_NODE_STATE states[2], is;
    int node = add(scene, "node", V_NODE_GROUP, -1);
    size_t count = 0;
    asked_scene = scene;
    OK(v_register_interpolation("middle", middle, &asked));
    OK(v_scene_set_track(scene, node, "position", "host:middle", two, way, NULL, 2, 0));
    is = state(scene, node, 3);
    CHECK(asked == 1 && is.matrix[12] == 2 && is.matrix[14] == 1);
    /* Missing, or wrong: the rest plays, and a sentence tells. */
    OK(v_register_interpolation("middle", NULL, NULL));
    OK(v_scene_evaluate(scene, 3, states, 2, &count));
    CHECK(count == 2 && *v_last_error() == 0);
    CHECK(strstr(v_last_warning(), "node \"node\": channel \"position\": no interpolation") != NULL);
    CHECK(states[1].matrix[12] == 0 && states[0].pose.vpn[2] == -1);
    OK(v_register_interpolation("host:middle", not_a_number, NULL));
    OK(v_scene_evaluate(scene, 3, states, 2, &count));
    CHECK(strstr(v_last_warning(), "cannot be used") != NULL && states[1].matrix[12] == 0);
    OK(v_register_interpolation("middle", NULL, NULL));
    STATUS(V_ERR_ARGUMENT, v_register_interpolation("", middle, NULL));
    v_scene_free(scene);
}

static void what_is_wrong_is_refused(void)
{
    static const double back[] = {2, 1}, six[6] = {0};
    double odd[6] = {0, 0, 0, 0, 0, 0};
    V_SCENE *scene = new_scene();
    V_NODE node;
    V_NODE_STATE states[4];
    int a = add(scene, "a", V_NODE_GROUP, -1), b = add(scene, "b", V_NODE_GROUP, a), at = 77;
    size_t count = 77;
    odd[4] = HUGE_VAL - HUGE_VAL;
    v_node_init(&node, V_NODE_GROUP);
    STATUS(V_ERR_ARGUMENT, v_scene_add_node(scene, "a", &node, &at));
    STATUS(V_ERR_ARGUMENT, v_scene_add_node(scene, "", &node, &at));
    STATUS(V_ERR_ARGUMENT, v_scene_add_node(scene, "\xff", &node, &at));
    STATUS(V_ERR_NULL, v_scene_add_node(scene, NULL, &node, &at));
    STATUS(V_ERR_NULL, v_scene_add_node(NULL, "c", &node, &at));
    node.parent = 9;
    STATUS(V_ERR_RANGE, v_scene_add_node(scene, "c", &node, &at));
    node.parent = -2;
    STATUS(V_ERR_RANGE, v_scene_add_node(scene, "c", &node, &at));
    node.parent = -1;
    node.kind = 4;
    STATUS(V_ERR_RANGE, v_scene_add_node(scene, "c", &node, &at));
    node.kind = V_NODE_GROUP;
    node.size--;
    STATUS(V_ERR_SIZE, v_scene_add_node(scene, "c", &node, &at));
    CHECK(at == 77 && nodes_of(scene) == 3);
    node = get(scene, a);
    node.parent = b;
    STATUS(V_ERR_ARGUMENT, v_scene_set_node(scene, a, &node));
    node.parent = a;
    STATUS(V_ERR_ARGUMENT, v_scene_set_node(scene, a, &node));
    node.parent = -1;
    node.rotation[0] = 0;
    STATUS(V_ERR_ARGUMENT, v_scene_set_node(scene, a, &node));
    node = get(scene, a);
    CHECK(node.parent == -1 && node.rotation[0] == 1);
    STATUS(V_ERR_ARGUMENT, v_scene_set_track(scene, a, "zoom", "linear", two, two, NULL, 2, 0));
    STATUS(V_ERR_ARGUMENT, v_scene_set_track(scene, a, "place", "linear", two, six, NULL, 2, 0));
    STATUS(V_ERR_ARGUMENT, v_scene_set_track(scene, a, "position", "bezier", two, six, NULL, 2, 0));
    STATUS(V_ERR_ARGUMENT, v_scene_set_track(scene, a, "position", "linear", back, six, NULL, 2, 0));
    STATUS(V_ERR_ARGUMENT, v_scene_set_track(scene, a, "position", "linear", two, odd, NULL, 2, 0));
    STATUS(V_ERR_NULL, v_scene_set_track(scene, a, "position", "hermite", two, six, NULL, 2, 0));
    STATUS(V_ERR_RANGE, v_scene_set_track(scene, a, "position", "linear", two, six, NULL, 2, 4));
    STATUS(V_ERR_LIMIT, v_scene_set_track(scene, a, "position", "linear", two, six, NULL,
                                          (size_t)-1 / 64, 0));
    STATUS(V_ERR_ARGUMENT, v_scene_evaluate(scene, odd[4], states, 4, &count));
    CHECK(count == 77);
    STATUS(V_ERR_SIZE, v_scene_evaluate(scene, 1, states, 2, &count));
    CHECK(count == 3);
    OK(v_scene_evaluate(scene, 1, NULL, 0, &count));
    CHECK(count == 3);
    OK(v_scene_remove_node(scene, a));
    CHECK(nodes_of(scene) == 1);
    STATUS(V_ERR_RANGE, v_scene_remove_node(scene, 1));
    v_scene_free(scene);
    STATUS(V_ERR_HANDLE, v_scene_evaluate(scene, 1, states, 4, &count));
    v_scene_free(scene);
    CHECK(v_last_error()[0] != '\0');
    v_scene_free(NULL);
    CHECK(v_last_error()[0] == '\0');
}

static void files(void)
{
    static const double angles[] = {0, 0, 0, 10, 20, 30};
    char file[4096], again[4096];
    V_SCENE *scene = new_scene(), *copy = NULL, *loaded = NULL;
    V_PATH *path = new_path(), *alone = NULL;
    V_NODE_STATE is, was;
    int car;
    snprintf(file, sizeof file, "%s/scene.vid", folder);
    snprintf(again, sizeof again, "%s/path.vid", folder);
    /* One camera on a path: the file of that path, byte for byte. */
    OK(v_scene_save(scene, file));
    OK(v_path_save(path, again));
    {
        FILE *a = fopen(file, "rb"), *b = fopen(again, "rb");
        int x, y;
        CHECK(a != NULL && b != NULL);
        do {
            x = fgetc(a);
            y = fgetc(b);
            CHECK(x == y);
        } while (x == y && x != EOF);
        fclose(a);
        fclose(b);
    }
    car = add(scene, "car", V_NODE_GROUP, -1);
    OK(v_scene_set_track(scene, car, "rotation", "euler-catmull-rom", two, angles, NULL, 2, 0));
    OK(v_scene_set_marker(scene, "meet", 40));
    OK(v_scene_pin(scene, 0, 1, "meet"));
    STATUS(V_ERR_ARGUMENT, v_scene_pin(scene, 0, 1, "never"));
    STATUS(V_ERR_RANGE, v_scene_pin(scene, 0, 2, "meet"));
    OK(v_scene_clone(scene, &copy));
    OK(v_scene_save(copy, file));
    v_scene_free(copy);
    OK(v_scene_load(file, &loaded));
    was = state(scene, car, 7.25);
    is = state(loaded, car, 7.25);
    CHECK(memcmp(is.matrix, was.matrix, sizeof is.matrix) == 0);
    /* As a path it is that of its camera. */
    OK(v_path_load(file, &alone));
    OK(v_path_save(alone, file));
    OK(v_scene_load(file, &copy));
    CHECK(nodes_of(copy) == 1);
    v_scene_free(copy);
    OK(v_scene_clone(loaded, &copy));
    v_path_free(alone);
    OK(v_scene_remove_node(copy, 0));
    OK(v_scene_save(copy, file));
    STATUS(V_ERR_ARGUMENT, v_path_load(file, &alone));
    STATUS(V_ERR_IO, v_scene_load("/nowhere/at.all", &copy));
    v_path_free(path);
    v_scene_free(copy);
    v_scene_free(loaded);
    v_scene_free(scene);
}

static void write_file(const char *name, const char *text)
{
    FILE *file = fopen(name, "w");
    CHECK(file != NULL && fputs(text, file) >= 0 && fclose(file) == 0);
}

static int holds(const char *name, const char *words)
{
    static char text[1 << 16];
    FILE *file = fopen(name, "r");
    size_t length = file == NULL ? 0 : fread(text, 1, sizeof text - 1, file);
    text[length] = 0;
    return file != NULL && fclose(file) == 0 && strstr(text, words) != NULL;
}

static size_t vertices(V_SCENE *scene, int node)
{
    size_t points = 99;
    OK(v_scene_vertices(scene, node, 1, NULL, NULL, 0, &points));
    return points;
}

/* A mesh beside the scene: named there, not copied; gone, broken, changed, and back. */
/* With a buffer within, and with one beside it that is not there. */
static void a_mesh_in_gltf(void)
{
    static const char text[] =
        "{\"asset\":{\"version\":\"2.0\"},\"nodes\":[{\"mesh\":0}],\"meshes\":[{\"primitives\":["
        "{\"attributes\":{\"POSITION\":0}}]}],\"accessors\":[{\"bufferView\":0,\"componentType\":"
        "5126,\"count\":3,\"type\":\"VEC3\"}],\"bufferViews\":[{\"buffer\":0,\"byteLength\":36}],"
        "\"buffers\":[{\"byteLength\":36,\"uri\":\"%s\"}]}";
    char mesh[512], json[1024];
    V_SCENE *scene;
    V_NODE node;
    int at;
    snprintf(mesh, sizeof mesh, "%s/corner.gltf", folder);
    OK(v_scene_new(&scene));
    v_node_init(&node, V_NODE_OBJECT);
    OK(v_scene_add_node(scene, "corner", &node, &at));
    snprintf(json, sizeof json, text, "gone.bin");
    write_file(mesh, json);
    STATUS(V_ERR_FORMAT, v_scene_load_geometry(scene, at, mesh));
    CHECK(strstr(v_last_error(), "buffer") != NULL && vertices(scene, at) == 0);
    snprintf(json, sizeof json, text,
             "data:;base64,AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA");
    write_file(mesh, json);
    OK(v_scene_load_geometry(scene, at, mesh));
    CHECK(vertices(scene, at) == 3);
    v_scene_free(scene);
}

static void a_mesh_of_a_file(void)
{
    static const char corner[] = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
    char mesh[512], file[512];
    V_SCENE *scene, *loaded;
    V_NODE node;
    int at;
    snprintf(mesh, sizeof mesh, "%s/corner.obj", folder);
    snprintf(file, sizeof file, "%s/corner.vid", folder);
    write_file(mesh, corner);
    OK(v_scene_new(&scene));
    v_node_init(&node, V_NODE_OBJECT);
    OK(v_scene_add_node(scene, "corner", &node, &at));
    STATUS(V_ERR_NULL, v_scene_load_geometry(scene, at, NULL));
    STATUS(V_ERR_RANGE, v_scene_load_geometry(scene, 7, mesh));
    STATUS(V_ERR_ARGUMENT, v_scene_load_geometry(scene, 0, mesh));
    STATUS(V_ERR_IO, v_scene_load_geometry(scene, at, "/nowhere/at.obj"));
    STATUS(V_ERR_FORMAT, v_scene_load_geometry(scene, at, file));
    CHECK(vertices(scene, at) == 0);
    OK(v_scene_load_geometry(scene, at, mesh));
    CHECK(vertices(scene, at) == 3);
    OK(v_scene_save(scene, file));
    CHECK(holds(file, "file = \"corner.obj\"") && !holds(file, "points = "));
    OK(v_scene_load(file, &loaded));
    CHECK(*v_last_warning() == 0 && vertices(loaded, at) == 3);
    v_scene_free(loaded);
    write_file(mesh, "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 1\nf 1 2 3\nf 1 2 4\n");
    OK(v_scene_load(file, &loaded));
    CHECK(strstr(v_last_warning(), "changed") != NULL && vertices(loaded, at) == 4);
    v_scene_free(loaded);
    write_file(mesh, "v 0 0\n");
    OK(v_scene_load(file, &loaded));
    CHECK(strstr(v_last_warning(), "corner.obj: line 1: ") != NULL);
    CHECK(vertices(loaded, at) == 0);
    v_scene_free(loaded);
    CHECK(remove(mesh) == 0);
    OK(v_scene_load(file, &loaded));
    CHECK(strstr(v_last_warning(), "corner.obj") != NULL && vertices(loaded, at) == 0);
    /* What is saved now finds the mesh again as soon as it is back. */
    OK(v_scene_save(loaded, file));
    v_scene_free(loaded);
    write_file(mesh, corner);
    OK(v_scene_load(file, &loaded));
    CHECK(*v_last_warning() == 0 && vertices(loaded, at) == 3);
    v_scene_free(loaded);
    /* Elsewhere it is not read for a file that names it, and is for a program. */
    snprintf(file, sizeof file, "%s/elsewhere", folder);
    CHECK(mkdir(file, 0700) == 0);
    snprintf(file, sizeof file, "%s/elsewhere/corner.vid", folder);
    OK(v_scene_save(scene, file));
    OK(v_scene_load(file, &loaded));
    CHECK(strstr(v_last_warning(), "lies outside the folder") != NULL);
    CHECK(vertices(loaded, at) == 0);
    OK(v_scene_load_geometry(loaded, at, mesh));
    CHECK(vertices(loaded, at) == 3);
    v_scene_free(loaded);
    v_scene_free(scene);
}

int main(int argc, char **argv)
{
    folder = argc > 1 ? argv[1] : ".";
    a_new_scene_is_a_camera_on_a_path();
    a_car();
    colours_morph();
    objects_change();
    a_hosts_interpolation();
    what_is_wrong_is_refused();
    files();
    a_mesh_of_a_file();
    a_mesh_in_gltf();
    return failures != 0;
}
