/*
 * headless: a camera path without a window.
 *
 *     cc -o headless headless.c -lvides -lm
 *     ./headless flight.vid
 *
 * Loads a path from a .vid file, takes all its camera poses as a list, walks
 * the list in both directions, and frees everything.
 */
#include <stdio.h>

#include <libvides.h>

/* One pose on one line: where the camera is, where it looks, what is up. */
static void print_pose(const V_KAMERAPAR *pose)
{
    printf("%5d  at %7.4f %7.4f %7.4f  to %7.4f %7.4f %7.4f  up %7.4f %7.4f %7.4f  zoom %d\n",
           pose->number,
           pose->VRP.x, pose->VRP.y, pose->VRP.z,
           pose->VPN.x, pose->VPN.y, pose->VPN.z,
           pose->VUP.x, pose->VUP.y, pose->VUP.z, pose->zoom);
}

int main(int argc, char **argv)
{
    V_PATH *path;               /* a handle; the library knows what is behind it */
    V_KAMERAPAR first;          /* the list's first element is ours ... */
    const V_KAMERAPAR *pose;

    if (argc != 2) {
        fprintf(stderr, "usage: headless FILE.vid\n");
        return 2;
    }

    /* Every call answers V_OK or what went wrong; v_last_error() says it in words. */
    if (v_path_load(argv[1], &path) != V_OK) {
        fprintf(stderr, "headless: %s\n", v_last_error());
        return 1;
    }

    first.number = -1;          /* ... and this says that there is no list yet */
    if (v_path_to_list(path, &first) != V_OK) {
        fprintf(stderr, "headless: %s\n", v_last_error());
        v_path_free(path);
        return 1;
    }
    v_path_free(path);          /* the list does not need it any more */

    /* The list is a ring: after the last pose comes the first. */
    printf("%d poses, forwards:\n", first.prev->number);
    pose = &first;
    do {
        print_pose(pose);
        pose = pose->next;
    } while (pose != &first);

    printf("and backwards:\n");
    do {
        pose = pose->prev;
        print_pose(pose);
    } while (pose != &first);

    v_free_liste(&first);       /* all but the first, which was not malloc's */
    return 0;
}
