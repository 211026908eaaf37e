/*
 * Scenes in files of other programs: exchange FOLDER.
 */
#include "check.h"

static char file[1024];

static const char *in(const char *folder, const char *name)
{
    snprintf(file, sizeof file, "%s/%s", folder, name);
    return file;
}

/* A scene of one camera on a path of its own. */
static V_SCENE *flight(void)
{
    V_SCENE *scene = NULL;
    OK(v_scene_new(&scene));
    return scene;
}

static void poses_at(const V_SCENE *scene, int node, double frame, V_NODE_STATE *state)
{
    V_NODE_STATE states[8];
    size_t count = 0;
    OK(v_scene_evaluate(scene, frame, states, 8, &count));
    CHECK(count > (size_t)node);
    *state = states[node];
}

/* Out and in again as keys: the poses at whole frames are the same. */
static void there_and_back(const char *folder, const char *format, const char *name, double epsilon)
{
    V_SCENE *scene = flight(), *again = NULL;
    double first = 0, last = 0, from = 0, to = 0, frame;
    OK(v_scene_export(scene, in(folder, name), format, NULL));
    OK(v_scene_import(file, format, "as=keys\nfps=25", &again));
    OK(v_scene_frame_range(scene, &first, &last));
    OK(v_scene_frame_range(again, &from, &to));
    CHECK(last > 10 && from == first);
    NEAR(to, last, 1e-4);
    for (frame = first; frame <= last; frame++) {
        V_NODE_STATE a, b;
        int axis;
        poses_at(scene, 0, frame, &a);
        poses_at(again, 0, frame, &b);
        for (axis = 0; axis < 3; axis++) {
            NEAR(a.pose.vrp[axis], b.pose.vrp[axis], epsilon);
            NEAR(a.pose.vpn[axis], b.pose.vpn[axis], epsilon);
            NEAR(a.pose.vup[axis], b.pose.vup[axis], epsilon);
        }
    }
    v_scene_free(scene);
    v_scene_free(again);
}

static void losses(const char *folder)
{
    V_SCENE *scene = flight(), *again = NULL;
    OK(v_scene_export(scene, in(folder, "a.tum"), NULL, ""));
    CHECK(strcmp(v_last_warning(),
                 "points, speeds and holds become poses, one a frame.\nthe field of view is left out.") == 0);
    OK(v_scene_export(scene, in(folder, "a.csv"), NULL, "frames=2..4\n"));
    CHECK(strcmp(v_last_warning(), "") == 0);
    OK(v_scene_import(file, NULL, NULL, &again));
    CHECK(strncmp(v_last_warning(), "a path of 2 points", 18) == 0);
    v_scene_free(again);
    v_scene_free(scene);
}

static void refused(const char *folder)
{
    V_SCENE *scene = flight(), *again = scene;
    FILE *out;
    STATUS(V_ERR_ARGUMENT, v_scene_export(scene, in(folder, "a.csv"), "tea", NULL));
    STATUS(V_ERR_ARGUMENT, v_scene_export(scene, in(folder, "a.unknown"), NULL, NULL));
    STATUS(V_ERR_ARGUMENT, v_scene_export(scene, in(folder, "b.csv"), NULL, "node=nobody"));
    STATUS(V_ERR_ARGUMENT, v_scene_export(scene, in(folder, "b.csv"), NULL, "fps=0"));
    STATUS(V_ERR_RANGE, v_scene_export(scene, in(folder, "b.csv"), NULL, "frames=-5..1"));
    STATUS(V_ERR_IO, v_scene_export(scene, in(folder, "none/b.csv"), NULL, NULL));
    STATUS(V_ERR_NULL, v_scene_export(NULL, in(folder, "b.csv"), NULL, NULL));
    STATUS(V_ERR_NULL, v_scene_export(scene, NULL, NULL, NULL));
    STATUS(V_ERR_IO, v_scene_import(in(folder, "b.csv"), NULL, NULL, &again));
    STATUS(V_ERR_NULL, v_scene_import(file, NULL, NULL, NULL));
    out = fopen(in(folder, "broken.tum"), "w");
    fputs("0 1 2 3 0 0 0 1\n1 1 2 3 0 0 0\n", out);
    fclose(out);
    STATUS(V_ERR_FORMAT, v_scene_import(file, NULL, NULL, &again));
    CHECK(strstr(v_last_error(), "line 2: expected 8 numbers, found 7") != NULL);
    CHECK(again == scene);
    /* Nothing is left to be written. */
    OK(v_scene_remove_node(scene, 0));
    STATUS(V_ERR_ARGUMENT, v_scene_export(scene, in(folder, "b.glb"), NULL, NULL));
    STATUS(V_ERR_ARGUMENT, v_scene_export(scene, in(folder, "b.csv"), NULL, NULL));
    v_scene_free(scene);
}

int main(int count, char **arguments)
{
    const char *folder = count > 1 ? arguments[1] : ".";
    there_and_back(folder, "csv", "c.csv", 0);
    there_and_back(folder, "json", "c.json", 0);
    there_and_back(folder, "tum", "c.tum", 1e-15);
    /* 32-bit numbers. */
    there_and_back(folder, "glb", "c.glb", 1e-6);
    there_and_back(folder, "usda", "c.usda", 1e-12);
    there_and_back(folder, "colmap", "colmap", 1e-14);
    there_and_back(folder, "paraview", "c.py", 1e-15);
    losses(folder);
    refused(folder);
    return failures != 0;
}
