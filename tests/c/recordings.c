/* Paths made of recorded poses, and what a check finds in a plain one. */
#include "check.h"

static V_PATH *orbit(double seconds)
{
    return made_by("orbit", "around=0,0.5,0\nradius=1.2\nseconds=%g", seconds);
}

static void recorded_poses_are_fitted(void)
{
    V_PATH *path = orbit(20), *fitted = NULL;
    static V_POSE poses[500], again[500];
    size_t count = 0, i;
    int points;

    OK(v_path_sample(path, poses, 500, &count));
    CHECK(count == 500);
    OK(v_path_fit_poses(poses, NULL, count, "tolerance=0.01", &fitted));
    OK(v_path_point_count(fitted, &points));
    CHECK(points <= 13);
    OK(v_path_sample(fitted, again, 500, &count));
    CHECK(count == 500);
    for (i = 0; i < count; i++)
        NEAR(again[i].vrp[0], poses[i].vrp[0], 0.0101);
    v_path_free(fitted);
    STATUS(V_ERR_ARGUMENT, v_path_fit_poses(poses, NULL, 1, "tolerance=0.01", &fitted));
    STATUS(V_ERR_RANGE, v_path_fit_poses(poses, NULL, 500, "tolerance=0", &fitted));
    poses[7].zoom = NAN;
    STATUS(V_ERR_RANGE, v_path_fit_poses(poses, NULL, 500, "tolerance=0.01", &fitted));
    v_path_free(path);
}

/* What a fit found is said: a cut meets both sides, and the warning names it. */
static void a_fit_reports(void)
{
    V_PATH *path = orbit(4), *fitted = NULL;
    static V_POSE poses[100], again[100];
    size_t count = 0, i;

    OK(v_path_sample(path, poses, 100, &count));
    CHECK(count == 100);
    for (i = 40; i < count; i++)
        poses[i].vrp[1] += 3;
    OK(v_path_fit_poses(poses, NULL, count, "tolerance=0.01", &fitted));
    CHECK(strstr(v_last_warning(), " points for 100 poses at 25 frames per second") != NULL);
    CHECK(strstr(v_last_warning(), "Found: 1 cut.") != NULL);
    OK(v_path_sample(fitted, again, 100, &count));
    CHECK(count == 100);
    for (i = 0; i < count; i++)
        NEAR(again[i].vrp[1], poses[i].vrp[1], 0.0101);
    v_path_free(fitted);
    v_path_free(path);
}

/* A camera that rests, poses at equal times, and times in nanoseconds are recordings, too. */
static void no_recording_is_refused(void)
{
    V_PATH *path = orbit(4), *fitted = NULL;
    static V_POSE poses[100], rests[60];
    static double seconds[100];
    size_t count = 0, frames, i;
    int points;

    OK(v_path_sample(path, poses, 100, &count));
    CHECK(count == 100);
    for (i = 0; i < 60; i++)
        rests[i] = poses[0];
    OK(v_path_fit_poses(rests, NULL, 60, "tolerance=0.01", &fitted));
    OK(v_path_point_count(fitted, &points));
    OK(v_path_frame_count(fitted, &frames));
    CHECK(points == 2 && frames == 60);
    v_path_free(fitted);
    for (i = 0; i < count; i++)
        seconds[i] = (i / 2) / 12.5;
    OK(v_path_fit_poses(poses, seconds, count, "tolerance=0.01", &fitted));
    v_path_free(fitted);
    for (i = 0; i < count; i++)
        seconds[i] = 1403636580838555648.0 + i * 40e6;
    OK(v_path_fit_poses(poses, seconds, count, "tolerance=0.01", &fitted));
    OK(v_path_frame_count(fitted, &frames));
    CHECK(frames == 100);
    v_path_free(fitted);
    v_path_free(path);
}

/* Times that are no seconds, and a frame far away: refused before any work, which would take
 * hours and all memory. */
static void times_that_span_too_many_frames_are_refused(void)
{
    V_PATH *path = orbit(4), *fitted = NULL;
    static V_POSE poses[100];
    static double seconds[100];
    const double steps[] = {33e6, 1e30, INFINITY};
    size_t count = 0, i, k;

    OK(v_path_sample(path, poses, 100, &count));
    CHECK(count == 100);
    for (k = 0; k < 3; k++) {
        for (i = 0; i < count; i++)
            seconds[i] = i == 0 ? 0 : i * steps[k];
        if (k == 2)
            for (i = 0; i + 1 < count; i++)
                seconds[i] = (double)i;
        STATUS(V_ERR_LIMIT, v_path_fit_poses(poses, seconds, count, "tolerance=0.01", &fitted));
        CHECK(fitted == NULL && strstr(v_last_error(), "times are seconds") != NULL);
        STATUS(V_ERR_LIMIT,
               v_path_fit_poses(poses, seconds, count, "tolerance=0.01\nrobust=yes", &fitted));
    }
    for (i = 0; i < count; i++)
        seconds[i] = i + 1 < count ? (double)i : 1e9;
    STATUS(V_ERR_LIMIT, v_path_fit_poses(poses, seconds, count, "fps=1\ntolerance=0.01", &fitted));
    v_path_free(path);
}

/* A hold between sections without an ease is no finding; a limit that the host sets counts. */
static void a_plain_hold_is_no_finding(void)
{
    V_PATH *path = NULL;
    V_FINDING found[8];
    const double summit[3] = {0, 0.4, 0.9};
    size_t count = 99;

    OK(v_path_new(&path));
    OK(v_path_insert_point(path, 1, summit));
    OK(v_path_set_number(path, "point.2.hold", 25));
    OK(v_path_check(path, NULL, NULL, 0, &count));
    CHECK(count == 0);
    OK(v_path_set_number(path, "check.speed-jump", 0.4));
    OK(v_path_check(path, NULL, found, 8, &count));
    CHECK(count == 1 && strcmp(found[0].kind, "speed-jump") == 0);
    v_path_free(path);
}

int main(void)
{
    recorded_poses_are_fitted();
    no_recording_is_refused();
    a_fit_reports();
    times_that_span_too_many_frames_are_refused();
    a_plain_hold_is_no_finding();
    return failures != 0;
}
