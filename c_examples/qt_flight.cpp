/*
 * qt_flight: flies the camera path in a window of Qt, 5 or 6.
 *
 *     c++ -fPIC -o qt_flight qt_flight.cpp $(pkg-config --cflags --libs vides Qt6Widgets) -lm
 *
 * A click into the window opens an editor, if none is open. The poses that the user
 * hands over (Alt-U) are played, 25 a second, round and round. Escape ends the program.
 */
#include <cstdio>
#include <vector>

#include <QApplication>
#include <QKeyEvent>
#include <QPainter>
#include <QSocketNotifier>
#include <QTimer>
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
        QObject::connect(&notifier, &QSocketNotifier::activated, [] { v_dispatch(); });
        QObject::connect(&timer, &QTimer::timeout, [this] {
            now = poses.empty() ? 0 : (now + 1) % poses.size();
            update();
        });
        timer.start(40); // milliseconds
        setWindowTitle("qt_flight");
        resize(480, 320);
    }
    ~Flight() override { v_editor_close(editor); }

private:
    // The poses are the library's and go when this returns: copy them. No exception
    // may leave a callback.
    static void onPoses(V_EDITOR *, const V_POSE *handedOver, size_t count, void *user) noexcept
    {
        auto *flight = static_cast<Flight *>(user);
        flight->poses.assign(handedOver, handedOver + count);
        flight->now = 0;
        std::printf("%zu poses\n", count);
        std::fflush(stdout);
    }

    // The user closes the window: its handle goes, too.
    static int onClose(V_EDITOR *editor, void *user) noexcept
    {
        v_editor_close(editor);
        static_cast<Flight *>(user)->editor = nullptr;
        return 1;
    }

    void mousePressEvent(QMouseEvent *) override
    {
        V_EDITOR_OPTIONS options;
        v_editor_options_init(&options);
        options.title = "qt_flight";
        options.object = &PYRAMID;
        options.on_poses = onPoses;
        options.on_close = onClose;
        options.user = this;
        if (editor == nullptr && v_editor_open(&options, &editor) != V_OK)
            std::fprintf(stderr, "qt_flight: %s\n", v_last_error());
    }

    void keyPressEvent(QKeyEvent *event) override
    {
        if (event->key() == Qt::Key_Escape)
            close();
    }

    void paintEvent(QPaintEvent *) override
    {
        QPainter painter(this);
        double m[16];
        if (poses.empty() || v_pose_gl_matrix(&poses[now], m) != V_OK)
            return;
        painter.translate(width() / 2.0, height() / 2.0);
        for (const auto &line : LINES) {
            QPointF ends[2];
            bool seen = true;
            for (int end = 0; end < 2; end++) {
                const double *p = XYZ[line[end]];
                // The zoom is a focal length in mm of a camera with a picture 24 mm high.
                const double depth = -(m[2] * p[0] + m[6] * p[1] + m[10] * p[2] + m[14]);
                const double scale = poses[now].zoom / 24.0 * height() / depth;
                ends[end] = QPointF((m[0] * p[0] + m[4] * p[1] + m[8] * p[2] + m[12]) * scale,
                                    -(m[1] * p[0] + m[5] * p[1] + m[9] * p[2] + m[13]) * scale);
                seen = seen && depth > 0.01;
            }
            if (seen)
                painter.drawLine(ends[0], ends[1]);
        }
    }

    V_EDITOR *editor = nullptr;
    std::vector<V_POSE> poses;
    size_t now = 0;
    QSocketNotifier notifier{v_fd(), QSocketNotifier::Read};
    QTimer timer;
};

int main(int argc, char **argv)
{
    QApplication application(argc, argv);
    Flight flight;
    flight.show();
    return application.exec();
}
