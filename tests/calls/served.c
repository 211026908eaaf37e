/* Windows opened, served and used: see served.h. */
#include "served.h"

#include <poll.h>
#include <stdio.h>
#include <stdlib.h>
#include <time.h>

#include "draw.h"
#include "hands.h"

#define PATIENCE 60 /* seconds; long, since machines may be busy */

static enum callback awaited;
static long count_before;
static int windows_before;
static unsigned long awaited_window;

void serve_until(int (*condition)(void), const char *what)
{
    time_t end = time(NULL) + PATIENCE;
    struct pollfd watched;

    while (!condition()) {
        watched.fd = v_fd();
        watched.events = POLLIN;
        poll(&watched, 1, 20);
        v_dispatch();
        if (time(NULL) > end) {
            fault("not in time: %s", what);
            show_last_calls();
            exit(1);
        }
    }
}

void settle(void)
{
    struct pollfd watched;

    do {
        v_dispatch();
        watched.fd = v_fd();
        watched.events = POLLIN;
    } while (poll(&watched, 1, 200) != 0);
}

static int one_more(void)
{
    return hands_count() > windows_before;
}

static unsigned long newest(void)
{
    serve_until(one_more, "a window on the screen");
    return hands_window(hands_count() - 1);
}

struct window open_editor(void)
{
    struct window window = {NULL, NULL, 0};
    V_EDITOR_OPTIONS options;

    windows_before = hands_count();
    v_editor_options_init(&options);
    options.on_poses = callback_on_poses;
    options.on_close = callback_on_close;
    options.on_view = callback_on_view;
    options.on_frame = callback_on_frame;
    options.on_change = callback_on_change;
    options.on_capture = callback_on_capture;
    options.on_pane = callback_on_pane;
    options.on_gone = callback_on_gone;
    options.user = a_user();
    if (v_editor_open(&options, &window.editor) != V_OK) {
        fault("v_editor_open: %s", v_last_error());
        exit(1);
    }
    window.shown = newest();
    return window;
}

struct window open_haupt(V_KAMERAPAR *list)
{
    struct window window = {NULL, list, 0};

    windows_before = hands_count();
    v_haupt(20, 20, 20, 20, list, 0, NULL, callback_rueck, callback_ende);
    if (v_last_error()[0] != '\0') {
        fault("v_haupt: %s", v_last_error());
        exit(1);
    }
    window.shown = newest();
    return window;
}

static int was_called(void)
{
    return callback_count[awaited] > count_before;
}

void use(const struct window *window, enum callback which)
{
    awaited = which;
    count_before = callback_count[which];
    if (which == ON_VIEW || which == ON_FRAME)
        hands_next_point(window->shown);
    else if (which == ON_CHANGE)
        hands_change(window->shown);
    else if (which == ON_CAPTURE)
        hands_take_over(window->shown);
    else if (which == ON_PANE)
        hands_switch_pane(window->shown);
    else if (which == RUECK || which == ON_POSES)
        hands_hand_over(window->shown);
    else
        hands_close(window->shown);
    serve_until(was_called, callback_names[which]);
}

static int is_there(unsigned long shown)
{
    int i, count = hands_count();

    for (i = 0; i < count; i++)
        if (hands_window(i) == shown)
            return 1;
    return 0;
}

int is_shown(const struct window *window)
{
    return is_there(window->shown);
}

static int is_gone(void)
{
    return !is_there(awaited_window);
}

void wait_gone(const struct window *window)
{
    awaited_window = window->shown;
    serve_until(is_gone, "a window to be gone");
}

static int nothing_open(void)
{
    unsigned long window = hands_window(0);

    if (window != 0)
        hands_close(window);
    return window == 0 && v_dispatch() == 0;
}

void close_all(void)
{
    serve_until(nothing_open, "all windows to be closed");
}
