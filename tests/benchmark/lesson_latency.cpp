// The latency of a lesson's steps, in a window as it starts: it measures while it rests, and the next step interrupts that.
#include "tests/benchmark/lesson_latency.h"

#include <QTest>
#include <chrono>
#include <memory>
#include <stdexcept>

#include "core/measure/statistics.h"
#include "tests/ui/lesson_on_screen.h"

namespace cullscope::benchmark {
namespace {

using namespace cullscope::ui;
using Clock = std::chrono::steady_clock;

constexpr int kPatience = 120'000;                            // ms
constexpr int kQuiet = 60;                                    // ms after a step, in which the window is at rest
constexpr int kBetweenLooks = 2;                              // ms
constexpr double kUsualLimit = 1000.0, kOtherLimit = 2000.0;  // ms

class LessonWindow {
public:
    LessonWindow() : window(session, language, appearance) {
        window.resize(1280, 720);
        window.show();
    }

    /// Milliseconds from `go` until the step in hand is on screen.
    double milliseconds(const std::function<void()>& go) {
        const Clock::time_point start = Clock::now();
        go();
        // A look at the window takes time from those who draw: there is a pause after each.
        while (!lessonStepIsOnScreen(window, session)) {
            if (Clock::now() - start > std::chrono::milliseconds(kPatience)) throw std::runtime_error("a step is not shown");
            QTest::qWait(kBetweenLooks);
        }
        QApplication::processEvents();
        const double taken = std::chrono::duration<double, std::milli>(Clock::now() - start).count();
        QTest::qWait(kQuiet);
        return taken;
    }
    LessonPlayer& player() { return window.lessons().player(); }

    Session session{{}};
    Language language;
    Appearance appearance;
    MainWindow window;
};

/// The rows of a lesson's steps.
Rows rowsOf(LessonWindow& shown, const QString& lesson, int times) {
    LessonPlayer& player = shown.player();
    std::vector<std::vector<double>> taken;
    Rows rows;
    for (int time = 0; time < times; ++time) {
        const double first = shown.milliseconds([&] { player.begin(lesson); });
        taken.resize(size_t(player.count()));
        rows.resize(taken.size());
        for (size_t step = 0; step < taken.size(); ++step) {
            taken[step].push_back(step == 0 ? first : shown.milliseconds([&] { player.go(int(step)); }));
            rows[step]["views"] = double(shown.session.viewCount());
            rows[step]["triangles"] = double(shown.session.scene()->triangleCount());
            rows[step]["limit_ms"] = player.current().defaultScene ? kUsualLimit : kOtherLimit;
        }
    }
    for (size_t step = 0; step < rows.size(); ++step) {
        rows[step]["step"] = double(step + 1);
        rows[step]["times"] = double(taken[step].size());
        rows[step]["shown_ms"] = quantile(taken[step], 0.5);
        rows[step]["shown_ms_longest"] = quantile(taken[step], 1.0);
    }
    return rows;
}

}  // namespace

Experiment lessonLatency(int times, std::vector<std::string> names) {
    if (names.empty())
        for (const QString& name : LessonPlayer::known()) names.push_back(name.toStdString());
    Experiment experiment;
    experiment.id = "lesson-latency";
    experiment.title = "From going to a lesson's step until it is on screen";
    experiment.notes = {{"a window of 1280 x 720", {}}};
    Axis lessons{"lesson", "lesson", Axis::Kind::Label, {}};
    Axis steps{"step", "step", Axis::Kind::InTurns, {}};
    size_t most = 0;
    for (const std::string& name : names) {
        lessons.values.emplace_back(name);
        most = std::max(most, LessonPlayer::read(QString::fromStdString(name)).steps.size());
    }
    for (size_t step = 1; step <= most; ++step) steps.values.emplace_back(double(step));
    experiment.settings = settingsOf({lessons});
    experiment.axes = {lessons, steps};
    experiment.columns = columnsOf(experiment.axes);
    for (const char* key : {"views", "triangles", "times", "shown_ms", "shown_ms_longest", "limit_ms"})
        experiment.columns.push_back({key, key});
    RowPlot shown;
    shown.plot.title = "From going to a lesson's step until it is on screen";
    shown.plot.x.title = "step";
    shown.plot.x.whole = true;
    shown.plot.y.title = "ms, the slowest of all times";
    shown.plot.y.zero = true;
    shown.x = "step";
    shown.y = {{"shown_ms_longest"}};
    shown.lines = {"lesson"};
    experiment.plots = {shown};
    for (const double limit : {kUsualLimit, kOtherLimit})
        experiment.checks.push_back(
            everyRowCheck("slowest step, ms", {{"limit_ms", {limit}}}, "shown_ms_longest", {.most = limit}));
    const auto shownIn = std::make_shared<std::unique_ptr<LessonWindow>>();
    experiment.measured = [shownIn, times](const Setting& setting, const ScenePointer& /*scene*/, const Progress& /*progress*/) {
        if (!*shownIn) *shownIn = std::make_unique<LessonWindow>();
        return rowsOf(**shownIn, QString::fromStdString(setting.words("lesson")), times);
    };
    return experiment;
}

}  // namespace cullscope::benchmark
