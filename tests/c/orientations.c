/*
 * Orientations of support points: what is set comes back, what is wrong is
 * refused and changes nothing, and the struct's size is looked at.
 */
#include "check.h"

static int orientations_of(const V_PATH *path, int point)
{
    int count = -1;
    OK(v_path_orientation_count(path, point, &count));
    return count;
}

static V_ORIENTATION get(const V_PATH *path, int point, int at)
{
    V_ORIENTATION o;
    v_orientation_init(&o);
    OK(v_path_get_orientation(path, point, at, &o));
    return o;
}

static void the_defaults(void)
{
    V_PATH *path = new_path();
    V_ORIENTATION o, is;
    int i;
    memset(&o, 0xa5, sizeof o);
    v_orientation_init(&o);
    CHECK(o.size == sizeof o && o.absolute == 0);
    CHECK(o.target[0] == 0 && o.target[1] == 0 && o.target[2] == -0.4);
    CHECK(o.roll == 0 && o.zoom == 24);
    CHECK(o.tension == 0 && o.continuity == 0 && o.bias == 0 && o.hold == 0);
    for (i = 0; i < 10; i++)
        CHECK(o.speed[i] == 50);
    CHECK(orientations_of(path, 0) == 1 && orientations_of(path, 1) == 1);
    is = get(path, 1, 0);
    CHECK(is.size == sizeof is && is.absolute == o.absolute && is.zoom == o.zoom);
    CHECK(memcmp(is.target, o.target, sizeof o.target) == 0);
    CHECK(memcmp(is.speed, o.speed, sizeof o.speed) == 0);
    v_path_free(path);
}

static void what_is_set_comes_back(void)
{
    V_PATH *path = new_path();
    V_ORIENTATION o, is;
    int i;
    v_orientation_init(&o);
    o.absolute = 5;
    o.target[0] = 0.25;
    o.roll = 190;
    o.zoom = 99.5;
    o.tension = -1;
    o.continuity = 0.5;
    o.bias = 1;
    for (i = 0; i < 10; i++)
        o.speed[i] = 1 + 11 * i;
    o.hold = 1000000;
    OK(v_path_set_orientation(path, 1, 0, &o));
    is = get(path, 1, 0);
    CHECK(is.absolute == 1 && is.target[0] == 0.25 && is.target[2] == -0.4);
    CHECK(is.roll == -170 && is.zoom == 99.5);
    CHECK(is.tension == -1 && is.continuity == 0.5 && is.bias == 1);
    CHECK(memcmp(is.speed, o.speed, sizeof o.speed) == 0);
    CHECK(is.hold == 1000000);

    OK(v_path_insert_orientation(path, 1, 1, NULL)); /* copies the one before */
    CHECK(orientations_of(path, 1) == 2);
    CHECK(get(path, 1, 1).zoom == 99.5);
    o.zoom = 10;
    OK(v_path_insert_orientation(path, 1, 0, &o));
    CHECK(get(path, 1, 0).zoom == 10 && get(path, 1, 1).zoom == 99.5);
    OK(v_path_insert_orientation(path, 1, 0, NULL)); /* copies the first */
    CHECK(get(path, 1, 0).zoom == 10 && orientations_of(path, 1) == 4);
    OK(v_path_remove_orientation(path, 1, 3));
    OK(v_path_remove_orientation(path, 1, 0));
    CHECK(get(path, 1, 0).zoom == 10 && get(path, 1, 1).zoom == 99.5);

    for (i = 2; i < 10; i++)
        OK(v_path_insert_orientation(path, 1, i, NULL));
    STATUS(V_ERR_LIMIT, v_path_insert_orientation(path, 1, 10, NULL));
    STATUS(V_ERR_LIMIT, v_path_insert_orientation(path, 1, 0, &o));
    CHECK(orientations_of(path, 1) == 10);
    for (i = 9; i > 0; i--)
        OK(v_path_remove_orientation(path, 1, i));
    STATUS(V_ERR_RANGE, v_path_remove_orientation(path, 1, 0)); /* one remains */
    CHECK(orientations_of(path, 1) == 1);
    v_path_free(path);
}

/* One field wrong at a time. */
static void refused(V_PATH *path, int status, const V_ORIENTATION *o, int line)
{
    int set, inserted;
    V_ORIENTATION before = get(path, 0, 0), after;
    set = v_path_set_orientation(path, 0, 0, o);
    inserted = v_path_insert_orientation(path, 0, 0, o);
    after = get(path, 0, 0);
    if (set != status || inserted != status || orientations_of(path, 0) != 1
        || memcmp(before.target, after.target, sizeof after.target) != 0
        || before.roll != after.roll || before.zoom != after.zoom
        || before.hold != after.hold) {
        failures++;
        fprintf(stderr, "orientations.c:%d: %s, %s\n", line, v_strerror(set),
                v_strerror(inserted));
    }
}

#define WRONG(status, change) \
    do { \
        V_ORIENTATION o; \
        v_orientation_init(&o); \
        change; \
        refused(path, status, &o, __LINE__); \
    } while (0)

static void wrong_values(void)
{
    V_PATH *path = new_path();
    double position[3];
    OK(get_position(path, 0, position));
    WRONG(V_ERR_SIZE, o.size = 0);
    WRONG(V_ERR_SIZE, o.size = sizeof o - 1);
    WRONG(V_ERR_SIZE, o.size = sizeof o + 8);
    WRONG(V_ERR_SIZE, o.size = (size_t)0xa5a5a5a5);
    WRONG(V_ERR_ARGUMENT, o.target[1] = NAN);
    WRONG(V_ERR_ARGUMENT, o.target[2] = INFINITY);
    WRONG(V_ERR_RANGE, o.target[0] = 1e10);
    WRONG(V_ERR_ARGUMENT, o.target[2] = 0); /* no direction */
    WRONG(V_ERR_ARGUMENT, (o.absolute = 1, memcpy(o.target, position, sizeof position)));
    WRONG(V_ERR_ARGUMENT, o.roll = NAN);
    WRONG(V_ERR_ARGUMENT, o.roll = -INFINITY);
    WRONG(V_ERR_RANGE, o.zoom = 0.999);
    WRONG(V_ERR_RANGE, o.zoom = 2000.001);
    WRONG(V_ERR_RANGE, o.zoom = NAN);
    WRONG(V_ERR_RANGE, o.tension = 1.5);
    WRONG(V_ERR_RANGE, o.continuity = -1.5);
    WRONG(V_ERR_RANGE, o.bias = NAN);
    WRONG(V_ERR_RANGE, o.speed[0] = 0);
    WRONG(V_ERR_RANGE, o.speed[9] = 100.5);
    WRONG(V_ERR_RANGE, o.speed[5] = NAN);
    WRONG(V_ERR_RANGE, o.hold = -1);
    WRONG(V_ERR_RANGE, o.hold = 1000001);
    v_path_free(path);
}

static void wrong_places(void)
{
    V_PATH *path = new_path();
    V_ORIENTATION o;
    int count = 7;
    v_orientation_init(&o);
    o.zoom = 3;
    STATUS(V_ERR_RANGE, v_path_orientation_count(path, 2, &count));
    STATUS(V_ERR_RANGE, v_path_orientation_count(path, -1, &count));
    CHECK(count == 7);
    STATUS(V_ERR_RANGE, v_path_get_orientation(path, 0, 1, &o));
    STATUS(V_ERR_RANGE, v_path_get_orientation(path, 0, -1, &o));
    STATUS(V_ERR_RANGE, v_path_get_orientation(path, 2, 0, &o));
    CHECK(o.zoom == 3);
    STATUS(V_ERR_RANGE, v_path_set_orientation(path, 0, 1, &o));
    STATUS(V_ERR_RANGE, v_path_set_orientation(path, 2, 0, &o));
    STATUS(V_ERR_RANGE, v_path_insert_orientation(path, 0, 2, &o));
    STATUS(V_ERR_RANGE, v_path_insert_orientation(path, 0, -1, NULL));
    STATUS(V_ERR_RANGE, v_path_insert_orientation(path, -1, 0, NULL));
    STATUS(V_ERR_RANGE, v_path_remove_orientation(path, 0, 1));
    STATUS(V_ERR_RANGE, v_path_remove_orientation(path, 9, 0));
    STATUS(V_ERR_RANGE, v_path_set_absolute(path, 0, 1, 1));
    STATUS(V_ERR_RANGE, v_path_set_absolute(path, 2, 0, 1));
    o.size = 1;
    STATUS(V_ERR_SIZE, v_path_get_orientation(path, 0, 0, &o));
    CHECK(o.size == 1 && o.zoom == 3);
    v_path_free(path);
}

/* Absolute and relative: the view stays; an absolute target then stays put. */
static void absolute_and_relative(void)
{
    V_PATH *path = new_path();
    V_ORIENTATION o;
    double xyz[3] = {0, 0, 0};
    OK(v_path_set_absolute(path, 0, 0, 1));
    o = get(path, 0, 0);
    CHECK(o.absolute == 1);
    NEAR(o.target[0], -0.6, 1e-15);
    NEAR(o.target[1], 0.2, 1e-15);
    NEAR(o.target[2], 0.4, 1e-15);
    OK(set_position(path, 0, xyz));
    CHECK(memcmp(get(path, 0, 0).target, o.target, sizeof o.target) == 0);
    STATUS(V_ERR_ARGUMENT, set_position(path, 0, o.target));
    OK(v_path_set_absolute(path, 0, 0, 0));
    o = get(path, 0, 0);
    CHECK(o.absolute == 0);
    NEAR(o.target[0], -0.6, 1e-15);
    NEAR(o.target[2], 0.4, 1e-15);
    v_path_free(path);
}

int main(void)
{
    the_defaults();
    what_is_set_comes_back();
    wrong_values();
    wrong_places();
    absolute_and_relative();
    return failures != 0;
}
