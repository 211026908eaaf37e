/*
 * pyramid_motif: a Motif program of 1994 that plans camera flights.
 *
 *     cc -c pyramid_motif.c
 *     cc -o pyramid_motif pyramid_motif.o -lvides -lm -lXm -lXt -lX11
 *
 * Three buttons. "Edit Kurve" opens an editor window, "Hole Werte" looks
 * whether poses have come meanwhile, "Quit" ends the program. The editor needs
 * nothing from this program but its event loop, XtMainLoop().
 *
 * Built as the example in the thesis is (Appendix C): the functions read() and
 * edit() and the variables quit and form keep their names on purpose. They are
 * the program's own, and the library must not fall over them.
 */
#include <stdio.h>
#include <stdlib.h>

#include <Xm/Form.h>
#include <Xm/PushB.h>

#include <libvides.h>

/* The base speeds: how many poses for a way of length 1, and so on. */
#define SPEED 100.0f

Widget form, quit;

/* What the editor is to show: a square and four edges up to the summit. A
 * point whose draw is 0 begins a new line. */
static V_OBJEKT_LIST pyramid[10] = {
    {{ 0.3f, 0.0f,  0.3f}, 1, 1},
    {{ 0.3f, 0.0f, -0.3f}, 1, 2},
    {{-0.3f, 0.0f, -0.3f}, 1, 3},
    {{-0.3f, 0.0f,  0.3f}, 1, 4},
    {{ 0.3f, 0.0f,  0.3f}, 1, 5},
    {{ 0.0f, 0.5f,  0.0f}, 1, 6},
    {{ 0.3f, 0.0f, -0.3f}, 1, 7},
    {{-0.3f, 0.0f, -0.3f}, 0, 8},
    {{ 0.0f, 0.5f,  0.0f}, 1, 9},
    {{-0.3f, 0.0f,  0.3f}, 1, 10}
};

/* The list's first element. The library adds the others. */
static V_KAMERAPAR *list;

static void print_poses(const V_KAMERAPAR *pose, int count)
{
    for (; count > 0; count--) {
        printf("pose %d: at %f %f %f\n", pose->number, pose->VRP.x, pose->VRP.y, pose->VRP.z);
        pose = pose->next;
    }
}

/* The user hands the poses over. */
void rueck(V_KAMERAPAR *daten, int anzahl)
{
    printf("%d poses came\n", anzahl);
    print_poses(daten, anzahl);
}

/* The user closes the editor. 0 would keep it open. */
int ende(void)
{
    printf("the editor asks whether it may close\n");
    return 1;
}

/* The buttons. */

void edit(Widget w, XtPointer client_data, XtPointer call_data)
{
    (void)w, (void)client_data, (void)call_data;
    v_haupt(SPEED, SPEED, SPEED, SPEED, list, 10, pyramid, rueck, ende);
}

/* The other way to the poses: look whether they are there. */
void read(Widget w, XtPointer client_data, XtPointer call_data)
{
    (void)w, (void)client_data, (void)call_data;
    if (list->number < 0)
        printf("no poses yet\n");
    else
        print_poses(list, list->prev->number); /* the last one's number is the count */
}

static void leave(Widget w, XtPointer client_data, XtPointer call_data)
{
    (void)w, (void)client_data, (void)call_data;
    exit(0);
}

/* A button over the whole width, between two heights in percent. */
static Widget button(char *name, int top, int bottom, XtCallbackProc pressed)
{
    Arg args[6];
    int n = 0;
    Widget made;

    XtSetArg(args[n], XmNtopAttachment, XmATTACH_POSITION); n++;
    XtSetArg(args[n], XmNtopPosition, top); n++;
    XtSetArg(args[n], XmNbottomAttachment, XmATTACH_POSITION); n++;
    XtSetArg(args[n], XmNbottomPosition, bottom); n++;
    XtSetArg(args[n], XmNleftAttachment, XmATTACH_FORM); n++;
    XtSetArg(args[n], XmNrightAttachment, XmATTACH_FORM); n++;
    made = XtCreateManagedWidget(name, xmPushButtonWidgetClass, form, args, n);
    XtAddCallback(made, XmNactivateCallback, pressed, NULL);
    return made;
}

int main(int argc, char **argv)
{
    Arg args[2];
    Widget toplevel;

    list = malloc(sizeof *list);
    if (list == NULL)
        return 1;
    list->number = -1; /* no poses yet */

    toplevel = XtInitialize(argv[0], "MainTest", NULL, 0, &argc, argv);
    XtSetArg(args[0], XmNwidth, 100);
    XtSetArg(args[1], XmNheight, 200);
    form = XtCreateManagedWidget("form", xmFormWidgetClass, toplevel, args, 2);
    button("Edit Kurve", 0, 32, edit);
    button("Hole Werte", 33, 65, read);
    quit = button("Quit", 66, 99, leave);

    XtRealizeWidget(toplevel);
    XtMainLoop();
    return 0;
}
