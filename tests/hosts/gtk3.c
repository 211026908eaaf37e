/* A host with GTK 3: a click opens the editor, M a dialog of its own, Escape ends. */
#include <stdio.h>

#include <glib-unix.h>
#include <gtk/gtk.h>

#include <libvides.h>

static GtkWidget *window;
static V_KAMERAPAR list;
static int turn;

static void rueck(V_KAMERAPAR *poses, int count)
{
    (void)poses;
    printf("%d poses\n", count);
    fflush(stdout);
}

static gboolean serve(gint fd, GIOCondition condition, gpointer unused)
{
    (void)fd, (void)condition, (void)unused;
    v_dispatch();
    return G_SOURCE_CONTINUE;
}

static gboolean tick(gpointer area)
{
    turn = (turn + 5) % 300;
    gtk_widget_queue_draw(area);
    return G_SOURCE_CONTINUE;
}

static gboolean draw(GtkWidget *area, cairo_t *cairo)
{
    (void)area;
    cairo_rectangle(cairo, turn, 20, 40, 40);
    cairo_fill(cairo);
    return FALSE;
}

static gboolean button(void)
{
    v_haupt(100, 100, 100, 100, &list, 0, NULL, rueck, NULL);
    return TRUE;
}

static gboolean key(GtkWidget *top, GdkEventKey *event)
{
    GtkWidget *dialog;

    if (event->keyval == GDK_KEY_Escape) {
        gtk_widget_destroy(top);
    } else if (event->keyval == GDK_KEY_m) {
        dialog = gtk_message_dialog_new(GTK_WINDOW(top), GTK_DIALOG_MODAL, GTK_MESSAGE_INFO,
                                        GTK_BUTTONS_OK, "A dialog");
        gtk_dialog_run(GTK_DIALOG(dialog)); /* a loop of its own */
        gtk_widget_destroy(dialog);
    }
    return TRUE;
}

int main(int argc, char **argv)
{
    GtkWidget *area;

    gtk_init(&argc, &argv);
    list.number = -1; /* no poses yet */
    window = gtk_window_new(GTK_WINDOW_TOPLEVEL);
    area = gtk_drawing_area_new();
    gtk_window_set_title(GTK_WINDOW(window), "gtk3");
    gtk_window_set_default_size(GTK_WINDOW(window), 360, 120);
    gtk_container_add(GTK_CONTAINER(window), area);
    gtk_widget_add_events(window, GDK_BUTTON_PRESS_MASK);
    g_signal_connect(window, "destroy", G_CALLBACK(gtk_main_quit), NULL);
    g_signal_connect(window, "button-press-event", G_CALLBACK(button), NULL);
    g_signal_connect(window, "key-press-event", G_CALLBACK(key), NULL);
    g_signal_connect(area, "draw", G_CALLBACK(draw), NULL);
    g_signal_connect_swapped(area, "destroy", G_CALLBACK(g_source_remove),
                             GUINT_TO_POINTER(g_timeout_add(40, tick, area)));
    g_unix_fd_add(v_fd(), G_IO_IN, serve, NULL);
    gtk_widget_show_all(window);
    gtk_main();
    return 0;
}
