/* Time, motion and matrices of a camera: see every.h. */
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

CALL(v_pose_projection)
{
    const V_POSE *pose = a_pose();
    double aspect = number(0.5, 2), front = number(0.1, 1), back = number(2, 3);
    int convention = whole(V_CLIP_OPENGL, V_CLIP_VULKAN);
    return v_pose_projection(pose, aspect, front, back, convention, result(16 * sizeof(double), 0));
}
