/*
 * What the tests of saving share: names in the test's folder, whole files, two
 * paths that differ, and the question whether a file is wholly one of them.
 */
#ifndef FILES_H
#define FILES_H

#include <dirent.h>
#include <errno.h>

#include "check.h"

/* A file's name in a folder; valid until the next call. */
static const char *in(const char *folder, const char *file)
{
    static char name[500];
    sprintf(name, "%.300s/%.100s", folder, file);
    return name;
}

static void write_text(const char *file, const char *text)
{
    FILE *out = fopen(file, "w");
    CHECK(out != NULL && fputs(text, out) >= 0 && fclose(out) == 0);
}

/* A file's contents: size < 0 where there is none. */
typedef struct whole {
    char *bytes;
    long size;
} WHOLE;

static WHOLE whole(const char *file)
{
    WHOLE found = {NULL, -1};
    FILE *in = fopen(file, "rb");
    if (in == NULL)
        return found;
    fseek(in, 0, SEEK_END);
    found.size = ftell(in);
    rewind(in);
    found.bytes = malloc((size_t)found.size + 1);
    if (fread(found.bytes, 1, (size_t)found.size, in) != (size_t)found.size)
        found.size = -2;
    fclose(in);
    return found;
}

static int same(WHOLE a, WHOLE b)
{
    return a.size == b.size && (a.size <= 0 || memcmp(a.bytes, b.bytes, (size_t)a.size) == 0);
}

/* The file's contents are one or the other, as one look finds them. */
static int holds_either(const char *file, WHOLE one, WHOLE other)
{
    WHOLE is = whole(file);
    int found = same(is, one) || same(is, other);
    free(is.bytes);
    return found;
}

/* The file's contents are these. */
static int holds(const char *file, WHOLE should)
{
    return holds_either(file, should, should);
}

/* Names in a folder that begin like this. */
static int names(const char *folder, const char *begin)
{
    DIR *open = opendir(folder);
    struct dirent *entry;
    int count = 0;
    while (open != NULL && (entry = readdir(open)) != NULL)
        count += strncmp(entry->d_name, begin, strlen(begin)) == 0;
    if (open != NULL)
        closedir(open);
    return count;
}

/* How the library's unfinished files begin. */
#define UNFINISHED ".vides-"

/* A path of so many points more than a new one has, different for each kind. */
static V_PATH *path_of(int points, int kind)
{
    V_PATH *path = new_path();
    int i;
    for (i = 0; i < points; i++) {
        double xyz[3];
        xyz[0] = cos(i + kind);
        xyz[1] = sin(0.7 * i + kind);
        xyz[2] = cos(0.3 * i);
        OK(v_path_insert_point(path, 1 + i, xyz));
    }
    return path;
}

/* Either way to write a path: as a .vid file, as its poses. */
typedef int WRITE(const V_PATH *path, const char *file);

#endif
