/*
 * plain_main_loop: an editor window for a program that has none itself.
 *
 *     cc -o plain_main_loop plain_main_loop.c -lvides -lm
 *
 * Opens the editor, runs until the user has closed it, and prints the poses
 * that were handed over. No X library is linked.
 */
#include <stdio.h>

#include <libvides.h>

int main(void)
{
    V_KAMERAPAR first; /* the list's first element; outlives the window */
    const V_KAMERAPAR *pose;

    first.number = -1; /* no poses yet */
    v_haupt(100, 100, 100, 100, &first, 0, NULL, NULL, NULL);

    /* v_haupt() has returned at once. With no loop of our own, the library's
     * runs the window, and ends when the last one is closed. */
    if (v_last_error()[0] != '\0' || v_main_loop() != V_OK) {
        fprintf(stderr, "plain_main_loop: %s\n", v_last_error());
        return 1;
    }

    if (first.number < 0) {
        printf("nothing was handed over\n");
        return 0;
    }
    pose = &first;
    do {
        printf("%d: %f %f %f\n", pose->number, pose->VRP.x, pose->VRP.y, pose->VRP.z);
        pose = pose->next;
    } while (pose != &first);
    v_free_liste(&first);
    return 0;
}
