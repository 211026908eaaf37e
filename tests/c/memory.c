/*
 * Memory runs out while a path is made, copied, changed or asked, and while a
 * list is built: at every single allocation, of the library's own too, once
 * and from then on. The answer is V_ERR_MEMORY, the path or the old list is as
 * it was, nothing is left behind, and the next call succeeds.
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
    OK(v_path_set_base_frames(path, move_frames, 40, 40, 40));
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

/* What can be done with a path; a call that needs no memory succeeds at once. */
static V_PATH *made; /* by new_one and copy */
static const double place[3] = { 0.1, 0.2, 0.3 };

static int new_one(V_PATH *path) { (void)path; return v_path_new(&made); }
static int copy(V_PATH *path) { return v_path_clone(path, &made); }
static int insert_first(V_PATH *path) { return v_path_insert_point(path, 0, place); }
static int insert_inside(V_PATH *path) { return v_path_insert_point(path, 3, place); }
static int divide(V_PATH *path) { return v_path_divide_segment(path, 2, 10); }
static int remove_one(V_PATH *path) { return v_path_remove_point(path, 2); }
static int move_one(V_PATH *path) { return v_path_set_position(path, 2, place); }
static int own_shape(V_PATH *path) { return v_path_set_tcb(path, 1, 0.1, 0.2, 0.3); }
static int use_preset(V_PATH *path) { return v_path_use_preset(path, 1, 7); }
static int set_preset(V_PATH *path) { return v_path_set_preset(path, 0, 0.1, 0.2, 0.3); }
static int copy_orientation(V_PATH *path) { return v_path_insert_orientation(path, 2, 1, NULL); }
static int remove_orientation(V_PATH *path) { return v_path_remove_orientation(path, 2, 1); }
static int switch_target(V_PATH *path) { return v_path_set_absolute(path, 1, 0, 1); }
static int set_base_frames(V_PATH *path) { return v_path_set_base_frames(path, 1, 2, 3, 4); }
static int set_closed(V_PATH *path) { return v_path_set_closed(path, 1); }
static int set_modes(V_PATH *path)
{
    return v_path_set_modes(path, V_ORIENTATION_SLERP, V_ZOOM_LINEAR);
}

static int with_orientation(V_PATH *path, int insert)
{
    V_ORIENTATION o;
    v_orientation_init(&o);
    o.target[1] = 0.5;
    return insert ? v_path_insert_orientation(path, 2, 1, &o)
                  : v_path_set_orientation(path, 2, 0, &o);
}

static int insert_orientation(V_PATH *path) { return with_orientation(path, 1); }
static int set_orientation(V_PATH *path) { return with_orientation(path, 0); }

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

static int ask_section(V_PATH *path) { return v_path_section_info(path, 2, NULL, NULL, NULL, NULL); }

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

/* Everything about a path that a call could have changed, and no byte of padding. */
struct state {
    size_t frames;
    double length;
    int points, orientations, closed, mode, zoom_mode, preset;
    double speeds[4], tcb[3], presets[3];
    int absolute, hold;
    double target[3], roll, zoom, turning[3], curve[10];
};

static void take_state(const V_PATH *path, struct state *state)
{
    int i, count;
    V_ORIENTATION o;
    memset(state, 0, sizeof *state);
    v_orientation_init(&o);
    OK(v_path_frame_count(path, &state->frames));
    OK(v_path_length(path, &state->length));
    OK(v_path_point_count(path, &state->points));
    for (i = 0; i < state->points; i++) {
        OK(v_path_orientation_count(path, i, &count));
        state->orientations += count;
    }
    OK(v_path_get_closed(path, &state->closed));
    OK(v_path_get_modes(path, &state->mode, &state->zoom_mode));
    OK(v_path_get_base_frames(path, &state->speeds[0], &state->speeds[1], &state->speeds[2],
                         &state->speeds[3]));
    OK(v_path_get_tcb(path, 1, state->tcb, &state->preset));
    OK(v_path_get_preset(path, 0, state->presets));
    OK(v_path_get_orientation(path, 2, 0, &o));
    state->absolute = o.absolute;
    state->hold = o.hold;
    memcpy(state->target, o.target, sizeof o.target);
    state->roll = o.roll;
    state->zoom = o.zoom;
    state->turning[0] = o.tension;
    state->turning[1] = o.continuity;
    state->turning[2] = o.bias;
    memcpy(state->curve, o.speed, sizeof o.speed);
}

static void each_call(const V_PATH *original, int forever)
{
    static const struct {
        int (*call)(V_PATH *path);
        const char *name;
        int needs_memory; /* as far as can be said from outside */
    } calls[] = {
        { new_one, "v_path_new", 1 },
        { copy, "v_path_clone", 1 },
        { insert_first, "v_path_insert_point at 0", 1 },
        { insert_inside, "v_path_insert_point", 1 },
        { divide, "v_path_divide_segment", 1 },
        { remove_one, "v_path_remove_point", 0 },
        { move_one, "v_path_set_position", 0 },
        { own_shape, "v_path_set_tcb", 0 },
        { use_preset, "v_path_use_preset", 0 },
        { set_preset, "v_path_set_preset", 0 },
        { insert_orientation, "v_path_insert_orientation", 1 },
        { copy_orientation, "v_path_insert_orientation, a copy", 1 },
        { remove_orientation, "v_path_remove_orientation", 0 },
        { set_orientation, "v_path_set_orientation", 0 },
        { switch_target, "v_path_set_absolute", 0 },
        { set_base_frames, "v_path_set_base_frames", 0 },
        { set_closed, "v_path_set_closed", 0 },
        { set_modes, "v_path_set_modes", 0 },
        { ask_length, "v_path_length", 1 },
        { ask_place, "v_path_point_at_length", 1 },
        { ask_section, "v_path_section_info", 1 },
        { ask_pose, "v_path_pose", 1 },
        { sample, "v_path_sample", 1 },
    };
    size_t i;
    for (i = 0; i < sizeof calls / sizeof *calls; i++) {
        int fresh; /* nothing of the path has been computed, or all has */
        for (fresh = 0; fresh < 2; fresh++) {
            long n = 0, begin = blocks;
            int status;
            do {
                struct state before, after;
                V_PATH *path = NULL;
                OK(v_path_clone(original, &path));
                OK(v_path_insert_orientation(path, 2, 1, NULL));
                take_state(path, &before);
                if (fresh) {
                    V_PATH *other = NULL;
                    OK(v_path_clone(path, &other));
                    v_path_free(path);
                    path = other;
                }
                made = path; /* untouched by a failure */
                asked = 0;
                fail_forever = forever;
                fail_at = n++;
                status = calls[i].call(path);
                fail_at = -1;
                if (status == V_ERR_MEMORY) {
                    CHECK(made == path && v_last_error()[0] != '\0');
                    take_state(path, &after);
                    CHECK(memcmp(&before, &after, sizeof before) == 0);
                } else if (made != path) {
                    OK(v_path_length(made, &before.length));
                    v_path_free(made);
                }
                v_path_free(path);
                CHECK(blocks == begin);
            } while (status == V_ERR_MEMORY && failures < 20);
            CHECK(status == V_OK);
            if (failures || (n == 1 && calls[i].needs_memory && fresh)) {
                fprintf(stderr, "memory.c: after %ld failures of %s\n", n - 1, calls[i].name);
                failures++;
                return;
            }
        }
    }
}

/* What is wrong in a call is answered where there is no memory: it takes none. */
static void what_is_wrong_is_told(V_PATH *path)
{
    double xyz[3] = { 0, 0, 0 };
    V_ORIENTATION o;
    v_orientation_init(&o);
    asked = 0;
    fail_forever = 1;
    fail_at = 0;
    STATUS(V_ERR_RANGE, v_path_get_position(path, 99, xyz));
    STATUS(V_ERR_RANGE, v_path_insert_point(path, 99, xyz));
    STATUS(V_ERR_RANGE, v_path_set_orientation(path, 1, 5, &o));
    STATUS(V_ERR_RANGE, v_path_get_orientation(path, 1, 5, &o));
    STATUS(V_ERR_RANGE, v_path_divide_segment(path, 99, 1));
    fail_at = -1;
    CHECK(asked == 0);
}

/* So many paths at once that the library must make room for their handles. */
static void with_many_paths(void)
{
    static V_PATH *paths[300];
    int i, refusals = 0, least = 1000;
    for (i = 0; i < 300; i++) {
        long n = 0, had = blocks;
        int status;
        do {
            CHECK(blocks == had && paths[i] == NULL);
            asked = 0;
            fail_forever = 1;
            fail_at = n++;
            status = v_path_new(&paths[i]);
            fail_at = -1;
        } while (status == V_ERR_MEMORY);
        CHECK(status == V_OK);
        refusals = n > refusals ? (int)n : refusals;
        least = n < least ? (int)n : least;
    }
    /* At least once there was more to allocate than a path. */
    CHECK(refusals > least);
    for (i = 0; i < 300; i++)
        v_path_free(paths[i]);
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
    with_many_paths();
    v_path_free(path);
    v_path_free(longer);
    return failures != 0;
}
