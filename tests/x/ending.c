/*
 * A host that ends in the way that its argument says, as soon as a line comes on
 * standard input: what becomes of the unsaved work in its window?
 */
#include <poll.h>
#include <pthread.h>
#include <semaphore.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

#include <X11/Xlib.h>

#include <libvides.h>

static Display *display;
static sem_t told;

static void say(const char *word)
{
    printf("%s\n", word);
    fflush(stdout);
}

/* Serves the window, and Xlib, until there is a line on standard input. */
static void serve(void)
{
    struct pollfd watch[3];
    char line[80];

    watch[0].fd = STDIN_FILENO;
    watch[1].fd = ConnectionNumber(display);
    watch[2].fd = v_fd();
    watch[0].events = watch[1].events = watch[2].events = POLLIN;
    for (;;) {
        XEvent event;
        while (XPending(display) > 0)
            XNextEvent(display, &event);
        v_dispatch();
        poll(watch, 3, v_timeout());
        if (watch[0].revents && fgets(line, sizeof line, stdin))
            return;
    }
}

static void open_window(void)
{
    v_haupt(100, 100, 100, 100, NULL, 0, NULL, NULL, NULL);
    say("open");
    serve();
}

static void *thread_with_window(void *unused)
{
    open_window();
    return unused;
}

/* It says that there was a line and serves its window on: it ends with its program. */
static void *thread_that_goes_on(void *unused)
{
    open_window();
    sem_post(&told);
    serve();
    return unused;
}

static void *thread_that_exits(void *unused)
{
    (void)unused;
    exit(0);
}

static void crash(void)
{
    abort();
}

int main(int count, char **words)
{
    const char *way = count > 1 ? words[1] : "";
    pthread_t thread;

    display = XOpenDisplay(NULL);
    if (!display)
        return 99;
    XMapWindow(display, XCreateSimpleWindow(display, DefaultRootWindow(display), 0, 0, 50, 50, 0, 0, 0));
    if (!strncmp(way, "thread", 6)) {
        if (!strcmp(way, "thread-ends")) {
            pthread_create(&thread, NULL, thread_with_window, NULL);
            pthread_join(thread, NULL);
            say("thread ended");
        } else {
            sem_init(&told, 0, 0);
            pthread_create(&thread, NULL, thread_that_goes_on, NULL);
            sem_wait(&told);
        }
        return 0;
    }
    open_window();
    if (!strcmp(way, "exit"))
        exit(0);
    if (!strcmp(way, "failure"))
        exit(3);
    if (!strcmp(way, "other-thread-exits")) {
        pthread_create(&thread, NULL, thread_that_exits, NULL);
        pthread_join(thread, NULL);
    }
    if (!strcmp(way, "closed-display"))
        XCloseDisplay(display);
    if (!strcmp(way, "_exit"))
        _exit(0);
    if (!strcmp(way, "abort"))
        abort();
    if (!strcmp(way, "segv"))
        raise(SIGSEGV);
    if (!strcmp(way, "term"))
        raise(SIGTERM);
    if (!strcmp(way, "crash-in-atexit"))
        atexit(crash);
    if (!strcmp(way, "child")) {
        /* A child's end is not ours. */
        pid_t child = fork();
        if (child == 0)
            exit(0);
        waitpid(child, NULL, 0);
        raise(SIGKILL);
    }
    return 0;
}
