/*
 * What hosts may do with windows, and seldom do: odd_hosts FOLDER
 *
 * A path with an object of its own is shown, and one without; a list of the
 * library's is changed within rueck; the X server's connection ends while the
 * main loop runs.
 */
#include <poll.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "draw.h"
#include "every.h"
#include "hands.h"
#include "served.h"

static char name[600];

static const char *in(const char *file)
{
    sprintf(name, "%.500s/%.90s", folder, file);
    return name;
}

/* ---- Objects ------------------------------------------------------------------------ */

static V_PATH *loaded(const char *text)
{
    V_PATH *path = NULL;
    FILE *out = fopen(in("given.vid"), "w");

    if (out == NULL || fputs(text, out) < 0 || fclose(out) != 0
        || v_path_load(in("given.vid"), &path) != V_OK)
        fault("a path to be shown: %s", v_last_error());
    return path;
}

/* Whether the path that the window has, saved, contains these words. */
static int shows(const V_EDITOR *editor, const char *words)
{
    static char text[20000];
    V_PATH *path;
    FILE *file;

    if (v_editor_get_path(editor, &path) != V_OK || v_path_save(path, in("shown.vid")) != V_OK)
        fault("the path of a window: %s", v_last_error());
    v_path_free(path);
    file = fopen(in("shown.vid"), "r");
    memset(text, 0, sizeof text);
    if (file == NULL || fread(text, 1, sizeof text - 1, file) == 0)
        fault("nothing was saved");
    if (file != NULL)
        fclose(file);
    return strstr(text, words) != NULL;
}

static void show(V_EDITOR *editor, const char *text)
{
    V_PATH *path = loaded(text);

    if (v_editor_set_path(editor, path) != V_OK)
        fault("v_editor_set_path: %s", v_last_error());
    v_path_free(path);
    settle();
}

#define POINTS "[[point]]\nposition = [0.0, 0.0, 0.0]\n[[point]]\nposition = [0.5, 0.0, 0.0]\n"

static void objects(void)
{
    struct window window = open_editor();

    if (shows(window.editor, "polylines"))
        fault("an object that nobody gave");
    show(window.editor, "version = 1\n" POINTS
                        "[object]\npolylines = [[[0.25, 0.0, 0.0], [0.75, 0.125, 0.0]]]\n");
    if (!shows(window.editor, "0.125"))
        fault("the path's object is not shown");
    /* A path without an object leaves the one that is shown. */
    show(window.editor, "version = 1\ntitle = \"another\"\n" POINTS);
    if (!shows(window.editor, "0.125") || !shows(window.editor, "another"))
        fault("the object went with its path");
    use(&window, ON_POSES);
    v_editor_close(window.editor);
    close_all();
}

/* ---- A list of the library's, changed within rueck ------------------------------------ */

static V_KAMERAPAR *taken; /* the elements that the host has made its own */

static int take_the_second(enum callback which, V_EDITOR *editor)
{
    (void)editor;
    if (which == RUECK) {
        taken = given_list->next;
        taken->prev = taken; /* no more what was made: nothing is freed */
    }
    return 1;
}

static int nothing(enum callback which, V_EDITOR *editor)
{
    (void)which, (void)editor;
    return 1;
}

static void changed_lists(void)
{
    struct window window = open_haupt(NULL);
    const V_KAMERAPAR *first;
    int count = 0;

    use(&window, RUECK);
    within_callback = take_the_second;
    use(&window, RUECK);
    within_callback = nothing;
    settle();
    /* The elements from the second on are the host's now, the first one is gone. */
    first = given_list;
    while (taken != first && count < 10000) {
        V_KAMERAPAR *next = taken->next;
        free(taken);
        taken = next;
        count++;
    }
    if (count < 2)
        fault("a list of %d elements", count);
    use(&window, RUECK);
    close_all();
}

/* ---- The connection ends ---------------------------------------------------------------- */

static struct window lost;

static int kill_it(enum callback which, V_EDITOR *editor)
{
    (void)which, (void)editor;
    hands_kill(lost.shown);
    return 1;
}

static void lost_in_the_main_loop(void)
{
    lost = open_editor();
    settle();
    within_callback = kill_it;
    hands_hand_over(lost.shown);
    if (v_main_loop() != V_ERR_DISPLAY || v_last_error()[0] == '\0')
        fault("v_main_loop tells \"%s\" of a connection that ended", v_last_error());
    within_callback = nothing;
    if (v_editor_close(lost.editor) != V_OK)
        fault("the handle of a window that is gone: %s", v_last_error());
}

int main(int argc, char **argv)
{
    folder = argc > 1 ? argv[1] : ".";
    within_callback = nothing;
    display_there = hands_connect();
    if (!display_there) {
        fprintf(stderr, "odd_hosts: no display\n");
        return 1;
    }
    objects();
    changed_lists();
    lost_in_the_main_loop();
    hands_leave();
    if (faults > 0)
        show_last_calls();
    printf("odd_hosts: %d faults\n", faults);
    return faults != 0;
}
