/*
 * What a window hands over of a scene is what its files have: film FOLDER
 *
 * A scene of three cameras, of which the second moves by keys, that begins between two
 * frames. For each of them, shown: the poses handed over by somebody's hands
 * (../calls/hands.h), v_scene_sample(), and a file of v_scene_export(), to the last bit;
 * each scene and its file stay in FOLDER. Then the path, the playhead and the reasons
 * that a host is told of. The exit status tells whether all agree.
 */
#include <poll.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <libvides.h>

#include "../calls/hands.h"

static int failures;
static V_POSE *handed;
static size_t handed_over;
static int reasons[5];
static double told = -1000;

static void ok(int status, const char *what)
{
    if (status != V_OK) {
        printf("%s: %d %s\n", what, status, v_last_error());
        failures++;
    }
}

static void check(int holds, const char *what)
{
    if (!holds) {
        printf("not so: %s\n", what);
        failures++;
    }
}

static void on_poses(V_EDITOR *editor, const V_POSE *poses, size_t count, void *user)
{
    (void)editor, (void)user;
    free(handed);
    handed = malloc(count * sizeof *poses);
    memcpy(handed, poses, count * sizeof *poses);
    handed_over = count;
}

static void on_view(V_EDITOR *editor, const V_POSE *pose, double frame, int reason, void *user)
{
    (void)editor, (void)pose, (void)user;
    reasons[reason]++;
    told = frame;
}

static void serve(int milliseconds)
{
    while (v_dispatch() >= 0 && milliseconds > 0) {
        struct pollfd watch;

        watch.fd = v_fd();
        watch.events = POLLIN;
        poll(&watch, 1, 10);
        milliseconds -= 10;
    }
}

/* Another path leaves the playhead at its frame if that is there; else it goes to the point. */
static void other_path(void)
{
    V_EDITOR *editor = NULL;
    V_PATH *path = NULL;
    double frame = 0;
    int frames, point = -1, orientation = -1;

    ok(v_path_new(&path), "path");
    ok(v_path_tool(path, "frames", "frames=200", NULL), "frames");
    ok(v_editor_open(NULL, &editor), "open");
    ok(v_editor_set_path(editor, path), "set_path");
    ok(v_editor_set_frame(editor, 150), "set_frame");
    for (frames = 180; frames >= 100; frames -= 80) {
        ok(v_path_tool(path, "frames", frames == 180 ? "frames=180" : "frames=100", NULL), "frames");
        ok(v_editor_set_path(editor, path), "set_path");
        serve(50);
        ok(v_editor_get_frame(editor, &frame), "get_frame");
        ok(v_editor_get_selection(editor, &point, &orientation), "get_selection");
        check(frame == (frames == 180 ? 150 : 1) && point == 0, "the playhead in another path");
    }
    ok(v_editor_close(editor), "close");
    v_path_free(path);
}

static V_SCENE *cameras(void)
{
    static const char *const names[] = {"camera", "by keys", "third"};
    static const double frames[] = {0.7, 900.3}, values[] = {0, 0.3, -1, 1, 0.2, -0.7};
    V_SCENE *scene = NULL;
    V_PATH *path = NULL;
    V_NODE node;
    int k;

    ok(v_scene_new(&scene), "scene");
    ok(v_path_new(&path), "path");
    v_node_init(&node, V_NODE_CAMERA);
    for (k = 1; k < 3; k++)
        ok(v_scene_add_node(scene, names[k], &node, NULL), names[k]);
    ok(v_scene_set_track(scene, 1, "position", "linear", frames, values, NULL, 2, V_AFTER_HOLD),
        "keys");
    ok(v_scene_set_path(scene, 2, path, 21, V_AFTER_PINGPONG), "path of the third");
    ok(v_scene_set_number(scene, "first_frame", 101), "first frame");
    v_path_free(path);
    return scene;
}

/* The poses of a file of comma separated values are these, to the last bit. */
static void in_file(const char *file, const V_POSE *poses, size_t count)
{
    static char line[1000];
    FILE *in = fopen(file, "r");
    size_t row = 0;

    check(in && fgets(line, sizeof line, in), "a file with a header");
    for (; in && fgets(line, sizeof line, in); row++) {
        double numbers[10];
        char *at = strchr(line, ',');
        int k;

        for (k = 0; k < 10; k++)
            numbers[k] = at ? strtod(at + 1, &at) : 0;
        if (row >= count || memcmp(numbers, &poses[row], sizeof numbers) != 0) {
            printf("row %lu of %s\n", (unsigned long)row + 1, file);
            failures++;
            break;
        }
    }
    check(row == count, "as many rows as poses");
    if (in)
        fclose(in);
}

static void shown(V_EDITOR *editor, int camera, const char *folder)
{
    char file[4096];
    double first, last;
    int k, before = reasons[V_VIEW_SELECTED], is = -1;
    V_SCENE *scene = NULL;
    V_PATH *path = NULL, *loaded = NULL;
    V_NODE_STATE *states;
    size_t at, same = 0;

    ok(v_editor_get_scene(editor, &scene), "get_scene");
    ok(v_scene_get_camera(scene, &is), "get_camera");
    ok(v_scene_set_camera(scene, camera), "set_camera");
    ok(v_editor_set_scene(editor, scene), "set_scene");
    v_scene_free(scene);
    serve(200);
    check((reasons[V_VIEW_SELECTED] > before) == (is != camera), "another camera is told as such");

    handed_over = 0;
    hands_hand_over(hands_window(0));
    for (k = 0; k < 500 && !handed_over; k++)
        serve(20);
    ok(v_editor_get_scene(editor, &scene), "get_scene");
    ok(v_scene_frame_range(scene, &first, &last), "frame_range");
    check(first == 0.7 && last == 900.3, "the range");
    check(handed_over == 900, "a pose for each frame");
    states = malloc(handed_over * sizeof *states);
    ok(v_scene_sample(scene, camera, first, 1, states, handed_over), "sample");
    for (at = 0; at < handed_over; at++)
        same += memcmp(&states[at].pose, &handed[at], sizeof *handed) == 0;
    check(same == 900, "the scene has what was handed over");
    free(states);
    sprintf(file, "%.4000s/film-%d.csv", folder, camera);
    ok(v_scene_export(scene, file, "csv", NULL), "export");
    in_file(file, handed, handed_over);
    sprintf(file, "%.4000s/film-%d.vid", folder, camera);
    ok(v_scene_save(scene, file), "save");
    v_scene_free(scene);

    if (camera == 1) {
        check(v_editor_get_path(editor, &path) == V_ERR_ARGUMENT, "keys are no path");
        check(v_path_load(file, &loaded) == V_ERR_ARGUMENT, "keys are no path of a file");
        ok(v_editor_select(editor, 0, 0), "the path that was edited still is");
    } else {
        V_POSE of_path, of_file;
        ok(v_editor_get_path(editor, &path), "get_path");
        ok(v_path_load(file, &loaded), "load");
        ok(v_path_pose(path, 7, &of_path), "pose");
        ok(v_path_pose(loaded, 7, &of_file), "pose");
        check(memcmp(&of_path, &of_file, sizeof of_path) == 0, "the path of the file");
        v_path_free(path);
        v_path_free(loaded);
    }
}

int main(int argc, char **argv)
{
    static const double all[] = {0.7, 1, 20.25, 400, 900.3};
    const char *folder = argc > 1 ? argv[1] : ".";
    V_EDITOR_OPTIONS options;
    V_EDITOR *editor = NULL;
    V_SCENE *scene = cameras();
    double frame;
    int k;

    if (!hands_connect())
        return 1;
    v_editor_options_init(&options);
    options.on_poses = on_poses;
    options.on_view = on_view;
    ok(v_editor_open(&options, &editor), "open");
    ok(v_editor_set_scene(editor, scene), "set_scene");
    v_scene_free(scene);
    serve(300);
    for (k = 0; k < 3; k++)
        shown(editor, k, folder);
    shown(editor, 0, folder);
    /* Any frame of the scene, though no path runs over all of them; no other. */
    for (k = 0; k < 5; k++) {
        ok(v_editor_set_frame(editor, all[k]), "set_frame");
        ok(v_editor_get_frame(editor, &frame), "get_frame");
        serve(100);
        check(frame == all[k] && told == all[k], "the frame is the scene's");
    }
    /* Another scene leaves it there. */
    ok(v_editor_get_scene(editor, &scene), "get_scene");
    ok(v_editor_set_scene(editor, scene), "set_scene");
    v_scene_free(scene);
    serve(100);
    ok(v_editor_get_frame(editor, &frame), "get_frame");
    check(frame == all[4], "the playhead stays");
    check(v_editor_set_frame(editor, 0.5) == V_ERR_RANGE, "before the first frame");
    check(v_editor_set_frame(editor, 900.5) == V_ERR_RANGE, "after the last frame");
    ok(v_editor_close(editor), "close");
    other_path();
    free(handed);
    hands_leave();
    return failures != 0;
}
