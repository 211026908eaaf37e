/*
 * The told host under Xt, in one of the ways in which programs begin:
 *
 *     initialize    XtInitialize, XtMainLoop: Xt's default context
 *     app           XtAppInitialize, XtAppMainLoop
 *     open          XtOpenApplication, XtAppMainLoop
 *     two [DISPLAY] two contexts, of which the second runs, on DISPLAY; told "third DISPLAY"
 *                   a third one is made, and ended when told "end-third"
 *     late          a context made when told "context", after the first window;
 *                   announced to the library when told "announce"
 *
 * Told "timeout" or "work", it opens a window in such a procedure of Xt's.
 *
 * Nothing here serves the library.
 */
#include <poll.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <X11/Intrinsic.h>
#include <X11/Shell.h>
#include <X11/StringDefs.h>

#include <libvides.h>

#include "host.h"

static XtAppContext context, third;
static int count;
static char **arguments;

static void input(XtPointer data, int *source, XtInputId *id)
{
    (void)data, (void)source, (void)id;
    commands();
}

static void show(Widget top)
{
    Arg size[2];

    XtSetArg(size[0], XtNwidth, 60);
    XtSetArg(size[1], XtNheight, 40);
    XtSetValues(top, size, 2);
    XtRealizeWidget(top);
}

static void watch_input(void)
{
    XtAppAddInput(context, 0, (XtPointer)XtInputReadMask, input, NULL);
}

static void open_window(void)
{
    V_EDITOR *editor = NULL;
    say("opened %d", v_editor_open(NULL, &editor));
}

static void on_timeout(XtPointer data, XtIntervalId *id)
{
    (void)data, (void)id;
    open_window();
}

static Boolean on_work(XtPointer data)
{
    (void)data;
    open_window();
    return True;
}

int loop_command(const char *name, char *rest)
{
    if (strcmp(name, "timeout") == 0) {
        XtAppAddTimeOut(context, 10, on_timeout, NULL);
        return 1;
    }
    if (strcmp(name, "work") == 0) {
        XtAppAddWorkProc(context, on_work, NULL);
        return 1;
    }
    if (strcmp(name, "context") == 0) {
        show(XtAppInitialize(&context, "Host", NULL, 0, &count, arguments, NULL, NULL, 0));
        say("context");
        return 1;
    }
    if (strcmp(name, "announce") == 0) {
        say("announced %d %s", v_set_app_context(context), v_last_error());
        return 1;
    }
    if (strcmp(name, "third") == 0) {
        third = XtCreateApplicationContext();
        say("third %d", XtOpenDisplay(third, rest, "host", "Host", NULL, 0, &count, arguments) != NULL);
        return 1;
    }
    if (strcmp(name, "end-third") == 0) {
        XtDestroyApplicationContext(third);
        say("end-third");
        return 1;
    }
    return 0;
}

int main(int argc, char **argv)
{
    const char *way = argc > 1 ? argv[1] : "initialize";
    XtAppContext other;

    begin();
    count = argc;
    arguments = argv;
    if (strcmp(way, "initialize") == 0) {
        Widget top = XtInitialize(argv[0], "Host", NULL, 0, &argc, argv);
        context = XtWidgetToApplicationContext(top);
        show(top);
        XtAddInput(0, (XtPointer)XtInputReadMask, input, NULL);
        XtMainLoop();
    } else if (strcmp(way, "app") == 0) {
        show(XtAppInitialize(&context, "Host", NULL, 0, &argc, argv, NULL, NULL, 0));
        watch_input();
        XtAppMainLoop(context);
    } else if (strcmp(way, "open") == 0) {
        show(XtOpenApplication(&context, "Host", NULL, 0, &argc, argv, NULL,
                               applicationShellWidgetClass, NULL, 0));
        watch_input();
        XtAppMainLoop(context);
    } else if (strcmp(way, "two") == 0) {
        XtAppInitialize(&other, "Other", NULL, 0, &argc, argv, NULL, NULL, 0);
        context = XtCreateApplicationContext();
        XtOpenDisplay(context, argc > 2 ? argv[2] : NULL, "host", "Host", NULL, 0, &argc, argv);
        watch_input();
        XtAppMainLoop(context);
    } else if (strcmp(way, "late") == 0) {
        XtToolkitInitialize();
        while (context == NULL)
            commands();
        watch_input();
        XtAppMainLoop(context);
    }
    return 2;
}
