/*
 * The told host with several windows that may lie behind one another, be
 * iconified, or be in a parent that is not shown: what each was told. A poll()
 * loop as in loop_poll.c.
 */
#include <poll.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <X11/Xlib.h>

#include <libvides.h>

#include "host.h"

#define MOST 4

static V_EDITOR *editors[MOST];
/* How often each was called, how often while it played, and what it heard last. */
static struct told { int views, frames, changes, poses, played, reason; double frame; } told[MOST];

static void on_view(V_EDITOR *editor, const V_POSE *pose, double frame, int reason, void *user)
{
    struct told *mine = user;

    (void)editor, (void)pose;
    mine->views++;
    mine->played += reason == V_VIEW_PLAYED;
    mine->reason = reason;
    mine->frame = frame;
}

static void on_frame(V_EDITOR *editor, double frame, int reason, void *user)
{
    (void)editor, (void)frame, (void)reason;
    ((struct told *)user)->frames++;
}

static void on_change(V_EDITOR *editor, void *user)
{
    (void)editor;
    ((struct told *)user)->changes++;
}

static void on_poses(V_EDITOR *editor, const V_POSE *poses, size_t count, void *user)
{
    (void)editor, (void)poses, (void)count;
    ((struct told *)user)->poses++;
}

static void open_one(int which, unsigned long parent)
{
    V_EDITOR_OPTIONS options;
    int status;

    v_editor_options_init(&options);
    options.on_view = on_view;
    options.on_frame = on_frame;
    options.on_change = on_change;
    options.on_poses = on_poses;
    options.parent = parent;
    options.user = &told[which];
    status = v_editor_open(&options, &editors[which]);
    say("open %d %s", status, v_last_error());
}

/* A window that the server does not show. */
static unsigned long unmapped(void)
{
    Display *display = XOpenDisplay(NULL);
    unsigned long window = XCreateSimpleWindow(display, DefaultRootWindow(display), 0, 0, 900, 700,
                                               0, 0, 0);

    XSync(display, False);
    return window;
}

/* The first point, elsewhere. */
static int alter(V_EDITOR *editor, double x)
{
    double xyz[3] = {0.0, 0.25, 0.125};
    V_PATH *path;
    int status = v_editor_get_path(editor, &path);

    xyz[0] = x;
    if (status == V_OK) {
        v_path_set_numbers(path, "point.1.position", xyz, 3);
        status = v_editor_set_path(editor, path);
        v_path_free(path);
    }
    return status;
}

int loop_command(const char *name, char *rest)
{
    int which = atoi(rest) % MOST, status;
    struct told *mine = &told[which];
    double number = 0;

    sscanf(rest, "%*d %lf", &number);
    if (strcmp(name, "open") == 0) {
        open_one(which, 0);
    } else if (strcmp(name, "open-unseen") == 0) {
        open_one(which, unmapped());
    } else if (strcmp(name, "told") == 0) {
        say("told %d %d %d %d %d %d %.17g", mine->views, mine->frames, mine->changes, mine->poses,
            mine->played, mine->reason, mine->frame);
    } else if (strcmp(name, "go") == 0) { /* and what came of it in the next dispatch */
        int views = mine->views, frames = mine->frames;
        status = v_editor_set_frame(editors[which], number);
        v_dispatch();
        say("go %d %d %d", status, mine->views - views, mine->frames - frames);
    } else if (strcmp(name, "select") == 0) {
        int views = mine->views, frames = mine->frames;
        status = v_editor_select(editors[which], (int)number, 0);
        v_dispatch();
        say("select %d %d %d", status, mine->views - views, mine->frames - frames);
    } else if (strcmp(name, "alter") == 0) {
        int views = mine->views, changes = mine->changes;
        status = alter(editors[which], number);
        v_dispatch();
        say("alter %d %d %d", status, mine->views - views, mine->changes - changes);
    } else if (strcmp(name, "play") == 0) {
        say("play %d", v_editor_play(editors[which], number != 0));
    } else {
        return 0;
    }
    return 1;
}

int main(void)
{
    struct pollfd watch[2];

    begin();
    watch[0].fd = 0;
    watch[0].events = watch[1].events = POLLIN;
    for (;;) {
        v_dispatch();
        watch[1].fd = v_fd();
        watch[0].revents = 0;
        if (poll(watch, 2, v_timeout()) > 0 && watch[0].revents != 0)
            commands();
    }
}
