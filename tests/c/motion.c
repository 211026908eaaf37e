/*
 * Poses between frames, time, motion and matrices of a camera, against closed
 * forms: a circle, lines of known length, corners of frusta; and against
 * differences of the poses.
 */
#include "check.h"

static const double pi = 3.14159265358979323846;

/* Once round a circle of radius 2 at height 0 in 200 frames at 25 a second. */
static V_PATH *circle(void)
{
    return made_by("orbit", "radius=2\nheight=0\nseconds=8");
}

static void poses_in_any_order(void)
{
    V_PATH *path = new_path();
    double frames[] = {3, 1.25, 121, 1, 64.5, 1.25};
    V_POSE poses[6], one, all[200], untouched;
    size_t count = 0, i;
    OK(v_path_sample(path, all, 200, &count));
    CHECK(count == 121); /* a way of 1.2 half sizes, 100 frames each */
    OK(v_path_poses_at(path, frames, 6, poses));
    for (i = 0; i < 6; i++) {
        OK(v_path_pose(path, frames[i], &one));
        CHECK(memcmp(&one, &poses[i], sizeof one) == 0);
        NEAR(poses[i].vrp[0], -0.6 + 1.2 * (frames[i] - 1) / 120, 1e-12);
        if (frames[i] == floor(frames[i]))
            CHECK(memcmp(&all[(size_t)frames[i] - 1], &poses[i], sizeof one) == 0);
    }
    OK(v_path_poses_at(path, frames, 0, poses));
    memset(poses, 0x5A, sizeof poses);
    memset(&untouched, 0x5A, sizeof untouched);
    frames[4] = 121.25;
    STATUS(V_ERR_RANGE, v_path_poses_at(path, frames, 6, poses));
    CHECK(strcmp(v_last_error(), "frames[4] is 121.25, but frames go from 1 to 121") == 0);
    frames[4] = 0.5;
    STATUS(V_ERR_RANGE, v_path_poses_at(path, frames, 6, poses));
    frames[4] = NAN;
    STATUS(V_ERR_RANGE, v_path_poses_at(path, frames, 6, poses));
    CHECK(memcmp(poses, &untouched, sizeof untouched) == 0);
    STATUS(V_ERR_NULL, v_path_poses_at(path, NULL, 1, poses));
    STATUS(V_ERR_NULL, v_path_poses_at(path, frames, 1, NULL));
    v_path_free(path);
    STATUS(V_ERR_HANDLE, v_path_poses_at(path, frames, 1, poses));
}

static void frames_and_seconds(void)
{
    V_PATH *path = new_path();
    double fps[] = {25, 30000.0 / 1001, 24, 59.94, 0.7}, frame, seconds;
    size_t i;
    int n, wrong = 0;
    OK(v_path_frame_at_seconds(path, 0, &frame));
    CHECK(frame == 1);
    OK(v_path_frame_at_seconds(path, 1.5, &frame));
    NEAR(frame, 38.5, 1e-13);
    OK(v_path_seconds_at_frame(path, 26, &seconds));
    CHECK(seconds == 1);
    OK(v_path_seconds_at_frame(path, 121, &seconds));
    CHECK(seconds == 4.8);
    STATUS(V_ERR_RANGE, v_path_frame_at_seconds(path, 4.800001, &frame));
    CHECK(strcmp(v_last_error(), "seconds is 4.800001, but must be between 0 and 4.8") == 0);
    STATUS(V_ERR_RANGE, v_path_frame_at_seconds(path, -1e-9, &frame));
    STATUS(V_ERR_RANGE, v_path_frame_at_seconds(path, NAN, &frame));
    STATUS(V_ERR_RANGE, v_path_seconds_at_frame(path, 121.5, &seconds));
    CHECK(strcmp(v_last_error(), "frame is 121.5, but frames go from 1 to 121") == 0);
    STATUS(V_ERR_RANGE, v_path_seconds_at_frame(path, 0.99, &seconds));
    STATUS(V_ERR_RANGE, v_path_seconds_at_frame(path, NAN, &seconds));
    CHECK(frame == 38.5 && seconds == 4.8);
    /* There and back no bit is lost at whole frames. */
    for (i = 0; i < sizeof fps / sizeof *fps; i++) {
        OK(v_path_set_number(path, "fps", fps[i]));
        for (n = 1; n <= 121; n++) {
            OK(v_path_seconds_at_frame(path, n, &seconds));
            OK(v_path_frame_at_seconds(path, seconds, &frame));
            wrong += frame != n;
            NEAR(seconds, (n - 1) / fps[i], 1e-12);
        }
    }
    CHECK(wrong == 0);
    v_path_free(path);
}

/* ---- Matrices -------------------------------------------------------------------------- */

static double dot(const double a[3], const double b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static void cross(const double a[3], const double b[3], double c[3])
{
    c[0] = a[1] * b[2] - a[2] * b[1];
    c[1] = a[2] * b[0] - a[0] * b[2];
    c[2] = a[0] * b[1] - a[1] * b[0];
}

/* m times (v, 1); m by columns. */
static void times(const double m[16], const double v[3], double result[4])
{
    int row;
    for (row = 0; row < 4; row++)
        result[row] = m[row] * v[0] + m[row + 4] * v[1] + m[row + 8] * v[2] + m[row + 12];
}

static V_POSE some_pose(double step)
{
    V_POSE pose = {{0}, {0}, {0}, 0};
    double aside[3], up[3], length;
    int k;
    for (k = 0; k < 3; k++) {
        pose.vrp[k] = 10 * sin(step + k);
        pose.vpn[k] = cos(2 * step + 3 * k);
        up[k] = sin(5 * step - k);
    }
    length = sqrt(dot(pose.vpn, pose.vpn));
    for (k = 0; k < 3; k++) pose.vpn[k] /= length;
    cross(pose.vpn, up, aside);
    length = sqrt(dot(aside, aside));
    for (k = 0; k < 3; k++) aside[k] /= length;
    cross(aside, pose.vpn, pose.vup);
    pose.zoom = 20 + 100 * fabs(sin(3 * step));
    return pose;
}

static void axes_of_other_programs(void)
{
    /* Right, up and forward of the camera along each convention's axes. */
    static const double axes[4][3][3] = {
        {{1, 0, 0}, {0, 1, 0}, {0, 0, -1}},
        {{1, 0, 0}, {0, -1, 0}, {0, 0, 1}},
        {{0, -1, 0}, {0, 0, 1}, {1, 0, 0}},
        {{-1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
    };
    double m[16], inverse[16], place[3], there[4], back[4], right[3];
    V_POSE pose;
    int convention, k, step;
    for (step = 0; step < 100; step++) {
        pose = some_pose(step);
        cross(pose.vpn, pose.vup, right);
        for (convention = 0; convention < 4; convention++) {
            OK(v_pose_matrix(&pose, convention, 0, m));
            OK(v_pose_matrix(&pose, convention, 7, inverse));
            /* A place 2 to the right, 3 above and 5 before the camera. */
            for (k = 0; k < 3; k++)
                place[k] = pose.vrp[k] + 2 * right[k] + 3 * pose.vup[k] + 5 * pose.vpn[k];
            times(m, place, there);
            for (k = 0; k < 3; k++)
                NEAR(there[k], 2 * axes[convention][0][k] + 3 * axes[convention][1][k]
                                   + 5 * axes[convention][2][k], 1e-13);
            times(inverse, there, back);
            for (k = 0; k < 3; k++) {
                NEAR(back[k], place[k], 1e-13);
                CHECK(inverse[12 + k] == pose.vrp[k]);
            }
            CHECK(there[3] == 1 && back[3] == 1);
        }
    }
    m[0] = 77;
    STATUS(V_ERR_RANGE, v_pose_matrix(&pose, 4, 0, m));
    CHECK(strstr(v_last_error(), "convention is 4; known: V_AXES_OPENGL (0)") != NULL);
    memcpy(pose.vup, pose.vpn, sizeof pose.vup);
    for (k = 0; k < 2; k++) {
        STATUS(V_ERR_ARGUMENT, v_pose_matrix(&pose, V_AXES_ROS, k, m));
        STATUS(V_ERR_NULL, v_pose_matrix(NULL, V_AXES_ROS, k, m));
        STATUS(V_ERR_NULL, v_pose_matrix(&pose, V_AXES_ROS, k, NULL));
    }
    pose.vrp[1] = INFINITY;
    STATUS(V_ERR_ARGUMENT, v_pose_matrix(&pose, V_AXES_ROS, 1, m));
    CHECK(m[0] == 77);
}

/* What v_pose_matrix() makes of a pose is taken back, also with rounding of float and a scale. */
static void poses_of_matrices(void)
{
    double m[16], zero[16] = {0};
    V_POSE pose, again;
    int convention, to_world, k, step;
    for (step = 0; step < 100; step++)
        for (convention = 0; convention < 4; convention++)
            for (to_world = 0; to_world < 2; to_world++) {
                double scale = step % 3 == 0 ? 1 : 0.01 * (step + 1);
                pose = some_pose(step);
                OK(v_pose_matrix(&pose, convention, to_world, m));
                for (k = 0; k < 12; k++)
                    m[k] *= scale;
                for (k = 12; k < 15 && !to_world; k++)
                    m[k] *= scale;
                OK(v_pose_from_matrix(m, convention, to_world, pose.zoom, &again));
                CHECK(again.zoom == pose.zoom);
                for (k = 0; k < 3; k++) {
                    NEAR(again.vrp[k], pose.vrp[k], 1e-12);
                    NEAR(again.vpn[k], pose.vpn[k], 1e-13);
                    NEAR(again.vup[k], pose.vup[k], 1e-13);
                }
                for (k = 0; k < 16; k++)
                    m[k] = (float)m[k];
                OK(v_pose_from_matrix(m, convention, to_world, 24, &again));
                NEAR(dot(again.vpn, again.vpn), 1, 1e-15);
                NEAR(dot(again.vpn, again.vup), 0, 1e-15);
                for (k = 0; k < 3; k++)
                    NEAR(again.vpn[k], pose.vpn[k], 1e-6);
            }
    again.zoom = 77;
    OK(v_pose_matrix(&pose, V_AXES_OPENGL, 0, m));
    STATUS(V_ERR_RANGE, v_pose_from_matrix(m, 4, 0, 24, &again));
    STATUS(V_ERR_ARGUMENT, v_pose_from_matrix(m, 0, 0, 0, &again));
    STATUS(V_ERR_ARGUMENT, v_pose_from_matrix(m, 0, 0, NAN, &again));
    STATUS(V_ERR_NULL, v_pose_from_matrix(NULL, 0, 0, 24, &again));
    STATUS(V_ERR_NULL, v_pose_from_matrix(m, 0, 0, 24, NULL));
    STATUS(V_ERR_ARGUMENT, v_pose_from_matrix(zero, 0, 0, 24, &again));
    CHECK(strstr(v_last_error(), "m is not the matrix of a camera") != NULL);
    for (k = 0; k < 16; k++) {
        double kept = m[k];
        m[k] = INFINITY;
        STATUS(V_ERR_ARGUMENT, v_pose_from_matrix(m, 0, k & 1, 24, &again));
        m[k] = kept;
    }
    m[11] = -1; /* a projection */
    STATUS(V_ERR_ARGUMENT, v_pose_from_matrix(m, 0, 0, 24, &again));
    m[11] = 0;
    for (k = 0; k < 3; k++)
        m[k] = -m[k]; /* a mirror */
    STATUS(V_ERR_ARGUMENT, v_pose_from_matrix(m, 0, 0, 24, &again));
    for (k = 0; k < 3; k++)
        m[k] *= -2; /* a stretch */
    STATUS(V_ERR_ARGUMENT, v_pose_from_matrix(m, 0, 1, 24, &again));
    CHECK(again.zoom == 77);
}

/* v = v turned about a world axis by degrees. */
static void turn(double v[3], int axis, double degrees)
{
    double s = sin(degrees * acos(-1) / 180), c = cos(degrees * acos(-1) / 180);
    double *a = &v[(axis + 1) % 3], *b = &v[(axis + 2) % 3], before = *a;
    *a = c * before - s * *b;
    *b = s * before + c * *b;
}

static void angles_of_a_pose(void)
{
    /* The axes in the order of the turns, and each convention's view and up. */
    static const int orders[6][3] = {{0, 1, 2}, {0, 2, 1}, {1, 0, 2}, {1, 2, 0}, {2, 0, 1}, {2, 1,
        0}};
    static const double views[4][3] = {{0, 0, -1}, {0, 0, 1}, {1, 0, 0}, {0, 0, 1}};
    static const double ups[4][3] = {{0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 1, 0}};
    static const double vrp[3] = {3, -4, 5};
    static const double seconds[] = {20, -65, 0, 89.999, 90, -90};
    double angles[3], back[3];
    V_POSE pose, again;
    int order, convention, k, step;
    for (order = 0; order < 6; order++)
        for (convention = 0; convention < 4; convention++)
            for (step = 0; step < 6; step++) {
                double view[3], up[3];
                memcpy(view, views[convention], sizeof view);
                memcpy(up, ups[convention], sizeof up);
                angles[orders[order][0]] = 130 - 17 * step;
                angles[orders[order][1]] = seconds[step];
                angles[orders[order][2]] = -40;
                for (k = 0; k < 3; k++) {
                    turn(view, orders[order][k], angles[orders[order][k]]);
                    turn(up, orders[order][k], angles[orders[order][k]]);
                }
                OK(v_pose_from_euler(vrp, angles, convention, order, 35, &pose));
                CHECK(pose.zoom == 35);
                for (k = 0; k < 3; k++) {
                    CHECK(pose.vrp[k] == vrp[k]);
                    NEAR(pose.vpn[k], view[k], 1e-14);
                    NEAR(pose.vup[k], up[k], 1e-14);
                }
                OK(v_pose_to_euler(&pose, convention, order, back));
                for (k = 0; k < 3 && step < 3; k++)
                    NEAR(back[k], angles[k], 1e-12);
                CHECK(fabs(back[orders[order][1]]) <= 90);
                OK(v_pose_from_euler(vrp, back, convention, order, 35, &again));
                for (k = 0; k < 3; k++) {
                    NEAR(again.vpn[k], pose.vpn[k], 1e-14);
                    NEAR(again.vup[k], pose.vup[k], 1e-14);
                }
            }
    /* Pitch looks down, yaw goes from z to x, and roll turns the up vector. */
    angles[0] = 30, angles[1] = 90, angles[2] = 0;
    OK(v_pose_from_euler(vrp, angles, V_AXES_VIDES, V_ORDER_ZXY, 24, &pose));
    NEAR(pose.vpn[0], cos(acos(-1) / 6), 1e-15);
    NEAR(pose.vpn[1], -0.5, 1e-15);
    STATUS(V_ERR_RANGE, v_pose_to_euler(&pose, 4, 0, back));
    STATUS(V_ERR_RANGE, v_pose_to_euler(&pose, 0, 6, back));
    CHECK(strstr(v_last_error(), "order is 6; known: V_ORDER_XYZ (0)") != NULL);
    STATUS(V_ERR_RANGE, v_pose_from_euler(vrp, angles, 0, -1, 24, &pose));
    STATUS(V_ERR_RANGE, v_pose_from_euler(vrp, angles, -1, 0, 24, &pose));
    STATUS(V_ERR_ARGUMENT, v_pose_from_euler(vrp, angles, 0, 0, -1, &pose));
    STATUS(V_ERR_NULL, v_pose_from_euler(NULL, angles, 0, 0, 24, &pose));
    STATUS(V_ERR_NULL, v_pose_from_euler(vrp, NULL, 0, 0, 24, &pose));
    STATUS(V_ERR_NULL, v_pose_from_euler(vrp, angles, 0, 0, 24, NULL));
    STATUS(V_ERR_NULL, v_pose_to_euler(NULL, 0, 0, back));
    STATUS(V_ERR_NULL, v_pose_to_euler(&pose, 0, 0, NULL));
    angles[1] = NAN;
    STATUS(V_ERR_ARGUMENT, v_pose_from_euler(vrp, angles, 0, 0, 24, &pose));
    CHECK(strstr(v_last_error(), "angles is") != NULL);
    memcpy(pose.vup, pose.vpn, sizeof pose.vup);
    STATUS(V_ERR_ARGUMENT, v_pose_to_euler(&pose, 0, 0, back));
}

/* A camera of a scene is where its axes say. */
static void axes_of_a_node(void)
{
    V_SCENE *scene = NULL;
    V_NODE_STATE state;
    double m[16], first, last, frame;
    int k;
    OK(v_scene_new(&scene));
    OK(v_scene_frame_range(scene, &first, &last));
    for (frame = first; frame <= last; frame += 7.25) {
        OK(v_scene_evaluate(scene, frame, &state, 1, NULL));
        OK(v_pose_matrix(&state.pose, V_AXES_VIDES, 1, m));
        for (k = 0; k < 16; k++)
            NEAR(m[k], state.matrix[k], 1e-12);
    }
    v_scene_free(scene);
}

static void corners_of_the_frustum(void)
{
    /* Depth near and far, and the sign of y, of each convention. */
    static const struct { int convention; double front, back, y; } kinds[] = {
        {V_CLIP_OPENGL, -1, 1, 1}, {V_CLIP_D3D, 0, 1, 1}, {V_CLIP_VULKAN, 0, 1, -1},
        {V_CLIP_OPENGL | V_CLIP_REVERSED, 1, -1, 1}, {V_CLIP_D3D | V_CLIP_REVERSED, 1, 0, 1},
        {V_CLIP_VULKAN | V_CLIP_REVERSED, 1, 0, -1},
    };
    const double aspect = 1.6, near = 0.25, far = 40;
    double m[16], corner[3], clip[4], half, reach;
    V_POSE pose = some_pose(1);
    size_t kind;
    int k;
    pose.zoom = 35;
    half = 12 / pose.zoom; /* tan of half the field of view */
    for (kind = 0; kind < sizeof kinds / sizeof *kinds; kind++) {
        OK(v_pose_projection(&pose, aspect, near, far, kinds[kind].convention, m));
        for (k = 0; k < 8; k++) {
            double z = k & 4 ? far : near;
            corner[0] = (k & 1 ? 1 : -1) * half * aspect * z;
            corner[1] = (k & 2 ? 1 : -1) * half * z;
            corner[2] = -z;
            times(m, corner, clip);
            NEAR(clip[3], z, 1e-13);
            NEAR(clip[0] / clip[3], k & 1 ? 1 : -1, 1e-13);
            NEAR(clip[1] / clip[3], kinds[kind].y * (k & 2 ? 1 : -1), 1e-13);
            NEAR(clip[2] / clip[3], k & 4 ? kinds[kind].back : kinds[kind].front, 1e-13);
        }
        /* Without an end: from the same depth at the front plane towards the same far away. */
        OK(v_pose_projection(&pose, aspect, near, INFINITY, kinds[kind].convention, m));
        corner[0] = corner[1] = 0;
        for (reach = near; reach < 1e16; reach *= 1000) {
            double share = near / reach;
            corner[2] = -reach;
            times(m, corner, clip);
            NEAR(clip[2] / clip[3],
                 kinds[kind].back + (kinds[kind].front - kinds[kind].back) * share, 1e-13);
        }
    }
    m[0] = 77;
    STATUS(V_ERR_RANGE, v_pose_projection(&pose, 0, near, far, V_CLIP_OPENGL, m));
    STATUS(V_ERR_RANGE, v_pose_projection(&pose, INFINITY, near, far, V_CLIP_OPENGL, m));
    STATUS(V_ERR_RANGE, v_pose_projection(&pose, aspect, 0, far, V_CLIP_OPENGL, m));
    STATUS(V_ERR_RANGE, v_pose_projection(&pose, aspect, INFINITY, INFINITY, V_CLIP_OPENGL, m));
    STATUS(V_ERR_RANGE, v_pose_projection(&pose, aspect, near, near, V_CLIP_OPENGL, m));
    STATUS(V_ERR_RANGE, v_pose_projection(&pose, aspect, near, NAN, V_CLIP_OPENGL, m));
    STATUS(V_ERR_RANGE, v_pose_projection(&pose, aspect, near, far, 3, m));
    STATUS(V_ERR_RANGE, v_pose_projection(&pose, aspect, near, far, 16 | 3, m));
    STATUS(V_ERR_RANGE, v_pose_projection(&pose, aspect, near, far, 32, m));
    STATUS(V_ERR_NULL, v_pose_projection(NULL, aspect, near, far, 0, m));
    STATUS(V_ERR_NULL, v_pose_projection(&pose, aspect, near, far, 0, NULL));
    pose.zoom = 0;
    STATUS(V_ERR_RANGE, v_pose_projection(&pose, aspect, near, far, 0, m));
    CHECK(m[0] == 77);
}

/* Both matrices bring a place of the world where PHIGS's view brings it, which is another
 * computation: x and y by the depth are the place in the picture. */
static void where_the_view_has_it(void)
{
    double view[16], projection[16], phigs[16], place[3], eye[4], clip[4], canonical[4];
    V_VIEW described;
    V_POSE pose;
    int step, k;
    described.size = sizeof described;
    for (step = 0; step < 100; step++) {
        pose = some_pose(step);
        OK(v_pose_matrix(&pose, V_AXES_OPENGL, 0, view));
        OK(v_pose_projection(&pose, 1.5, 0.1, 100, V_CLIP_OPENGL, projection));
        OK(v_view_from_pose(&pose, 1.5, 0.1, 100, &described));
        OK(v_view_matrix(&described, phigs));
        for (k = 0; k < 3; k++)
            place[k] = pose.vrp[k] + 7 * pose.vpn[k] + sin(step * (k + 1));
        times(view, place, eye);
        times(projection, eye, clip);
        for (k = 0; k < 3; k++)
            canonical[k] = dot(&phigs[4 * k], place) + phigs[4 * k + 3];
        NEAR(clip[0] / clip[3], canonical[0] / canonical[2], 1e-12);
        NEAR(clip[1] / clip[3], canonical[1] / canonical[2], 1e-12);
    }
}

/* ---- Motion ---------------------------------------------------------------------------- */

static V_MOTION motion_at(const V_PATH *path, double frame)
{
    V_MOTION motion;
    memset(&motion, 0x5A, sizeof motion);
    motion.size = sizeof motion;
    OK(v_path_motion(path, frame, &motion));
    CHECK(motion.size == sizeof motion);
    return motion;
}

/* Round a target that stays in view: v = r w, 1 / r, and the camera turns by w. */
static void round_a_circle(void)
{
    V_PATH *path = circle();
    size_t frames = 0;
    double frame, length;
    OK(v_path_frame_count(path, &frames));
    for (frame = 1; frame <= (double)frames; frame += 0.75) {
        V_MOTION motion = motion_at(path, frame);
        double share = (frame - 1) / (double)(frames - 1);
        double seconds = (double)(frames - 1) / 25;
        NEAR(motion.distance, 4 * pi * share, 4 * pi * 2e-4);
        NEAR(motion.speed, 4 * pi / seconds, 4 * pi / seconds * 2e-4);
        NEAR(motion.turning, 360 / seconds, 360 / seconds * 5e-3);
        NEAR(motion.curvature, 0.5, 0.02);
    }
    OK(v_path_length(path, &length));
    NEAR(motion_at(path, (double)frames).distance, length, 1e-12);
    v_path_free(path);
}

/* What differences of the poses say, on a path with everything: an ease, a pan, rests, a
 * target in view. */
static void by_differences(void)
{
    V_PATH *path = new_path();
    double corner[3] = {0.5, 0.6, 0.1}, target[3] = {0.1, 0, -0.5}, h = 1e-3, way = 0, frame;
    V_POSE pose[2];
    V_ORIENTATION o;
    size_t frames = 0;
    int k;
    OK(v_path_insert_point(path, 2, corner));
    v_orientation_init(&o);
    o.absolute = 1;
    memcpy(o.target, target, sizeof target);
    OK(v_path_set_orientation(path, 1, 0, &o));
    OK(v_path_set_orientation(path, 2, 0, &o));
    o.roll = 40;
    o.zoom = 50;
    o.hold = 5;
    OK(v_path_insert_orientation(path, 1, 1, &o));
    o.hold = 3;
    OK(v_path_set_orientation(path, 2, 0, &o));
    OK(v_path_set_numbers(path, v_path_key(0, 0, "ease"), NUMBERS(V_EASE_SINE, 0.3, 0.2, 70)));
    OK(v_path_frame_count(path, &frames));
    for (frame = 1.5; frame < (double)frames; frame += 1) {
        V_MOTION motion = motion_at(path, frame);
        double step = 0, turned = 0, a[3], b[3], right[2][3], trace;
        for (k = 0; k < 2; k++) {
            OK(v_path_pose(path, frame + (k ? h : -h), &pose[k]));
            cross(pose[k].vup, pose[k].vpn, right[k]);
        }
        for (k = 0; k < 3; k++)
            step += pow(pose[1].vrp[k] - pose[0].vrp[k], 2);
        NEAR(motion.speed, sqrt(step) / (2 * h) * 25, 1e-6);
        /* |R - 1| of a small turn: sin of it by sqrt 2, twice. */
        for (k = 0; k < 3; k++) {
            a[k] = pose[1].vpn[k] - pose[0].vpn[k];
            b[k] = pose[1].vup[k] - pose[0].vup[k];
            turned += pow(right[1][k] - right[0][k], 2);
        }
        trace = sqrt((turned + dot(a, a) + dot(b, b)) / 2);
        NEAR(motion.turning, trace / (2 * h) * 25 * 180 / pi, 1e-4);
        /* The way is the sum of what speed says: the rule of Simpson between keys. */
        way = motion_at(path, frame + 0.5).distance - motion_at(path, frame - 0.5).distance;
        NEAR(way * 25, (motion_at(path, frame - 0.4999999).speed + 4 * motion.speed
                        + motion_at(path, frame + 0.4999999).speed) / 6, 1e-3);
    }
    /* At rest and on the spot nothing moves along a way. */
    CHECK(motion_at(path, (double)frames).speed == 0);
    CHECK(motion_at(path, (double)frames).turning == 0);
    v_path_free(path);
}

static void motion_that_is_none(void)
{
    V_PATH *path = new_path();
    V_MOTION motion;
    /* Straight, at constant speed, without a turn. */
    motion = motion_at(path, 60.5);
    NEAR(motion.speed, 0.25, 1e-12);
    NEAR(motion.distance, 59.5 * 0.01, 1e-12);
    NEAR(motion.turning, 0, 1e-9);
    NEAR(motion.curvature, 0, 1e-12);
    NEAR(motion_at(path, 1).speed, 0.25, 1e-12);
    NEAR(motion_at(path, 121).speed, 0.25, 1e-12);
    OK(v_path_set_number(path, "fps", 50));
    NEAR(motion_at(path, 7).speed, 0.5, 1e-12);
    motion.speed = 77;
    STATUS(V_ERR_RANGE, v_path_motion(path, 121.5, &motion));
    STATUS(V_ERR_RANGE, v_path_motion(path, 0, &motion));
    STATUS(V_ERR_RANGE, v_path_motion(path, NAN, &motion));
    STATUS(V_ERR_NULL, v_path_motion(path, 1, NULL));
    motion.size = 8;
    STATUS(V_ERR_SIZE, v_path_motion(path, 1, &motion));
    CHECK(motion.speed == 77);
    v_path_free(path);
}

int main(void)
{
    poses_in_any_order();
    frames_and_seconds();
    axes_of_other_programs();
    poses_of_matrices();
    angles_of_a_pose();
    axes_of_a_node();
    corners_of_the_frustum();
    where_the_view_has_it();
    round_a_circle();
    by_differences();
    motion_that_is_none();
    return failures != 0;
}
