/*
 * How much stack the library needs, beside what hostile.c calls:
 *
 *     stack FOLDER CORPUS
 *
 * Every function, the opening and drawing of a window, and every malformed file are called in
 * threads whose stack is painted before; what has lost its paint was used. No call may use more
 * than the header says; without windows, and with.
 */
#include <dirent.h>
#include <pthread.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "draw.h"
#include "every.h"
#include "hands.h"

#define PAINT 0xA5
#define ROOM (1 << 20)
/* What the header promises to suffice. */
#define LEAST (128 << 10)

static unsigned char *room;
static const char *most_name = "";
static size_t most;

/* Runs something in a thread; the bytes of stack that it used. */
static size_t used_by(void *(*work)(void *), void *with)
{
    pthread_attr_t attributes;
    pthread_t thread;
    size_t untouched = 0;

    memset(room, PAINT, ROOM);
    pthread_attr_init(&attributes);
    if (pthread_attr_setstack(&attributes, room, ROOM) != 0 ||
        pthread_create(&thread, &attributes, work, with) != 0) {
        fault("no thread");
        return 0;
    }
    pthread_join(thread, NULL);
    pthread_attr_destroy(&attributes);
    while (untouched < ROOM && room[untouched] == PAINT)
        untouched++;
    return ROOM - untouched;
}

static void measure(const char *name, void *(*work)(void *), void *with)
{
    size_t used = used_by(work, with);

    if (used > most) {
        most = used;
        most_name = name;
    }
    if (used > LEAST)
        fault("%s uses %lu bytes of stack", name, (unsigned long)used);
}

static void *nothing(void *unused)
{
    return unused;
}

static void *one_call(void *function)
{
    call(function, -2);
    return NULL;
}

/* Of all forms that are read. */
static void *one_file(void *name)
{
    const char *const formats[] = {NULL, "vid", "glb", "gltf", "usda", "nerfstudio", "transforms",
                                   "tum", "html", "paraview", "colmap"};
    V_PATH *path = NULL;
    V_SCENE *scene = NULL;
    size_t i;

    if (v_path_load(name, &path) == V_OK)
        v_path_free(path);
    for (i = 0; i < sizeof formats / sizeof *formats; i++)
        if (v_scene_import(name, formats[i], NULL, &scene) == V_OK)
            v_scene_free(scene);
    return NULL;
}

static void *one_window(void *unused)
{
    V_EDITOR *editor = NULL;
    int turns;

    if (v_editor_open(NULL, &editor) != V_OK)
        fault("no window: %s", v_last_error());
    for (turns = 0; turns < 200; turns++) {
        if (turns == 50)
            hands_change(hands_window(0));
        v_dispatch();
        usleep(2000);
    }
    v_editor_close(editor);
    return unused;
}

static void files_in(const char *folder, int deep)
{
    DIR *all = opendir(folder);
    struct dirent *entry;

    while (all != NULL && (entry = readdir(all)) != NULL) {
        char name[4000];
        snprintf(name, sizeof name, "%.1900s/%.1900s", folder, entry->d_name);
        if (entry->d_name[0] == '.')
            continue;
        if (entry->d_type == DT_DIR && deep > 0)
            files_in(name, deep - 1);
        else
            measure("a malformed file", one_file, name);
    }
    if (all != NULL)
        closedir(all);
}

/* As deep as texts can nest, and deeper. */
static void nested(const char *name, const char *begin, const char *open, int times)
{
    char file[4000];
    FILE *out;

    snprintf(file, sizeof file, "%.1900s/%s", folder, name);
    out = fopen(file, "w");
    if (out == NULL)
        return;
    fputs(begin, out);
    while (times-- > 0)
        fputs(open, out);
    fclose(out);
    measure(name, one_file, file);
}

static void every_function(void)
{
    int i, times;

    for (times = 0; times < 12; times++) {
        fresh_things();
        wild = times % 3 == 2 ? 15 : 0;
        for (i = 0; i < function_count; i++)
            measure(functions[i].name, one_call, (void *)&functions[i]);
        wild = 0;
        end_things();
    }
}

int main(int argc, char **argv)
{
    size_t least;
    int depths;

    folder = argc > 1 ? argv[1] : ".";
    if (posix_memalign((void **)&room, 4096, ROOM) != 0)
        return 99;
    draw_seed(1);
    display_there = windows_may_go = hands_connect();
    least = used_by(nothing, NULL);
    every_function();
    if (display_there)
        measure("a window that is drawn", one_window, NULL);
    for (depths = 50; depths <= 100000; depths *= 10) {
        nested("arrays.vid", "version = 1\nx = ", "[", depths);
        nested("tables.vid", "version = 1\nx = ", "{a=", depths);
        nested("arrays.gltf", "{\"asset\":{\"version\":\"2.0\"},\"x\":", "[", depths);
        nested("objects.gltf", "{\"asset\":{\"version\":\"2.0\"},\"x\":", "{\"a\":", depths);
        nested("prims.usda", "#usda 1.0\n", "def Xform \"a\" {\n", depths);
        nested("lists.usda", "#usda 1.0\ndef Xform \"a\" {\n int x = ", "[", depths);
    }
    if (argc > 2)
        files_in(argv[2], 2);
    hands_leave();
    printf("stack: %s uses %lu KiB, an empty thread %lu; %d faults\n", most_name,
           (unsigned long)(most >> 10), (unsigned long)(least >> 10), faults);
    return faults != 0;
}
