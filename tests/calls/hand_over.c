/*
 * Memory runs out while a window hands over: every single allocation fails in
 * turn, once and from then on until the poses are ready: hand_over FOLDER
 *
 * Linked with a library that tells when that is (crates/engine/src/inject.rs). The host is not
 * called, its list is as it was, nothing is left behind; the window works on, and
 * when there is memory again it hands over.
 */
#include <stdio.h>
#include <string.h>

#include "../c/allocations.h"
#include "draw.h"
#include "every.h"
#include "hands.h"
#include "places.h"
#include "served.h"

#define MOST 400 /* elements of a list that are looked at */

static V_KAMERAPAR head;
static long next_failure; /* the allocation of the next hand-over that fails; -1: none */
static int for_ever;
static long needed;       /* allocations of the last hand-over */
static long left;         /* blocks that it left behind */
static int ready;         /* the poses are, or could not be */
static int refusals;      /* hand-overs that failed */

static int nothing(enum callback which, V_EDITOR *editor)
{
    (void)which, (void)editor;
    return 1;
}

/* The library tells where it is. */
static void tell(int place)
{
    if (place == HAND_OVER) {
        left = -blocks;
        asked = 0;
        fail_forever = for_ever;
        fail_at = next_failure;
    } else if (place == PREPARED) {
        fail_at = -1;
        left += blocks;
        needed = asked;
        ready = 1;
    }
}

static int is_ready(void)
{
    return ready;
}

static void hand_over(const struct window *window)
{
    ready = 0;
    hands_hand_over(window->shown);
    serve_until(is_ready, "poses made ready");
    settle();
}

/* What a list holds, and where; no data, no elements. */
static int copied(V_KAMERAPAR *to)
{
    const V_KAMERAPAR *element = &head;
    int count = 0;

    if (head.number < 0)
        return 0;
    do {
        to[count++] = *element;
        element = element->next;
    } while (element != &head && count < MOST);
    return count;
}

/* Hands over with each allocation failing in turn, until one more than there are. */
static void without_memory(const struct window *window, enum callback callback)
{
    static V_KAMERAPAR before[MOST], after[MOST];
    long calls;
    int count;

    for (next_failure = 0;; next_failure++) {
        count = copied(before);
        calls = callback_count[callback];
        hand_over(window);
        if (needed <= next_failure || faults > 5)
            break;
        if (left != 0)
            fault("%ld blocks are left by the failure of allocation %ld", left, next_failure);
        if (callback_count[callback] != calls)
            fault("the host was called after the failure of allocation %ld", next_failure);
        if (copied(after) != count || memcmp(before, after, count * sizeof *after) != 0)
            fault("the failure of allocation %ld changed the list", next_failure);
        refusals++;
    }
    if (next_failure == 0)
        fault("a hand-over that needs no memory");
    if (callback_count[callback] != calls + 1)
        fault("the host was not called when there was memory again");
    if (window->list != NULL && copied(after) < 2)
        fault("no list when there was memory again");
    /* Elements are used again: a host that keeps one meets no freed memory. */
    if (window->list != NULL && count >= 2 && after[0].next != before[0].next)
        fault("the list's elements are others than before");
}

/* Without and with poses of before. */
static void twice(struct window window, enum callback callback)
{
    head.number = -1;
    without_memory(&window, callback);
    without_memory(&window, callback);
    v_editor_close(window.editor);
    close_all();
    v_free_liste(&head);
}

int main(int argc, char **argv)
{
    folder = argc > 1 ? argv[1] : ".";
    within_callback = nothing;
    display_there = hands_connect();
    if (!display_there) {
        fprintf(stderr, "hand_over: no display\n");
        return 1;
    }
    v_test_tell(tell);
    for (for_ever = 0; for_ever < 2; for_ever++) {
        twice(open_editor(), ON_POSES);
        twice(open_haupt(&head), RUECK);
        twice(open_haupt(NULL), RUECK);
    }
    v_test_tell(NULL);
    hands_leave();
    if (faults > 0)
        show_last_calls();
    printf("hand_over: %d hand-overs refused, %d faults\n", refusals, faults);
    return faults != 0;
}
