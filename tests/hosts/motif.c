/* A host with Motif: a click opens the editor, M a dialog of its own, Escape ends. For
 * the editor it does nothing. */
#include <stdio.h>
#include <stdlib.h>

#include <X11/keysym.h>
#include <Xm/DrawingA.h>
#include <Xm/MessageB.h>
#include <Xm/Xm.h>

#include <libvides.h>

static XtAppContext context;
static V_KAMERAPAR list;
static int turn, open_dialog;

static void rueck(V_KAMERAPAR *poses, int count)
{
    (void)poses;
    printf("%d poses\n", count);
    fflush(stdout);
}

static void tick(XtPointer area, XtIntervalId *id)
{
    Display *display = XtDisplay((Widget)area);

    (void)id;
    turn = (turn + 5) % 300;
    XClearWindow(display, XtWindow((Widget)area));
    XFillRectangle(display, XtWindow((Widget)area), DefaultGC(display, DefaultScreen(display)),
                   turn, 20, 40, 40);
    XtAppAddTimeOut(context, 40, tick, area);
}

static void answered(Widget dialog, XtPointer data, XtPointer call)
{
    (void)dialog, (void)data, (void)call;
    open_dialog = 0;
}

/* A modal dialog as Motif programs have them: with a loop of its own. */
static void ask(Widget area)
{
    Widget dialog = XmCreateInformationDialog(area, "dialog", NULL, 0);
    XEvent event;

    XtVaSetValues(dialog, XmNdialogStyle, XmDIALOG_FULL_APPLICATION_MODAL, NULL);
    XtAddCallback(dialog, XmNokCallback, answered, NULL);
    XtAddCallback(dialog, XmNcancelCallback, answered, NULL);
    XtManageChild(dialog);
    for (open_dialog = 1; open_dialog;) {
        XtAppNextEvent(context, &event);
        XtDispatchEvent(&event);
    }
    XtDestroyWidget(XtParent(dialog));
}

static void input(Widget area, XtPointer data, XEvent *event, Boolean *further)
{
    KeySym key = event->type == KeyPress ? XLookupKeysym(&event->xkey, 0) : NoSymbol;

    (void)data, (void)further;
    if (event->type == ButtonPress)
        v_haupt(100, 100, 100, 100, &list, 0, NULL, rueck, NULL);
    else if (key == XK_Escape)
        exit(0);
    else if (key == XK_m)
        ask(area);
}

int main(int argc, char **argv)
{
    Widget top = XtAppInitialize(&context, "Motif", NULL, 0, &argc, argv, NULL, NULL, 0);
    Widget area = XtVaCreateManagedWidget("area", xmDrawingAreaWidgetClass, top,
                                          XmNwidth, 360, XmNheight, 120, NULL);

    list.number = -1; /* no poses yet */
    XtAddEventHandler(area, ButtonPressMask | KeyPressMask, False, input, NULL);
    XtVaSetValues(top, XmNtitle, "motif", NULL);
    XtRealizeWidget(top);
    tick(area, NULL);
    XtAppMainLoop(context);
    return 0;
}
