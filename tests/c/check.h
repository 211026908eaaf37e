/*
 * What every C test of the library shares: checks that say where they fail
 * and go on, so that one run shows all. A test's main ends with
 * "return failures != 0".
 */
#ifndef CHECK_H
#define CHECK_H

#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "libvides.h"

static int failures;

/* The condition holds. */
#define CHECK(condition) \
    check((condition) != 0, __FILE__, __LINE__, #condition)

/* The call answers this status; a failure has a message, a success has none. */
#define STATUS(status, call) \
    check_status(call, status, __FILE__, __LINE__, #call)

#define OK(call) STATUS(V_OK, call)

/* An array of these numbers, and how many they are. */
#define NUMBERS(...) \
    (const double[]){__VA_ARGS__}, sizeof((const double[]){__VA_ARGS__}) / sizeof(double)

/* Both numbers are equal to within epsilon. */
#define NEAR(a, b, epsilon) \
    check_near(a, b, epsilon, __FILE__, __LINE__, #a)

static void check(int holds, const char *file, int line, const char *what)
{
    if (!holds) {
        failures++;
        fprintf(stderr, "%s:%d: %s\n", file, line, what);
    }
}

static void check_status(int is, int should, const char *file, int line, const char *call)
{
    int told = (v_last_error()[0] != '\0') == (is != V_OK);
    if (is != should || !told) {
        failures++;
        fprintf(stderr, "%s:%d: %s: %s instead of %s; \"%s\"\n", file, line, call,
                v_strerror(is), v_strerror(should), v_last_error());
    }
}

static void check_near(double a, double b, double epsilon, const char *file, int line,
                       const char *what)
{
    if (!(fabs(a - b) <= epsilon)) {
        failures++;
        fprintf(stderr, "%s:%d: %s is %.17g instead of %.17g\n", file, line, what, a, b);
    }
}

/* v_path_tool() with options as printf() writes them. */
static int tool(V_PATH *path, const char *name, const V_MESH *object, const char *options, ...)
{
    char text[500];
    va_list numbers;

    va_start(numbers, options);
    vsnprintf(text, sizeof text, options, numbers);
    va_end(numbers);
    return v_path_tool(path, name, text, object);
}

/* A new path, or the end of the test. */
static V_PATH *new_path(void)
{
    V_PATH *path = NULL;
    if (v_path_new(&path) != V_OK) {
        fprintf(stderr, "v_path_new: %s\n", v_last_error());
        exit(2);
    }
    return path;
}

/* A new path of a tool with options as printf() writes them. */
static V_PATH *made_by(const char *name, const char *options, ...)
{
    V_PATH *path = new_path();
    char text[500];
    va_list numbers;

    va_start(numbers, options);
    vsnprintf(text, sizeof text, options, numbers);
    va_end(numbers);
    OK(v_path_tool(path, name, text, NULL));
    return path;
}

static int set_position(V_PATH *path, int at, const double xyz[3])
{
    return v_path_set_numbers(path, v_path_key(at, -1, "position"), xyz, 3);
}

static int get_position(const V_PATH *path, int at, double xyz[3])
{
    size_t count;
    return v_path_get_numbers(path, v_path_key(at, -1, "position"), xyz, 3, &count);
}

/* The space of a path or scene, one property after the other. */
#define HAS_SPACE(kind, TYPE) \
    static int set_##kind##_space(TYPE *it, const double centre[3], double half, int up) \
    { \
        int status = v_##kind##_set_number(it, "space.half_size", half); \
        if (status == V_OK) \
            status = v_##kind##_set_numbers(it, "space.centre", centre, 3); \
        if (status == V_OK) \
            status = v_##kind##_set_text(it, "space.up", up == V_UP_Y ? "y" : up == V_UP_Z ? "z" : "x"); \
        return status; \
    } \
    static int get_##kind##_space(const TYPE *it, double centre[3], double *half, int *up) \
    { \
        size_t count; \
        char axis[2]; \
        int status = v_##kind##_get_number(it, "space.half_size", half); \
        if (status == V_OK) \
            status = v_##kind##_get_numbers(it, "space.centre", centre, 3, &count); \
        if (status == V_OK) \
            status = v_##kind##_get_text(it, "space.up", axis, 2, &count); \
        if (status == V_OK) \
            *up = axis[0] == 'z' ? V_UP_Z : V_UP_Y; \
        return status; \
    }
HAS_SPACE(path, V_PATH)
HAS_SPACE(scene, V_SCENE)

#endif
