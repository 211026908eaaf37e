/*
 * glut_flight: flies the camera path through a scene drawn with OpenGL.
 *
 *     cc -o glut_flight glut_flight.c -lvides -lm -lglut -lGL
 *
 * The editor stands beside the picture. Whenever the user hands the poses over
 * (Alt-U), the flight plays from the beginning, 25 poses a second, round and
 * round. Escape ends the program.
 */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <GL/freeglut.h>

#include <libvides.h>

#define FRAME 40 /* milliseconds */

/* What both show: points, and the lines between them. */
static const double xyz[5][3] = {
    {0.3, 0.0, 0.3}, {0.3, 0.0, -0.3}, {-0.3, 0.0, -0.3}, {-0.3, 0.0, 0.3}, {0.0, 0.5, 0.0}
};
static const unsigned lines[16] = {0, 1, 1, 2, 2, 3, 3, 0, 0, 4, 1, 4, 2, 4, 3, 4};
static const V_MESH pyramid = {sizeof pyramid, xyz[0], 5, NULL, lines, 16, NULL, 0};
static V_POSE *flight;     /* a copy of what was handed over */
static size_t poses, now;

/* The poses are the library's and go when this returns: copy them. */
static void on_poses(V_EDITOR *editor, const V_POSE *handed_over, size_t count, void *user)
{
    V_POSE *copy = malloc(count * sizeof *copy);

    (void)editor, (void)user;
    if (copy == NULL)
        return;
    memcpy(copy, handed_over, count * sizeof *copy);
    free(flight);
    flight = copy;
    poses = count;
    now = 0;
}

static void display(void)
{
    double matrix[16], slope, aspect;
    int i;

    glClear(GL_COLOR_BUFFER_BIT);
    if (poses > 0 && v_pose_gl_matrix(&flight[now], matrix) == V_OK) {
        /* The zoom is the focal length, in mm, of a camera with a picture of
         * 36 x 24 mm: half the picture's height, seen from there, gives the
         * vertical field of view, 2 atan (12 / zoom). */
        slope = 12.0 / flight[now].zoom;
        aspect = (double)glutGet(GLUT_WINDOW_WIDTH) / glutGet(GLUT_WINDOW_HEIGHT);
        glMatrixMode(GL_PROJECTION);
        glLoadIdentity();
        glFrustum(-0.01 * slope * aspect, 0.01 * slope * aspect, -0.01 * slope, 0.01 * slope,
                  0.01, 10.0);
        glMatrixMode(GL_MODELVIEW);
        glLoadMatrixd(matrix);
        glBegin(GL_LINES);
        for (i = 0; i < 16; i++)
            glVertex3dv(xyz[lines[i]]);
        glEnd();
    }
    glutSwapBuffers();
}

/* GLUT cannot watch a descriptor, so the timer that moves the flight on looks
 * after the editor, too. */
static void tick(int unused)
{
    (void)unused;
    v_dispatch();
    if (poses > 0) {
        now = (now + 1) % poses;
        glutPostRedisplay();
    }
    glutTimerFunc(FRAME, tick, 0);
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
    V_EDITOR *editor;

    glutInit(&argc, argv);
    glutInitDisplayMode(GLUT_DOUBLE | GLUT_RGB);
    glutInitWindowSize(600, 400);
    glutCreateWindow("glut_flight");
    glutDisplayFunc(display);
    glutKeyboardFunc(key);

    v_editor_options_init(&options);
    options.title = "glut_flight";
    options.object = &pyramid;
    options.on_poses = on_poses;
    if (argc > 1)
        options.file = argv[1];
    if (v_editor_open(&options, &editor) != V_OK) {
        fprintf(stderr, "glut_flight: %s\n", v_last_error());
        return 1;
    }
    glutTimerFunc(FRAME, tick, 0);
    glutMainLoop();
    return 0;
}
