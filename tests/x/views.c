/*
 * The first view of a window: views FOLDER
 *
 * A new path looks at the object, or begins with the host's own view. A line for what is not so;
 * the exit status tells whether all is.
 */
#include <math.h>
#include <poll.h>
#include <stdio.h>
#include <string.h>

#include <libvides.h>

static int failures, views, frames;
static V_POSE told;

static void check(int holds, const char *what)
{
    if (!holds) {
        printf("%s: %s\n", what, v_last_error());
        failures++;
    }
}

static void on_view(V_EDITOR *of, const V_POSE *pose, double frame, int reason, void *user)
{
    (void)of, (void)frame, (void)reason, (void)user;
    told = *pose;
    views++;
}

static void on_frame(V_EDITOR *of, double frame, int reason, void *user)
{
    (void)of, (void)frame, (void)reason, (void)user;
    frames++;
}

/* Serves the windows for so many milliseconds. */
static void serve(int milliseconds)
{
    struct pollfd watch = {0, POLLIN, 0};
    for (watch.fd = v_fd(); milliseconds > 0; milliseconds -= 20) {
        poll(&watch, 1, 20);
        v_dispatch();
    }
}

/* How far from the middle of a square picture a place is seen, 1 at its edge. */
static double seen(const V_POSE *pose, const double place[3])
{
    double m[16], eye[3];
    int row;
    check(v_pose_matrix(pose, V_AXES_OPENGL, 0, m) == V_OK, "matrix");
    for (row = 0; row < 3; row++)
        eye[row] = m[row] * place[0] + m[4 + row] * place[1] + m[8 + row] * place[2] + m[12 + row];
    if (eye[2] >= 0)
        return INFINITY;
    return fmax(fabs(eye[0]), fabs(eye[1])) / -eye[2] * pose->zoom / 12;
}

static V_EDITOR *opened(const V_EDITOR_OPTIONS *options, const char *what)
{
    V_EDITOR *editor = NULL;
    check(v_editor_open(options, &editor) == V_OK, what);
    return editor;
}

static int same(const V_POSE *a, const V_POSE *b)
{
    const double *x = a->vrp, *y = b->vrp;
    int k;
    for (k = 0; k < 10; k++)
        if (fabs(x[k] - y[k]) > 1e-12)
            return 0;
    return 1;
}

/* All of a box is in the first and the last picture, and it is in the middle. */
static void looks_at(V_EDITOR *editor, const double *xyz, const double middle[3], const char *what)
{
    V_PATH *path = NULL;
    V_POSE pose;
    size_t last = 1;
    int corner, end;
    check(v_editor_get_path(editor, &path) == V_OK, what);
    check(v_path_frame_count(path, &last) == V_OK && last > 1, what);
    for (end = 0; end < 2; end++) {
        check(v_path_pose(path, end ? (double)last : 1, &pose) == V_OK, what);
        for (corner = 0; corner < 8; corner++)
            check(seen(&pose, xyz + 3 * corner) < 1, what);
        check(seen(&pose, middle) < 1e-9, what);
    }
    v_path_free(path);
}

int main(int argc, char **argv)
{
    static const unsigned lines[8] = {0, 1, 2, 3, 4, 5, 6, 7};
    double box[8][3], middle[3] = {0.3, -0.2, 0.1};
    char file[4096];
    V_MESH object;
    V_EDITOR_OPTIONS options;
    V_EDITOR *editor;
    V_PATH *path = NULL;
    V_POSE view = {{4, 3, 2}, {-8, -5, -4}, {0, 1, 0.25}, 35}, first;
    int k, up;

    opened(NULL, "first"); /* so that the server always has a client */
    memset(&object, 0, sizeof object);
    object.size = sizeof object;
    object.xyz = box[0];
    object.points = 8;
    object.lines = lines;
    object.line_ends = 8;
    for (up = V_UP_Y; up <= V_UP_Z; up++) {
        double half;
        for (half = 0.05; half < 0.4; half += 0.1) {
            for (k = 0; k < 24; k++)
                box[k / 3][k % 3] = middle[k % 3] + (k / 3 >> k % 3 & 1 ? half : -half);
            v_editor_options_init(&options);
            options.object = &object;
            options.space_up = up;
            editor = opened(&options, "an object");
            looks_at(editor, box[0], middle, "an object");
            v_editor_close(editor);
        }
    }

    /* The host's own view. */
    v_editor_options_init(&options);
    options.space_half_size = 10;
    options.on_view = on_view;
    options.on_frame = on_frame;
    editor = opened(&options, "no view");
    serve(400);
    check(views == 2 && frames == 2, "on_view and on_frame are called at once, and at rest");
    v_editor_close(editor);
    views = frames = 0;
    options.object = &object;
    options.view = &view;
    editor = opened(&options, "a view");
    serve(400);
    check(views == 0, "on_view is called where the host's picture stays");
    check(frames == 2, "on_frame is not called");
    check(v_editor_get_path(editor, &path) == V_OK, "get_path");
    check(v_path_pose(path, 1, &first) == V_OK, "pose");
    check(v_editor_select(editor, 1, 0) == V_OK, "select");
    serve(400);
    check(views == 2, "on_view is called for another point");
    check(v_editor_select(editor, 0, 0) == V_OK, "select");
    serve(400);
    check(views == 4 && same(&told, &first), "on_view tells the host's own view");
    for (k = 0; k < 3; k++)
        check(first.vrp[k] == view.vrp[k], "the view's place");
    {
        double length = sqrt(64 + 25 + 16);
        for (k = 0; k < 3; k++)
            check(fabs(first.vpn[k] - view.vpn[k] / length) < 1e-12, "the view's direction");
    }
    check(first.zoom == 35, "the view's zoom");
    v_editor_close(editor);

    /* A path that is given stays what it is, and the picture what it was. */
    sprintf(file, "%.4000s/given.vid", argc > 1 ? argv[1] : ".");
    check(v_path_save(path, file) == V_OK, "save");
    for (k = 0; k < 2; k++) {
        V_PATH *held = NULL;
        V_POSE begins;
        V_POSE other = {{1, 1, 1}, {-1, -1, -1}, {0, 1, 0}, 50};
        v_editor_options_init(&options);
        options.view = &other;
        options.on_view = on_view;
        options.path = k ? path : NULL;
        options.file = k ? NULL : file;
        views = 0;
        editor = opened(&options, "a path with a view");
        serve(400);
        check(views == 0, "on_view is called for a given path");
        check(v_editor_get_path(editor, &held) == V_OK && v_path_pose(held, 1, &begins) == V_OK
                  && same(&begins, &first), "the given path");
        v_path_free(held);
        v_editor_close(editor);
    }
    v_path_free(path);

    /* What is no view is refused. */
    v_editor_options_init(&options);
    view.vup[0] = view.vpn[0], view.vup[1] = view.vpn[1], view.vup[2] = view.vpn[2];
    options.view = &view;
    check(v_editor_open(&options, &editor) == V_ERR_ARGUMENT, "a view along its up");
    view.vrp[0] = INFINITY;
    check(v_editor_open(&options, &editor) == V_ERR_ARGUMENT, "a view from nowhere");
    printf("views %d\n", failures);
    return failures != 0;
}
