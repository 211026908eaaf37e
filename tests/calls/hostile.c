/*
 * Calls of every function in any order, most with some argument that will not
 * do, some from within callbacks and some from other threads, while somebody
 * sends the windows events:
 *
 *     hostile FOLDER [SEED [CALLS [ROUNDS]]]
 *
 * Each call must be answered as every.h says. After each round everything is
 * closed and freed, and no more memory may be in use than after the round
 * before. With DISPLAY unset the same without windows.
 */
#include <malloc.h>
#include <pthread.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "draw.h"
#include "every.h"
#include "hands.h"
#include "served.h"

#define MOST_WINDOWS 5
#define DEEPEST 2

static unsigned long long seed = 1;

static void tell_the_seed(void)
{
    fprintf(stderr, "hostile: seed %llu\n", seed);
    show_last_calls();
}

static void on_signal(int number)
{
    fprintf(stderr, "hostile: signal %d\n", number);
    tell_the_seed();
    signal(number, SIG_DFL);
    raise(number);
}

/* The sanitizers' way to say a last word, where they are. */
extern void __sanitizer_set_death_callback(void (*)(void)) __attribute__((weak));

static int within(enum callback which, V_EDITOR *editor)
{
    int i, number = (int)below(4);

    (void)editor;
    if (depth <= DEEPEST)
        for (i = 0; i < number; i++)
            call(&functions[below((unsigned)function_count)], -2);
    return which == RUECK || which == ON_POSES || chance(50);
}

/* A call from a thread that has no windows, and ends. */
static void *elsewhere(void *function)
{
    call(function, -2);
    return NULL;
}

static void one_call(void)
{
    const struct function *function = &functions[below((unsigned)function_count)];
    pthread_t thread;

    if (chance(95)) {
        call(function, -2);
    } else if (pthread_create(&thread, NULL, elsewhere, (void *)function) == 0) {
        pthread_join(thread, NULL);
    }
}

/* A window by a call that has nothing wrong, so that there are some. */
static void one_window(void)
{
    int were = wild;

    wild = 0;
    call(function_named(chance(50) ? "v_haupt" : "v_editor_open"), -2);
    wild = were;
}

static void one_event(void)
{
    int count = hands_count();
    unsigned long window = hands_window((int)below((unsigned)count + 1));

    if (count > MOST_WINDOWS)
        hands_destroy(hands_window(0));
    if (window == 0)
        return;
    switch (below(11)) {
    case 0:
    case 1:
    case 2:
        hands_hand_over(window);
        break;
    case 3:
        hands_change(window);
        break;
    case 4:
        hands_take_over(window);
        break;
    case 5:
    case 6:
        hands_close(window);
        break;
    case 7:
        if (chance(50))
            hands_destroy(window);
        else
            hands_kill(window);
        break;
    default:
        hands_send(window, (int)below((unsigned)hands_kinds()),
                   (unsigned long long)below(~0u) << 32 | below(~0u));
        hands_finish();
    }
}

/* Nothing is left of a round. */
static void end_round(void)
{
    int patience = 1000;

    end_things();
    while (display_there && v_dispatch() > 0 && patience-- > 0) {
        unsigned long window = hands_window(0);
        if (window != 0)
            hands_destroy(window);
        else
            usleep(1000);
    }
    if (patience <= 0)
        fault("a window cannot be closed");
    end_things(); /* what callbacks have made meanwhile */
}

static size_t in_use(void)
{
    return mallinfo2().uordblks;
}

static void round_of(int number, int calls)
{
    char state[400];
    int i;

    /* Work that windows leave behind is offered in the next ones, and then
     * they hear nothing else: each round begins without. */
    snprintf(state, sizeof state, "%.300s/state%d", folder, number);
    setenv("XDG_STATE_HOME", state, 1);
    wild = 0;
    fresh_things();
    wild = 15;
    for (i = 0; i < calls && faults == 0; i++) {
        one_call();
        if (display_there && chance(5))
            one_window();
        if (display_there && chance(30)) {
            one_event();
            call(function_named("v_dispatch"), -2);
        }
        if (chance(1))
            wild = (int)below(5) * 10;
    }
    wild = 0;
    end_round();
}

int main(int argc, char **argv)
{
    int calls = argc > 3 ? atoi(argv[3]) : 2000, rounds = argc > 4 ? atoi(argv[4]) : 3;
    size_t settled = 0, now = 0;
    int i;

    folder = argc > 1 ? argv[1] : ".";
    if (argc > 2)
        seed = strtoull(argv[2], NULL, 0);
    draw_seed(seed);
    signal(SIGSEGV, on_signal);
    signal(SIGABRT, on_signal);
    if (__sanitizer_set_death_callback != NULL)
        __sanitizer_set_death_callback(tell_the_seed);
    display_there = windows_may_go = hands_connect();
    if (!display_there && getenv("DISPLAY") != NULL)
        fault("there is no X server at %s", getenv("DISPLAY"));
    within_callback = within;
    check_names();
    if (display_there) { /* what is read when the first sign is typed is kept for good */
        struct window first;
        fresh_things(); /* its callbacks call, too */
        first = open_editor();
        hands_type(first.shown);
        settle();
        v_editor_close(first.editor);
    }
    for (i = 0; i < rounds && faults == 0; i++) {
        round_of(i, calls);
        now = in_use();
        if (i == rounds / 2)
            settled = now; /* what is kept for good is there by now */
    }
    hands_leave();
    printf("hostile:");
    for (i = 0; i < CALLBACKS; i++) {
        printf(" %s %ld,", callback_names[i], callback_count[i]);
        if (display_there && callback_count[i] == 0)
            fault("%s was never called", callback_names[i]);
    }
    if (faults > 0)
        tell_the_seed();
    if (now > settled + (256 << 10)) {
        fprintf(stderr, "hostile: memory in use grows from %lu to %lu; seed %llu\n",
                (unsigned long)settled, (unsigned long)now, seed);
        faults++;
    }
    printf(" seed %llu, %d rounds of %d calls, %d faults, %lu bytes in use\n", seed,
           rounds, calls, faults, (unsigned long)now);
    return faults != 0;
}
