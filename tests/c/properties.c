/*
 * Properties by name: numbers, lists of them, texts and flags of paths and scenes, by names that
 * count from 1 and, in loops, of indices. What is wrong is refused by its name and changes nothing.
 */
#include "check.h"

/* The last error is this sentence, or begins so. */
#define SAID(text) CHECK(strncmp(v_last_error(), text, strlen(text)) == 0)

static void numbers_and_flags(void)
{
    V_PATH *path = new_path();
    V_ORIENTATION view;
    double zoom = 0, ahead = 0, list[30];
    size_t count = 99;
    int on = 7;

    view.size = sizeof view;
    OK(v_path_set_number(path, "point.2.zoom", 30));
    OK(v_path_get_orientation(path, 1, 0, &view));
    CHECK(view.zoom == 30);
    OK(v_path_get_number(path, "point.2.view.1.zoom_mm", &zoom));
    CHECK(zoom == 30);
    OK(v_path_set_text(path, "point.2.zoom", ""));
    OK(v_path_get_number(path, "point.2.zoom", &zoom));
    CHECK(zoom == 24);
    OK(v_path_get_number(path, "point.1.ahead", &ahead));
    CHECK(isnan(ahead));
    OK(v_path_set_number(path, "point.1.ahead", 0));
    OK(v_path_get_number(path, "point.1.ahead", &ahead));
    CHECK(ahead == 0);

    OK(v_path_get_numbers(path, "point.1.own", list, 30, &count));
    CHECK(count == 0); /* it has a preset */
    list[0] = 0.5, list[1] = -0.25, list[2] = 1;
    OK(v_path_set_numbers(path, "point.1.own", list, 3));
    OK(v_path_get_number(path, "point.1.preset", &zoom));
    CHECK(isnan(zoom));
    memset(list, 0, sizeof list);
    OK(v_path_get_numbers(path, "point.1.own", list, 3, &count));
    CHECK(count == 3 && list[0] == 0.5 && list[1] == -0.25 && list[2] == 1);
    list[0] = 7;
    STATUS(V_ERR_SIZE, v_path_get_numbers(path, "presets", list, 29, &count));
    CHECK(count == 30 && list[0] == 7);
    OK(v_path_get_numbers(path, "presets", NULL, 0, &count));
    OK(v_path_get_numbers(path, "presets", list, 30, &count));
    CHECK(list[3] == 0.3 && list[15] == 0 && list[16] == -0.5); /* thesis A.6.1 */
    OK(v_path_get_numbers(path, "point.1.position", list, 30, &count));
    CHECK(count == 3 && list[0] == -0.6 && list[1] == 0.2 && list[2] == 0.8);

    OK(v_path_set_flag(path, "closed", 1));
    OK(v_path_get_flag(path, "closed", &on));
    CHECK(on == 1);
    OK(v_path_set_flag(path, "point.1.locked", -3));
    OK(v_path_tool(path, "reverse", NULL, NULL)); /* closed: the section from 1 to 2 goes from 2 to 1 then */
    OK(v_path_get_flag(path, "point.1.locked", &on));
    CHECK(on == 0);
    OK(v_path_get_flag(path, "point.2.locked", &on));
    CHECK(on == 1);

    OK(v_path_set_number(path, "check.turning", INFINITY));
    OK(v_path_get_number(path, "check.turning", &zoom));
    CHECK(zoom == INFINITY);
    v_path_free(path);
}

static void texts(void)
{
    V_PATH *path = new_path();
    char value[100], small[2] = "a";
    size_t length = 99;

    OK(v_path_set_text(path, "title", "\"Um\" den Turm"));
    OK(v_path_get_text(path, "title", value, sizeof value, &length));
    CHECK(strcmp(value, "\"Um\" den Turm") == 0 && length == 13);
    STATUS(V_ERR_SIZE, v_path_get_text(path, "title", small, sizeof small, &length));
    CHECK(strcmp(small, "a") == 0 && length == 13);
    OK(v_path_set_text(path, "curve", "cubic"));
    OK(v_path_get_text(path, "curve", value, sizeof value, &length));
    CHECK(strcmp(value, "cubic") == 0);
    OK(v_path_set_text(path, "comment", "first\nsecond"));
    OK(v_path_get_text(path, "comment", value, sizeof value, &length));
    CHECK(strcmp(value, "first\nsecond") == 0);
    /* Others as in a file. */
    OK(v_path_set_text(path, "point.2.zoom", "35"));
    OK(v_path_get_text(path, "point.2.zoom", value, sizeof value, &length));
    CHECK(strcmp(value, "35.0") == 0);
    OK(v_path_set_text(path, "point.2.ease",
        "{ kind = \"sine\", rise = 0.5, fall = 0, cruise = 50 }"));
    v_path_free(path);
}

static void in_loops(void)
{
    V_PATH *path = new_path();
    double zoom = 0;
    int point, view;

    CHECK(strcmp(v_path_key(1, 2, "zoom"), "point.2.view.3.zoom") == 0);
    CHECK(strcmp(v_path_key(1, -1, "position"), "point.2.position") == 0);
    CHECK(strcmp(v_scene_key(0, "colour"), "node.1.colour") == 0);
    CHECK(strcmp(v_path_key(-1, 0, "zoom"), "") == 0);
    SAID("point is -1");
    CHECK(strcmp(v_path_key(0, -2, "zoom"), "") == 0);
    SAID("orientation is -2");
    CHECK(strcmp(v_path_key(0, 0, NULL), "") == 0);
    SAID("key is NULL");
    OK(v_path_insert_orientation(path, 0, 1, NULL));
    for (point = 0; point < 2; point++)
        for (view = 0; view < 2 - point; view++)
            OK(v_path_set_number(path, v_path_key(point, view, "zoom"), 30 + 10 * point + view));
    OK(v_path_get_number(path, "point.1.view.2.zoom", &zoom));
    CHECK(zoom == 31);
    OK(v_path_get_number(path, v_path_key(1, 0, "zoom"), &zoom));
    CHECK(zoom == 40);
    v_path_free(path);
}

static void what_is_refused(void)
{
    V_PATH *path = new_path();
    double value = 0, none[2] = {0, 0};
    int on = 0;

    STATUS(V_ERR_RANGE, v_path_set_number(path, "point.2.zoom", 3000));
    SAID("point.2.zoom: the zoom must lie between 1 and 2000");
    STATUS(V_ERR_RANGE, v_path_set_number(path, "point.2.zoom", NAN));
    STATUS(V_ERR_RANGE, v_path_set_number(path, "point.2.colour", 1));
    SAID("there is no property \"point.2.colour\"; known here: ");
    STATUS(V_ERR_RANGE, v_path_set_number(path, "point.3.zoom", 30));
    SAID("there is no point 3: the path has points 1 to 2");
    STATUS(V_ERR_RANGE, v_path_set_number(path, "check.boredom", 30));
    STATUS(V_ERR_ARGUMENT, v_path_set_number(path, "point.2.hold", 1.5));
    SAID("point.2.hold: expected a whole number, found a number");
    STATUS(V_ERR_RANGE, v_path_set_number(path, "point.2.hold", -1));
    STATUS(V_ERR_ARGUMENT, v_path_set_number(path, "closed", 1));
    SAID("closed: expected true or false, found a number");
    STATUS(V_ERR_ARGUMENT, v_path_set_text(path, "closed", "perhaps"));
    STATUS(V_ERR_ARGUMENT, v_path_set_text(path, "curve", "round"));
    STATUS(V_ERR_ARGUMENT, v_path_set_text(path, "title", "two\nlines"));
    STATUS(V_ERR_ARGUMENT, v_path_set_text(path, "title", "\xff"));
    SAID("value is not UTF-8");
    STATUS(V_ERR_ARGUMENT, v_path_set_numbers(path, "point.2.position", none, 2));
    SAID("point.2.position: expected 3 numbers, found 2");
    STATUS(V_ERR_ARGUMENT, v_path_get_number(path, "title", &value));
    SAID("title: expected a text, found a number");
    STATUS(V_ERR_ARGUMENT, v_path_get_flag(path, "fps", &on));
    STATUS(V_ERR_NULL, v_path_set_number(path, NULL, 1));
    STATUS(V_ERR_NULL, v_path_set_text(path, "title", NULL));
    STATUS(V_ERR_NULL, v_path_set_numbers(path, "point.2.position", NULL, 3));
    STATUS(V_ERR_NULL, v_path_get_number(path, "fps", NULL));
    OK(v_path_get_number(path, "point.2.zoom", &value));
    CHECK(value == 24);
    v_path_free(path);
    STATUS(V_ERR_HANDLE, v_path_set_flag(path, "closed", 1));
    STATUS(V_ERR_HANDLE, v_path_get_flag(path, "closed", &on));
}

static void scenes(void)
{
    V_SCENE *scene = NULL;
    V_NODE lamp;
    double value = 0, colour[3] = {1, 0.5, 0.25};
    char text[100];
    size_t count = 0;
    int node = -1, on = 7;

    OK(v_scene_new(&scene));
    v_node_init(&lamp, V_NODE_LIGHT);
    OK(v_scene_add_node(scene, "lamp", &lamp, &node));
    OK(v_scene_set_number(scene, "node.lamp.intensity", 3));
    OK(v_scene_set_numbers(scene, v_scene_key(node, "colour"), colour, 3));
    OK(v_scene_set_flag(scene, "node.2.visible", 0));
    lamp.size = sizeof lamp;
    OK(v_scene_get_node(scene, node, &lamp));
    CHECK(lamp.intensity == 3 && lamp.colour[1] == 0.5 && lamp.visible == 0);
    OK(v_scene_get_number(scene, "node.2.intensity", &value));
    CHECK(value == 3);
    OK(v_scene_get_numbers(scene, "node.lamp.colour", colour, 3, &count));
    CHECK(count == 3 && colour[2] == 0.25);
    OK(v_scene_get_flag(scene, "node.lamp.visible", &on));
    CHECK(on == 0);
    OK(v_scene_set_text(scene, "title", "Two lamps"));
    OK(v_scene_get_text(scene, "title", text, sizeof text, &count));
    CHECK(strcmp(text, "Two lamps") == 0);
    OK(v_scene_set_number(scene, "fps", 50));
    OK(v_scene_set_number(scene, "check.zoom", 5));
    OK(v_scene_get_number(scene, "check.zoom", &value));
    CHECK(value == 5);

    STATUS(V_ERR_RANGE, v_scene_set_number(scene, "node.lamp.intensity", -1));
    SAID("node.lamp.intensity: ");
    STATUS(V_ERR_RANGE, v_scene_set_number(scene, "fps", 0));
    STATUS(V_ERR_ARGUMENT, v_scene_set_number(scene, "node.moon.intensity", 1));
    STATUS(V_ERR_RANGE, v_scene_set_flag(scene, "closed", 1)); /* of a path */
    OK(v_scene_get_number(scene, "fps", &value));
    CHECK(value == 50);
    v_scene_free(scene);
    STATUS(V_ERR_HANDLE, v_scene_set_number(scene, "fps", 25));
}

/* Every property that there is can be asked of a new path or scene, and has the usual value. */
static void all_that_is_known(void)
{
    V_PATH *path = new_path();
    V_SCENE *scene = NULL;
    V_PROPERTY property;
    char name[100], text[2000];
    size_t length;
    int count = 0, at, kinds[4] = {0};

    OK(v_scene_new(&scene));
    property.size = sizeof property;
    OK(v_property_count(&count));
    CHECK(count > 50);
    for (at = 0; at < count; at++) {
        const char *from, *end;
        char *to = name;

        OK(v_property_info(at, &property));
        CHECK(strlen(property.about) > 5 && property.least <= property.most);
        kinds[property.kind]++;
        for (from = property.name, end = from + strlen(from); from < end; from++)
            *to++ = *from == 'N' ? '1' : *from;
        *to = '\0';
        if (strncmp(name, "node.", 5) == 0)
            OK(v_scene_get_text(scene, name, text, sizeof text, &length));
        else
            OK(v_path_get_text(path, name, text, sizeof text, &length));
        if (property.kind == V_PROPERTY_NUMBER && strncmp(name, "node.", 5) != 0) {
            double value = 0;
            OK(v_path_get_number(path, name, &value));
            CHECK(isnan(value) == (property.usual[0] == '\0'));
            if (!isnan(value) && isfinite(value))
                CHECK(value == atof(property.usual) && value >= property.least && value <= property.most);
        }
    }
    CHECK(kinds[0] > 20 && kinds[1] > 10 && kinds[2] > 5 && kinds[3] > 2);
    STATUS(V_ERR_RANGE, v_property_info(count, &property));
    STATUS(V_ERR_RANGE, v_property_info(-1, &property));
    property.size = 3;
    STATUS(V_ERR_SIZE, v_property_info(0, &property));
    v_scene_free(scene);
    v_path_free(path);
}

int main(void)
{
    numbers_and_flags();
    texts();
    in_loops();
    what_is_refused();
    scenes();
    all_that_is_known();
    return failures != 0;
}
