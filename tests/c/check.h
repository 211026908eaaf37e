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

#endif
