/* What is set in a scene and read again: see every.h. */
#include "functions.h"
#include "scene_things.h"
#include "things.h"

#define POINTS 4

CALL(v_scene_set_camera)
{
    V_SCENE *of = a_scene();
    return v_scene_set_camera(of, whole(-1, 0));
}

CALL(v_scene_get_camera)
{
    const V_SCENE *of = a_scene();
    return v_scene_get_camera(of, result(sizeof(int), 0));
}

CALL(v_scene_count)
{
    static const char *const of_what[] = {"nodes", "markers", "pins", "tracks", "shapes",
                                          "deformations", "wheels", ""};
    const V_SCENE *of = a_scene();
    int node = whole(1, 1);
    unsigned what = below(chance(wild) ? 8 : 6);

    frame->unfit |= what >= 6;
    return v_scene_count(of, node, text(of_what[what]), result(sizeof(int), 0));
}

CALL(v_scene_set_range)
{
    V_SCENE *of = a_scene();
    double first = number(-100, 100);
    return v_scene_set_range(of, first, number(-100, 100));
}

CALL(v_scene_set_parent)
{
    V_SCENE *of = a_scene();
    int node = whole(2, 2), parent = whole(-1, 1);
    return v_scene_set_parent(of, node, parent, whole(V_KEEP_PLACE, V_KEEP_NUMBERS));
}

CALL(v_scene_get_channel)
{
    const V_SCENE *of = a_scene();
    int node = whole(1, 1), at = whole(0, 0);
    return v_scene_get_channel(of, node, at, result(sizeof(char *), 0));
}

CALL(v_scene_get_marker)
{
    const V_SCENE *of = a_scene();
    int at = whole(0, 0);
    const char **name = result(sizeof *name, 1);
    return v_scene_get_marker(of, at, name, result(sizeof(double), 1));
}

CALL(v_scene_remove_marker)
{
    V_SCENE *of = a_scene();
    if (chance(wild)) {
        frame->unfit = 1;
        return v_scene_remove_marker(of, a_name());
    }
    return v_scene_remove_marker(of, text("meet"));
}

/* The same with a pin, if it is a scene. */
static V_SCENE *a_pinned_scene(void)
{
    V_SCENE *of = a_scene();
    v_scene_pin(of, 0, 1, "meet");
    return of;
}

CALL(v_scene_get_pin)
{
    V_SCENE *of = a_pinned_scene();
    int at = whole(0, 0);
    int *node = result(sizeof *node, 1), *point = result(sizeof *point, 1);
    return v_scene_get_pin(of, at, node, point, result(sizeof(char *), 1));
}

CALL(v_scene_get_geometry)
{
    const V_SCENE *of = a_scene();
    int node = whole(1, 1);
    V_MESH mesh = {0};

    mesh.size = sizeof mesh;
    if (chance(wild)) {
        frame->unfit = 1;
        mesh.size = below(200);
    }
    return v_scene_get_geometry(of, node, given("V_MESH", &mesh, sizeof mesh));
}

CALL(v_scene_get_shape)
{
    const V_SCENE *of = a_scene();
    int node = whole(1, 1), at = whole(0, 0);
    const char **name = result(sizeof *name, 1);
    double *xyz = result(3 * POINTS * sizeof *xyz, 1);
    unsigned char *rgb = result(3 * POINTS, 1);
    size_t *points = result(sizeof *points, 1);
    int *coloured = result(sizeof *coloured, 1);
    return too_small(v_scene_get_shape(of, node, at, name, xyz, rgb, POINTS, points, coloured),
                     points, POINTS);
}

CALL(v_scene_remove_shape)
{
    V_SCENE *of = a_scene();
    int node = whole(1, 1);
    return v_scene_remove_shape(of, node, whole(0, 0));
}

CALL(v_scene_get_deformation)
{
    const V_SCENE *of = a_scene();
    int node = whole(1, 1), at = whole(0, 0);
    const char **kind = result(sizeof *kind, 1);
    double *parameters = result(2 * sizeof *parameters, 1);
    size_t *count = result(sizeof *count, 1);
    double *box = result(6 * sizeof *box, 1);
    return too_small(v_scene_get_deformation(of, node, at, kind, parameters, 2, count, box), count,
                     2);
}
