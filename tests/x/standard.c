/*
 * A host without standard input, output and error: says after each step its status, and how many
 * of the three descriptors are in use.
 */
#include <fcntl.h>
#include <stdio.h>
#include <string.h>
#include <time.h>
#include <unistd.h>

#include <libvides.h>

static int out;

static void say(const char *what, int status)
{
    char line[100];
    int number, taken = 0;

    for (number = 0; number < 3; number++)
        taken += fcntl(number, F_GETFD) != -1;
    sprintf(line, "%s %d taken %d\n", what, status, taken);
    if (write(out, line, strlen(line)) < 0)
        _exit(3);
}

int main(void)
{
    const struct timespec moment = {0, 10000000};
    V_EDITOR *editor = NULL;
    V_PATH *path = NULL;
    int i, status;

    out = fcntl(1, F_DUPFD, 10);
    for (i = 0; i < 3; i++)
        close(i);
    say("open", v_editor_open(NULL, &editor));
    for (i = 0; i < 100; i++) {
        v_dispatch();
        nanosleep(&moment, NULL);
    }
    say("served", 0);
    status = v_editor_get_path(editor, &path);
    if (status == V_OK)
        status = v_path_save(path, "standard.vid");
    v_path_free(path);
    if (status == V_OK)
        status = v_path_load("standard.vid", &path);
    say("saved", status);
    v_path_free(path);
    say("closed", v_editor_close(editor));
    return 0;
}
