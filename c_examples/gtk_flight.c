/*
 * gtk_flight: flies the camera path in a window of GTK 4.
 *
 *     cc -o gtk_flight gtk_flight.c $(pkg-config --cflags --libs vides gtk4) -lm
 *
 * The picture follows the editor beside it: what is dragged, scrubbed or played there
 * is seen here at once. Dragging here moves a separate camera around the object; the
 * editor shows it as a ghost and takes it over into the path (Ctrl-Enter). Escape ends.
 */
#include <math.h>

#include <glib-unix.h>
#include <gtk/gtk.h>

#include <libvides.h>

/* What both show: points, and the lines between them. */
static const double xyz[5][3] = {
    {0.3, 0.0, 0.3}, {0.3, 0.0, -0.3}, {-0.3, 0.0, -0.3}, {-0.3, 0.0, 0.3}, {0.0, 0.5, 0.0}
};
static const unsigned lines[16] = {0, 1, 1, 2, 2, 3, 3, 0, 0, 4, 1, 4, 2, 4, 3, 4};
static const V_MESH pyramid = {sizeof pyramid, xyz[0], 5, NULL, lines, 16, NULL, 0};

static V_EDITOR *editor;
static V_POSE shown, own = {{0, 0, 0}, {0, 0, 1}, {0, 1, 0}, 30};
static GtkWidget *window, *area;

/* The camera in the editor has moved: this picture shows the same moment. */
static void on_view(V_EDITOR *of, const V_POSE *pose, double frame, int reason, void *user)
{
    g_autofree char *title = g_strdup_printf("gtk_flight: frame %g", frame);

    (void)of, (void)reason, (void)user;
    shown = *pose;
    gtk_window_set_title(GTK_WINDOW(window), title);
    gtk_widget_queue_draw(area);
}

/* The own camera goes about the object, and stands in the editor as a ghost, which is
 * what "take over the view" takes. */
static void drag(GtkGestureDrag *mouse, double x, double y)
{
    double turn = 0.01 * x, lean = 0.6 + 0.005 * y;

    (void)mouse;
    own.vrp[0] = 1.6 * sin(turn) * cos(lean);
    own.vrp[1] = 1.6 * sin(lean), own.vrp[2] = 1.6 * cos(turn) * cos(lean);
    own.vpn[0] = -own.vrp[0], own.vpn[1] = 0.2 - own.vrp[1], own.vpn[2] = -own.vrp[2];
    v_editor_set_view(editor, &own);
    shown = own;
    gtk_widget_queue_draw(area);
}

static void draw(GtkDrawingArea *unused, cairo_t *cairo, int width, int height, gpointer user)
{
    double m[16], depth, scale, before = 0.0;
    int i;

    (void)unused, (void)user;
    cairo_set_source_rgb(cairo, 1, 1, 1), cairo_paint(cairo), cairo_set_source_rgb(cairo, 0, 0, 0);
    cairo_translate(cairo, width / 2.0, height / 2.0);
    for (i = 0; v_pose_matrix(&shown, V_AXES_OPENGL, 0, m) == V_OK && i < 16; i++, before = depth) {
        const double *p = xyz[lines[i]];

        depth = -(m[2] * p[0] + m[6] * p[1] + m[10] * p[2] + m[14]);
        /* The zoom is a focal length in mm of a camera with a picture 24 mm high. */
        scale = shown.zoom / 24.0 * height / depth;
        (i % 2 == 1 && depth > 0.01 && before > 0.01 ? cairo_line_to : cairo_move_to)(
            cairo, (m[0] * p[0] + m[4] * p[1] + m[8] * p[2] + m[12]) * scale,
            -(m[1] * p[0] + m[5] * p[1] + m[9] * p[2] + m[13]) * scale);
    }
    cairo_stroke(cairo);
}

static gboolean serve(gint fd, GIOCondition condition, gpointer unused)
{
    (void)fd, (void)condition, (void)unused;
    v_dispatch();
    return G_SOURCE_CONTINUE;
}

static void key(GtkEventController *keys, guint value)
{
    if (value == GDK_KEY_Escape)
        gtk_window_close(GTK_WINDOW(gtk_event_controller_get_widget(keys)));
}

static void activate(GtkApplication *application)
{
    GtkGesture *mouse = gtk_gesture_drag_new();
    GtkEventController *keys = gtk_event_controller_key_new();
    V_EDITOR_OPTIONS options;

    window = gtk_application_window_new(application);
    area = gtk_drawing_area_new();
    gtk_window_set_default_size(GTK_WINDOW(window), 480, 320);
    gtk_window_set_child(GTK_WINDOW(window), area);
    gtk_drawing_area_set_draw_func(GTK_DRAWING_AREA(area), draw, NULL, NULL);
    g_signal_connect(mouse, "drag-update", G_CALLBACK(drag), NULL);
    gtk_widget_add_controller(area, GTK_EVENT_CONTROLLER(mouse));
    g_signal_connect(keys, "key-pressed", G_CALLBACK(key), NULL);
    gtk_widget_add_controller(window, keys);
    gtk_window_present(GTK_WINDOW(window));

    v_editor_options_init(&options);
    options.title = options.host_name = "gtk_flight";
    options.object = &pyramid, options.on_view = on_view;
    if (v_editor_open(&options, &editor) != V_OK)
        g_printerr("gtk_flight: %s\n", v_last_error());
    g_unix_fd_add(v_fd(), G_IO_IN, serve, NULL);
    drag(NULL, 60, -40);
}

int main(int argc, char **argv)
{
    GtkApplication *application = gtk_application_new(NULL, G_APPLICATION_NON_UNIQUE);

    g_signal_connect(application, "activate", G_CALLBACK(activate), NULL);
    return g_application_run(G_APPLICATION(application), argc, argv);
}
