/*
 * pace: how steadily a window of another program is drawn.
 *
 *     pace WINDOW
 *
 * Until its standard input ends it counts the pictures that the window shows; then
 * it says how many there were and the longest time between two, in milliseconds,
 * the times before the first and after the last included.
 */
#include <poll.h>
#include <stdio.h>
#include <stdlib.h>
#include <time.h>
#include <unistd.h>

#include <X11/Xlib.h>
#include <X11/extensions/Xdamage.h>

static double milliseconds(void)
{
    struct timespec now;

    clock_gettime(CLOCK_MONOTONIC, &now);
    return now.tv_sec * 1e3 + now.tv_nsec * 1e-6;
}

int main(int argc, char **argv)
{
    Display *display = XOpenDisplay(NULL);
    struct pollfd watch[2] = {{0, POLLIN, 0}, {0, POLLIN, 0}};
    int first, error, pictures = 0;
    double last, longest = 0.0;
    Damage damage;
    XEvent event;

    if (argc != 2 || display == NULL || !XDamageQueryExtension(display, &first, &error))
        return 1;
    damage = XDamageCreate(display, strtoul(argv[1], NULL, 0), XDamageReportNonEmpty);
    XSync(display, False);
    printf("watching\n");
    fflush(stdout);
    last = milliseconds();
    watch[1].fd = ConnectionNumber(display);
    for (;;) {
        double now;

        if (XPending(display) == 0) /* also sends what is to be sent */
            poll(watch, 2, -1);
        now = milliseconds();
        if (now - last > longest)
            longest = now - last;
        if (watch[0].revents)
            break;
        while (XPending(display)) {
            XNextEvent(display, &event);
            if (event.type != first + XDamageNotify)
                continue;
            pictures++;
            last = now;
        }
        XDamageSubtract(display, damage, None, None);
    }
    printf("%d %.0f\n", pictures, longest);
    return 0;
}
