/*
 * Progress: a callback that is told how far a call is, may end it, and may call anything. Objects
 * are as bad as they come: triangles at random, each as large as all of the object.
 */
#include <time.h>

#include "check.h"

#define TRIANGLES 30000

static double points[9 * TRIANGLES];
static unsigned corners[3 * TRIANGLES];
static V_MESH object;

/* Seconds of the processor that this thread has had: others may be busy. */
static double now(void)
{
    struct timespec time;
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return (double)time.tv_sec + 1e-9 * (double)time.tv_nsec;
}

static void make_object(void)
{
    unsigned long long state = 1;
    int i;
    for (i = 0; i < 9 * TRIANGLES; i++) {
        state = state * 6364136223846793005ULL + 1442695040888963407ULL;
        points[i] = (double)(state >> 11) / (double)(1ULL << 52) - 1;
    }
    for (i = 0; i < 3 * TRIANGLES; i++)
        corners[i] = (unsigned)i;
    memset(&object, 0, sizeof object);
    object.size = sizeof object;
    object.xyz = points;
    object.points = 3 * TRIANGLES;
    object.triangles = corners;
    object.corners = 3 * TRIANGLES;
}

/* What the callback is to do, and what it saw. */
static struct {
    V_PATH *path;  /* the one that the call works on */
    V_PATH *other;
    double end;    /* when it says no */
    double longest, last;
    int calls, in_range;
} seen;

static V_SCENE *seen_scene;

static int progress(double share, void *user)
{
    double time = now();
    CHECK(user == &seen);
    if (seen.calls > 0 && time - seen.last > seen.longest)
        seen.longest = time - seen.last;
    seen.last = time;
    seen.calls++;
    seen.in_range &= share >= 0 && share <= 1;
    if (seen.path != NULL) {
        int count;
        double xyz[3] = {0, 0, 0};
        STATUS(V_ERR_BUSY, set_position(seen.path, 0, xyz));
        OK(v_path_point_count(seen.other, &count));
        STATUS(V_ERR_RANGE, set_position(seen.other, 99, xyz));
    }
    return time < seen.end;
}

static void begin(V_PATH *path, V_PATH *other, double seconds)
{
    memset(&seen, 0, sizeof seen);
    seen.path = path;
    seen.other = other;
    seen.in_range = 1;
    seen.end = now() + seconds;
}

/* A path of many points round and through the object. */
static V_PATH *flight(int turns)
{
    return made_by("orbit", "radius=1.5\nheight=0.2\nturns=%d\nseconds=%d", turns, 4 * turns);
}

static char *text_of(V_PATH *path)
{
    size_t length = 0;
    char *text;
    OK(v_path_save_to_memory(path, NULL, 0, &length));
    text = malloc(length + 1);
    if (text == NULL)
        exit(2);
    OK(v_path_save_to_memory(path, text, length + 1, &length));
    return text;
}

static void each_call_ends(void)
{
    V_PATH *path = flight(40), *other = new_path(), *made = NULL;
    V_POSE *poses;
    size_t count = 0, found = 0;
    char *before = text_of(path), *after;
    int which, ended = 0;

    OK(v_path_frame_count(path, &count));
    poses = malloc(count * sizeof *poses);
    if (poses == NULL)
        exit(2);
    OK(v_path_sample(path, poses, count, &count));
    OK(v_set_progress(progress, &seen));
    for (which = 0; which < 10; which++) {
        int status = V_OK;
        double start;
        begin(which == 7 ? NULL : path, other, 0);
        start = now();
        switch (which) {
        case 0: status = tool(path, "retime", NULL, "seconds=0\nfirst=1\nlast=481"); break;
        case 1: status = tool(path, "steady", NULL, "period=1\nwithin=0"); break;
        case 2: status = tool(path, "avoid", &object, "clearance=0.9\nradius=0"); break;
        case 3: status = tool(path, "picture", &object, "margin=0.1\nwhat=zoom"); break;
        case 4: status = tool(path, "picture", &object, "margin=0.1\nwhat=distance"); break;
        case 5: status = tool(path, "picture", &object, "margin=0.1\nwhat=view"); break;
        case 6: seen.path = NULL; /* it is only read */
                status = v_path_check(path, &object, NULL, 0, &found); break;
        case 7: status = v_path_fit_poses(poses, NULL, count, "tolerance=1e-4\nangle=0.1", &made); break;
        default: status = tool(path, "tour", &object, which == 8 ? "" : "inside=yes");
        }
        after = text_of(path);
        if (status == V_OK && seen.calls == 0) { /* it took less than a tenth of a second */
            free(before);
            before = after;
            if (made != NULL)
                v_path_free(made);
            made = NULL;
            continue;
        }
        CHECK(strcmp(before, after) == 0);
        free(after);
        ended++;
        if (status != V_ERR_REFUSED || seen.calls != 1 || now() - start > 2.5) {
            fprintf(stderr, "call %d: %s after %d calls, %.2f s: %s\n", which, v_strerror(status),
                    seen.calls, now() - start, v_last_error());
            failures++;
        }
    }
    /* On a fast machine few calls take long enough to be asked; tours always do. */
    CHECK(made == NULL && ended >= 2);
    free(before);
    free(poses);
    OK(v_set_progress(NULL, NULL));
    v_path_free(path);
    v_path_free(other);
}

/* It is asked often, and what it does there does no harm. */
static void it_is_asked_often(void)
{
    V_PATH *path = flight(2), *other = new_path();
    int round;

    OK(v_set_progress(progress, &seen));
    for (round = 0; round < 3; round++) {
        begin(path, other, 1);
        if (round == 0)
            tool(path, "avoid", &object, "clearance=0.9\nradius=0");
        else
            tool(path, "tour", &object, round == 1 ? "" : "inside=yes");
        if (!seen.in_range || seen.longest > 0.5) {
            fprintf(stderr, "round %d: %d calls, %.2f s between two\n", round, seen.calls, seen.longest);
            failures++;
        }
        printf("note: round %d: %d calls, %.2f s between two at the longest\n", round, seen.calls,
               seen.longest);
    }
    /* What was set for another thread, or not at all, is not asked. */
    OK(v_set_progress(NULL, &seen));
    begin(path, other, 0);
    OK(tool(path, "retime", NULL, "seconds=0\nfirst=1\nlast=25"));
    CHECK(seen.calls == 0);
    v_path_free(path);
    v_path_free(other);
}

static int asks_the_scene(double share, void *user)
{
    V_SCENE *other = NULL;
    double first;
    int count, *calls = user;

    (void)share;
    STATUS(V_ERR_BUSY, v_scene_count(seen_scene, 0, "nodes", &count));
    STATUS(V_ERR_BUSY, v_scene_frame_range(seen_scene, &first, NULL));
    STATUS(V_ERR_BUSY, v_scene_set_number(seen_scene, "fps", 30));
    OK(v_scene_new(&other));
    OK(v_scene_count(other, 0, "nodes", &count));
    v_scene_free(other);
    ++*calls;
    return 0;
}

/* Of a scene that the call works on nothing is waited for. */
static void a_scene_in_use_is_busy(void)
{
    V_PATH *path = flight(2), *after = NULL;
    int calls = 0, points = 0;

    OK(v_scene_new(&seen_scene));
    OK(v_scene_set_path(seen_scene, 0, path, 1, V_AFTER_HOLD));
    OK(v_set_progress(asks_the_scene, &calls));
    STATUS(V_ERR_REFUSED, v_scene_tool(seen_scene, 0, "tour", NULL, &object));
    OK(v_set_progress(NULL, NULL));
    CHECK(calls == 1);
    OK(v_scene_get_path(seen_scene, 0, &after, NULL, NULL));
    OK(v_path_point_count(after, &points));
    CHECK(points == 25);
    v_path_free(after);
    v_path_free(path);
    v_scene_free(seen_scene);
}

int main(void)
{
    make_object();
    a_scene_in_use_is_busy();
    each_call_ends();
    it_is_asked_often();
    return failures != 0;
}
