/* Somebody at the windows: see hands.h. */
#include "hands.h"

#include <stdio.h>
#include <string.h>

#include <X11/XKBlib.h>
#include <X11/Xatom.h>
#include <X11/Xlib.h>
#include <X11/Xutil.h>
#include <X11/keysym.h>

static Display *display;

/* Windows go while they are asked: no error is worth a word. */
static int ignore(Display *of, XErrorEvent *error)
{
    (void)of, (void)error;
    return 0;
}

int hands_connect(void)
{
    display = XOpenDisplay(NULL);
    XSetErrorHandler(ignore);
    return display != NULL;
}

void hands_leave(void)
{
    if (display != NULL)
        XCloseDisplay(display);
    display = NULL;
}

static int is_ours(Window window)
{
    XClassHint hint = {NULL, NULL};
    int ours;

    if (!XGetClassHint(display, window, &hint))
        return 0;
    ours = hint.res_class != NULL && strcmp(hint.res_class, "Vides") == 0;
    XFree(hint.res_name);
    XFree(hint.res_class);
    return ours;
}

/* The window of this number, or none; how many there are. */
static Window find(int number, int *count)
{
    Window root, parent, *children = NULL, found = None;
    unsigned n = 0, i;

    *count = 0;
    if (display == NULL || !XQueryTree(display, DefaultRootWindow(display), &root, &parent, &children, &n))
        return None;
    for (i = 0; i < n; i++)
        if (is_ours(children[i]) && (*count)++ == number)
            found = children[i];
    if (children != NULL)
        XFree(children);
    return found;
}

int hands_count(void)
{
    int count;

    find(-1, &count);
    return count;
}

unsigned long hands_window(int number)
{
    int count;

    return find(number, &count);
}

static void send_event(Window window, XEvent *event)
{
    event->xany.window = window;
    event->xany.display = display;
    XSendEvent(display, window, False, NoEventMask, event);
}

static void key(Window window, KeySym sign, unsigned state)
{
    XEvent event;

    memset(&event, 0, sizeof event);
    event.type = KeyPress;
    event.xkey.root = DefaultRootWindow(display);
    event.xkey.state = state;
    event.xkey.keycode = XKeysymToKeycode(display, sign);
    event.xkey.same_screen = True;
    send_event(window, &event);
    event.type = KeyRelease;
    send_event(window, &event);
}

void hands_raise(unsigned long window)
{
    XRaiseWindow(display, window);
    hands_finish();
}

/* A key for a window that has the keyboard. */
static void press(Window window, KeySym sign, unsigned state)
{
    XEvent event;

    memset(&event, 0, sizeof event);
    event.type = FocusIn;
    event.xfocus.detail = NotifyNonlinear;
    send_event(window, &event);
    key(window, sign, state);
    hands_finish();
}

void hands_hand_over(unsigned long window)
{
    press(window, XK_u, Mod1Mask);
}

void hands_next_point(unsigned long window)
{
    press(window, XK_Next, ControlMask);
}

void hands_change(unsigned long window)
{
    press(window, XK_F6, 0); /* absolute or relative: there is no end to it */
}

void hands_take_over(unsigned long window)
{
    press(window, XK_Return, ControlMask);
}

void hands_type(unsigned long window)
{
    press(window, XK_n, 0);
}

void hands_switch_pane(unsigned long window)
{
    press(window, XK_F4, 0);
}

void hands_close(unsigned long window)
{
    XEvent event;

    memset(&event, 0, sizeof event);
    event.type = ClientMessage;
    event.xclient.message_type = XInternAtom(display, "WM_PROTOCOLS", False);
    event.xclient.format = 32;
    event.xclient.data.l[0] = (long)XInternAtom(display, "WM_DELETE_WINDOW", False);
    send_event(window, &event);
    hands_finish();
}

void hands_destroy(unsigned long window)
{
    XDestroyWindow(display, window);
    hands_finish();
}

void hands_kill(unsigned long window)
{
    XKillClient(display, window);
    hands_finish();
}

void hands_take_all(void)
{
    XGrabServer(display);
    hands_finish();
}

void hands_let_go(void)
{
    XUngrabServer(display);
    hands_finish();
}

void hands_finish(void)
{
    if (display != NULL)
        XSync(display, True);
}

/* Names that messages and selections may go by, and some that they may not. */
static Atom a_name(unsigned noise)
{
    static const char *const names[] = {
        "WM_PROTOCOLS", "_VIDES_SHOWN", "_VIDES_SELECTION", "CLIPBOARD", "PRIMARY", "UTF8_STRING",
        "TARGETS", "MULTIPLE", "INCR", "SAVE_TARGETS", "_NET_WM_PING", "RESOURCE_MANAGER"
    };
    const unsigned count = sizeof names / sizeof *names;

    return noise % (count + 2) < count ? XInternAtom(display, names[noise % (count + 2)], False)
                                       : noise;
}

/* The kinds of the core protocol, 2 to 34, those of extensions, and nonsense. */
int hands_kinds(void)
{
    return LASTEvent + 8;
}

/* A number that is small, near the window's size, or anything. */
static int some(unsigned noise)
{
    switch (noise % 4) {
    case 0:
        return (int)(noise >> 8) % 4;
    case 1:
        return (int)(noise >> 8) % 1200;
    case 2:
        return -(int)(noise >> 8) % 40;
    default:
        return (int)(noise >> 8) % 65536;
    }
}

void hands_send(unsigned long window, int kind, unsigned long long noise)
{
    unsigned a = (unsigned)noise, b = (unsigned)(noise >> 32), i;
    XEvent event;
    int type = kind < LASTEvent ? kind : 64 + (int)(a % 64);

    if (type == KeymapNotify || type == GenericEvent || type < KeyPress)
        type = MotionNotify;
    memset(&event, 0, sizeof event);
    event.type = type;
    switch (type) {
    case KeyPress:
    case KeyRelease:
        event.xkey.root = DefaultRootWindow(display);
        event.xkey.state = b & 0xFFFF;
        event.xkey.keycode = 8 + a % 248;
        event.xkey.time = b;
        event.xkey.same_screen = True;
        /* Alt-F4 and the like end what shall be flooded. */
        event.xkey.state &= a % 5 == 0 ? ~0u : ~(unsigned)(Mod1Mask | ControlMask);
        break;
    case ButtonPress:
    case ButtonRelease:
    case MotionNotify:
    case EnterNotify:
    case LeaveNotify:
        event.xbutton.root = DefaultRootWindow(display);
        event.xbutton.x = some(a);
        event.xbutton.y = some(b);
        event.xbutton.state = a >> 16;
        event.xbutton.time = b;
        event.xbutton.same_screen = True;
        if (type == ButtonPress || type == ButtonRelease)
            event.xbutton.button = b % 12;
        break;
    case FocusIn:
    case FocusOut:
        event.xfocus.mode = (int)(a % 5);
        event.xfocus.detail = (int)(b % 9);
        break;
    case Expose:
        event.xexpose.x = some(a);
        event.xexpose.y = some(b);
        event.xexpose.width = some(a >> 4);
        event.xexpose.height = some(b >> 4);
        break;
    case ConfigureNotify:
        event.xconfigure.event = window;
        event.xconfigure.x = some(a);
        event.xconfigure.y = some(a >> 8);
        event.xconfigure.width = some(b);
        event.xconfigure.height = some(b >> 8);
        break;
    case VisibilityNotify:
        event.xvisibility.state = (int)(a % 5);
        break;
    case UnmapNotify:
    case MapNotify:
    case ReparentNotify:
    case GravityNotify:
    case CirculateNotify:
        event.xmap.event = window;
        break;
    case DestroyNotify: /* ends the window: only where that is wanted */
        event.type = NoExpose;
        break;
    case PropertyNotify:
        event.xproperty.atom = a % 3 == 0 ? XA_RESOURCE_MANAGER : a_name(a);
        event.xproperty.state = (int)(b % 3);
        event.xproperty.time = b;
        break;
    case SelectionClear:
        event.xselectionclear.selection = a_name(a);
        event.xselectionclear.time = b;
        break;
    case SelectionRequest:
        event.xselectionrequest.owner = window;
        event.xselectionrequest.requestor = a % 2 ? window : (Window)b;
        event.xselectionrequest.selection = a_name(a);
        event.xselectionrequest.target = a_name(b);
        event.xselectionrequest.property = a_name(a ^ b);
        event.xselectionrequest.time = b;
        break;
    case SelectionNotify:
        event.xselection.requestor = a % 2 ? window : (Window)b;
        event.xselection.selection = a_name(a);
        event.xselection.target = a_name(b);
        event.xselection.property = a_name(a ^ b);
        event.xselection.time = b;
        break;
    case ClientMessage:
        event.xclient.message_type = a_name(a);
        event.xclient.format = a % 7 == 0 ? 8 : a % 7 == 1 ? 16 : 32;
        for (i = 0; i < 5; i++)
            event.xclient.data.l[i] = (long)(a_name(b + i));
        break;
    case MappingNotify:
        event.xmapping.request = (int)(a % 4);
        event.xmapping.first_keycode = (int)(b % 256);
        event.xmapping.count = (int)(b >> 8) % 256;
        break;
    default:
        memcpy((char *)&event + sizeof event.xany, &noise, sizeof noise);
    }
    send_event(window, &event);
}
