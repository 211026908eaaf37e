/*
 * qt_flight: flies the camera path in a window of Qt, 5 or 6.
 *
 *     c++ -fPIC -o qt_flight qt_flight.cpp $(pkg-config --cflags --libs vides Qt6Widgets) -lm
 *
 * The picture follows the editor beside it: what is dragged, scrubbed or played there
 * is seen here at once. Dragging here moves a separate camera around the object; the
 * editor shows it as a ghost and takes it over into the path (Ctrl-Enter). Escape ends.
 */
#include <cmath>
#include <cstdio>

#include <QApplication>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QSocketNotifier>
#include <QWidget>

#include <libvides.h>

// What both show: points, and the lines between them.
const double XYZ[][3] = {
    {0.3, 0.0, 0.3}, {0.3, 0.0, -0.3}, {-0.3, 0.0, -0.3}, {-0.3, 0.0, 0.3}, {0.0, 0.5, 0.0}
};
const unsigned LINES[][2] = {{0, 1}, {1, 2}, {2, 3}, {3, 0}, {0, 4}, {1, 4}, {2, 4}, {3, 4}};
const V_MESH PYRAMID = {sizeof PYRAMID, XYZ[0], 5, nullptr, LINES[0], 16, nullptr, 0};

class Flight : public QWidget {
public:
    Flight()
    {
        setWindowTitle("qt_flight");
        resize(480, 320);
        QObject::connect(&notifier, &QSocketNotifier::activated, [] { v_dispatch(); });
        V_EDITOR_OPTIONS options;
        v_editor_options_init(&options);
        options.title = options.host_name = "qt_flight";
        options.object = &PYRAMID;
        options.on_view = onView;
        options.on_capture = onCapture;
        options.user = this;
        if (v_editor_open(&options, &editor) != V_OK)
            std::fprintf(stderr, "qt_flight: %s\n", v_last_error());
        lead(0.6, 0.4);
    }
    ~Flight() override { v_editor_close(editor); }

private:
    // The camera in the editor has moved: this picture shows the same moment. No exception
    // may leave a callback.
    static void onView(V_EDITOR *, const V_POSE *pose, double frame, int, void *user) noexcept
    {
        auto *flight = static_cast<Flight *>(user);
        flight->shown = *pose;
        flight->setWindowTitle(QString("qt_flight: frame %1").arg(frame));
        flight->update();
    }

    // "Take over the view".
    static int onCapture(V_EDITOR *, V_POSE *pose, void *user) noexcept
    {
        *pose = static_cast<Flight *>(user)->own;
        return 1;
    }

    // The own camera goes about the object, and stands in the editor as a ghost.
    void lead(double turn, double lean)
    {
        const double x = 1.6 * std::sin(turn) * std::cos(lean);
        const double y = 1.6 * std::sin(lean), z = 1.6 * std::cos(turn) * std::cos(lean);
        shown = own = {{x, y, z}, {-x, 0.2 - y, -z}, {0, 1, 0}, 30};
        v_editor_set_view(editor, &own);
        update();
    }

    void mouseMoveEvent(QMouseEvent *event) override
    {
        lead(0.01 * event->pos().x(), 0.005 * event->pos().y());
    }

    void keyPressEvent(QKeyEvent *event) override
    {
        if (event->key() == Qt::Key_Escape)
            close();
    }

    // Where a point is seen. The zoom is a focal length in mm, with a picture 24 mm high.
    bool seen(const double (&m)[16], const double (&p)[3], QPointF &at) const
    {
        const double depth = -(m[2] * p[0] + m[6] * p[1] + m[10] * p[2] + m[14]);
        const double scale = shown.zoom / 24.0 * height() / depth;
        at = {width() / 2.0 + (m[0] * p[0] + m[4] * p[1] + m[8] * p[2] + m[12]) * scale,
              height() / 2.0 - (m[1] * p[0] + m[5] * p[1] + m[9] * p[2] + m[13]) * scale};
        return depth > 0.01;
    }

    void paintEvent(QPaintEvent *) override
    {
        QPainter painter(this);
        QPointF from, to;
        double m[16];
        v_pose_matrix(&shown, V_AXES_OPENGL, 0, m);
        for (const auto &line : LINES)
            if (seen(m, XYZ[line[0]], from) && seen(m, XYZ[line[1]], to))
                painter.drawLine(from, to);
    }

    V_EDITOR *editor = nullptr;
    V_POSE shown, own;
    QSocketNotifier notifier{v_fd(), QSocketNotifier::Read};
};

int main(int argc, char **argv)
{
    QApplication application(argc, argv);
    Flight flight;
    flight.show();
    return application.exec();
}
