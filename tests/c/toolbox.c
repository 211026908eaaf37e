/*
 * Quaternions, splines, the speed curve, views and matrices: values known in
 * closed form, and what makes no sense refused with nothing written.
 */
#include "check.h"

static const double pi = 3.14159265358979323846;
static const double zero4[4] = {0, 0, 0, 0};

/* A turn by `degrees` about the y axis. */
static void about_y(double degrees, double q[4])
{
    q[0] = cos(degrees * pi / 360);
    q[1] = 0;
    q[2] = sin(degrees * pi / 360);
    q[3] = 0;
}

/* The same orientation: equal or opposite. */
static void same_turn(const double a[4], const double b[4], double epsilon, int line)
{
    double dot = a[0] * b[0] + a[1] * b[1] + a[2] * b[2] + a[3] * b[3];
    if (!(fabs(fabs(dot) - 1) <= epsilon)) {
        failures++;
        fprintf(stderr, "toolbox.c:%d: (%g %g %g %g) instead of (%g %g %g %g)\n", line, a[0],
                a[1], a[2], a[3], b[0], b[1], b[2], b[3]);
    }
}

#define SAME(a, b) same_turn(a, b, 1e-14, __LINE__)

static void slerp(void)
{
    double a[4], b[4], q[4], should[4];
    double t;
    int k;
    about_y(10, a);
    about_y(100, b);
    for (t = -2; t <= 3; t += 0.125) {
        OK(v_quat_slerp(a, b, t, q));
        about_y(10 + 90 * t, should);
        SAME(q, should);
    }
    for (k = 0; k < 4; k++)
        b[k] *= -1e200; /* the shorter way, whatever sign and length */
    OK(v_quat_slerp(a, b, 0.5, q));
    about_y(55, should);
    SAME(q, should);
    for (k = 0; k < 4; k++)
        b[k] = b[k] * 1e-200 * 1e-320; /* denormal */
    about_y(10, a);
    OK(v_quat_slerp(a, b, 0, a)); /* into an argument */
    about_y(10, should);
    SAME(a, should);

    q[0] = 77;
    STATUS(V_ERR_NULL, v_quat_slerp(NULL, b, 0, q));
    STATUS(V_ERR_NULL, v_quat_slerp(a, NULL, 0, q));
    STATUS(V_ERR_NULL, v_quat_slerp(a, a, 0, NULL));
    STATUS(V_ERR_ARGUMENT, v_quat_slerp(zero4, a, 0, q));
    STATUS(V_ERR_ARGUMENT, v_quat_slerp(a, zero4, 0, q));
    STATUS(V_ERR_ARGUMENT, v_quat_slerp(a, a, NAN, q));
    STATUS(V_ERR_ARGUMENT, v_quat_slerp(a, a, INFINITY, q));
    b[2] = NAN;
    STATUS(V_ERR_ARGUMENT, v_quat_slerp(a, b, 0, q));
    b[2] = INFINITY;
    STATUS(V_ERR_ARGUMENT, v_quat_slerp(a, b, 0, q));
    CHECK(q[0] == 77);
}

static void views_and_quaternions(void)
{
    double vpn[3] = {0, 0, 1}, vup[3] = {0, 1, 0}, q[4], identity[4] = {1, 0, 0, 0};
    double n[3], u[3];
    int i;
    OK(v_quat_from_view(vpn, vup, q));
    SAME(q, identity);
    OK(v_view_from_quat(q, n, u));
    CHECK(n[2] == 1 && u[1] == 1);
    vpn[0] = 5; /* to the side, up tilted and long */
    vpn[2] = 0;
    vup[0] = 3e100;
    vup[1] = 1e100;
    OK(v_quat_from_view(vpn, vup, q));
    about_y(90, identity);
    SAME(q, identity);
    /* Everywhere, half turns and poles too: there and back. */
    srand(1);
    for (i = 0; i < 2000; i++) {
        double a[3], b[3], side = 0, up = 0, length_a = 0;
        int k;
        for (k = 0; k < 3; k++) {
            a[k] = i < 200 ? rand() % 3 - 1 : rand() / (double)RAND_MAX - 0.5;
            b[k] = i < 200 ? rand() % 3 - 1 : rand() / (double)RAND_MAX - 0.5;
        }
        if (v_quat_from_view(a, b, q) != V_OK)
            continue;
        NEAR(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3], 1, 1e-14);
        OK(v_view_from_quat(q, n, u));
        for (k = 0; k < 3; k++)
            length_a += a[k] * a[k];
        length_a = sqrt(length_a);
        for (k = 0; k < 3; k++) {
            NEAR(n[k], a[k] / length_a, 1e-14);
            side += n[k] * u[k];
            up += u[k] * b[k];
        }
        NEAR(side, 0, 1e-14);
        CHECK(up > 0);
    }
    OK(v_view_from_quat(q, NULL, u));
    OK(v_view_from_quat(q, n, NULL));
    STATUS(V_ERR_NULL, v_view_from_quat(NULL, n, u));
    STATUS(V_ERR_ARGUMENT, v_view_from_quat(zero4, n, u));
    q[0] = 77;
    vup[0] = -10; /* along the view */
    vup[1] = vup[2] = 0;
    STATUS(V_ERR_ARGUMENT, v_quat_from_view(vpn, vup, q));
    STATUS(V_ERR_ARGUMENT, v_quat_from_view(zero4, vup, q));
    STATUS(V_ERR_ARGUMENT, v_quat_from_view(vpn, zero4, q));
    vup[1] = NAN;
    STATUS(V_ERR_ARGUMENT, v_quat_from_view(vpn, vup, q));
    STATUS(V_ERR_NULL, v_quat_from_view(NULL, vup, q));
    STATUS(V_ERR_NULL, v_quat_from_view(vpn, NULL, q));
    STATUS(V_ERR_NULL, v_quat_from_view(vpn, vup, NULL));
    CHECK(q[0] == 77);
}

/* Length 1 whatever t is, however close or far apart the ends are; and far
 * beyond them the angle is still right: 1000 turns of 1e-3 radians. */
static void slerp_at_its_limits(void)
{
    static const double many[] = {0, 1, -1, 0.3, 1e3, -1e8, 1e17, 1e300, -1.7e308};
    static const double apart[] = {0, 1e-300, 1e-17, 1e-13, 1e-9, 1e-3, 1, 1.5707963267948966};
    size_t i, k;
    double a[4] = {1, 0, 0, 0}, b[4] = {0, 0, 0, 0}, q[4];
    for (i = 0; i < sizeof many / sizeof *many; i++) {
        for (k = 0; k < sizeof apart / sizeof *apart; k++) {
            b[0] = cos(apart[k]);
            b[2] = sin(apart[k]);
            OK(v_quat_slerp(a, b, many[i], q));
            NEAR(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3], 1, 1e-14);
        }
    }
    b[0] = cos(1e-3);
    b[2] = sin(1e-3);
    OK(v_quat_slerp(a, b, 1000, q));
    NEAR(q[0], cos(1.0), 1e-12);
    NEAR(q[2], sin(1.0), 1e-12);
}

/* Length 1 where keys are nearly opposite and times unequal; a status where the
 * times are such that nothing can be computed. */
static void splines_at_their_limits(void)
{
    static const double keys[4][4] = {
        {1, 0, 0, 0}, {1e-13, 1, 0, 0}, {-1, 1e-13, 1e-14, 0}, {1e-5, -1, 1e-9, 0}};
    static const double uneven[4] = {0, 1e-12, 1, 1e9}, hopeless[4] = {-1e308, 0, 5e-324, 1e308};
    double q[4], when;
    int kind;
    for (kind = 0; kind < 2; kind++) {
        for (when = 0; when <= 1; when += 1.0 / 64) {
            OK(kind ? v_quat_spline(keys[0], uneven, 4, when, q)
                    : v_quat_tcb_spline(keys[0], uneven, NULL, 4, when, q));
            NEAR(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3], 1, 1e-14);
        }
    }
    q[0] = 77;
    STATUS(V_ERR_ARGUMENT, v_quat_tcb_spline(keys[0], hopeless, NULL, 4, 5e-324, q));
    CHECK(q[0] == 77);
}

/* Evenly spaced keys about one axis: both splines turn evenly, also where the
   times are not even but the speed is. */
static void splines(void)
{
    static const double at[5] = {0, 1, 3, 3.5, 6};
    double keys[5][4], tcb[15] = {0}, q[4], should[4], when, bad[5];
    int i;
    for (i = 0; i < 5; i++) {
        int k;
        about_y(20 * at[i], keys[i]);
        for (k = 0; k < 4; k++)
            keys[i][k] *= i % 2 ? -3 : 1;
    }
    for (when = 0; when <= 6; when += 0.05) {
        about_y(20 * when, should);
        OK(v_quat_spline(keys[0], at, 5, when, q));
        SAME(q, should);
        OK(v_quat_tcb_spline(keys[0], at, NULL, 5, when, q));
        SAME(q, should);
        OK(v_quat_tcb_spline(keys[0], at, tcb, 5, when, q));
        SAME(q, should);
    }
    /* Two keys: a slerp. */
    OK(v_quat_spline(keys[0], at, 2, 0.25, q));
    about_y(5, should);
    SAME(q, should);
    OK(v_quat_tcb_spline(keys[0], at, NULL, 2, 0.25, q));
    SAME(q, should);
    /* Full tension: at rest in every key. */
    tcb[3] = tcb[6] = 1;
    OK(v_quat_tcb_spline(keys[0], at, tcb, 5, 2, q));
    about_y(40, should);
    SAME(q, should); /* the middle, by symmetry */
    OK(v_quat_tcb_spline(keys[0], at, tcb, 5, 1.01, q));
    about_y(20, should);
    same_turn(q, should, 1e-7, __LINE__);

    q[0] = 77;
    for (i = 0; i < 2; i++) {
        /* Both functions alike. */
#define SPLINE(keys, times, count, when, q) \
    (i == 0 ? v_quat_spline(keys, times, count, when, q) \
            : v_quat_tcb_spline(keys, times, NULL, count, when, q))
        STATUS(V_ERR_NULL, SPLINE(NULL, at, 5, 1, q));
        STATUS(V_ERR_NULL, SPLINE(keys[0], NULL, 5, 1, q));
        STATUS(V_ERR_NULL, SPLINE(keys[0], at, 5, 1, NULL));
        STATUS(V_ERR_RANGE, SPLINE(keys[0], at, 1, 0, q));
        STATUS(V_ERR_RANGE, SPLINE(keys[0], at, 0, 0, q));
        STATUS(V_ERR_RANGE, SPLINE(keys[0], at, -5, 0, q));
        STATUS(V_ERR_LIMIT, SPLINE(keys[0], at, 2147483647, 0, q));
        STATUS(V_ERR_RANGE, SPLINE(keys[0], at, 5, -0.001, q));
        STATUS(V_ERR_RANGE, SPLINE(keys[0], at, 5, 6.001, q));
        CHECK(SPLINE(keys[0], at, 5, NAN, q) != V_OK);
        memcpy(bad, at, sizeof bad);
        bad[3] = bad[2]; /* not increasing */
        CHECK(SPLINE(keys[0], bad, 5, 1, q) != V_OK);
        bad[3] = NAN;
        CHECK(SPLINE(keys[0], bad, 5, 1, q) != V_OK);
        keys[4][1] = INFINITY; /* far from `when` */
        STATUS(V_ERR_ARGUMENT, SPLINE(keys[0], at, 5, 1, q));
        keys[4][1] = 0;
    }
    tcb[14] = 1.5;
    STATUS(V_ERR_RANGE, v_quat_tcb_spline(keys[0], at, tcb, 5, 1, q));
    CHECK(q[0] == 77);
}

static void speed_curve(void)
{
    double speed[10], v, f, before, u;
    int i;
    for (i = 0; i < 10; i++)
        speed[i] = 50;
    for (u = 0; u <= 1; u += 0.01) {
        OK(v_speed_curve(speed, NULL, NULL, u, &v, &f));
        NEAR(v, 50, 1e-12);
        NEAR(f, u, 1e-14);
    }
    for (i = 0; i < 10; i++)
        speed[i] = 10 + 9 * i; /* a straight line from 10 to 91 */
    for (u = 0; u <= 1; u += 0.01) {
        OK(v_speed_curve(speed, NULL, NULL, u, &v, &f));
        NEAR(v, 10 + 81 * u, 1e-11);
        NEAR(f, (10 * u + 40.5 * u * u) / 50.5, 1e-14);
    }
    before = 1;
    OK(v_speed_curve(speed, &before, &speed[9], 0, &v, NULL));
    NEAR(v, 10, 1e-12);
    OK(v_speed_curve(speed, NULL, NULL, 1, NULL, &f));
    CHECK(f == 1);
    OK(v_speed_curve(speed, NULL, NULL, 0.5, NULL, NULL));

    v = 77;
    STATUS(V_ERR_NULL, v_speed_curve(NULL, NULL, NULL, 0.5, &v, &v));
    STATUS(V_ERR_RANGE, v_speed_curve(speed, NULL, NULL, -0.01, &v, &v));
    STATUS(V_ERR_RANGE, v_speed_curve(speed, NULL, NULL, 1.01, &v, &v));
    STATUS(V_ERR_ARGUMENT, v_speed_curve(speed, NULL, NULL, NAN, &v, &v));
    before = 0.5;
    STATUS(V_ERR_RANGE, v_speed_curve(speed, &before, NULL, 0.5, &v, &v));
    STATUS(V_ERR_RANGE, v_speed_curve(speed, NULL, &before, 0.5, &v, &v));
    speed[7] = 101;
    STATUS(V_ERR_RANGE, v_speed_curve(speed, NULL, NULL, 0.5, &v, &v));
    speed[7] = NAN;
    STATUS(V_ERR_ARGUMENT, v_speed_curve(speed, NULL, NULL, 0.5, &v, &v));
    CHECK(v == 77);
}

/* m times (x, y, z, 1), m by rows. */
static void mapped(const double m[16], double x, double y, double z, double r[4])
{
    int i;
    for (i = 0; i < 4; i++)
        r[i] = m[4 * i] * x + m[4 * i + 1] * y + m[4 * i + 2] * z + m[4 * i + 3];
}

static V_POSE some_pose(void)
{
    V_POSE pose = {{1, 2, 3}, {0, 0, -1}, {0, 1, 0}, 12};
    return pose;
}

static void view_of_a_pose(void)
{
    V_POSE pose = some_pose();
    V_VIEW view;
    double m[16], r[4];
    memset(&view, 0xa5, sizeof view);
    view.size = sizeof view;
    OK(v_view_from_pose(&pose, 2, 0.5, 10, &view));
    CHECK(view.size == sizeof view && view.perspective != 0);
    CHECK(view.normal[2] == 1 && view.vrp[0] == 1); /* against the view */
    OK(v_view_matrix(&view, m));
    /* Ten before the camera: the back plane, its middle. */
    mapped(m, 1, 2, -7, r);
    NEAR(r[0], 0, 1e-14);
    NEAR(r[1], 0, 1e-14);
    NEAR(r[2], 1, 1e-14);
    CHECK(r[3] == 1);
    /* Zoom 12: 45 degrees up is the upper edge, 2:1 the right one. */
    mapped(m, 1 + 10 * 2, 2 + 10, -7, r);
    NEAR(r[0], 1, 1e-14);
    NEAR(r[1], 1, 1e-14);
    mapped(m, 1, 2, 3 - 0.5, r);
    NEAR(r[2], 0.05, 1e-14);

    view.size = 0;
    STATUS(V_ERR_SIZE, v_view_matrix(&view, m));
    STATUS(V_ERR_SIZE, v_view_from_pose(&pose, 2, 0.5, 10, &view));
    view.size = sizeof view + 1;
    STATUS(V_ERR_SIZE, v_view_matrix(&view, m));
    view.size = sizeof view;
    view.front = 77;
    STATUS(V_ERR_NULL, v_view_from_pose(NULL, 2, 0.5, 10, &view));
    STATUS(V_ERR_NULL, v_view_from_pose(&pose, 2, 0.5, 10, NULL));
    STATUS(V_ERR_RANGE, v_view_from_pose(&pose, 0, 0.5, 10, &view));
    STATUS(V_ERR_RANGE, v_view_from_pose(&pose, 2, 0, 10, &view));
    STATUS(V_ERR_RANGE, v_view_from_pose(&pose, 2, 10, 10, &view));
    CHECK(v_view_from_pose(&pose, NAN, 0.5, 10, &view) != V_OK);
    CHECK(v_view_from_pose(&pose, 2, 0.5, INFINITY, &view) != V_OK);
    pose.vup[1] = 0;
    pose.vup[2] = 5;
    STATUS(V_ERR_ARGUMENT, v_view_from_pose(&pose, 2, 0.5, 10, &view));
    CHECK(view.front == 77);
}

/* A parallel view, the window off the middle and the projection oblique. */
static void parallel_view(void)
{
    static const V_VIEW good = {
        sizeof(V_VIEW), {1, 0, 0}, {0, 0, 2}, {0, 3, 0}, {4, 0, 4}, {1, 3, -1, 1}, 1, -3, 0, 0,
    };
    V_VIEW view = good;
    double m[16], r[4];
    OK(v_view_matrix(&view, m));
    /* The window's middle, u = 2, v = 0 on n = 0, is world (3, 0, 0). */
    mapped(m, 3, 0, 0, r);
    NEAR(r[0], 0, 1e-14);
    NEAR(r[2], -0.25, 1e-14);
    /* A quarter of the way back along the projection, (-2, 0, -4). */
    mapped(m, 2.5, 1, -1, r);
    NEAR(r[0], 0, 1e-14);
    NEAR(r[1], 1, 1e-14);
    NEAR(r[2], -0.5, 1e-14);
    mapped(m, 3 - 1.5, 0, -3, r);
    NEAR(r[0], 0, 1e-14);
    NEAR(r[2], -1, 1e-14);
    CHECK(m[12] == 0 && m[13] == 0 && m[14] == 0 && m[15] == 1);

    m[0] = 77;
    STATUS(V_ERR_NULL, v_view_matrix(NULL, m));
    STATUS(V_ERR_NULL, v_view_matrix(&view, NULL));
#define WRONG(status, change) \
    do { \
        view = good; \
        change; \
        STATUS(status, v_view_matrix(&view, m)); \
    } while (0)
    WRONG(V_ERR_ARGUMENT, (view.up[1] = 0, view.up[2] = -1)); /* along the normal */
    WRONG(V_ERR_ARGUMENT, view.normal[2] = 0);
    WRONG(V_ERR_ARGUMENT, view.vrp[0] = NAN);
    WRONG(V_ERR_RANGE, view.prp[2] = 1);     /* in the front plane */
    WRONG(V_ERR_RANGE, view.back = 2);       /* before the front plane */
    WRONG(V_ERR_RANGE, view.window[1] = 1);  /* an empty window */
    WRONG(V_ERR_RANGE, view.window[3] = -2);
    CHECK(m[0] == 77);
}

static void gl_matrix(void)
{
    V_POSE pose = some_pose();
    double m[16], eye[3] = {0, 0, 0};
    int i, k;
    OK(v_pose_matrix(&pose, V_AXES_OPENGL, 0, m));
    /* By columns: looking along -z already, so only the place is taken off. */
    for (i = 0; i < 16; i++) {
        static const double should[16] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, -1, -2, -3, 1};
        NEAR(m[i], should[i], 1e-15);
    }
    pose.vpn[0] = 1; /* to the right: what was ahead is now on the left */
    pose.vpn[2] = 0;
    OK(v_pose_matrix(&pose, V_AXES_OPENGL, 0, m));
    for (i = 0; i < 3; i++)
        for (k = 0; k < 4; k++)
            eye[i] += m[4 * k + i] * (k == 0 ? 1 : k == 1 ? 2 : k == 2 ? 3 - 5 : 1);
    NEAR(eye[0], -5, 1e-14);
    NEAR(eye[1], 0, 1e-14);
    NEAR(eye[2], 0, 1e-14);
    m[0] = 77;
    STATUS(V_ERR_NULL, v_pose_matrix(NULL, V_AXES_OPENGL, 0, m));
    STATUS(V_ERR_NULL, v_pose_matrix(&pose, V_AXES_OPENGL, 0, NULL));
    pose.vrp[1] = INFINITY;
    STATUS(V_ERR_ARGUMENT, v_pose_matrix(&pose, V_AXES_OPENGL, 0, m));
    pose = some_pose();
    pose.vpn[2] = 0;
    STATUS(V_ERR_ARGUMENT, v_pose_matrix(&pose, V_AXES_OPENGL, 0, m));
    CHECK(m[0] == 77);
}

/* The closed form; 24 mm is the height of a pose's picture. */
static void fields_of_view(void)
{
    static const double heights[] = {24, 18.66, 1, 100, 1e-3};
    static const double bad[] = {0, -1, NAN, INFINITY, -INFINITY};
    double zoom;
    size_t i;
    for (i = 0; i < sizeof heights / sizeof *heights; i++)
        for (zoom = 1; zoom <= 2000; zoom *= 1.37) {
            double fov = v_fov_from_zoom(zoom, heights[i]);
            NEAR(fov, 2 * atan(heights[i] / (2 * zoom)) * 180 / pi, 1e-13);
            NEAR(v_zoom_from_fov(fov, heights[i]) / zoom, 1, 1e-13);
            CHECK(v_last_error()[0] == '\0');
        }
    NEAR(v_fov_from_zoom(12, 24), 90, 1e-13);
    NEAR(v_zoom_from_fov(90, 24), 12, 1e-14);
    /* A lens of 35 mm on a sensor 18.66 mm high is one of 45 mm on film. */
    NEAR(v_zoom_from_fov(v_fov_from_zoom(35, 18.66), 24), 35 * 24 / 18.66, 1e-12);
#define REFUSED(call, word) CHECK(isnan(call) && strstr(v_last_error(), word))
    for (i = 0; i < sizeof bad / sizeof *bad; i++) {
        REFUSED(v_fov_from_zoom(bad[i], 24), "zoom");
        REFUSED(v_fov_from_zoom(50, bad[i]), "height");
        REFUSED(v_zoom_from_fov(bad[i], 24), "field of view");
        REFUSED(v_zoom_from_fov(50, bad[i]), "height");
    }
    REFUSED(v_zoom_from_fov(180, 24), "field of view");
    REFUSED(v_fov_from_zoom(1e300, 1e-300), "field of view"); /* 0 by rounding */
    REFUSED(v_zoom_from_fov(1e-300, 1e300), "zoom");
}

int main(void)
{
    fields_of_view();
    slerp();
    views_and_quaternions();
    slerp_at_its_limits();
    splines();
    splines_at_their_limits();
    speed_curve();
    view_of_a_pose();
    parallel_view();
    gl_matrix();
    return failures != 0;
}
