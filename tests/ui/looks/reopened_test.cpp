// A large screenshot that restores the whole state when it is opened, and a malformed file that changes nothing.
#include <QDir>
#include <QDropEvent>
#include <QMimeData>
#include <QTemporaryDir>
#include <QToolBar>

#include "tests/ui/looks/desktop.h"
#include "ui/panels/message_bar.h"

namespace cullscope::ui::reopened_test {
namespace {

const Viewport kUltraHd{3840, 2160};
const QSize kKept{1280, 720};  // size of the stored picture of a large screenshot, which keeps the file small

void drop(MainWindow& window, const QString& file) {
    QMimeData dragged;
    dragged.setUrls({QUrl::fromLocalFile(file)});
    const QPoint middle = window.rect().center();
    QDragEnterEvent enter(middle, Qt::CopyAction, &dragged, Qt::LeftButton, {});
    QApplication::sendEvent(&window, &enter);
    ASSERT_TRUE(enter.isAccepted());
    QDropEvent dropped(middle, Qt::CopyAction, &dragged, Qt::LeftButton, {});
    QApplication::sendEvent(&window, &dropped);
    ASSERT_TRUE(dropped.isAccepted());
}

/// Takes a screenshot with the last settings, as F12 does.
QString screenshot(Desktop& desktop, const QString& folder) {
    ScreenshotSettings settings = ScreenshotSettings::load();
    settings.options.size = kUltraHd;
    settings.options.grid = settings.options.overlays = settings.options.legend = settings.options.caption = true;
    settings.folder = folder;
    settings.pattern = QStringLiteral("view-{n}.png");
    settings.save();
    QString file;
    QObject::connect(&desktop.window.document().screenshots(), &ScreenshotTaker::done, [&](const QString& path) { file = path; });
    desktop.window.actions().screenshotNow->trigger();
    EXPECT_TRUE(waitUntil([&] { return !file.isEmpty(); }));
    return file;
}

/// Changes strategies, parameters, cameras, roles, sizes, number of views and scene.
void changeEverything(Desktop& desktop) {
    openAndWait(desktop.session, QStringLiteral("torus:triangles=500"));
    desktop.window.actions().eightViews->trigger();
    for (int view = 0; view < 8; ++view) {
        desktop.edit(view, [](ViewSetup& setup) {
            setup = {};
            setup.size = Viewport{320, 200};
        });
        desktop.session.slot(view).choose("all");
    }
    desktop.session.setActiveView(5);
    desktop.session.setCamera(turned(desktop.session.camera(), UpAxis::Y, Angle::fromDegrees(70.0), Angle::fromDegrees(10.0)));
    desktop.settle();
}

/// The masked rectangles of `look` (times), the toolbars (opening a state clears the undo history) and the message bar.
std::vector<QRect> maskedToo(Desktop& desktop, Look look) {
    const auto mask = [&](const QWidget& widget) {
        look.masked.emplace_back(widget.mapTo(&desktop.window, QPoint()), widget.size());
    };
    for (const auto* bar : desktop.window.findChildren<QToolBar*>()) mask(*bar);
    mask(desktop.window.message());
    return look.masked;
}

TEST(Reopened, aLargeScreenshotBringsTheSameViewBack) {
    Desktop desktop;
    Session& session = desktop.session;
    session.slot(0).choose("frustum");
    ParameterSet parameters = session.slot(0).parameters();
    parameters.setFromText("facing", "front");
    session.slot(0).setParameters(parameters);
    session.setCamera(zoomed(turned(session.camera(), UpAxis::Y, Angle::fromDegrees(25.0), Angle::fromDegrees(-10.0)),
                             session.camera().target, 0.7, 1.0));
    desktop.settle();
    const QTemporaryDir folder;
    const QString file = screenshot(desktop, folder.path());
    const QImage saved(file);
    ASSERT_EQ(saved.size(), QSize(kUltraHd.width, kUltraHd.height));
    // The strips at the top and at the bottom state times: mask them.
    Look small{saved.scaled(kKept, Qt::IgnoreAspectRatio, Qt::SmoothTransformation).convertToFormat(QImage::Format_RGB32),
               {},
               {},
               QString::fromStdString(session.gpu()->info().renderer)};
    for (int y = 0; y < kKept.height(); y += kKept.height() - 30) small.masked.emplace_back(0, y, kKept.width(), 30);
    EXPECT_TRUE(looksAsKept(small, QStringLiteral("screenshot-4k")));

    // That the screenshot was saved is said below the views; the other window has saved none.
    for (MessageBar* bar : desktop.window.findChildren<MessageBar*>()) bar->hide();
    const Look before = desktop.look();
    const std::vector<QImage> scenes{desktop.scene(0), desktop.scene(1)};
    changeEverything(desktop);
    ASSERT_NE(session.viewCount(), 2);
    bool restored = false;
    QObject::connect(&desktop.window.document().opener(), &SessionOpener::restored, [&] { restored = true; });
    desktop.window.document().opener().open(file);
    ASSERT_TRUE(waitUntil([&] { return restored; }));
    desktop.settle();
    ASSERT_EQ(session.viewCount(), 2);
    EXPECT_EQ(session.slot(0).id(), "frustum");
    EXPECT_EQ(session.slot(0).parameters(), parameters);
    for (int view = 0; view < 2; ++view) EXPECT_EQ(desktop.scene(view), scenes[size_t(view)]) << "view " << view;
    Look after = desktop.look();
    const std::vector<QRect> masked = maskedToo(desktop, before);
    if (withoutMasked(after.picture, masked) == withoutMasked(before.picture, masked)) return;
    QDir().mkpath(writtenPicturesFolder());
    before.picture.save(writtenPicturesFolder() + QStringLiteral("/reopened-before.png"));
    after.picture.save(writtenPicturesFolder() + QStringLiteral("/reopened-after.png"));
    ADD_FAILURE() << "The window differs: see reopened-before.png and reopened-after.png in "
                  << writtenPicturesFolder().toStdString();
}

TEST(Reopened, aMalformedFileIsOneSentenceAndChangesNothing) {
    Desktop desktop;
    Session& session = desktop.session;
    const std::string before = session.slot(0).id();
    session.slot(0).choose("all");
    desktop.settle();
    desktop.window.document().undo().settle();
    const OpenedScenePointer scene = session.opened();
    const std::vector<QImage> pictures{desktop.scene(0), desktop.scene(1)};
    const QTemporaryDir folder;
    const QString file = folder.filePath(QStringLiteral("broken.obj"));
    QFile broken(file);
    ASSERT_TRUE(broken.open(QIODevice::WriteOnly));
    broken.write("v 0 0 zero\nf 1 2 99999\n");
    broken.close();
    drop(desktop.window, file);
    ASSERT_TRUE(waitUntil([&] { return desktop.window.message().isVisible() && !session.loader().loading(); }));
    desktop.settle();
    const QString said = desktop.window.message().text();
    EXPECT_TRUE(said.contains(file)) << said.toStdString();
    EXPECT_EQ(said.count(QLatin1Char('\n')), 0) << said.toStdString();
    EXPECT_EQ(session.opened(), scene);
    for (int view = 0; view < 2; ++view) EXPECT_EQ(desktop.scene(view), pictures[size_t(view)]);
    // The sentence names the temporary folder: mask it.
    Look look = desktop.look();
    const MessageBar& bar = desktop.window.message();
    look.masked.emplace_back(bar.mapTo(&desktop.window, QPoint()), bar.size());
    look.scenes.clear();
    EXPECT_TRUE(looksAsKept(look, QStringLiteral("malformed-file")));
    QTest::keyClick(&desktop.window, Qt::Key_Z, Qt::ControlModifier);
    EXPECT_TRUE(waitUntil([&] { return session.slot(0).id() == before; }));
}

}  // namespace
}  // namespace cullscope::ui::reopened_test
