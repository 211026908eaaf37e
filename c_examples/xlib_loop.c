/*
 * xlib_loop: the editor under the event loop of a plain Xlib program.
 *
 *     cc -o xlib_loop xlib_loop.c -lvides -lm -lX11
 *
 * A click into the window opens an editor, a key ends the program. The window
 * prints the number of poses of the last hand-over. Where it would block in
 * XNextEvent(), it waits for the library's descriptor, too.
 */
#include <poll.h>
#include <stdio.h>
#include <string.h>

#include <X11/Xlib.h>

#include <libvides.h>

static Display *display;
static Window window;
static char text[80] = "Click: edit a camera path";
static V_KAMERAPAR list;

static void draw(void)
{
    XClearWindow(display, window);
    XDrawString(display, window, DefaultGC(display, DefaultScreen(display)),
                20, 40, text, (int)strlen(text));
}

/* Runs within v_dispatch(), so it may draw as any other code of ours. */
static void rueck(V_KAMERAPAR *daten, int anzahl)
{
    (void)daten;
    sprintf(text, "%d poses", anzahl);
    draw();
}

int main(void)
{
    struct pollfd watch[2];
    XEvent event;
    int screen;

    display = XOpenDisplay(NULL);
    if (display == NULL) {
        fprintf(stderr, "xlib_loop: no X server\n");
        return 1;
    }
    screen = DefaultScreen(display);
    window = XCreateSimpleWindow(display, RootWindow(display, screen), 0, 0, 240, 70, 0,
                                 BlackPixel(display, screen), WhitePixel(display, screen));
    XStoreName(display, window, "xlib_loop");
    XSelectInput(display, window, ExposureMask | ButtonPressMask | KeyPressMask);
    XMapWindow(display, window);
    list.number = -1; /* no poses yet */

    watch[0].fd = ConnectionNumber(display);
    watch[1].fd = v_fd();
    watch[0].events = watch[1].events = POLLIN;
    do {
        while (!XPending(display)) /* also sends what was drawn */
            if (poll(watch, 2, -1) > 0 && watch[1].revents)
                v_dispatch();
        XNextEvent(display, &event);
        if (event.type == Expose)
            draw();
        else if (event.type == ButtonPress)
            v_haupt(100, 100, 100, 100, &list, 0, NULL, rueck, NULL);
    } while (event.type != KeyPress);

    v_free_liste(&list);
    XCloseDisplay(display);
    return 0;
}
