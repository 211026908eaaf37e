/*
 * What the calls of every.c work on: paths, windows, lists, files; and handles
 * and names drawn among them, see draw.h.
 */
#ifndef THINGS_H
#define THINGS_H

#include "draw.h"
#include "every.h"

#define PATHS 6
#define LISTS 6
/* No path has more poses than this when a call begins. */
#define POSES 3000

/* A handle, or one that is none. */
void *handle(void *one);
/* It is valid no more, and may be drawn as one that is none. */
void make_stale(void *handle);

/* A path with four points or more. */
V_PATH *a_path(void);
/* A new path takes the place of an older one. */
void keep_path(V_PATH *made);
int points_of(const V_PATH *path);
int orientations_of(const V_PATH *path, int point);
int a_point(const V_PATH *path);
int a_segment(const V_PATH *path);
int an_orientation(const V_PATH *path, int point);
/* A point with so many orientations. */
int a_point_with(const V_PATH *path, int least, int most);

/* A file of this name, or a name that will not do. */
const char *a_file(const char *fit);

V_EDITOR *an_editor(void);
void keep_editor(V_EDITOR *made);

V_KAMERAPAR *a_list(void);

/* A camera. */
const V_POSE *a_pose(void);

/* A mesh of a few points. */
const V_MESH *a_mesh(void);

#endif
