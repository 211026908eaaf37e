/* What v_path_to_list costs beyond sampling, beside a loop that only
   allocates, fills and links as many elements.

       cc -O2 -Iinclude -o list benches/list.c -Ltarget/c -l:libvides.a -lm
       ./list [runs]

   Each measurement is made in a separate process, so that every malloc meets
   fresh memory; of each kind the fastest run counts. The path is that of
   benches/engine.rs. */
#define _POSIX_C_SOURCE 200809L
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

#include "libvides.h"

#define POINTS 100
#define POSES 1e6

static void check(int status, const char *what)
{
    if (status != V_OK) {
        fprintf(stderr, "%s: %s\n", what, v_last_error());
        exit(1);
    }
}

static double now(void)
{
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

static double sum; /* of all coordinates, to be compared with the other two */

static V_PATH *make_path(void)
{
    V_PATH *path;
    double length;
    int i, k;
    check(v_path_new(&path), "v_path_new");
    for (i = 0; i < POINTS; i++) {
        V_ORIENTATION o;
        double n = i, xyz[3], yaw = 0.21 * n + 0.3 * sin(0.7 * n);
        xyz[0] = 0.8 * sin(0.37 * n);
        xyz[1] = 0.6 * sin(0.23 * n + 1.0);
        xyz[2] = 0.8 * cos(0.31 * n);
        for (k = 0; k < 3; k++) sum += xyz[k];
        v_orientation_init(&o);
        o.target[0] = sin(yaw);
        o.target[1] = 0.4 * sin(0.29 * n);
        o.target[2] = cos(yaw);
        o.roll = 20.0 * sin(0.41 * n);
        o.zoom = 50.0 + 30.0 * sin(0.17 * n);
        o.tension = 0.3 * sin(1.9 * n);
        o.continuity = 0.3 * sin(2.3 * n + 1.0);
        o.bias = 0.3 * sin(2.9 * n + 2.0);
        if (i < 2) /* a new path has two points */
            check(v_path_set_numbers(path, v_path_key(i, -1, "position"), xyz, 3), "v_path_set_numbers");
        else
            check(v_path_insert_point(path, i, xyz), "v_path_insert_point");
        check(v_path_set_numbers(path, v_path_key(i, -1, "own"),
              (const double[]){0.4 * sin(1.3 * n), 0.3 * sin(1.7 * n + 1.0), 0.4 * sin(2.1 * n + 2.0)}, 3), "v_path_set_numbers");
        check(v_path_set_orientation(path, i, 0, &o), "v_path_set_orientation");
    }
    check(v_path_length(path, &length), "v_path_length");
    check(v_path_set_numbers(path, "base_speeds", (const double[]){POSES / length, 100.0, 100.0,
          100.0}, 4), "v_path_set_numbers");
    return path;
}

static V_PATH *path;
static V_POSE *poses;
static size_t count;

static double time_sample(void)
{
    size_t got;
    double begin;
    memset(poses, 1, count * sizeof *poses); /* this process's own pages */
    begin = now();
    check(v_path_sample(path, poses, count, &got), "v_path_sample");
    return now() - begin;
}

static double time_list(void)
{
    V_KAMERAPAR first;
    double begin;
    memset(&first, 0, sizeof first);
    first.number = -1;
    begin = now();
    check(v_path_to_list(path, &first), "v_path_to_list");
    return now() - begin;
}

static double time_loop(void)
{
    V_KAMERAPAR first, *last = &first;
    double begin = now();
    size_t i;
    for (i = 1; i <= count; i++) {
        V_KAMERAPAR *e = i == 1 ? &first : malloc(sizeof *e);
        float x = (float)i;
        if (e == NULL) exit(1);
        e->VRP.x = x; e->VRP.y = x; e->VRP.z = x;
        e->VPN.x = x; e->VPN.y = x; e->VPN.z = x;
        e->VUP.x = x; e->VUP.y = x; e->VUP.z = x;
        e->zoom = (int)i;
        e->number = (int)i;
        e->prev = last;
        last->next = e;
        last = e;
    }
    last->next = &first;
    first.prev = last;
    return now() - begin;
}

/* Seconds that `work` reports, in a separate process. */
static double apart(double (*work)(void))
{
    int ends[2], status;
    double seconds;
    pid_t child;
    if (pipe(ends) != 0 || (child = fork()) < 0) {
        perror("list");
        exit(1);
    }
    if (child == 0) {
        seconds = work();
        _exit(write(ends[1], &seconds, sizeof seconds) == (ssize_t)sizeof seconds ? 0 : 1);
    }
    close(ends[1]);
    if (read(ends[0], &seconds, sizeof seconds) != (ssize_t)sizeof seconds) seconds = -1;
    close(ends[0]);
    if (waitpid(child, &status, 0) != child || status != 0 || seconds < 0) {
        fprintf(stderr, "list: a measurement failed\n");
        exit(1);
    }
    return seconds;
}

static double smaller(double a, double b) { return a < b ? a : b; }

int main(int argc, char **argv)
{
    int run, runs = argc > 1 ? atoi(argv[1]) : 15;
    double sample = 1e9, list = 1e9, loop = 1e9;
    path = make_path();
    check(v_path_frame_count(path, &count), "v_path_frame_count");
    poses = malloc(count * sizeof *poses);
    if (poses == NULL) return 1;
    time_sample(); /* prepares the path, here and so in every child */
    for (run = 0; run < runs; run++) {
        sample = smaller(sample, apart(time_sample));
        list = smaller(list, apart(time_list));
        loop = smaller(loop, apart(time_loop));
    }
    printf("elements     %lu\n", (unsigned long)count);
    printf("coordinates  %.12f\n", sum);
    printf("sample_ms    %.3f\n", 1e3 * sample);
    printf("to_list_ms   %.3f\n", 1e3 * list);
    printf("c_loop_ms    %.3f\n", 1e3 * loop);
    printf("ratio        %.3f\n", (list - sample) / loop);
    v_path_free(path);
    free(poses);
    return 0;
}
