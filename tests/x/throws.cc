/*
 * A C++ host whose callback throws: throws CALLBACK, one of rueck, ende, on_poses,
 * on_close, interpolation. What another of its callbacks throws and catches itself is nobody's business.
 */
#include <cstdio>
#include <cstring>
#include <stdexcept>

#include <libvides.h>

static const char *which;

static void may_throw(const char *here)
{
    try {
        throw 1;
    } catch (int) {
        std::printf("caught within %s\n", here);
        std::fflush(stdout);
    }
    if (std::strcmp(here, which) == 0)
        throw std::runtime_error("on purpose");
}

extern "C" {
static void rueck(V_KAMERAPAR *, int) { may_throw("rueck"); }
static int ende(void) { may_throw("ende"); return 1; }
static void on_poses(V_EDITOR *, const V_POSE *, size_t, void *) { may_throw("on_poses"); }
static int on_close(V_EDITOR *, void *) { may_throw("on_close"); return 1; }
static int interpolation(const double *frames, const double *values, size_t width,
                         size_t keys, double frame, double *value, void *user)
{
    /* All arguments arrive. */
    if (keys != 2 || width != 3 || frames[1] != 9 || values[3] != 1 || frame != 5
        || user != static_cast<void *>(&which))
        return 1;
    may_throw("interpolation");
    for (size_t i = 0; i < width; i++)
        value[i] = 7;
    return V_OK;
}
}

/* A scene whose camera moves by a function of this program's. */
static int interpolate()
{
    static const double frames[] = {1, 9}, values[] = {0, 0, 0, 1, 2, 3};
    V_SCENE *scene;
    V_NODE_STATE state;
    size_t count;

    if (v_scene_new(&scene) != V_OK || v_scene_set_path(scene, 0, NULL, 1, V_AFTER_HOLD) != V_OK
        || v_register_interpolation("ours", interpolation, &which) != V_OK
        || v_scene_set_track(scene, 0, "position", "host:ours", frames, values, NULL, 2,
                             V_AFTER_HOLD) != V_OK)
        return 2;
    if (v_scene_evaluate(scene, 5, &state, 1, &count) != V_OK)
        return 4;
    v_scene_free(scene);
    return state.matrix[12] == 7 && state.matrix[14] == 7 ? 0 : 5;
}

int main(int argc, char **argv)
{
    which = argc > 1 ? argv[1] : "";
    if (std::strcmp(which, "interpolation") == 0 || std::strcmp(which, "none") == 0)
        return interpolate();
    if (std::strncmp(which, "on_", 3) == 0) {
        V_EDITOR_OPTIONS options;
        V_EDITOR *editor;
        v_editor_options_init(&options);
        options.on_poses = on_poses;
        options.on_close = on_close;
        if (v_editor_open(&options, &editor) != V_OK)
            return 2;
    } else {
        v_haupt(100, 100, 100, 100, NULL, 0, NULL, rueck, ende);
    }
    try {
        return v_main_loop();
    } catch (...) {
        return 3;
    }
}
