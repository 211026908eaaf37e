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
    OK(get_position(path, at, is));
    CHECK(is[0] == x && is[1] == y && is[2] == z);
}

static void a_new_path(void)
{
    V_PATH *path = new_path();
    static const double presets[10][3] = { /* thesis A.6.1 */
        {0, 0, 0}, {0.3, 0, 0}, {0.6, 0, 0}, {-0.3, 0, 0}, {-0.6, 0, 0},
        {0, -0.5, 0}, {0, 0.5, 0}, {0, 0, 0.5}, {0, 0, -0.5}, {0, 0, 0},
    };
    double numbers[30], preset = -7;
    char text[20];
    size_t count = 0;
    int closed = -7;
    CHECK(points_of(path) == 2);
    position_is(path, 0, -0.6, 0.2, 0.8);
    position_is(path, 1, 0.6, 0.2, 0.8);
    OK(v_path_get_numbers(path, "presets", numbers, 30, &count));
    CHECK(count == 30 && memcmp(numbers, presets, sizeof presets) == 0);
    OK(v_path_get_number(path, "point.2.preset", &preset));
    CHECK(preset == 0);
    OK(v_path_get_numbers(path, "base_speeds", numbers, 4, &count));
    CHECK(numbers[0] == 100 && numbers[1] == 100 && numbers[2] == 100 && numbers[3] == 100);
    OK(v_path_get_flag(path, "closed", &closed));
    CHECK(closed == 0);
    OK(v_path_get_text(path, "orientation_mode", text, sizeof text, &count));
    CHECK(strcmp(text, "tcb") == 0);
    OK(v_path_get_text(path, "zoom_mode", text, sizeof text, &count));
    CHECK(strcmp(text, "smooth") == 0);
    v_path_free(path);
}

static void inserting_and_removing(void)
{
    V_PATH *path = new_path();
    double xyz[3] = {0, 0.5, 0}, tcb[3], preset;
    size_t count;
    int i;

    OK(v_path_set_number(path, v_path_key(0, -1, "preset"), 3));
    OK(v_path_set_numbers(path, v_path_key(1, -1, "own"), NUMBERS(0.1, 0.2, 0.3)));
    OK(v_path_insert_point(path, 1, xyz)); /* from its predecessor */
    CHECK(points_of(path) == 3);
    position_is(path, 1, 0, 0.5, 0);
    OK(v_path_get_number(path, "point.2.preset", &preset));
    CHECK(preset == 3);
    xyz[0] = -0.9;
    OK(v_path_insert_point(path, 0, xyz)); /* from its successor */
    OK(v_path_get_number(path, "point.1.preset", &preset));
    CHECK(preset == 3);
    xyz[0] = 0.9;
    OK(v_path_insert_point(path, 4, xyz)); /* at the end */
    OK(v_path_get_number(path, "point.5.preset", &preset));
    OK(v_path_get_numbers(path, "point.5.own", tcb, 3, &count));
    CHECK(isnan(preset) && tcb[0] == 0.1 && tcb[1] == 0.2 && tcb[2] == 0.3);
    position_is(path, 4, 0.9, 0.5, 0);

    STATUS(V_ERR_RANGE, v_path_insert_point(path, 6, xyz));
    STATUS(V_ERR_RANGE, v_path_insert_point(path, -1, xyz));
    STATUS(V_ERR_RANGE, v_path_remove_point(path, 5));
    STATUS(V_ERR_RANGE, v_path_remove_point(path, -1));
    for (i = 0; i < 3; i++) {
        double bad[3] = {0, 0, 0};
        bad[i] = a_nan;
        STATUS(V_ERR_ARGUMENT, v_path_insert_point(path, 0, bad));
        STATUS(V_ERR_ARGUMENT, set_position(path, 0, bad));
        bad[i] = -infinity;
        STATUS(V_ERR_ARGUMENT, set_position(path, 0, bad));
        bad[i] = 1.1e9;
        STATUS(V_ERR_RANGE, set_position(path, 0, bad));
        bad[i] = -1e9;
        OK(set_position(path, 4, bad));
    }
    STATUS(V_ERR_RANGE, set_position(path, 5, xyz));
    STATUS(V_ERR_RANGE, get_position(path, 5, xyz));
    STATUS(V_ERR_RANGE, get_position(path, -2147483647 - 1, xyz));
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
        OK(get_position(path, i, is));
        NEAR(is[0], -0.6 + 0.2 * i, 1e-12);
        NEAR(is[1], 0.2, 1e-12);
    }
    STATUS(V_ERR_RANGE, v_path_divide_segment(path, 6, 1));
    STATUS(V_ERR_RANGE, v_path_divide_segment(path, -1, 1));
    STATUS(V_ERR_RANGE, v_path_divide_segment(path, 0, 0));
    STATUS(V_ERR_RANGE, v_path_divide_segment(path, 0, 11));
    STATUS(V_ERR_RANGE, v_path_divide_segment(path, 0, -1));
    CHECK(points_of(path) == 7);
    OK(v_path_set_flag(path, "closed", 1));
    OK(v_path_divide_segment(path, 6, 1)); /* the segment that closes it */
    CHECK(points_of(path) == 8);
    v_path_free(path);
}

static void shape(void)
{
    V_PATH *path = new_path();
    double tcb[3], preset;
    size_t count;
    int i;
    OK(v_path_set_numbers(path, "presets.9", NUMBERS(-1, 1, 0.25)));
    OK(v_path_get_numbers(path, "presets.9", tcb, 3, &count));
    CHECK(tcb[0] == -1 && tcb[1] == 1 && tcb[2] == 0.25);
    OK(v_path_set_number(path, v_path_key(0, -1, "preset"), 9));
    OK(v_path_set_numbers(path, "presets.9", NUMBERS(0, 0, 0.5))); /* the point follows */
    OK(v_path_get_number(path, "point.1.preset", &preset));
    OK(v_path_get_numbers(path, "presets.9", tcb, 3, &count));
    CHECK(preset == 9 && tcb[0] == 0 && tcb[2] == 0.5);
    for (i = 0; i < 3; i++) {
        static const double bad[4] = {1.0000001, -1.0000001, NAN, INFINITY};
        int k;
        for (k = 0; k < 4; k++) {
            double v[3] = {0, 0, 0};
            v[i] = bad[k];
            STATUS(V_ERR_RANGE, v_path_set_numbers(path, v_path_key(0, -1, "own"), NUMBERS(v[0],
                   v[1], v[2])));
            STATUS(V_ERR_RANGE, v_path_set_numbers(path, "presets.9", NUMBERS(v[0], v[1], v[2])));
        }
    }
    STATUS(V_ERR_RANGE, v_path_set_numbers(path, v_path_key(2, -1, "own"), NUMBERS(0, 0, 0)));
    STATUS(V_ERR_RANGE, v_path_set_number(path, v_path_key(0, -1, "preset"), 10));
    STATUS(V_ERR_RANGE, v_path_set_number(path, v_path_key(0, -1, "preset"), -1));
    STATUS(V_ERR_RANGE, v_path_set_number(path, v_path_key(2, -1, "preset"), 0));
    STATUS(V_ERR_RANGE, v_path_set_numbers(path, "presets.10", NUMBERS(0, 0, 0)));
    STATUS(V_ERR_RANGE, v_path_get_numbers(path, "presets.10", tcb, 3, &count));
    STATUS(V_ERR_RANGE, v_path_get_number(path, "point.3.preset", &preset));
    OK(v_path_get_number(path, "point.1.preset", &preset));
    OK(v_path_get_numbers(path, "presets.9", tcb, 3, &count));
    CHECK(preset == 9 && tcb[0] == 0 && tcb[2] == 0.5);
    v_path_free(path);
}

static void the_whole_path(void)
{
    V_PATH *path = new_path();
    double v[4];
    char text[20];
    size_t count;
    int i, closed;
    OK(v_path_set_numbers(path, "base_speeds", NUMBERS(1, 2, 3, 4e-300)));
    for (i = 0; i < 4; i++) {
        static const double bad[4] = {0, -1, NAN, INFINITY};
        int k;
        for (k = 0; k < 4; k++) {
            double s[4] = {1, 1, 1, 1};
            s[i] = bad[k];
            STATUS(V_ERR_ARGUMENT, v_path_set_numbers(path, "base_speeds", NUMBERS(s[0], s[1],
                   s[2], s[3])));
        }
    }
    OK(v_path_get_numbers(path, "base_speeds", v, 4, &count));
    CHECK(v[0] == 1 && v[1] == 2 && v[2] == 3 && v[3] == 4e-300);

    OK(v_path_set_flag(path, "closed", -5));
    OK(v_path_get_flag(path, "closed", &closed));
    CHECK(closed == 1);
    OK(v_path_set_flag(path, "closed", 0));
    OK(v_path_get_flag(path, "closed", &closed));
    CHECK(closed == 0);

    OK(v_path_set_text(path, "orientation_mode", "barry-goldman"));
    OK(v_path_set_text(path, "zoom_mode", "linear"));
    STATUS(V_ERR_ARGUMENT, v_path_set_text(path, "orientation_mode", "linear"));
    STATUS(V_ERR_ARGUMENT, v_path_set_text(path, "zoom_mode", "tcb"));
    OK(v_path_get_text(path, "orientation_mode", text, sizeof text, &count));
    CHECK(strcmp(text, "barry-goldman") == 0);
    OK(v_path_get_text(path, "zoom_mode", text, sizeof text, &count));
    CHECK(strcmp(text, "linear") == 0);
    OK(v_path_set_text(path, "orientation_mode", ""));
    OK(v_path_get_text(path, "orientation_mode", text, sizeof text, &count));
    CHECK(strcmp(text, "tcb") == 0);
    v_path_free(path);
}

static void a_copy_is_independent(void)
{
    V_PATH *path = new_path(), *copy = NULL;
    double xyz[3] = {0, 0, 0};
    OK(v_path_set_flag(path, "closed", 1));
    OK(v_path_clone(path, &copy));
    OK(set_position(path, 0, xyz));
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
