/*
 * A host that draws in the camera pane, whatever becomes of the window around it:
 *
 *     pane ROUNDS glx|xlib|direct [cut]
 *
 * In each round an editor is opened, resized, its pane closed and opened again, and
 * closed, in turn by the host, by its user, by a window manager that kills it or, with
 * `cut`, by its connections being cut. All the while the host draws: by OpenGL or Xlib in a
 * child of its own, or directly in the pane, and goes on for a while in what it was told
 * is closed. Its Xlib has the error handler that ends the program. Ends with 0 if
 * every pane was announced, filled and taken back.
 */
#include <poll.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include <GL/gl.h>
#include <GL/glx.h>
#include <X11/Xlib.h>
#include <X11/keysym.h>

#include <libvides.h>

#define RED 0xFF0000
#define SECONDS 60.0 /* for what must happen; machines may be busy */

enum way { BY_GLX, BY_XLIB, DIRECTLY };

static Display *display;
static enum way way;
static XVisualInfo *visual;
static GLXContext context;
static GC gc;
static Window pane, child; /* as the host knows them */
static Window last;        /* where it drew last */
static int width, height, calls, closed_calls;

static double now(void)
{
    struct timespec time;

    clock_gettime(CLOCK_MONOTONIC, &time);
    return time.tv_sec + time.tv_nsec * 1e-9;
}

static void fail(const char *what)
{
    fprintf(stderr, "pane: %s; %s\n", what, v_last_error());
    exit(1);
}

/* Paints all of where it draws red. */
static void draw(void)
{
    if (last == None)
        return;
    if (way == BY_GLX) {
        glXMakeCurrent(display, last, context);
        glViewport(0, 0, width, height);
        glClearColor(1.0f, 0.0f, 0.0f, 1.0f);
        glClear(GL_COLOR_BUFFER_BIT);
        glXSwapBuffers(display, last);
    } else {
        XFillRectangle(display, last, gc, 0, 0, (unsigned)width, (unsigned)height);
    }
    XSync(display, False);
}

static void make_child(void)
{
    XSetWindowAttributes own;

    own.border_pixel = 0;
    own.colormap = XCreateColormap(display, DefaultRootWindow(display), visual->visual, AllocNone);
    /* 3 x 5: it is the editor that gives it the pane's size. */
    child = XCreateWindow(display, pane, 0, 0, 3, 5, 0, visual->depth, InputOutput, visual->visual,
                          CWBorderPixel | CWColormap, &own);
    XMapWindow(display, child);
    last = child;
}

static void on_pane(V_EDITOR *editor, unsigned long window, int w, int h, void *user)
{
    (void)editor, (void)user;
    calls++;
    if (window == 0) {
        closed_calls++;
        draw(); /* what it was drawing when it learns of it */
        pane = None;
        return;
    }
    if (pane == None && child != None && rand() % 2 == 0) { /* the old one again */
        XReparentWindow(display, child, window, 0, 0);
        XMapWindow(display, child);
    } else if (pane == None && child != None) {
        if (way == BY_GLX)
            glXMakeCurrent(display, None, NULL);
        XDestroyWindow(display, child);
        child = last = None;
    }
    pane = window;
    width = w, height = h;
    if (way == DIRECTLY)
        last = pane;
    else if (child == None)
        make_child();
    draw();
}

static void serve(void)
{
    struct pollfd watch;

    watch.fd = v_fd();
    watch.events = POLLIN;
    poll(&watch, 1, 2);
    v_dispatch();
    draw();
}

/* Serves until the pane is open, or closed, or was told of more than `before`. */
static void until(int open, int before, const char *what)
{
    double end = now() + SECONDS;

    while ((pane != None) != open || calls <= before) {
        serve();
        if (now() > end)
            fail(what);
    }
}

static Window parent_of(Window window)
{
    Window root, parent, *children;
    unsigned count;

    if (!XQueryTree(display, window, &root, &parent, &children, &count))
        fail("no such window");
    if (children != NULL)
        XFree(children);
    return parent;
}

/* The colour in the middle of the pane, as a person sees it. */
static unsigned long seen(void)
{
    Window root = DefaultRootWindow(display), none;
    XImage *image;
    unsigned long colour;
    int x, y;

    XTranslateCoordinates(display, pane, root, width / 2, height / 2, &x, &y, &none);
    image = XGetImage(display, root, x, y, 1, 1, AllPlanes, ZPixmap);
    colour = XGetPixel(image, 0, 0) & 0xFFFFFF;
    XDestroyImage(image);
    return colour;
}

/* What a window manager or a hand sends. */
static void send_event(Window window, XEvent *event, int type)
{
    event->type = type;
    event->xany.window = window;
    event->xany.display = display;
    XSendEvent(display, window, False, NoEventMask, event);
}

static void press_f4(Window window)
{
    XEvent event;

    memset(&event, 0, sizeof event);
    event.xfocus.detail = NotifyNonlinear;
    send_event(window, &event, FocusIn);
    memset(&event, 0, sizeof event);
    event.xkey.root = DefaultRootWindow(display);
    event.xkey.keycode = XKeysymToKeycode(display, XK_F4);
    event.xkey.same_screen = True;
    send_event(window, &event, KeyPress);
    send_event(window, &event, KeyRelease);
    XSync(display, False);
}

static void ask_to_close(Window window)
{
    XEvent event;

    memset(&event, 0, sizeof event);
    event.xclient.message_type = XInternAtom(display, "WM_PROTOCOLS", False);
    event.xclient.format = 32;
    event.xclient.data.l[0] = (long)XInternAtom(display, "WM_DELETE_WINDOW", False);
    send_event(window, &event, ClientMessage);
    XSync(display, False);
}

static void work(int number, int cut)
{
    V_EDITOR_OPTIONS options;
    V_EDITOR *editor;
    Window window, old;
    double end;
    int i, before;

    v_editor_options_init(&options);
    options.on_pane = on_pane;
    options.hand_over_saves = 1;
    if (v_editor_open(&options, &editor) != V_OK)
        fail("no editor");
    until(1, calls, "no pane");
    window = parent_of(pane);
    for (end = now() + SECONDS; seen() != RED; serve())
        if (now() > end)
            fail("the pane is not filled");
    for (i = 0; i < 3; i++) {
        before = calls;
        /* Large and small: where its widest is, the pane keeps its size. */
        XResizeWindow(display, window, (unsigned)(i % 2 ? 1100 + rand() % 100 : 810 + rand() % 60),
                      (unsigned)(610 + rand() % 200));
        XSync(display, False);
        until(1, before, "the pane keeps its size");
    }
    if (number % 4 == 1) {
        old = pane;
        press_f4(window);
        until(0, calls, "the pane is not closed");
        if (parent_of(old) != DefaultRootWindow(display))
            fail("a closed pane is not put away");
        for (i = 0; i < 5; i++)
            draw();
        press_f4(window);
        until(1, calls, "the pane does not come back");
        if (pane != old)
            fail("another pane");
    }
    old = pane;
    if (cut) {
        if (number % 4 == 3 && way != DIRECTLY) { /* the one that panes belong to */
            XKillClient(display, pane);
            XSync(display, False);
            for (i = 0; i < 5; i++)
                draw();
            before = calls;
            until(1, before + 1, "no other pane");
        }
        XKillClient(display, window);
        XSync(display, False);
        for (i = 0; i < 5; i++)
            draw();
        until(0, calls, "nobody says that the pane is gone");
        v_editor_close(editor);
    } else if (number % 3 == 0) {
        if (v_editor_close(editor) != V_OK || pane != None)
            fail("v_editor_close");
    } else if (number % 3 == 1) {
        ask_to_close(window);
        until(0, calls, "its user cannot close it");
        v_editor_close(editor);
    } else { /* somebody means it ill: the pane goes with all that is in it */
        glXMakeCurrent(display, None, NULL);
        XDestroySubwindows(display, window);
        XSync(display, False);
        child = last = None;
        until(1, calls + 1, "no other pane");
        v_editor_close(editor);
    }
    if (v_dispatch() != 0)
        fail("a window is left");
    draw();
}

int main(int argc, char **argv)
{
    static int wanted[] = {GLX_RGBA, GLX_DOUBLEBUFFER, None};
    int rounds = argc > 2 ? atoi(argv[1]) : 0, done;

    if (rounds < 1 || (display = XOpenDisplay(NULL)) == NULL)
        fail("pane ROUNDS glx|xlib|direct [cut]");
    way = strcmp(argv[2], "glx") == 0 ? BY_GLX : strcmp(argv[2], "xlib") == 0 ? BY_XLIB : DIRECTLY;
    visual = glXChooseVisual(display, DefaultScreen(display), wanted);
    if (visual == NULL)
        fail("no OpenGL");
    if (way == BY_GLX)
        context = glXCreateContext(display, visual, NULL, True);
    gc = XCreateGC(display, DefaultRootWindow(display), 0, NULL);
    XSetForeground(display, gc, RED);
    for (done = 0; done < rounds; done++)
        work(done, argc > 3);
    printf("%d rounds, told %d times, of %d closings\n", rounds, calls, closed_calls);
    return 0;
}
