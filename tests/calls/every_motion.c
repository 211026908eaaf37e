/* Time, motion and matrices of a camera; what a path gives back as it was set: see every.h. */
#include <string.h>

#include "functions.h"
#include "things.h"

static double a_frame(const V_PATH *path)
{
    size_t frames;

    if (v_path_frame_count(path, &frames) != V_OK)
        frames = 1;
    return number(1, (double)frames);
}

CALL(v_path_poses_at)
{
    const V_PATH *path = a_path();
    const double *frames = numbers(3, 1, 1);
    return v_path_poses_at(path, frames, 3, result(3 * sizeof(V_POSE), 0));
}

CALL(v_path_frame_at_seconds)
{
    const V_PATH *path = a_path();
    double seconds = number(0, 0);
    return v_path_frame_at_seconds(path, seconds, result(sizeof(double), 0));
}

CALL(v_path_seconds_at_frame)
{
    const V_PATH *path = a_path();
    double at = a_frame(path);
    return v_path_seconds_at_frame(path, at, result(sizeof(double), 0));
}

CALL(v_path_motion)
{
    const V_PATH *path = a_path();
    double at = a_frame(path);
    V_MOTION motion;

    memset(&motion, 0x5A, sizeof motion);
    motion.size = chance(wild) ? below(400) : sizeof motion;
    frame->unfit |= motion.size != sizeof motion;
    return v_path_motion(path, at, (V_MOTION *)given("V_MOTION", &motion, sizeof motion));
}

CALL(v_pose_matrix)
{
    const V_POSE *pose = a_pose();
    int convention = whole(V_AXES_OPENGL, V_AXES_VIDES), to_world = whole(0, 1);
    return v_pose_matrix(pose, convention, to_world, result(16 * sizeof(double), 0));
}

CALL(v_pose_from_matrix)
{
    double m[16] = {1, 0, 0, 0, 0, 0, 1, 0, 0, -1, 0, 0, 0, 0, 0, 1};
    int convention = whole(V_AXES_OPENGL, V_AXES_VIDES), to_world = whole(0, 1);
    double zoom;

    m[12] = number(-0.5, 0.5);
    m[14] = number(-2, 2);
    zoom = number(1, 100);
    return v_pose_from_matrix(given("m", m, sizeof m), convention, to_world, zoom,
                              result(sizeof(V_POSE), 0));
}

CALL(v_pose_to_euler)
{
    const V_POSE *pose = a_pose();
    int convention = whole(V_AXES_OPENGL, V_AXES_VIDES), order = whole(V_ORDER_XYZ, V_ORDER_ZYX);
    return v_pose_to_euler(pose, convention, order, result(3 * sizeof(double), 0));
}

CALL(v_pose_from_euler)
{
    const double *vrp = numbers(3, -1, 1), *angles = numbers(3, -400, 400);
    int convention = whole(V_AXES_OPENGL, V_AXES_VIDES), order = whole(V_ORDER_XYZ, V_ORDER_ZYX);
    double zoom = number(1, 100);
    return v_pose_from_euler(vrp, angles, convention, order, zoom, result(sizeof(V_POSE), 0));
}

CALL(v_pose_projection)
{
    const V_POSE *pose = a_pose();
    double aspect = number(0.5, 2), front = number(0.1, 1), back = number(2, 3);
    int convention = whole(V_CLIP_OPENGL, V_CLIP_VULKAN);
    return v_pose_projection(pose, aspect, front, back, convention, result(16 * sizeof(double), 0));
}

/* ---- What was set ---------------------------------------------------------------------- */

CALL(v_path_move_point)
{
    V_PATH *path = a_path();
    int from = a_point(path);
    return v_path_move_point(path, from, a_point(path));
}

CALL(v_path_get_up)
{
    const V_PATH *path = a_path();
    int point = a_point(path), at = an_orientation(path, point), status;
    const char **up = result(sizeof *up, 1);
    double *place = result(3 * sizeof *place, 1);
    V_PATH **made = result(sizeof *made, 1);

    status = v_path_get_up(path, point, at, up, place, made);
    if (status == V_OK && made != NULL && *made != NULL)
        frame->made_path = *made;
    return status;
}

CALL(v_path_get_object)
{
    const V_PATH *path = a_path();
    V_MESH mesh;

    memset(&mesh, 0x5A, sizeof mesh);
    mesh.size = chance(wild) ? below(400) : sizeof mesh;
    frame->unfit |= mesh.size != sizeof mesh;
    return v_path_get_object(path, (V_MESH *)given("V_MESH", &mesh, sizeof mesh));
}
