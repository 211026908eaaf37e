/* Properties by name: see every.h. */
#include "functions.h"
#include "things.h"
#include "scene_things.h"

CALL(v_property_info)
{
    V_PROPERTY property = {0};

    property.size = sizeof property;
    if (chance(wild)) {
        frame->unfit = 1;
        property.size = below(100);
    }
    return v_property_info(whole(0, 20), given("V_PROPERTY", &property, sizeof property));
}

CALL(v_property_count)
{
    return v_property_count(result(sizeof(int), 0));
}

/* The name of a property, or now and then one of another kind, or none. */
static const char *a_property(const char *fit)
{
    static const char *const unfit[] = {NULL, "", "point.2.own", "closed", "title", "fps",
                                        "point.9.zoom", "node.9.zoom"};

    if (!chance(wild))
        return text(fit);
    frame->unfit = 1;
    return text(unfit[below(8)]);
}

CALL(v_path_key)
{
    int point = whole(0, 5), orientation = whole(-1, 3);

    v_path_key(point, orientation, a_property("zoom"));
    return 0;
}

CALL(v_path_set_number)
{
    V_PATH *path = a_path();
    const char *name = a_property("fps");

    return v_path_set_number(path, name, number(1, 100));
}

CALL(v_path_get_number)
{
    const V_PATH *path = a_path();
    const char *name = a_property("fps");

    return v_path_get_number(path, name, result(sizeof(double), 0));
}

CALL(v_path_set_numbers)
{
    V_PATH *path = a_path();
    const char *name = a_property("point.2.tangents");

    return v_path_set_numbers(path, name, numbers(6, -1, 1), 6);
}

CALL(v_path_get_numbers)
{
    const V_PATH *path = a_path();
    const char *name = a_property("point.2.tangents");
    double *values = result(6 * sizeof *values, 0);
    size_t *count = result(sizeof *count, 0);

    return too_small(v_path_get_numbers(path, name, values, 6, count), count, 6);
}

CALL(v_path_set_text)
{
    V_PATH *path = a_path();
    const char *name = a_property("title");

    return v_path_set_text(path, name, text(below(2) ? "Um den Turm" : ""));
}

CALL(v_path_get_text)
{
    const V_PATH *path = a_path();
    const char *name = a_property("title");
    char *value = result(100, 0);
    size_t *length = result(sizeof *length, 0);

    return too_small(v_path_get_text(path, name, value, 100, length), length, 100);
}

CALL(v_path_set_flag)
{
    V_PATH *path = a_path();
    const char *name = a_property("closed");

    return v_path_set_flag(path, name, whole(0, 1));
}

CALL(v_path_get_flag)
{
    const V_PATH *path = a_path();
    const char *name = a_property("closed");

    return v_path_get_flag(path, name, result(sizeof(int), 0));
}

CALL(v_scene_key)
{
    int node = whole(0, 5);

    v_scene_key(node, a_property("zoom"));
    return 0;
}

CALL(v_scene_set_number)
{
    V_SCENE *scene = a_scene();
    const char *name = a_property("check.turning");

    return v_scene_set_number(scene, name, number(1, 100));
}

CALL(v_scene_get_number)
{
    const V_SCENE *scene = a_scene();
    const char *name = a_property("check.turning");

    return v_scene_get_number(scene, name, result(sizeof(double), 0));
}

CALL(v_scene_set_numbers)
{
    V_SCENE *scene = a_scene();
    const char *name = a_property("node.2.position");

    return v_scene_set_numbers(scene, name, numbers(3, -1, 1), 3);
}

CALL(v_scene_get_numbers)
{
    const V_SCENE *scene = a_scene();
    const char *name = a_property("node.2.position");
    double *values = result(3 * sizeof *values, 0);
    size_t *count = result(sizeof *count, 0);

    return too_small(v_scene_get_numbers(scene, name, values, 3, count), count, 3);
}

CALL(v_scene_set_text)
{
    V_SCENE *scene = a_scene();
    const char *name = a_property("comment");

    return v_scene_set_text(scene, name, text(below(2) ? "Um den Turm" : ""));
}

CALL(v_scene_get_text)
{
    const V_SCENE *scene = a_scene();
    const char *name = a_property("comment");
    char *value = result(100, 0);
    size_t *length = result(sizeof *length, 0);

    return too_small(v_scene_get_text(scene, name, value, 100, length), length, 100);
}

CALL(v_scene_set_flag)
{
    V_SCENE *scene = a_scene();
    const char *name = a_property("node.2.visible");

    return v_scene_set_flag(scene, name, whole(0, 1));
}

CALL(v_scene_get_flag)
{
    const V_SCENE *scene = a_scene();
    const char *name = a_property("node.2.visible");

    return v_scene_get_flag(scene, name, result(sizeof(int), 0));
}
