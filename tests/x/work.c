/*
 * Reads numbers from standard input, and opens so many windows, one after the
 * other: each is given another path, its poses are handed over by somebody's
 * hands (../calls/hands.h), and it is closed. Says "worked" and how many.
 */
#include <poll.h>
#include <stdio.h>

#include <libvides.h>

#include "../calls/hands.h"

static long handed_over;

static void on_poses(V_EDITOR *editor, const V_POSE *poses, size_t count, void *user)
{
    (void)editor, (void)poses, (void)user;
    handed_over += count > 0;
}

/* One window; 0 if something fails. */
static int work(void)
{
    static const double summit[3] = {0, 0.6, -0.2};
    long before = handed_over;
    V_EDITOR_OPTIONS options;
    V_EDITOR *editor;
    V_PATH *path;

    v_editor_options_init(&options);
    options.on_poses = on_poses;
    if (v_editor_open(&options, &editor) != V_OK || v_editor_get_path(editor, &path) != V_OK
        || v_path_insert_point(path, 1, summit) != V_OK || v_editor_set_path(editor, path) != V_OK)
        return 0;
    v_path_free(path);
    hands_hand_over(hands_window(0));
    while (handed_over == before) {
        struct pollfd watch;

        watch.fd = v_fd();
        watch.events = POLLIN;
        poll(&watch, 1, v_timeout());
        if (v_dispatch() < 1)
            return 0;
    }
    return v_editor_close(editor) == V_OK && v_dispatch() == 0;
}

int main(void)
{
    int times, done;

    setvbuf(stdout, NULL, _IOLBF, 0);
    if (!hands_connect())
        return 1;
    while (scanf("%d", &times) == 1) {
        for (done = 0; done < times && work(); done++)
            ;
        printf("worked %d %s\n", done, v_last_error());
    }
    hands_leave();
    return 0;
}
