/* Tools on paths: moves, points moved and deformed, blocks, blends. */
#include "check.h"

static V_PATH *orbit(double turns, double seconds)
{
    return made_by("orbit", "around=0,0.5,0\nradius=1.2\nturns=%g\nseconds=%g", turns, seconds);
}

static void an_orbit_is_round(void)
{
    V_PATH *path = orbit(2, 12), *plain = NULL;
    V_POSE pose;
    size_t count = 0, i;
    double here[3];
    int points;

    OK(v_path_frame_count(path, &count));
    CHECK(count == 300);
    OK(v_path_point_count(path, &points));
    CHECK(points == 25);
    for (i = 1; i <= count; i++) {
        OK(v_path_pose(path, (double)i, &pose));
        NEAR(sqrt(pose.vrp[0] * pose.vrp[0] + pose.vrp[2] * pose.vrp[2]), 1.2, 1e-6);
        NEAR(pose.vrp[1], 0.9, 1e-12);
        /* The target is in the middle of the view. */
        NEAR(pose.vpn[0] * pose.vrp[2] - pose.vpn[2] * pose.vrp[0], 0, 1e-12);
    }
    OK(v_path_clone(path, &plain));
    OK(v_path_tool(path, "pan", NULL, NULL));
    OK(get_position(path, 0, here));
    CHECK(here[0] == 0 && here[1] == 0 && here[2] == 0);
    v_path_free(path);
    STATUS(V_ERR_ARGUMENT, v_path_tool(plain, "loop", NULL, NULL));
    STATUS(V_ERR_RANGE, v_path_tool(plain, "orbit", "speed=1", NULL));
    STATUS(V_ERR_ARGUMENT, v_path_tool(plain, "orbit", "radius=nan", NULL));
    STATUS(V_ERR_ARGUMENT, v_path_tool(plain, "orbit", "around=1,2", NULL));
    OK(v_path_frame_count(plain, &count));
    CHECK(count == 300);
    v_path_free(plain);
}

static void points_are_moved_and_deformed(void)
{
    V_PATH *path = orbit(1, 4);
    double matrix[16] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 1, -2, 3, 1};
    double before[3], after[3];

    OK(get_position(path, 3, before));
    OK(v_path_transform(path, 0, 12, matrix, 1));
    OK(get_position(path, 3, after));
    NEAR(after[0] - before[0], 1, 1e-15);
    NEAR(after[1] - before[1], -2, 1e-15);
    matrix[4] = 0.5;
    STATUS(V_ERR_ARGUMENT, v_path_transform(path, 0, 1, matrix, 1));
    STATUS(V_ERR_RANGE, v_path_transform(path, 2, 1, matrix, 1));
    STATUS(V_ERR_RANGE, v_path_transform(path, 0, 12, matrix, 2));
    STATUS(V_ERR_RANGE, v_path_transform(path, 0, 13, matrix, 1));
    OK(get_position(path, 3, before));
    OK(tool(path, "twist", NULL, "axis=y\nangle=180\nfirst=4\nlast=4\nbox=-3,-3,-3,3,3,3"));
    OK(get_position(path, 3, after));
    /* Turned by 180 degrees times the share of the height in the box; (u, v) are
     * (z, x) about y. */
    {
        double angle = M_PI * (before[1] + 3) / 6;
        NEAR(after[2], before[2] * cos(angle) - before[0] * sin(angle), 1e-14);
        NEAR(after[0], before[2] * sin(angle) + before[0] * cos(angle), 1e-14);
    }
    STATUS(V_ERR_ARGUMENT, tool(path, "shear", NULL, ""));
    STATUS(V_ERR_ARGUMENT, tool(path, "twist", NULL, "box=3,3,3,-3,-3,-3"));
    v_path_free(path);
}

static void blocks(void)
{
    V_PATH *path = orbit(1, 4), *block = NULL, *blend = NULL, *both[2];
    double weights[] = {0.25, 0.75}, one[3], two[3], mixed[3], fps;
    int points, k;

    OK(v_path_extract(path, 0, 3, &block));
    OK(v_path_point_count(block, &points));
    CHECK(points == 4);
    OK(v_path_insert_path(path, 12, block, V_FIT_TURN));
    OK(v_path_point_count(path, &points));
    CHECK(points == 16);
    OK(v_path_insert_path(block, 3, block, V_FIT_MOVE));
    OK(v_path_tool(block, "repeat", "times=2", NULL));
    OK(v_path_point_count(block, &points));
    CHECK(points == 13);
    OK(get_position(block, 0, one));
    OK(v_path_tool(block, "reverse", NULL, NULL));
    OK(get_position(block, 12, two));
    CHECK(memcmp(one, two, sizeof one) == 0);
    both[0] = path;
    both[1] = block;
    OK(v_path_set_number(path, "fps", 24));
    OK(v_path_set_number(block, "fps", 30));
    OK(v_path_blend(both, weights, 2, &blend));
    OK(v_path_get_number(blend, "fps", &fps)); /* of the path that weighs most */
    CHECK(fps == 30);
    OK(get_position(path, 0, one));
    OK(get_position(block, 0, two));
    OK(get_position(blend, 0, mixed));
    for (k = 0; k < 3; k++)
        NEAR(mixed[k], 0.25 * one[k] + 0.75 * two[k], 1e-12);
    weights[0] = 0.5;
    STATUS(V_ERR_RANGE, v_path_blend(both, weights, 2, &blend));
    STATUS(V_ERR_RANGE, v_path_extract(path, 2, 2, &blend));
    STATUS(V_ERR_RANGE, v_path_insert_path(path, 0, block, 4));
    STATUS(V_ERR_RANGE, v_path_insert_path(path, 15, block, V_FIT_SCALE));
    STATUS(V_ERR_RANGE, v_path_tool(path, "repeat", "times=0", NULL));
    v_path_free(blend);
    v_path_free(block);
    STATUS(V_ERR_HANDLE, v_path_insert_path(path, 0, block, V_FIT_NONE));
    v_path_free(path);
}

/* A move and a fit where z stands upright: the coordinates turned, a space that holds
 * them, and poses that are off left out. */
static void moves_and_fits_have_a_space(void)
{
    static const double there[3] = {1000, 0, 0};
    V_PATH *path = NULL, *fitted = NULL;
    static V_POSE poses[250], again[250];
    double centre[3], half, tolerance, least, left_out = 99;
    size_t count = 0, i;
    int up, k, points;

    OK(v_path_new_in_space(there, 50, V_UP_Z, &path));
    OK(v_path_tool(path, "orbit", NULL, NULL));
    OK(get_path_space(path, centre, &half, &up));
    CHECK(centre[0] == 1000 && half == 50 && up == V_UP_Z);
    OK(v_path_sample(path, poses, 250, &count));
    CHECK(count == 250);
    for (i = 0; i < count; i++) {
        NEAR(hypot(poses[i].vrp[0] - 1000, poses[i].vrp[1]), 50, 1e-4);
        NEAR(poses[i].vrp[2], 20, 1e-9);
        CHECK(poses[i].vup[2] > 0.9);
    }
    OK(v_path_fit_poses(poses, NULL, count, "tolerance=0.1\nup=z", &fitted));
    OK(get_path_space(fitted, centre, &half, &up));
    NEAR(centre[0], 1000, 0.1);
    NEAR(half, 55, 0.1);
    CHECK(up == V_UP_Z);
    v_path_free(fitted);
    OK(v_path_fit_poses(poses, NULL, count, "tolerance=0.1\nspace=1000,0,0,400", &fitted));
    OK(get_path_space(fitted, centre, &half, &up));
    CHECK(centre[0] == 1000 && half == 400 && up == V_UP_Y);
    v_path_free(fitted);
    OK(v_path_fit_poses(poses, NULL, count, NULL, &fitted));
    OK(get_path_space(fitted, centre, &half, &up));
    NEAR(half, 55, 0.1);
    OK(v_last_number("tolerance", &tolerance));
    NEAR(tolerance, 1e-3 * sqrt(2) * 100, 1e-3); /* of the diagonal of a flat square */
    OK(v_path_fit_poses(poses, NULL, count, "points=6", &path));
    OK(v_last_number("tolerance", &least));
    OK(v_path_point_count(path, &points));
    CHECK(points <= 6 && least > 0);
    OK(v_path_sample(path, again, 250, &count));
    CHECK(count == 250);
    for (i = 0; i < count; i++)
        for (k = 0; k < 3; k++)
            NEAR(again[i].vrp[k], poses[i].vrp[k], 1.01 * least);
    v_path_free(path);
    v_path_free(fitted);

    poses[77].vrp[2] += 5;
    OK(v_path_fit_poses(poses, NULL, count, "tolerance=0.1\nup=z\nrobust=yes\nspace=1000,0,0,400",
                        &fitted));
    OK(v_last_number("left_out", &left_out));
    CHECK(left_out == 1);
    CHECK(strstr(v_last_warning(),
          "Found: 1 outlier. 1 pose is left out, first poses[77].") != NULL);
    OK(v_path_sample(fitted, again, 250, &count));
    CHECK(count == 250);
    for (i = 0; i < count; i++)
        for (k = 0; k < 3; k++)
            NEAR(again[i].vrp[k], poses[i].vrp[k] - 5 * (i == 77 && k == 2), 0.11);
    v_path_free(fitted);
    STATUS(V_ERR_RANGE, v_path_fit_poses(poses, NULL, 9, "space=0,0,0,0", &fitted));
    STATUS(V_ERR_ARGUMENT, v_path_fit_poses(poses, NULL, 9, "up=x", &fitted));
    STATUS(V_ERR_RANGE, v_path_fit_poses(poses, NULL, 9, "near=1", &fitted));
    CHECK(strstr(v_last_error(), "tolerance, angle, points, robust, fps, up, space") != NULL);
}

static void what_looks_wrong_is_found(void)
{
    V_PATH *path = orbit(1, 4);
    V_FINDING findings[8];
    V_MESH mesh = {sizeof mesh, NULL, 0, NULL, NULL, 0, NULL, 0};
    const double corners[9] = {-2, 0, 0.5, 2, 0, 0.5, 0, 3, 0.5};
    const unsigned triangle[3] = {0, 1, 2};
    size_t count = 99, i;
    double limit = 0;
    int through = 0;

    OK(v_path_check(path, NULL, NULL, 0, &count));
    CHECK(count > 0 && count <= 8); /* 90 degrees a second */
    STATUS(V_ERR_SIZE, v_path_check(path, NULL, findings, 0, &count));
    OK(v_path_check(path, NULL, findings, 8, &count));
    CHECK(strcmp(findings[count - 1].kind, "turning") == 0
          || strcmp(findings[0].kind, "turning") == 0
          || strcmp(findings[count - 1].kind, "space") == 0);
    OK(v_path_set_number(path, "check.turning", 100));
    OK(v_path_set_number(path, "check.space", 10));
    OK(v_path_get_number(path, "check.turning", &limit));
    CHECK(limit == 100);
    OK(v_path_check(path, NULL, NULL, 0, &count));
    CHECK(count == 0);
    mesh.xyz = corners;
    mesh.points = 3;
    mesh.triangles = triangle;
    mesh.corners = 3;
    OK(v_path_check(path, &mesh, findings, 8, &count));
    for (i = 0; i < count; i++)
        through += strcmp(findings[i].kind, "through") == 0;
    CHECK(through == 2);
    mesh.points = 0;
    mesh.corners = 0;
    STATUS(V_ERR_ARGUMENT, v_path_check(path, &mesh, findings, 8, &count));
    STATUS(V_ERR_RANGE, v_path_set_number(path, "check.tuning", 1));
    STATUS(V_ERR_RANGE, v_path_set_number(path, "check.turning", -1));
    v_path_free(path);
}

/* Whether a kind is among the findings, with its value. */
static int has(const V_FINDING *findings, size_t count, const char *kind, double *value)
{
    size_t i;

    for (i = 0; i < count; i++)
        if (strcmp(findings[i].kind, kind) == 0) {
            *value = findings[i].value;
            return 1;
        }
    return 0;
}

/* Quads of a box whose corners are the bits of their number, in two triangles each. */
static const unsigned box_corners[36] = {
    0, 1, 3, 0, 3, 2, 4, 5, 7, 4, 7, 6, 0, 1, 5, 0, 5, 4,
    2, 3, 7, 2, 7, 6, 0, 2, 6, 0, 6, 4, 1, 3, 7, 1, 7, 5};

/* A cube of 0.5 around the origin. */
static V_MESH cube(double corners[24])
{
    V_MESH box = {sizeof box, corners, 8, NULL, NULL, 0, box_corners, 36};
    int i;

    for (i = 0; i < 24; i++)
        corners[i] = (i / 3) >> (i % 3) & 1 ? 0.25 : -0.25;
    return box;
}

static void the_faces_of_the_own_object_are_looked_at(void)
{
    V_PATH *path = NULL;
    V_FINDING own[16], given[16];
    double corners[24], value = 9, limit = 0;
    V_MESH box = cube(corners);
    const double ends[2][3] = {{-0.8, 0.01, 0.02}, {0.8, 0.01, 0.02}};
    size_t i, count = 0, other = 0;

    OK(v_path_new(&path));
    OK(set_position(path, 0, ends[0]));
    OK(set_position(path, 1, ends[1]));
    OK(v_path_check(path, NULL, own, 16, &count));
    CHECK(!has(own, count, "through", &value));
    OK(v_path_check(path, &box, given, 16, &other));
    OK(v_path_set_object(path, &box));
    OK(v_path_check(path, NULL, own, 16, &count));
    CHECK(count == other && memcmp(own, given, count * sizeof *own) == 0);
    CHECK(has(own, count, "through", &value));
    CHECK(has(own, count, "clearance", &value) && value == 0);
    CHECK(strcmp(v_last_warning(), "") == 0);
    /* A room: the camera never leaves it. */
    for (i = 0; i < 24; i++)
        corners[i] *= 4;
    OK(v_path_set_object(path, &box));
    OK(v_path_check(path, NULL, own, 16, &count));
    CHECK(!has(own, count, "through", &value));
    CHECK(strstr(v_last_warning(), "inside") != NULL && v_last_error()[0] == 0);
    OK(v_path_set_object(path, NULL));
    OK(v_path_check(path, NULL, NULL, 0, &count));
    CHECK(strcmp(v_last_warning(), "") == 0);
    v_path_free(path);
    /* What is off unless a limit is set: on a circle r w^3 = 1.2 (pi / 2)^3 = 4.65. */
    path = orbit(1, 4);
    OK(v_path_get_number(path, "check.jerk", &limit));
    CHECK(limit == INFINITY);
    OK(v_path_set_number(path, "check.jerk", 4));
    OK(v_path_check(path, NULL, own, 16, &count));
    CHECK(has(own, count, "jerk", &value) && value > 4);
    OK(v_path_set_number(path, "check.jerk", INFINITY));
    OK(v_path_check(path, NULL, own, 16, &count));
    CHECK(!has(own, count, "jerk", &value));
    v_path_free(path);
}

/* From rest to rest on a straight line: the trapezoid, to the next frames. */
static void retime(void)
{
    V_PATH *path;
    V_POSE pose;
    double place[3] = {0, 0, 0}, seconds = 0;
    size_t frames, again;

    OK(v_path_new(&path));
    OK(set_position(path, 0, place));
    place[0] = 0.9;
    OK(set_position(path, 1, place));
    OK(v_path_set_number(path, "check.speed", 0.5));
    OK(v_path_set_number(path, "check.acceleration", 1));
    OK(tool(path, "retime", NULL, "seconds=0\nfirst=1\nlast=2"));
    OK(v_path_frame_count(path, &frames));
    /* 0.9 / 0.5 + 0.5 / 1 = 2.3 s = 57.5 frames. */
    CHECK(frames >= 59 && frames <= 61);
    OK(v_path_pose(path, (1 + (double)frames) / 2, &pose));
    CHECK(fabs(pose.vrp[0] - 0.45) < 0.01);
    /* Exactly so long; too short is refused, with the least time, and changes nothing. */
    OK(tool(path, "retime", NULL, "seconds=4\nfirst=1\nlast=2"));
    OK(v_path_frame_count(path, &frames));
    CHECK(frames == 100);
    STATUS(V_ERR_ARGUMENT, tool(path, "retime", NULL, "seconds=1\nfirst=1\nlast=2"));
    CHECK(strstr(v_last_error(), "too short") != NULL);
    STATUS(V_ERR_ARGUMENT, v_last_number("seconds", &seconds)); /* it failed */
    OK(tool(path, "retime", NULL, "seconds=4"));
    OK(v_last_number("seconds", &seconds));
    CHECK(seconds == 4);
    STATUS(V_ERR_ARGUMENT, v_last_number("minutes", &seconds));
    CHECK(strcmp(v_last_error(), "the last tool reported no number \"minutes\"") == 0);
    STATUS(V_ERR_NULL, v_last_number(NULL, &seconds));
    STATUS(V_ERR_NULL, v_last_number("seconds", NULL));
    STATUS(V_ERR_ARGUMENT, v_path_tool(path, "retimes", NULL, NULL));
    CHECK(strcmp(v_last_error(), "there is no tool \"retimes\" for a path") == 0);
    STATUS(V_ERR_ARGUMENT, v_path_tool(path, "insert", NULL, NULL)); /* it needs another path */
    STATUS(V_ERR_RANGE, v_path_tool(path, "retime", "duration=4", NULL));
    CHECK(strstr(v_last_error(), "\"duration\"; known here: seconds, first, last") != NULL);
    STATUS(V_ERR_ARGUMENT, v_path_tool(path, "retime", "seconds=long", NULL));
    CHECK(strcmp(v_last_error(), "seconds: expected a number, found a text") == 0);
    STATUS(V_ERR_ARGUMENT, v_path_tool(path, "move", "by=1,2", NULL));
    CHECK(strcmp(v_last_error(), "by: expected 3 numbers, found 2") == 0);
    STATUS(V_ERR_ARGUMENT, v_path_tool(path, "turn", "with_targets=perhaps", NULL));
    STATUS(V_ERR_NULL, v_path_tool(path, NULL, NULL, NULL));
    STATUS(V_ERR_NULL, v_path_tool(NULL, "reverse", NULL, NULL));
    STATUS(V_ERR_RANGE, tool(path, "retime", NULL, "seconds=0\nfirst=1\nlast=3"));
    OK(v_path_frame_count(path, &again));
    CHECK(again == frames);
    v_path_free(path);
}

static void larger(double *most, double value)
{
    if (value > *most)
        *most = value;
}

/* A flight with a shake at every other frame: it goes, and within a bound no place goes far. */
static void steady(void)
{
    V_PATH *path, *again;
    V_POSE poses[200], was, pose;
    size_t frames, k;
    double shake = 0, rest = 0, far = 0;

    memset(poses, 0, sizeof poses);
    for (k = 0; k < 200; k++) {
        poses[k].vrp[0] = 0.01 * (double)k;
        poses[k].vrp[1] = 0.5 * sin(0.02 * (double)k) + (k % 2 ? 0.004 : -0.004);
        poses[k].vpn[2] = poses[k].vup[1] = 1;
        poses[k].zoom = 30;
    }
    OK(v_path_fit_poses(poses, NULL, 200, "tolerance=1e-4\nangle=0.1", &path));
    OK(v_path_clone(path, &again));
    OK(tool(path, "steady", NULL, "period=1\nwithin=0"));
    CHECK(strstr(v_last_warning(), "places went 0.00") != NULL);
    OK(v_path_frame_count(path, &frames));
    CHECK(frames == 200);
    for (k = 20; k < 180; k++) {
        double smooth = 0.5 * sin(0.02 * (double)k);
        OK(v_path_pose(path, (double)(k + 1), &pose));
        larger(&shake, fabs(poses[k].vrp[1] - smooth));
        larger(&rest, fabs(pose.vrp[1] - smooth));
    }
    CHECK(shake > 0.0039 && rest < 0.001);
    OK(tool(again, "steady", NULL, "period=1\nwithin=0.003"));
    for (k = 0; k < 200; k++) {
        OK(v_path_pose(again, (double)(k + 1), &was));
        larger(&far, fabs(was.vrp[1] - poses[k].vrp[1]));
    }
    CHECK(far < 0.0032);
    STATUS(V_ERR_RANGE, tool(path, "steady", NULL, "period=0\nwithin=0"));
    STATUS(V_ERR_RANGE, tool(path, "steady", NULL, "period=80.1\nwithin=0"));
    CHECK(strstr(v_last_error(), "period") != NULL);
    STATUS(V_ERR_RANGE, tool(path, "steady", NULL, "period=1\nwithin=-1"));
    CHECK(strstr(v_last_error(), "within") != NULL);
    v_path_free(path);
    v_path_free(again);
}

/* Round a box; within a closed one there is no way. */
static void avoid(void)
{
    V_PATH *path = NULL;
    V_FINDING found[16];
    double corners[24], value = 9, place[3];
    V_MESH box = cube(corners);
    const double ends[2][3] = {{-0.8, 0.01, 0.02}, {0.8, 0.01, 0.02}};
    size_t count = 0;
    int points, again;

    OK(v_path_new(&path));
    OK(set_position(path, 0, ends[0]));
    OK(set_position(path, 1, ends[1]));
    STATUS(V_ERR_ARGUMENT, tool(path, "avoid", NULL, "clearance=0.1\nradius=0"));
    STATUS(V_ERR_RANGE, tool(path, "avoid", &box, "clearance=0\nradius=0"));
    STATUS(V_ERR_ARGUMENT, tool(path, "avoid", &box, "clearance=0.1\nradius=%g", NAN));
    OK(v_path_set_number(path, "check.clearance", 0.12));
    OK(v_path_check(path, &box, found, 16, &count));
    CHECK(has(found, count, "through", &value));
    OK(tool(path, "avoid", &box, "clearance=0.1\nradius=0.02"));
    CHECK(strstr(v_last_warning(), "put in") != NULL);
    OK(v_path_check(path, &box, found, 16, &count));
    CHECK(!has(found, count, "through", &value) && !has(found, count, "clearance", &value));
    OK(v_path_point_count(path, &points));
    CHECK(points == 4);
    OK(get_position(path, points - 1, place));
    CHECK(memcmp(place, ends[1], sizeof place) == 0);
    OK(tool(path, "avoid", &box, "clearance=0.1\nradius=0.02"));
    CHECK(strcmp(v_last_warning(), "") == 0);
    OK(v_path_point_count(path, &again));
    CHECK(again == points);
    place[0] = place[1] = place[2] = 0;
    OK(set_position(path, points - 1, place));
    STATUS(V_ERR_ARGUMENT, tool(path, "avoid", &box, "clearance=0.1\nradius=0"));
    CHECK(strstr(v_last_error(), "no way round") != NULL && strstr(v_last_error(),
          "frame") != NULL);
    v_path_free(path);
}

/* The greatest share of the picture that a corner takes at ten places a frame; 9: one is behind. */
static double taken(const V_PATH *path, const double *xyz, size_t points)
{
    size_t frames, k, at;
    double most = 0;

    OK(v_path_frame_count(path, &frames));
    for (k = 0; k <= 10 * (frames - 1); k++) {
        V_POSE pose;
        double right[3];

        OK(v_path_pose(path, 1 + (double)k / 10, &pose));
        right[0] = pose.vpn[1] * pose.vup[2] - pose.vpn[2] * pose.vup[1];
        right[1] = pose.vpn[2] * pose.vup[0] - pose.vpn[0] * pose.vup[2];
        right[2] = pose.vpn[0] * pose.vup[1] - pose.vpn[1] * pose.vup[0];
        for (at = 0; at < points; at++) {
            double x = 0, y = 0, depth = 0;
            int i;

            for (i = 0; i < 3; i++) {
                double way = xyz[3 * at + (size_t)i] - pose.vrp[i];
                x += way * right[i];
                y += way * pose.vup[i];
                depth += way * pose.vpn[i];
            }
            if (depth <= 0)
                return 9;
            most = fmax(most, fabs(x) * pose.zoom / (18 * depth));
            most = fmax(most, fabs(y) * pose.zoom / (12 * depth));
        }
    }
    return most;
}

/* All corners of a house stay in the picture, less a margin of a tenth. */
static void picture(void)
{
    static const double xyz[] = {-0.3, 0, -0.2, 0.3, 0, -0.2, 0.3, 0.3, 0.2, -0.3, 0.5, 0.2};
    static const unsigned triangles[] = {0, 1, 2, 0, 2, 3};
    V_PATH *path;
    V_MESH mesh;
    static const char *const ways[] = {"zoom", "distance", "view"};
    int what;

    memset(&mesh, 0, sizeof mesh);
    mesh.size = sizeof mesh;
    mesh.xyz = xyz;
    mesh.points = 4;
    mesh.triangles = triangles;
    mesh.corners = 6;
    for (what = 0; what < 3; what++) {
        double share;

        path = orbit(1.5, 4);
        /* Turning alone needs room: there is some with a wide angle. */
        if (what == 2) {
            static const double aside[3] = {0.7, 0.4, 0};
            int k, count;

            OK(v_path_point_count(path, &count));
            for (k = 0; k < count; k++) {
                V_ORIENTATION view;

                v_orientation_init(&view);
                OK(v_path_get_orientation(path, k, 0, &view));
                memcpy(view.target, aside, sizeof aside);
                view.zoom = 14;
                OK(v_path_set_orientation(path, k, 0, &view));
            }
            CHECK(taken(path, xyz, 4) > 0.8);
        }
        OK(tool(path, "picture", &mesh, "margin=0.1\nwhat=%s", ways[what]));
        share = taken(path, xyz, 4);
        CHECK(share <= 0.8 && share >= 0.99 * 0.8);
        /* As tight as that it stays to the bit. */
        OK(tool(path, "picture", &mesh, "margin=0.1\nwhat=%s", ways[what]));
        CHECK(taken(path, xyz, 4) == share);
        STATUS(V_ERR_RANGE, tool(path, "picture", &mesh, "margin=0.5\nwhat=%s", ways[what]));
        CHECK(strstr(v_last_error(), "margin") != NULL);
        STATUS(V_ERR_ARGUMENT, tool(path, "picture", &mesh, "margin=nan\nwhat=%s", ways[what]));
        STATUS(V_ERR_ARGUMENT, tool(path, "picture", NULL, "margin=0.1\nwhat=%s", ways[what]));
        CHECK(taken(path, xyz, 4) == share);
        v_path_free(path);
    }
    OK(v_path_new(&path));
    STATUS(V_ERR_ARGUMENT, v_path_tool(path, "picture", "what=sound", &mesh));
    CHECK(strcmp(v_last_error(), "what: must be \"zoom\", \"distance\" or \"view\"") == 0);
    v_path_free(path);
}

/* An octahedron is seen from all sides; nothing is found by a check. */
static void tour(void)
{
    const double xyz[] = {1, 0, 0, -1, 0, 0, 0, 1, 0, 0, -1, 0, 0, 0, 1, 0, 0, -1};
    const unsigned corners[] = {0, 2, 4, 2, 1, 4, 1, 3, 4, 3, 0, 4, 2, 0, 5, 1, 2, 5, 3, 1, 5, 0,
        3, 5};
    V_MESH object;
    V_PATH *path = new_path(), *other;
    V_FINDING found[8];
    double coverage = 0, seconds = 0;
    V_POSE pose;
    size_t frames, count;

    memset(&object, 0, sizeof object);
    object.size = sizeof object;
    object.points = 6;
    object.xyz = xyz;
    object.triangles = corners;
    object.corners = 24;
    OK(v_path_tool(path, "tour", "seconds=40\ncoverage=1", &object));
    CHECK(strstr(v_last_warning(), "100.0 %") != NULL);
    OK(v_last_number("coverage", &coverage));
    CHECK(coverage > 0.999);
    OK(v_last_number("seconds", &seconds));
    OK(v_path_frame_count(path, &frames));
    NEAR(seconds * 25, (double)frames, 1.5);
    /* A closed round comes back to its first pose, which is not shown twice. */
    CHECK(frames >= 1000 && frames <= 1001);
    OK(v_path_check(path, &object, found, 8, &count));
    CHECK(count == 0);
    /* From a start; of the path's own object; what will not do is refused. */
    OK(v_path_tool(path, "tour", "start=0,0,4", &object));
    OK(v_path_pose(path, 1, &pose));
    NEAR(pose.vrp[2], 4, 1e-6);
    STATUS(V_ERR_ARGUMENT, v_path_tool(path, "tour", NULL, NULL));
    CHECK(strstr(v_last_error(), "surface") != NULL);
    OK(v_path_set_object(path, &object));
    OK(v_path_tool(path, "tour", NULL, NULL));
    OK(v_path_clone(path, &other));
    STATUS(V_ERR_ARGUMENT, v_path_tool(path, "tour", "start=0,0,0.5", &object));
    CHECK(strstr(v_last_error(), "start") != NULL);
    STATUS(V_ERR_ARGUMENT, v_path_tool(path, "tour", "seconds=0.1", &object));
    CHECK(strstr(v_last_error(), "too short") != NULL);
    STATUS(V_ERR_RANGE, v_path_tool(path, "tour", "coverage=1.5", &object));
    STATUS(V_ERR_ARGUMENT, v_path_tool(path, "tour", "start=0,nan,1", &object));
    OK(v_path_frame_count(path, &frames));
    OK(v_path_frame_count(other, &count));
    CHECK(frames == count);
    v_path_free(other);
    OK(v_path_tool(path, "tour", "coverage=1\ninside=yes", &object));
    OK(v_last_number("coverage", &coverage));
    CHECK(coverage > 0.999);
    object.corners = 0;
    STATUS(V_ERR_ARGUMENT, v_path_tool(path, "tour", NULL, &object));
    CHECK(strstr(v_last_error(), "surface") != NULL);
    v_path_free(path);
}

/* A node's path in its scene: the object is the scene's, and pins hold. */
static void a_tool_in_a_scene(void)
{
    static const unsigned corners[] = {0, 1, 2};
    static const double xyz[] = {-0.2, 0, 0.8, 0.2, 0, 0.8, 0, 0.4, 0.8};
    V_SCENE *scene = NULL;
    V_PATH *before = NULL, *path = NULL;
    V_MESH mesh = {sizeof mesh, NULL, 0, NULL, NULL, 0, NULL, 0};
    V_NODE node;
    double moved = -1, start = 0;
    size_t frames, count;
    V_FINDING found[9];
    int sheet, points, after;

    OK(v_scene_new(&scene));
    v_node_init(&node, V_NODE_OBJECT);
    OK(v_scene_add_node(scene, "sheet", &node, &sheet));
    mesh.xyz = xyz;
    mesh.points = 3;
    mesh.triangles = corners;
    mesh.corners = 3;
    OK(v_scene_set_geometry(scene, sheet, &mesh));
    OK(v_scene_get_path(scene, 0, &before, NULL, NULL));
    OK(v_scene_set_path(scene, 0, before, 11, V_AFTER_REPEAT));
    OK(v_scene_tool(scene, 0, "avoid", "clearance=0.1", NULL));
    OK(v_last_number("parts", &moved));
    CHECK(moved == 1 && strcmp(v_last_warning(), "") != 0);
    OK(v_scene_get_path(scene, 0, &path, &start, &after));
    CHECK(start == 11 && after == V_AFTER_REPEAT);
    OK(v_path_point_count(path, &points));
    CHECK(points > 2);
    OK(v_path_set_number(path, "check.clearance", 0.09));
    OK(v_path_check(path, &mesh, found, 9, &count));
    while (count-- > 0)
        CHECK(strcmp(found[count].kind, "clearance") != 0 && strcmp(found[count].kind, "through") != 0);
    v_path_free(path);
    /* Pinned to frame 31, the last point is reached there, however long the way. */
    OK(v_scene_set_path(scene, 0, before, 1, V_AFTER_HOLD));
    OK(v_scene_set_marker(scene, "meet", 31));
    OK(v_scene_set_marker(scene, "begin", 1));
    OK(v_scene_pin(scene, 0, 0, "begin"));
    OK(v_scene_pin(scene, 0, 1, "meet"));
    OK(v_scene_tool(scene, 0, "scale", "factor=3\nabout=origin", NULL));
    OK(v_scene_get_path(scene, 0, &path, NULL, NULL));
    OK(v_path_frame_count(path, &frames));
    CHECK(frames == 31);
    v_path_free(path);
    STATUS(V_ERR_RANGE, v_scene_tool(scene, 7, "reverse", NULL, NULL));
    STATUS(V_ERR_RANGE, v_scene_tool(scene, -1, "reverse", NULL, NULL));
    STATUS(V_ERR_ARGUMENT, v_scene_tool(scene, sheet, "reverse", NULL, NULL));
    STATUS(V_ERR_ARGUMENT, v_scene_tool(scene, 0, "fold", NULL, NULL));
    STATUS(V_ERR_ARGUMENT, v_scene_tool(scene, 0, "scale", "factor=much", NULL));
    OK(v_scene_get_path(scene, 0, &path, NULL, NULL));
    OK(v_path_frame_count(path, &frames));
    CHECK(frames == 31);
    v_path_free(path);
    v_path_free(before);
    v_scene_free(scene);
}

int main(void)
{
    the_faces_of_the_own_object_are_looked_at();
    a_tool_in_a_scene();
    an_orbit_is_round();
    points_are_moved_and_deformed();
    blocks();
    moves_and_fits_have_a_space();
    what_looks_wrong_is_found();
    retime();
    steady();
    avoid();
    picture();
    tour();
    return failures != 0;
}
