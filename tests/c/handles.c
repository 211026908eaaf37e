/*
 * Every function that takes a handle, with handles that are none: a status,
 * no crash, and no result touched. Likewise NULL, for the handle and for each
 * result that must not be.
 */
#include "check.h"

/*
 * Handles that are none, for a parameter that takes one. A real address is
 * never a handle: the library gives out odd numbers only.
 */
#define BAD_HANDLES 6
static void bad_handles(V_PATH *bad[BAD_HANDLES])
{
    static double somewhere[4];
    V_PATH *path = new_path();
    v_path_free(path);
    bad[0] = path;                     /* freed */
    bad[1] = (V_PATH *)(void *)somewhere; /* an address */
    bad[2] = (V_PATH *)(size_t)1;
    bad[3] = (V_PATH *)~(size_t)0;
    bad[4] = (V_PATH *)((size_t)path ^ 2); /* of another kind */
    bad[5] = (V_PATH *)((size_t)path + ((size_t)1 << 20)); /* never given out */
}

/* Results filled with a pattern that must still be there afterwards. */
static union {
    unsigned char bytes[4096];
    int number;
    size_t size;
    double numbers[100];
    V_POSE pose;
    V_ORIENTATION orientation;
    V_PATH *path;
    V_KAMERAPAR element;
} out[4];

static void fill(void)
{
    memset(out, 0x5a, sizeof out);
}

static void untouched(int line)
{
    size_t i;
    const unsigned char *bytes = (const unsigned char *)out;
    for (i = 0; i < sizeof out; i++) {
        if (bytes[i] != 0x5a) {
            failures++;
            fprintf(stderr, "handles.c:%d: a result was touched\n", line);
            return;
        }
    }
}

#define REFUSED(status, call) \
    do { \
        fill(); \
        STATUS(status, call); \
        untouched(__LINE__); \
    } while (0)

static const double xyz[3] = {0.1, 0.2, 0.3};

static void every_function(V_PATH *bad, int status)
{
    V_ORIENTATION o;
    V_ORIENTATION result;
    v_orientation_init(&o);
    v_orientation_init(&result);
    result.zoom = 77;

    REFUSED(status, v_path_clone(bad, &out[0].path));
    REFUSED(status, v_path_save(bad, "/nonexistent/never.vid"));
    REFUSED(status, v_path_point_count(bad, &out[0].number));
    REFUSED(status, v_path_insert_point(bad, 0, xyz));
    REFUSED(status, v_path_divide_segment(bad, 0, 1));
    REFUSED(status, v_path_remove_point(bad, 0));
    REFUSED(status, set_position(bad, 0, xyz));
    REFUSED(status, get_position(bad, 0, out[0].numbers));
    REFUSED(status, v_path_orientation_count(bad, 0, &out[0].number));
    REFUSED(status, v_path_insert_orientation(bad, 0, 0, &o));
    REFUSED(status, v_path_insert_orientation(bad, 0, 0, NULL));
    REFUSED(status, v_path_remove_orientation(bad, 0, 0));
    REFUSED(status, v_path_set_orientation(bad, 0, 0, &o));
    REFUSED(status, v_path_get_orientation(bad, 0, 0, &result));
    CHECK(result.zoom == 77);
    REFUSED(status, v_path_set_absolute(bad, 0, 0, 1));
    REFUSED(status, v_path_set_number(bad, "fps", 1));
    REFUSED(status, v_path_get_number(bad, "fps", out[0].numbers));
    REFUSED(status, v_path_set_numbers(bad, "base_speeds", NUMBERS(1, 1, 1, 1)));
    REFUSED(status, v_path_get_numbers(bad, "base_speeds", out[0].numbers, 4, &out[1].size));
    REFUSED(status, v_path_set_text(bad, "title", ""));
    REFUSED(status, v_path_get_text(bad, "title", (char *)out[0].bytes, 9, &out[1].size));
    REFUSED(status, v_path_set_flag(bad, "closed", 1));
    REFUSED(status, v_path_get_flag(bad, "closed", &out[0].number));
    REFUSED(status, v_path_length(bad, out[0].numbers));
    REFUSED(status, v_path_segment_length(bad, 0, out[0].numbers));
    REFUSED(status, v_path_curve_point(bad, 0, 0.5, out[0].numbers));
    REFUSED(status, v_path_point_at_length(bad, 0, 0.1, out[0].numbers));
    REFUSED(status, v_path_section_count(bad, &out[0].number));
    REFUSED(status, v_path_section_info(bad, 0, &out[0].number, &out[1].number,
                                        &out[2].size, &out[3].size));
    REFUSED(status, v_path_frame_count(bad, &out[0].size));
    REFUSED(status, v_path_sample(bad, &out[0].pose, 20, &out[3].size));
    REFUSED(status, v_path_sample(bad, NULL, 0, &out[3].size));
    REFUSED(status, v_path_pose(bad, 1, &out[0].pose));
    REFUSED(status, v_path_to_list(bad, &out[0].element));
    REFUSED(status, v_path_write_ascii(bad, "/nonexistent/never.txt"));
    fill();
    v_path_free(bad);
    untouched(__LINE__);
    CHECK((v_last_error()[0] != '\0') == (bad != NULL));
}

/* NULL for every pointer in turn that must not be NULL. */
static void every_null(V_PATH *path)
{
    V_PATH *copy = NULL;
    REFUSED(V_ERR_NULL, v_path_new(NULL));
    REFUSED(V_ERR_NULL, v_path_clone(path, NULL));
    REFUSED(V_ERR_NULL, v_path_load(NULL, &out[0].path));
    REFUSED(V_ERR_NULL, v_path_load("/nonexistent/never.vid", NULL));
    REFUSED(V_ERR_NULL, v_path_save(path, NULL));
    REFUSED(V_ERR_NULL, v_path_point_count(path, NULL));
    REFUSED(V_ERR_NULL, v_path_insert_point(path, 0, NULL));
    REFUSED(V_ERR_NULL, set_position(path, 0, NULL));
    REFUSED(V_ERR_NULL, get_position(path, 0, NULL));
    REFUSED(V_ERR_NULL, v_path_orientation_count(path, 0, NULL));
    REFUSED(V_ERR_NULL, v_path_set_orientation(path, 0, 0, NULL));
    REFUSED(V_ERR_NULL, v_path_get_orientation(path, 0, 0, NULL));
    REFUSED(V_ERR_NULL, v_path_get_number(path, "fps", NULL));
    REFUSED(V_ERR_NULL, v_path_get_number(path, NULL, out[0].numbers));
    REFUSED(V_ERR_NULL, v_path_get_numbers(path, "base_speeds", NULL, 4, &out[1].size));
    REFUSED(V_ERR_NULL, v_path_get_numbers(path, "base_speeds", out[0].numbers, 4, NULL));
    REFUSED(V_ERR_NULL, v_path_get_text(path, "title", NULL, 4, &out[1].size));
    REFUSED(V_ERR_NULL, v_path_get_flag(path, "closed", NULL));
    REFUSED(V_ERR_NULL, v_path_length(path, NULL));
    REFUSED(V_ERR_NULL, v_path_segment_length(path, 0, NULL));
    REFUSED(V_ERR_NULL, v_path_curve_point(path, 0, 0.5, NULL));
    REFUSED(V_ERR_NULL, v_path_point_at_length(path, 0, 0.1, NULL));
    REFUSED(V_ERR_NULL, v_path_section_count(path, NULL));
    REFUSED(V_ERR_NULL, v_path_frame_count(path, NULL));
    REFUSED(V_ERR_NULL, v_path_sample(path, &out[0].pose, 20, NULL));
    REFUSED(V_ERR_NULL, v_path_sample(path, NULL, 0, NULL));
    REFUSED(V_ERR_NULL, v_path_sample(path, NULL, 20, &out[0].size));
    REFUSED(V_ERR_NULL, v_path_pose(path, 1, NULL));
    REFUSED(V_ERR_NULL, v_path_to_list(path, NULL));
    REFUSED(V_ERR_NULL, v_path_write_ascii(path, NULL));
    /* Results of which one may be wanted without the others. */
    OK(v_path_section_info(path, 0, NULL, NULL, NULL, NULL));
    /* An address that no such object can have. */
    REFUSED(V_ERR_ARGUMENT,
            v_path_length(path, (double *)(void *)(out[0].bytes + 1)));
    OK(v_path_clone(path, &copy));
    v_path_free(copy);
}

/* Handles keep their objects apart, however they come and go. */
static void coming_and_going(void)
{
    V_PATH *paths[50];
    int i, round;
    for (i = 0; i < 50; i++)
        paths[i] = new_path();
    for (round = 0; round < 2000; round++) {
        V_PATH *old;
        double is[3], at[3] = {0, 0, 0};
        i = round * 7 % 50;
        old = paths[i];
        v_path_free(old);
        paths[i] = new_path();
        CHECK(paths[i] != old);
        CHECK(((size_t)paths[i] & 1) == 1);
        at[0] = round * 1e-4;
        OK(set_position(paths[i], 1, at));
        STATUS(V_ERR_HANDLE, get_position(old, 1, is));
        OK(get_position(paths[i], 1, is));
        CHECK(is[0] == at[0]);
    }
    for (i = 0; i < 50; i++)
        v_path_free(paths[i]);
}

int main(void)
{
    V_PATH *bad[BAD_HANDLES], *path = new_path();
    int i;
    bad_handles(bad);
    for (i = 0; i < BAD_HANDLES; i++)
        every_function(bad[i], V_ERR_HANDLE);
    every_function(NULL, V_ERR_NULL);
    every_null(path);
    v_path_free(path);
    coming_and_going();
    return failures != 0;
}
