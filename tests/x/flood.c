/*
 * Somebody who means it ill with the library's windows, on a display of the
 * environment (../calls/hands.h):
 *
 *     flood events SECONDS RATE   events of every kind, RATE a second; 0: as
 *                                 many as go, a million at most
 *     flood alone SECONDS RATE    of every kind, and the server serves nobody
 *                                 else meanwhile
 *     flood silent                owns the clipboard and answers nobody
 *     flood endless               owns the clipboard and hands over pieces
 *                                 without an end
 *
 * Says "ready" when it begins and "done" with what it has done.
 */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>
#include <unistd.h>

#include <X11/Xatom.h>
#include <X11/Xlib.h>

#include "../calls/hands.h"

/* Events that are sent, however fast the machine is. */
#define MOST 1000000

static unsigned long long state = 1;

static unsigned long long noise(void)
{
    state ^= state >> 12;
    state ^= state << 25;
    state ^= state >> 27;
    return state * 0x2545F4914F6CDD1Du;
}

static double now(void)
{
    struct timespec time;

    clock_gettime(CLOCK_MONOTONIC, &time);
    return (double)time.tv_sec + 1e-9 * (double)time.tv_nsec;
}

static void events(double seconds, double rate)
{
    double start = now();
    unsigned long window = hands_window(0);
    long sent = 0;

    while (now() < start + seconds && sent < MOST) {
        if (rate > 0 && (double)sent > rate * (now() - start)) {
            hands_finish();
            usleep(1000);
            continue;
        }
        hands_send(window, (int)(sent % hands_kinds()), noise());
        sent++;
        if (sent % 1000 == 0)
            hands_finish();
    }
    hands_finish();
    printf("done %ld events\n", sent);
}

static Display *display;

static int ignore(Display *of, XErrorEvent *error)
{
    (void)of, (void)error;
    return 0;
}

/* What the next piece is written into: announced once, then fed for ever. */
static void answer(const XSelectionRequestEvent *request)
{
    long size = 1000;
    XEvent event;

    XSelectInput(display, request->requestor, PropertyChangeMask);
    XChangeProperty(display, request->requestor, request->property,
                    XInternAtom(display, "INCR", False), 32, PropModeReplace,
                    (unsigned char *)&size, 1);
    memset(&event, 0, sizeof event);
    event.xselection.type = SelectionNotify;
    event.xselection.requestor = request->requestor;
    event.xselection.selection = request->selection;
    event.xselection.target = request->target;
    event.xselection.property = request->property;
    event.xselection.time = request->time;
    XSendEvent(display, request->requestor, False, NoEventMask, &event);
}

static void own_the_clipboard(int endless)
{
    static unsigned char piece[60000];
    Window owner;
    long pieces = 0;

    display = XOpenDisplay(NULL);
    if (display == NULL)
        exit(1);
    XSetErrorHandler(ignore);
    memset(piece, 'x', sizeof piece);
    owner = XCreateSimpleWindow(display, DefaultRootWindow(display), 0, 0, 1, 1, 0, 0, 0);
    XSetSelectionOwner(display, XInternAtom(display, "CLIPBOARD", False), owner, CurrentTime);
    XSync(display, False);
    puts("ready");
    for (;;) {
        XEvent event;

        XNextEvent(display, &event);
        if (event.type == SelectionRequest) {
            puts("asked");
            if (endless)
                answer(&event.xselectionrequest);
        } else if (event.type == PropertyNotify && event.xproperty.state == PropertyDelete) {
            XChangeProperty(display, event.xproperty.window, event.xproperty.atom,
                            XInternAtom(display, "UTF8_STRING", False), 8, PropModeReplace, piece,
                            sizeof piece);
            if (++pieces % 100 == 0)
                printf("pieces %ld\n", pieces);
        }
    }
}

int main(int argc, char **argv)
{
    setvbuf(stdout, NULL, _IOLBF, 0);
    if (argc > 3) {
        int alone = strcmp(argv[1], "alone") == 0;

        if (!hands_connect() || hands_count() == 0)
            return 1;
        puts("ready");
        if (alone)
            hands_take_all();
        events(atof(argv[2]), atof(argv[3]));
        if (alone)
            hands_let_go();
        hands_leave();
        return 0;
    }
    if (argc > 1)
        own_the_clipboard(strcmp(argv[1], "endless") == 0);
    return 1;
}
