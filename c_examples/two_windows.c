/*
 * two_windows: two editors at once, each with its own path, object and list.
 *
 *     cc -o two_windows two_windows.c -lvides -lm
 *
 * Every v_haupt() opens one more window that knows nothing of the others. One
 * function may serve them all: the list that it gets identifies the window.
 */
#include <stdio.h>

#include <libvides.h>

static V_OBJEKT_LIST triangle[4] = {
    {{-0.3f, 0.0f, 0.0f}, 0, 1}, {{0.3f, 0.0f, 0.0f}, 1, 2},
    {{ 0.0f, 0.5f, 0.0f}, 1, 3}, {{-0.3f, 0.0f, 0.0f}, 1, 4}
};
static V_OBJEKT_LIST square[5] = {
    {{-0.3f, 0.0f, -0.3f}, 0, 1}, {{0.3f, 0.0f, -0.3f}, 1, 2}, {{0.3f, 0.0f, 0.3f}, 1, 3},
    {{-0.3f, 0.0f, 0.3f}, 1, 4}, {{-0.3f, 0.0f, -0.3f}, 1, 5}
};
static V_KAMERAPAR above_triangle, above_square;

static void rueck(V_KAMERAPAR *daten, int anzahl)
{
    printf("%s: %d poses\n", daten == &above_triangle ? "triangle" : "square", anzahl);
}

int main(void)
{
    above_triangle.number = above_square.number = -1; /* no poses yet */
    v_haupt(100, 100, 100, 100, &above_triangle, 4, triangle, rueck, NULL);
    v_haupt(250, 100, 100, 100, &above_square, 5, square, rueck, NULL);

    if (v_main_loop() != V_OK) { /* until both are closed */
        fprintf(stderr, "two_windows: %s\n", v_last_error());
        return 1;
    }
    v_free_liste(&above_triangle);
    v_free_liste(&above_square);
    return 0;
}
