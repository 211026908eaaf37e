/* A host with GLUT: a click opens the editor, Escape ends. */
#include <stdio.h>
#include <stdlib.h>

#include <GL/freeglut.h>

#include <libvides.h>

static V_KAMERAPAR list;
static int turn;

static void rueck(V_KAMERAPAR *poses, int count)
{
    (void)poses;
    printf("%d poses\n", count);
    fflush(stdout);
}

static void display(void)
{
    glClear(GL_COLOR_BUFFER_BIT);
    glRectf(turn / 200.0f - 1.0f, -0.2f, turn / 200.0f - 0.8f, 0.2f);
    glutSwapBuffers();
}

/* GLUT watches no descriptor: the timer serves the editor. */
static void tick(int unused)
{
    (void)unused;
    v_dispatch();
    turn = (turn + 5) % 300;
    glutPostRedisplay();
    glutTimerFunc(20, tick, 0);
}

static void mouse(int button, int state, int x, int y)
{
    (void)button, (void)x, (void)y;
    if (state == GLUT_DOWN)
        v_haupt(100, 100, 100, 100, &list, 0, NULL, rueck, NULL);
}

static void key(unsigned char character, int x, int y)
{
    (void)x, (void)y;
    if (character == 27)
        exit(0);
}

int main(int argc, char **argv)
{
    list.number = -1; /* no poses yet */
    glutInit(&argc, argv);
    glutInitDisplayMode(GLUT_DOUBLE | GLUT_RGB);
    glutInitWindowSize(360, 120);
    glutCreateWindow("glut");
    glutDisplayFunc(display);
    glutMouseFunc(mouse);
    glutKeyboardFunc(key);
    glutTimerFunc(20, tick, 0);
    glutMainLoop();
    return 0;
}
