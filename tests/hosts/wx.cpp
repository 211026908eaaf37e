/* A host with wxWidgets: a click opens the editor, M a dialog of its own, Escape ends. */
#include <cstdio>

#include <wx/evtloop.h>
#include <wx/evtloopsrc.h>
#include <wx/wx.h>

#include <libvides.h>

static V_KAMERAPAR list;

extern "C" {
static void rueck(V_KAMERAPAR *, int count)
{
    std::printf("%d poses\n", count);
    std::fflush(stdout);
}
}

class Serve : public wxEventLoopSourceHandler {
public:
    void OnReadWaiting() override { v_dispatch(); }
    void OnWriteWaiting() override {}
    void OnExceptionWaiting() override {}
};

class Host : public wxFrame {
public:
    Host() : wxFrame(nullptr, wxID_ANY, "wx", wxDefaultPosition, wxSize(360, 160)), timer(this)
    {
        auto panel = new wxPanel(this, wxID_ANY, wxDefaultPosition, wxDefaultSize, wxWANTS_CHARS);
        panel->Bind(wxEVT_PAINT, [this, panel](wxPaintEvent &) {
            wxPaintDC dc(panel);
            dc.SetBrush(*wxBLACK_BRUSH);
            dc.DrawRectangle(turn, 20, 40, 40);
        });
        panel->Bind(wxEVT_LEFT_DOWN, [](wxMouseEvent &) {
            v_haupt(100, 100, 100, 100, &list, 0, nullptr, rueck, nullptr);
        });
        panel->Bind(wxEVT_CHAR, [this](wxKeyEvent &event) {
            if (event.GetKeyCode() == WXK_ESCAPE)
                Close();
            else if (event.GetKeyCode() == 'm')
                wxMessageBox("A dialog"); // a loop of its own
        });
        Bind(wxEVT_TIMER, [this, panel](wxTimerEvent &) {
            turn = (turn + 5) % 300;
            panel->Refresh();
        });
        timer.Start(40);
        Show();
        panel->SetFocus();
    }

private:
    int turn = 0;
    wxTimer timer;
};

class Program : public wxApp {
    bool OnInit() override
    {
        list.number = -1; // no poses yet
        source = wxEventLoopBase::AddSourceForFD(v_fd(), &serve, wxEVENT_SOURCE_INPUT);
        new Host();
        return source != nullptr;
    }

    int OnExit() override
    {
        delete source;
        return wxApp::OnExit();
    }

    Serve serve;
    wxEventLoopSource *source = nullptr;
};

wxIMPLEMENT_APP(Program);
