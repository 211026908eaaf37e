/* Every function of the library: see every.h. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "documented.h"
#include "functions.h"
#include "things.h"

/* ---- Arguments that only these calls have ----------------------------------------- */

/* An object of a few points, exactly as many as *count says, or fewer, or none. */
static const V_OBJEKT_LIST *an_object(int *count)
{
    V_OBJEKT_LIST points[5];
    const V_OBJEKT_LIST *object;
    int i;

    memset(points, 0, sizeof points);
    for (i = 0; i < 5; i++) {
        points[i].pos.x = (float)number(-1, 1);
        points[i].pos.y = (float)number(-1, 1);
        points[i].draw = (unsigned short)below(2);
        points[i].number = whole(i + 1, i + 1);
    }
    object = given("object", points, sizeof points);
    *count = object == NULL ? whole(0, 5) : (int)below(6);
    if (object != NULL && chance(wild))
        *count = -(int)below(3);
    word("%d", *count);
    return object;
}

/* ---- The interface of 1994, loops, windows ------------------------------------------ */

CALL(v_last_error) { return v_last_error() != NULL; }
CALL(v_last_warning) { return v_last_warning() != NULL; }
CALL(v_strerror) { return v_strerror(whole(V_OK, V_ERR_INTERNAL)) != NULL; }
CALL(v_version) { return strcmp(v_version(), "") != 0; }

CALL(v_haupt)
{
    double move = number(1, 50), orient = number(1, 50), zoom = number(1, 50), roll = number(1, 50);
    V_KAMERAPAR *list = chance(30) ? NULL : a_list();
    int count;
    const V_OBJEKT_LIST *object = an_object(&count);

    v_haupt((float)move, (float)orient, (float)zoom, (float)roll, list, count,
            (V_OBJEKT_LIST *)object, chance(80) ? callback_rueck : NULL,
            chance(80) ? callback_ende : NULL);
    return 0;
}

CALL(v_free_liste)
{
    V_KAMERAPAR *list = a_list(), *second;

    if (frame->unaligned || list == NULL || list->number < 1 || list->next == list || !chance(wild)) {
        v_free_liste(list);
        return 0;
    }
    /* Changed by the host: nothing is freed. */
    second = list->next;
    second->number += 7;
    frame->unfit = 1;
    v_free_liste(list);
    if (v_last_error()[0] == '\0' || list->next != second)
        fault("v_free_liste freed a list that was changed");
    second->number -= 7;
    v_free_liste(list);
    return 0;
}

CALL(v_fd) { return v_fd(); }
CALL(v_timeout) { return v_timeout(); }

CALL(v_dispatch) { return v_dispatch(); }

CALL(v_main_loop)
{
    /* Only where it returns: within a callback, or when no window is open. */
    if (depth == 0 && v_dispatch() > 0) {
        word("(windows are open)");
        return v_editor_close(NULL);
    }
    return v_main_loop();
}

CALL(v_set_app_context) { return v_set_app_context(result(64, 0)); }

CALL(v_editor_options_init)
{
    (v_editor_options_init)(result(sizeof(V_EDITOR_OPTIONS), 0));
    return 0;
}

CALL(v_editor_options_init_sized)
{
    v_editor_options_init(result(sizeof(V_EDITOR_OPTIONS), 0));
    return 0;
}

CALL(v_editor_open)
{
    static const char *const titles[] = {NULL, "", "Flug", "a\nb", "\377", "\xc3\xbc"};
    static const char *const displays[] = {NULL, "", ":987", "x", ":0.77", "\377"};
    static const char *const languages[] = {NULL, "de", "en", "fr", "", "\377"};
    V_EDITOR_OPTIONS options;
    V_EDITOR **made;
    int status;

    v_editor_options_init(&options);
    options.title = text(titles[below(chance(wild) ? 6 : 3)]);
    options.language = text(languages[below(chance(wild) ? 6 : 3)]);
    options.display = text(displays[chance(wild) ? below(6) : 0]);
    options.object = chance(50) ? NULL : a_mesh();
    if (chance(50))
        options.path = a_path();
    else if (chance(50))
        options.file = a_file("a.vid");
    if (chance(30)) {
        options.move_frames = number(1, 50);
        options.turn_frames = number(1, 50);
        options.zoom_frames = number(1, 50);
        options.roll_frames = number(1, 50);
    }
    options.on_poses = chance(80) ? callback_on_poses : NULL;
    options.on_close = chance(80) ? callback_on_close : NULL;
    options.on_view = chance(80) ? callback_on_view : NULL;
    options.on_frame = chance(80) ? callback_on_frame : NULL;
    options.on_change = chance(80) ? callback_on_change : NULL;
    options.on_capture = chance(80) ? callback_on_capture : NULL;
    options.on_pane = chance(50) ? callback_on_pane : NULL;
    options.on_gone = chance(80) ? callback_on_gone : NULL;
    options.user = a_user();
    if (chance(wild)) {
        frame->unfit = 1;
        options.size = below(400);
    }
    if (wild > 0) /* titles and the like are not always fit */
        frame->unfit = 1;
    made = result(sizeof *made, 0);
    status = v_editor_open(given("options", &options, sizeof options), made);
    if (status == V_OK)
        frame->made_editor = *made;
    return status;
}

CALL(v_editor_close)
{
    V_EDITOR *editor = an_editor();
    int i, status = v_editor_close(editor);

    for (i = 0; i < EDITORS; i++)
        if (status == V_OK && editors[i] == editor && editor != NULL) {
            make_stale(editor);
            editors[i] = NULL;
        }
    return status;
}

CALL(v_editor_get_path)
{
    const V_EDITOR *editor = an_editor();
    V_PATH **path = result(sizeof *path, 0);
    int status = v_editor_get_path(editor, path);

    if (status == V_OK)
        frame->made_path = *path;
    return status;
}

CALL(v_editor_set_path)
{
    V_EDITOR *editor = an_editor();
    return v_editor_set_path(editor, a_path());
}

CALL(v_editor_set_view)
{
    V_EDITOR *editor = an_editor();
    return v_editor_set_view(editor, a_pose());
}

CALL(v_editor_get_frame)
{
    const V_EDITOR *editor = an_editor();
    return v_editor_get_frame(editor, result(sizeof(double), 0));
}

CALL(v_editor_set_frame)
{
    V_EDITOR *editor = an_editor();
    return v_editor_set_frame(editor, number(1, 2));
}

CALL(v_editor_play)
{
    V_EDITOR *editor = an_editor();
    return v_editor_play(editor, (int)below(2));
}

CALL(v_editor_select)
{
    V_EDITOR *editor = an_editor();
    int point = whole(0, 1);
    return v_editor_select(editor, point, whole(0, 0));
}

CALL(v_editor_set_object)
{
    V_EDITOR *editor = an_editor();
    return v_editor_set_object(editor, a_mesh());
}

CALL(v_editor_set_title)
{
    static const char *const titles[] = {NULL, "", "Flug", "\xc3\xbc", "a\nb", "\377"};
    V_EDITOR *editor = an_editor();
    int odd = chance(wild);

    frame->unfit |= odd;
    return v_editor_set_title(editor, text(titles[below(odd ? 6 : 4)]));
}

CALL(v_editor_undo) { return v_editor_undo(an_editor()); }

CALL(v_editor_redo) { return v_editor_redo(an_editor()); }

CALL(v_editor_begin_step) { return v_editor_begin_step(an_editor()); }

CALL(v_editor_end_step) { return v_editor_end_step(an_editor()); }

CALL(v_editor_get_selection)
{
    const V_EDITOR *editor = an_editor();
    int *point = result(sizeof *point, 1);
    return v_editor_get_selection(editor, point, result(sizeof(int), 1));
}

CALL(v_editor_is_playing)
{
    const V_EDITOR *editor = an_editor();
    return v_editor_is_playing(editor, result(sizeof(int), 0));
}

CALL(v_editor_is_modified)
{
    const V_EDITOR *editor = an_editor();
    return v_editor_is_modified(editor, result(sizeof(int), 0));
}

CALL(v_editor_mark_saved) { return v_editor_mark_saved(an_editor()); }

CALL(v_editor_save)
{
    V_EDITOR *editor = an_editor();
    return v_editor_save(editor, a_file("saved.vid"));
}

CALL(v_editor_raise) { return v_editor_raise(an_editor()); }

CALL(v_editors_close)
{
    /* As v_main_loop(): nobody is there to answer, and the others are needed. */
    if (depth == 0 && v_dispatch() > 0) {
        word("(windows are open)");
        return v_editor_close(NULL);
    }
    return v_editors_close((int)below(2));
}

int (*ask_after_call)(void);
int asked_after_call;

/* ---- All of them ------------------------------------------------------------------------ */

#define ENTRY(name, answers, normally, display) \
    {#name, call_##name, answers, normally, display},

const struct function functions[] = {EACH_FUNCTION(ENTRY)};
const int function_count = sizeof functions / sizeof *functions;

const struct function *function_named(const char *name)
{
    int i;

    for (i = 0; i < function_count; i++)
        if (strcmp(functions[i].name, name) == 0)
            return &functions[i];
    return NULL;
}

static const struct documented *documentation_of(const char *name)
{
    size_t i;

    for (i = 0; i < sizeof documented / sizeof *documented; i++)
        if (strcmp(documented[i].name, name) == 0)
            return &documented[i];
    return NULL;
}

void check_names(void)
{
    size_t i;
    int j;

    for (i = 0; i < sizeof documented / sizeof *documented; i++)
        if (function_named(documented[i].name) == NULL)
            fault("%s is in the header and not in this test", documented[i].name);
    for (j = 0; j < function_count; j++)
        if (documentation_of(functions[j].name) == NULL)
            fault("%s is in this test and not in the header", functions[j].name);
}

/* An answer against the function's documentation; V_ERR_INTERNAL only where it
 * is expected. */
static void check_answer(const struct function *function, int answer, int expected)
{
    const char *name = function->name, *said = v_last_error();
    unsigned may = documentation_of(name)->statuses | 1u << V_OK;

    if (expected == V_ERR_INTERNAL)
        may = 1u << V_ERR_INTERNAL;

    switch (function->answers) {
    case STATUS:
        if (frame->unaligned)
            may |= 1u << V_ERR_ARGUMENT; /* said once for all functions */
        if (answer < V_OK || answer > V_ERR_REFUSED || (may >> answer & 1) == 0)
            fault("%s answers %d, which is not documented: %s", name, answer, said);
        if ((answer == V_OK) != (said[0] == '\0'))
            fault("%s answers %d and says \"%s\"", name, answer, said);
        if (answer != V_OK && !frame_untouched())
            fault("%s answers %d and has written", name, answer);
        break;
    case NOTHING:
        if (said[0] != '\0' && !frame_untouched())
            fault("%s failed and has written: %s", name, said);
        break;
    case COUNT:
        if (answer < -1)
            fault("%s answers %d", name, answer);
        break;
    case TEXT:
        if (!answer)
            fault("%s answers nothing", name);
    }
}

int call(const struct function *function, int instead)
{
    struct frame here;
    char said[200];
    int answer, expected = instead != -2 ? instead : function->normally;

    if (depth > 0
        && (function->call == call_v_main_loop || function->call == call_v_editors_close))
        expected = V_ERR_BUSY;
    frame_begin(&here, function->name);
    answer = function->call();
    if (ask_after_call != NULL)
        asked_after_call = ask_after_call();
    snprintf(said, sizeof said, "%s", v_last_error());
    check_answer(function, answer, expected);
    if (here.made_path != NULL)
        keep_path(here.made_path);
    if (here.made_editor != NULL)
        keep_editor(here.made_editor);
    here.unfit |= function->needs_display && (!display_there || windows_may_go);
    if (!here.unfit && expected != -2
        && (function->answers == STATUS    ? answer != expected
            : function->answers == NOTHING ? (said[0] != '\0') != (expected != V_OK)
                                           : 0))
        fault("%s answers %d instead of %d to fit arguments: %s", function->name, answer,
              expected, said);
    frame_end();
    remember(here.text, answer);
    return answer;
}
