/*
 * Scenes, as a C program asks for them: scene
 *
 * 1,000 nodes of a tree with position, rotation and scale tracks of 11 keys each, and
 * 100,000 with 6, evaluated at one frame after the other; the last of the 1,000 at many frames; 100,000 points with two shapes and a twist.
 * peers/scene.mjs and peers/scene.py make the same. Prints a name and a number a line.
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <time.h>

#include <libvides.h>

#define KEYS 11
#define SAMPLES 1000
#define POINTS 100000
#define RUNS 7

static void check(int status)
{
    if (status != V_OK) {
        fprintf(stderr, "scene: %s\n", v_last_error());
        exit(1);
    }
}

/* The processor's time: others at work on the machine do not count. */
static double now(void)
{
    struct timespec at;

    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &at);
    return (double)at.tv_sec + 1e-9 * (double)at.tv_nsec;
}

static V_SCENE *nodes(int count, int keys)
{
    double frames[KEYS], place[3 * KEYS], turn[4 * KEYS], scale[3 * KEYS];
    V_SCENE *scene;
    V_NODE node;
    char name[20];
    int i, k, number;

    check(v_scene_new(&scene));
    check(v_scene_remove_node(scene, 0));
    for (i = 0; i < count; i++) {
        v_node_init(&node, V_NODE_GROUP);
        node.parent = i > 0 ? (i - 1) / 4 : -1;
        sprintf(name, "n%d", i);
        check(v_scene_add_node(scene, name, &node, &number));
        for (k = 0; k < keys; k++) {
            double axis[3], angle = 0.6 * sin(0.3 * i + k), length;

            frames[k] = 1 + 100.0 / (keys - 1) * k;
            place[3 * k] = 0.5 * sin(0.37 * i + 0.9 * k);
            place[3 * k + 1] = 0.5 * cos(0.23 * i + 0.5 * k);
            place[3 * k + 2] = 0.5 * sin(0.11 * i + 0.7 * k);
            axis[0] = 1, axis[1] = sin(i), axis[2] = cos(i);
            length = sqrt(axis[0] * axis[0] + axis[1] * axis[1] + axis[2] * axis[2]);
            turn[4 * k] = cos(angle / 2);
            turn[4 * k + 1] = sin(angle / 2) * axis[0] / length;
            turn[4 * k + 2] = sin(angle / 2) * axis[1] / length;
            turn[4 * k + 3] = sin(angle / 2) * axis[2] / length;
            scale[3 * k] = 1 + 0.1 * sin(i + k);
            scale[3 * k + 1] = 1 + 0.1 * cos(i + k);
            scale[3 * k + 2] = 1;
        }
        check(v_scene_set_track(scene, i, "position", "linear", frames, place, NULL, keys, 0));
        check(v_scene_set_track(scene, i, "rotation", "linear", frames, turn, NULL, keys, 0));
        check(v_scene_set_track(scene, i, "scale", "linear", frames, scale, NULL, keys, 0));
    }
    return scene;
}

static void evaluate(int count, int keys, const char *name)
{
    V_NODE_STATE *states = malloc(count * sizeof *states);
    V_SCENE *scene = nodes(count, keys);
    int frames = 200000 / count > 4 ? 200000 / count : 4;
    double best = 1e9, sum = 0;
    int run, n, i;

    for (run = 0; run <= RUNS; run++) {
        double begin = now(), took;

        for (n = 0; n < frames; n++)
            check(v_scene_evaluate(scene, 1 + fmod(0.37 * n, 100), states, count, NULL));
        took = (now() - begin) / frames;
        if (run > 0 && took < best)
            best = took;
    }
    for (i = 0; i < count; i++)
        sum += states[i].matrix[12] + 2 * states[i].matrix[13] + 3 * states[i].matrix[14];
    printf("%s_per_second %.0f\n%s_places %.12f\n", name, count / best, name, sum);
    if (count >= SAMPLES) {
        for (run = 0, best = 1e9; run <= RUNS; run++) {
            double begin = now();

            check(v_scene_sample(scene, 999, 1, 0.1, states, SAMPLES));
            if (now() - begin < best)
                best = now() - begin;
        }
        printf("%s_sampled_per_second %.0f\n", name, SAMPLES / best);
    }
    v_scene_free(scene);
    free(states);
}

static void vertices(void)
{
    static const double twist[] = {2, 90}, weights[] = {0.3, 0.2}, frames[] = {1};
    double *xyz = malloc(3 * POINTS * sizeof *xyz), *other = malloc(3 * POINTS * sizeof *xyz);
    double best = 1e9, sum = 0;
    V_SCENE *scene;
    V_NODE node;
    V_MESH mesh = {sizeof mesh, NULL, POINTS, NULL, NULL, 0, NULL, 0};
    size_t points;
    int run, n, i, shape, number;

    if (xyz == NULL || other == NULL)
        exit(1);
    for (i = 0; i < 3 * POINTS; i++)
        xyz[i] = sin(0.001 * i);
    mesh.xyz = xyz;
    check(v_scene_new(&scene));
    v_node_init(&node, V_NODE_OBJECT);
    check(v_scene_add_node(scene, "cloud", &node, &number));
    check(v_scene_set_geometry(scene, number, &mesh));
    for (shape = 0; shape < 2; shape++) {
        for (i = 0; i < 3 * POINTS; i++)
            other[i] = xyz[i] + 0.1 * cos(0.002 * i + shape);
        check(v_scene_add_shape(scene, number, shape ? "b" : "a", other, NULL, POINTS));
    }
    check(v_scene_set_track(scene, number, "weights", "linear", frames, weights, NULL, 1, 0));
    check(v_scene_add_deformation(scene, number, "twist", twist, 2, NULL, NULL));
    for (run = 0; run <= RUNS; run++) {
        double begin = now(), took;

        for (n = 0; n < 10; n++)
            check(v_scene_vertices(scene, number, 1, other, NULL, POINTS, &points));
        took = (now() - begin) / 10;
        if (run > 0 && took < best)
            best = took;
    }
    for (i = 0; i < POINTS; i++)
        sum += other[3 * i] + 2 * other[3 * i + 1] + 3 * other[3 * i + 2];
    printf("vertices_per_second %.0f\npoints %.9f\n", POINTS / best, sum);
    v_scene_free(scene);
    free(xyz);
    free(other);
}

int main(void)
{
    evaluate(1000, 11, "nodes");
    evaluate(100000, 6, "many");
    vertices();
    return 0;
}
