/* What the calls work on: see things.h. */
#include "things.h"

#include <math.h>
#include <stdarg.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

const char *const callback_names[CALLBACKS] = {
    "rueck", "ende", "on_poses", "on_close", "on_view", "on_frame", "on_change",
    "on_capture", "on_pane", "on_gone"
};
int (*within_callback)(enum callback which, V_EDITOR *editor);
int depth, faults, display_there, windows_may_go;
long callback_count[CALLBACKS];
const char *folder;
V_EDITOR *editors[EDITORS], *this_editor;
V_KAMERAPAR *this_list, *given_list;

static V_PATH *paths[PATHS];
static void *stale[16]; /* handles that are valid no more */
static V_KAMERAPAR lists[LISTS];

void fault(const char *format, ...)
{
    va_list arguments;

    faults++;
    fprintf(stderr, "FAULT: ");
    va_start(arguments, format);
    vfprintf(stderr, format, arguments);
    va_end(arguments);
    fputc('\n', stderr);
}

/* ---- Callbacks ------------------------------------------------------------------ */

static int called(enum callback which, V_EDITOR *editor)
{
    int answer = 1;

    callback_count[which]++;
    depth++;
    if (within_callback != NULL)
        answer = within_callback(which, editor);
    depth--;
    return answer;
}

void callback_rueck(V_KAMERAPAR *first, int count)
{
    const V_KAMERAPAR *element = first;
    int i;

    for (i = 1; i <= count; i++, element = element->next)
        if (element->number != i || element->next->prev != element || !isfinite(element->VRP.x))
            break;
    if (i <= count || element != first || first->prev->number != count)
        fault("rueck was given a list that is none, at %d of %d", i, count);
    given_list = first;
    called(RUECK, NULL);
}

int callback_ende(void)
{
    return called(ENDE, NULL);
}

static void look_at(const V_POSE *poses, size_t count)
{
    size_t i;

    for (i = 0; i < count; i++) {
        const double *vpn = poses[i].vpn;
        if (!(fabs(vpn[0] * vpn[0] + vpn[1] * vpn[1] + vpn[2] * vpn[2] - 1) < 1e-9)
            || !isfinite(poses[i].vrp[0])) {
            fault("pose %lu of on_poses is none", (unsigned long)i);
            return;
        }
    }
}

void callback_on_poses(V_EDITOR *editor, const V_POSE *poses, size_t count, void *user)
{
    if (user != (void *)lists || count == 0)
        fault("on_poses was given another user or nothing");
    look_at(poses, count);
    called(ON_POSES, editor);
    look_at(poses, count); /* theirs until we return, whatever happened */
}

int callback_on_close(V_EDITOR *editor, void *user)
{
    if (user != (void *)lists)
        fault("on_close was given another user");
    return called(ON_CLOSE, editor);
}

void callback_on_view(V_EDITOR *editor, const V_POSE *pose, double at, int reason, void *user)
{
    if (user != (void *)lists || !(at >= 1) || reason < V_VIEW_SELECTED || reason > V_VIEW_RESTED)
        fault("on_view was given another user, frame %g or reason %d", at, reason);
    look_at(pose, 1);
    called(ON_VIEW, editor);
    look_at(pose, 1);
}

void callback_on_frame(V_EDITOR *editor, double at, int reason, void *user)
{
    if (user != (void *)lists || !isfinite(at) || reason < V_VIEW_SELECTED
        || reason > V_VIEW_RESTED)
        fault("on_frame was given another user, frame %g or reason %d", at, reason);
    called(ON_FRAME, editor);
}

void callback_on_change(V_EDITOR *editor, void *user)
{
    if (user != (void *)lists)
        fault("on_change was given another user");
    called(ON_CHANGE, editor);
}

int callback_on_capture(V_EDITOR *editor, V_POSE *pose, void *user)
{
    static const V_POSE camera = {{0.3, 0.5, -0.2}, {0, -3, 4}, {0, 4, 3.5}, 30};

    if (user != (void *)lists)
        fault("on_capture was given another user");
    *pose = camera;
    return called(ON_CAPTURE, editor);
}

void callback_on_pane(V_EDITOR *editor, unsigned long window, int width, int height, void *user)
{
    if (user != (void *)lists || (window == 0) != (width == 0) || (window == 0) != (height == 0))
        fault("on_pane was given another user, or %d x %d of %#lx", width, height, window);
    called(ON_PANE, editor);
}

void callback_on_gone(V_EDITOR *editor, int reason, void *user)
{
    int modified;

    if (user != (void *)lists || reason < V_GONE_BY_USER || reason > V_GONE_FAULT)
        fault("on_gone was given another user, or reason %d", reason);
    if (v_editor_is_modified(editor, &modified) != V_ERR_CLOSED)
        fault("a window that has gone is open: %s", v_last_error());
    called(ON_GONE, editor);
}

/* ---- What calls work on ------------------------------------------------------------ */

void make_stale(void *handle)
{
    stale[below(16)] = handle;
}

/* A handle that is not one of this kind. */
static void *no_handle(void *one)
{
    static int something;
    void *odd[8];

    odd[0] = NULL;
    odd[1] = stale[below(16)];
    odd[2] = paths[below(PATHS)];
    odd[3] = editors[below(EDITORS)];
    odd[4] = &something;
    odd[5] = (void *)((uintptr_t)below(~0u) << 32 | below(~0u) | 1u);
    odd[6] = (void *)(uintptr_t)below(9);
    odd[7] = (void *)((uintptr_t)one ^ (uintptr_t)1 << below(64));
    return odd[below(8)];
}

void *handle(void *one)
{
    if (chance(wild)) {
        frame->unfit = 1;
        one = no_handle(one);
    }
    word("%p", one);
    return one;
}

/* A new path takes the place of an older one. */
void keep_path(V_PATH *made)
{
    unsigned i = below(PATHS);

    if (paths[i] != NULL) {
        make_stale(paths[i]);
        v_path_free(paths[i]);
    }
    paths[i] = made;
}

/* A path with everything: a pan, a tracked target, a roll, a hold. */
static V_PATH *rich_path(void)
{
    static const double places[3][3] = {{0, 0.6, -0.2}, {0.3, 0.1, 0.2}, {-0.4, -0.5, 0.1}};
    V_ORIENTATION o;
    V_PATH *path;
    int i;

    if (v_path_new(&path) != V_OK || v_path_set_numbers(path, "base_speeds", (const double[]){20,
        15, 15, 15}, 4) != V_OK) {
        fault("v_path_new: %s", v_last_error());
        exit(2);
    }
    v_orientation_init(&o);
    for (i = 0; i < 3; i++) {
        o.absolute = i != 1;
        o.target[0] = 0.01;
        o.roll = 20 * i;
        o.hold = i;
        o.zoom = 24 + i;
        if (v_path_insert_point(path, 1 + i, places[i]) != V_OK
            || v_path_set_orientation(path, 1 + i, 0, &o) != V_OK
            || v_path_insert_orientation(path, 1 + i, 1, NULL) != V_OK)
            fault("a path cannot be made: %s", v_last_error());
    }
    return path;
}

/* One of the paths, and what can be asked about it. */
V_PATH *a_path(void)
{
    int i = (int)below(PATHS), points;
    size_t frames;

    /* A call may have freed it, or left little of it, or made it very long. */
    if (paths[i] == NULL || v_path_point_count(paths[i], &points) != V_OK || points < 4
        || points > 40 || v_path_frame_count(paths[i], &frames) != V_OK || frames > POSES) {
        if (paths[i] != NULL) {
            make_stale(paths[i]);
            v_path_free(paths[i]);
        }
        paths[i] = rich_path();
    }
    return handle(paths[i]);
}

int points_of(const V_PATH *path)
{
    int count;

    return v_path_point_count(path, &count) == V_OK ? count : 2;
}

int orientations_of(const V_PATH *path, int point)
{
    int count;

    return v_path_orientation_count(path, point, &count) == V_OK ? count : 1;
}

int a_point(const V_PATH *path)
{
    return whole(0, points_of(path) - 1);
}

int a_segment(const V_PATH *path)
{
    return whole(0, points_of(path) - 2);
}

int an_orientation(const V_PATH *path, int point)
{
    return whole(0, orientations_of(path, point) - 1);
}

/* A point that has room for another orientation, or one to spare. */
int a_point_with(const V_PATH *path, int least, int most)
{
    int i, count, points = points_of(path), first = (int)below((unsigned)points);

    for (i = 0; i < points; i++) {
        int point = (first + i) % points;
        count = orientations_of(path, point);
        if (count >= least && count <= most)
            return whole(point, point);
    }
    frame->unfit = 1; /* there is none */
    return whole(0, points - 1);
}

const char *a_file(const char *fit)
{
    static char endless[6000];
    char name[400];

    snprintf(name, sizeof name, "%.300s/%s", folder, fit);
    if (chance(wild)) {
        frame->unfit = 1;
        memset(endless, 'x', sizeof endless - 1);
        switch (below(7)) {
        case 0:
            return text(NULL);
        case 1:
            return text("");
        case 2:
            return text(endless);
        case 3:
            snprintf(name, sizeof name, "%.300s", folder);
            break;
        case 4:
            snprintf(name, sizeof name, "%.300s/no/such/file", folder);
            break;
        case 5:
            snprintf(name, sizeof name, "%.300s/broken.vid", folder);
            break;
        default:
            snprintf(name, sizeof name, "%.300s/\377\376", folder);
        }
    }
    return text(name);
}

/* ---- Windows --------------------------------------------------------------------- */

V_EDITOR *an_editor(void)
{
    unsigned i = below(EDITORS);

    if (this_editor != NULL)
        return handle(this_editor);
    frame->unfit |= editors[i] == NULL;
    return handle(editors[i]);
}

void keep_editor(V_EDITOR *made)
{
    unsigned i = below(EDITORS);

    if (editors[i] != NULL) {
        make_stale(editors[i]);
        v_editor_close(editors[i]);
    }
    editors[i] = made;
}

V_KAMERAPAR *a_list(void)
{
    V_KAMERAPAR *list = this_list != NULL ? this_list : &lists[below(LISTS)];

    if (chance(wild)) {
        frame->unfit = 1;
        if (chance(50)) {
            word("NULL");
            return NULL;
        }
        frame->unaligned = 1;
        word("(not aligned)");
        return (V_KAMERAPAR *)(void *)((char *)list + 1);
    }
    word("list %ld", (long)(list - lists));
    return list;
}

void *a_user(void)
{
    return lists;
}

static void write_file(const char *called, const char *text)
{
    char name[400];
    FILE *file;

    snprintf(name, sizeof name, "%.300s/%s", folder, called);
    file = fopen(name, "w");
    if (file != NULL) {
        fputs(text, file);
        fclose(file);
    }
}

void fresh_things(void)
{
    char name[400];
    int i;

    end_things();
    for (i = 0; i < LISTS; i++)
        lists[i].number = -1;
    for (i = 0; i < PATHS; i++)
        paths[i] = rich_path();
    snprintf(name, sizeof name, "%.300s/a.vid", folder);
    if (v_path_save(paths[0], name) != V_OK)
        fault("v_path_save: %s", v_last_error());
    write_file("broken.vid", "version = 1\n[[point]]\nposition = [0, 0, nan]\n");
    write_file("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nf 1 2 3\n");
}

void end_things(void)
{
    int i;

    for (i = 0; i < EDITORS; i++) {
        if (editors[i] != NULL)
            v_editor_close(editors[i]);
        editors[i] = NULL;
    }
    for (i = 0; i < PATHS; i++) {
        if (paths[i] != NULL)
            v_path_free(paths[i]);
        paths[i] = NULL;
    }
    for (i = 0; i < LISTS; i++)
        if (lists[i].number >= 0) /* all zero at first: a list that is none */
            v_free_liste(&lists[i]);
}
