/*
 * Tangents and kinds of the curve, points that keep the motion, easing, fixed
 * frames, views along the way.
 */
#include "check.h"

/* Custom tangents of a point, or without them those of the curve again. */
static int set_tangents(V_PATH *path, int at, const double *before, const double *after)
{
    double both[6];

    if (before == NULL)
        return v_path_set_numbers(path, v_path_key(at, -1, "tangents"), NULL, 0);
    memcpy(both, before, 3 * sizeof *both);
    memcpy(both + 3, after, 3 * sizeof *both);
    return v_path_set_numbers(path, v_path_key(at, -1, "tangents"), both, 6);
}

static const double a_nan = NAN;

static V_PATH *three_points(void)
{
    V_PATH *path = new_path();
    const double middle[3] = {0.1, -0.3, -0.4};
    V_ORIENTATION o;

    OK(v_path_insert_point(path, 1, middle));
    v_orientation_init(&o);
    o.zoom = 60;
    o.target[0] = 0.9;
    o.roll = 25;
    o.speed[0] = 5;
    o.speed[1] = 20;
    OK(v_path_set_orientation(path, 1, 0, &o));
    return path;
}

static size_t frames_of(const V_PATH *path)
{
    size_t count = 0;
    OK(v_path_frame_count(path, &count));
    return count;
}

static V_POSE *poses_of(const V_PATH *path, size_t count)
{
    V_POSE *poses = calloc(count, sizeof *poses);
    size_t found = 0;

    OK(v_path_sample(path, poses, count, &found));
    CHECK(found == count);
    return poses;
}

static void tangents(void)
{
    V_PATH *path = three_points();
    double before[3], after[3], again[3], place[2][3];
    int own = -7, at;

    OK(v_path_curve_point(path, 0, 0.3, place[0]));
    for (at = 0; at < 3; at++) {
        OK(v_path_get_tangents(path, at, before, after, &own));
        CHECK(own == 0);
        OK(set_tangents(path, at, before, after));
        OK(v_path_get_tangents(path, at, again, NULL, &own));
        CHECK(own == 1 && memcmp(before, again, sizeof before) == 0);
    }
    OK(v_path_curve_point(path, 0, 0.3, place[1]));
    CHECK(memcmp(place[0], place[1], sizeof place[0]) == 0);
    after[0] = 2;
    OK(set_tangents(path, 0, before, after));
    OK(v_path_curve_point(path, 0, 0.3, place[1]));
    CHECK(memcmp(place[0], place[1], sizeof place[0]) != 0);
    OK(set_tangents(path, 0, NULL, NULL));
    OK(v_path_curve_point(path, 0, 0.3, place[1]));
    CHECK(memcmp(place[0], place[1], sizeof place[0]) == 0);
    after[1] = a_nan;
    STATUS(V_ERR_ARGUMENT, set_tangents(path, 0, before, after));
    after[1] = 2e9;
    STATUS(V_ERR_RANGE, set_tangents(path, 0, before, after));
    STATUS(V_ERR_RANGE, set_tangents(path, 3, NULL, NULL));
    STATUS(V_ERR_ARGUMENT, v_path_set_numbers(path, "point.1.tangents", before, 3));
    STATUS(V_ERR_RANGE, v_path_get_tangents(path, -1, before, after, &own));
    v_path_free(path);
}

static void kinds(void)
{
    V_PATH *path = three_points();
    char kind[20];
    size_t used;
    double place[3], length;

    OK(v_path_get_text(path, "curve", kind, sizeof kind, &used));
    CHECK(strcmp(kind, "tcb") == 0);
    OK(v_path_set_text(path, "curve", "linear"));
    OK(v_path_curve_point(path, 0, 0.5, place));
    NEAR(place[0], -0.25, 1e-15);
    NEAR(place[1], -0.05, 1e-15);
    OK(v_path_segment_length(path, 0, &length));
    NEAR(length, sqrt(0.7 * 0.7 + 0.5 * 0.5 + 1.2 * 1.2), 1e-14);
    OK(v_path_set_text(path, "curve", "cubic"));
    OK(v_path_get_text(path, "curve", kind, sizeof kind, &used));
    CHECK(strcmp(kind, "cubic") == 0);
    /* Natural, three points: the tangent at the first one is 5/4 of the first
     * chord less 1/4 of the second. */
    {
        double after[3];
        OK(v_path_get_tangents(path, 0, NULL, after, NULL));
        NEAR(after[0], 1.25 * 0.7 - 0.25 * 0.5, 1e-14);
    }
    STATUS(V_ERR_ARGUMENT, v_path_set_text(path, "curve", "round"));
    STATUS(V_ERR_NULL, v_path_set_text(path, "curve", NULL));
    v_path_free(path);
}

static void the_motion_is_kept(void)
{
    V_PATH *path = three_points();
    size_t count = frames_of(path), i;
    V_POSE *before = poses_of(path, count), *after;
    int at = -7, points, k;

    OK(v_path_insert_on_curve(path, (double)count / 3, &at));
    CHECK(at == 1);
    OK(v_path_insert_on_curve(path, (double)count * 0.8, NULL));
    OK(v_path_point_count(path, &points));
    CHECK(points == 5 && frames_of(path) == count);
    after = poses_of(path, count);
    for (i = 0; i < count; i++) {
        for (k = 0; k < 3; k++) {
            NEAR(after[i].vrp[k], before[i].vrp[k], 1e-12);
            NEAR(after[i].vpn[k], before[i].vpn[k], 1e-7);
            NEAR(after[i].vup[k], before[i].vup[k], 1e-7);
        }
        NEAR(after[i].zoom, before[i].zoom, 1e-9);
    }
    STATUS(V_ERR_RANGE, v_path_insert_on_curve(path, 1, &at));
    STATUS(V_ERR_RANGE, v_path_insert_on_curve(path, a_nan, &at));
    STATUS(V_ERR_RANGE, v_path_insert_on_curve(path, (double)count + 1, &at));
    OK(v_path_set_text(path, "orientation_mode", "barry-goldman"));
    STATUS(V_ERR_ARGUMENT, v_path_insert_on_curve(path, 5, &at));
    free(before);
    free(after);
    v_path_free(path);
}

static void easing(void)
{
    const double pi = acos(-1);
    V_PATH *path = new_path();
    double distance, speed, ease[4], t;
    size_t numbers = 7, count, steady = frames_of(path);
    V_POSE *poses;
    const double keys[] = {0, 0, 0.25, 0.5, 1, 1};

    for (t = 0; t <= 1; t += 0.125) {
        OK(v_ease(V_EASE_SINE, 0.5, 0.5, t, &distance, &speed));
        NEAR(distance, (1 - cos(pi * t)) / 2, 1e-14);
        NEAR(speed, sin(pi * t) * pi / 2, 1e-14);
    }
    OK(v_ease(V_EASE_PARABOLIC, 0.5, 0.5, 0.25, &distance, NULL));
    NEAR(distance, 0.125, 1e-15);
    STATUS(V_ERR_RANGE, v_ease(2, 0.5, 0.5, 0.25, &distance, NULL));
    STATUS(V_ERR_RANGE, v_ease(0, 0.6, 0.5, 0.25, &distance, NULL));
    STATUS(V_ERR_RANGE, v_ease(0, 0.6, 0.1, 1.25, &distance, NULL));
    STATUS(V_ERR_ARGUMENT, v_ease(0, a_nan, 0.1, 0.25, &distance, NULL));

    OK(v_path_get_numbers(path, v_path_key(0, 0, "ease"), ease, 4, &numbers));
    CHECK(numbers == 0);
    OK(v_path_set_numbers(path, v_path_key(0, 0, "ease"), NUMBERS(V_EASE_PARABOLIC, 0.5, 0.5, 50)));
    OK(v_path_get_numbers(path, v_path_key(0, 0, "ease"), ease, 4, &numbers));
    CHECK(numbers == 4 && ease[0] == V_EASE_PARABOLIC && ease[1] == 0.5 && ease[2] == 0.5 && ease[3] == 50);
    count = frames_of(path);
    CHECK(count == 2 * (steady - 1) + 1); /* half the mean speed */
    poses = poses_of(path, count);
    NEAR(poses[(count - 1) / 4].vrp[0], -0.6 + 1.2 * 0.125, 1e-12);
    free(poses);
    STATUS(V_ERR_RANGE, v_path_set_numbers(path, v_path_key(0, 0, "ease"), NUMBERS(V_EASE_SINE,
           0.5, 0.5, 101)));
    STATUS(V_ERR_RANGE, v_path_set_numbers(path, v_path_key(0, 1, "ease"), NUMBERS(V_EASE_SINE,
           0.5, 0.5, 50)));

    OK(v_path_set_numbers(path, v_path_key(0, 0, "distance"), keys, 6));
    OK(v_path_get_numbers(path, v_path_key(0, 0, "ease"), ease, 4, &numbers));
    CHECK(numbers == 0);
    count = frames_of(path);
    CHECK(count == steady);
    poses = poses_of(path, count);
    NEAR(poses[(count - 1) / 4].vrp[0], 0, 1e-12);
    free(poses);
    STATUS(V_ERR_RANGE, v_path_set_numbers(path, v_path_key(0, 0, "distance"), keys, 4));
    STATUS(V_ERR_RANGE, v_path_set_numbers(path, v_path_key(0, 0, "distance"), keys, 66));
    STATUS(V_ERR_NULL, v_path_set_numbers(path, v_path_key(0, 0, "distance"), NULL, 6));
    OK(v_path_set_numbers(path, v_path_key(0, 0, "distance"), NULL, 0));
    OK(v_path_set_numbers(path, v_path_key(0, 0, "ease"), NULL, 0));
    CHECK(frames_of(path) == steady);
    v_path_free(path);
}

static void fixed_frames(void)
{
    V_PATH *path = three_points();
    double fixed = 7;
    size_t frames;
    int locked = 7;

    OK(v_path_get_number(path, v_path_key(0, 0, "frames"), &fixed));
    CHECK(fixed == 0);
    OK(v_path_set_number(path, v_path_key(0, 0, "frames"), 33));
    OK(v_path_get_number(path, v_path_key(0, 0, "frames"), &fixed));
    CHECK(fixed == 33);
    for (frames = 3; frames < 1000; frames += 83) {
        OK(tool(path, "frames", NULL, "frames=%zu\nfirst=1\nlast=3", frames));
        CHECK(frames_of(path) == frames);
    }
    OK(v_path_set_number(path, v_path_key(0, 0, "frames"), 33));
    OK(v_path_set_flag(path, v_path_key(0, 0, "locked"), 1));
    OK(v_path_get_flag(path, v_path_key(0, 0, "locked"), &locked));
    CHECK(locked == 1);
    OK(tool(path, "frames", NULL, "frames=500\nfirst=1\nlast=3"));
    OK(v_path_get_number(path, v_path_key(0, 0, "frames"), &fixed));
    CHECK(fixed == 33 && frames_of(path) == 500);
    STATUS(V_ERR_RANGE, v_path_set_flag(path, v_path_key(3, 0, "locked"), 1));
    STATUS(V_ERR_NULL, v_path_get_flag(path, v_path_key(0, 0, "locked"), NULL));
    OK(v_path_set_flag(path, v_path_key(0, 0, "locked"), 0));
    OK(v_path_set_flag(path, "closed", 1));
    OK(tool(path, "frames", NULL, "frames=300\nfirst=1\nlast=3"));
    CHECK(frames_of(path) == 300);
    STATUS(V_ERR_RANGE, tool(path, "frames", NULL, "frames=3\nfirst=1\nlast=3"));
    CHECK(strstr(v_last_error(), "at least 4") != NULL);
    STATUS(V_ERR_RANGE, tool(path, "frames", NULL, "frames=300\nfirst=1\nlast=4"));
    STATUS(V_ERR_RANGE, v_path_set_number(path, v_path_key(0, 0, "frames"), -1));
    STATUS(V_ERR_RANGE, v_path_set_number(path, v_path_key(0, 0, "frames"), 100000000));
    CHECK(frames_of(path) == 300);
    /* What is accepted can be counted, up to the last frame. */
    OK(v_path_get_number(path, v_path_key(0, 0, "frames"), &fixed));
    OK(v_path_set_number(path, v_path_key(0, 0, "frames"), 100000000 - 300 + fixed));
    CHECK(frames_of(path) == 100000000);
    STATUS(V_ERR_LIMIT, v_path_set_number(path, v_path_key(0, 0, "frames"),
           100000000 - 300 + fixed + 1));
    OK(v_path_get_number(path, v_path_key(1, 0, "frames"), &fixed));
    STATUS(V_ERR_LIMIT, v_path_set_number(path, v_path_key(1, 0, "frames"), fixed + 1));
    CHECK(frames_of(path) == 100000000);
    v_path_free(path);
}

static void along_the_way(void)
{
    V_PATH *path = three_points();
    V_ORIENTATION o;
    V_POSE pose;
    double to[3], length;
    int at, k;

    v_orientation_init(&o);
    OK(v_path_set_text(path, "curve", "linear"));
    for (at = 0; at < 3; at++)
        OK(v_path_set_number(path, v_path_key(at, 0, "ahead"), 0));
    OK(v_path_pose(path, 4.5, &pose));
    OK(get_position(path, 1, to));
    OK(v_path_segment_length(path, 0, &length));
    NEAR(pose.vpn[0], 0.7 / length, 1e-12);
    NEAR(pose.vpn[1], -0.5 / length, 1e-12);
    NEAR(pose.vpn[2], -1.2 / length, 1e-12);
    /* What the struct has no place for stays. */
    OK(v_path_get_orientation(path, 0, 0, &o));
    o.zoom = 40;
    OK(v_path_set_orientation(path, 0, 0, &o));
    OK(v_path_pose(path, 1, &pose));
    NEAR(pose.vpn[0], 0.7 / length, 1e-12);
    /* No longer ahead, in the same direction. */
    OK(v_path_set_numbers(path, v_path_key(0, 0, "offset"), pose.vpn, 3));
    OK(v_path_get_number(path, v_path_key(0, 0, "ahead"), &length));
    CHECK(isnan(length));
    OK(v_path_get_orientation(path, 0, 0, &o));
    CHECK(o.absolute == 0);
    for (k = 0; k < 3; k++)
        CHECK(o.target[k] == pose.vpn[k]);
    OK(v_path_pose(path, 1, &pose));
    for (k = 0; k < 3; k++)
        NEAR(o.target[k], pose.vpn[k], 1e-15);
    OK(v_path_set_number(path, v_path_key(0, 0, "ahead"), 0.5));
    OK(v_path_set_text(path, v_path_key(0, 0, "ahead"), ""));
    OK(v_path_get_number(path, v_path_key(0, 0, "ahead"), &length));
    CHECK(isnan(length));
    STATUS(V_ERR_ARGUMENT, v_path_set_number(path, v_path_key(0, 0, "ahead"), a_nan));
    STATUS(V_ERR_RANGE, v_path_set_number(path, v_path_key(0, 0, "ahead"), 2e9));
    STATUS(V_ERR_RANGE, v_path_set_number(path, v_path_key(0, 1, "ahead"), 0));
    v_path_free(path);
}

/* Up towards a point, a path, the normal; carried along. */
static void ups(void)
{
    V_PATH *path = three_points(), *second = three_points();
    const double above[3] = {0.2, 5, 0.1};
    double to[3], along = 0, length = 0;
    V_ORIENTATION o;
    V_POSE pose;
    int at, k;

    for (at = 0; at < 3; at++) {
        v_orientation_init(&o); /* without its roll, which is added */
        OK(v_path_set_orientation(path, at, 0, &o));
        OK(v_path_set_number(path, v_path_key(at, 0, "ahead"), 0));
        OK(v_path_set_up(path, at, 0, "point", above, NULL));
    }
    OK(v_path_pose(path, 7.5, &pose));
    for (k = 0; k < 3; k++) {
        to[k] = above[k] - pose.vrp[k];
        along += to[k] * pose.vpn[k];
    }
    for (k = 0; k < 3; k++) {
        to[k] -= along * pose.vpn[k];
        length += to[k] * to[k];
    }
    for (k = 0; k < 3; k++)
        NEAR(pose.vup[k], to[k] / sqrt(length), 1e-12);
    OK(v_path_set_up(path, 0, 0, "path", NULL, second));
    OK(v_path_set_up(path, 1, 0, "path", NULL, path));
    OK(v_path_set_up(path, 2, 0, "minimal", NULL, NULL));
    STATUS(V_ERR_ARGUMENT, v_path_set_up(path, 0, 0, "frenet", NULL, NULL));
    CHECK(strstr(v_last_error(), "minimal") != NULL);
    OK(v_path_set_text(path, "curve", "cubic"));
    OK(v_path_set_up(path, 0, 0, "frenet", NULL, NULL));
    STATUS(V_ERR_ARGUMENT, v_path_set_text(path, "curve", "tcb"));
    STATUS(V_ERR_ARGUMENT, v_path_set_up(path, 0, 0, "Minimal", NULL, NULL));
    STATUS(V_ERR_NULL, v_path_set_up(path, 0, 0, NULL, NULL, NULL));
    STATUS(V_ERR_NULL, v_path_set_up(path, 0, 0, "point", NULL, NULL));
    STATUS(V_ERR_NULL, v_path_set_up(path, 0, 0, "path", NULL, NULL));
    STATUS(V_ERR_RANGE, v_path_set_up(path, 3, 0, "axis", NULL, NULL));
    OK(v_path_set_up(path, 0, 0, "axis", NULL, NULL));
    OK(v_path_set_text(path, "curve", "tcb"));
    v_path_free(path);
    v_path_free(second);
}

/* The tangents by which an insertion kept the motion are removed when a point
 * beside them moves; those that the host sets stay. */
static void kept_tangents_lapse(void)
{
    V_PATH *path = three_points();
    double before[3], after[3], xyz[3];
    int at, own, k;

    OK(v_path_insert_on_curve(path, (double)frames_of(path) / 3, &at));
    for (k = 0; k < 3; k++) {
        OK(v_path_get_tangents(path, k, before, after, &own));
        CHECK(own == 1);
    }
    OK(set_tangents(path, 0, before, after));
    OK(get_position(path, 1, xyz));
    xyz[1] += 0.05;
    OK(set_position(path, 1, xyz));
    for (k = 0; k < 3; k++) {
        OK(v_path_get_tangents(path, k, NULL, NULL, &own));
        CHECK(own == (k == 0));
    }
    v_path_free(path);
}

/* After a point moved the total is shared anew, by length, but for what is locked. */
static void frames_follow_length(void)
{
    V_PATH *path = new_path();
    double place[3] = {0, 0, 0.5}, frames[3];
    const double ways[4] = {-0.8, 1.0, -0.2, 0.4};
    const size_t at[4] = {0, 1, 1, 2};
    int k, round;

    OK(v_path_set_text(path, "curve", "linear"));
    for (k = 0; k < 4; k++) {
        place[0] = ways[k];
        OK(k < 2 ? v_path_set_numbers(path, v_path_key(at[k], -1, "position"), place, 3)
                 : v_path_insert_point(path, at[k], place));
    }
    OK(tool(path, "frames", NULL, "frames=301"));
    for (round = 0; round < 3; round++) {
        for (k = 0; k < 3; k++)
            OK(v_path_get_number(path, v_path_key((size_t)k, 0, "frames"), &frames[k]));
        CHECK(frames[0] == (round == 0 ? 100 : 17) && frames[2] == 100);
        CHECK(frames[1] == (round == 0 ? 100 : round == 1 ? 183 : 383));
        place[0] = -0.7;
        OK(v_path_set_numbers(path, v_path_key(1, -1, "position"), place, 3));
        if (round == 1) {
            OK(v_path_set_flag(path, v_path_key(0, 0, "locked"), 1));
            OK(v_path_set_flag(path, v_path_key(2, 0, "locked"), 1));
        }
        OK(tool(path, "frames", NULL, round == 0 ? "frames=301" : "frames=501"));
    }
    v_path_free(path);
}

/* All of it comes back from a file. */
static void saved(const char *folder)
{
    V_PATH *path = three_points(), *read = NULL;
    char file[4096];
    const double keys[] = {0, 0, 0.25, 0.5, 1, 1}, above[] = {0, 3, 0.2};
    size_t count, i;
    V_POSE *a, *b;

    OK(v_path_set_numbers(path, v_path_key(0, 0, "ease"), NUMBERS(V_EASE_SINE, 0.3, 0.2, 80)));
    OK(v_path_insert_on_curve(path, 20, NULL));
    OK(v_path_set_numbers(path, v_path_key(2, 0, "distance"), keys, 6));
    OK(tool(path, "frames", NULL, "frames=241\nfirst=1\nlast=4"));
    OK(v_path_set_number(path, v_path_key(3, 0, "ahead"), 0.1));
    OK(v_path_set_up(path, 0, 0, "path", NULL, path));
    OK(v_path_set_up(path, 1, 0, "path", NULL, path));
    OK(v_path_set_up(path, 2, 0, "minimal", NULL, NULL));
    OK(v_path_set_up(path, 3, 0, "point", above, NULL));
    snprintf(file, sizeof file, "%s/shape.vid", folder);
    OK(v_path_save(path, file));
    OK(v_path_load(file, &read));
    count = frames_of(path);
    CHECK(count == 241 && frames_of(read) == count);
    a = poses_of(path, count);
    b = poses_of(read, count);
    for (i = 0; i < count; i++)
        CHECK(memcmp(&a[i], &b[i], sizeof a[i]) == 0);
    free(a);
    free(b);
    v_path_free(path);
    v_path_free(read);
}

int main(int argc, char **argv)
{
    tangents();
    kinds();
    the_motion_is_kept();
    kept_tangents_lapse();
    easing();
    fixed_frames();
    frames_follow_length();
    along_the_way();
    ups();
    saved(argc > 1 ? argv[1] : ".");
    return failures != 0;
}
