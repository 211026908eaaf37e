/*
 * The told host with a picture of its own: it is told of the flight while it is
 * planned, and tells the window. A poll() loop as in loop_poll.c.
 */
#include <poll.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>
#include <unistd.h>

#include <libvides.h>

#include "host.h"

#define VIEWS 20000

/* What on_view was told. */
static struct view { double at, frame; int reason; V_POSE pose; } views[VIEWS];
static int seen, other_poses, changes, captures, handed_over;
static long delay_ms, dispatched, most;
static double longest, step, frames_of_path;
static char within[20]; /* what the next call of on_view does */
static V_POSE camera = {{0.2, 0.6, 0.9}, {0, 0, -1}, {0, 1, 0}, 24};
static int has_camera = 1;
static V_EDITOR *editor;

static double now_ms(void)
{
    struct timespec time;
    clock_gettime(CLOCK_MONOTONIC, &time);
    return 1e3 * time.tv_sec + 1e-6 * time.tv_nsec;
}

/* The pose is the path's, to the last bit. */
static void compare(const V_POSE *pose, double frame)
{
    V_PATH *path;
    V_POSE again;

    if (v_editor_get_path(editor, &path) != V_OK)
        return;
    if (v_path_pose(path, frame, &again) != V_OK || memcmp(&again, pose, sizeof again) != 0)
        other_poses++;
    v_path_free(path);
}

static void on_view(V_EDITOR *told, const V_POSE *pose, double frame, int reason, void *user)
{
    struct view *view = &views[seen % VIEWS];
    int status;

    (void)user;
    view->at = now_ms();
    view->frame = frame;
    view->reason = reason;
    view->pose = *pose;
    seen++;
    if (frames_of_path == 0)
        compare(pose, frame); /* not while it plays against the clock */
    dispatched++;
    if (delay_ms > 0)
        usleep((useconds_t)delay_ms * 1000);
    if (strcmp(within, "close") == 0) {
        status = v_editor_close(told);
        say("within %d", status);
        editor = NULL;
    } else if (strcmp(within, "frame") == 0) {
        status = v_editor_set_frame(told, 7.5);
        say("within %d", status);
    } else if (strcmp(within, "select") == 0) {
        status = v_editor_select(told, 1, 0);
        say("within %d", status);
    } else if (strcmp(within, "object") == 0) {
        status = v_editor_set_object(told, NULL);
        say("within %d", status);
    } else if (strcmp(within, "sleep") == 0) {
        sleep(10);
        say("within 0");
    }
    within[0] = '\0';
}

static void on_change(V_EDITOR *told, void *user)
{
    (void)told, (void)user;
    changes++;
}

static int on_capture(V_EDITOR *told, V_POSE *pose, void *user)
{
    (void)told, (void)user;
    captures++;
    *pose = camera;
    return has_camera;
}

static void on_poses(V_EDITOR *told, const V_POSE *poses, size_t count, void *user)
{
    (void)told, (void)poses, (void)count, (void)user;
    handed_over++;
}

static void open_live(const char *file)
{
    V_EDITOR_OPTIONS options;
    int status;

    v_editor_options_init(&options);
    options.file = file[0] != '\0' ? file : NULL;
    options.on_view = on_view;
    options.on_change = on_change;
    options.on_capture = on_capture;
    options.on_poses = on_poses;
    options.host_name = "Viewer";
    status = v_editor_open(&options, &editor);
    say("live %d %s", status, v_last_error());
}

/* count, others than the path's, changes, captures, hand-overs; the last one. */
static void summary(void)
{
    const struct view *last = &views[(seen + VIEWS - 1) % VIEWS];
    const V_POSE *p = &last->pose;

    say("views %d %d %d %d %d last %d %.17g %.17g %.17g %.17g %.17g %.17g %.17g %.17g %.17g %.17g %.17g",
        seen, other_poses, changes, captures, handed_over, last->reason, last->frame, p->vrp[0],
        p->vrp[1], p->vrp[2], p->vpn[0], p->vpn[1], p->vpn[2], p->vup[0], p->vup[1], p->vup[2],
        p->zoom);
}

static void points(void)
{
    V_PATH *path;
    double xyz[3];
    size_t three;
    int count = 0, i;
    char line[3000] = "";

    if (v_editor_get_path(editor, &path) == V_OK) {
        v_path_point_count(path, &count);
        for (i = 0; i < count && i < 40; i++) {
            v_path_get_numbers(path, v_path_key(i, -1, "position"), xyz, 3, &three);
            sprintf(line + strlen(line), " %.17g %.17g %.17g", xyz[0], xyz[1], xyz[2]);
        }
        v_path_free(path);
    }
    say("points %d%s", count, line);
}

static void write_log(const char *file)
{
    FILE *out = fopen(file, "w");
    int i;

    for (i = 0; out != NULL && i < seen && i < VIEWS; i++)
        fprintf(out, "%.6f %.17g %d\n", views[i].at, views[i].frame, views[i].reason);
    if (out != NULL)
        fclose(out);
    say("log %d", seen);
}

int loop_command(const char *name, char *rest)
{
    double number = atof(rest);
    int status, whole = 0;

    rest[strcspn(rest, "\n")] = '\0';
    if (strcmp(name, "live") == 0) {
        open_live(rest);
    } else if (strcmp(name, "views") == 0) {
        summary();
    } else if (strcmp(name, "points") == 0) {
        points();
    } else if (strcmp(name, "log") == 0) {
        write_log(rest);
    } else if (strcmp(name, "reset") == 0) {
        seen = 0;
        longest = most = 0;
        say("reset");
    } else if (strcmp(name, "longest") == 0) {
        say("longest %.3f calls %ld", longest, most);
    } else if (strcmp(name, "delay") == 0) {
        delay_ms = (long)number;
        say("delay %ld", delay_ms);
    } else if (strcmp(name, "clocked") == 0) {
        frames_of_path = number;
        say("clocked");
    } else if (strcmp(name, "in-view") == 0) {
        strncpy(within, rest, sizeof within - 1);
        say("in-view");
    } else if (strcmp(name, "camera") == 0) {
        has_camera = sscanf(rest, "%lf %lf %lf %lf %lf %lf %lf %lf %lf %lf", &camera.vrp[0],
                            &camera.vrp[1], &camera.vrp[2], &camera.vpn[0], &camera.vpn[1],
                            &camera.vpn[2], &camera.vup[0], &camera.vup[1], &camera.vup[2],
                            &camera.zoom) == 10;
        say("camera %d", has_camera);
    } else if (strcmp(name, "ghost") == 0) {
        status = v_editor_set_view(editor, number != 0 ? &camera : NULL);
        say("ghost %d %s", status, v_last_error());
    } else if (strcmp(name, "frame") == 0) {
        status = v_editor_set_frame(editor, number);
        say("frame %d %s", status, v_last_error());
    } else if (strcmp(name, "at") == 0) {
        status = v_editor_get_frame(editor, &number);
        say("at %d %.17g", status, number);
    } else if (strcmp(name, "play") == 0) {
        step = now_ms();
        status = v_editor_play(editor, number != 0);
        say("play %d %.6f", status, step);
    } else if (strcmp(name, "select") == 0) {
        sscanf(rest, "%d %d", &status, &whole);
        status = v_editor_select(editor, status, whole);
        say("select %d %s", status, v_last_error());
    } else if (strcmp(name, "undo") == 0) {
        status = v_editor_undo(editor);
        say("undo %d %s", status, v_last_error());
    } else if (strcmp(name, "redo") == 0) {
        status = v_editor_redo(editor);
        say("redo %d %s", status, v_last_error());
    } else if (strcmp(name, "step") == 0) {
        status = number != 0 ? v_editor_begin_step(editor) : v_editor_end_step(editor);
        say("step %d %s", status, v_last_error());
    } else if (strcmp(name, "current") == 0) {
        int point = -1, orientation = -1;
        status = v_editor_get_selection(editor, &point, &orientation);
        say("current %d %d %d", status, point, orientation);
    } else if (strcmp(name, "plays") == 0) {
        status = v_editor_is_playing(editor, &whole);
        say("plays %d %d", status, whole);
    } else if (strcmp(name, "title") == 0) {
        status = v_editor_set_title(editor, rest[0] != '\0' ? rest : NULL);
        say("title %d", status);
    } else if (strcmp(name, "modified") == 0) {
        status = v_editor_is_modified(editor, &whole);
        say("modified %d %d", status, whole);
    } else if (strcmp(name, "keep") == 0) {
        status = v_editor_save(editor, rest[0] != '\0' ? rest : NULL);
        say("keep %d %s", status, v_last_error());
    } else if (strcmp(name, "raise") == 0) {
        status = v_editor_raise(editor);
        say("raise %d", status);
    } else {
        return 0;
    }
    return 1;
}

int main(void)
{
    struct pollfd watch[2];
    double start;

    begin();
    watch[0].fd = 0;
    watch[0].events = watch[1].events = POLLIN;
    for (;;) {
        start = now_ms();
        dispatched = 0;
        v_dispatch();
        if (dispatched > most)
            most = dispatched;
        if (now_ms() - start > longest)
            longest = now_ms() - start;
        watch[1].fd = v_fd();
        watch[0].revents = 0;
        if (poll(watch, 2, v_timeout()) > 0 && watch[0].revents != 0)
            commands();
    }
}
