/*
 * The told host under a loop of its own: poll() on standard input and on the
 * library's descriptor. With "none" it serves the library only when told to.
 * No X library is linked.
 */
#include <poll.h>
#include <string.h>

#include <libvides.h>

#include "host.h"

/* How often the loop has been woken. */
static long turns;

int loop_command(const char *name, char *rest)
{
    (void)rest;
    if (strcmp(name, "turns") != 0)
        return 0;
    say("turns %ld", turns);
    return 1;
}

int main(int argc, char **argv)
{
    struct pollfd watch[2];
    int serve = argc < 2 || strcmp(argv[1], "none") != 0;

    begin();
    watch[0].fd = 0;
    watch[0].events = watch[1].events = POLLIN;
    for (;;) {
        if (serve)
            v_dispatch();
        watch[1].fd = serve ? v_fd() : -1;
        watch[0].revents = 0;
        if (poll(watch, 2, serve ? v_timeout() : -1) > 0 && watch[0].revents != 0)
            commands();
        turns++;
    }
}
