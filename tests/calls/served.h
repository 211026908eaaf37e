/*
 * Windows opened, served and used by somebody (hands.h), one step after the
 * other: each step waits until it is done, and a step that is not done in time
 * ends the test.
 */
#ifndef SERVED_H
#define SERVED_H

#include "every.h"

/* A window and what it is known by: to the library, to the X server. */
struct window {
    V_EDITOR *editor;  /* NULL for one of v_haupt() */
    V_KAMERAPAR *list; /* of v_haupt(); NULL: VIDES's own */
    unsigned long shown;
};

/* Opens a window by v_editor_open(), or by v_haupt() with this list. */
struct window open_editor(void);
struct window open_haupt(V_KAMERAPAR *list);

/* Serves the windows until the condition holds. */
void serve_until(int (*condition)(void), const char *what);
/* Serves the windows until this callback has run once more; hands over or
 * asks to close before. */
void use(const struct window *window, enum callback which);

/* Serves the windows until they have nothing to do. */
void settle(void);

/* Whether a window is still on the screen. */
int is_shown(const struct window *window);
/* Serves the windows until this one is gone. */
void wait_gone(const struct window *window);
/* Closes whatever is open. */
void close_all(void);

#endif
