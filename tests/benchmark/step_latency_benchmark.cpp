// The latency of a step: a key is posted to the window, and the time is taken until the display has the picture of that step in
// the stepped view. Each kind of step (on, back, jump) is made many times in a stepped frame. Exit status 1 where the slowest
// step of a kind takes longer than the limit.
//
//   step_latency_benchmark [scene] [strategy] [limit in ms] [steps of a kind]        needs a display
//   step_latency_benchmark all FOLDER [mesh] [steps of a kind]
//   step_latency_benchmark lessons FOLDER [times] [lesson]…
//
// `all` steps the quiz and 500 polygons by the lecture's six methods, at most 50 ms a step, and a large mesh (a sphere of 144,046
// triangles, unless a file is named) by `spherical`, seen whole and cut by the frustum, at most 100 ms. The table is written to
// FOLDER. `lessons` goes through the steps of the program's own lessons instead (lesson_latency.h).
#include <QApplication>
#include <QDir>
#include <QScreen>
#include <QTest>
#include <array>
#include <chrono>
#include <cstdio>
#include <set>
#include <stdexcept>

#include "core/geometry/random.h"
#include "core/measure/statistics.h"
#include "tests/benchmark/lesson_latency.h"
#include "tests/benchmark/run_experiment.h"
#include "ui/startup/display.h"
#include "ui/window/main_window.h"

namespace {

using namespace cullscope;
using namespace cullscope::ui;
using Clock = std::chrono::steady_clock;

constexpr int kPatience = 120'000;                         // ms
constexpr int kQuiet = 60;                                 // ms after a step, in which its panels follow
constexpr double kSmallLimit = 50.0, kLargeLimit = 100.0;  // ms
constexpr int kUsualTimes = 40;                            // steps of a kind
constexpr size_t kPolygons = 500;
const std::array<std::string, 3> kKinds{"on", "back", "jump"};
constexpr const char* kSixMethods[] = {"backface", "depth-buffer", "scan-line", "octree-query", "painter", "bsp"};

/// What is stepped: a scene that is opened by its specification, or polygons made here.
struct SteppedScene {
    std::string name, strategy;
    double limit = kSmallLimit;   ///< ms
    std::string specification{};  ///< empty: polygons
    double fovy = 0.0;            ///< degrees; 0: as the scene is opened
};

/// Triangles anywhere in a cube that meet each other, with edges of a third of it at most.
std::shared_ptr<const OpenedScene> polygons() {
    TriangleMesh::Data data;
    data.name = "polygons";
    Random random(17);
    const auto within = [&](double reach) {
        return Vec3f(float(random.between(-reach, reach)), float(random.between(-reach, reach)),
                     float(random.between(-reach, reach)));
    };
    for (size_t i = 0; i < kPolygons; ++i) {
        const Vec3f middle = within(1.0);
        for (uint32_t corner = 0; corner < 3; ++corner) {
            data.positions.push_back(middle + within(0.3));
            data.indices.push_back(uint32_t(3 * i) + corner);
        }
    }
    auto opened = std::make_shared<OpenedScene>();
    opened->scene =
        std::make_shared<const Scene>("polygons", std::vector<MeshPointer>{std::make_shared<TriangleMesh>(std::move(data))},
                                      std::vector<Instance>{{0, Mat4(1.0), "polygons"}});
    return opened;
}

/// Sees when the window has been painted with what a part of it shows.
class PaintWatch : public QObject {
public:
    PaintWatch(QWidget& window, QWidget& part, std::function<bool()> awaited)
        : m_window(window), m_part(part), m_awaited(std::move(awaited)) {
        m_window.installEventFilter(this);
        m_part.installEventFilter(this);
    }

    bool eventFilter(QObject* watched, QEvent* event) override {
        if (watched == &m_part && event->type() == QEvent::Paint) m_painted = m_painted || m_awaited();
        if (watched != &m_window || event->type() != QEvent::UpdateRequest) return false;
        // What is painted in it is flushed at its end, and a reading of the screen comes after that.
        watched->event(event);
        if (!m_painted || shown) return true;
        (void)m_window.screen()->grabWindow(m_window.winId(), 0, 0, 1, 1);
        shown = Clock::now();
        return true;
    }

    std::optional<Clock::time_point> shown;

private:
    QWidget& m_window;
    QWidget& m_part;
    std::function<bool()> m_awaited;
    bool m_painted = false;
};

/// The window with one stepped view of 640 × 480 pixels.
class SteppedWindow {
public:
    SteppedWindow() : window(session, language, appearance) {
        window.resize(1366, 768);
        window.show();
        session.setViewCount(1);
        ViewSetup setup = session.setup(session.activeView());
        setup.size = Viewport{640, 480};
        session.setSetup(session.activeView(), setup);
    }

    /// Shows what is stepped, and steps it.
    void step(const SteppedScene& scene) {
        window.stepper().stop();
        session.slot(session.activeView()).choose(scene.strategy);
        if (scene.specification.empty())
            session.show(polygons());
        else
            session.open(QString::fromStdString(scene.specification));
        wait([&] { return !session.loader().loading() && settled(); });
        if (scene.fovy > 0.0) {
            Camera camera = session.camera();
            camera.fovy = Angle::fromDegrees(scene.fovy);
            session.setCamera(camera);
            wait([&] { return settled(); });
        }
        window.actions().stepThrough->trigger();
        wait([&] { return window.stepper().place() != nullptr && current(); });
    }
    [[nodiscard]] bool settled() {
        return session.opened() && session.buffers() && !session.slot(session.activeView()).building() &&
               session.metricsSettled() && !session.pictures()->busy();
    }

    void wait(const std::function<bool()>& condition) const {
        if (!QTest::qWaitFor(condition, kPatience)) throw std::runtime_error("the window does not settle");
    }
    [[nodiscard]] bool current() { return session.pictures()->isCurrent(session.activeView()) && !session.pictures()->busy(); }

    /// From the posting until the X server has the view's picture of the step, in milliseconds.
    double milliseconds(const std::function<void()>& post) {
        const LogPlace before = session.step()->place;
        const int view = session.activeView();
        PaintWatch watch(window, window.views().pane(view).picture(),
                         [&] { return !(session.step()->place == before) && session.pictures()->isCurrent(view); });
        const Clock::time_point start = Clock::now(), patience = start + std::chrono::seconds(30);
        post();
        while (!watch.shown && Clock::now() < patience) QApplication::processEvents(QEventLoop::AllEvents, 1);
        if (!watch.shown) throw std::runtime_error("a step is not shown");
        // The panels follow; the next step begins when all is quiet.
        QTest::qWait(kQuiet);
        return std::chrono::duration<double, std::milli>(*watch.shown - start).count();
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

/// `kind`: of kKinds.
Row rowOf(SteppedWindow& stepped, int kind, int times) {
    Stepper& stepper = stepped.window.stepper();
    const size_t count = stepper.place()->count();
    std::vector<double> taken;
    for (int i = 0; i < times; ++i) {
        const size_t step = stepper.place()->step();
        if (kind == 0 && step == count) stepper.jump(0);
        if (kind == 1 && step == 0) stepper.toEnd();
        stepped.wait([&] { return stepped.current(); });
        // Its panels follow, as after a timed step.
        if (stepper.place()->step() != step) QTest::qWait(kQuiet);
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
    return {{"steps", double(count)},
            {"times", double(taken.size())},
            {"shown_ms", quantile(taken, 0.5)},
            {"shown_ms_p99", quantile(taken, 0.99)},
            {"shown_ms_longest", quantile(taken, 1.0)}};
}

Experiment stepLatency(SteppedWindow& stepped, const std::vector<SteppedScene>& scenes, int times) {
    Experiment experiment;
    experiment.id = "step-latency";
    experiment.title = "From a step's key until its picture is shown";
    experiment.notes = {{"one view of 640 x 480", {}}};
    Axis names{"scene", "scene", Axis::Kind::Label, {}}, strategies{"strategy", "strategy", Axis::Kind::Label, {}};
    const Axis kinds{"step", "step", Axis::Kind::Label, {kKinds.begin(), kKinds.end()}};
    for (const SteppedScene& scene : scenes) {
        const Axis name{"scene", "", Axis::Kind::Label, {scene.name}},
            strategy{"strategy", "", Axis::Kind::Label, {scene.strategy}};
        for (Setting& setting : settingsOf({name, strategy, kinds})) experiment.settings.push_back(std::move(setting));
        for (const auto& [axis, value] : {std::pair(&names, scene.name), std::pair(&strategies, scene.strategy)})
            if (std::ranges::find(axis->values, CellValue(value)) == axis->values.end()) axis->values.emplace_back(value);
    }
    experiment.axes = {names, strategies, kinds};
    experiment.columns = columnsOf(experiment.axes);
    for (const char* key : {"triangles", "steps", "times", "shown_ms", "shown_ms_p99", "shown_ms_longest", "limit_ms"})
        experiment.columns.push_back({key, key});
    RowPlot shown{logPlot("%1: from a step's key until its picture is shown", "steps of the frame", "ms")};
    shown.x = "steps";
    shown.y = {{"shown_ms", "median"}, {"shown_ms_longest", "slowest"}};
    shown.lines = {"step"};
    shown.separate = {"scene"};
    shown.byX = true;
    experiment.plots = {shown};
    std::set<double> limits;
    for (const SteppedScene& scene : scenes) limits.insert(scene.limit);
    for (const double limit : limits)
        experiment.checks.push_back(
            everyRowCheck("slowest step, ms", {{"limit_ms", {limit}}}, "shown_ms_longest", {.most = limit}));
    experiment.measured = [&stepped, scenes, times](const Setting& setting, const ScenePointer& /*scene*/,
                                                    const Progress& /*progress*/) {
        const auto isIt = [&](const SteppedScene& scene) {
            return scene.name == setting.words("scene") && scene.strategy == setting.words("strategy");
        };
        const SteppedScene& scene = *std::ranges::find_if(scenes, isIt);
        const auto kind = std::ranges::find(kKinds, setting.words("step")) - kKinds.begin();
        if (kind == 0) stepped.step(scene);
        Row row = rowOf(stepped, int(kind), times);
        row["triangles"] = double(stepped.session.scene()->triangleCount());
        row["limit_ms"] = scene.limit;
        return Rows{row};
    };
    return experiment;
}

std::vector<SteppedScene> allScenes(const std::string& mesh) {
    std::vector<SteppedScene> scenes;
    for (const char* strategy : kSixMethods) scenes.push_back({"quiz", strategy, kSmallLimit, "quiz"});
    for (const char* strategy : kSixMethods) scenes.push_back({"500 polygons", strategy});
    scenes.push_back({"mesh, whole", "spherical", kLargeLimit, mesh});
    scenes.push_back({"mesh, cut", "spherical", kLargeLimit, mesh, 14.0});
    return scenes;
}

}  // namespace

int main(int argc, char** argv) try {
    setDefaultSurfaceFormat();
    int qtArgc = 1;
    const std::unique_ptr<QApplication> application = makeApplication(qtArgc, argv);
    QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, QDir::tempPath());
    const std::vector<std::string> arguments(argv + 1, argv + argc);
    const auto argument = [&](size_t i, const char* usual) { return i < arguments.size() ? arguments[i] : std::string(usual); };
    const std::string large = "sphere:triangles=144046";
    const bool all = argument(0, "") == "all", lessons = argument(0, "") == "lessons";
    if ((all || lessons) && arguments.size() < 2) throw std::runtime_error(arguments[0] + ": name the folder for the table");
    if (lessons) {
        const auto named = arguments.begin() + ptrdiff_t(std::min<size_t>(arguments.size(), 3));
        return benchmark::runAndReport(
            {benchmark::lessonLatency(std::stoi(argument(2, "3")), {named, arguments.end()}), arguments[1]});
    }
    SteppedWindow stepped;
    if (all) {
        const int times = std::stoi(argument(3, std::to_string(kUsualTimes).c_str()));
        return benchmark::runAndReport({stepLatency(stepped, allScenes(argument(2, large.c_str())), times), arguments[1]});
    }
    const std::string scene = argument(0, large.c_str());
    const SteppedScene one{scene, argument(1, "spherical"), std::stod(argument(2, "100")), scene};
    return benchmark::runAndReport({stepLatency(stepped, {one}, std::stoi(argument(3, "40")))});
} catch (const std::exception& failure) {
    std::fprintf(stderr, "%s\n", failure.what());
    return 2;
}
