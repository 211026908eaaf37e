/*
 * The contract of statuses, of v_last_error(), and of v_haupt() and
 * v_free_liste(), which answer nothing.
 */
#include <pthread.h>
#include <unistd.h>

#include "check.h"

static void texts(void)
{
    char version[40];
    int status;
    sprintf(version, "%d.%d.%d", V_VERSION_MAJOR, V_VERSION_MINOR, V_VERSION_PATCH);
    CHECK(strcmp(v_version(), version) == 0);
    CHECK(V_OK == 0);
    for (status = V_OK; status <= V_ERR_INTERNAL; status++) {
        int other;
        CHECK(v_strerror(status)[0] != '\0');
        for (other = V_OK; other < status; other++)
            CHECK(strcmp(v_strerror(status), v_strerror(other)) != 0);
    }
    CHECK(v_strerror(-1) != NULL && v_strerror(14) != NULL && v_strerror(1 << 30) != NULL);
}

static void last_error(void)
{
    V_PATH *path;
    int count = 77;
    char kept[200];

    CHECK(strcmp(v_last_error(), "") == 0);
    path = new_path();
    CHECK(strcmp(v_last_error(), "") == 0);

    STATUS(V_ERR_NULL, v_path_point_count(path, NULL));
    sprintf(kept, "%.150s", v_last_error());
    /* Asking changes nothing. */
    (void)v_strerror(V_ERR_NULL);
    (void)v_version();
    CHECK(strcmp(v_last_error(), kept) == 0);

    OK(v_path_point_count(path, &count));
    CHECK(strcmp(v_last_error(), "") == 0);

    /* Functions without a status tell by the message alone. */
    v_path_free(path);
    CHECK(strcmp(v_last_error(), "") == 0);
    v_path_free(path);
    CHECK(strcmp(v_last_error(), "") != 0);
    v_path_free(NULL);
    CHECK(strcmp(v_last_error(), "") == 0);
    v_orientation_init(NULL);
    CHECK(strcmp(v_last_error(), "") != 0);
    v_free_liste(NULL);
    CHECK(strcmp(v_last_error(), "") == 0);
}

static void *other_thread(void *message)
{
    CHECK(strcmp(v_last_error(), "") == 0);
    STATUS(V_ERR_HANDLE, v_path_remove_point((V_PATH *)(size_t)7, 0));
    CHECK(v_last_error() != (const char *)message);
    return NULL;
}

static void each_thread_has_its_own(void)
{
    pthread_t thread;
    char kept[200];
    STATUS(V_ERR_NULL, v_path_new(NULL));
    sprintf(kept, "%.150s", v_last_error());
    CHECK(pthread_create(&thread, NULL, other_thread, (void *)v_last_error()) == 0);
    pthread_join(thread, NULL);
    CHECK(strcmp(v_last_error(), kept) == 0);
}

/* A name so long that no message holds it, of characters of three bytes: the
 * middle is left out (an ellipsis, three bytes too), the reason is there. */
static void a_long_message_stays_text(void)
{
    static char name[3 * 20000 + 1];
    V_PATH *path = NULL;
    const unsigned char *text;
    size_t i;
    for (i = 0; i + 3 < sizeof name; i += 3)
        memcpy(name + i, "\xe2\x82\xac", 3);
    STATUS(V_ERR_IO, v_path_load(name, &path));
    CHECK(path == NULL);
    /* Whole characters only. */
    text = (const unsigned char *)v_last_error();
    while (*text != '\0') {
        if (*text < 0x80) {
            text++;
        } else if (memcmp(text, "\xe2\x82\xac", 3) == 0
                   || memcmp(text, "\xe2\x80\xa6", 3) == 0) {
            text += 3;
        } else {
            CHECK(!"a broken character");
            break;
        }
    }
    CHECK(strstr(v_last_error(), ": File name too long") != NULL);
}

/* A file's name need not be UTF-8; a message is nevertheless. The system's
 * number for what it says is left out. */
static void a_name_is_bytes_and_a_message_is_text(void)
{
    V_PATH *path = NULL;
    STATUS(V_ERR_IO, v_path_load("no/such/\xff\xfe.vid", &path));
    CHECK(strcmp(v_last_error(), "no/such/\xef\xbf\xbd\xef\xbf\xbd.vid: "
                                 "No such file or directory") == 0);
}

/* The call answers this status and says this. */
#define SAYS(status, sentence, call) \
    do { \
        STATUS(status, call); \
        if (strcmp(v_last_error(), sentence) != 0) { \
            failures++; \
            fprintf(stderr, "%s:%d: \"%s\" instead of \"%s\"\n", __FILE__, __LINE__, \
                    v_last_error(), sentence); \
        } \
    } while (0)

/* The last message begins so. */
#define BEGINS(beginning) (strncmp(v_last_error(), beginning, sizeof beginning - 1) == 0)

/* Points, orientations and keys are counted from 0, and the sentence says so once. */
static void numbers_count_from_0(void)
{
    V_PATH *path = new_path();
    V_ORIENTATION o;
    V_POSE poses[3];
    V_SCENE *scene = NULL;
    const double far[3] = {2e9, 0, 0}, frames[2] = {5, 5}, values[6] = {0};

    SAYS(V_ERR_RANGE, "there is no point 2 (counted from 0): the path has points 0 to 1",
         v_path_remove_point(path, 2));
    SAYS(V_ERR_RANGE, "at is -1, but counting starts at 0", v_path_remove_point(path, -1));
    SAYS(V_ERR_RANGE, "a new point must be put at 0 (counted from 0) to 2, not at 9",
         v_path_insert_point(path, 9, far));
    v_orientation_init(&o);
    SAYS(V_ERR_RANGE,
         "there is no orientation 4 (counted from 0): point 1 has orientations 0 to 0",
         v_path_get_orientation(path, 1, 4, &o));
    SAYS(V_ERR_RANGE, "there is no segment 1 (counted from 0): the path has segments 0 to 0",
         v_path_segment_length(path, 1, &o.roll));
    SAYS(V_ERR_RANGE,
         "the first point of a range, 1 (counted from 0), must not lie behind its last one, 0",
         tool(path, "frames", NULL, "frames=100\nfirst=2\nlast=1"));
    SAYS(V_ERR_RANGE, "there is no frame 0.5: they go from 1 to 121",
         v_path_pose(path, 0.5, poses));
    memset(poses, 0, sizeof poses);
    poses[0].zoom = poses[1].zoom = poses[2].zoom = 24;
    poses[0].vpn[2] = poses[0].vup[1] = 1;
    CHECK(v_path_fit_poses(poses, NULL, 3, "tolerance=0.1", &path) != V_OK
          && BEGINS("pose 1 (counted from 0): "));
    /* A coordinate of the second point of two. */
    o.absolute = 1;
    o.target[0] = 0.6, o.target[1] = 0.2, o.target[2] = 0.8;
    SAYS(V_ERR_ARGUMENT, "the target must not lie on the camera's own position",
         v_path_set_orientation(path, 1, 0, &o));
    o.target[0] = 1.6;
    OK(v_path_set_orientation(path, 1, 0, &o));
    SAYS(V_ERR_ARGUMENT, "point 2 must not lie on the target of its orientation 1",
         set_position(path, 1, o.target));
    OK(v_scene_new(&scene));
    SAYS(V_ERR_RANGE, "there is no node 3 among 1, counted from 0", v_scene_remove_node(scene, 3));
    SAYS(V_ERR_ARGUMENT,
         "channel \"value:a\": key 1 (counted from 0): its frame must lie behind that of the key "
         "before",
         v_scene_set_track(scene, 0, "value:a", "linear", frames, values, NULL, 2, V_AFTER_HOLD));
    v_scene_free(scene);
    v_path_free(path);
}

/* What there is to choose is listed, and what is wrong is named as the header does. */
static void what_there_is_is_told(void)
{
    V_PATH *path = new_path();
    V_SCENE *scene = NULL;
    V_NODE node;
    V_EDITOR_OPTIONS options;
    V_EDITOR *editor = NULL;
    const double frames[2] = {1, 5}, values[12] = {0};
    const unsigned int corners[6] = {0, 1, 2, 3, 4, 0};
    const V_POSE parallel = {{0, 0, 0}, {0, 1, 0}, {0, 1, 0}, 24};
    size_t count = 0;
    V_MESH mesh = {sizeof mesh, NULL, 4, NULL, NULL, 0, NULL, 6};
    V_ORIENTATION o;
    V_POSE pose;

    v_orientation_init(&o);
    o.zoom = 0;
    SAYS(V_ERR_ARGUMENT,
         "curve: must be \"tcb\", \"centripetal\", \"chordal\", \"cubic\" or \"linear\"",
         v_path_set_text(path, "curve", "bezier"));
    SAYS(V_ERR_ARGUMENT, "there is no up \"w\"; known: axis, point, path, minimal, frenet, y, z",
         v_path_set_up(path, 0, 0, "w", NULL, NULL));
    SAYS(V_ERR_RANGE, "up is 9; known: V_UP_Y (1), V_UP_Z (2)", v_path_change_up(path, 9));
    SAYS(V_ERR_ARGUMENT, "space.up: must be \"y\" or \"z\"", v_path_set_text(path, "space.up", "x"));
    SAYS(V_ERR_RANGE, "the deformation \"bend\" does not take 5 numbers; it takes 2, 6",
         v_deform("bend", values, 5, (const double[]){-1, -1, -1, 1, 1, 1}, o.target, 1));
    CHECK(v_path_set_number(path, "check.turns", 1) == V_ERR_RANGE
          && BEGINS("there is no property \"check.turns\"; known here: space, cusp, "));
    SAYS(V_ERR_ARGUMENT,
         "check.turning: the limit of turning must be a number, or infinite where nothing is to be looked for",
         v_path_set_number(path, "check.turning", NAN));
    SAYS(V_ERR_RANGE, "space.half_size: the half size of the space must lie between 1e-30 and 1e30",
         v_path_set_number(path, "space.half_size", -1));
    SAYS(V_ERR_RANGE, "times must lie between 1 and 100000", v_path_tool(path, "repeat", "times=0", NULL));
    SAYS(V_ERR_RANGE, "fps: the frames per second must be greater than 0 and at most 100000",
         v_path_set_number(path, "fps", 0));
    SAYS(V_ERR_RANGE, "zoom must lie between 1 and 2000", v_path_set_orientation(path, 0, 0, &o));
    o.zoom = 24;
    o.speed[3] = 101;
    SAYS(V_ERR_RANGE, "speed must lie between 1 and 100", v_path_set_orientation(path, 0, 0, &o));
    SAYS(V_ERR_ARGUMENT, "vup must not be parallel to vpn",
         v_orientation_from_pose(&parallel, V_UP_Y, &o));
    SAYS(V_ERR_SIZE, "poses has room for 1, but 121 are needed",
         v_path_sample(path, &pose, 1, &count));
    SAYS(V_ERR_ARGUMENT, "base_speeds: a base speed must be finite and greater than zero",
         v_path_set_numbers(path, "base_speeds", NUMBERS(1, 1, 0, 1)));

    OK(v_scene_new(&scene));
    v_node_init(&node, V_NODE_OBJECT);
    OK(v_scene_add_node(scene, "box", &node, NULL));
    mesh.xyz = values;
    mesh.triangles = corners;
    SAYS(V_ERR_RANGE, "triangles[4]: there is no point 4 among 4, counted from 0",
         v_scene_set_geometry(scene, 1, &mesh));
    SAYS(V_ERR_ARGUMENT,
         "there is no channel \"place\"; known: position, rotation, scale, visible, zoom, roll, "
         "colour, intensity, cone, weights, aim_weight, deformation.N.NAME, value:NAME",
         v_scene_set_track(scene, 1, "place", "linear", frames, values, NULL, 2, V_AFTER_HOLD));
    SAYS(V_ERR_ARGUMENT,
         "an object has no channel \"zoom\"; it can have: position, rotation, scale, visible, "
         "colour, weights, deformation.N.NAME, value:NAME",
         v_scene_set_track(scene, 1, "zoom", "linear", frames, values, NULL, 2, V_AFTER_HOLD));
    SAYS(V_ERR_ARGUMENT, "an object without shapes has no channel \"weights\"",
         v_scene_set_track(scene, 1, "weights", "linear", frames, values, NULL, 2, V_AFTER_HOLD));
    SAYS(V_ERR_ARGUMENT,
         "there is no interpolation \"lin\"; known: step, linear, ramp, sine, parabolic, "
         "catmull-rom, hermite, tcb, cubic, euler-linear, euler-catmull-rom, host:NAME",
         v_scene_set_track(scene, 1, "scale", "lin", frames, values, NULL, 2, V_AFTER_HOLD));
    SAYS(V_ERR_ARGUMENT,
         "channel \"visible\": it cannot be interpolated by \"cubic\"; it can by: step",
         v_scene_set_track(scene, 1, "visible", "cubic", frames, values, NULL, 2, V_AFTER_HOLD));
    node.kind = 7;
    SAYS(V_ERR_RANGE,
         "values->kind is 7; known: V_NODE_GROUP (0), V_NODE_OBJECT (1), V_NODE_LIGHT (2), "
         "V_NODE_CAMERA (3)",
         v_scene_add_node(scene, "x", &node, NULL));
    v_node_init(&node, V_NODE_CAMERA);
    SAYS(V_ERR_ARGUMENT, "\"box\" is an object and stays one", v_scene_set_node(scene, 1, &node));
    v_scene_free(scene);

    v_editor_options_init(&options);
    options.move_frames = -1;
    SAYS(V_ERR_ARGUMENT, "options->move_frames is -1, but must be finite and greater than 0",
         v_editor_open(&options, &editor));
    options.move_frames = 10;
    SAYS(V_ERR_ARGUMENT, "options->turn_frames is 0, but must be finite and greater than 0",
         v_editor_open(&options, &editor));
    options.move_frames = 0;
    options.language = "fr";
    SAYS(V_ERR_ARGUMENT, "options->language is \"fr\"; known: de, en",
         v_editor_open(&options, &editor));
    options.size = 12;
    CHECK(v_editor_open(&options, &editor) == V_ERR_SIZE
          && BEGINS("options->size is 12, but sizeof (V_EDITOR_OPTIONS) is ")
          && (size_t)atol(v_last_error() + 54) == sizeof options);
    v_path_free(path);
}

/* One line on standard error that begins with "vides:". */
static void haupt_says_what_is_wrong(void)
{
    char said[1000] = "";
    int ends[2], kept = dup(2);
    ssize_t length;
    V_KAMERAPAR head;
    memset(&head, 0xa5, sizeof head);
    head.number = -1;
    CHECK(pipe(ends) == 0 && dup2(ends[1], 2) == 2);
    v_haupt(100, 100, 100, 100, &head, 0, NULL, NULL, NULL);
    CHECK(dup2(kept, 2) == 2);
    close(ends[1]);
    length = read(ends[0], said, sizeof said - 1);
    close(ends[0]);
    close(kept);
    CHECK(length > 0 && strncmp(said, "vides:", 6) == 0);
    CHECK(strchr(said, '\n') == said + strlen(said) - 1);
    CHECK(v_last_error()[0] != '\0' && strstr(said, v_last_error()) != NULL);
    CHECK(head.number == -1);
}

int main(void)
{
    texts();
    last_error();
    each_thread_has_its_own();
    a_long_message_stays_text();
    a_name_is_bytes_and_a_message_is_text();
    numbers_count_from_0();
    what_there_is_is_told();
    haupt_says_what_is_wrong();
    return failures != 0;
}
