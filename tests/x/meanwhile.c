/*
 * A host that changes the scene while the user is at it. It does what it is told, a
 * line each:
 *
 *     change    takes the scene as the user has it, adds "host", removes "old",
 *               moves "box" by one up, and shows that: "changed STATUS"
 *     nodes     "nodes" and of each node its name and position
 *     leave     ends; the exit status tells whether all was done
 */
#include <poll.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

#include <libvides.h>

static int failures;

static void ok(int status, const char *what)
{
    if (status != V_OK) {
        printf("%s: %d %s\n", what, status, v_last_error());
        failures++;
    }
}

static V_SCENE *lights(void)
{
    static const char *const names[] = {"lamp", "old", "box"};
    V_SCENE *scene = NULL;
    V_NODE node;
    int k;

    ok(v_scene_new(&scene), "scene");
    for (k = 0; k < 3; k++) {
        v_node_init(&node, V_NODE_LIGHT);
        node.position[0] = 0.5 * k;
        ok(v_scene_add_node(scene, names[k], &node, NULL), names[k]);
    }
    /* There is nothing but lights. */
    ok(v_scene_remove_node(scene, 0), "camera");
    return scene;
}

static void change(V_EDITOR *editor)
{
    V_SCENE *scene = NULL;
    V_NODE node;
    int at = -1, status;

    ok(v_editor_get_scene(editor, &scene), "get_scene");
    v_node_init(&node, V_NODE_GROUP);
    ok(v_scene_add_node(scene, "host", &node, NULL), "add");
    if (v_scene_find_node(scene, "old", &at) == V_OK)
        ok(v_scene_remove_node(scene, at), "remove");
    ok(v_scene_find_node(scene, "box", &at), "find");
    ok(v_scene_get_node(scene, at, &node), "get_node");
    node.position[1] += 1;
    ok(v_scene_set_node(scene, at, &node), "set_node");
    status = v_editor_set_scene(editor, scene);
    printf("changed %d\n", status);
    v_scene_free(scene);
}

static void tell(V_EDITOR *editor)
{
    V_SCENE *scene = NULL;
    int count = 0, k;

    ok(v_editor_get_scene(editor, &scene), "get_scene");
    ok(v_scene_count(scene, 0, "nodes", &count), "count");
    printf("nodes");
    for (k = 0; k < count; k++) {
        const char *name = "";
        V_NODE node;

        v_node_init(&node, V_NODE_GROUP);
        ok(v_scene_get_name(scene, k, &name), "name");
        ok(v_scene_get_node(scene, k, &node), "get_node");
        printf(" %s:%.17g,%.17g,%.17g", name, node.position[0], node.position[1],
               node.position[2]);
    }
    printf("\n");
    v_scene_free(scene);
}

int main(void)
{
    V_EDITOR *editor = NULL;
    V_SCENE *scene = lights();
    char line[100];

    setvbuf(stdout, NULL, _IOLBF, 0);
    setvbuf(stdin, NULL, _IONBF, 0);
    ok(v_editor_open(NULL, &editor), "open");
    ok(v_editor_set_scene(editor, scene), "set_scene");
    v_scene_free(scene);
    if (v_editor_select(editor, 0, 0) != V_ERR_ARGUMENT) {
        printf("a point was selected where no path is edited\n");
        failures++;
    }
    for (;;) {
        struct pollfd watch[2];

        watch[0].fd = v_fd();
        watch[1].fd = STDIN_FILENO;
        watch[0].events = watch[1].events = POLLIN;
        poll(watch, 2, v_timeout());
        if (v_dispatch() < 0)
            break;
        if (!watch[1].revents)
            continue;
        if (!fgets(line, sizeof line, stdin) || strcmp(line, "leave\n") == 0)
            break;
        if (strcmp(line, "change\n") == 0)
            change(editor);
        else
            tell(editor);
    }
    ok(v_editor_close(editor), "close");
    return failures != 0;
}
