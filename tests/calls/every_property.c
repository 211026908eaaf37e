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

CALL(v_scene_key)
{
    int node = whole(0, 5);

    v_scene_key(node, a_property("zoom"));
    return 0;
}

/* Getter and setter of a form: what is given, and room for what is returned. */
#define ONE(kind, TYPE, form, fit, value, RESULT) \
    CALL(v_##kind##_set_##form) \
    { \
        TYPE *it = a_##kind(); \
        const char *name = a_property(fit); \
        return v_##kind##_set_##form(it, name, value); \
    } \
    CALL(v_##kind##_get_##form) \
    { \
        const TYPE *it = a_##kind(); \
        const char *name = a_property(fit); \
        return v_##kind##_get_##form(it, name, result(sizeof(RESULT), 0)); \
    }

#define SEVERAL(kind, TYPE, form, fit, value, RESULT, room) \
    CALL(v_##kind##_set_##form) \
    { \
        TYPE *it = a_##kind(); \
        const char *name = a_property(fit); \
        return v_##kind##_set_##form(it, name, value); \
    } \
    CALL(v_##kind##_get_##form) \
    { \
        const TYPE *it = a_##kind(); \
        const char *name = a_property(fit); \
        RESULT *values = result((room) * sizeof *values, 0); \
        size_t *count = result(sizeof *count, 0); \
        return too_small(v_##kind##_get_##form(it, name, values, room, count), count, room); \
    }

#define VALUES(width) numbers(width, -1, 1), width

ONE(path, V_PATH, number, "fps", number(1, 100), double)
ONE(path, V_PATH, flag, "closed", whole(0, 1), int)
SEVERAL(path, V_PATH, numbers, "point.2.tangents", VALUES(6), double, 6)
SEVERAL(path, V_PATH, text, "title", text(below(2) ? "Um den Turm" : ""), char, 100)
ONE(scene, V_SCENE, number, "check.turning", number(1, 100), double)
ONE(scene, V_SCENE, flag, "node.2.visible", whole(0, 1), int)
SEVERAL(scene, V_SCENE, numbers, "node.2.position", VALUES(3), double, 3)
SEVERAL(scene, V_SCENE, text, "space.up", text(below(2) ? "y" : "z"), char, 100)
