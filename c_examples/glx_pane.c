/*
 * glx_pane: what the camera sees, drawn by the host itself in the editor's window.
 *
 *     cc -o glx_pane glx_pane.c -lvides -lm -lX11 -lGL
 *
 * The editor gives its camera pane, and the camera at every moment; this program draws in
 * its own window in that pane, by OpenGL. It ends with the editor.
 */
#include <poll.h>
#include <stdio.h>

#include <GL/gl.h>
#include <GL/glx.h>
#include <X11/Xlib.h>

#include <libvides.h>

static const double xyz[5][3] = { /* what both show: points, and triangles between them */
    {0.3, 0.0, 0.3}, {0.3, 0.0, -0.3}, {-0.3, 0.0, -0.3}, {-0.3, 0.0, 0.3}, {0.0, 0.5, 0.0}
};
static const unsigned corners[18] = {0, 1, 4, 1, 2, 4, 2, 3, 4, 3, 0, 4, 0, 2, 1, 0, 3, 2};
static const V_MESH pyramid = {sizeof pyramid, xyz[0], 5, NULL, NULL, 0, corners, 18};

static Display *display;
static XVisualInfo *visual;
static GLXContext context;
static Window child; /* in the pane; None if that is closed */
static int width, height;
static V_POSE camera;

static void draw(void)
{
    double matrix[16], projection[16];
    int i;

    if (child == None)
        return;
    glXMakeCurrent(display, child, context);
    glViewport(0, 0, width, height);
    glClearColor(0.1f, 0.1f, 0.15f, 1.0f), glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    if (v_pose_matrix(&camera, V_AXES_OPENGL, 0, matrix) == V_OK) { /* otherwise no camera has arrived yet */
        glEnable(GL_DEPTH_TEST);
        v_pose_projection(&camera, (double)width / height, 0.01, 10.0, V_CLIP_OPENGL, projection);
        glMatrixMode(GL_PROJECTION), glLoadMatrixd(projection);
        glMatrixMode(GL_MODELVIEW);
        glLoadMatrixd(matrix);
        glBegin(GL_TRIANGLES);
        for (i = 0; i < 18; i++) {
            glColor3d(0.9 - i / 3 * 0.1, 0.5 - i / 3 * 0.05, 0.2);
            glVertex3dv(xyz[corners[i]]);
        }
        glEnd();
    }
    glXSwapBuffers(display, child);
}

/* The camera at the moment that the editor shows. */
static void on_view(V_EDITOR *editor, const V_POSE *pose, double frame, int reason, void *user)
{
    (void)editor, (void)frame, (void)reason, (void)user;
    camera = *pose;
    draw();
}

/* The pane opened, changed its size, which its child then has, or closed. */
static void on_pane(V_EDITOR *editor, unsigned long window, int w, int h, void *user)
{
    XSetWindowAttributes own;

    (void)editor, (void)user;
    width = w, height = h;
    if (window != 0 && child == None) {
        own.border_pixel = 0;
        own.event_mask = ExposureMask;
        own.colormap = XCreateColormap(display, window, visual->visual, AllocNone);
        child = XCreateWindow(display, window, 0, 0, 1, 1, 0, visual->depth, InputOutput,
                              visual->visual, CWBorderPixel | CWColormap | CWEventMask, &own);
        XMapWindow(display, child);
    } else if (window == 0 && child != None) {
        glXMakeCurrent(display, None, NULL);
        XDestroyWindow(display, child);
        child = None;
    }
    draw();
}

int main(void)
{
    static int kind[] = {GLX_RGBA, GLX_DOUBLEBUFFER, GLX_DEPTH_SIZE, 16, None};
    struct pollfd from[2] = {{0, POLLIN, 0}, {0, POLLIN, 0}};
    V_EDITOR_OPTIONS options;
    V_EDITOR *editor;
    XEvent event;

    display = XOpenDisplay(NULL);
    visual = display == NULL ? NULL : glXChooseVisual(display, DefaultScreen(display), kind);
    if (visual == NULL)
        return 1;
    context = glXCreateContext(display, visual, NULL, True);
    v_editor_options_init(&options);
    options.title = "glx_pane";
    options.object = &pyramid;
    options.on_view = on_view, options.on_pane = on_pane;
    if (v_editor_open(&options, &editor) != V_OK)
        return fprintf(stderr, "glx_pane: %s\n", v_last_error()), 1;
    from[0].fd = ConnectionNumber(display), from[1].fd = v_fd();
    while (v_dispatch() > 0) {
        while (XPending(display) > 0) {
            XNextEvent(display, &event);
            if (event.type == Expose && event.xexpose.count == 0)
                draw();
        }
        poll(from, 2, -1);
    }
    v_editor_close(editor);
    return 0;
}
