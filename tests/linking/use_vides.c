/* What a host does with libvides: every way to the system that the engine
 * has (load, save, write), and a list. */
#include <stdio.h>
#include <string.h>
#include <libvides.h>
#include "use.h"

static int step(int status, const char *what)
{
    if (status != V_OK)
        fprintf(stderr, "%s: %s: %s\n", what, v_strerror(status), v_last_error());
    return status;
}

int use_library(const char *folder)
{
    char file[1024], text[1024];
    V_PATH *path = NULL, *copy = NULL;
    V_KAMERAPAR first;
    size_t frames = 0;
    int failed;

    sprintf(file, "%.900s/linking.vid", folder);
    sprintf(text, "%.900s/linking.txt", folder);
    memset(&first, 0, sizeof first);
    first.number = -1;
    failed = step(v_path_new(&path), "new")
          || step(v_path_save(path, file), "save")
          || step(v_path_load(file, &copy), "load")
          || step(v_path_frame_count(copy, &frames), "frame count")
          || step(v_path_to_list(copy, &first), "list")
          || step(v_path_write_ascii(copy, text), "write");
    if (!failed && (size_t)first.prev->number != frames) {
        fputs("the list has the wrong length\n", stderr);
        failed = 1;
    }
    if (!failed) v_free_liste(&first);
    if (v_path_load("/nowhere/at/all.vid", &copy) != V_ERR_IO) {
        fputs("a missing file was not reported\n", stderr);
        failed = 1;
    }
    v_path_free(path);
    v_path_free(copy);
    return failed;
}
