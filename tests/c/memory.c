/*
 * Memory runs out while a path is asked, and while a list is built: at every
 * single allocation, of the library's own too, once and from then on. The answer
 * is V_ERR_MEMORY, the path or the old list is as it was, nothing is left behind,
 * and the next call succeeds.
 */
#include "allocations.h"
#include "check.h"

/* A path with everything: pans, tracked targets, rolls, zooms, holds. */
static V_PATH *rich_path(int points, double move_frames)
{
    V_PATH *path = new_path();
    V_ORIENTATION o;
    int i;
    v_orientation_init(&o);
    o.absolute = 1;
    OK(v_path_set_numbers(path, "base_speeds", NUMBERS(move_frames, 40, 40, 40)));
    for (i = 0; i < points; i++) {
        double xyz[3];
        xyz[0] = cos(i * 0.7);
        xyz[1] = sin(i * 1.3);
        xyz[2] = cos(i * 0.3);
        o.target[0] = 0.01 * (i / 3);
        o.roll = 10 * i;
        o.zoom = 20 + i % 50;
        o.hold = i % 4;
        OK(v_path_insert_point(path, 2 + i, xyz));
        if (i % 5 == 1) /* copied from the point before */
            OK(v_path_remove_orientation(path, 2 + i, 1));
        OK(v_path_set_orientation(path, 2 + i, 0, &o));
        o.absolute = !o.absolute;
        o.target[2] = -o.target[2];
        if (i % 5 == 0)
            OK(v_path_insert_orientation(path, 2 + i, 1, &o));
    }
    return path;
}

static long whole(const V_KAMERAPAR *first, int count)
{
    const V_KAMERAPAR *element = first;
    int i;
    for (i = 1; i <= count; i++) {
        if (element->number != i || element->next->prev != element)
            return 0;
        element = element->next;
    }
    return element == first && first->prev->number == count;
}

/* Allocation number n fails; is the list made nevertheless? */
static int try_with_failure(const V_PATH *original, long n, int forever, V_KAMERAPAR *head)
{
    V_PATH *path = NULL;
    V_KAMERAPAR before = *head;
    int status, count = head->number < 0 ? 0 : head->prev->number;
    long had;
    /* A copy, so that nothing of it has been computed yet. */
    OK(v_path_clone(original, &path));
    had = blocks;
    asked = 0;
    fail_forever = forever;
    fail_at = n;
    status = v_path_to_list(path, head);
    fail_at = -1;
    if (status == V_OK) {
        /* The list's elements, and what the path has computed. */
        CHECK(blocks >= had);
        v_path_free(path);
        return 1;
    }
    CHECK(status == V_ERR_MEMORY && v_last_error()[0] != '\0');
    CHECK(memcmp(&before, head, sizeof before) == 0);
    CHECK(count == 0 || whole(head, count));
    v_path_free(path);
    return 0;
}

static void at_every_allocation(const V_PATH *path, int with_old_list, int forever, long step)
{
    V_KAMERAPAR head;
    V_PATH *small;
    long n = 0, start, begin = blocks;
    small = rich_path(0, 10);
    memset(&head, 0xa5, sizeof head);
    head.number = -1;
    if (with_old_list)
        OK(v_path_to_list(small, &head));
    start = blocks;
    while (!try_with_failure(path, n, forever, &head)) {
        CHECK(blocks == start);
        if (blocks != start)
            fprintf(stderr, "memory.c: %ld blocks left by the failure of allocation %ld\n",
                    blocks - start, n);
        if (failures > 5)
            return;
        n += step;
    }
    printf("memory: %ld allocations failed in turn\n", n / step);
    CHECK(n > 0);
    v_free_liste(&head);
    CHECK(head.number == -1);
    v_path_free(small);
    CHECK(blocks == begin);
}

/* So many lists at once that the library must make room to remember them. */
static void with_many_heads(void)
{
    static V_KAMERAPAR heads[200];
    V_PATH *path = rich_path(0, 1);
    size_t frames;
    int i, longest = 0;
    OK(v_path_sample(path, NULL, 0, &frames)); /* all is computed now */
    for (i = 0; i < 200; i++) {
        long n = 0, had = blocks;
        int status;
        heads[i].number = -1;
        do {
            CHECK(blocks == had && heads[i].number == -1);
            asked = 0;
            fail_forever = 0;
            fail_at = n++;
            status = v_path_to_list(path, &heads[i]);
            fail_at = -1;
        } while (status == V_ERR_MEMORY);
        CHECK(status == V_OK && whole(&heads[i], (int)frames));
        longest = n > longest ? (int)n : longest;
    }
    /* At least once there was more to allocate than the elements. */
    CHECK(longest > (int)frames);
    for (i = 0; i < 200; i++)
        v_free_liste(&heads[i]);
    v_path_free(path);
}

/* What can be asked of a path. */
static int ask_length(V_PATH *path)
{
    double length;
    return v_path_length(path, &length);
}

static int ask_place(V_PATH *path)
{
    double xyz[3];
    return v_path_point_at_length(path, 3, 0.1, xyz);
}

static int ask_section(V_PATH *path) { return v_path_section_info(path, 2, NULL, NULL, NULL,
                       NULL); }

static int ask_pose(V_PATH *path)
{
    V_POSE pose;
    return v_path_pose(path, 2.5, &pose);
}

static int sample(V_PATH *path)
{
    static V_POSE poses[4000];
    size_t count;
    return v_path_sample(path, poses, 4000, &count);
}

static void each_call(const V_PATH *original, int forever)
{
    static const struct {
        int (*call)(V_PATH *path);
        const char *name;
    } calls[] = {
        { ask_length, "v_path_length" },
        { ask_place, "v_path_point_at_length" },
        { ask_section, "v_path_section_info" },
        { ask_pose, "v_path_pose" },
        { sample, "v_path_sample" },
    };
    size_t i;
    for (i = 0; i < sizeof calls / sizeof *calls; i++) {
        long n = 0, begin = blocks;
        int status;
        do {
            V_PATH *path = NULL;
            size_t frames;
            /* A copy, so that nothing of it has been computed yet. */
            OK(v_path_clone(original, &path));
            asked = 0;
            fail_forever = forever;
            fail_at = n++;
            status = calls[i].call(path);
            fail_at = -1;
            CHECK(status == V_OK || v_last_error()[0] != '\0');
            OK(v_path_frame_count(path, &frames));
            v_path_free(path);
            CHECK(blocks == begin);
        } while (status == V_ERR_MEMORY && failures < 20);
        CHECK(status == V_OK);
        if (failures || n == 1) {
            fprintf(stderr, "memory.c: after %ld failures of %s\n", n - 1, calls[i].name);
            failures++;
            return;
        }
    }
}

/* What is wrong in a call is answered where there is no memory: it takes none. */
static void what_is_wrong_is_told(V_PATH *path)
{
    double xyz[3] = { 0, 0, 0 };
    int count;
    V_ORIENTATION o;
    v_orientation_init(&o);
    asked = 0;
    fail_forever = 1;
    fail_at = 0;
    STATUS(V_ERR_RANGE, v_path_orientation_count(path, 99, &count));
    STATUS(V_ERR_RANGE, v_path_insert_point(path, 99, xyz));
    STATUS(V_ERR_RANGE, v_path_set_orientation(path, 1, 5, &o));
    STATUS(V_ERR_RANGE, v_path_get_orientation(path, 1, 5, &o));
    STATUS(V_ERR_RANGE, v_path_divide_segment(path, 99, 1));
    fail_at = -1;
    CHECK(asked == 0);
}

int main(void)
{
    V_PATH *path, *longer, *copies[2];
    int forever, old;
    setvbuf(stdout, NULL, _IONBF, 0);
    path = rich_path(30, 20);
    longer = rich_path(300, 300);
    /* What the library keeps for good (room for handles) it has from now on. */
    OK(v_path_clone(path, &copies[0]));
    OK(v_path_clone(path, &copies[1]));
    v_path_free(copies[0]);
    v_path_free(copies[1]);
    for (forever = 0; forever < 2; forever++) {
        for (old = 0; old < 2; old++) {
            at_every_allocation(path, old, forever, 1);
            at_every_allocation(longer, old, forever, 997);
        }
    }
    with_many_heads();
    each_call(path, 0);
    each_call(path, 1);
    what_is_wrong_is_told(path);
    v_path_free(path);
    v_path_free(longer);
    return failures != 0;
}
