/*
 * glut_flight: flies the camera path through a scene drawn with OpenGL.
 *
 *     cc -o glut_flight glut_flight.c -lvides -lm -lglut -lGL
 *
 * The picture follows the editor beside it: what is dragged, scrubbed or played there
 * is seen here at once. Dragging here moves a separate camera around the object; the
 * editor shows it as a ghost and takes it over into the path (Ctrl-Enter). Escape ends.
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#define GL_GLEXT_PROTOTYPES
#include <GL/freeglut.h>

#include <libvides.h>

/* What both show: points, and the lines between them. */
static const double xyz[5][3] = {
    {0.3, 0.0, 0.3}, {0.3, 0.0, -0.3}, {-0.3, 0.0, -0.3}, {-0.3, 0.0, 0.3}, {0.0, 0.5, 0.0}
};
static const unsigned lines[16] = {0, 1, 1, 2, 2, 3, 3, 0, 0, 4, 1, 4, 2, 4, 3, 4};
static const V_MESH pyramid = {sizeof pyramid, xyz[0], 5, NULL, lines, 16, NULL, 0};

static V_EDITOR *editor;
static V_POSE shown, own = {{0, 0, 0}, {0, 0, 1}, {0, 1, 0}, 30};
static char caption[40];

/* The camera in the editor has moved: this picture shows the same moment. */
static void on_view(V_EDITOR *of, const V_POSE *pose, double at, int reason, void *user)
{
    (void)of, (void)reason, (void)user;
    sprintf(caption, "frame %g", at);
    shown = *pose;
    glutPostRedisplay();
}

/* "Take over the view". */
static int on_capture(V_EDITOR *of, V_POSE *pose, void *user)
{
    (void)of, (void)user;
    *pose = own;
    return 1;
}

static void show_own(void)
{
    shown = own;
    sprintf(caption, "own view");
    glutPostRedisplay();
}

/* The editor has gone, whoever ended it. */
static void on_gone(V_EDITOR *of, int reason, void *user)
{
    (void)of, (void)reason, (void)user;
    show_own();
}

/* The own camera goes about the object, and stands in the editor as a ghost. Its vectors
 * may have any length; up is made perpendicular to the view. */
static void drag(int x, int y)
{
    double turn = 0.01 * x, lean = 0.005 * y;

    own.vrp[0] = 1.6 * sin(turn) * cos(lean);
    own.vrp[1] = 1.6 * sin(lean), own.vrp[2] = 1.6 * cos(turn) * cos(lean);
    own.vpn[0] = -own.vrp[0], own.vpn[1] = 0.2 - own.vrp[1], own.vpn[2] = -own.vrp[2];
    v_editor_set_view(editor, &own);
    show_own();
}

static void display(void)
{
    double matrix[16], projection[16];
    double aspect = (double)glutGet(GLUT_WINDOW_WIDTH) / glutGet(GLUT_WINDOW_HEIGHT);
    int i;

    glClear(GL_COLOR_BUFFER_BIT);
    if (v_pose_projection(&shown, aspect, 0.01, 10.0, V_CLIP_OPENGL, projection) == V_OK)
        glMatrixMode(GL_PROJECTION), glLoadMatrixd(projection);
    glMatrixMode(GL_MODELVIEW);
    if (v_pose_matrix(&shown, V_AXES_OPENGL, 0, matrix) == V_OK)
        glLoadMatrixd(matrix);
    glBegin(GL_LINES);
    for (i = 0; i < 16; i++)
        glVertex3dv(xyz[lines[i]]);
    glEnd();
    glWindowPos2i(10, 10);
    glutBitmapString(GLUT_BITMAP_HELVETICA_18, (const unsigned char *)caption);
    glutSwapBuffers();
}

/* GLUT watches no descriptor: a timer serves the editor. */
static void tick(int unused)
{
    v_dispatch();
    glutTimerFunc(8, tick, unused);
}

static void key(unsigned char character, int x, int y)
{
    (void)x, (void)y;
    if (character == 27)
        exit(0);
}

int main(int argc, char **argv)
{
    V_EDITOR_OPTIONS options;

    glutInit(&argc, argv);
    glutInitDisplayMode(GLUT_DOUBLE | GLUT_RGB);
    glutInitWindowSize(600, 400);
    glutCreateWindow("glut_flight");
    glutDisplayFunc(display), glutKeyboardFunc(key), glutMotionFunc(drag);

    v_editor_options_init(&options);
    options.title = options.host_name = "glut_flight";
    options.object = &pyramid;
    options.on_view = on_view, options.on_capture = on_capture;
    options.on_gone = on_gone;
    options.file = argc > 1 ? argv[1] : NULL;
    if (v_editor_open(&options, &editor) != V_OK)
        return fprintf(stderr, "glut_flight: %s\n", v_last_error()), 1;
    drag(60, 70);
    glutTimerFunc(8 /* milliseconds */, tick, 0);
    glutMainLoop();
    return 0;
}
