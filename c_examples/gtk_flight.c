/*
 * gtk_flight: flies the camera path in a window of GTK 4.
 *
 *     cc -o gtk_flight gtk_flight.c $(pkg-config --cflags --libs vides gtk4) -lm
 *
 * A click into the window opens an editor. The poses that the user hands over (Alt-U)
 * are played, 25 a second, round and round. Escape ends the program.
 */
#include <stdio.h>

#include <glib-unix.h>
#include <gtk/gtk.h>

#include <libvides.h>

/* What both show: from point to point a line, unless draw is 0. */
static V_OBJEKT_LIST pyramid[10] = {
    {{ 0.3f, 0.0f,  0.3f}, 0, 1}, {{ 0.3f, 0.0f, -0.3f}, 1, 2}, {{-0.3f, 0.0f, -0.3f}, 1, 3},
    {{-0.3f, 0.0f,  0.3f}, 1, 4}, {{ 0.3f, 0.0f,  0.3f}, 1, 5}, {{ 0.0f, 0.5f,  0.0f}, 1, 6},
    {{ 0.3f, 0.0f, -0.3f}, 1, 7}, {{-0.3f, 0.0f, -0.3f}, 0, 8}, {{ 0.0f, 0.5f,  0.0f}, 1, 9},
    {{-0.3f, 0.0f,  0.3f}, 1, 10}
};
static V_KAMERAPAR list;       /* closed to a ring; stays as it is until the next rueck */
static const V_KAMERAPAR *now; /* the pose being shown; NULL before the first hand-over */

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

static void draw(GtkDrawingArea *area, cairo_t *cairo, int width, int height, gpointer unused)
{
    double x, y, from_x = 0.0, from_y = 0.0;
    int i, here, before = 0;

    (void)area, (void)unused;
    cairo_translate(cairo, width / 2.0, height / 2.0);
    for (i = 0; now != NULL && i < 10; i++) {
        here = seen(now, &pyramid[i].pos, &x, &y);
        if (here && before && pyramid[i].draw) {
            cairo_move_to(cairo, from_x * height / 2, from_y * height / 2);
            cairo_line_to(cairo, x * height / 2, y * height / 2);
        }
        before = here, from_x = x, from_y = y;
    }
    cairo_stroke(cairo);
}

static gboolean tick(gpointer area)
{
    now = now != NULL ? now->next : NULL;
    gtk_widget_queue_draw(area);
    return G_SOURCE_CONTINUE;
}

static gboolean serve(gint fd, GIOCondition condition, gpointer unused)
{
    (void)fd, (void)condition, (void)unused;
    v_dispatch();
    return G_SOURCE_CONTINUE;
}

static void edit(void)
{
    v_haupt(100, 100, 100, 100, &list, 10, pyramid, rueck, NULL);
}

static void key(GtkEventController *keys, guint value)
{
    if (value == GDK_KEY_Escape)
        gtk_window_close(GTK_WINDOW(gtk_event_controller_get_widget(keys)));
}

static void activate(GtkApplication *application)
{
    GtkWidget *window = gtk_application_window_new(application);
    GtkWidget *area = gtk_drawing_area_new();
    GtkGesture *click = gtk_gesture_click_new();
    GtkEventController *keys = gtk_event_controller_key_new();
    guint timer;

    gtk_window_set_title(GTK_WINDOW(window), "gtk_flight");
    gtk_window_set_default_size(GTK_WINDOW(window), 480, 320);
    gtk_window_set_child(GTK_WINDOW(window), area);
    gtk_drawing_area_set_draw_func(GTK_DRAWING_AREA(area), draw, NULL, NULL);
    g_signal_connect(click, "pressed", G_CALLBACK(edit), NULL);
    gtk_widget_add_controller(area, GTK_EVENT_CONTROLLER(click));
    g_signal_connect(keys, "key-pressed", G_CALLBACK(key), NULL);
    gtk_widget_add_controller(window, keys);
    timer = g_timeout_add(40, tick, area); /* milliseconds */
    g_signal_connect_swapped(area, "destroy", G_CALLBACK(g_source_remove), GUINT_TO_POINTER(timer));
    g_unix_fd_add(v_fd(), G_IO_IN, serve, NULL); /* all that it needs */
    gtk_window_present(GTK_WINDOW(window));
}

int main(int argc, char **argv)
{
    GtkApplication *application = gtk_application_new(NULL, G_APPLICATION_NON_UNIQUE);

    list.number = -1; /* no poses yet */
    g_signal_connect(application, "activate", G_CALLBACK(activate), NULL);
    return g_application_run(G_APPLICATION(application), argc, argv);
}
