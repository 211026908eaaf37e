/*
 * Memory runs out while a list is built: at every single allocation, of the
 * library's own too, once and from then on. The answer is V_ERR_MEMORY, the
 * old list is whole, nothing is left behind, and the next call succeeds.
 *
 * This program's malloc and its kin stand in for the C library's.
 */
#include <errno.h>

#include "check.h"

extern void *__libc_malloc(size_t size);
extern void *__libc_calloc(size_t count, size_t size);
extern void *__libc_realloc(void *old, size_t size);
extern void *__libc_memalign(size_t alignment, size_t size);
extern void __libc_free(void *old);

static long blocks;          /* allocated and not freed */
static long asked;           /* allocations since the countdown was set */
static long fail_at = -1;    /* the allocation that fails, counted from 0 */
static int fail_forever;     /* and all that follow */

static int refused(void)
{
    long number = asked++;
    if (fail_at < 0 || number < fail_at || (number > fail_at && !fail_forever))
        return 0;
    errno = ENOMEM;
    return 1;
}

static void *counted(void *made)
{
    blocks += made != NULL;
    return made;
}

void *malloc(size_t size)
{
    return refused() ? NULL : counted(__libc_malloc(size));
}

void *calloc(size_t count, size_t size)
{
    return refused() ? NULL : counted(__libc_calloc(count, size));
}

void *realloc(void *old, size_t size)
{
    void *made;
    if (refused())
        return NULL;
    made = __libc_realloc(old, size);
    if (old == NULL)
        counted(made);
    return made;
}

void *memalign(size_t alignment, size_t size)
{
    return refused() ? NULL : counted(__libc_memalign(alignment, size));
}

void *aligned_alloc(size_t alignment, size_t size)
{
    return memalign(alignment, size);
}

int posix_memalign(void **made, size_t alignment, size_t size)
{
    void *block = memalign(alignment, size);
    if (block == NULL)
        return ENOMEM;
    *made = block;
    return 0;
}

void free(void *old)
{
    blocks -= old != NULL;
    __libc_free(old);
}

/* A path with everything: pans, tracked targets, rolls, zooms, holds. */
static V_PATH *rich_path(int points, double move_speed)
{
    V_PATH *path = new_path();
    V_ORIENTATION o;
    int i;
    v_orientation_init(&o);
    o.absolute = 1;
    OK(v_path_set_speeds(path, move_speed, 40, 40, 40));
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
    v_path_free(path);
    v_path_free(longer);
    return failures != 0;
}
