/* Arguments for calls, drawn at random: see draw.h. */
#include "draw.h"
#include "every.h"

#include <float.h>
#include <limits.h>
#include <math.h>
#include <stdarg.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define FILL 0xA5
#define REMEMBERED 40

int wild;
struct frame *frame;

static uint64_t state = 1;
static char last[REMEMBERED][860];
static unsigned calls;

void draw_seed(unsigned long long seed)
{
    state = seed * 0x9E3779B97F4A7C15u + 1;
}

/* xorshift64*, Vigna 2016. */
static uint64_t next(void)
{
    state ^= state >> 12;
    state ^= state << 25;
    state ^= state >> 27;
    return state * 0x2545F4914F6CDD1Du;
}

unsigned below(unsigned count)
{
    return (unsigned)((next() >> 32) * count >> 32);
}

int chance(int of_a_hundred)
{
    return (int)below(100) < of_a_hundred;
}

/* Whether the next argument shall be an unfit one. */
static int unfit(void)
{
    if (!chance(wild))
        return 0;
    frame->unfit = 1;
    return 1;
}

void frame_begin(struct frame *new_frame, const char *name)
{
    new_frame->outer = frame;
    new_frame->length = 0;
    new_frame->count = 0;
    new_frame->unfit = new_frame->unaligned = 0;
    new_frame->made_path = new_frame->made_editor = NULL;
    frame = new_frame;
    word("%s:", name);
}

int frame_untouched(void)
{
    int i;

    for (i = 0; i < frame->count; i++) {
        struct block *block = &frame->blocks[i];
        if (block->given != NULL && memcmp(block->given, block->before, block->size) != 0)
            return 0;
    }
    return 1;
}

int too_small(int status, size_t *count, size_t capacity)
{
    size_t needed;

    if (status == V_ERR_SIZE && count != NULL) {
        memcpy(&needed, count, sizeof needed);
        if (needed <= capacity)
            fault("it needs %lu and has %lu", (unsigned long)needed, (unsigned long)capacity);
        memset(count, FILL, sizeof *count);
    }
    return status;
}

void frame_end(void)
{
    int i;

    for (i = 0; i < frame->count; i++) {
        free(frame->blocks[i].base);
        free(frame->blocks[i].before);
    }
    frame = frame->outer;
}

void word(const char *format, ...)
{
    va_list arguments;
    size_t room = sizeof frame->text - frame->length;
    int written;

    if (frame->length > 0 && room > 2) {
        frame->text[frame->length++] = ' ';
        room--;
    }
    va_start(arguments, format);
    written = vsnprintf(frame->text + frame->length, room, format, arguments);
    va_end(arguments);
    if (written > 0)
        frame->length += (size_t)written < room ? (size_t)written : room - 1;
}

int whole(int least, int most)
{
    int drawn = least + (int)below((unsigned)(most - least) + 1);

    if (unfit()) {
        const int odd[] = {least - 1, most + 1, -1, INT_MIN, INT_MAX, most + 1000, (int)next()};
        drawn = odd[below(sizeof odd / sizeof *odd)];
    }
    word("%d", drawn);
    return drawn;
}

static double one_number(double least, double most)
{
    if (unfit()) {
        const double odd[] = {NAN, INFINITY, -INFINITY, 1e300, -1e300, 5e-324, -0.0, 0.0,
                              -1, 1e9 + 1, least - 1e-9, most + 1e-9, -DBL_MAX};
        return odd[below(sizeof odd / sizeof *odd)];
    }
    /* Now and then the ends, and the middle. */
    switch (below(8)) {
    case 0:
        return least;
    case 1:
        return most;
    default:
        return least + (most - least) * (below(1 << 20) / (double)(1 << 20));
    }
}

double number(double least, double most)
{
    double drawn = one_number(least, most);

    word("%.17g", drawn);
    return drawn;
}

/* A block of exactly this size, at an address that does or does not suit. */
static struct block *block(size_t size, int aligned)
{
    struct block *made;

    if (frame->count == (int)(sizeof frame->blocks / sizeof *frame->blocks)) {
        fprintf(stderr, "draw.c: more blocks than a call has arguments\n");
        abort();
    }
    made = &frame->blocks[frame->count++];
    made->base = malloc(size + !aligned);
    made->given = made->base + !aligned;
    made->before = malloc(size + 1);
    made->size = size;
    if (made->base == NULL || made->before == NULL)
        abort();
    memset(made->given, FILL, size);
    memcpy(made->before, made->given, size);
    if (!aligned) {
        frame->unaligned = 1;
        word("(not aligned)");
    }
    return made;
}

static void fill(struct block *made, const void *what)
{
    memcpy(made->given, what, made->size);
    memcpy(made->before, what, made->size);
}

void *given(const char *name, const void *what, size_t size)
{
    struct block *made;

    word("%s", name);
    if (unfit() && chance(60)) {
        word("NULL");
        return NULL;
    }
    made = block(size, !unfit());
    fill(made, what);
    return made->given;
}

const char *text(const char *value)
{
    struct block *made;

    if (value == NULL) {
        word("NULL");
        return NULL;
    }
    word("\"%.60s\"", value);
    made = block(strlen(value) + 1, 1);
    fill(made, value);
    return (const char *)made->given;
}

static const double *drawn_numbers(int count, double least, double most)
{
    double some[64];
    int i;

    for (i = 0; i < count; i++) {
        some[i] = one_number(least, most);
        word(i == 0 ? "[%.17g" : "%.17g", some[i]);
    }
    word("]");
    return given("numbers", some, (size_t)count * sizeof *some);
}

const double *numbers(int count, double least, double most)
{
    return drawn_numbers(count, least, most);
}

const double *numbers_or_null(int count, double least, double most)
{
    if (chance(30)) {
        word("NULL");
        return NULL;
    }
    return drawn_numbers(count, least, most);
}

const double *increasing(int count)
{
    double some[64], sum = -1;
    int i;

    for (i = 0; i < count; i++) {
        some[i] = sum;
        sum += one_number(0.1, 2);
    }
    return given("increasing", some, (size_t)count * sizeof *some);
}

void *result(size_t size, int may_be_null)
{
    if (may_be_null && chance(30)) {
        word("NULL");
        return NULL;
    }
    if (unfit() && chance(60)) {
        word("NULL");
        return NULL;
    }
    word("&");
    return block(size, !unfit())->given;
}

void remember(const char *text, int answer)
{
    int depth = 0;
    struct frame *outer;

    for (outer = frame; outer != NULL; outer = outer->outer)
        depth++;
    snprintf(last[calls % REMEMBERED], sizeof last[0], "%*s%s -> %d", 2 * depth, "", text, answer);
    calls++;
}

void show_last_calls(void)
{
    unsigned i, from = calls > REMEMBERED ? calls - REMEMBERED : 0;
    const struct frame *under;

    fprintf(stderr, "the last of %u calls:\n", calls);
    for (i = from; i < calls; i++)
        fprintf(stderr, "  %s\n", last[i % REMEMBERED]);
    for (under = frame; under != NULL; under = under->outer)
        fprintf(stderr, "  under way: %s\n", under->text);
    fflush(stderr);
}
