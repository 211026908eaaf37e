/*
 * A host of a z-up world asks what its windows hold: spaces FOLDER
 *
 * For each way to open a window with space_up, and after v_editor_set_scene() and
 * v_editor_set_path(): what the window's path and scene say, and what a file of the
 * same contents says. A line each; the exit status tells whether all agree.
 */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <libvides.h>

static int failures;

static void ok(int status, const char *what)
{
    if (status != V_OK) {
        printf("%s: %s\n", what, v_last_error());
        failures++;
    }
}

static void is(const char *what, double centre, double half, int up, const V_PATH *path,
               const V_SCENE *scene)
{
    double c[2][3], h[2];
    char axis[2][2];
    int u[2];
    size_t n;
    ok(v_path_get_numbers(path, "space.centre", c[0], 3, &n), what);
    ok(v_path_get_number(path, "space.half_size", &h[0]), what);
    ok(v_path_get_text(path, "space.up", axis[0], 2, &n), what);
    ok(v_scene_get_numbers(scene, "space.centre", c[1], 3, &n), what);
    ok(v_scene_get_number(scene, "space.half_size", &h[1]), what);
    ok(v_scene_get_text(scene, "space.up", axis[1], 2, &n), what);
    u[0] = axis[0][0] == 'z' ? V_UP_Z : V_UP_Y;
    u[1] = axis[1][0] == 'z' ? V_UP_Z : V_UP_Y;
    printf("%s: path %g %g %d, scene %g %g %d\n", what, c[0][0], h[0], u[0], c[1][0], h[1], u[1]);
    if (c[0][0] != centre || h[0] != half || u[0] != up || c[1][0] != centre || h[1] != half
        || u[1] != up)
        failures++;
}

/* What the window holds and what the file then says. */
static void holds(V_EDITOR *editor, const char *folder, const char *what, double centre, double half,
                  int up)
{
    char file[4096], name[100];
    V_PATH *path = NULL;
    V_SCENE *scene = NULL;
    v_dispatch();
    sprintf(file, "%.4000s/saved.vid", folder);
    ok(v_editor_get_path(editor, &path), what);
    ok(v_editor_get_scene(editor, &scene), what);
    is(what, centre, half, up, path, scene);
    ok(v_scene_save(scene, file), what);
    v_path_free(path);
    v_scene_free(scene);
    ok(v_path_load(file, &path), what);
    ok(v_scene_load(file, &scene), what);
    sprintf(name, "%.80s, file", what);
    is(name, centre, half, up, path, scene);
    v_path_free(path);
    v_scene_free(scene);
}

static V_EDITOR *opened(const V_EDITOR_OPTIONS *options, const char *what)
{
    V_EDITOR *editor = NULL;
    ok(v_editor_open(options, &editor), what);
    return editor;
}

/* The z of the first view of the new path: in a z-up world its cameras look level. */
static double first_z(const V_EDITOR *editor)
{
    V_PATH *path = NULL;
    V_POSE pose;
    ok(v_editor_get_path(editor, &path), "get_path");
    ok(v_path_pose(path, 1, &pose), "pose");
    v_path_free(path);
    return pose.vup[2];
}

/* A scene of two nodes, of which one is a camera on a path. */
static V_SCENE *two(const double centre[3], double half_size, int up)
{
    V_SCENE *scene = NULL;
    V_PATH *path = NULL;
    V_NODE node;
    ok(v_scene_new(&scene), "scene");
    v_node_init(&node, V_NODE_OBJECT);
    ok(v_scene_add_node(scene, "car", &node, NULL), "node");
    ok(v_path_new_in_space(centre, half_size, up, &path), "path");
    ok(v_scene_set_number(scene, "space.half_size", half_size), "half_size");
    ok(v_scene_set_numbers(scene, "space.centre", centre, 3), "centre");
    ok(v_scene_set_text(scene, "space.up", up == V_UP_Z ? "z" : "y"), "up");
    ok(v_scene_set_path(scene, 0, path, 1, V_AFTER_HOLD), "set_path");
    v_path_free(path);
    return scene;
}

int main(int argc, char **argv)
{
    const char *folder = argc > 1 ? argv[1] : ".";
    char file[4096];
    V_EDITOR_OPTIONS options;
    V_EDITOR *editor, *first;
    static const double metres[3] = {100, 0, 0}, plain[3] = {0, 0, 0};
    V_SCENE *scene;
    V_PATH *path;
    int k;

    first = opened(NULL, "first"); /* so that the server always has a client */
    for (k = V_UP_Y; k <= V_UP_Z; k++) {
        v_editor_options_init(&options);
        options.space_up = k;
        editor = opened(&options, "new");
        holds(editor, folder, k == V_UP_Z ? "new, z up" : "new, y up", 0, 1, k);
        if (first_z(editor) != (k == V_UP_Z))
            failures++;
        v_editor_close(editor);
    }
    /* A path of its own space, which V_UP_Y does not touch. */
    ok(v_path_new_in_space(metres, 50, V_UP_Z, &path), "path");
    v_editor_options_init(&options);
    options.path = path;
    editor = opened(&options, "path");
    holds(editor, folder, "z-up path", 100, 50, V_UP_Z);
    v_path_free(path);
    /* Another path and another scene bring theirs. */
    ok(v_path_new_in_space(plain, 1, V_UP_Y, &path), "path");
    ok(v_editor_set_path(editor, path), "set_path");
    holds(editor, folder, "y-up path set", 0, 1, V_UP_Y);
    v_path_free(path);
    scene = two(metres, 50, V_UP_Z);
    ok(v_editor_set_scene(editor, scene), "set_scene");
    holds(editor, folder, "z-up scene set", 100, 50, V_UP_Z);
    v_editor_close(editor);
    /* The space given for a file with a scene is that of scene and path. */
    v_scene_free(scene);
    scene = two(plain, 1, V_UP_Y);
    sprintf(file, "%.4000s/scene.vid", folder);
    ok(v_scene_save(scene, file), "save");
    v_scene_free(scene);
    v_editor_options_init(&options);
    options.file = file;
    options.space_centre[0] = 100;
    options.space_half_size = 50;
    options.space_up = V_UP_Z;
    editor = opened(&options, "scene file");
    holds(editor, folder, "y-up scene file, z-up space", 100, 50, V_UP_Z);
    v_editor_close(editor);
    /* A new path in the options' space, then a scene handed in. */
    options.file = NULL;
    editor = opened(&options, "new in metres");
    holds(editor, folder, "new in metres", 100, 50, V_UP_Z);
    scene = two(metres, 50, V_UP_Z);
    ok(v_editor_set_scene(editor, scene), "set_scene");
    holds(editor, folder, "scene in metres set", 100, 50, V_UP_Z);
    v_scene_free(scene);
    v_editor_close(editor);
    v_editor_close(first);
    return failures != 0;
}
