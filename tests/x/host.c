/* The commands of the host that does what it is told, see host.h. */
#include <errno.h>
#include <fcntl.h>
#include <locale.h>
#include <pthread.h>
#include <signal.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <time.h>
#include <unistd.h>

#include <libvides.h>

#include "host.h"

#define LISTS 128
#define EDITORS 128

extern char **environ;

static V_KAMERAPAR lists[LISTS];
static V_EDITOR *editors[EDITORS];
static int closing = 1;        /* what ende() answers */
static float speeds[4] = {100, 100, 100, 100};
static char within_rueck[400], within_ende[400], within_gone[400]; /* commands, done once */
static pthread_t first_thread;
static int depth;

static V_OBJEKT_LIST pyramid[10] = {
    {{0.3f, 0, 0.3f}, 1, 1}, {{0.3f, 0, -0.3f}, 1, 2}, {{-0.3f, 0, -0.3f}, 1, 3},
    {{-0.3f, 0, 0.3f}, 1, 4}, {{0.3f, 0, 0.3f}, 1, 5}, {{0, 0.5f, 0}, 1, 6},
    {{0.3f, 0, -0.3f}, 1, 7}, {{-0.3f, 0, -0.3f}, 0, 8}, {{0, 0.5f, 0}, 1, 9},
    {{-0.3f, 0, 0.3f}, 1, 10}
};

/* The same as a mesh. */
static const double pyramid_xyz[] = {
    0.3, 0.0, 0.3,  0.3, 0.0, -0.3,  -0.3, 0.0, -0.3,  -0.3, 0.0, 0.3,  0.0, 0.5, 0.0
};
static const unsigned pyramid_lines[] = {0, 1, 1, 2, 2, 3, 3, 0, 0, 4, 4, 1, 2, 4, 4, 3};
static const V_MESH pyramid_mesh = {
    sizeof(V_MESH), pyramid_xyz, 5, NULL, pyramid_lines, 16, NULL, 0
};

void say(const char *format, ...)
{
    va_list arguments;

    va_start(arguments, format);
    vprintf(format, arguments);
    va_end(arguments);
    putchar('\n');
    fflush(stdout);
}

static void command(char *line);

static double now(void)
{
    struct timespec time;

    clock_gettime(CLOCK_MONOTONIC, &time);
    return time.tv_sec + 1e-9 * time.tv_nsec;
}

/* A command that a callback does, once. */
static void once(char *what)
{
    char line[400];

    strcpy(line, what);
    what[0] = '\0';
    if (line[0] != '\0')
        command(line);
}

static const char *thread(void)
{
    return pthread_equal(pthread_self(), first_thread) ? "own" : "another";
}

static void rueck(V_KAMERAPAR *daten, int anzahl)
{
    long which = daten >= lists && daten < lists + LISTS ? (long)(daten - lists) : -1;

    say("rueck %ld %d thread %s depth %d", which, anzahl, thread(), depth);
    depth++;
    once(within_rueck);
    depth--;
    say("rueck-end %ld", which);
}

static int ende(void)
{
    say("ende thread %s answers %d", thread(), closing);
    once(within_ende);
    return closing;
}

static void on_poses(V_EDITOR *editor, const V_POSE *poses, size_t count, void *user)
{
    (void)editor;
    say("poses %ld %lu thread %s first %.9g %.9g %.9g", (long)(size_t)user, (unsigned long)count,
        thread(), poses[0].vrp[0], poses[0].vrp[1], poses[0].vrp[2]);
    once(within_rueck);
}

static int on_close(V_EDITOR *editor, void *user)
{
    (void)editor;
    say("on_close %ld thread %s answers %d", (long)(size_t)user, thread(), closing);
    once(within_ende);
    return closing;
}

static void on_gone(V_EDITOR *editor, int reason, void *user)
{
    (void)editor;
    say("gone %ld %d thread %s", (long)(size_t)user, reason, thread());
    once(within_gone);
}

/* A list as the ASCII output has it. */
static void write_list(const V_KAMERAPAR *first, const char *file)
{
    const V_KAMERAPAR *p = first;
    FILE *out = fopen(file, "w");

    if (out == NULL || first->number < 0) {
        say("written -1");
        return;
    }
    do {
        fprintf(out, "%3.4f %3.4f %3.4f %3.4f %3.4f %3.4f %3.4f %3.4f %3.4f %3.4f\n",
                p->VRP.x, p->VRP.y, p->VRP.z, p->VPN.x, p->VPN.y, p->VPN.z,
                p->VUP.x, p->VUP.y, p->VUP.z, (double)p->zoom);
        p = p->next;
    } while (p != first);
    fclose(out);
    say("written %d", first->prev->number);
}

/* Everything process-wide that a library might change, as one line. */
static void process(void)
{
    unsigned long handlers = 5381, variables = 5381;
    struct sigaction action;
    sigset_t mask;
    const char *c;
    int i;

    for (i = 1; i < NSIG; i++)
        if (sigaction(i, NULL, &action) == 0)
            handlers = handlers * 33 + (unsigned long)action.sa_handler;
    sigprocmask(SIG_SETMASK, NULL, &mask);
    for (i = 1; i < NSIG; i++)
        handlers = handlers * 33 + (unsigned long)(sigismember(&mask, i) == 1);
    for (i = 0; environ[i] != NULL; i++)
        for (c = environ[i]; *c != '\0'; c++)
            variables = variables * 33 + (unsigned char)*c;
    say("process signals %lx environment %lx locale %s alarm %u umask %o stdin %x stdout %x stderr %x",
        handlers, variables, setlocale(LC_ALL, NULL), alarm(0), (unsigned)umask(022),
        (unsigned)fcntl(0, F_GETFL), (unsigned)fcntl(1, F_GETFL), (unsigned)fcntl(2, F_GETFL));
}

/* Whether windows are given no object. */
static int objectless;

static void open_editor(int which, const char *file, const char *display, const char *language)
{
    V_EDITOR_OPTIONS options;
    double start = now();
    int status;

    v_editor_options_init(&options);
    options.title = "host";
    options.file = file;
    options.display = display;
    options.language = language;
    options.object = objectless ? NULL : &pyramid_mesh;
    options.on_poses = on_poses;
    options.on_close = on_close;
    options.on_gone = on_gone;
    options.user = (void *)(size_t)which;
    status = v_editor_open(&options, &editors[which]);
    say("edited %d %.1f %s", status, 1e6 * (now() - start), v_last_error());
}

/* Opens and closes windows; each is served for a moment. */
static void cycle(int times)
{
    int i;

    for (i = 0; i < times; i++) {
        V_EDITOR_OPTIONS options;
        V_EDITOR *editor;

        v_editor_options_init(&options);
        if (v_editor_open(&options, &editor) != V_OK)
            break;
        if (i % 4 != 0)
            v_dispatch();
        if (v_editor_close(editor) != V_OK)
            break;
        v_dispatch();
    }
    say("cycled %d %s", i, v_last_error());
}

/* The points' positions. */
static void print_path(int which)
{
    V_PATH *path;
    double xyz[3];
    size_t three;
    char line[4000];
    int count, i, status;
    size_t length = 0;

    status = v_editor_get_path(editors[which], &path);
    if (status != V_OK) {
        say("path status %d %s", status, v_last_error());
        return;
    }
    v_path_point_count(path, &count);
    for (i = 0; i < count && length < sizeof line - 300; i++) {
        v_path_get_numbers(path, v_path_key(i, -1, "position"), xyz, 3, &three);
        length += (size_t)sprintf(line + length, " %.17g %.17g %.17g", xyz[0], xyz[1], xyz[2]);
    }
    v_path_free(path);
    say("path %d%s", count, line);
}

/* The first orientation of a point, numbers in full. */
static void print_orientation(int which, int point, int at)
{
    V_ORIENTATION o;
    V_PATH *path;
    int status = v_editor_get_path(editors[which], &path);

    v_orientation_init(&o);
    if (status == V_OK) {
        status = v_path_get_orientation(path, point, at, &o);
        v_path_free(path);
    }
    say("orientation %d %d %.17g %.17g %.17g roll %.17g zoom %.17g hold %d", status, o.absolute,
        o.target[0], o.target[1], o.target[2], o.roll, o.zoom, o.hold);
}

static void path_command(int which, const char *file, int save)
{
    V_PATH *path;
    int status;

    if (save) {
        status = v_editor_get_path(editors[which], &path);
        if (status == V_OK) {
            status = v_path_save(path, file);
            v_path_free(path);
        }
        say("saved %d %s", status, v_last_error());
        return;
    }
    status = v_path_load(file, &path);
    if (status == V_OK) {
        status = v_editor_set_path(editors[which], path);
        v_path_free(path);
    }
    say("set %d %s", status, v_last_error());
}

static void command(char *line)
{
    char name[40] = "", text[300] = "", more[300] = "";
    int a = 0, b = 0, rest = 0;
    V_KAMERAPAR *list;
    V_EDITOR **editor;
    double start;

    sscanf(line, "%39s %n", name, &rest);
    sscanf(line + rest, "%d %d", &a, &b);
    sscanf(line + rest, "%299s %299s", text, more);
    if (loop_command(name, line + rest))
        return;
    list = &lists[(unsigned)a % LISTS];
    editor = &editors[(unsigned)a % EDITORS];
    if (strcmp(name, "haupt") == 0) { /* with list number a, rueck and ende */
        start = now();
        v_haupt(speeds[0], speeds[1], speeds[2], speeds[3], list, 10, pyramid, rueck, ende);
        say("haupt %.1f %s", 1e6 * (now() - start), v_last_error());
    } else if (strcmp(name, "poll") == 0) { /* a list, but no functions */
        v_haupt(speeds[0], speeds[1], speeds[2], speeds[3], list, 10, pyramid, NULL, NULL);
        say("haupt 0 %s", v_last_error());
    } else if (strcmp(name, "nolist") == 0) { /* a function, but no list */
        v_haupt(speeds[0], speeds[1], speeds[2], speeds[3], NULL, 0, NULL, rueck, ende);
        say("haupt 0 %s", v_last_error());
    } else if (strcmp(name, "bare") == 0) { /* nothing at all */
        v_haupt(speeds[0], speeds[1], speeds[2], speeds[3], NULL, 0, NULL, NULL, NULL);
        say("haupt 0 %s", v_last_error());
    } else if (strcmp(name, "speeds") == 0) {
        sscanf(line + rest, "%f %f %f %f", &speeds[0], &speeds[1], &speeds[2], &speeds[3]);
        say("speeds");
    } else if (strcmp(name, "misnumber") == 0) {
        pyramid[3].number = a;
        say("misnumber");
    } else if (strcmp(name, "closing") == 0) {
        closing = a;
        say("closing %d", closing);
    } else if (strcmp(name, "within-rueck") == 0) {
        strcpy(within_rueck, line + rest);
        say("within-rueck");
    } else if (strcmp(name, "within-ende") == 0) {
        strcpy(within_ende, line + rest);
        say("within-ende");
    } else if (strcmp(name, "within-gone") == 0) {
        strcpy(within_gone, line + rest);
        say("within-gone");
    } else if (strcmp(name, "list") == 0) {
        if (list->number < 0)
            say("list %d none", a);
        else
            say("list %d %d first %.9g %.9g %.9g last %.9g %.9g %.9g", a, list->prev->number,
                list->VRP.x, list->VRP.y, list->VRP.z, list->prev->VRP.x,
                list->prev->VRP.y, list->prev->VRP.z);
    } else if (strcmp(name, "write") == 0) {
        write_list(list, more);
    } else if (strcmp(name, "free") == 0) {
        v_free_liste(list);
        say("freed %d %s", list->number, v_last_error());
    } else if (strcmp(name, "edit") == 0) { /* NUMBER [FILE] */
        open_editor(a, more[0] != '\0' ? more : NULL, NULL, NULL);
    } else if (strcmp(name, "objectless") == 0) { /* NUMBER */
        objectless = a;
        say("objectless");
    } else if (strcmp(name, "edit-on") == 0) { /* NUMBER DISPLAY */
        open_editor(a, NULL, more, NULL);
    } else if (strcmp(name, "edit-in") == 0) { /* NUMBER LANGUAGE */
        open_editor(a, NULL, NULL, more);
    } else if (strcmp(name, "path") == 0) {
        print_path(a);
    } else if (strcmp(name, "orientation") == 0) { /* EDITOR POINT AT */
        int at = 0;
        sscanf(line + rest, "%*d %*d %d", &at);
        print_orientation(a, b, at);
    } else if (strcmp(name, "save") == 0) {
        path_command(a, more, 1);
    } else if (strcmp(name, "set") == 0) {
        path_command(a, more, 0);
    } else if (strcmp(name, "close") == 0) {
        a = v_editor_close(*editor);
        say("closed %d %s", a, v_last_error());
    } else if (strcmp(name, "modified") == 0) {
        a = v_editor_is_modified(*editor, &b);
        say("modified %d %d", a, b);
    } else if (strcmp(name, "mark-saved") == 0) {
        a = v_editor_mark_saved(*editor);
        say("mark-saved %d", a);
    } else if (strcmp(name, "quit") == 0) { /* ASK */
        a = v_editors_close(a);
        say("quit %d %s", a, v_last_error());
    } else if (strcmp(name, "dispatch") == 0) {
        a = v_dispatch();
        say("dispatch %d %s", a, v_last_error());
    } else if (strcmp(name, "main-loop") == 0) {
        a = v_main_loop();
        say("main-loop %d %s", a, v_last_error());
    } else if (strcmp(name, "fd") == 0) {
        say("fd %d timeout %d", v_fd(), v_timeout());
    } else if (strcmp(name, "process") == 0) {
        process();
    } else if (strcmp(name, "kill") == 0) { /* PID SIGNAL */
        a = kill(atoi(text), b);
        say("kill %d", a);
    } else if (strcmp(name, "sleep") == 0) { /* milliseconds, serving nothing */
        usleep((useconds_t)atoi(text) * 1000);
        say("slept");
    } else if (strcmp(name, "compute") == 0) { /* milliseconds, without a pause */
        say("computing");
        start = now();
        while (1e3 * (now() - start) < a)
            ;
        say("computed");
    } else if (strcmp(name, "cycle") == 0) {
        cycle(a);
    } else if (strcmp(name, "stamp") == 0) {
        say("stamp %.1f", 1e6 * now());
    } else if (strcmp(name, "ping") == 0) {
        say("pong");
    } else if (strcmp(name, "exit") == 0) {
        exit(a);
    } else {
        say("unknown command: %s", line);
    }
}

void commands(void)
{
    char line[400];
    size_t length = 0;
    char c;

    /* One line by bytes: what comes after it must stay to be polled for. */
    for (;;) {
        ssize_t got = read(0, &c, 1);
        if (got < 0 && errno == EINTR)
            continue;
        if (got <= 0)
            exit(0);
        if (c == '\n')
            break;
        if (length < sizeof line - 1)
            line[length++] = c;
    }
    line[length] = '\0';
    command(line);
}

void begin(void)
{
    int i;

    first_thread = pthread_self();
    for (i = 0; i < LISTS; i++)
        lists[i].number = -1;
}
