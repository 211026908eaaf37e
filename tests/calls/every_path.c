/* The functions of paths and of the toolbox: see every.h. */
#include <string.h>

#include "functions.h"
#include "things.h"

/* ---- Structs --------------------------------------------------------------------------- */

static const V_ORIENTATION *an_orientation_struct(void)
{
    V_ORIENTATION o;
    int i;

    v_orientation_init(&o);
    if (chance(wild)) {
        const size_t sizes[] = {0, (size_t)-1, sizeof o + 1, sizeof o - 1, 8};
        frame->unfit = 1;
        o.size = sizes[below(5)];
        word("size %lu", (unsigned long)o.size);
    }
    o.absolute = whole(0, 1);
    for (i = 0; i < 3; i++)
        o.target[i] = number(3, 5); /* far from every point */
    o.roll = number(-720, 720);
    o.zoom = number(1, 2000);
    o.tension = number(-1, 1);
    o.continuity = number(-1, 1);
    o.bias = number(-1, 1);
    for (i = 0; i < 10; i++)
        o.speed[i] = number(1, 100);
    o.hold = whole(0, 3);
    return given("V_ORIENTATION", &o, sizeof o);
}

static V_VIEW a_view(void)
{
    V_VIEW view = {sizeof view, {0, 0, 0}, {0, 0, 1}, {0, 1, 0}, {0, 0, 2}, {-1, 1, -1, 1},
                   1, -1, 0, 0};
    if (chance(wild)) {
        frame->unfit = 1;
        view.size = below(400);
    }
    view.vrp[0] = number(-1, 1);
    view.normal[0] = number(-0.5, 0.5);
    view.up[1] = number(0.5, 1);
    view.prp[2] = number(2, 3);
    view.window[1] = number(0, 2);
    view.front = number(0, 1);
    view.back = number(-2, -1);
    view.distance = number(-1, 1);
    view.perspective = whole(0, 1);
    return view;
}

const V_POSE *a_pose(void)
{
    V_POSE pose = {{0, 0, 0}, {0, 0, 1}, {0, 1, 0}, 24};

    pose.vrp[1] = number(-1, 1);
    pose.vpn[0] = number(-1, 1);
    pose.vup[1] = number(0.5, 1);
    pose.zoom = number(1, 2000);
    return given("V_POSE", &pose, sizeof pose);
}

/* ---- Paths --------------------------------------------------------------------------- */

CALL(v_path_new)
{
    V_PATH **path = result(sizeof *path, 0);
    int status = v_path_new(path);

    if (status == V_OK)
        frame->made_path = *path;
    return status;
}

CALL(v_path_clone)
{
    const V_PATH *path = a_path();
    V_PATH **copy = result(sizeof *copy, 0);
    int status = v_path_clone(path, copy);

    if (status == V_OK)
        frame->made_path = *copy;
    return status;
}

CALL(v_path_free)
{
    V_PATH *path = a_path();

    make_stale(path);
    v_path_free(path);
    return 0;
}

CALL(v_path_load)
{
    const char *file = a_file("a.vid");
    V_PATH **path = result(sizeof *path, 0);
    int status = v_path_load(file, path);

    if (status == V_OK)
        frame->made_path = *path;
    return status;
}

CALL(v_path_load_from_memory)
{
    static const char fit[] = "version = 1\n[[point]]\nposition = [0.0, 0.0, 0.0]\n"
                              "[[point.orientation]]\noffset = [0.0, 0.0, -1.0]\n"
                              "[[point]]\nposition = [1.0, 0.0, 0.0]\n"
                              "[[point.orientation]]\noffset = [0.0, 0.0, -1.0]\n";
    const char *lines = given("text", fit, sizeof fit - 1);
    V_PATH **path = result(sizeof *path, 0);
    int status = v_path_load_from_memory(lines, sizeof fit - 1, path);

    if (status == V_OK)
        frame->made_path = *path;
    return status;
}

CALL(v_path_save)
{
    const V_PATH *path = a_path();
    return v_path_save(path, a_file("b.vid"));
}

CALL(v_path_point_count)
{
    const V_PATH *path = a_path();
    return v_path_point_count(path, result(sizeof(int), 0));
}

CALL(v_path_insert_point)
{
    V_PATH *path = a_path();
    int at = whole(0, points_of(path));
    return v_path_insert_point(path, at, numbers(3, -1, 1));
}

CALL(v_path_divide_segment)
{
    V_PATH *path = a_path();
    int segment = a_segment(path);
    return v_path_divide_segment(path, segment, whole(1, 10));
}

CALL(v_path_remove_point)
{
    V_PATH *path = a_path();
    return v_path_remove_point(path, a_point(path));
}

CALL(v_orientation_init)
{
    v_orientation_init(result(sizeof(V_ORIENTATION), 0));
    return 0;
}

CALL(v_path_orientation_count)
{
    const V_PATH *path = a_path();
    int point = a_point(path);
    return v_path_orientation_count(path, point, result(sizeof(int), 0));
}

CALL(v_path_insert_orientation)
{
    V_PATH *path = a_path();
    int point = a_point_with(path, 1, 9), at = whole(0, orientations_of(path, point));
    return v_path_insert_orientation(path, point, at, chance(30) ? NULL : an_orientation_struct());
}

CALL(v_path_remove_orientation)
{
    V_PATH *path = a_path();
    int point = a_point_with(path, 2, 10);
    return v_path_remove_orientation(path, point, an_orientation(path, point));
}

CALL(v_path_set_orientation)
{
    V_PATH *path = a_path();
    int point = a_point(path), at = an_orientation(path, point);
    return v_path_set_orientation(path, point, at, an_orientation_struct());
}

CALL(v_path_get_orientation)
{
    const V_PATH *path = a_path();
    int point = a_point(path), at = an_orientation(path, point);
    V_ORIENTATION o;

    memset(&o, 0x5A, sizeof o);
    o.size = chance(wild) ? below(400) : sizeof o;
    frame->unfit |= o.size != sizeof o;
    return v_path_get_orientation(path, point, at,
                                  (V_ORIENTATION *)given("V_ORIENTATION", &o, sizeof o));
}

CALL(v_path_set_absolute)
{
    V_PATH *path = a_path();
    int point = a_point(path), at = an_orientation(path, point);
    return v_path_set_absolute(path, point, at, whole(0, 1));
}

CALL(v_path_length)
{
    const V_PATH *path = a_path();
    return v_path_length(path, result(sizeof(double), 0));
}

CALL(v_path_segment_length)
{
    const V_PATH *path = a_path();
    int segment = a_segment(path);
    return v_path_segment_length(path, segment, result(sizeof(double), 0));
}

CALL(v_path_curve_point)
{
    const V_PATH *path = a_path();
    int segment = a_segment(path);
    double t = number(0, 1);
    return v_path_curve_point(path, segment, t, result(3 * sizeof(double), 0));
}

CALL(v_path_point_at_length)
{
    const V_PATH *path = a_path();
    int segment = a_segment(path);
    double length, s;

    if (v_path_segment_length(path, segment, &length) != V_OK)
        length = 1;
    s = number(0, length);
    return v_path_point_at_length(path, segment, s, result(3 * sizeof(double), 0));
}

CALL(v_path_section_count)
{
    const V_PATH *path = a_path();
    return v_path_section_count(path, result(sizeof(int), 0));
}

CALL(v_path_section_info)
{
    const V_PATH *path = a_path();
    int sections, section, *point, *orientation;
    size_t *first;

    if (v_path_section_count(path, &sections) != V_OK)
        sections = 1;
    section = whole(0, sections - 1);
    point = result(sizeof *point, 1);
    orientation = result(sizeof *orientation, 1);
    first = result(sizeof *first, 1);
    return v_path_section_info(path, section, point, orientation, first,
                               result(sizeof(size_t), 1));
}

CALL(v_path_frame_count)
{
    const V_PATH *path = a_path();
    return v_path_frame_count(path, result(sizeof(size_t), 0));
}

CALL(v_path_sample)
{
    const V_PATH *path = a_path();
    size_t capacity = (size_t)whole(POSES, POSES) % (POSES + 1), *count;
    V_POSE *poses = result(capacity * sizeof *poses, 0);

    if (poses == NULL && chance(30))
        capacity = 0;
    count = result(sizeof *count, 0);
    return too_small(v_path_sample(path, poses, capacity, count), count, capacity);
}

CALL(v_path_sample_range)
{
    const V_PATH *path = a_path();
    size_t first = (size_t)whole(1, 3), count = (size_t)whole(0, 3) % 4;
    return v_path_sample_range(path, first, count, result(count * sizeof(V_POSE), 0));
}

CALL(v_path_pose)
{
    const V_PATH *path = a_path();
    size_t frames;
    double at;

    if (v_path_frame_count(path, &frames) != V_OK)
        frames = 1;
    at = number(1, (double)frames);
    return v_path_pose(path, at, result(sizeof(V_POSE), 0));
}

CALL(v_path_to_list)
{
    const V_PATH *path = a_path();
    return v_path_to_list(path, a_list());
}

CALL(v_path_write_ascii)
{
    const V_PATH *path = a_path();
    return v_path_write_ascii(path, a_file("a.txt"));
}

/* Calls a function that writes a text into an array of this one's size. */
static int text_of(int (*function)(const V_PATH *, char *, size_t, size_t *),
                   const V_PATH *path, size_t most)
{
    size_t capacity = (size_t)whole((int)most, (int)most) % (most + 1), *length, needed = 0;
    char *array = result(capacity, 0);
    int status;

    if (array == NULL && chance(30))
        capacity = 0;
    length = result(sizeof *length, 0);
    status = function(path, array, capacity, length);
    if (status == V_ERR_SIZE && length != NULL) {
        memcpy(&needed, length, sizeof needed);
        if (needed < capacity)
            fault("a text of %lu bytes does not fit into %lu", (unsigned long)needed,
                  (unsigned long)capacity);
        memset(length, 0xA5, sizeof *length);
    }
    return status;
}

CALL(v_path_write_ascii_to_memory)
{
    return text_of(v_path_write_ascii_to_memory, a_path(), 100 * POSES);
}

CALL(v_path_save_to_memory)
{
    return text_of(v_path_save_to_memory, a_path(), 100 * POSES);
}

CALL(v_path_set_object)
{
    V_PATH *path = a_path();
    return v_path_set_object(path, a_mesh());
}

/* ---- Toolbox --------------------------------------------------------------------------- */

CALL(v_quat_slerp)
{
    const double *a = numbers(4, 0.1, 1), *b = numbers(4, 0.1, 1);
    double t = number(-1, 2);
    return v_quat_slerp(a, b, t, result(4 * sizeof(double), 0));
}

CALL(v_quat_from_view)
{
    const double *vpn = numbers(3, 0.1, 0.2), *vup = numbers(3, -2, -1);
    double parallel = 0;

    if (vpn != NULL && vup != NULL && !frame->unaligned)
        parallel = vpn[0] * vup[1] - vpn[1] * vup[0];
    frame->unfit |= parallel == 0;
    return v_quat_from_view(vpn, vup, result(4 * sizeof(double), 0));
}

CALL(v_view_from_quat)
{
    const double *q = numbers(4, 0.1, 1);
    double *vpn = result(3 * sizeof *vpn, 1);
    return v_view_from_quat(q, vpn, result(3 * sizeof(double), 1));
}

#define KEYS 5

/* How many keys there are: never more than the arrays hold. */
static int a_count(const double *keys)
{
    static const int odd[] = {0, 1, -1, -2147483647 - 1, 2147483647, 1000001};

    if (chance(wild)) {
        frame->unfit = 1;
        return odd[below(keys == NULL ? 6 : 4)];
    }
    return 2 + (int)below(KEYS - 1);
}

CALL(v_quat_spline)
{
    const double *keys = numbers(4 * KEYS, 0.1, 1), *times = increasing(KEYS);
    int count = a_count(keys);
    double when = number(-1, -0.9);
    return v_quat_spline(keys, times, count, when, result(4 * sizeof(double), 0));
}

CALL(v_quat_tcb_spline)
{
    const double *keys = numbers(4 * KEYS, 0.1, 1), *times = increasing(KEYS);
    const double *tcb = numbers_or_null(3 * KEYS, -1, 1);
    int count = a_count(keys);
    double when = number(-1, -0.9);
    return v_quat_tcb_spline(keys, times, tcb, count, when, result(4 * sizeof(double), 0));
}

CALL(v_speed_curve)
{
    const double *speeds = numbers(10, 1, 100), *before = numbers_or_null(1, 1, 100);
    const double *after = numbers_or_null(1, 1, 100);
    double u = number(0, 1), *speed = result(sizeof *speed, 1);
    return v_speed_curve(speeds, before, after, u, speed, result(sizeof(double), 1));
}

CALL(v_view_matrix)
{
    V_VIEW view = a_view();
    const V_VIEW *drawn = given("V_VIEW", &view, sizeof view);
    return v_view_matrix(drawn, result(16 * sizeof(double), 0));
}

CALL(v_view_from_pose)
{
    const V_POSE *pose = a_pose();
    double aspect = number(0.5, 2), front = number(0.1, 1), back = number(2, 3);
    V_VIEW view;

    memset(&view, 0x5A, sizeof view);
    view.size = chance(wild) ? below(400) : sizeof view;
    frame->unfit |= view.size != sizeof view;
    return v_view_from_pose(pose, aspect, front, back,
                            (V_VIEW *)given("V_VIEW", &view, sizeof view));
}

CALL(v_fov_from_zoom)
{
    double zoom = number(1, 2000);
    v_fov_from_zoom(zoom, number(1, 100));
    return 0;
}

CALL(v_zoom_from_fov)
{
    double fov = number(1, 179);
    v_zoom_from_fov(fov, number(1, 100));
    return 0;
}

/* ---- Space ---------------------------------------------------------------------------- */

CALL(v_path_new_in_space)
{
    const double *centre = numbers(3, -1, 1);
    double half_size = number(0.5, 2);
    int up = whole(V_UP_Y, V_UP_Z);
    V_PATH **path = result(sizeof *path, 0);
    int status = v_path_new_in_space(centre, half_size, up, path);

    if (status == V_OK)
        frame->made_path = *path;
    return status;
}

CALL(v_path_change_up)
{
    V_PATH *path = a_path();
    return v_path_change_up(path, whole(V_UP_Y, V_UP_Z));
}

CALL(v_orientation_from_pose)
{
    const V_POSE *pose = a_pose();
    int up = whole(V_UP_Y, V_UP_Z);
    V_ORIENTATION o;

    v_orientation_init(&o);
    o.size = chance(wild) ? below(400) : sizeof o;
    frame->unfit |= o.size != sizeof o;
    return v_orientation_from_pose(pose, up,
                                   (V_ORIENTATION *)given("V_ORIENTATION", &o, sizeof o));
}

/* ---- Shape and pace ------------------------------------------------------------------- */

CALL(v_path_get_tangents)
{
    const V_PATH *path = a_path();
    int at = a_point(path);
    double *before = result(3 * sizeof *before, 1), *after = result(3 * sizeof *after, 1);
    return v_path_get_tangents(path, at, before, after, result(sizeof(int), 1));
}

CALL(v_path_insert_on_curve)
{
    V_PATH *path = a_path();
    size_t frames;
    double at;

    if (v_path_frame_count(path, &frames) != V_OK)
        frames = 1;
    at = number(1, (double)frames);
    return v_path_insert_on_curve(path, at, result(sizeof(int), 1));
}

CALL(v_ease)
{
    int kind = whole(0, 1);
    double rise = number(0, 0.5), fall = number(0, 0.5), t = number(0, 1);
    double *distance = result(sizeof *distance, 1);
    return v_ease(kind, rise, fall, t, distance, result(sizeof(double), 1));
}

CALL(v_path_set_up)
{
    static const char *const ups[] = {"axis", "point", "path", "minimal", "frenet", "down"};
    V_PATH *path = a_path();
    int point = a_point(path), at = an_orientation(path, point);
    const double *above = numbers(3, 2, 3);
    int up = below(chance(wild) ? 6 : 4);

    if (up >= 4) /* "frenet" is not for every curve */
        frame->unfit = 1;
    return v_path_set_up(path, point, at, text(ups[up]), above, a_path());
}
