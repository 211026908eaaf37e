/*
 * A host that opens windows on a thread and lets that thread end: thread_ends [HOW]
 *
 *     (nothing)  one window by v_editor_open(), served for a moment; the thread returns
 *     two        two windows, of which one by v_haupt(); by pthread_exit()
 *     exit       nothing ends but the program, from that thread
 *
 * Says what the handle tells afterwards.
 */
#include <pthread.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include <libvides.h>

static V_EDITOR *editor;
static const char *how;

static void *opens(void *unused)
{
    const struct timespec moment = {0, 20000000};
    int i;

    (void)unused;
    if (v_editor_open(NULL, &editor) != V_OK)
        exit(2);
    if (strcmp(how, "two") == 0)
        v_haupt(100, 100, 100, 100, NULL, 0, NULL, NULL, NULL);
    for (i = 0; i < 20; i++) {
        v_dispatch();
        nanosleep(&moment, NULL);
    }
    if (strcmp(how, "exit") == 0)
        exit(0);
    if (strcmp(how, "two") == 0)
        pthread_exit(NULL);
    return NULL;
}

int main(int argc, char **argv)
{
    pthread_t thread;
    V_PATH *path;
    int status;

    how = argc > 1 ? argv[1] : "";
    if (pthread_create(&thread, NULL, opens, NULL) != 0)
        return 2;
    pthread_join(thread, NULL);
    status = v_editor_get_path(editor, &path);
    printf("get_path %d %s\n", status, v_last_error());
    printf("strerror %s\n", v_strerror(status));
    status = v_editor_close(editor);
    printf("close %d %s\n", status, v_last_error());
    fflush(stdout);
    return 0;
}
