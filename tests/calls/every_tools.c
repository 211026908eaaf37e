/* The functions of tools on paths: see every.h. */
#include "functions.h"
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

CALL(v_path_from_move)
{
    static const char *const moves[] = {"orbit", "spiral", "arc", "flyby", "approach",
                                        "dolly-zoom", "crane", "figure-eight"};
    const char *name = one_of(moves, 8);
    const double *parameters = numbers(3, -1, 1);
    V_PATH **path = result(sizeof *path, 0);

    return made(v_path_from_move(name, parameters, 3, path), path);
}

CALL(v_path_from_move_in_space)
{
    const double *parameters = numbers(3, -1, 1);
    const V_SPACE *space = a_space();
    V_PATH **path = result(sizeof *path, 0);

    return made(v_path_from_move_in_space(text("orbit"), parameters, 3, space, path), path);
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

CALL(v_path_tool)
{
    static const char *const names[] = {"reverse", "repeat", "move", "turn"};
    V_PATH *path = a_path();
    const char *name = one_of(names, 4);

    return v_path_tool(path, name, below(2) ? NULL : text(""), NULL);
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

CALL(v_path_deform)
{
    static const char *const kinds[] = {"taper", "twist", "bend"};
    V_PATH *path = a_path();
    int last, first = a_range(path, &last);
    const char *kind = one_of(kinds, 3);
    double parameters[2] = {1, 0.5};
    const double box[6] = {-2, -2, -2, 2, 2, 2};

    parameters[1] = number(0.1, 2);
    return v_path_deform(path, first, last, kind, given("parameters", parameters,
        sizeof parameters),
                         2, below(2) ? NULL : given("box", box, sizeof box), whole(0, 1));
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
    const V_POSE *poses = some_poses();
    V_PATH **path = result(sizeof *path, 0);

    return made(v_path_fit_poses(poses, NULL, 12, number(1, 100), number(0.01, 0.1),
                                 number(0.1, 2), path), path);
}

CALL(v_path_fit_poses_in_space)
{
    const V_POSE *poses = some_poses();
    const V_SPACE *space = a_space();
    V_PATH **path = result(sizeof *path, 0);

    return made(v_path_fit_poses_in_space(poses, NULL, 12, number(1, 100), number(0.01, 0.1),
                                          number(0.1, 2), space, path), path);
}

CALL(v_path_fit_poses_robust)
{
    const V_POSE *poses = some_poses();
    const V_SPACE *space = a_space();
    size_t *left_out = result(sizeof *left_out, 1);
    V_PATH **path = result(sizeof *path, 0);

    return made(v_path_fit_poses_robust(poses, NULL, 12, number(1, 100), number(0.01, 0.1),
                                        number(0.1, 2), space, left_out, path), path);
}

CALL(v_path_check)
{
    const V_PATH *path = a_path();
    return v_path_check(path, NULL, NULL, 0, result(sizeof(size_t), 0));
}

