/*
 * The host's own coordinates: a path in another space is the same path carried
 * there, z may stand upright, and the host's camera becomes an orientation.
 */
#include "check.h"

enum { MOST = 2000 };

static const double far_away[3] = {1e9, -7e8, 3e8};
static const double unit_cube[3] = {0, 0, 0};

/* y upright to z upright. */
static void exchange(const double from[3], double to[3])
{
    to[0] = from[2];
    to[1] = from[0];
    to[2] = from[1];
}

/* The new path, bent and looking about, in a space. */
static V_PATH *bent_path(const double centre[3], double half_size, int up)
{
    static const double places[4][3] = {
        {-0.6, 0.2, 0.8}, {0.6, -0.3, 0.5}, {0.4, 0.7, -0.6}, {-0.5, 0.1, -0.4}};
    V_PATH *path = new_path();
    V_ORIENTATION o;
    int point, k;
    OK(v_path_set_space(path, centre, half_size, up));
    for (point = 0; point < 4; point++) {
        double in_cube[3], at[3];
        exchange(places[point], in_cube);
        for (k = 0; k < 3; k++)
            at[k] = centre[k] + half_size * (up == V_UP_Z ? in_cube[k] : places[point][k]);
        OK(v_path_insert_point(path, point, at));
        v_orientation_init(&o);
        for (k = 0; k < 3; k++)
            o.target[k] = 0;
        o.target[up == V_UP_Z ? 0 : 2] = -half_size;
        o.roll = 20 * point;
        o.zoom = 20 + point;
        o.absolute = 0;
        if (point == 2) { /* looks down */
            o.target[up] = -half_size;
        }
        OK(v_path_set_orientation(path, point, 0, &o));
    }
    OK(v_path_remove_point(path, 4));
    OK(v_path_remove_point(path, 4));
    return path;
}

static size_t poses_of(const V_PATH *path, V_POSE *poses)
{
    size_t count = 0;
    OK(v_path_sample(path, poses, MOST, &count));
    return count;
}

static void a_path_is_the_same_anywhere(void)
{
    static V_POSE here[MOST], there[MOST];
    static const double halves[] = {1e-6, 1, 1e6};
    V_PATH *plain = bent_path(unit_cube, 1, V_UP_Y);
    size_t count = poses_of(plain, here), n;
    int which, up, k;
    CHECK(count > 100);
    for (which = 0; which < 3; which++) {
        double half = halves[which], centre[3];
        for (k = 0; k < 3; k++)
            centre[k] = far_away[k] * 1e-6 * half;
        for (up = V_UP_Y; up <= V_UP_Z; up++) {
            V_PATH *path = bent_path(centre, half, up);
            CHECK(poses_of(path, there) == count);
            for (n = 0; n < count; n++) {
                double vrp[3], vpn[3], vup[3];
                memcpy(vrp, here[n].vrp, sizeof vrp);
                memcpy(vpn, here[n].vpn, sizeof vpn);
                memcpy(vup, here[n].vup, sizeof vup);
                if (up == V_UP_Z) {
                    exchange(here[n].vrp, vrp);
                    exchange(here[n].vpn, vpn);
                    exchange(here[n].vup, vup);
                }
                for (k = 0; k < 3; k++) {
                    NEAR(there[n].vrp[k], centre[k] + half * vrp[k], 1e-9 * half);
                    NEAR(there[n].vpn[k], vpn[k], 1e-10);
                    NEAR(there[n].vup[k], vup[k], 1e-10);
                }
            }
            v_path_free(path);
        }
    }
    v_path_free(plain);
}

static void what_is_set_comes_back(void)
{
    V_PATH *path = new_path(), *copy = NULL;
    double centre[3] = {7, 7, 7}, half = 0, at[3];
    int up = 0;
    OK(v_path_get_space(path, centre, &half, &up));
    CHECK(centre[0] == 0 && centre[1] == 0 && centre[2] == 0 && half == 1 && up == V_UP_Y);
    centre[1] = 2.5;
    OK(v_path_set_space(path, centre, 40, V_UP_Z));
    OK(v_path_get_position(path, 0, at));
    CHECK(at[0] == -0.6 && at[1] == 0.2 && at[2] == 0.8); /* numbers stay */
    OK(v_path_clone(path, &copy));
    centre[1] = 0;
    OK(v_path_get_space(copy, centre, &half, &up));
    CHECK(centre[1] == 2.5 && half == 40 && up == V_UP_Z);
    OK(v_path_get_space(copy, NULL, NULL, NULL));
    v_path_free(copy);
    v_path_free(path);
}

static void what_is_wrong_is_refused(void)
{
    static const double bad[] = {0, -1, 1e-300, 1e300};
    V_PATH *path = new_path();
    double centre[3] = {0, 0, 0}, half;
    int up;
    size_t k;
    for (k = 0; k < sizeof bad / sizeof *bad; k++)
        STATUS(V_ERR_RANGE, v_path_set_space(path, centre, bad[k], V_UP_Y));
    STATUS(V_ERR_RANGE, v_path_set_space(path, centre, sqrt(-1.0), V_UP_Y));
    STATUS(V_ERR_RANGE, v_path_set_space(path, centre, 1, 0));
    STATUS(V_ERR_RANGE, v_path_set_space(path, centre, 1, 3));
    STATUS(V_ERR_RANGE, v_path_set_space(path, far_away, 0.1, V_UP_Y));
    STATUS(V_ERR_RANGE, v_path_set_space(path, centre, 1e-12, V_UP_Y)); /* its points */
    STATUS(V_ERR_NULL, v_path_set_space(path, NULL, 1, V_UP_Y));
    STATUS(V_ERR_NULL, v_path_set_space(NULL, centre, 1, V_UP_Y));
    centre[2] = HUGE_VAL;
    STATUS(V_ERR_ARGUMENT, v_path_set_space(path, centre, 1, V_UP_Y));
    OK(v_path_get_space(path, centre, &half, &up));
    CHECK(centre[2] == 0 && half == 1 && up == V_UP_Y);
    v_path_free(path);
    STATUS(V_ERR_HANDLE, v_path_get_space(path, centre, &half, &up));
}

/* Points and views of the new path, by hand: z up, metres, round (100, 200, 30). */
static void a_new_path_lies_in_its_space(void)
{
    static const double at[2][3] = {{140, 170, 40}, {140, 230, 40}};
    V_PATH *path = NULL;
    V_SPACE space;
    V_ORIENTATION o;
    double centre[3], half, got[3];
    int up, point, k;
    v_space_init(&space);
    CHECK(space.size == sizeof space && space.half_size == 1 && space.up == V_UP_Y);
    CHECK(space.centre[0] == 0 && space.centre[1] == 0 && space.centre[2] == 0);
    memset(&space, 7, sizeof space);
    (v_space_init)(&space); /* as other languages call it */
    CHECK(space.size == sizeof space && space.half_size == 1 && space.up == V_UP_Y);
    space.centre[0] = 100;
    space.centre[1] = 200;
    space.centre[2] = 30;
    space.half_size = 50;
    space.up = V_UP_Z;
    OK(v_path_new_in_space(&space, &path));
    OK(v_path_get_space(path, centre, &half, &up));
    CHECK(memcmp(centre, space.centre, sizeof centre) == 0 && half == 50 && up == V_UP_Z);
    for (point = 0; point < 2; point++) {
        OK(v_path_get_position(path, point, got));
        for (k = 0; k < 3; k++)
            NEAR(got[k], at[point][k], 1e-12);
        v_orientation_init(&o);
        OK(v_path_get_orientation(path, point, 0, &o));
        CHECK(o.absolute == 0 && o.target[0] < 0 && o.target[1] == 0 && o.target[2] == 0);
    }
    v_path_free(path);
    OK(v_path_new_in_space(NULL, &path));
    OK(v_path_get_space(path, NULL, &half, &up));
    CHECK(half == 1 && up == V_UP_Y);
    v_path_free(path);
}

static void a_bad_space_is_refused(void)
{
    static const double bad[] = {0, -1, 1e-300, 1e300, HUGE_VAL};
    V_PATH *path = (V_PATH *)&path;
    V_SPACE space;
    size_t k;
    v_space_init(&space);
    for (k = 0; k < sizeof bad / sizeof *bad; k++) {
        space.half_size = bad[k];
        STATUS(V_ERR_RANGE, v_path_new_in_space(&space, &path));
    }
    space.half_size = 1;
    for (space.up = -1; space.up < 10; space.up++)
        if (space.up != V_UP_Y && space.up != V_UP_Z)
            STATUS(V_ERR_RANGE, v_path_new_in_space(&space, &path));
    space.up = V_UP_Z;
    space.centre[1] = 2e9;
    STATUS(V_ERR_RANGE, v_path_new_in_space(&space, &path));
    space.centre[1] = HUGE_VAL;
    STATUS(V_ERR_ARGUMENT, v_path_new_in_space(&space, &path));
    space.centre[1] = 0;
    STATUS(V_ERR_NULL, v_path_new_in_space(&space, NULL));
    for (k = 0; k < 80; k++)
        if (k != sizeof space) {
            space.size = k;
            STATUS(V_ERR_SIZE, v_path_new_in_space(&space, &path));
        }
    CHECK(path == (V_PATH *)&path); /* nothing was written */
}

/* Every pose of a path, made an orientation, is that pose again. */
static void a_pose_becomes_an_orientation(void)
{
    static V_POSE poses[MOST];
    int up, k;
    for (up = V_UP_Y; up <= V_UP_Z; up++) {
        V_PATH *path = bent_path(far_away, 1e6, up);
        size_t count = poses_of(path, poses), n;
        for (n = 0; n < count; n += 7) {
            V_ORIENTATION o;
            V_POSE again;
            v_orientation_init(&o);
            o.absolute = 1;
            o.hold = 5;
            OK(v_orientation_from_pose(&poses[n], up, &o));
            CHECK(o.size == sizeof o && o.absolute == 0 && o.hold == 5 && o.speed[3] == 50);
            o.hold = 0;
            OK(v_path_set_position(path, 0, poses[n].vrp));
            OK(v_path_set_orientation(path, 0, 0, &o));
            OK(v_path_pose(path, 1, &again));
            NEAR(again.zoom, poses[n].zoom, 1e-12);
            for (k = 0; k < 3; k++) {
                CHECK(again.vrp[k] == poses[n].vrp[k]);
                NEAR(again.vpn[k], poses[n].vpn[k], 1e-12);
                NEAR(again.vup[k], poses[n].vup[k], 1e-12);
            }
        }
        v_path_free(path);
    }
}

static void a_bad_pose_is_refused(void)
{
    V_POSE pose = {{0, 0, 0}, {0, 0, 1}, {0, 1, 0}, 24}, bad;
    V_ORIENTATION o, before;
    v_orientation_init(&o);
    before = o;
    bad = pose;
    bad.zoom = 0;
    STATUS(V_ERR_RANGE, v_orientation_from_pose(&bad, V_UP_Y, &o));
    bad = pose;
    bad.vpn[2] = 0;
    STATUS(V_ERR_ARGUMENT, v_orientation_from_pose(&bad, V_UP_Y, &o));
    bad = pose;
    bad.vup[1] = 0;
    bad.vup[2] = 3;
    STATUS(V_ERR_ARGUMENT, v_orientation_from_pose(&bad, V_UP_Y, &o));
    STATUS(V_ERR_RANGE, v_orientation_from_pose(&pose, 0, &o));
    STATUS(V_ERR_NULL, v_orientation_from_pose(NULL, V_UP_Y, &o));
    STATUS(V_ERR_NULL, v_orientation_from_pose(&pose, V_UP_Y, NULL));
    o.size = 4;
    STATUS(V_ERR_SIZE, v_orientation_from_pose(&pose, V_UP_Y, &o));
    o.size = sizeof o;
    CHECK(memcmp(&o, &before, sizeof o) == 0);
    pose.vpn[2] = 250; /* any length */
    pose.vup[2] = 8;   /* brought to be perpendicular */
    OK(v_orientation_from_pose(&pose, V_UP_Y, &o));
    CHECK(o.target[2] == 1 && o.roll == 0);
}

/* A file keeps the space. */
static void a_file_keeps_it(const char *folder)
{
    static V_POSE here[MOST], there[MOST];
    char file[4096];
    V_PATH *path = bent_path(far_away, 1e6, V_UP_Z), *loaded = NULL;
    size_t count = poses_of(path, here);
    snprintf(file, sizeof file, "%s/space.vid", folder);
    OK(v_path_save(path, file));
    OK(v_path_load(file, &loaded));
    CHECK(poses_of(loaded, there) == count);
    CHECK(memcmp(here, there, count * sizeof *here) == 0);
    v_path_free(loaded);
    v_path_free(path);
}

int main(int argc, char **argv)
{
    a_path_is_the_same_anywhere();
    what_is_set_comes_back();
    what_is_wrong_is_refused();
    a_new_path_lies_in_its_space();
    a_bad_space_is_refused();
    a_pose_becomes_an_orientation();
    a_bad_pose_is_refused();
    a_file_keeps_it(argc > 1 ? argv[1] : ".");
    return failures != 0;
}
