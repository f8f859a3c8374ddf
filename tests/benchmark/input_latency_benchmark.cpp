// The latency of a drag in one of several views: mouse moves are posted every 8 ms from another thread while all pictures follow
// them and the figures are measured after each rest. Prints, per strategy of the dragged view, the time from a move's posting
// until the window has handled it, and until the dragged view shows a picture of it or of a later one. Exit status 1 where a move
// is handled later than 100 ms after its posting, or half of the moves are shown later than `shown` ms after theirs.
//
//   input_latency_benchmark [scene] [seconds] [strategies] [shown]        needs a display
//
// `strategies`: those of the views, as for cullscope -s; empty: what the window shows of a scene of one's own, a strategy and the
// view that watches it. Left out: eight views.
#include <QApplication>
#include <QDir>
#include <QMouseEvent>
#include <QTest>
#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <stdexcept>
#include <thread>

#include "core/measure/statistics.h"
#include "tests/benchmark/run_experiment.h"
#include "ui/startup/display.h"
#include "ui/startup/first_views.h"
#include "ui/window/main_window.h"

namespace {

using namespace cullscope;
using namespace cullscope::ui;
using Clock = std::chrono::steady_clock;

constexpr double kLongestWait = 100.0;  // ms
constexpr int kPatience = 600'000;      // ms
constexpr int kMostDragged = 3;
constexpr auto kBetweenMoves = std::chrono::milliseconds(8);

double millisecondsSince(Clock::time_point start) {
    return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

/// A mouse move with the time of its posting.
struct TimedMove : QMouseEvent {
    TimedMove(const QPointF& position, const QPointF& global)
        : QMouseEvent(QEvent::MouseMove, position, global, Qt::NoButton, Qt::LeftButton, {}) {}
    Clock::time_point posted = Clock::now();
};

/// Records when each move was handled, and when the view's picture has caught up with it.
class Watch : public QObject {
public:
    Watch(Session& session, int view) : m_session(session), m_view(view) {
        connect(&session, &Session::pictureChanged, this, [this](int changed) {
            if (changed == m_view) shown();
        });
    }

    bool eventFilter(QObject* watched, QEvent* event) override {
        auto* move = dynamic_cast<TimedMove*>(event);
        if (!move) return false;
        watched->event(event);
        taken.push_back(millisecondsSince(move->posted));
        m_cameras.push_back({m_session.viewingCamera(m_view), move->posted});
        return true;
    }

    std::vector<double> taken, answered;

private:
    void shown() {
        const Camera& camera = m_session.picture(m_view)->request.viewing;
        const auto answers =
            std::find_if(m_cameras.rbegin(), m_cameras.rend(), [&](const auto& one) { return one.first == camera; });
        if (answers == m_cameras.rend()) return;
        // The latency is that of the oldest move that this picture is the first to show.
        answered.push_back(millisecondsSince(m_cameras.front().second));
        m_cameras.erase(m_cameras.begin(), answers.base());
    }

    Session& m_session;
    int m_view;
    std::vector<std::pair<Camera, Clock::time_point>> m_cameras;
};

Row cellsOf(const std::string& strategy, const Watch& watch) {
    return {{"strategy", strategy},
            {"moves", double(watch.taken.size())},
            {"taken_ms", quantile(watch.taken, 0.5)},
            {"taken_ms_p99", quantile(watch.taken, 0.99)},
            {"taken_ms_longest", quantile(watch.taken, 1.0)},
            {"pictures", double(watch.answered.size())},
            {"shown_ms", quantile(watch.answered, 0.5)},
            {"shown_ms_p99", quantile(watch.answered, 0.99)},
            {"shown_ms_longest", quantile(watch.answered, 1.0)}};
}

/// Drags in a view for that many seconds, with rests in which figures are measured.
Row drag(Session& session, MainWindow& window, int view, double seconds) {
    session.setActiveView(view);
    SceneView& picture = window.views().pane(view).picture();
    Watch watch(session, view);
    picture.installEventFilter(&watch);
    const QPointF middle = QRectF(picture.rect()).center();
    const QPointF global = picture.mapToGlobal(middle);
    QMouseEvent press(QEvent::MouseButtonPress, middle, global, Qt::LeftButton, Qt::LeftButton, {});
    QApplication::sendEvent(&picture, &press);
    std::atomic<bool> done = false;
    std::thread hand([&] {
        const auto start = Clock::now();
        for (int step = 0; millisecondsSince(start) < 1000.0 * seconds; ++step) {
            const QPointF offset(60.0 * std::sin(step / 40.0), 20.0 * std::cos(step / 25.0));
            QCoreApplication::postEvent(&picture, new TimedMove(middle + offset, global + offset));
            // Once a second the drag pauses for 400 ms: measuring begins, and the next move interrupts it.
            std::this_thread::sleep_for(step % 75 == 74 ? std::chrono::milliseconds(400) : kBetweenMoves);
        }
        done = true;
    });
    // As an application does: the thread that looks for events in a loop would take a core from those that draw.
    while (!done) QApplication::processEvents(QEventLoop::AllEvents | QEventLoop::WaitForMoreEvents);
    hand.join();
    QApplication::processEvents();
    QMouseEvent release(QEvent::MouseButtonRelease, middle, global, Qt::LeftButton, Qt::NoButton, {});
    QApplication::sendEvent(&picture, &release);
    picture.removeEventFilter(&watch);
    return cellsOf(session.slot(view).id(), watch);
}

/// The window's state is the point: the experiment names no scene of its own.
Experiment inputLatency(Session& session, MainWindow& window, const std::function<void()>& settle, double seconds,
                        const std::optional<double>& latestShown) {
    Experiment experiment;
    experiment.id = "input-latency";
    experiment.title = "From a mouse move's posting until it is taken, and until its picture is shown";
    const Viewport size = session.renderSize(0);
    experiment.notes = {{"%1: %2 triangles, %3 views of %4 x %5",
                         {session.opened()->specification, std::to_string(session.scene()->triangleCount()),
                          std::to_string(session.viewCount()), std::to_string(size.width), std::to_string(size.height)}}};
    std::vector<CellValue> dragged;
    for (int view = 0; view < std::min(kMostDragged, session.viewCount()); ++view) dragged.emplace_back(double(view));
    experiment.axes = {{"view", "view", Axis::Kind::Label, dragged}};
    experiment.settings = settingsOf(experiment.axes);
    experiment.columns = columnsOf(experiment.axes);
    experiment.columns.push_back({"strategy", "strategy", ResultColumn::Origin::Axis});
    for (const char* key :
         {"moves", "taken_ms", "taken_ms_p99", "taken_ms_longest", "pictures", "shown_ms", "shown_ms_p99", "shown_ms_longest"})
        experiment.columns.push_back({key, key});
    RowPlot times{logPlot("From a mouse move until it is taken and until its picture is shown", "view", "ms"),
                  "view",
                  {{"taken_ms", "taken, median"},
                   {"taken_ms_longest", "taken, longest"},
                   {"shown_ms", "shown, median"},
                   {"shown_ms_longest", "shown, longest"}}};
    times.plot.x.scale = PlotScale::Linear;
    experiment.plots = {times};
    experiment.checks = {everyRowCheck("longest wait of a move, ms", {}, "taken_ms_longest", {.most = kLongestWait})};
    if (latestShown)
        experiment.checks.push_back(
            everyRowCheck("median wait until a move is shown, ms", {}, "shown_ms", {.most = *latestShown}));
    experiment.measured = [&session, &window, settle, seconds](const Setting& setting, const ScenePointer& /*scene*/,
                                                               const Progress& /*progress*/) {
        const Row cells = drag(session, window, int(setting.number("view")), seconds);
        settle();
        return Rows{cells};
    };
    return experiment;
}

int run(const QString& scene, double seconds, const std::optional<std::string>& strategies,
        const std::optional<double>& latestShown) {
    Session session({});
    Language language;
    Appearance appearance;
    MainWindow window(session, language, appearance);
    window.resize(1366, 768);
    window.show();
    if (strategies)
        showFirstViews(session, strategies->empty() ? std::vector<StrategyRequest>() : strategiesFromText({*strategies}));
    else
        session.setViewCount(Session::kMostViews);
    session.open(scene);
    const auto settle = [&] {
        const auto settled = [&] {
            const bool drawn = session.opened() && session.buffers() && !session.pictures()->busy();
            return drawn && session.metricsSettled() && session.picture(session.shownViews().front());
        };
        if (!QTest::qWaitFor(settled, kPatience)) throw std::runtime_error(scene.toStdString() + " does not open");
    };
    settle();
    return benchmark::runAndReport({inputLatency(session, window, settle, seconds, latestShown)});
}

}  // namespace

int main(int argc, char** argv) try {
    setDefaultSurfaceFormat();
    int qtArgc = 1;
    const std::unique_ptr<QApplication> application = makeApplication(qtArgc, argv);
    QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, QDir::tempPath());
    return run(argc > 1 ? QString::fromLocal8Bit(argv[1]) : QStringLiteral("sphere:triangles=144046"),
               argc > 2 ? QString::fromLocal8Bit(argv[2]).toDouble() : 8.0,
               argc > 3 ? std::optional<std::string>(argv[3]) : std::nullopt,
               argc > 4 ? std::optional(QString::fromLocal8Bit(argv[4]).toDouble()) : std::nullopt);
} catch (const std::exception& failure) {
    std::fprintf(stderr, "%s\n", failure.what());
    return 2;
}
