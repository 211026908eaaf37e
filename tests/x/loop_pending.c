/*
 * The told host in a loop of its own over Xt, which draws between its rounds or
 * sleeps where Xt does not:
 *
 *     next      XtAppPending, XtAppNextEvent, XtDispatchEvent; then it draws
 *     process   XtAppPending, XtAppProcessEvent; then it draws
 *     threads   as next, after XtToolkitThreadInitialize
 *     displays  as next, with a second display in the same context
 *     blocked   XtAppNextEvent, XtDispatchEvent, as XtAppMainLoop has them
 *     one       XtAppProcessEvent alone
 *     select    select() over its X connection, and Xt's functions when that is
 *               readable, as terminal programs do
 *
 * "gap" tells since it was asked last by how many milliseconds in all rounds came later
 * than STALL after the one before, how late the latest came, and how many events for no window the host has been given in all. Where Xt
 * sleeps, a timer of Xt's makes the rounds after "tick".
 */
#include <poll.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/select.h>
#include <time.h>
#include <unistd.h>

#include <X11/Intrinsic.h>
#include <X11/Shell.h>
#include <X11/StringDefs.h>

#include <libvides.h>

#include "host.h"

static XtAppContext context;
static Display *display;
/* From here on one sees that a picture comes late, ms. */
#define STALL 100

static double last, longest, stalled;
static long empty;

static double now(void)
{
    struct timespec time;

    clock_gettime(CLOCK_MONOTONIC, &time);
    return 1e3 * time.tv_sec + 1e-6 * time.tv_nsec;
}

/* One round of the loop. */
static void turn(void)
{
    double time = now();

    if (last > 0 && time - last > longest)
        longest = time - last;
    if (last > 0 && time - last > STALL)
        stalled += time - last - STALL;
    last = time;
}

static void tick(XtPointer data, XtIntervalId *id)
{
    (void)data, (void)id;
    turn();
    XtAppAddTimeOut(context, 20, tick, NULL);
}

int loop_command(const char *name, char *rest)
{
    (void)rest;
    if (strcmp(name, "gap") == 0) {
        say("gap %.1f longest %.1f events %ld", stalled, longest, empty);
        longest = stalled = last = 0;
        return 1;
    }
    if (strcmp(name, "tick") == 0) {
        tick(NULL, NULL);
        say("tick");
        return 1;
    }
    return 0;
}

static void input(XtPointer data, int *source, XtInputId *id)
{
    (void)data, (void)source, (void)id;
    commands();
}

static void next_event(void)
{
    XEvent event;

    XtAppNextEvent(context, &event);
    if (event.xany.window == None)
        empty++;
    XtDispatchEvent(&event);
}

/* Commands by a poll of its own: no input of Xt's but the library's. */
static void look_for_commands(void)
{
    struct pollfd watch;

    watch.fd = 0;
    watch.events = POLLIN;
    if (poll(&watch, 1, 0) > 0)
        commands();
}

static void own_select(void)
{
    int connection = ConnectionNumber(display);
    fd_set readable;

    for (;;) {
        XFlush(display);
        FD_ZERO(&readable);
        FD_SET(0, &readable);
        FD_SET(connection, &readable);
        if (!XtAppPending(context) && select(connection + 1, &readable, NULL, NULL, NULL) < 0)
            continue;
        while (XtAppPending(context) & XtIMXEvent)
            next_event();
        if (XtAppPending(context) & XtIMAlternateInput)
            XtAppProcessEvent(context, XtIMAlternateInput);
        look_for_commands();
    }
}

int main(int argc, char **argv)
{
    const char *way = argc > 1 ? argv[1] : "next";
    int process = strcmp(way, "process") == 0;
    Arg size[2];
    Widget top;

    begin();
    if (strcmp(way, "threads") == 0)
        XtToolkitThreadInitialize();
    top = XtAppInitialize(&context, "Host", NULL, 0, &argc, argv, NULL, NULL, 0);
    display = XtDisplay(top);
    XtSetArg(size[0], XtNwidth, 60);
    XtSetArg(size[1], XtNheight, 40);
    XtSetValues(top, size, 2);
    XtRealizeWidget(top);
    if (strcmp(way, "displays") == 0)
        XtOpenDisplay(context, NULL, "host", "Host", NULL, 0, &argc, argv);
    if (strcmp(way, "select") == 0)
        own_select();
    if (strcmp(way, "blocked") == 0 || strcmp(way, "one") == 0) {
        XtAppAddInput(context, 0, (XtPointer)XtInputReadMask, input, NULL);
        for (;;)
            if (strcmp(way, "one") == 0)
                XtAppProcessEvent(context, XtIMAll);
            else
                next_event();
    }
    for (;;) {
        while (XtAppPending(context))
            if (process)
                XtAppProcessEvent(context, XtIMAll);
            else
                next_event();
        look_for_commands();
        turn();
        usleep(20000); /* draws */
    }
}
