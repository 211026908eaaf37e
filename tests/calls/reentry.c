/*
 * Every function from within every callback: reentry FOLDER [PART PARTS]
 *
 * For each pair a window is opened whose callback makes the call, with fit
 * arguments: about the callback's own window, about another one, about neither.
 * It must do there what it does elsewhere, but for v_main_loop() and
 * v_editors_close(), which are refused. Afterwards both windows are used again.
 */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "draw.h"
#include "every.h"
#include "hands.h"
#include "served.h"

enum about { OWN, OTHER };

static struct window own, other;
static V_KAMERAPAR head;
static enum callback cell_callback;
static const struct function *cell_function;
static enum about cell_about;
static int cell_answer; /* of ende and on_close */
static int done, answered;

static int is(const char *name)
{
    return cell_function == function_named(name);
}

/* Whether a call needs the window whose end its callback tells. */
static int about_the_gone(enum callback which)
{
    return which == ON_GONE && cell_about == OWN && cell_function->answers == STATUS
        && !is("v_editor_open") && !is("v_editor_close");
}

static int within(enum callback which, V_EDITOR *editor)
{
    if (done || which != cell_callback || editor != own.editor)
        return 1;
    done = 1;
    this_editor = cell_about == OWN && editor != NULL ? editor : other.editor;
    /* The element itself must outlive a window that it is given to. */
    this_list = which == RUECK && cell_function != function_named("v_haupt") ? given_list : NULL;
    answered = call(cell_function, about_the_gone(which) ? V_ERR_CLOSED : -2);
    this_editor = NULL;
    this_list = NULL;
    return cell_answer;
}

static void cell_words(char *words, size_t size)
{
    snprintf(words, size, "%s within %s about %s window, answer %d%s", cell_function->name,
             callback_names[cell_callback], cell_about == OWN ? "its own" : "the other", cell_answer,
             own.editor == NULL && own.list == NULL ? ", VIDES's list" : "");
}

static int is_done(void)
{
    return done;
}

/* One callback, one function. */
static void cell(enum callback which, const struct function *function, enum about about,
                 V_KAMERAPAR *list, int answer)
{
    int gone, asks_to_close = which == ENDE || which == ON_CLOSE, faults_before = faults;
    char words[200];

    cell_callback = which;
    cell_function = function;
    cell_about = about;
    cell_answer = answer;
    done = 1;
    fresh_things();
    if (list != NULL)
        list->number = -1;
    other = open_editor();
    own = which == RUECK || which == ENDE ? open_haupt(list) : open_editor();
    if (which == ON_PANE)
        settle(); /* they open with the windows */
    done = 0;
    use(&own, which);
    /* What the other one calls when it opens may come between. */
    serve_until(is_done, "the callback of its own window");
    if (is("v_dispatch") && answered < 2 - (which == ON_GONE))
        fault("v_dispatch answers %d while two windows are open", answered);

    gone = (asks_to_close && answer) || which == ON_GONE || (is("v_editor_close") && about == OWN);
    if (gone) {
        /* A window that is opened in on_gone may get the same number. */
        if (which != ON_GONE)
            wait_gone(&own);
        if (own.editor != NULL && v_editor_get_path(own.editor, NULL) == V_OK)
            fault("a window that is gone gives its path");
    } else {
        if (!is_shown(&own))
            fault("the window is gone");
        use(&own, own.editor == NULL ? RUECK : ON_POSES);
    }
    if (is("v_editor_close") && about == OTHER) {
        wait_gone(&other);
    } else {
        use(&other, ON_POSES);
        v_editor_close(other.editor);
    }
    if (own.editor != NULL)
        v_editor_close(own.editor);
    end_things();
    close_all();
    if (list != NULL && list->number >= 0)
        v_free_liste(list);
    if (faults > faults_before) {
        cell_words(words, sizeof words);
        fprintf(stderr, "reentry: %s\n", words);
    }
}

/* Callbacks within callbacks, as deep as there are windows: each serves the
 * others, and the last one closes them all. */
#define DEEP 8
static struct window nested[DEEP];
static int deepest;

static int within_each_other(enum callback which, V_EDITOR *editor)
{
    int i;

    (void)which, (void)editor;
    deepest = depth > deepest ? depth : deepest;
    if (depth < DEEP)
        v_dispatch();
    else
        for (i = 0; i < DEEP; i++)
            if (v_editor_close(nested[i].editor) != V_OK)
                fault("closing within callbacks: %s", v_last_error());
    return 1;
}

static int all_gone(void)
{
    return v_dispatch() == 0;
}

static void callbacks_within_callbacks(void)
{
    int i;

    within_callback = NULL;
    for (i = 0; i < DEEP; i++)
        nested[i] = open_editor();
    within_callback = within_each_other;
    for (i = 0; i < DEEP; i++)
        hands_hand_over(nested[i].shown);
    serve_until(all_gone, "windows to be closed by a callback");
    if (deepest != DEEP)
        fault("callbacks were %d deep instead of %d", deepest, DEEP);
    close_all();
}

int main(int argc, char **argv)
{
    int i, cells = 0, tried = 0, parts = argc > 3 ? atoi(argv[3]) : 1;
    int part = argc > 3 ? atoi(argv[2]) : 0; /* of so many, counted from 0 */
    enum callback which;
    enum about about;

    folder = argc > 1 ? argv[1] : ".";
    if (!hands_connect()) {
        fprintf(stderr, "reentry: no display\n");
        return 1;
    }
    display_there = 1;
    check_names();
    callbacks_within_callbacks();
    within_callback = within;
    for (which = 0; which < CALLBACKS; which++) {
        for (i = 0; i < function_count; i++) {
            int editors_function = strncmp(functions[i].name, "v_editor_", 9) == 0;
            for (about = OWN; about <= OTHER; about++) {
                int lists = which == RUECK, answers = which == ENDE || which == ON_CLOSE, k;
                /* Only a window with a handle can be named by its own callback. */
                if (about == OWN && (!editors_function || which == RUECK || which == ENDE))
                    continue;
                for (k = 0; k <= (lists || answers); k++, cells++)
                    if (cells % parts == part) {
                        cell(which, &functions[i], about, lists && k ? NULL : &head,
                             answers ? k : 1);
                        tried++;
                    }
            }
        }
    }
    hands_leave();
    if (faults > 0)
        show_last_calls();
    printf("reentry: %d cells, %d faults\n", tried, faults);
    return faults != 0;
}
