/*
 * The structs of 1994 lie in memory as the thesis's own declarations make them
 * (B.2.2, written down anew here), the frozen V_POSE as it says,
 * and V_EDITOR_OPTIONS as it was first written.
 */
#include "check.h"

typedef struct { float x; float y; float z; } point;
typedef struct { point pos; unsigned short int draw; int number; } object;
typedef struct pose_1994 {
    point VRP;
    point VPN;
    point VUP;
    int zoom;
    struct pose_1994 *prev, *next;
    int number;
} pose_1994;

/* Once shipped, its fields stay where they are; new ones come behind. */
typedef struct {
    size_t size;
    const char *title, *file;
    const V_PATH *path;
    const V_MESH *object;
    double move_frames, turn_frames, zoom_frames, roll_frames;
    const char *display, *language;
    void (*on_poses)(V_EDITOR *, const V_POSE *, size_t, void *);
    int (*on_close)(V_EDITOR *, void *);
    void *user;
    double space_centre[3], space_half_size;
    int space_up;
    void (*on_view)(V_EDITOR *, const V_POSE *, double, int, void *);
    void (*on_change)(V_EDITOR *, void *);
    int (*on_capture)(V_EDITOR *, V_POSE *, void *);
    void (*on_pane)(V_EDITOR *, unsigned long, int, int, void *);
    const char *host_name;
    unsigned long parent, transient_for;
    const char *application;
    int hand_over_saves;
    void (*on_frame)(V_EDITOR *, double, int, void *);
    const V_POSE *view;
    void (*on_gone)(V_EDITOR *, int, void *);
} options;

#define SAME_SIZE(ours, theirs) CHECK(sizeof(ours) == sizeof(theirs))
#define SAME_FIELD(ours, theirs, field) \
    CHECK(offsetof(ours, field) == offsetof(theirs, field) \
          && sizeof(((ours *)0)->field) == sizeof(((theirs *)0)->field))

static int function_type(float a, float b, float c, float d, V_KAMERAPAR *list, int count,
                         V_OBJEKT_LIST *object, void (*rueck)(V_KAMERAPAR *, int),
                         int (*ende)(void))
{
    /* Compiles only if the types are the printed ones. */
    void (*haupt)(float, float, float, float, V_KAMERAPAR *, int, V_OBJEKT_LIST *,
                  void (*)(V_KAMERAPAR *, int), int (*)(void)) = v_haupt;
    void (*free_liste)(V_KAMERAPAR *) = v_free_liste;
    (void)a, (void)b, (void)c, (void)d, (void)list, (void)count, (void)object;
    (void)rueck, (void)ende;
    return haupt != NULL && free_liste != NULL;
}

int main(void)
{
    struct v_punkt tagged = {1, 2, 3};
    V_EDITOR_OPTIONS given;
    V_POS position = tagged;
    V_PUNKT *same = &position;
    struct v_objekt_list *one = NULL;
    V_OBJEKT_LIST *two = one;
    V_OBJEKT_LISTE *three = two;
    interpolparameter *element = NULL; /* as the thesis writes it, in C as in C++ */
    V_KAMERAPAR *also = element;

    CHECK(same->x == 1 && three == NULL && also == NULL);
    CHECK(function_type(0, 0, 0, 0, NULL, 0, NULL, NULL, NULL));

    SAME_SIZE(V_PUNKT, point);
    SAME_FIELD(V_PUNKT, point, x);
    SAME_FIELD(V_PUNKT, point, y);
    SAME_FIELD(V_PUNKT, point, z);
    SAME_SIZE(V_OBJEKT_LIST, object);
    SAME_FIELD(V_OBJEKT_LIST, object, pos);
    SAME_FIELD(V_OBJEKT_LIST, object, draw);
    SAME_FIELD(V_OBJEKT_LIST, object, number);
    SAME_SIZE(V_KAMERAPAR, pose_1994);
    SAME_FIELD(V_KAMERAPAR, pose_1994, VRP);
    SAME_FIELD(V_KAMERAPAR, pose_1994, VPN);
    SAME_FIELD(V_KAMERAPAR, pose_1994, VUP);
    SAME_FIELD(V_KAMERAPAR, pose_1994, zoom);
    SAME_FIELD(V_KAMERAPAR, pose_1994, prev);
    SAME_FIELD(V_KAMERAPAR, pose_1994, next);
    SAME_FIELD(V_KAMERAPAR, pose_1994, number);

    CHECK(sizeof(V_POSE) == 10 * sizeof(double));
    CHECK(offsetof(V_POSE, vpn) == 3 * sizeof(double));
    CHECK(offsetof(V_POSE, vup) == 6 * sizeof(double));
    CHECK(offsetof(V_POSE, zoom) == 9 * sizeof(double));
    CHECK(offsetof(V_ORIENTATION, size) == 0 && offsetof(V_VIEW, size) == 0);
    SAME_SIZE(V_EDITOR_OPTIONS, options);
    SAME_FIELD(V_EDITOR_OPTIONS, options, size);
    SAME_FIELD(V_EDITOR_OPTIONS, options, title);
    SAME_FIELD(V_EDITOR_OPTIONS, options, file);
    SAME_FIELD(V_EDITOR_OPTIONS, options, path);
    SAME_FIELD(V_EDITOR_OPTIONS, options, object);
    SAME_FIELD(V_EDITOR_OPTIONS, options, move_frames);
    SAME_FIELD(V_EDITOR_OPTIONS, options, turn_frames);
    SAME_FIELD(V_EDITOR_OPTIONS, options, zoom_frames);
    SAME_FIELD(V_EDITOR_OPTIONS, options, roll_frames);
    SAME_FIELD(V_EDITOR_OPTIONS, options, display);
    SAME_FIELD(V_EDITOR_OPTIONS, options, language);
    SAME_FIELD(V_EDITOR_OPTIONS, options, on_poses);
    SAME_FIELD(V_EDITOR_OPTIONS, options, on_close);
    SAME_FIELD(V_EDITOR_OPTIONS, options, user);
    SAME_FIELD(V_EDITOR_OPTIONS, options, space_centre);
    SAME_FIELD(V_EDITOR_OPTIONS, options, space_half_size);
    SAME_FIELD(V_EDITOR_OPTIONS, options, space_up);
    SAME_FIELD(V_EDITOR_OPTIONS, options, on_view);
    SAME_FIELD(V_EDITOR_OPTIONS, options, on_change);
    SAME_FIELD(V_EDITOR_OPTIONS, options, on_capture);
    SAME_FIELD(V_EDITOR_OPTIONS, options, on_pane);
    SAME_FIELD(V_EDITOR_OPTIONS, options, host_name);
    SAME_FIELD(V_EDITOR_OPTIONS, options, parent);
    SAME_FIELD(V_EDITOR_OPTIONS, options, transient_for);
    SAME_FIELD(V_EDITOR_OPTIONS, options, application);
    SAME_FIELD(V_EDITOR_OPTIONS, options, hand_over_saves);
    SAME_FIELD(V_EDITOR_OPTIONS, options, on_frame);
    SAME_FIELD(V_EDITOR_OPTIONS, options, view);
    SAME_FIELD(V_EDITOR_OPTIONS, options, on_gone);
    memset(&given, 0xff, sizeof given);
    v_editor_options_init(&given);
    CHECK(given.size == sizeof given && given.title == NULL && given.path == NULL);
    CHECK(given.object == NULL && given.roll_frames == 0 && given.on_close == NULL);
    CHECK(given.user == NULL && given.language == NULL && given.on_poses == NULL);
    CHECK(given.application == NULL && given.space_half_size == 0 && given.space_up == V_UP_Y);
    CHECK(given.on_view == NULL && given.on_change == NULL && given.on_capture == NULL);
    CHECK(given.on_pane == NULL && given.host_name == NULL && given.parent == 0);
    CHECK(given.transient_for == 0 && given.hand_over_saves == 0 && given.on_frame == NULL);
    CHECK(given.on_gone == NULL);
    return failures != 0;
}
