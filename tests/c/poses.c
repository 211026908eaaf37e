/*
 * Lengths, sections and poses, on paths whose poses are known in closed form:
 * a straight line at constant speed, a pan, a roll, a zoom.
 */
#include "check.h"

static const double pi = 3.14159265358979323846;

/*
 * A path in modes in which everything runs evenly: at its first point a pan by
 * 90 degrees (50 poses: half of the 180 degrees that take 100), a roll by 45
 * degrees (50), a zoom from 24 to 57 (33.33: 33), nothing at all (none), then
 * the way of length 1.2 (120).
 */
static V_PATH *even_path(void)
{
    V_PATH *path = new_path();
    V_ORIENTATION o;
    v_orientation_init(&o);
    OK(v_path_set_text(path, "orientation_mode", "slerp"));
    OK(v_path_set_text(path, "zoom_mode", "linear"));
    o.target[0] = 0.3;
    o.target[2] = 0;
    OK(v_path_insert_orientation(path, 0, 1, &o));
    o.roll = 45;
    OK(v_path_insert_orientation(path, 0, 2, &o));
    o.zoom = 57;
    OK(v_path_insert_orientation(path, 0, 3, &o));
    OK(v_path_insert_orientation(path, 0, 4, NULL));
    OK(v_path_set_orientation(path, 1, 0, &o));
    return path;
}

static void unit_and_upright(const V_POSE *pose)
{
    const double *n = pose->vpn, *u = pose->vup;
    NEAR(n[0] * n[0] + n[1] * n[1] + n[2] * n[2], 1, 2e-12);
    NEAR(u[0] * u[0] + u[1] * u[1] + u[2] * u[2], 1, 2e-12);
    NEAR(n[0] * u[0] + n[1] * u[1] + n[2] * u[2], 0, 1e-12);
}

/* What the pose number n of the even path must be. */
static void is_pose(const V_POSE *pose, double n)
{
    double pan = n <= 51 ? (n - 1) / 50 : 1, roll = n <= 51 ? 0 : (n - 51) / 50;
    double zoom = n <= 101 ? 0 : (n - 101) / 33, way = n <= 134 ? 0 : (n - 134) / 120;
    double yaw, c, s;
    if (roll > 1) roll = 1;
    if (zoom > 1) zoom = 1;
    /* From looking along -z to looking along x; up turns towards -U0, and the
       turned x axis is then (0, 0, -1). */
    yaw = pan * pi / 2;
    c = cos(roll * pi / 4);
    s = sin(roll * pi / 4);
    NEAR(pose->vrp[0], -0.6 + 1.2 * way, 1e-12);
    NEAR(pose->vrp[1], 0.2, 1e-12);
    NEAR(pose->vrp[2], 0.8, 1e-12);
    NEAR(pose->vpn[0], sin(yaw), 1e-12);
    NEAR(pose->vpn[1], 0, 1e-12);
    NEAR(pose->vpn[2], -cos(yaw), 1e-12);
    NEAR(pose->vup[1], c, 1e-12);
    if (pan == 1)
        NEAR(pose->vup[2], s, 1e-12);
    NEAR(pose->zoom, 24 + 33 * zoom, 1e-12);
    unit_and_upright(pose);
}

static void every_pose(void)
{
    V_PATH *path = even_path();
    V_POSE poses[300];
    V_POSE one;
    size_t frames = 0, count = 0, i;
    double frame;
    OK(v_path_frame_count(path, &frames));
    CHECK(frames == 1 + 50 + 50 + 33 + 120);
    OK(v_path_sample(path, NULL, 0, &count));
    CHECK(count == frames);

    memset(poses, 0x5a, sizeof poses);
    count = 0;
    STATUS(V_ERR_SIZE, v_path_sample(path, poses, frames - 1, &count));
    CHECK(count == frames);
    count = 0;
    STATUS(V_ERR_SIZE, v_path_sample(path, poses, 0, &count));
    CHECK(count == frames);
    for (i = 0; i < sizeof poses; i++)
        CHECK(((unsigned char *)poses)[i] == 0x5a);

    count = 0;
    OK(v_path_sample(path, poses, 300, &count));
    CHECK(count == frames);
    for (i = 0; i < frames; i++)
        is_pose(&poses[i], (double)i + 1);
    for (i = frames * sizeof(V_POSE); i < sizeof poses; i++)
        CHECK(((unsigned char *)poses)[i] == 0x5a);
    OK(v_path_sample(path, poses, frames, &count));

    for (i = 0; i < frames; i++) {
        OK(v_path_pose(path, (double)i + 1, &one));
        is_pose(&one, (double)i + 1);
    }
    for (frame = 1; frame <= (double)frames; frame += 0.37) {
        OK(v_path_pose(path, frame, &one));
        is_pose(&one, frame);
    }
    one.zoom = 77;
    STATUS(V_ERR_RANGE, v_path_pose(path, 0, &one));
    STATUS(V_ERR_RANGE, v_path_pose(path, 0.999999, &one));
    STATUS(V_ERR_RANGE, v_path_pose(path, (double)frames + 1e-6, &one));
    STATUS(V_ERR_RANGE, v_path_pose(path, -1e300, &one));
    STATUS(V_ERR_RANGE, v_path_pose(path, NAN, &one));
    STATUS(V_ERR_RANGE, v_path_pose(path, INFINITY, &one));
    CHECK(one.zoom == 77);
    v_path_free(path);
}

static void sections(void)
{
    static const struct { int point, orientation; size_t first, frames; } should[5] = {
        {0, 0, 2, 50}, {0, 1, 52, 50}, {0, 2, 102, 33}, {0, 3, 134, 0}, {0, 4, 135, 120},
    };
    V_PATH *path = even_path();
    int count = 0, i, point, orientation;
    size_t first, frames;
    OK(v_path_section_count(path, &count));
    CHECK(count == 5);
    for (i = 0; i < 5; i++) {
        OK(v_path_section_info(path, i, &point, &orientation, &first, &frames));
        CHECK(point == should[i].point && orientation == should[i].orientation);
        CHECK(frames == should[i].frames);
        if (first != should[i].first) {
            failures++;
            fprintf(stderr, "section %d begins with %lu\n", i, (unsigned long)first);
        }
    }
    point = 77;
    first = 77;
    STATUS(V_ERR_RANGE, v_path_section_info(path, 5, &point, NULL, &first, NULL));
    STATUS(V_ERR_RANGE, v_path_section_info(path, -1, &point, NULL, &first, NULL));
    CHECK(point == 77 && first == 77);
    OK(v_path_set_flag(path, "closed", 1));
    OK(v_path_section_count(path, &count));
    CHECK(count == 6);
    v_path_free(path);
}

static void the_curve(void)
{
    V_PATH *path = new_path();
    double length = 0, at[3], end[3], corner[3] = {0.6, 0.2, -0.4};
    int i;
    OK(v_path_length(path, &length));
    NEAR(length, 1.2, 1e-12);
    OK(v_path_segment_length(path, 0, &length));
    NEAR(length, 1.2, 1e-12);
    OK(v_path_curve_point(path, 0, 0.25, at));
    NEAR(at[0], -0.3, 1e-12);
    OK(v_path_point_at_length(path, 0, 0.9, at));
    NEAR(at[0], 0.3, 1e-12);
    OK(v_path_point_at_length(path, 0, length, at));
    CHECK(at[0] == 0.6 && at[1] == 0.2 && at[2] == 0.8);
    OK(v_path_curve_point(path, 0, 1, at));
    CHECK(at[0] == 0.6 && at[1] == 0.2 && at[2] == 0.8);
    at[0] = 77;
    STATUS(V_ERR_RANGE, v_path_segment_length(path, 1, &length));
    STATUS(V_ERR_RANGE, v_path_segment_length(path, -1, &length));
    STATUS(V_ERR_RANGE, v_path_curve_point(path, 1, 0, at));
    STATUS(V_ERR_RANGE, v_path_curve_point(path, 0, 1.0001, at));
    STATUS(V_ERR_RANGE, v_path_curve_point(path, 0, -0.0001, at));
    STATUS(V_ERR_ARGUMENT, v_path_curve_point(path, 0, NAN, at));
    STATUS(V_ERR_RANGE, v_path_point_at_length(path, -1, 0, at));
    STATUS(V_ERR_RANGE, v_path_point_at_length(path, 0, 1.3, at));
    STATUS(V_ERR_ARGUMENT, v_path_point_at_length(path, 0, INFINITY, at));
    CHECK(at[0] == 77);
    /* Full tension: straight segments, and a closed path has one more. */
    OK(v_path_insert_point(path, 2, corner));
    OK(v_path_set_numbers(path, "presets.0", NUMBERS(1, 0, 0)));
    OK(v_path_set_flag(path, "closed", 1));
    OK(v_path_segment_length(path, 1, &length));
    NEAR(length, 1.2, 1e-9);
    OK(v_path_segment_length(path, 2, &length));
    NEAR(length, 1.2 * sqrt(2), 1e-9);
    OK(v_path_length(path, &length));
    NEAR(length, 2.4 + 1.2 * sqrt(2), 1e-9);
    /* Where a segment's length ends is its end, whatever its shape. */
    for (i = 0; i < 200; i++) {
        at[0] = sin(i);
        at[1] = cos(3 * i);
        at[2] = sin(0.3 * i);
        OK(set_position(path, 1, at));
        OK(v_path_set_numbers(path, "presets.0", NUMBERS(sin(5 * i), cos(7 * i), sin(11 * i))));
        OK(v_path_segment_length(path, 0, &length));
        OK(v_path_point_at_length(path, 0, length, end));
        CHECK(memcmp(at, end, sizeof at) == 0);
    }
    v_path_free(path);
}

/* More poses than there may be: an error before any memory is taken. */
static void too_many(void)
{
    V_PATH *path = new_path();
    V_POSE pose;
    V_KAMERAPAR head;
    size_t frames = 77;
    memset(&head, 0xa5, sizeof head);
    head.number = -1;
    OK(v_path_set_numbers(path, "base_speeds", NUMBERS(1e12, 1, 1, 1)));
    STATUS(V_ERR_LIMIT, v_path_frame_count(path, &frames));
    STATUS(V_ERR_LIMIT, v_path_sample(path, NULL, 0, &frames));
    STATUS(V_ERR_LIMIT, v_path_pose(path, 1, &pose));
    STATUS(V_ERR_LIMIT, v_path_to_list(path, &head));
    CHECK(frames == 77 && head.number == -1);
    OK(v_path_set_numbers(path, "base_speeds", NUMBERS(1e-12, 1, 1, 1)));
    OK(v_path_frame_count(path, &frames));
    CHECK(frames == 2); /* at least one for a section that moves */
    v_path_free(path);
}

static unsigned long long dice = 1;

/* At random, from `least` to `most`. */
static double drawn(double least, double most)
{
    dice = dice * 6364136223846793005ULL + 1442695040888963407ULL;
    return least + (most - least) * (double)(dice >> 11) / 9007199254740992.0;
}

static int luck(void)
{
    return drawn(0, 1) < 0.3;
}

/* A view of a random path, as text. */
static char *random_view(char *at)
{
    int i;
    at += sprintf(at, "[[point.orientation]]\n%s = [%.3f, %.3f, %.3f]\n",
                  luck() ? "target" : "offset",
                  drawn(2, 3), drawn(-1, 1), drawn(2, 3));
    at += sprintf(at, "roll_degrees = %.3f\nzoom_mm = %.3f\n", drawn(-180, 180),
                  exp(drawn(0, log(2000))));
    if (luck()) at += sprintf(at, "hold_frames = %d\n", (int)drawn(1, 4));
    if (luck()) at += sprintf(at, "zoom_slope_mm = %.3f\n", drawn(-300, 300));
    if (luck()) at += sprintf(at, "roll_slope_degrees = %.3f\n", drawn(-9, 9));
    if (luck())
        at += sprintf(at,
                      "velocity_degrees = { reach = [%.3f, %.3f, 0.0], leave = [0.0, %.3f, %.3f] }\n", drawn(-9, 9),
                      drawn(-9, 9), drawn(-9, 9), drawn(-9, 9));
    if (luck()) at += sprintf(at, "ahead = %.1f\n", luck() ? drawn(0.1, 0.5) : 0);
    if (luck()) at += sprintf(at, "up = \"minimal\"\n");
    if (luck()) return at + sprintf(at,
        "ease = { kind = \"sine\", rise = 0.2, fall = 0.4, cruise = 60.0 }\n");
    at += sprintf(at, "speed_curve = [");
    for (i = 0; i < 10; i++) at += sprintf(at, "%s%.3f", i ? ", " : "", drawn(1, 100));
    return at + sprintf(at, "]\n");
}

/* A random path, as text. */
static void random_path(char *at)
{
    static const char *const modes[] = {"tcb", "barry-goldman", "slerp"};
    int point, view, points = (int)drawn(2, 6);
    at += sprintf(at, "version = 1\nclosed = %s\ncurve = \"%s\"\norientation_mode = \"%s\"\n",
                  luck() ? "true" : "false", luck() ? "cubic" : "tcb", modes[(int)drawn(0, 3)]);
    at += sprintf(at, "zoom_mode = \"%s\"\n[space]\nup = \"%s\"\n", luck() ? "linear" : "smooth",
                  luck() ? "z" : "y");
    at += sprintf(at, "[base_speeds]\nmove_frames = 9\nturn_frames = 9\nzoom_frames = 9\n");
    for (point = 0; point < points; point++) {
        at += sprintf(at, "[[point]]\nposition = [%.3f, %.3f, %.3f]\n", drawn(-1, 1), drawn(-1, 1),
                      drawn(-1, 1));
        for (view = luck(); view >= 0; view--)
            at = random_view(at);
    }
}

/* The pose at a whole frame is that of the list, bit for bit. */
static void at_whole_frames(void)
{
    char text[16384];
    size_t count = 0, frame, all = 0;
    int n, wrong = 0;
    for (n = 0; n < 1000; n++) {
        V_PATH *path = NULL;
        V_POSE *poses, one;
        random_path(text);
        OK(v_path_load_from_memory(text, strlen(text), &path));
        OK(v_path_frame_count(path, &count));
        poses = malloc(count * sizeof *poses);
        OK(v_path_sample(path, poses, count, &count));
        for (frame = 1; frame <= count; frame++) {
            OK(v_path_pose(path, (double)frame, &one));
            wrong += memcmp(&one, &poses[frame - 1], sizeof one) != 0;
        }
        all += count;
        free(poses);
        v_path_free(path);
    }
    printf("note: %lu poses of %d random paths, %d not bit for bit\n", (unsigned long)all, n,
           wrong);
    CHECK(wrong == 0);
}

int main(void)
{
    every_pose();
    at_whole_frames();
    sections();
    the_curve();
    too_many();
    return failures != 0;
}
