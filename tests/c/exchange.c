/*
 * Scenes in files of other programs: exchange FOLDER.
 */
#include "check.h"

#include <sys/stat.h>
#include <unistd.h>

static const char AIMING[] =
    "version = 1\n"
    "[[node]]\nname = \"mark\"\nkind = \"group\"\n"
    "[[node.track]]\nchannel = \"position\"\ninterpolation = \"host:none\"\n"
    "frames = [1.0, 9.0]\nvalues = [[0.0, 0.0, 1.0], [1.0, 0.0, 0.0]]\n"
    "[[node]]\nname = \"camera\"\nkind = \"camera\"\naim = \"mark\"\nposition = [0.0, 0.0, 3.0]\n";

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

/* Errors and warnings count and name as the header does. */
static void words_are_those_of_c(const char *folder)
{
    V_SCENE *scene = flight(), *again = NULL;
    FILE *out;
    STATUS(V_ERR_ARGUMENT, v_scene_export(scene, in(folder, "x.unknown"), NULL, NULL));
    CHECK(strstr(v_last_error(), "no format has this ending: name it, with format") != NULL);
    CHECK(strstr(v_last_error(), "--") == NULL);
    out = fopen(in(folder, "x.unknown"), "w");
    fputs("nothing", out);
    fclose(out);
    STATUS(V_ERR_FORMAT, v_scene_import(file, NULL, NULL, &again));
    CHECK(strstr(v_last_error(), "name it, with format") != NULL && strstr(v_last_error(), "--") == NULL);
    OK(v_scene_export(scene, in(folder, "late.csv"), NULL, "frames=1..3"));
    out = fopen(file, "w");
    fputs("frame,vrp_x,vrp_y,vrp_z,vpn_x,vpn_y,vpn_z,vup_x,vup_y,vup_z,zoom,seconds\n"
          "1,0,0,1,0,0,-1,0,1,0,24,0\n2,1,0,1,0,0,-1,0,1,0,24,0.04\n"
          "3,2,0,1,0,0,-1,0,1,0,24,9\n", out);
    fclose(out);
    OK(v_scene_import(file, "csv", "fps=25", &again));
    CHECK(strstr(v_last_warning(), "by the seconds pose 2 (counted from 0) would be at 9 s") != NULL);
    if (again != NULL)
        v_scene_free(again);
    v_scene_free(scene);
}

/* What was told of a call that succeeded does not stand beside one that fails. */
static void warnings_are_the_last_calls(const char *folder)
{
    V_SCENE *scene = flight(), *again = NULL;
    OK(v_scene_export(scene, in(folder, "w.tum"), NULL, NULL));
    CHECK(v_last_warning()[0] != '\0');
    STATUS(V_ERR_IO, v_scene_export(scene, in(folder, "none/w.tum"), NULL, NULL));
    CHECK(strcmp(v_last_warning(), "") == 0);
    OK(v_scene_import(in(folder, "w.tum"), NULL, NULL, &again));
    CHECK(v_last_warning()[0] != '\0');
    v_scene_free(again);
    STATUS(V_ERR_IO, v_scene_import(in(folder, "none.tum"), NULL, NULL, &again));
    CHECK(strcmp(v_last_warning(), "") == 0);
    v_scene_free(scene);
}

/* A folder of files is written wholly or not at all, and is made in one that is there. */
static void folders_are_whole(const char *folder)
{
    V_SCENE *scene = flight();
    char text[8] = "";
    FILE *old;
    CHECK(mkdir(in(folder, "half"), 0777) == 0 && mkdir(in(folder, "half/points3D.txt"), 0777) == 0);
    old = fopen(in(folder, "half/cameras.txt"), "w");
    fputs("old", old);
    fclose(old);
    STATUS(V_ERR_IO, v_scene_export(scene, in(folder, "half"), "colmap", NULL));
    old = fopen(in(folder, "half/cameras.txt"), "r");
    CHECK(fread(text, 1, sizeof text, old) == 3 && strcmp(text, "old") == 0);
    fclose(old);
    CHECK(access(in(folder, "half/images.txt"), F_OK) != 0);
    STATUS(V_ERR_IO, v_scene_export(scene, in(folder, "new/deep"), "colmap", NULL));
    CHECK(access(in(folder, "new"), F_OK) != 0);
    v_scene_free(scene);
}

/* A camera that aims at what a function of the host moves, which is not there. */
static void aims_that_fail_are_told(const char *folder)
{
    V_SCENE *scene = NULL;
    OK(v_scene_load_from_memory(AIMING, strlen(AIMING), &scene));
    STATUS(V_ERR_ARGUMENT, v_scene_export(scene, in(folder, "aim.tum"), NULL, NULL));
    CHECK(strstr(v_last_error(), "node \"mark\": channel \"position\": no interpolation \"host:none\"") != NULL);
    CHECK(access(in(folder, "aim.tum"), F_OK) != 0);
    v_scene_free(scene);
}

static void write_text(const char *folder, const char *name, const char *text)
{
    FILE *out = fopen(in(folder, name), "w");
    CHECK(out != NULL);
    if (out) {
        fputs(text, out);
        fclose(out);
    }
}

static int has(const char *folder, const char *name, const char *part)
{
    static char text[1 << 20];
    FILE *read = fopen(in(folder, name), "r");
    size_t length = 0;
    if (read) {
        length = fread(text, 1, sizeof text - 1, read);
        fclose(read);
    }
    text[length] = '\0';
    return strstr(text, part) != NULL;
}

/* The object of a path, named by its file, goes along; one that is gone is told. */
static void objects_of_paths_go_along(const char *folder)
{
    V_SCENE *scene = NULL;
    write_text(folder, "plate.obj", "v 0 0 0\nv 0.5 0 0\nv 0 0 0.5\nf 1 2 3\n");
    write_text(folder, "flight.vid",
               "version = 1\n[object]\nfile = \"plate.obj\"\n"
               "[[point]]\nposition = [0.0, 0.5, 0.5]\n[[point.orientation]]\n"
               "[[point]]\nposition = [0.5, 0.5, 0.5]\n[[point.orientation]]\n");
    OK(v_scene_load(in(folder, "flight.vid"), &scene));
    CHECK(v_last_warning()[0] == '\0');
    OK(v_scene_export(scene, in(folder, "object.usda"), NULL, NULL));
    CHECK(has(folder, "object.usda", "def Mesh"));
    v_scene_free(scene);
    scene = NULL;
    CHECK(remove(in(folder, "plate.obj")) == 0);
    OK(v_scene_load(in(folder, "flight.vid"), &scene));
    CHECK(strstr(v_last_warning(), "plate.obj") != NULL);
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
    warnings_are_the_last_calls(folder);
    words_are_those_of_c(folder);
    folders_are_whole(folder);
    aims_that_fail_are_told(folder);
    objects_of_paths_go_along(folder);
    return failures != 0;
}
