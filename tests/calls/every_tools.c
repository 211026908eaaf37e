/* The functions of tools on paths: see every.h. */
#include "functions.h"
#include "scene_things.h"
#include "things.h"

static const char *one_of(const char *const *names, int count)
{
    if (chance(wild)) {
        frame->unfit = 1;
        return text(below(2) ? NULL : "");
    }
    return text(names[below((unsigned)count)]);
}

static int made(int status, V_PATH *const *path)
{
    if (status == V_OK)
        frame->made_path = *path;
    return status;
}

/* Two points in their order. */
static int a_range(const V_PATH *path, int *last)
{
    int first = a_point(path);

    *last = a_point(path);
    if (first > *last && !frame->unfit) {
        int other = first;
        first = *last;
        *last = other;
    }
    return first;
}

/* A tool with options; from "tour" on they may not do for the path or the object. */
static const char *a_tool(const char **options)
{
    static const char *const tools[][2] = {
        {"reverse", ""}, {"repeat", "times=2"}, {"move", "by=0.1,0,0\nwith_targets=yes"},
        {"twist", "angle=9\nbox=-2,-2,-2,2,2,2"}, {"orbit", "turns=2\nput=append"},
        {"crane", "end-height=0.7"}, {"pan", "zoom=30"}, {"steady", "period=0.5"},
        {"tour", "seconds=30\nstart=2,2,2"}, {"retime", "seconds=9"}, {"fold", ""},
        {"orbit", "turn=2"}, {"repeat", "times=0"}};
    unsigned at = below(chance(wild) ? 13 : 8);

    if (at >= 8)
        frame->unfit = 1;
    *options = below(2) ? NULL : text(tools[at][1]);
    return chance(wild) ? one_of(&tools[at][0], 1) : text(tools[at][0]);
}

CALL(v_path_tool)
{
    V_PATH *path = a_path();
    const char *options, *name = a_tool(&options);

    return v_path_tool(path, name, options, chance(50) ? NULL : a_mesh());
}

CALL(v_scene_tool)
{
    V_SCENE *scene = a_scene();
    int node = whole(0, 0);
    const char *options, *name = a_tool(&options);

    return v_scene_tool(scene, node, name, options, chance(50) ? NULL : a_mesh());
}

CALL(v_last_number)
{
    return v_last_number(text("seconds"), result(sizeof(double), 0));
}

CALL(v_path_transform)
{
    V_PATH *path = a_path();
    int last, first = a_range(path, &last);
    double matrix[16] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};

    matrix[12] = number(-0.5, 0.5);
    matrix[5] = number(0.5, 1);
    return v_path_transform(path, first, last, given("matrix", matrix, sizeof matrix),
                            whole(0, 1));
}

CALL(v_path_extract)
{
    const V_PATH *path = a_path();
    V_PATH **block = result(sizeof *block, 0);
    int first = whole(0, 1);

    return made(v_path_extract(path, first, whole(2, 3), block), block);
}

CALL(v_path_insert_path)
{
    V_PATH *path = a_path();
    int at = a_point(path);
    const V_PATH *block = a_path();

    return v_path_insert_path(path, at, block, whole(V_FIT_NONE, V_FIT_SCALE));
}

CALL(v_path_blend)
{
    V_PATH *paths[2];
    double weights[2];
    V_PATH **blend;

    paths[0] = a_path();
    paths[1] = a_path();
    weights[0] = number(0, 1);
    weights[1] = 1 - weights[0];
    blend = result(sizeof *blend, 0);
    return made(v_path_blend(given("paths", paths, sizeof paths),
                             given("weights", weights, sizeof weights), 2, blend), blend);
}

/* Twelve poses on a way. */
static const V_POSE *some_poses(void)
{
    V_POSE poses[12];
    int k;

    for (k = 0; k < 12; k++) {
        const V_POSE pose = {{0, 0, 0}, {0, 0, 1}, {0, 1, 0}, 24};
        poses[k] = pose;
        poses[k].vrp[0] = 0.1 * k;
    }
    poses[3].vrp[1] = number(-0.1, 0.1);
    return given("poses", poses, sizeof poses);
}

static int goes_on(double share, void *user)
{
    if (!(share >= 0 && share <= 1) || user != &frame)
        fault("progress %g of %p", share, user);
    return 1;
}

CALL(v_set_progress)
{
    return v_set_progress(below(2) ? NULL : goes_on, &frame);
}

CALL(v_path_fit_poses)
{
    static const char *const fit[] = {"", "fps=30\ntolerance=0.05", "angle=1\nup=z",
                                      "points=5\nrobust=yes", "space=0,0,0,4"};
    const V_POSE *poses = some_poses();
    const char *options = chance(30) ? NULL : one_of(fit, 5);
    V_PATH **path = result(sizeof *path, 0);

    return made(v_path_fit_poses(poses, NULL, 12, options, path), path);
}

CALL(v_path_check)
{
    const V_PATH *path = a_path();
    return v_path_check(path, NULL, NULL, 0, result(sizeof(size_t), 0));
}

