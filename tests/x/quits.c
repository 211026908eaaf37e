/*
 * A Motif host with three buttons: Edit opens an editor, Press says that it was pressed,
 * Quit ends the program unless a user wants to keep an editor open.
 */
#include <stdio.h>
#include <stdlib.h>

#include <Xm/Form.h>
#include <Xm/Protocols.h>
#include <Xm/PushB.h>

#include <libvides.h>

static Widget form;

static void edit(Widget w, XtPointer client_data, XtPointer call_data)
{
    (void)w, (void)client_data, (void)call_data;
    v_haupt(100, 100, 100, 100, NULL, 0, NULL, NULL, NULL);
}

static void press(Widget w, XtPointer client_data, XtPointer call_data)
{
    static int times;

    (void)w, (void)client_data, (void)call_data;
    printf("pressed %d\n", ++times);
}

static void leave(Widget w, XtPointer client_data, XtPointer call_data)
{
    int status;

    (void)w, (void)client_data, (void)call_data;
    status = v_editors_close(1);
    if (status == V_OK)
        exit(0);
    if (status == V_ERR_REFUSED)
        printf("it stays\n");
}

static void button(char *name, int top, int bottom, XtCallbackProc pressed)
{
    Widget made = XtVaCreateManagedWidget(
        name, xmPushButtonWidgetClass, form, XmNtopAttachment, XmATTACH_POSITION,
        XmNtopPosition, top, XmNbottomAttachment, XmATTACH_POSITION, XmNbottomPosition, bottom,
        XmNleftAttachment, XmATTACH_FORM, XmNrightAttachment, XmATTACH_FORM, (char *)NULL);
    XtAddCallback(made, XmNactivateCallback, pressed, NULL);
}

int main(int argc, char **argv)
{
    XtAppContext context;
    Widget toplevel = XtVaAppInitialize(&context, "Quits", NULL, 0, &argc, argv, NULL, XmNwidth,
                                        100, XmNheight, 200, (char *)NULL);

    XtVaSetValues(toplevel, XmNdeleteResponse, XmDO_NOTHING, (char *)NULL);
    XmAddWMProtocolCallback(toplevel, XInternAtom(XtDisplay(toplevel), "WM_DELETE_WINDOW", False),
                            leave, NULL);
    form = XtVaCreateManagedWidget("form", xmFormWidgetClass, toplevel, (char *)NULL);
    button("Edit", 0, 33, edit);
    button("Press", 33, 67, press);
    button("Quit", 67, 100, leave);
    XtRealizeWidget(toplevel);
    XtAppMainLoop(context);
    return 0;
}
