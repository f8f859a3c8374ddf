// The latency of a step: a key is posted to the window, and the time is taken until the stepped view has painted the picture of
// that step. Each kind of step (on, back, jump) is made many times in a stepped frame. Exit status 1 where the slowest step of a
// kind takes longer than the limit.
//
//   step_latency_benchmark [scene] [strategy] [limit in ms] [steps of a kind]        needs a display
#include <QApplication>
#include <QDir>
#include <QTest>
#include <chrono>
#include <cstdio>
#include <stdexcept>

#include "core/measure/statistics.h"
#include "tests/benchmark/run_experiment.h"
#include "ui/startup/display.h"
#include "ui/window/main_window.h"

namespace {

using namespace cullscope;
using namespace cullscope::ui;
using Clock = std::chrono::steady_clock;

constexpr int kPatience = 120'000;  // ms

/// The window with one stepped view of 640 × 480 pixels.
class SteppedWindow {
public:
    SteppedWindow(const QString& scene, const std::string& strategy) : window(session, language, appearance) {
        window.resize(1366, 768);
        window.show();
        session.setViewCount(1);
        ViewSetup setup = session.setup(session.activeView());
        setup.size = Viewport{640, 480};
        session.setSetup(session.activeView(), setup);
        session.slot(session.activeView()).choose(strategy);
        session.open(scene);
        wait([&] {
            return session.opened() && session.buffers() && !session.slot(session.activeView()).building() &&
                   session.metricsSettled() && !session.pictures()->busy();
        });
        window.actions().stepThrough->trigger();
        wait([&] { return window.stepper().place() != nullptr && current(); });
    }

    void wait(const std::function<bool()>& condition) const {
        if (!QTest::qWaitFor(condition, kPatience)) throw std::runtime_error("the window does not settle");
    }
    [[nodiscard]] bool current() { return session.pictures()->isCurrent(session.activeView()) && !session.pictures()->busy(); }

    /// From the posting until the view has been painted with the picture of the step, in milliseconds.
    double milliseconds(const std::function<void()>& post) {
        const LogPlace before = session.step()->place;
        const int view = session.activeView();
        bool painted = false;
        // Emitted when the window has been composed with what the view painted.
        const auto watch = QObject::connect(&window.views().pane(view).picture(), &QOpenGLWidget::frameSwapped, [&] {
            painted = !(session.step()->place == before) && session.pictures()->isCurrent(view);
        });
        const Clock::time_point start = Clock::now(), patience = start + std::chrono::seconds(30);
        post();
        while (!painted && Clock::now() < patience) QApplication::processEvents(QEventLoop::AllEvents, 1);
        QObject::disconnect(watch);
        if (!painted) throw std::runtime_error("a step is not shown");
        const double passed = std::chrono::duration<double, std::milli>(Clock::now() - start).count();
        // The panels follow; the next step begins when all is quiet.
        QTest::qWait(30);
        return passed;
    }

    /// A window that no window manager made active gets no shortcuts: the key's action is posted.
    void postKey(int key) {
        QAction* action = key == Qt::Key_PageDown ? window.actions().stepOn : window.actions().stepBack;
        QMetaObject::invokeMethod(action, &QAction::trigger, Qt::QueuedConnection);
    }

    Session session{{}};
    Language language;
    Appearance appearance;
    MainWindow window;
};

Row rowOf(SteppedWindow& stepped, int kind, int times) {
    Stepper& stepper = stepped.window.stepper();
    const size_t count = stepper.place()->count();
    std::vector<double> taken;
    for (int i = 0; i < times; ++i) {
        const size_t step = stepper.place()->step();
        if (kind == 0 && step == count) stepper.jump(0);
        if (kind == 1 && step == 0) stepper.toEnd();
        stepped.wait([&] { return stepped.current(); });
        // Jumps go to and fro over the frame: 0, 5/8, 2/8, 7/8, … of it.
        const size_t target = (count * size_t((5 * i) % 8 + (i / 8) % 2)) / 8;
        if (kind == 2 && target == stepper.place()->step()) continue;
        taken.push_back(stepped.milliseconds([&] {
            if (kind == 2)
                stepped.window.stepBar().slider().setValue(int(target));
            else
                stepped.postKey(kind == 0 ? Qt::Key_PageDown : Qt::Key_PageUp);
        }));
    }
    const char* names[] = {"on", "back", "jump"};
    return {{"step", std::string(names[kind])},      {"steps", double(count)},
            {"times", double(taken.size())},         {"shown_ms", quantile(taken, 0.5)},
            {"shown_ms_p99", quantile(taken, 0.99)}, {"shown_ms_longest", quantile(taken, 1.0)}};
}

Experiment stepLatency(SteppedWindow& stepped, const QString& scene, const std::string& strategy, double limit, int times) {
    Experiment experiment;
    experiment.id = "step-latency";
    experiment.title = "From a step's key until its picture is painted";
    experiment.notes = {{"%1 by %2: %3 triangles, one view of 640 x 480",
                         {scene.toStdString(), strategy, std::to_string(stepped.session.scene()->triangleCount())}}};
    experiment.axes = {{"kind", "kind of step", Axis::Kind::Label, {0.0, 1.0, 2.0}}};
    experiment.settings = settingsOf(experiment.axes);
    experiment.columns = columnsOf(experiment.axes);
    experiment.columns.push_back({"step", "step", ResultColumn::Origin::Axis});
    for (const char* key : {"steps", "times", "shown_ms", "shown_ms_p99", "shown_ms_longest"})
        experiment.columns.push_back({key, key});
    experiment.checks = {everyRowCheck("slowest step, ms", {}, "shown_ms_longest", {.most = limit})};
    experiment.measured = [&stepped, times](const Setting& setting, const ScenePointer& /*scene*/, const Progress& /*progress*/) {
        return Rows{rowOf(stepped, int(setting.number("kind")), times)};
    };
    return experiment;
}

}  // namespace

int main(int argc, char** argv) try {
    setDefaultSurfaceFormat();
    int qtArgc = 1;
    const std::unique_ptr<QApplication> application = makeApplication(qtArgc, argv);
    QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, QDir::tempPath());
    const QString scene = argc > 1 ? QString::fromLocal8Bit(argv[1]) : QStringLiteral("sphere:triangles=144046");
    const std::string strategy = argc > 2 ? argv[2] : "spherical";
    const double limit = argc > 3 ? std::stod(argv[3]) : 100.0;
    const int times = argc > 4 ? std::stoi(argv[4]) : 40;
    SteppedWindow stepped(scene, strategy);
    return benchmark::runAndReport({stepLatency(stepped, scene, strategy, limit, times)});
} catch (const std::exception& failure) {
    std::fprintf(stderr, "%s\n", failure.what());
    return 2;
}
