/*
 * Support points, their shape, and what holds for the whole path: what is set
 * comes back, what is wrong is refused and changes nothing.
 */
#include "check.h"

static const double a_nan = NAN, infinity = INFINITY;

static int points_of(const V_PATH *path)
{
    int count = -1;
    OK(v_path_point_count(path, &count));
    return count;
}

static void position_is(const V_PATH *path, int at, double x, double y, double z)
{
    double is[3];
    OK(v_path_get_position(path, at, is));
    CHECK(is[0] == x && is[1] == y && is[2] == z);
}

static void a_new_path(void)
{
    V_PATH *path = new_path();
    static const double presets[10][3] = { /* thesis A.6.1 */
        {0, 0, 0}, {0.3, 0, 0}, {0.6, 0, 0}, {-0.3, 0, 0}, {-0.6, 0, 0},
        {0, -0.5, 0}, {0, 0.5, 0}, {0, 0, 0.5}, {0, 0, -0.5}, {0, 0, 0},
    };
    double tcb[3], speeds[4];
    int i, preset = -7, closed = -7, mode = -7, zoom = -7;
    CHECK(points_of(path) == 2);
    position_is(path, 0, -0.6, 0.2, 0.8);
    position_is(path, 1, 0.6, 0.2, 0.8);
    for (i = 0; i < 10; i++) {
        OK(v_path_get_preset(path, i, tcb));
        CHECK(memcmp(tcb, presets[i], sizeof tcb) == 0);
    }
    OK(v_path_get_tcb(path, 1, tcb, &preset));
    CHECK(preset == 0 && tcb[0] == 0 && tcb[1] == 0 && tcb[2] == 0);
    OK(v_path_get_base_frames(path, &speeds[0], &speeds[1], &speeds[2], &speeds[3]));
    CHECK(speeds[0] == 100 && speeds[1] == 100 && speeds[2] == 100 && speeds[3] == 100);
    OK(v_path_get_closed(path, &closed));
    CHECK(closed == 0);
    OK(v_path_get_modes(path, &mode, &zoom));
    CHECK(mode == V_ORIENTATION_TCB && zoom == V_ZOOM_SMOOTH);
    v_path_free(path);
}

static void inserting_and_removing(void)
{
    V_PATH *path = new_path();
    double xyz[3] = {0, 0.5, 0};
    int preset, i;
    double tcb[3];

    OK(v_path_use_preset(path, 0, 3));
    OK(v_path_set_tcb(path, 1, 0.1, 0.2, 0.3));
    OK(v_path_insert_point(path, 1, xyz)); /* from its predecessor */
    CHECK(points_of(path) == 3);
    position_is(path, 1, 0, 0.5, 0);
    OK(v_path_get_tcb(path, 1, tcb, &preset));
    CHECK(preset == 3 && tcb[0] == -0.3);
    xyz[0] = -0.9;
    OK(v_path_insert_point(path, 0, xyz)); /* from its successor */
    OK(v_path_get_tcb(path, 0, NULL, &preset));
    CHECK(preset == 3);
    xyz[0] = 0.9;
    OK(v_path_insert_point(path, 4, xyz)); /* at the end */
    OK(v_path_get_tcb(path, 4, tcb, &preset));
    CHECK(preset == -1 && tcb[0] == 0.1 && tcb[1] == 0.2 && tcb[2] == 0.3);
    position_is(path, 4, 0.9, 0.5, 0);

    STATUS(V_ERR_RANGE, v_path_insert_point(path, 6, xyz));
    STATUS(V_ERR_RANGE, v_path_insert_point(path, -1, xyz));
    STATUS(V_ERR_RANGE, v_path_remove_point(path, 5));
    STATUS(V_ERR_RANGE, v_path_remove_point(path, -1));
    for (i = 0; i < 3; i++) {
        double bad[3] = {0, 0, 0};
        bad[i] = a_nan;
        STATUS(V_ERR_ARGUMENT, v_path_insert_point(path, 0, bad));
        STATUS(V_ERR_ARGUMENT, v_path_set_position(path, 0, bad));
        bad[i] = -infinity;
        STATUS(V_ERR_ARGUMENT, v_path_set_position(path, 0, bad));
        bad[i] = 1.1e9;
        STATUS(V_ERR_RANGE, v_path_set_position(path, 0, bad));
        bad[i] = -1e9;
        OK(v_path_set_position(path, 4, bad));
    }
    STATUS(V_ERR_RANGE, v_path_set_position(path, 5, xyz));
    STATUS(V_ERR_RANGE, v_path_get_position(path, 5, xyz));
    STATUS(V_ERR_RANGE, v_path_get_position(path, -2147483647 - 1, xyz));
    position_is(path, 0, -0.9, 0.5, 0);
    CHECK(points_of(path) == 5);

    for (i = 5; i > 2; i--)
        OK(v_path_remove_point(path, 1));
    STATUS(V_ERR_RANGE, v_path_remove_point(path, 0)); /* two remain */
    CHECK(points_of(path) == 2);
    v_path_free(path);
}

static void dividing(void)
{
    V_PATH *path = new_path();
    double is[3];
    int i;
    OK(v_path_divide_segment(path, 0, 5));
    CHECK(points_of(path) == 7);
    for (i = 0; i < 7; i++) { /* a straight line: equal distances */
        OK(v_path_get_position(path, i, is));
        NEAR(is[0], -0.6 + 0.2 * i, 1e-12);
        NEAR(is[1], 0.2, 1e-12);
    }
    STATUS(V_ERR_RANGE, v_path_divide_segment(path, 6, 1));
    STATUS(V_ERR_RANGE, v_path_divide_segment(path, -1, 1));
    STATUS(V_ERR_RANGE, v_path_divide_segment(path, 0, 0));
    STATUS(V_ERR_RANGE, v_path_divide_segment(path, 0, 11));
    STATUS(V_ERR_RANGE, v_path_divide_segment(path, 0, -1));
    CHECK(points_of(path) == 7);
    OK(v_path_set_closed(path, 1));
    OK(v_path_divide_segment(path, 6, 1)); /* the segment that closes it */
    CHECK(points_of(path) == 8);
    v_path_free(path);
}

static void shape(void)
{
    V_PATH *path = new_path();
    double tcb[3];
    int preset, i;
    OK(v_path_set_preset(path, 9, -1, 1, 0.25));
    OK(v_path_get_preset(path, 9, tcb));
    CHECK(tcb[0] == -1 && tcb[1] == 1 && tcb[2] == 0.25);
    OK(v_path_use_preset(path, 0, 9));
    OK(v_path_set_preset(path, 9, 0, 0, 0.5)); /* the point follows */
    OK(v_path_get_tcb(path, 0, tcb, &preset));
    CHECK(preset == 9 && tcb[0] == 0 && tcb[2] == 0.5);
    for (i = 0; i < 3; i++) {
        static const double bad[4] = {1.0000001, -1.0000001, NAN, INFINITY};
        int k;
        for (k = 0; k < 4; k++) {
            double v[3] = {0, 0, 0};
            v[i] = bad[k];
            STATUS(V_ERR_RANGE, v_path_set_tcb(path, 0, v[0], v[1], v[2]));
            STATUS(V_ERR_RANGE, v_path_set_preset(path, 9, v[0], v[1], v[2]));
        }
    }
    STATUS(V_ERR_RANGE, v_path_set_tcb(path, 2, 0, 0, 0));
    STATUS(V_ERR_RANGE, v_path_use_preset(path, 0, 10));
    STATUS(V_ERR_RANGE, v_path_use_preset(path, 0, -1));
    STATUS(V_ERR_RANGE, v_path_use_preset(path, 2, 0));
    STATUS(V_ERR_RANGE, v_path_set_preset(path, 10, 0, 0, 0));
    STATUS(V_ERR_RANGE, v_path_get_preset(path, 10, tcb));
    STATUS(V_ERR_RANGE, v_path_get_preset(path, -1, tcb));
    STATUS(V_ERR_RANGE, v_path_get_tcb(path, 2, tcb, &preset));
    OK(v_path_get_tcb(path, 0, tcb, &preset));
    CHECK(preset == 9 && tcb[0] == 0 && tcb[2] == 0.5);
    v_path_free(path);
}

static void the_whole_path(void)
{
    V_PATH *path = new_path();
    double v[4];
    int i, closed, mode, zoom;
    OK(v_path_set_base_frames(path, 1, 2, 3, 4e-300));
    for (i = 0; i < 4; i++) {
        static const double bad[4] = {0, -1, NAN, INFINITY};
        int k;
        for (k = 0; k < 4; k++) {
            double s[4] = {1, 1, 1, 1};
            s[i] = bad[k];
            STATUS(V_ERR_ARGUMENT, v_path_set_base_frames(path, s[0], s[1], s[2], s[3]));
        }
    }
    OK(v_path_get_base_frames(path, &v[0], &v[1], &v[2], &v[3]));
    CHECK(v[0] == 1 && v[1] == 2 && v[2] == 3 && v[3] == 4e-300);

    OK(v_path_set_closed(path, -5));
    OK(v_path_get_closed(path, &closed));
    CHECK(closed == 1);
    OK(v_path_set_closed(path, 0));
    OK(v_path_get_closed(path, &closed));
    CHECK(closed == 0);

    OK(v_path_set_modes(path, V_ORIENTATION_BARRY_GOLDMAN, V_ZOOM_LINEAR));
    STATUS(V_ERR_RANGE, v_path_set_modes(path, 3, V_ZOOM_SMOOTH));
    STATUS(V_ERR_RANGE, v_path_set_modes(path, -1, V_ZOOM_SMOOTH));
    STATUS(V_ERR_RANGE, v_path_set_modes(path, V_ORIENTATION_TCB, 2));
    STATUS(V_ERR_RANGE, v_path_set_modes(path, V_ORIENTATION_TCB, -1));
    OK(v_path_get_modes(path, &mode, &zoom));
    CHECK(mode == V_ORIENTATION_BARRY_GOLDMAN && zoom == V_ZOOM_LINEAR);
    OK(v_path_set_modes(path, V_ORIENTATION_SLERP, V_ZOOM_SMOOTH));
    OK(v_path_get_modes(path, &mode, NULL));
    CHECK(mode == V_ORIENTATION_SLERP);
    v_path_free(path);
}

static void a_copy_is_independent(void)
{
    V_PATH *path = new_path(), *copy = NULL;
    double xyz[3] = {0, 0, 0};
    OK(v_path_set_closed(path, 1));
    OK(v_path_clone(path, &copy));
    OK(v_path_set_position(path, 0, xyz));
    OK(v_path_insert_point(path, 2, xyz));
    CHECK(points_of(copy) == 2);
    position_is(copy, 0, -0.6, 0.2, 0.8);
    v_path_free(path);
    CHECK(points_of(copy) == 2);
    v_path_free(copy);
}

int main(void)
{
    a_new_path();
    inserting_and_removing();
    dividing();
    shape();
    the_whole_path();
    a_copy_is_independent();
    return failures != 0;
}
