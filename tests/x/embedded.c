/*
 * A host in whose window the editor lives: see what it checks. Its Xlib has the error
 * handler that ends the program. Says "unsaved" when there is work that is not, and goes on
 * when a line comes.
 */
#include <poll.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include <X11/Xlib.h>
#include <X11/Xutil.h>

#include <libvides.h>

#define SECONDS 60.0

static Display *display;
static int asked;

static int on_close(V_EDITOR *editor, void *user)
{
    (void)editor, (void)user;
    asked++;
    return 1;
}

static void check(int truth, const char *what)
{
    if (!truth) {
        fprintf(stderr, "embedded: %s; %s\n", what, v_last_error());
        exit(1);
    }
}

static double now(void)
{
    struct timespec time;

    clock_gettime(CLOCK_MONOTONIC, &time);
    return time.tv_sec + time.tv_nsec * 1e-9;
}

/* Serves the editor for so many seconds; how many windows are left. */
static int serve(double seconds)
{
    double end = now() + seconds;
    int left;

    do {
        struct pollfd watch;

        watch.fd = v_fd();
        watch.events = POLLIN;
        poll(&watch, 1, 5);
        left = v_dispatch();
    } while (now() < end);
    return left;
}

static Window focus(void)
{
    Window window;
    int revert;

    XGetInputFocus(display, &window, &revert);
    return window;
}

static Window top_level(void)
{
    XSetWindowAttributes own;
    XVisualInfo visual;
    Window window;

    /* Transparent, as GTK's are. */
    check(XMatchVisualInfo(display, DefaultScreen(display), 32, TrueColor, &visual), "no 32 bits");
    own.border_pixel = 0;
    own.colormap = XCreateColormap(display, DefaultRootWindow(display), visual.visual, AllocNone);
    window = XCreateWindow(display, DefaultRootWindow(display), 0, 0, 900, 700, 0, 32, InputOutput,
                           visual.visual, CWBorderPixel | CWColormap, &own);
    XMapWindow(display, window);
    XSync(display, False);
    return window;
}

static V_EDITOR *editor_in(Window parent)
{
    V_EDITOR_OPTIONS options;
    V_EDITOR *editor = NULL;

    v_editor_options_init(&options);
    options.parent = parent;
    options.on_close = on_close;
    check(v_editor_open(&options, &editor) == V_OK, "no editor");
    return editor;
}

static Window child_of(Window parent)
{
    Window root, above, *children, child;
    unsigned count;

    check(XQueryTree(display, parent, &root, &above, &children, &count) && count == 1, "no child");
    child = children[0];
    XFree(children);
    return child;
}

static void refused(unsigned long parent, unsigned long owner, int status)
{
    V_EDITOR_OPTIONS options;
    V_EDITOR *editor = NULL;

    v_editor_options_init(&options);
    options.parent = parent;
    options.transient_for = owner;
    check(v_editor_open(&options, &editor) == status && editor == NULL, "it is not refused");
    check(strlen(v_last_error()) > 20, "no sentence");
}

static void click(Window window)
{
    XEvent event;

    memset(&event, 0, sizeof event);
    event.type = ButtonPress;
    event.xbutton.window = window;
    event.xbutton.root = DefaultRootWindow(display);
    event.xbutton.x = event.xbutton.y = 400;
    event.xbutton.button = 1;
    event.xbutton.same_screen = True;
    XSendEvent(display, window, False, NoEventMask, &event);
    event.type = ButtonRelease;
    XSendEvent(display, window, False, NoEventMask, &event);
    XSync(display, False);
}

int main(void)
{
    static const double summit[3] = {0, 0.6, -0.2};
    XWindowAttributes size;
    Window host, window;
    V_EDITOR *editor;
    V_PATH *path;
    double end;
    Pixmap pixmap;

    display = XOpenDisplay(NULL);
    check(display != NULL, "no display");
    host = top_level();
    pixmap = XCreatePixmap(display, host, 8, 8, 32);
    XSync(display, False);
    refused(pixmap, 0, V_ERR_ARGUMENT);
    refused(1, 0, V_ERR_ARGUMENT);
    refused(DefaultRootWindow(display), 0, V_ERR_ARGUMENT);
    refused(0, pixmap, V_ERR_ARGUMENT);
    refused(0, 0x1FFFFFFF, V_ERR_ARGUMENT);
    refused(~0UL, 0, V_ERR_RANGE);
    refused(0, ~0UL, V_ERR_RANGE);

    editor = editor_in(host);
    window = child_of(host);
    XResizeWindow(display, host, 1111, 777);
    XSync(display, False);
    for (end = now() + SECONDS;;) {
        serve(0.02);
        XGetWindowAttributes(display, window, &size);
        if (size.width == 1111 && size.height == 777)
            break;
        check(now() < end, "it does not follow");
    }
    check(size.depth == DefaultDepth(display, DefaultScreen(display)), "a copied depth");

    /* The keyboard, and again from a toolkit that takes it back. */
    XSetInputFocus(display, host, RevertToParent, CurrentTime);
    click(window);
    for (end = now() + SECONDS; focus() != window; serve(0.02))
        check(now() < end, "a click does not take the keyboard");
    XSetInputFocus(display, host, RevertToParent, CurrentTime);
    for (end = now() + SECONDS; focus() != window; serve(0.02))
        check(now() < end, "it does not take the keyboard again");

    check(v_editor_get_path(editor, &path) == V_OK && v_path_insert_point(path, 1, summit) == V_OK
              && v_editor_set_path(editor, path) == V_OK, "another path");
    v_path_free(path);
    puts("unsaved");
    fflush(stdout);
    while (poll(&(struct pollfd){0, POLLIN, 0}, 1, 0) == 0)
        serve(0.02);

    XDestroyWindow(display, host);
    XSync(display, False);
    for (end = now() + SECONDS; serve(0.02) > 0;)
        check(now() < end, "it outlives its parent");
    check(v_editor_get_path(editor, &path) == V_ERR_CLOSED
              && strstr(v_last_error(), "destroyed") != NULL, "the handle");
    check(v_editor_close(editor) == V_OK && asked == 0, "on_close is asked");

    host = top_level();
    editor = editor_in(host);
    window = child_of(host);
    serve(0.1);
    XReparentWindow(display, window, DefaultRootWindow(display), 0, 0);
    XSync(display, False);
    for (end = now() + SECONDS; serve(0.02) > 0;)
        check(now() < end, "it lives on the root");
    check(v_editor_close(editor) == V_OK && asked == 0, "on_close is asked");
    XCloseDisplay(display);
    return 0;
}
