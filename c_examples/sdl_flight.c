/*
 * sdl_flight: flies the camera path in a window of SDL 2.
 *
 *     cc -o sdl_flight sdl_flight.c $(pkg-config --cflags --libs vides sdl2) -lm
 *
 * The picture follows the editor beside it: what is dragged, scrubbed or played there
 * is seen here at once. Dragging here moves a separate camera around the object; the
 * editor shows it as a ghost and takes it over into the path (Ctrl-Enter). Escape ends.
 */
#include <math.h>
#include <stdio.h>

#include <SDL.h>

#include <libvides.h>

#define WIDTH 480
#define HEIGHT 320

/* What both show: points, and the lines between them. */
static const double xyz[5][3] = {
    {0.3, 0.0, 0.3}, {0.3, 0.0, -0.3}, {-0.3, 0.0, -0.3}, {-0.3, 0.0, 0.3}, {0.0, 0.5, 0.0}
};
static const unsigned lines[16] = {0, 1, 1, 2, 2, 3, 3, 0, 0, 4, 1, 4, 2, 4, 3, 4};
static const V_MESH pyramid = {sizeof pyramid, xyz[0], 5, NULL, lines, 16, NULL, 0};

static V_EDITOR *editor;
static V_POSE shown, own = {{0, 0, 0}, {0, 0, 1}, {0, 1, 0}, 30};
static SDL_Window *window;

/* The camera in the editor has moved: the next picture shows the same moment. */
static void on_view(V_EDITOR *of, const V_POSE *pose, double frame, int reason, void *user)
{
    char title[40];

    (void)of, (void)reason, (void)user;
    shown = *pose;
    snprintf(title, sizeof title, "sdl_flight: frame %g", frame);
    SDL_SetWindowTitle(window, title);
}

/* The own camera goes about the object, and stands in the editor as a ghost, which is
 * what "take over the view" takes. */
static void drag(double turn, double lean)
{
    own.vrp[0] = 1.6 * sin(turn) * cos(lean);
    own.vrp[1] = 1.6 * sin(lean), own.vrp[2] = 1.6 * cos(turn) * cos(lean);
    own.vpn[0] = -own.vrp[0], own.vpn[1] = 0.2 - own.vrp[1], own.vpn[2] = -own.vrp[2];
    v_editor_set_view(editor, &own);
    shown = own;
}

static void draw(SDL_Renderer *renderer)
{
    double m[16], scale;
    SDL_FPoint to, from = {0, 0};
    int i, here, before = 0;

    SDL_SetRenderDrawColor(renderer, 255, 255, 255, 255);
    SDL_RenderClear(renderer);
    SDL_SetRenderDrawColor(renderer, 0, 0, 0, 255);
    for (i = 0; v_pose_matrix(&shown, V_AXES_OPENGL, 0, m) == V_OK && i < 16; i++, before = here, from = to) {
        const double *p = xyz[lines[i]];
        double depth = -(m[2] * p[0] + m[6] * p[1] + m[10] * p[2] + m[14]);

        here = depth > 0.01;
        /* The zoom is a focal length in mm of a camera with a picture 24 mm high. */
        scale = shown.zoom / 24.0 * HEIGHT / depth;
        to.x = WIDTH / 2 + (m[0] * p[0] + m[4] * p[1] + m[8] * p[2] + m[12]) * scale;
        to.y = HEIGHT / 2 - (m[1] * p[0] + m[5] * p[1] + m[9] * p[2] + m[13]) * scale;
        if (i % 2 == 1 && here && before)
            SDL_RenderDrawLineF(renderer, from.x, from.y, to.x, to.y);
    }
    SDL_RenderPresent(renderer);
}

/* What the user has done; 0 when the program is to end. */
static int own_events(void)
{
    SDL_Event event;

    while (SDL_PollEvent(&event)) {
        if (event.type == SDL_MOUSEMOTION && event.motion.state != 0)
            drag(0.01 * event.motion.x, 0.005 * event.motion.y);
        else if (event.type == SDL_QUIT
                 || (event.type == SDL_KEYDOWN && event.key.keysym.sym == SDLK_ESCAPE))
            return 0;
    }
    return 1;
}

int main(int argc, char **argv)
{
    V_EDITOR_OPTIONS options;
    SDL_Renderer *renderer;

    (void)argc, (void)argv;
    if (SDL_Init(SDL_INIT_VIDEO) != 0
        || SDL_CreateWindowAndRenderer(WIDTH, HEIGHT, 0, &window, &renderer) != 0)
        return fprintf(stderr, "sdl_flight: %s\n", SDL_GetError()), 1;
    v_editor_options_init(&options);
    options.title = options.host_name = "sdl_flight";
    options.object = &pyramid;
    options.on_view = on_view;
    if (v_editor_open(&options, &editor) != V_OK)
        return fprintf(stderr, "sdl_flight: %s\n", v_last_error()), 1;
    drag(0.6, 0.4);
    while (own_events()) {
        v_dispatch(); /* between two frames; never waits */
        draw(renderer);
        SDL_Delay(16); /* milliseconds */
    }
    SDL_Quit();
    return 0;
}
