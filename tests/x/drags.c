/*
 * A file manager as small as can be: the files in its window can be dragged onto windows of
 * other programs (XDND 5), with the pointer, by whoever holds it.
 *
 *     drags URI...
 *
 * Its window is at the upper left of the screen. It says "ready", and after each drag
 * "dropped 1" if the files were taken, "dropped 0" if not.
 */
#include <stdio.h>
#include <string.h>

#include <X11/Xatom.h>
#include <X11/Xlib.h>

#define SIZE 60
#define VERSION 5

static Display *display;
static Window own, over; /* what the pointer is over that takes drops */
static Atom aware, enter, position, status, leave, drop, finished, selection, copy, uris;
static int waits, /* for the answer to a position */
    accepted, released;
static char list[8192];

static Atom atom(const char *name)
{
    return XInternAtom(display, name, False);
}

static void say(int taken)
{
    printf("dropped %d\n", taken);
    fflush(stdout);
    over = None;
}

static void send(Atom kind, long a, long b, long c, long d)
{
    XEvent event;

    memset(&event, 0, sizeof event);
    event.xclient.type = ClientMessage;
    event.xclient.window = over;
    event.xclient.message_type = kind;
    event.xclient.format = 32;
    event.xclient.data.l[0] = (long)own;
    event.xclient.data.l[1] = a;
    event.xclient.data.l[2] = b;
    event.xclient.data.l[3] = c;
    event.xclient.data.l[4] = d;
    XSendEvent(display, over, False, NoEventMask, &event);
}

static int is_aware(Window window)
{
    Atom type;
    int format, is;
    unsigned long count, rest;
    unsigned char *data = NULL;

    is = XGetWindowProperty(display, window, aware, 0, 1, False, XA_ATOM, &type, &format, &count,
                            &rest, &data) == Success && count == 1;
    if (data != NULL)
        XFree(data);
    return is;
}

/* The topmost window under the pointer, or one that it is in, that takes drops. */
static Window under_pointer(void)
{
    Window root, at = DefaultRootWindow(display), child;
    int x, y, in_x, in_y;
    unsigned buttons;

    while (XQueryPointer(display, at, &root, &child, &x, &y, &in_x, &in_y, &buttons)
           && child != None) {
        if (is_aware(child))
            return child;
        at = child;
    }
    return None;
}

static void moved(int x, int y, Time time)
{
    Window now = under_pointer();

    if (now != over) {
        if (over != None)
            send(leave, 0, 0, 0, 0);
        over = now;
        accepted = waits = 0;
        if (over != None)
            send(enter, (long)VERSION << 24, (long)uris, None, None);
    }
    if (over != None && !waits) {
        send(position, 0, (long)x << 16 | y, (long)time, (long)copy);
        waits = 1;
    }
}

/* Lets go as soon as the window has said whether it takes them. */
static void let_go(Time time)
{
    if (over == None) {
        say(0);
    } else if (waits) {
        released = 1;
    } else if (accepted) {
        send(drop, 0, (long)time, 0, 0);
    } else {
        send(leave, 0, 0, 0, 0);
        say(0);
    }
}

static void hand_over(const XSelectionRequestEvent *asked)
{
    XEvent answer;
    int knows = asked->target == uris && asked->property != None;

    if (knows)
        XChangeProperty(display, asked->requestor, asked->property, uris, 8, PropModeReplace,
                        (unsigned char *)list, (int)strlen(list));
    memset(&answer, 0, sizeof answer);
    answer.xselection.type = SelectionNotify;
    answer.xselection.requestor = asked->requestor;
    answer.xselection.selection = asked->selection;
    answer.xselection.target = asked->target;
    answer.xselection.property = knows ? asked->property : None;
    answer.xselection.time = asked->time;
    XSendEvent(display, asked->requestor, False, NoEventMask, &answer);
}

int main(int argc, char **argv)
{
    XSetWindowAttributes free_of_managers;
    XEvent event;
    Time time = CurrentTime;
    int i;

    for (i = 1; i < argc; i++)
        snprintf(list + strlen(list), sizeof list - strlen(list), "%s\r\n", argv[i]);
    display = XOpenDisplay(NULL);
    if (display == NULL)
        return 2;
    aware = atom("XdndAware"), enter = atom("XdndEnter"), position = atom("XdndPosition");
    status = atom("XdndStatus"), leave = atom("XdndLeave"), drop = atom("XdndDrop");
    finished = atom("XdndFinished"), selection = atom("XdndSelection");
    copy = atom("XdndActionCopy"), uris = atom("text/uri-list");
    free_of_managers.override_redirect = True;
    free_of_managers.event_mask = ButtonPressMask | ButtonReleaseMask | ButtonMotionMask | ExposureMask;
    own = XCreateWindow(display, DefaultRootWindow(display), 0, 0, SIZE, SIZE, 0, CopyFromParent,
                        InputOutput, CopyFromParent, CWOverrideRedirect | CWEventMask,
                        &free_of_managers);
    XMapRaised(display, own);
    for (;;) {
        XNextEvent(display, &event);
        if (event.type == Expose && event.xexpose.count == 0) {
            puts("ready");
            fflush(stdout);
        } else if (event.type == ButtonPress) {
            XSetSelectionOwner(display, selection, own, event.xbutton.time);
            released = 0;
        } else if (event.type == MotionNotify) {
            moved(event.xmotion.x_root, event.xmotion.y_root, event.xmotion.time);
        } else if (event.type == ButtonRelease) {
            moved(event.xbutton.x_root, event.xbutton.y_root, event.xbutton.time);
            time = event.xbutton.time;
            let_go(time);
        } else if (event.type == SelectionRequest) {
            hand_over(&event.xselectionrequest);
        } else if (event.type == ClientMessage && event.xclient.message_type == status) {
            waits = 0;
            accepted = (int)(event.xclient.data.l[1] & 1);
            if (released)
                let_go(time);
        } else if (event.type == ClientMessage && event.xclient.message_type == finished) {
            say((int)(event.xclient.data.l[1] & 1));
        }
    }
}
