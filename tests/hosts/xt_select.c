/* Hosts with Xt that draw steadily: a click opens the editor, Escape ends.
 *
 *     xt_select            waits by itself, with select()
 *     xt_select pending    asks by XtAppPending() whether there is something to do; for
 *                          the editor it does nothing
 *     xt_select both       asks so, and waits by itself between
 */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/select.h>
#include <unistd.h>

#include <X11/Intrinsic.h>
#include <X11/Shell.h>
#include <X11/StringDefs.h>
#include <X11/keysym.h>

#include <libvides.h>

static V_KAMERAPAR list;
static int turn;

static void rueck(V_KAMERAPAR *poses, int count)
{
    (void)poses;
    printf("%d poses\n", count);
    fflush(stdout);
}

static void input(Widget top, XtPointer data, XEvent *event, Boolean *further)
{
    (void)top, (void)data, (void)further;
    if (event->type == ButtonPress)
        v_haupt(100, 100, 100, 100, &list, 0, NULL, rueck, NULL);
    else if (XLookupKeysym(&event->xkey, 0) == XK_Escape)
        exit(0);
}

static void draw(Display *display, Window window)
{
    turn = (turn + 5) % 300;
    XClearWindow(display, window);
    XFillRectangle(display, window, DefaultGC(display, DefaultScreen(display)), turn, 20, 40, 40);
}

static void loop_pending(XtAppContext context, Display *display, Window window)
{
    XEvent event;

    for (;;) {
        while (XtAppPending(context)) {
            XtAppNextEvent(context, &event);
            XtDispatchEvent(&event);
        }
        draw(display, window);
        XFlush(display);
        usleep(20000);
    }
}

static void loop_select(XtAppContext context, Display *display, Window window)
{
    int own = ConnectionNumber(display), last;
    fd_set readable;

    for (;;) {
        struct timeval wait = {0, 40000};

        while (XtAppPending(context) & XtIMXEvent)
            XtAppProcessEvent(context, XtIMXEvent);
        draw(display, window);
        XFlush(display);

        FD_ZERO(&readable);
        FD_SET(own, &readable);
        FD_SET(v_fd(), &readable);
        last = own > v_fd() ? own : v_fd();
        if (select(last + 1, &readable, NULL, NULL, &wait) > 0 && FD_ISSET(v_fd(), &readable))
            v_dispatch();
    }
}

static void loop_both(XtAppContext context, Display *display, Window window)
{
    int own = ConnectionNumber(display), last;
    fd_set readable;

    for (;;) {
        struct timeval wait = {0, 100000};

        while (XtAppPending(context))
            XtAppProcessEvent(context, XtIMAll);
        draw(display, window);
        XFlush(display);

        FD_ZERO(&readable);
        FD_SET(own, &readable);
        FD_SET(v_fd(), &readable);
        last = own > v_fd() ? own : v_fd();
        select(last + 1, &readable, NULL, NULL, &wait);
    }
}

int main(int argc, char **argv)
{
    XtAppContext context;
    Widget top = XtOpenApplication(&context, "Host", NULL, 0, &argc, argv, NULL,
                                   applicationShellWidgetClass, NULL, 0);

    list.number = -1; /* no poses yet */
    XtVaSetValues(top, XtNtitle, "xt_select", XtNwidth, 360, XtNheight, 120, NULL);
    XtAddEventHandler(top, ButtonPressMask | KeyPressMask, False, input, NULL);
    XtRealizeWidget(top);
    if (argc > 1 && strcmp(argv[1], "pending") == 0)
        loop_pending(context, XtDisplay(top), XtWindow(top));
    if (argc > 1 && strcmp(argv[1], "both") == 0)
        loop_both(context, XtDisplay(top), XtWindow(top));
    loop_select(context, XtDisplay(top), XtWindow(top));
}
