/*
 * gtk_embedded: the editor as a part of a window of GTK 3.
 *
 *     cc -o gtk_embedded gtk_embedded.c $(pkg-config --cflags --libs vides gtk+-3.0) -lm
 *
 * The line above the editor shows the camera while the flight is planned.
 * A window of GTK 4 has no part that another could live in.
 */
#include <stdio.h>

#include <glib-unix.h>
#include <gtk/gtk.h>
#include <gtk/gtkx.h>

#include <libvides.h>

static GtkWidget *line;
static V_EDITOR *editor;

static gboolean serve(gint fd, GIOCondition condition, gpointer unused)
{
    (void)fd, (void)condition, (void)unused;
    v_dispatch();
    return G_SOURCE_CONTINUE;
}

/* The camera at the moment that the editor shows. */
static void on_view(V_EDITOR *of, const V_POSE *pose, double frame, int reason, void *user)
{
    char text[200];

    (void)of, (void)user;
    snprintf(text, sizeof text, "Frame %.1f: camera at %.3f  %.3f  %.3f, zoom %.0f mm",
             frame, pose->vrp[0], pose->vrp[1], pose->vrp[2], pose->zoom);
    gtk_label_set_text(GTK_LABEL(line), text);
    if (reason == V_VIEW_RESTED)
        puts(text);
}

static void on_poses(V_EDITOR *of, const V_POSE *poses, size_t count, void *user)
{
    (void)of, (void)poses, (void)user;
    printf("%lu poses\n", (unsigned long)count);
}

/* A field to write into: it has the keyboard until the editor is clicked. */
static void named(GtkEntry *entry)
{
    printf("named %s\n", gtk_entry_get_text(entry));
}

/* GTK does not know that the editor has the keyboard: take it back for the field. */
static gboolean pressed(GtkWidget *entry)
{
    gdk_window_focus(gtk_widget_get_window(gtk_widget_get_toplevel(entry)),
                     gtk_get_current_event_time());
    return FALSE;
}

/* The part's own X window is where the editor lives, as large as that. */
static void realized(GtkWidget *part)
{
    V_EDITOR_OPTIONS options;

    v_editor_options_init(&options);
    gdk_window_ensure_native(gtk_widget_get_window(part));
    options.parent = GDK_WINDOW_XID(gtk_widget_get_window(part));
    gdk_display_sync(gtk_widget_get_display(part)); /* the server must know it by now */
    options.on_view = on_view;
    options.on_poses = on_poses;
    if (v_editor_open(&options, &editor) != V_OK)
        fprintf(stderr, "gtk_embedded: %s\n", v_last_error());
}

/* Before its parent goes. */
static void unrealized(void)
{
    v_editor_close(editor);
    editor = NULL;
}

int main(int argc, char **argv)
{
    GtkWidget *window, *box, *bar, *entry, *part;

    gdk_set_allowed_backends("x11"); /* through Xwayland where there is none */
    gtk_init(&argc, &argv);
    window = gtk_window_new(GTK_WINDOW_TOPLEVEL);
    box = gtk_box_new(GTK_ORIENTATION_VERTICAL, 0);
    bar = gtk_box_new(GTK_ORIENTATION_HORIZONTAL, 12);
    line = gtk_label_new("No camera yet");
    entry = gtk_entry_new();
    part = gtk_drawing_area_new();
    gtk_window_set_title(GTK_WINDOW(window), "gtk_embedded");
    gtk_window_set_default_size(GTK_WINDOW(window), 1200, 800);
    gtk_container_add(GTK_CONTAINER(window), box);
    gtk_container_set_border_width(GTK_CONTAINER(bar), 6);
    gtk_box_pack_start(GTK_BOX(bar), entry, FALSE, FALSE, 0);
    gtk_box_pack_start(GTK_BOX(bar), line, FALSE, FALSE, 0);
    gtk_box_pack_start(GTK_BOX(box), bar, FALSE, FALSE, 0);
    gtk_box_pack_start(GTK_BOX(box), part, TRUE, TRUE, 0);
    g_signal_connect(entry, "activate", G_CALLBACK(named), NULL);
    g_signal_connect(entry, "button-press-event", G_CALLBACK(pressed), NULL);
    g_signal_connect(part, "realize", G_CALLBACK(realized), NULL);
    g_signal_connect(part, "unrealize", G_CALLBACK(unrealized), NULL);
    g_signal_connect(window, "destroy", G_CALLBACK(gtk_main_quit), NULL);
    g_unix_fd_add(v_fd(), G_IO_IN, serve, NULL);
    gtk_widget_show_all(window);
    gtk_main();
    return 0;
}
