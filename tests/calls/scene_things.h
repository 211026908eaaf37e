/*
 * The scene on which the calls of every_scene.c and every_contents.c work.
 */
#ifndef SCENE_THINGS_H
#define SCENE_THINGS_H

#include "libvides.h"

/* A camera on a path, a sheet that changes and moves, a lamp in it: made anew for
 * each call, always by the same calls. */
V_SCENE *a_scene(void);
/* The number of one of its nodes. */
int a_node(void);
/* The name of a thing in a scene. */
const char *a_name(void);

#endif
