/*
 * Every function of the library, called with arguments from draw.h.
 *
 * The paths, windows and lists that the calls work on are kept here. With
 * `wild` 0 every argument is fit and every call does what it is there for.
 */
#ifndef EVERY_H
#define EVERY_H

#include "libvides.h"

enum answers {
    STATUS,  /* one of V_OK ... V_ERR_INTERNAL */
    NOTHING, /* v_last_error() alone tells */
    COUNT,   /* a number, -1 or more */
    TEXT     /* never NULL; v_last_error() stays as it is */
};

struct function {
    const char *name;
    int (*call)(void);
    enum answers answers;
    int normally;   /* the answer to fit arguments; -2: any */
    int needs_display;
};

extern const struct function functions[];
extern const int function_count;

/* Which callback of a window runs. */
enum callback { RUECK, ENDE, ON_POSES, ON_CLOSE, ON_VIEW, ON_FRAME, ON_CHANGE, ON_CAPTURE,
                ON_PANE, ON_GONE, CALLBACKS };
extern const char *const callback_names[CALLBACKS];

/* What a callback does, after it has looked at what it was given; the answer
 * of ende and on_close. `editor` is NULL in rueck and ende. */
extern int (*within_callback)(enum callback which, V_EDITOR *editor);
extern int depth; /* callbacks under way */
extern long callback_count[CALLBACKS];

/* A folder that the calls may write to; whether windows can be opened. */
extern const char *folder;
extern int display_there;
/* Windows are closed by other hands. */
extern int windows_may_go;

/* Windows of handles; the one that the next call shall work on, if any. */
#define EDITORS 6
extern V_EDITOR *editors[EDITORS];
extern V_EDITOR *this_editor;

/* The head of the list that the next call shall work on, if any; and that
 * which rueck was given last. */
extern V_KAMERAPAR *this_list, *given_list;
/* What the callbacks of V_EDITOR_OPTIONS expect as their user. */
void *a_user(void);

void callback_rueck(V_KAMERAPAR *first, int count);
int callback_ende(void);
void callback_on_poses(V_EDITOR *editor, const V_POSE *poses, size_t count, void *user);
int callback_on_close(V_EDITOR *editor, void *user);
void callback_on_view(V_EDITOR *editor, const V_POSE *pose, double at, int reason, void *user);
void callback_on_frame(V_EDITOR *editor, double at, int reason, void *user);
void callback_on_change(V_EDITOR *editor, void *user);
int callback_on_capture(V_EDITOR *editor, V_POSE *pose, void *user);
void callback_on_pane(V_EDITOR *editor, unsigned long window, int width, int height, void *user);
void callback_on_gone(V_EDITOR *editor, int reason, void *user);

/* Makes one call and holds its answer against what is promised: a documented
 * status (V_ERR_INTERNAL is none), a message after a failure and none after a
 * success, nothing written after a failure. With fit arguments the answer must be the normal one, or
 * `instead` if that is not -2. Gives the answer; faults are counted. */
int call(const struct function *function, int instead);
/* If set, asked after each call, before anything else; the last answer. */
extern int (*ask_after_call)(void);
extern int asked_after_call;
const struct function *function_named(const char *name);
extern int faults;
void fault(const char *format, ...);

/* The name of every function in the header has a function here. */
void check_names(void);

/* Fit things for calls to work on; and an end to all of them. */
void fresh_things(void);
void end_things(void);

#endif
