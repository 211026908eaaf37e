/*
 * The header on its own, in the strictest mode of every standard; then again,
 * since a file may include it twice.
 */
#include "libvides.h"
#include "libvides.h"

int uses_nothing_else(V_PATH *path, V_POSE *pose, size_t *count);
int uses_nothing_else(V_PATH *path, V_POSE *pose, size_t *count)
{
    return v_path_sample(path, pose, 0, count);
}
