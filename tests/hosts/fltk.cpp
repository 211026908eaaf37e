/* A host with FLTK: a click opens the editor, M a dialog of its own, Escape ends. */
#include <cstdio>

#include <FL/Fl.H>
#include <FL/Fl_Window.H>
#include <FL/fl_ask.H>
#include <FL/fl_draw.H>

#include <libvides.h>

static V_KAMERAPAR list;
static int turn;

extern "C" {
static void rueck(V_KAMERAPAR *, int count)
{
    std::printf("%d poses\n", count);
    std::fflush(stdout);
}
}

class Host : public Fl_Window {
public:
    Host() : Fl_Window(360, 120, "fltk") { end(); }

private:
    void draw() override
    {
        Fl_Window::draw();
        fl_rectf(turn, 20, 40, 40, FL_BLACK);
    }

    int handle(int event) override
    {
        if (event == FL_PUSH) {
            v_haupt(100, 100, 100, 100, &list, 0, nullptr, rueck, nullptr);
            return 1;
        }
        if (event == FL_KEYDOWN && Fl::event_key() == 'm') {
            fl_message("A dialog"); // a loop of its own
            return 1;
        }
        return Fl_Window::handle(event);
    }
};

static void tick(void *host)
{
    turn = (turn + 5) % 300;
    static_cast<Host *>(host)->redraw();
    Fl::repeat_timeout(0.04, tick, host);
}

static void serve(int, void *)
{
    v_dispatch();
}

int main()
{
    Host host;

    list.number = -1; // no poses yet
    Fl::add_timeout(0.04, tick, &host);
    Fl::add_fd(v_fd(), FL_READ, serve);
    host.show();
    return Fl::run();
}
