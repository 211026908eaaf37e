/*
 * motif_flight: a Motif program that turns its object before a camera that stands still,
 * as many viewers do, and flies along nevertheless.
 *
 *     cc -o motif_flight motif_flight.c -lvides -lm -lXm -lXt -lX11
 *
 *     motif_flight             the editor has its own window
 *     motif_flight embedded    the editor is a part of this program's window
 *
 * Opening the editor leaves the picture as it is: the path begins with its view. Dragging
 * turns the object; the editor takes that view over into the path (Ctrl-Enter). Escape ends.
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <X11/keysym.h>
#include <Xm/DrawingA.h>
#include <Xm/Form.h>

#include <libvides.h>

/* How far before the camera the object's zero is at first: glTranslated (0, 0, -DISTANCE). */
#define DISTANCE 2.0

static const double xyz[5][3] = {
    {0.3, 0.0, 0.3}, {0.3, 0.0, -0.3}, {-0.3, 0.0, -0.3}, {-0.3, 0.0, 0.3}, {0.0, 0.5, 0.0}
};
static const unsigned lines[16] = {0, 1, 1, 2, 2, 3, 3, 0, 0, 4, 1, 4, 2, 4, 3, 4};
static const V_MESH pyramid = {sizeof pyramid, xyz[0], 5, NULL, lines, 16, NULL, 0};

/* What turns and moves the object, by columns; the camera adds the distance to it. */
static double object[16] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
static double zoom = 24;
static int drag_x, drag_y;
static char title[40] = "motif_flight";
static Widget top, picture;
static V_EDITOR *editor;

static void draw(void)
{
    Display *display = XtDisplay(picture);
    GC context = DefaultGC(display, DefaultScreen(display));
    Dimension width, height;
    short at[5][2];
    int point, line, row;

    if (!XtIsRealized(picture))
        return;
    XtVaGetValues(picture, XmNwidth, &width, XmNheight, &height, NULL);
    for (point = 0; point < 5; point++) {
        double seen[3], scale;
        for (row = 0; row < 3; row++)
            seen[row] = object[row] * xyz[point][0] + object[4 + row] * xyz[point][1]
                + object[8 + row] * xyz[point][2] + object[12 + row];
        seen[2] -= DISTANCE;
        scale = zoom / 24 * height / (seen[2] < -0.01 ? -seen[2] : 0.01);
        at[point][0] = (short)(width / 2.0 + scale * seen[0]);
        at[point][1] = (short)(height / 2.0 - scale * seen[1]);
    }
    XClearWindow(display, XtWindow(picture));
    for (line = 0; line < 16; line += 2)
        XDrawLine(display, XtWindow(picture), context, at[lines[line]][0], at[lines[line]][1],
                  at[lines[line + 1]][0], at[lines[line + 1]][1]);
    XtVaSetValues(top, XmNtitle, title, NULL);
}

/* The editor's camera has moved: what the own camera adds is taken out of its matrix. */
static void on_view(V_EDITOR *of, const V_POSE *pose, double at, int reason, void *user)
{
    double seen[16];

    (void)of, (void)reason, (void)user;
    if (v_pose_matrix(pose, V_AXES_OPENGL, 0, seen) != V_OK)
        return;
    memcpy(object, seen, sizeof object);
    object[14] += DISTANCE;
    zoom = pose->zoom;
    sprintf(title, "motif_flight: frame %g", at);
    draw();
}

/* "Take over the view": the camera of which the object is seen so. */
static int on_capture(V_EDITOR *of, V_POSE *pose, void *user)
{
    double seen[16];

    (void)of, (void)user;
    memcpy(seen, object, sizeof seen);
    seen[14] -= DISTANCE;
    return v_pose_from_matrix(seen, V_AXES_OPENGL, 0, zoom, pose) == V_OK;
}

/* Turns about the axes of the picture through the object's zero. */
static void turn(double about_x, double about_y)
{
    V_POSE pose;
    int column;

    for (column = 0; column < 12; column += 4) {
        double *v = object + column, x, y, z;
        x = cos(about_y) * v[0] + sin(about_y) * v[2];
        z = cos(about_y) * v[2] - sin(about_y) * v[0];
        y = cos(about_x) * v[1] - sin(about_x) * z;
        v[2] = sin(about_x) * v[1] + cos(about_x) * z;
        v[0] = x, v[1] = y;
    }
    strcpy(title, "motif_flight: own view");
    draw();
    if (on_capture(editor, &pose, NULL))
        v_editor_set_view(editor, &pose);
}

static void input(Widget widget, XtPointer data, XEvent *event, Boolean *further)
{
    (void)widget, (void)data, (void)further;
    if (event->type == Expose) {
        draw();
    } else if (event->type == KeyPress) {
        if (XLookupKeysym(&event->xkey, 0) == XK_Escape)
            exit(0);
    } else if (event->type == ButtonPress) {
        drag_x = event->xbutton.x, drag_y = event->xbutton.y;
    } else if (event->type == MotionNotify) {
        turn(0.01 * (event->xmotion.y - drag_y), 0.01 * (event->xmotion.x - drag_x));
        drag_x = event->xmotion.x, drag_y = event->xmotion.y;
    }
}

/* Opens the editor: in its own window, or in a widget made for it. */
static int open_editor(Widget part)
{
    V_EDITOR_OPTIONS options;
    V_POSE view;

    v_editor_options_init(&options);
    options.title = options.host_name = "motif_flight";
    options.object = &pyramid;
    options.space_half_size = 3; /* room for the camera, about the object */
    options.on_view = on_view, options.on_capture = on_capture;
    if (on_capture(NULL, &view, NULL))
        options.view = &view;
    if (part != NULL) {
        XtMapWidget(part); /* a widget that was made unmapped is seen only now */
        options.parent = XtWindow(part);
        XSync(XtDisplay(part), False); /* the server must know the window by now */
    }
    return v_editor_open(&options, &editor);
}

int main(int argc, char **argv)
{
    XtAppContext context;
    Widget form, part = NULL;

    top = XtAppInitialize(&context, "Motif_flight", NULL, 0, &argc, argv, NULL, NULL, 0);
    form = XtVaCreateManagedWidget("form", xmFormWidgetClass, top, NULL);
    picture = XtVaCreateManagedWidget("picture", xmDrawingAreaWidgetClass, form, XmNwidth, 400,
                                      XmNheight, 300, XmNtopAttachment, XmATTACH_FORM,
                                      XmNbottomAttachment, XmATTACH_FORM, XmNleftAttachment,
                                      XmATTACH_FORM, NULL);
    if (argc > 1 && strcmp(argv[1], "embedded") == 0)
        part = XtVaCreateManagedWidget("part", xmDrawingAreaWidgetClass, form, XmNwidth, 1000,
                                       XmNheight, 800, XmNtopAttachment, XmATTACH_FORM,
                                       XmNbottomAttachment, XmATTACH_FORM, XmNrightAttachment,
                                       XmATTACH_FORM, XmNleftAttachment, XmATTACH_WIDGET,
                                       XmNleftWidget, picture, XmNmappedWhenManaged, False,
                                       NULL);
    else
        XtVaSetValues(picture, XmNrightAttachment, XmATTACH_FORM, NULL);
    XtAddEventHandler(picture, ExposureMask | ButtonPressMask | Button1MotionMask | KeyPressMask,
                      False, input, NULL);
    XtVaSetValues(top, XmNtitle, title, NULL);
    XtRealizeWidget(top);
    if (open_editor(part) != V_OK) {
        fprintf(stderr, "motif_flight: %s\n", v_last_error());
        return 1;
    }
    XtAppMainLoop(context);
    return 0;
}
