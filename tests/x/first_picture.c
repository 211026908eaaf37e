/*
 * Tells when the upper left corner of the screen shows a picture, on the clock
 * CLOCK_MONOTONIC in microseconds: more than three colours in its first rows.
 * Says "ready" before, and looks again for every line on standard input.
 */
#include <stdio.h>
#include <time.h>

#include <X11/Xlib.h>
#include <X11/Xutil.h>

static int picture(Display *display)
{
    XImage *image = XGetImage(display, DefaultRootWindow(display), 0, 0, 300, 24, AllPlanes, ZPixmap);
    unsigned long seen[4];
    int count = 0, x, y, i;

    for (y = 0; y < 24 && count < 4; y++)
        for (x = 0; x < 300 && count < 4; x++) {
            unsigned long pixel = XGetPixel(image, x, y);
            for (i = 0; i < count && seen[i] != pixel; i++)
                ;
            if (i == count)
                seen[count++] = pixel;
        }
    XDestroyImage(image);
    return count == 4;
}

int main(void)
{
    Display *display = XOpenDisplay(NULL);
    struct timespec now;
    char line[100];

    if (display == NULL)
        return 1;
    do {
        puts("ready");
        fflush(stdout);
        while (!picture(display))
            ;
        clock_gettime(CLOCK_MONOTONIC, &now);
        printf("%.1f\n", now.tv_sec * 1e6 + now.tv_nsec / 1e3);
        fflush(stdout);
    } while (fgets(line, sizeof line, stdin) != NULL);
    return 0;
}
