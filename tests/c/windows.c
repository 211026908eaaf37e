/*
 * The functions of windows where there is no X server: every one answers, none
 * does harm, and nothing stays behind. What windows do on a screen is tried in
 * tests/x.
 */
#include <fcntl.h>
#include <poll.h>
#include <pthread.h>
#include <unistd.h>

#include "check.h"

static int called;

static int on_close(V_EDITOR *editor, void *user)
{
    (void)editor, (void)user;
    called++;
    return 1;
}

static void on_poses(V_EDITOR *editor, const V_POSE *poses, size_t count, void *user)
{
    (void)editor, (void)poses, (void)count, (void)user;
    called++;
}

static int descriptors(void)
{
    int i, open = 0;
    for (i = 0; i < 256; i++)
        open += fcntl(i, F_GETFD) >= 0;
    return open;
}

/* The options fail with this status, and the handle is not touched. */
static void refused(int status, const V_EDITOR_OPTIONS *options)
{
    V_EDITOR *untouched = (V_EDITOR *)&called, *editor = untouched;
    STATUS(status, v_editor_open(options, &editor));
    CHECK(editor == untouched);
}

static void opening(void)
{
    double xyz[6] = {0, 0, 0, 1, 1, 1};
    unsigned line[2] = {0, 1};
    V_MESH object = {sizeof object, NULL, 2, NULL, NULL, 2, NULL, 0};
    V_PATH *path = new_path();
    V_EDITOR_OPTIONS options, all;

    STATUS(V_ERR_NULL, v_editor_open(NULL, NULL));
    refused(V_ERR_DISPLAY, NULL);
    v_editor_options_init(NULL);
    CHECK(v_last_error()[0] != '\0');
    v_editor_options_init(&options);
    CHECK(v_last_error()[0] == '\0');
    refused(V_ERR_DISPLAY, &options);

    all = options;
    all.title = "Flug \303\274ber die Pyramide";
    all.path = path;
    object.xyz = xyz;
    object.lines = line;
    all.object = &object;
    all.move_frames = all.turn_frames = all.zoom_frames = all.roll_frames = 50;
    all.language = "de";
    all.on_poses = on_poses;
    all.on_close = on_close;
    refused(V_ERR_DISPLAY, &all);
    all.display = ":no-display";
    refused(V_ERR_DISPLAY, &all);
    all.display = "";
    refused(V_ERR_DISPLAY, &all);

    options.size = 0;
    refused(V_ERR_SIZE, &options);
    options.size = sizeof options + 1;
    refused(V_ERR_SIZE, &options);
    v_editor_options_init(&options);
    options.title = "\377";
    refused(V_ERR_ARGUMENT, &options);
    v_editor_options_init(&options);
    options.language = "fr";
    refused(V_ERR_ARGUMENT, &options);
    v_editor_options_init(&options);
    options.path = path;
    options.file = "a.vid";
    refused(V_ERR_ARGUMENT, &options);
    v_editor_options_init(&options);
    options.file = "/no/such/folder/but/a/new/path.vid";
    refused(V_ERR_DISPLAY, &options);
    options.file = "/";
    refused(V_ERR_IO, &options);
    v_editor_options_init(&options);
    options.move_frames = 1;
    refused(V_ERR_ARGUMENT, &options);
    options.move_frames = NAN;
    refused(V_ERR_ARGUMENT, &options);
    v_editor_options_init(&options);
    options.object = &object;
    xyz[4] = INFINITY;
    refused(V_ERR_ARGUMENT, &options);
    xyz[4] = 1;
    line[1] = 2;
    refused(V_ERR_RANGE, &options);
    object.size--;
    refused(V_ERR_SIZE, &options);
    options.object = (V_MESH *)((char *)&object + 1);
    refused(V_ERR_ARGUMENT, &options);
    v_editor_options_init(&options);
    options.host_name = "\377";
    refused(V_ERR_ARGUMENT, &options);
    v_editor_options_init(&options);
    options.parent = ~0ul;
    refused(V_ERR_RANGE, &options);
    v_editor_options_init(&options);
    options.transient_for = ~0ul;
    refused(V_ERR_RANGE, &options);
    /* Which axis is up, whether a half size is given or not. */
    v_editor_options_init(&options);
    options.space_up = 9;
    refused(V_ERR_RANGE, &options);
    options.space_half_size = 2;
    refused(V_ERR_RANGE, &options);
    options.space_up = V_UP_Z;
    refused(V_ERR_DISPLAY, &options);
    v_path_free(path);
    v_editor_options_init(&options);
    options.path = path;
    refused(V_ERR_HANDLE, &options);
}

static void handles(void)
{
    V_PATH *path = new_path(), *copy = path;
    int number = 7;
    /* A path is no window, and a made-up handle is none. */
    V_EDITOR *wrong = (V_EDITOR *)path, *nothing = (V_EDITOR *)&called;
    OK(v_editor_close(NULL));
    STATUS(V_ERR_HANDLE, v_editor_close(wrong));
    STATUS(V_ERR_HANDLE, v_editor_close(nothing));
    STATUS(V_ERR_NULL, v_editor_get_path(NULL, &copy));
    STATUS(V_ERR_NULL, v_editor_get_path(wrong, NULL));
    STATUS(V_ERR_HANDLE, v_editor_get_path(wrong, &copy));
    STATUS(V_ERR_NULL, v_editor_set_path(NULL, path));
    STATUS(V_ERR_HANDLE, v_editor_set_path(nothing, path));
    CHECK(copy == path);
    STATUS(V_ERR_NULL, v_editor_undo(NULL));
    STATUS(V_ERR_HANDLE, v_editor_undo(wrong));
    STATUS(V_ERR_HANDLE, v_editor_redo(nothing));
    STATUS(V_ERR_NULL, v_editor_begin_step(NULL));
    STATUS(V_ERR_HANDLE, v_editor_begin_step(wrong));
    STATUS(V_ERR_HANDLE, v_editor_end_step(nothing));
    STATUS(V_ERR_HANDLE, v_editor_get_selection(wrong, &number, NULL));
    STATUS(V_ERR_NULL, v_editor_is_playing(wrong, NULL));
    STATUS(V_ERR_HANDLE, v_editor_is_playing(wrong, &number));
    CHECK(number == 7);
    v_path_free(path);
}

static void loop(void)
{
    struct pollfd watched;
    CHECK(v_dispatch() == 0 && v_last_error()[0] == '\0');
    CHECK(v_timeout() == -1 && v_last_error()[0] == '\0');
    OK(v_main_loop());
    watched.fd = v_fd();
    watched.events = POLLIN;
    CHECK(watched.fd >= 0 && v_fd() == watched.fd);
    CHECK((fcntl(watched.fd, F_GETFD) & FD_CLOEXEC) != 0);
    CHECK(poll(&watched, 1, 0) == 0);
    CHECK(v_dispatch() == 0 && v_timeout() == -1);
    /* There is no Xt in this program. */
    STATUS(V_ERR_NULL, v_set_app_context(NULL));
    STATUS(V_ERR_ARGUMENT, v_set_app_context(&called));
}

static void *other_thread(void *fd)
{
    int own = v_fd();
    CHECK(own >= 0 && own != *(int *)fd);
    CHECK(v_dispatch() == 0);
    OK(v_main_loop());
    return NULL;
}

static void haupt(void)
{
    V_KAMERAPAR head, *unaligned = (V_KAMERAPAR *)((char *)&head + 1);
    V_OBJEKT_LIST object[3] = {{{0, 0, 0}, 0, 1}, {{0, 1, 0}, 1, 7}, {{1, 1, 0}, 1, 8}};
    head.number = -1;
    v_haupt(100, 100, 100, 100, &head, 3, object, NULL, NULL);
    CHECK(strstr(v_last_error(), "DISPLAY") != NULL);
    CHECK(strstr(v_last_error(), "point 2 of the object has the number 7;") != NULL);
    CHECK(strstr(v_last_error(), "point 3") == NULL); /* the first one tells */
    v_haupt(100, 100, 100, 100, &head, 1000001, object, NULL, NULL);
    CHECK(strstr(v_last_error(), "the object is not shown: an object has at most") != NULL);
    v_haupt(100, 100, 100, 100, &head, 0, object + 1, NULL, NULL);
    CHECK(strstr(v_last_error(), "object") == NULL);
    CHECK(head.number == -1);
    v_haupt(0, NAN, -1, INFINITY, NULL, -5, NULL, NULL, NULL);
    CHECK(v_last_error()[0] != '\0');
    v_haupt(100, 100, 100, 100, unaligned, 0, NULL, NULL, NULL);
    CHECK(strstr(v_last_error(), "aligned") != NULL);
}

int main(void)
{
    pthread_t thread;
    int before, fd;
    unsetenv("DISPLAY");
    opening(); /* once, so that what stays for good is there */
    handles();
    haupt();
    before = descriptors();
    opening();
    haupt();
    CHECK(descriptors() == before);
    loop();
    fd = v_fd();
    before = descriptors();
    CHECK(pthread_create(&thread, NULL, other_thread, &fd) == 0);
    CHECK(pthread_join(thread, NULL) == 0);
    CHECK(descriptors() == before);
    CHECK(called == 0);
    return failures != 0;
}
