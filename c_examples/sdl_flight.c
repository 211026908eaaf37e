/*
 * sdl_flight: flies the camera path in a window of SDL 2.
 *
 *     cc -o sdl_flight sdl_flight.c $(pkg-config --cflags --libs vides sdl2) -lm
 *
 * A click into the window opens an editor. The poses that the user hands over (Alt-U)
 * are played, 25 a second, round and round. Escape ends the program.
 */
#include <stdio.h>

#include <SDL.h>

#include <libvides.h>

#define FRAME 40 /* milliseconds */
#define WIDTH 480
#define HEIGHT 320

/* What both show: from point to point a line, unless draw is 0. */
static V_OBJEKT_LIST pyramid[10] = {
    {{ 0.3f, 0.0f,  0.3f}, 0, 1}, {{ 0.3f, 0.0f, -0.3f}, 1, 2}, {{-0.3f, 0.0f, -0.3f}, 1, 3},
    {{-0.3f, 0.0f,  0.3f}, 1, 4}, {{ 0.3f, 0.0f,  0.3f}, 1, 5}, {{ 0.0f, 0.5f,  0.0f}, 1, 6},
    {{ 0.3f, 0.0f, -0.3f}, 1, 7}, {{-0.3f, 0.0f, -0.3f}, 0, 8}, {{ 0.0f, 0.5f,  0.0f}, 1, 9},
    {{-0.3f, 0.0f,  0.3f}, 1, 10}
};
static V_KAMERAPAR list;       /* closed to a ring by the library */
static const V_KAMERAPAR *now; /* the pose being shown; NULL before the first hand-over */

/* The list stays as it is until the next call. */
static void rueck(V_KAMERAPAR *poses, int count)
{
    now = poses;
    printf("%d poses\n", count);
    fflush(stdout);
}

/* Where a camera sees a point: right and down from the picture's middle, in half
 * heights of the picture; 0 if behind the camera. The zoom is a focal length in mm
 * of a camera with a picture 24 mm high. */
static int seen(const V_KAMERAPAR *pose, const V_PUNKT *point, double *x, double *y)
{
    const V_POS *d = &pose->VPN, *u = &pose->VUP;
    double px = point->x - pose->VRP.x, py = point->y - pose->VRP.y, pz = point->z - pose->VRP.z;
    double depth = (px * d->x + py * d->y + pz * d->z) * 12.0 / pose->zoom;

    *x = (px * (d->y * u->z - d->z * u->y) + py * (d->z * u->x - d->x * u->z)
          + pz * (d->x * u->y - d->y * u->x)) / depth;
    *y = -(px * u->x + py * u->y + pz * u->z) / depth;
    return depth > 0.01;
}

static void draw(SDL_Renderer *renderer)
{
    double x, y, from_x = 0.0, from_y = 0.0;
    int i, here, before = 0;

    SDL_SetRenderDrawColor(renderer, 255, 255, 255, 255);
    SDL_RenderClear(renderer);
    SDL_SetRenderDrawColor(renderer, 0, 0, 0, 255);
    for (i = 0; now != NULL && i < 10; i++) {
        here = seen(now, &pyramid[i].pos, &x, &y);
        x = (WIDTH + x * HEIGHT) / 2;
        y = (HEIGHT + y * HEIGHT) / 2;
        if (here && before && pyramid[i].draw)
            SDL_RenderDrawLine(renderer, (int)from_x, (int)from_y, (int)x, (int)y);
        before = here, from_x = x, from_y = y;
    }
    SDL_RenderPresent(renderer);
}

/* What the user has done; 0 when the program is to end. */
static int own_events(void)
{
    SDL_Event event;

    while (SDL_PollEvent(&event)) {
        if (event.type == SDL_MOUSEBUTTONDOWN)
            v_haupt(100, 100, 100, 100, &list, 10, pyramid, rueck, NULL);
        else if (event.type == SDL_QUIT
                 || (event.type == SDL_KEYDOWN && event.key.keysym.sym == SDLK_ESCAPE))
            return 0;
    }
    return 1;
}

int main(int argc, char **argv)
{
    SDL_Window *window;
    SDL_Renderer *renderer;

    (void)argc, (void)argv;
    if (SDL_Init(SDL_INIT_VIDEO) != 0
        || SDL_CreateWindowAndRenderer(WIDTH, HEIGHT, 0, &window, &renderer) != 0) {
        fprintf(stderr, "sdl_flight: %s\n", SDL_GetError());
        return 1;
    }
    SDL_SetWindowTitle(window, "sdl_flight");
    list.number = -1; /* no poses yet */
    while (own_events()) {
        v_dispatch(); /* between two frames; never waits */
        draw(renderer);
        if (now != NULL)
            now = now->next;
        SDL_Delay(FRAME);
    }
    SDL_Quit();
    v_free_liste(&list);
    return 0;
}
