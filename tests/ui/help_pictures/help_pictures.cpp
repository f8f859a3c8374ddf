// The pictures of the manual: the window in the states that the pages speak of.
//
//   help_pictures FOLDER MODELS [name]...        needs a display; MODELS: the folder with the bunny
//
// Writes FOLDER/<name>.png for each picture, or for the named ones. Colours are reduced to a palette of 255, as in the tree.
#include <QApplication>
#include <QDir>
#include <QTest>
#include <algorithm>
#include <cstdio>
#include <functional>
#include <stdexcept>

#include "core/scene/camera_path.h"
#include "ui/startup/display.h"
#include "ui/startup/first_views.h"
#include "ui/window/main_window.h"

namespace {

using namespace cullscope;
using namespace cullscope::ui;

constexpr QSize kWindow{1366, 748};
constexpr int kPatience = 120'000;  // ms
constexpr int kPalette = 255;
constexpr const char* kBunny = "mesh:bunny,triangles=144046";

struct Desktop {
    explicit Desktop(const QString& models) : session(options(models)), window(session, language, appearance) {
        window.setKeepsLayout(false);
        appearance.setMode(Appearance::Mode::Light);
        window.resize(kWindow);
        window.show();
    }

    static Session::Options options(const QString& models) {
        Session::Options options;
        options.sceneSource.modelFolders = {models.toStdString()};
        return options;
    }

    void settle() {
        const auto settled = [this] {
            return !session.loader().loading() && session.opened() && session.buffers() && !session.slot(0).building() &&
                   session.metricsSettled() && !session.pictures()->busy();
        };
        // What the panels read follows the picture.
        for (int i = 0; i < 2; ++i) {
            if (!QTest::qWaitFor(settled, kPatience)) throw std::runtime_error("the window does not settle");
            QTest::qWait(400);
        }
    }

    void open(const char* scene) {
        session.open(QString::fromLatin1(scene));
        settle();
    }

    /// View A by a strategy, in a picture of a fixed size; view B watches it, with verdicts and overlays.
    void watch(const char* strategy, const ViewLook& look) {
        session.setActiveView(0);
        session.slot(0).choose(strategy);
        session.setViewCount(2);
        ViewSetup setup = session.setup(0);
        setup.size = Viewport{640, 480};
        session.setSetup(0, setup);
        session.observe(1, 0);
        ViewSetup watching = session.setup(1);
        watching.look = look;
        watching.size = setup.size;
        session.setSetup(1, watching);
        settle();
    }

    void seeFrom(int view, const Vec3& eye, const Vec3& target) {
        Camera camera = session.viewingCamera(view);
        camera.eye = eye;
        camera.target = target;
        camera.fovy = Angle::fromDegrees(40.0);
        session.setViewingCamera(view, camera);
        settle();
    }

    void showTab(QWidget& tab) {
        window.structurePanel().tabs().setCurrentWidget(&tab);
        settle();
    }

    Session session;
    Language language;
    Appearance appearance;
    MainWindow window;
};

void firstWindow(Desktop& desktop) {
    desktop.window.lessons().player().show(LessonPlayer::firstStep(2));
    desktop.settle();
}

void inside(Desktop& desktop) {
    desktop.open(kBunny);
    desktop.watch("spherical", {"verdicts", "bands"});
    desktop.seeFrom(1, {4.2, 0.9, -0.6}, Vec3(0.0));
    if (!desktop.window.structurePanel().curves().empty()) desktop.showTab(*desktop.window.structurePanel().curves().front());
}

void ofCase(Desktop& desktop, const char* path) {
    desktop.open(kBunny);
    desktop.watch("spherical", {"verdicts", "boxes", "frustum"});
    const Camera camera = cameraPath(path, *desktop.session.scene()).camera(0);
    desktop.session.setCamera(camera);
    // From beside the culling camera, so that its rays are seen from the side.
    const Vec3 back = glm::normalize(camera.eye - camera.target), side = glm::normalize(glm::cross(camera.up, back));
    desktop.seeFrom(1, 3.6 * glm::normalize(0.5 * back + 0.8 * side + 0.3 * glm::cross(back, side)), Vec3(0.0));
}

void lossless(Desktop& desktop) {
    desktop.open(kBunny);
    desktop.watch("spherical-lossless", {"verdicts", "kernel"});
    desktop.seeFrom(1, {4.2, 0.9, -0.6}, Vec3(0.0));
}

/// The quiz by its tree, at the step that draws a polygon in the middle.
void stepping(Desktop& desktop) {
    desktop.open("quiz");
    desktop.session.setActiveView(0);
    showFirstViews(desktop.session, strategiesFromText({"bsp:plane=given"}));
    desktop.settle();
    desktop.window.actions().stepThrough->trigger();
    if (!QTest::qWaitFor([&] { return desktop.window.stepper().place() != nullptr; }, kPatience))
        throw std::runtime_error("the frame is not read");
    desktop.window.stepper().jump(desktop.window.stepper().place()->count() * 5 / 8);
    desktop.showTab(desktop.window.structurePanel().listing());
}

const std::vector<std::pair<std::string, std::function<void(Desktop&)>>> kPictures{
    {"first-window", firstWindow},
    {"inside", inside},
    {"case-1", [](Desktop& desktop) { ofCase(desktop, "case-1"); }},
    {"case-2", [](Desktop& desktop) { ofCase(desktop, "case-2"); }},
    {"case-3", [](Desktop& desktop) { ofCase(desktop, "case-3"); }},
    {"lossless", lossless},
    {"stepping", stepping},
};

/// The most frequent colours, and for all others the nearest one of them.
QImage withPalette(const QImage& picture) {
    const QImage image = picture.convertToFormat(QImage::Format_RGB32);
    QHash<QRgb, int> counts;
    const auto coarse = [](QRgb colour) { return colour & 0xFFF8F8F8; };
    QHash<QRgb, QHash<QRgb, int>> exact;
    for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x) {
            const QRgb colour = image.pixel(x, y);
            ++counts[coarse(colour)];
            ++exact[coarse(colour)][colour];
        }
    QList<QRgb> colours = counts.keys();
    std::ranges::sort(colours, [&](QRgb a, QRgb b) { return counts[a] > counts[b]; });
    if (colours.size() > kPalette) colours.resize(kPalette);
    for (QRgb& colour : colours) {
        const QHash<QRgb, int>& of = exact[colour];
        for (auto one = of.begin(); one != of.end(); ++one)
            if (one.value() > of.value(colour)) colour = one.key();
    }
    return image.convertToFormat(QImage::Format_Indexed8, colours, Qt::ThresholdDither | Qt::AvoidDither);
}

}  // namespace

int main(int argc, char** argv) try {
    setDefaultSurfaceFormat();
    int qtArgc = 1;
    const std::unique_ptr<QApplication> application = makeApplication(qtArgc, argv);
    QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, QDir::tempPath() + QStringLiteral("/help-pictures"));
    if (argc < 3) throw std::runtime_error("help_pictures FOLDER MODELS [name]...");
    const std::vector<std::string> named(argv + 3, argv + argc);
    for (const auto& [name, make] : kPictures) {
        if (!named.empty() && std::ranges::find(named, name) == named.end()) continue;
        Desktop desktop(QString::fromLocal8Bit(argv[2]));
        make(desktop);
        const QString file = QString::fromLocal8Bit(argv[1]) + QLatin1Char('/') + QString::fromStdString(name) + ".png";
        if (!withPalette(desktop.window.grab().toImage()).save(file))
            throw std::runtime_error("cannot write " + file.toStdString());
        std::printf("%s\n", qPrintable(file));
    }
    return 0;
} catch (const std::exception& failure) {
    std::fprintf(stderr, "%s\n", failure.what());
    return 2;
}
