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
    OK(set_path_space(path, centre, half_size, up));
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
    OK(get_path_space(path, centre, &half, &up));
    CHECK(centre[0] == 0 && centre[1] == 0 && centre[2] == 0 && half == 1 && up == V_UP_Y);
    centre[1] = 2.5;
    OK(set_path_space(path, centre, 40, V_UP_Z));
    OK(get_position(path, 0, at));
    CHECK(at[0] == -0.6 && at[1] == 0.2 && at[2] == 0.8); /* numbers stay */
    OK(v_path_clone(path, &copy));
    centre[1] = 0;
    OK(get_path_space(copy, centre, &half, &up));
    CHECK(centre[1] == 2.5 && half == 40 && up == V_UP_Z);
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
        STATUS(V_ERR_RANGE, set_path_space(path, centre, bad[k], V_UP_Y));
    STATUS(V_ERR_RANGE, set_path_space(path, centre, sqrt(-1.0), V_UP_Y));
    STATUS(V_ERR_ARGUMENT, set_path_space(path, centre, 1, 3));
    STATUS(V_ERR_RANGE, v_path_set_number(path, "space.size", 1));
    CHECK(strstr(v_last_error(), "known here: centre, half_size, up") != NULL);
    STATUS(V_ERR_RANGE, set_path_space(path, far_away, 0.1, V_UP_Y));
    STATUS(V_ERR_RANGE, set_path_space(path, centre, 1e-12, V_UP_Y)); /* its points */
    STATUS(V_ERR_NULL, set_path_space(path, NULL, 1, V_UP_Y));
    STATUS(V_ERR_NULL, set_path_space(NULL, centre, 1, V_UP_Y));
    centre[2] = HUGE_VAL;
    STATUS(V_ERR_ARGUMENT, set_path_space(path, centre, 1, V_UP_Y));
    OK(get_path_space(path, centre, &half, &up));
    CHECK(centre[2] == 0 && half == 1 && up == V_UP_Y);
    v_path_free(path);
    STATUS(V_ERR_HANDLE, get_path_space(path, centre, &half, &up));
}

/* Points and views of the new path, by hand: z up, metres, round (100, 200, 30). */
static void a_new_path_lies_in_its_space(void)
{
    static const double at[2][3] = {{140, 170, 40}, {140, 230, 40}};
    V_PATH *path = NULL;
    static const double there[3] = {100, 200, 30};
    V_ORIENTATION o;
    double centre[3], half, got[3];
    int up, point, k;
    OK(v_path_new_in_space(there, 50, V_UP_Z, &path));
    OK(get_path_space(path, centre, &half, &up));
    CHECK(memcmp(centre, there, sizeof centre) == 0 && half == 50 && up == V_UP_Z);
    for (point = 0; point < 2; point++) {
        OK(get_position(path, point, got));
        for (k = 0; k < 3; k++)
            NEAR(got[k], at[point][k], 1e-12);
        v_orientation_init(&o);
        OK(v_path_get_orientation(path, point, 0, &o));
        CHECK(o.absolute == 0 && o.target[0] < 0 && o.target[1] == 0 && o.target[2] == 0);
    }
    v_path_free(path);
}

static void a_bad_space_is_refused(void)
{
    static const double bad[] = {0, -1, 1e-300, 1e300, HUGE_VAL};
    V_PATH *path = (V_PATH *)&path;
    double centre[3] = {0, 0, 0};
    size_t k;
    int up;
    for (k = 0; k < sizeof bad / sizeof *bad; k++)
        STATUS(V_ERR_RANGE, v_path_new_in_space(centre, bad[k], V_UP_Y, &path));
    for (up = -1; up < 10; up++)
        if (up != V_UP_Y && up != V_UP_Z)
            STATUS(V_ERR_RANGE, v_path_new_in_space(centre, 1, up, &path));
    centre[1] = 2e9;
    STATUS(V_ERR_RANGE, v_path_new_in_space(centre, 1, V_UP_Z, &path));
    centre[1] = HUGE_VAL;
    STATUS(V_ERR_ARGUMENT, v_path_new_in_space(centre, 1, V_UP_Z, &path));
    centre[1] = 0;
    STATUS(V_ERR_NULL, v_path_new_in_space(centre, 1, V_UP_Z, NULL));
    STATUS(V_ERR_NULL, v_path_new_in_space(NULL, 1, V_UP_Z, &path));
    CHECK(path == (V_PATH *)&path); /* nothing was written */
}

/* Poses at whole frames and between stay when another axis becomes upright. */
static void another_axis_turns_nothing(void)
{
    static V_POSE before[MOST], after[MOST];
    static const double aim[3] = {0.1, -0.2, 0.05};
    V_PATH *path = bent_path(unit_cube, 1, V_UP_Y);
    V_ORIENTATION o;
    size_t count, n;
    int round, k, up;
    /* Points 0 and 1 track one target; the others turn freely. */
    for (k = 0; k < 2; k++) {
        v_orientation_init(&o);
        OK(v_path_get_orientation(path, k, 0, &o));
        o.absolute = 1;
        memcpy(o.target, aim, sizeof aim);
        OK(v_path_set_orientation(path, k, 0, &o));
    }
    OK(v_path_set_up(path, 3, 0, "z", NULL, NULL));
    count = poses_of(path, before);
    for (round = 0; round < 2; round++) {
        int to = round == 0 ? V_UP_Z : V_UP_Y;
        V_POSE here, there;
        V_PATH *old = NULL;
        OK(v_path_clone(path, &old));
        OK(v_path_change_up(path, to));
        {
            double centre[3], half;
            OK(get_path_space(path, centre, &half, &up));
        }
        CHECK(up == to && poses_of(path, after) == count);
        for (n = 0; n < 2 * count - 1; n++) {
            OK(v_path_pose(old, 1 + n / 2.0, &here));
            OK(v_path_pose(path, 1 + n / 2.0, &there));
            for (k = 0; k < 3; k++) {
                NEAR(here.vrp[k], there.vrp[k], 1e-12);
                NEAR(here.vpn[k], there.vpn[k], 1e-12);
                NEAR(here.vup[k], there.vup[k], 1e-12);
            }
        }
        for (n = 0; n < count; n++)
            for (k = 0; k < 3; k++)
                NEAR(before[n].vup[k], after[n].vup[k], 1e-12);
        v_path_free(old);
    }
    STATUS(V_ERR_RANGE, v_path_change_up(path, 9));
    STATUS(V_ERR_NULL, v_path_change_up(NULL, V_UP_Z));
    STATUS(V_ERR_ARGUMENT, v_path_set_up(path, 0, 0, "x", NULL, NULL));
    v_path_free(path);
    STATUS(V_ERR_HANDLE, v_path_change_up(path, V_UP_Z));
}

/* What a level camera at eye must be that looks at target, worked out by hand: up is
 * the axis less its part along the view. */
static void level(const double eye[3], const double target[3], int axis, double vpn[3], double vup[3])
{
    double length = 0, rest = 0;
    int k;
    for (k = 0; k < 3; k++)
        length += (target[k] - eye[k]) * (target[k] - eye[k]);
    for (k = 0; k < 3; k++)
        vpn[k] = (target[k] - eye[k]) / sqrt(length);
    for (k = 0; k < 3; k++) {
        vup[k] = (k == axis) - vpn[axis] * vpn[k];
        rest += vup[k] * vup[k];
    }
    for (k = 0; k < 3; k++)
        vup[k] /= sqrt(rest);
}

static void who_aims_stands_as_the_scene_does(void)
{
    static const double eye[3] = {140, 180, 42}, car[3] = {100, 203, 30.5};
    double centre[3] = {100, 200, 30}, got[3], half = 0, vpn[3], vup[3];
    V_SCENE *scene = NULL;
    V_NODE node;
    V_NODE_STATE states[3];
    size_t count = 0;
    int up = 0, target = -1, camera = -1, k;
    OK(v_scene_new(&scene));
    OK(get_scene_space(scene, got, &half, &up));
    CHECK(got[0] == 0 && half == 1 && up == V_UP_Y);
    v_node_init(&node, V_NODE_OBJECT);
    memcpy(node.position, car, sizeof car);
    OK(v_scene_add_node(scene, "car", &node, &target));
    v_node_init(&node, V_NODE_CAMERA);
    memcpy(node.position, eye, sizeof eye);
    node.aim = target;
    OK(v_scene_add_node(scene, "watch", &node, &camera));
    for (up = V_UP_Y; up <= V_UP_Z; up++) {
        int is = 0;
        OK(set_scene_space(scene, centre, 50, up));
        OK(get_scene_space(scene, got, &half, &is));
        CHECK(memcmp(got, centre, sizeof got) == 0 && half == 50 && is == up);
        OK(v_scene_evaluate(scene, 1, states, 3, &count));
        level(eye, car, up == V_UP_Z ? 2 : 1, vpn, vup);
        for (k = 0; k < 3; k++) {
            NEAR(states[camera].pose.vpn[k], vpn[k], 1e-12);
            NEAR(states[camera].pose.vup[k], vup[k], 1e-12);
        }
    }
    STATUS(V_ERR_RANGE, set_scene_space(scene, centre, 0, V_UP_Z));
    STATUS(V_ERR_ARGUMENT, set_scene_space(scene, centre, 50, 9));
    STATUS(V_ERR_NULL, set_scene_space(scene, NULL, 50, V_UP_Z));
    centre[1] = HUGE_VAL;
    STATUS(V_ERR_ARGUMENT, set_scene_space(scene, centre, 50, V_UP_Z));
    OK(get_scene_space(scene, got, &half, &up));
    CHECK(got[1] == 200 && half == 50 && up == V_UP_Z);
    v_scene_free(scene);
    STATUS(V_ERR_HANDLE, get_scene_space(scene, got, &half, &up));
}

static void near_poses(const V_POSE *a, const V_POSE *b, size_t count, double metres, double rest)
{
    size_t n;
    int k;
    for (n = 0; n < count; n++)
        for (k = 0; k < 3; k++) {
            NEAR(a[n].vrp[k], b[n].vrp[k], metres);
            NEAR(a[n].vpn[k], b[n].vpn[k], rest);
            NEAR(a[n].vup[k], b[n].vup[k], rest);
        }
}

/* A program whose world is z-up metres: what it hands in comes out of every door. */
static void metres_through_every_door(const char *folder)
{
    static const double places[4][3] = {{120, 170, 35}, {140, 200, 42}, {118, 228, 38}, {95, 225, 33}};
    static const double door[3] = {101, 199, 31.5}, middle[3] = {100, 200, 30};
    static V_POSE own[MOST], got[MOST];
    char file[4096];
    double centre[3], half, vpn[3], vup[3];
    V_PATH *path = NULL, *copy = NULL, *block = NULL;
    V_SCENE *scene = NULL, *loaded = NULL;
    V_NODE_STATE state[1];
    V_ORIENTATION o;
    V_KAMERAPAR list, *element;
    size_t count, n, one;
    int up, k, points;
    const double matrix[16] = {0, 1, 0, 0, -1, 0, 0, 0, 0, 0, 1, 0, 300, 100, 5, 1};

    OK(v_path_new_in_space(middle, 50, V_UP_Z, &path));
    for (k = 0; k < 4; k++) {
        OK(v_path_insert_point(path, k, places[k]));
        v_orientation_init(&o);
        o.absolute = 1;
        memcpy(o.target, door, sizeof door);
        OK(v_path_set_orientation(path, k, 0, &o));
    }
    OK(v_path_remove_point(path, 4));
    OK(v_path_remove_point(path, 4));
    count = poses_of(path, own);
    CHECK(count > 50);
    /* Each camera is level where z is up, by hand. */
    for (n = 0; n < count; n++) {
        level(own[n].vrp, door, 2, vpn, vup);
        for (k = 0; k < 3; k++) {
            NEAR(own[n].vpn[k], vpn[k], 1e-12);
            NEAR(own[n].vup[k], vup[k], 1e-12);
        }
    }
    /* The file, and text in memory. */
    snprintf(file, sizeof file, "%s/metres.vid", folder);
    OK(v_path_save(path, file));
    OK(v_path_load(file, &copy));
    CHECK(poses_of(copy, got) == count && memcmp(own, got, count * sizeof *own) == 0);
    OK(get_path_space(copy, centre, &half, &up));
    CHECK(memcmp(centre, middle, sizeof centre) == 0 && half == 50 && up == V_UP_Z);
    v_path_free(copy);
    /* A scene, its file, and the camera in it. */
    OK(v_scene_new(&scene));
    OK(set_scene_space(scene, middle, 50, V_UP_Z));
    OK(v_scene_set_path(scene, 0, path, 1, V_AFTER_HOLD));
    snprintf(file, sizeof file, "%s/scene.vid", folder);
    OK(v_scene_save(scene, file));
    OK(v_scene_load(file, &loaded));
    OK(get_scene_space(loaded, centre, &half, &up));
    CHECK(memcmp(centre, middle, sizeof centre) == 0 && half == 50 && up == V_UP_Z);
    for (n = 0; n < count; n += 5) {
        OK(v_scene_evaluate(loaded, (double)(n + 1), state, 1, &one));
        near_poses(&state[0].pose, &own[n], 1, 1e-9, 1e-12);
    }
    OK(v_scene_get_path(loaded, 0, &copy, NULL, NULL));
    CHECK(poses_of(copy, got) == count && memcmp(own, got, count * sizeof *own) == 0);
    v_path_free(copy);
    v_scene_free(loaded);
    v_scene_free(scene);
    /* The list of 1994, in float. */
    list.number = -1;
    OK(v_path_to_list(path, &list));
    element = &list;
    for (n = 0; n < count; n++, element = element->next) {
        NEAR(element->VRP.z, own[n].vrp[2], 1e-4);
        NEAR(element->VUP.z, own[n].vup[2], 1e-6);
    }
    v_free_liste(&list);
    /* A block, a quarter turn about z with targets, the way back. */
    OK(v_path_extract(path, 0, 3, &block));
    OK(get_path_space(block, centre, &half, &up));
    CHECK(memcmp(centre, middle, sizeof centre) == 0 && half == 50 && up == V_UP_Z);
    v_path_free(block);
    OK(v_path_clone(path, &copy));
    OK(v_path_point_count(copy, &points));
    OK(v_path_transform(copy, 0, points - 1, matrix, 1));
    CHECK(poses_of(copy, got) == count);
    for (n = 0; n < count; n++) {
        NEAR(got[n].vrp[0], 300 - own[n].vrp[1], 1e-9);
        NEAR(got[n].vrp[1], 100 + own[n].vrp[0], 1e-9);
        NEAR(got[n].vup[0], -own[n].vup[1], 1e-9);
        NEAR(got[n].vup[2], own[n].vup[2], 1e-9);
    }
    v_path_free(copy);
    OK(v_path_clone(path, &copy));
    OK(v_path_tool(copy, "reverse", NULL, NULL));
    OK(v_path_tool(copy, "reverse", NULL, NULL));
    CHECK(poses_of(copy, got) == count);
    near_poses(own, got, count, 1e-9, 1e-9);
    /* Y upright for a moment: nothing is turned, and the ups say which axis was. */
    OK(v_path_change_up(copy, V_UP_Y));
    CHECK(poses_of(copy, got) == count);
    near_poses(own, got, count, 1e-9, 1e-9);
    v_path_free(copy);
    v_path_free(path);
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
            OK(set_position(path, 0, poses[n].vrp));
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
    another_axis_turns_nothing();
    who_aims_stands_as_the_scene_does();
    metres_through_every_door(argc > 1 ? argv[1] : ".");
    a_pose_becomes_an_orientation();
    a_bad_pose_is_refused();
    a_file_keeps_it(argc > 1 ? argv[1] : ".");
    return failures != 0;
}
