/*
 * Nodes removed one by one from a large scene, from the front, from the back and from
 * anywhere, with what a host asks in between: each removal asks for no memory but the
 * first, so that none works on the whole scene. With "measure" as its second argument it
 * says how long they take.
 */
#include <time.h>

#include "allocations.h"
#include "check.h"

static double now(void)
{
    struct timespec time;
    clock_gettime(CLOCK_MONOTONIC, &time);
    return time.tv_sec + 1e-9 * time.tv_nsec;
}

/* So many groups, the first tenth at the top, each other one in one of these; and a
 * lamp as the last node that aims at the one before it. */
static V_SCENE *a_scene(int count)
{
    V_SCENE *scene = NULL;
    V_NODE node;
    char name[20];
    int i;

    OK(v_scene_new(&scene));
    for (i = 1; i < count - 1; i++) {
        v_node_init(&node, V_NODE_GROUP);
        if (i > count / 10)
            node.parent = 1 + i % (count / 10);
        sprintf(name, "n%d", i);
        if (v_scene_add_node(scene, name, &node, NULL) != V_OK)
            CHECK(!"a node");
    }
    v_node_init(&node, V_NODE_LIGHT);
    node.aim = count - 2;
    OK(v_scene_add_node(scene, "lamp", &node, NULL));
    return scene;
}

enum from { FRONT, BACK, ANYWHERE };
static const char *const names[] = {"front", "back", "anywhere"};

/* Removes nodes until few are left; how many calls that took. */
static int removals(V_SCENE *scene, enum from from, int few)
{
    unsigned random = 1;
    int count, calls = 0, lamp = -1;
    V_NODE node;
    const char *name;

    node.size = sizeof node;
    for (;; calls++) {
        if (v_scene_count(scene, 0, "nodes", &count) != V_OK || count <= few)
            return calls;
        random = random * 1664525u + 1013904223u;
        /* Neither the lamp, nor what it aims at. */
        if (v_scene_remove_node(scene, from == FRONT  ? 0
                                       : from == BACK ? count - 3
                                                      : (int)(random >> 8) % (count - 2))
            != V_OK) {
            CHECK(!"a removal");
            return calls;
        }
        if (calls % 16 != 0)
            continue;
        OK(v_scene_count(scene, 0, "nodes", &count));
        OK(v_scene_find_node(scene, "lamp", &lamp));
        CHECK(lamp == count - 1);
        OK(v_scene_get_name(scene, count - 1, &name));
        CHECK(strcmp(name, "lamp") == 0);
        OK(v_scene_get_node(scene, lamp, &node));
        CHECK(node.aim == -1 || node.aim == count - 2);
        STATUS(V_ERR_RANGE, v_scene_get_name(scene, count, &name));
        STATUS(V_ERR_RANGE, v_scene_remove_node(scene, count));
    }
}

/* What is left is whole: it can be changed, evaluated and searched. */
static void what_is_left_is_whole(V_SCENE *scene)
{
    static V_NODE_STATE states[100];
    int count = 0, i, number;
    const char *name;
    V_NODE node;
    size_t all;

    OK(v_scene_evaluate(scene, 1, states, 100, &all));
    OK(v_scene_count(scene, 0, "nodes", &count));
    CHECK((int)all == count);
    for (i = 0; i < count; i++) {
        char kept[20];
        OK(v_scene_get_name(scene, i, &name));
        sprintf(kept, "%.19s", name);
        OK(v_scene_find_node(scene, kept, &number));
        CHECK(number == i);
        node.size = sizeof node;
        OK(v_scene_get_node(scene, i, &node));
        CHECK(node.parent >= -1 && node.parent < count);
    }
    v_node_init(&node, V_NODE_GROUP);
    OK(v_scene_add_node(scene, "n1 again", &node, &number));
    CHECK(number == count);
    OK(v_scene_remove_node(scene, number));
    OK(v_scene_set_name(scene, 0, "n1 again"));
}

static void nodes_one_by_one(int count, enum from from, int measure)
{
    V_SCENE *scene = a_scene(count);
    double begun = now();
    int calls;

    asked = 0;
    calls = removals(scene, from, 50);
    CHECK(asked < 20);
    if (measure)
        printf("note: %6d nodes, %-8s: %6d removals, %.4f ms each\n", count, names[from], calls,
               1e3 * (now() - begun) / calls);
    what_is_left_is_whole(scene);
    v_scene_free(scene);
}

int main(int argc, char **argv)
{
    int measure = argc > 2 && strcmp(argv[2], "measure") == 0, count, from;

    for (count = 1000; count <= (measure ? 100000 : 10000); count *= 10)
        for (from = FRONT; from <= ANYWHERE; from++)
            nodes_one_by_one(count, from, measure);
    return failures != 0;
}
