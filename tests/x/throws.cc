/*
 * A C++ host whose callback throws: throws CALLBACK, one of rueck, ende, on_poses,
 * on_close. What another of its callbacks throws and catches itself is nobody's business.
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
}

int main(int argc, char **argv)
{
    which = argc > 1 ? argv[1] : "";
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
