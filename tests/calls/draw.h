/*
 * Arguments for calls of the library, drawn at random.
 *
 * A drawn argument is fit, or as often as `wild` says out of a hundred times it
 * is not: NULL, not aligned, a handle that is none, a number that is none. What
 * goes to the library lies in blocks of exactly its size, so that a sanitizer
 * sees each byte too much; what comes back is looked at after the call: a call
 * that fails has written nothing.
 *
 * Each call is also put into words as it is drawn, so that a failure can show
 * the calls that led to it.
 */
#ifndef DRAW_H
#define DRAW_H

#include <stddef.h>

#include "libvides.h"

/* How many of a hundred arguments are unfit. */
extern int wild;

/* The generator: the same seed, the same calls. */
void draw_seed(unsigned long long seed);
unsigned below(unsigned count);
int chance(int of_a_hundred);

/* A call: begun before its arguments are drawn, ended after it. Calls within
 * calls (from callbacks) are kept apart. */
struct frame {
    struct frame *outer;
    char text[800];
    size_t length;
    struct block {
        unsigned char *base, *given, *before;
        size_t size;
    } blocks[24];
    int count;
    int unfit;     /* an argument was drawn that may not do */
    int unaligned; /* one that is not aligned */
    void *made_path, *made_editor; /* handles that the call has given */
};

extern struct frame *frame;

void frame_begin(struct frame *new_frame, const char *name);
/* Whether everything that was to be written is still as it was. */
int frame_untouched(void);
/* The one result of a call that fails: how many are needed, of an array that is too small. It
 * is looked at and forgotten; gives the status. */
int too_small(int status, size_t *count, size_t capacity);
void frame_end(void);

/* Words for the call under way. */
void word(const char *format, ...);

int whole(int least, int most);
double number(double least, double most);
/* `count` numbers; NULL is unfit, too. */
const double *numbers(int count, double least, double most);
/* The same, or NULL, which is as good. */
const double *numbers_or_null(int count, double least, double most);
/* Increasing numbers, the first being -1. */
const double *increasing(int count);
/* A copy of a struct or an array, NULL being unfit. */
void *given(const char *name, const void *what, size_t size);
/* A copy of a text, at any address. NULL stays NULL. */
const char *text(const char *value);
/* Room for a result; may_be_null: NULL is as good. */
void *result(size_t size, int may_be_null);

/* The last calls, for whoever looks for what went wrong. */
void remember(const char *text, int answer);
void show_last_calls(void);

#endif
