/*
 * Threads of the library's own: none, but for one while it asks the system for
 * the address of a display on another machine. That one takes no signal of the
 * host's, and ends with the answer.
 *
 * The program's own pthread_create counts them.
 */
#define _GNU_SOURCE
#include <dlfcn.h>
#include <pthread.h>
#include <signal.h>
#include <unistd.h>

#include "check.h"

typedef int create(pthread_t *, const pthread_attr_t *, void *(*)(void *), void *);

static int started, ended, signals_let_in;

struct work {
    void *(*run)(void *);
    void *argument;
};

static void *watched(void *given)
{
    struct work work = *(struct work *)given;
    sigset_t mask;
    int number;
    void *result;

    free(given);
    pthread_sigmask(SIG_BLOCK, NULL, &mask);
    for (number = 1; number < 32; number++)
        if (number != SIGKILL && number != SIGSTOP && !sigismember(&mask, number))
            __sync_fetch_and_add(&signals_let_in, 1);
    result = work.run(work.argument);
    __sync_fetch_and_add(&ended, 1);
    return result;
}

int pthread_create(pthread_t *thread, const pthread_attr_t *how, void *(*run)(void *), void *argument)
{
    create *real = (create *)dlsym(RTLD_NEXT, "pthread_create");
    struct work *work = malloc(sizeof *work);

    work->run = run;
    work->argument = argument;
    __sync_fetch_and_add(&started, 1);
    return real(thread, how, watched, work);
}

/* Opens a window on a display where there is no server; it must be told. */
static int threads_for(const char *display)
{
    V_EDITOR_OPTIONS options;
    V_EDITOR *editor = NULL;
    int before = started;

    memset(&options, 0, sizeof options);
    options.size = sizeof options;
    options.display = display;
    STATUS(V_ERR_DISPLAY, v_editor_open(&options, &editor));
    return started - before;
}

int main(void)
{
    static const char *const known[] = {
        ":59535", "unix:59534", "localhost:59534", "127.0.0.1:59534", "[::1]:59534", "no display",
    };
    char name[300];
    size_t k;
    int tries;

    for (k = 0; k < sizeof known / sizeof *known; k++)
        CHECK(threads_for(known[k]) == 0);

    /* A name: this machine's, then one that nobody has. */
    CHECK(gethostname(name, 256) == 0);
    strcat(name, ":59534");
    CHECK(threads_for(name) == 1);
    CHECK(threads_for("nobody.invalid:0") == 1);
    CHECK(signals_let_in == 0);
    for (tries = 0; ended < started && tries < 600; tries++)
        usleep(100000);
    CHECK(ended == started);
    return failures != 0;
}
