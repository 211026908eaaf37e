/*
 * A desktop's settings manager (XSETTINGS): takes the selection, names a theme, tells
 * the root window so, and stays until its standard input ends. With a second word it
 * only says that a manager of that selection begins.
 *
 *     manager THEME
 *     manager - SELECTION
 */
#include <stdio.h>
#include <string.h>
#include <unistd.h>

#include <X11/Xlib.h>

/* One string setting, as the specification lays it out. */
static int settings(unsigned char *out, const char *theme)
{
    static const char name[] = "Net/ThemeName"; /* 13 letters, filled up to 16 */
    const unsigned int one = 1;
    const unsigned short name_length = 13;
    const unsigned int length = (unsigned int)strlen(theme);

    memset(out, 0, 128);
    out[0] = *(const unsigned char *)&one ? 0 : 1; /* byte order */
    memcpy(out + 8, &one, 4);                      /* number of settings */
    out[12] = 1;                                   /* a string */
    memcpy(out + 14, &name_length, 2);
    memcpy(out + 16, name, 13);
    memcpy(out + 36, &length, 4); /* behind the serial number */
    memcpy(out + 40, theme, length);
    return 40 + (int)((length + 3) / 4 * 4);
}

int main(int argc, char **argv)
{
    const int only_says = argc > 2;
    Display *display = XOpenDisplay(NULL);
    Window root, window;
    Atom selection;
    XEvent event;
    char end;

    if (argc < 2 || display == NULL || strlen(argv[1]) > 60)
        return 1;
    root = RootWindow(display, 0);
    window = XCreateSimpleWindow(display, root, -9, -9, 1, 1, 0, 0, 0);
    selection = XInternAtom(display, only_says ? argv[2] : "_XSETTINGS_S0", False);
    if (!only_says) {
        const Atom property = XInternAtom(display, "_XSETTINGS_SETTINGS", False);
        unsigned char bytes[128];
        const int count = settings(bytes, argv[1]);

        XSetSelectionOwner(display, selection, window, CurrentTime);
        XChangeProperty(display, window, property, property, 8, PropModeReplace, bytes, count);
    }
    memset(&event, 0, sizeof event);
    event.xclient.type = ClientMessage;
    event.xclient.window = root;
    event.xclient.message_type = XInternAtom(display, "MANAGER", False);
    event.xclient.format = 32;
    event.xclient.data.l[0] = CurrentTime;
    event.xclient.data.l[1] = (long)selection;
    event.xclient.data.l[2] = (long)window;
    XSendEvent(display, root, False, StructureNotifyMask, &event);
    XSync(display, False);
    puts("begun");
    fflush(stdout);
    while (!only_says && read(0, &end, 1) > 0)
        ;
    XCloseDisplay(display);
    return 0;
}
