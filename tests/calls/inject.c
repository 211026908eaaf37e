/*
 * The library panics, in every export and wherever a window is at work:
 * inject FOLDER
 *
 * Linked with a library that is built for it (crates/engine/src/inject.rs). An export answers
 * V_ERR_INTERNAL and has written nothing; a window closes, and its owner is
 * told. The host lives, and everything else works as before.
 */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "draw.h"
#include "every.h"
#include "hands.h"
#include "places.h"
#include "served.h"

static const char *const place_names[PLACES] = {
    "call", "path", "dispatch", "event", "turn", "layout", "paint", "hand-over", "prepared",
    "callback"
};

static struct window victim, bystander, old_bystander;
static V_KAMERAPAR heads[2];
static int struck; /* panics that were had */

static int nothing(enum callback which, V_EDITOR *editor)
{
    (void)which, (void)editor;
    return 1;
}

/* Was it said that the library was at fault? */
static void check_told(const char *where)
{
    if (strstr(v_last_error(), "a fault inside the library") == NULL)
        fault("%s: \"%s\" tells of no fault of the library", where, v_last_error());
}

/* ---- Exports ---------------------------------------------------------------------- */

/* The same call as always: the same arguments, the same things. */
static int same_call(const struct function *function, int instead)
{
    fresh_things();
    this_editor = bystander.editor;
    draw_seed(7);
    return call(function, instead);
}

/* Whether it works on a path. */
static int holds_a_path(const struct function *function)
{
    const char *name = function->name;

    return strcmp(name, "v_editor_set_path") == 0 || strcmp(name, "v_editor_set_scene") == 0
           || (strncmp(name, "v_path_", 7) == 0 && strncmp(name, "v_path_new", 10) != 0
               && strcmp(name, "v_path_free") != 0 && strcmp(name, "v_path_key") != 0
               && strcmp(name, "v_path_fit_poses") != 0
               && strncmp(name, "v_path_load", 11) != 0);
}

/* The function panics at its last time through a place, which is its own: what
 * comes before it asks about its arguments. */
static void in_export(const struct function *function, enum place place)
{
    int passed, answer;

    if (place == PATH && !holds_a_path(function))
        return;
    fresh_things();
    this_editor = bystander.editor;
    draw_seed(7);
    v_test_panic(place, -1);
    call(function, -2);
    passed = asked_after_call;
    if (passed == 0) {
        fault("%s does not come through the %s", function->name, place_names[place]);
        return;
    }
    if (function == function_named("v_editor_close"))
        bystander = open_editor();
    fresh_things();
    this_editor = bystander.editor;
    draw_seed(7);
    v_test_panic(place, passed - 1);
    answer = call(function, V_ERR_INTERNAL);
    if (asked_after_call != passed)
        fault("%s did not come through again", function->name);
    check_told(function->name);
    if (function->answers == COUNT && answer > 0)
        fault("%s answers %d after a panic", function->name, answer);
    v_test_panic(place, -1);
    struck++;
    /* What else there is works, and so does the function itself. */
    same_call(function_named("v_path_to_list"), -2);
    if (same_call(function, -2) == V_ERR_INTERNAL)
        fault("%s fails after a panic: %s", function->name, v_last_error());
    if (function == function_named("v_editor_close"))
        bystander = open_editor();
}

static void every_export(void)
{
    int i;

    bystander = open_editor();
    for (i = 0; i < function_count; i++)
        if (functions[i].answers != TEXT) {
            in_export(&functions[i], CALL);
            in_export(&functions[i], PATH);
        }
    this_editor = NULL;
    v_editor_close(bystander.editor);
    end_things();
    close_all();
}

/* A path that was being changed is unusable, and can be freed. */
static void spoiled_path(void)
{
    V_PATH *path, *other;
    double place[3] = {0, 0.5, 0}, length;

    if (v_path_new(&path) != V_OK || v_path_new(&other) != V_OK)
        fault("v_path_new: %s", v_last_error());
    v_test_panic(PATH, 0);
    if (v_path_set_numbers(path, "point.1.position", place, 3) != V_ERR_INTERNAL)
        fault("no panic while a path is changed");
    if (v_path_length(path, &length) != V_ERR_INTERNAL || v_path_length(other, &length) != V_OK)
        fault("a spoiled path is used, or another is not");
    v_path_free(path);
    if (v_last_error()[0] != '\0' || v_path_length(path, &length) != V_ERR_HANDLE)
        fault("a spoiled path is not freed: %s", v_last_error());
    v_path_free(other);
    struck++;
}

/* ---- Windows ------------------------------------------------------------------------ */

static int victim_gone(void)
{
    return !is_shown(&victim);
}

/* The victim's next work at this place ends it; the others go on. */
static void in_window(enum place place, int of_haupt, int closing)
{
    V_PATH *path;
    int before = faults;

    heads[0].number = heads[1].number = -1;
    victim = of_haupt ? open_haupt(&heads[0]) : open_editor(); /* the first to be served */
    bystander = open_editor();
    old_bystander = open_haupt(&heads[1]);
    use(&bystander, ON_POSES);
    hands_raise(victim.shown); /* what is not seen is not painted */
    settle(); /* so that the next to work is the victim */
    v_test_panic(place, 0);
    if (closing)
        hands_close(victim.shown);
    else
        hands_hand_over(victim.shown);
    serve_until(victim_gone, place_names[place]);
    if (v_test_passed() == 0)
        fault("the window went without a panic");
    struck++;
    if (!of_haupt && v_editor_get_path(victim.editor, &path) != V_ERR_CLOSED)
        fault("a window that is gone gives its path");
    use(&bystander, ON_POSES);
    use(&old_bystander, RUECK);
    if (heads[1].number != 1)
        fault("no list from the other window");
    if (!of_haupt && v_editor_close(victim.editor) != V_OK)
        fault("the handle of a window that is gone: %s", v_last_error());
    victim = open_editor(); /* and there can be new ones */
    use(&victim, ON_POSES);
    v_editor_close(victim.editor);
    v_editor_close(bystander.editor);
    close_all();
    v_free_liste(&heads[0]);
    v_free_liste(&heads[1]);
    if (faults > before)
        fprintf(stderr, "inject: at %s, %s, %s\n", place_names[place],
                of_haupt ? "v_haupt" : "v_editor_open", closing ? "closing" : "handing over");
}

static void every_place(void)
{
    enum place place;
    int of_haupt;

    for (place = EVENT; place < PLACES; place++)
        for (of_haupt = 0; of_haupt < 2; of_haupt++) {
            in_window(place, of_haupt, 0);
            if (place != HAND_OVER && place != PREPARED)
                in_window(place, of_haupt, 1);
        }
}

/* What v_dispatch() and v_main_loop() say. */
static void told_by_the_loops(void)
{
    victim = open_editor();
    v_test_panic(DISPATCH, 0);
    if (v_dispatch() != 0)
        fault("v_dispatch after a panic before any window was served");
    check_told("v_dispatch");
    use(&victim, ON_POSES); /* it is still there */
    settle();
    hands_hand_over(victim.shown);
    v_test_panic(LAYOUT, 0);
    if (v_main_loop() != V_ERR_INTERNAL)
        fault("v_main_loop does not tell of a panic");
    check_told("v_main_loop");
    v_editor_close(victim.editor);
    struck += 2;
}

int main(int argc, char **argv)
{
    folder = argc > 1 ? argv[1] : ".";
    within_callback = nothing;
    display_there = hands_connect();
    if (!display_there) {
        fprintf(stderr, "inject: no display\n");
        return 1;
    }
    ask_after_call = v_test_passed;
    every_export();
    ask_after_call = NULL;
    spoiled_path();
    every_place();
    told_by_the_loops();
    v_test_panic(CALL, -1);
    close_all();
    hands_leave();
    if (faults > 0)
        show_last_calls();
    printf("inject: %d panics, %d faults\n", struck, faults);
    return faults != 0;
}
