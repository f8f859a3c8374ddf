#include <gtest/gtest.h>

#include <QApplication>
#include <QComboBox>
#include <QMimeData>
#include <QProcess>
#include <QTabBar>
#include <QTabWidget>
#include <QTemporaryDir>
#include <QWheelEvent>

#include "core/gpu/framebuffer.h"
#include "core/measure/frame.h"
#include "tests/ui/test_scene.h"
#include "ui/startup/start_size.h"
#include "ui/startup/window_picture.h"
#include "ui/window/main_window.h"

namespace cullscope::ui {
namespace {

/// A shown window on a small scene, its figures known.
struct Window : ::testing::Test {
    void SetUp() override {
        window.resize(1000, 700);
        window.show();
        ASSERT_TRUE(QTest::qWaitForWindowExposed(&window, kPatience));
        openAndWait(session, QStringLiteral("torus:triangles=2000"));
        settle();
    }

    void settle() {
        ASSERT_TRUE(waitUntil([&] { return session.buffers() && session.figuresSettled(); }));
        QApplication::processEvents();
    }

    SceneView& picture(int view) { return window.views().pane(view).picture(); }

    void turnWheel(int notches, Qt::KeyboardModifiers modifiers, const QPointF& position) {
        QWheelEvent event(position, picture(0).mapToGlobal(position), {}, {0, 120 * notches}, Qt::NoButton, modifiers,
                          Qt::NoScrollPhase, false);
        QApplication::sendEvent(&picture(0), &event);
    }

    Session session{sessionOptions(true)};
    Language language;
    Appearance appearance;
    MainWindow window{session, language, appearance};
};

TEST_F(Window, headersShowStrategyPromiseAndFigures) {
    const ViewHeader& header = window.views().pane(1).header();
    EXPECT_EQ(header.firstLine().toStdString(), "Back-face culling: lossless");
    EXPECT_TRUE(header.secondLine().endsWith(QStringLiteral(" missed"))) << header.secondLine().toStdString();
    session.setCamera(turned(session.camera(), UpAxis::Y, Angle::fromDegrees(10.0), {}));
    EXPECT_EQ(header.secondLine(), QStringLiteral("…"));
    settle();
    EXPECT_TRUE(header.secondLine().endsWith(QStringLiteral(" missed")));
    EXPECT_EQ(session.figures(1).lostPixels(), 0u);
    EXPECT_TRUE(window.views().pane(0).header().secondLine().endsWith(QStringLiteral(" % · 0 missed")));
}

TEST_F(Window, viewsHaveTheSameSize) {
    for (const int width : {1001, 1366, 1000}) {
        window.resize(width, 700);
        QApplication::processEvents();
        EXPECT_EQ(picture(0).renderSize(), picture(1).renderSize());
    }
}

TEST_F(Window, picturesAreTheFramebuffersPixels) {
    window.actions().axes->trigger();  // they are painted over the picture
    const QImage shown = picture(0).grabFramebuffer().convertToFormat(QImage::Format_RGB888);
    const QImage drawn = picture(0).picture().convertToFormat(QImage::Format_RGB888);
    ASSERT_EQ(shown.size(), drawn.size());
    EXPECT_EQ(shown, drawn);
    int covered = 0;
    for (int y = 0; y < drawn.height(); ++y)
        for (int x = 0; x < drawn.width(); ++x) covered += drawn.pixel(x, y) != drawn.pixel(0, 0) ? 1 : 0;
    EXPECT_GT(covered, 1000);
}

TEST_F(Window, viewsThatAreNotDirtyAreNotDrawn) {
    session.slot(1).choose("frustum");
    settle();
    const size_t first = picture(0).drawnPictures();
    const size_t second = picture(1).drawnPictures();
    ParameterSet parameters = session.slot(1).parameters();
    parameters.setFromText("box", "length");
    session.slot(1).setParameters(parameters);
    settle();
    ASSERT_TRUE(waitUntil([&] { return picture(1).drawnPictures() > second; }));
    EXPECT_EQ(picture(0).drawnPictures(), first);
}

TEST_F(Window, leftDragTurnsAndAClickDoesNot) {
    const Camera before = session.camera();
    QTest::mousePress(&picture(0), Qt::LeftButton, {}, {100, 100});
    QTest::mouseMove(&picture(0), {102, 101});
    QTest::mouseRelease(&picture(0), Qt::LeftButton, {}, {102, 101});
    EXPECT_EQ(session.camera(), before);
    EXPECT_EQ(session.activeView(), 0);
    const QPointF from(100, 100);
    const QPointF to(160, 120);
    const auto send = [&](QEvent::Type type, const QPointF& position, Qt::MouseButton button, Qt::MouseButtons buttons) {
        QMouseEvent event(type, position, picture(0).mapToGlobal(position), button, buttons, {});
        QApplication::sendEvent(&picture(0), &event);
    };
    send(QEvent::MouseButtonPress, from, Qt::LeftButton, Qt::LeftButton);
    send(QEvent::MouseMove, to, Qt::NoButton, Qt::LeftButton);
    send(QEvent::MouseButtonRelease, to, Qt::LeftButton, {});
    EXPECT_NE(session.camera().eye, before.eye);
    EXPECT_EQ(session.camera().target, before.target);
    session.goHome();
    EXPECT_EQ(session.camera().eye, before.eye);
}

TEST_F(Window, wheelZoomsLensAndNearPlaneSayThatTheyChanged) {
    const Camera before = session.camera();
    turnWheel(1, {}, {100, 100});
    EXPECT_LT(glm::length(session.camera().eye - session.camera().target), glm::length(before.eye - before.target));
    ViewPane& pane = window.views().pane(0);
    EXPECT_TRUE(pane.chipText().isEmpty());
    turnWheel(2, Qt::ShiftModifier, {100, 100});
    EXPECT_LT(session.camera().fovy, before.fovy);
    EXPECT_TRUE(pane.chipText().contains(QStringLiteral("field of view")));
    turnWheel(1, Qt::ControlModifier, {100, 100});
    EXPECT_TRUE(pane.chipText().contains(QStringLiteral("near plane")));
    session.goHome();
    EXPECT_TRUE(pane.chipText().isEmpty());
    EXPECT_EQ(session.camera(), before);
}

TEST_F(Window, doubleClickSetsTheCentreOfRotationOnTheSurface) {
    QPointF middle(picture(0).width() / 2.0, picture(0).height() / 2.0);
    while (middle.x() > 0.0 && !picture(0).surfaceAt(middle)) middle.rx() -= 10.0;
    ASSERT_GT(middle.x(), 0.0);
    const Vec3 point = picture(0).pointAt(middle.toPoint());
    QTest::mouseDClick(&picture(0), Qt::LeftButton, {}, middle.toPoint());
    EXPECT_NEAR(glm::length(session.camera().target - point), 0.0, 0.05);
}

TEST_F(Window, keyboardAloneTurnsZoomsAndSwitchesViews) {
    picture(0).setFocus();
    const Camera before = session.camera();
    QTest::keyClick(&picture(0), Qt::Key_Left);
    EXPECT_NE(session.camera().eye, before.eye);
    QTest::keyClick(&picture(0), Qt::Key_Plus);
    EXPECT_LT(glm::length(session.camera().eye - session.camera().target), glm::length(before.eye - before.target));
    window.actions().oneView->trigger();
    EXPECT_EQ(session.viewCount(), 1);
    window.actions().twoViews->trigger();
    EXPECT_EQ(session.viewCount(), 2);
    window.actions().home->trigger();
    EXPECT_EQ(session.camera().target, before.target);
}

TEST_F(Window, anotherLanguageKeepsTheState) {
    session.slot(0).choose("all");
    // A camera that the user has moved stays even where longer words change the size of the views.
    session.setCamera(turned(session.camera(), UpAxis::Y, Angle::fromDegrees(10.0), {}));
    settle();
    const Camera camera = session.camera();
    const OpenedScenePointer scene = session.opened();
    for (const char* id : {"ko", "zh_CN", "en"}) {
        language.use(QString::fromLatin1(id));
        QApplication::processEvents();
        EXPECT_EQ(session.slot(0).id(), "all");
        EXPECT_EQ(session.camera(), camera);
        EXPECT_EQ(session.opened(), scene);
        const QString line = window.views().pane(0).header().firstLine();
        if (QLatin1String(id) == QLatin1String("ko")) {
            EXPECT_EQ(line, QStringLiteral("모든 삼각형: 무손실"));
            EXPECT_EQ(window.actions().open->text(), QStringLiteral("열기(&O)…"));
        }
        if (QLatin1String(id) == QLatin1String("zh_CN")) {
            EXPECT_EQ(line, QStringLiteral("所有三角形：无损"));
        }
        if (QLatin1String(id) == QLatin1String("en")) {
            EXPECT_EQ(line, QStringLiteral("All triangles: lossless"));
        }
    }
}

TEST_F(Window, messagesAreShownInTheLanguageOfTheWindow) {
    language.use(QStringLiteral("ko"));
    openAndWait(session, QStringLiteral("/nonexistent/file.obj"));
    QApplication::processEvents();
    EXPECT_TRUE(window.message().isVisible());
    EXPECT_TRUE(window.message().text().contains(QStringLiteral("파일을 열 수 없습니다")))
        << window.message().text().toStdString();
    EXPECT_TRUE(window.message().text().contains(QStringLiteral("/nonexistent/file.obj")));
    language.use(QStringLiteral("en"));
}

TEST_F(Window, choosingAStrategyChangesTheActiveViewOnly) {
    session.setActiveView(0);
    QComboBox& choice = window.strategyPanel().choice();
    choice.setCurrentIndex(choice.findData(QStringLiteral("frustum"), StrategyModel::IdRole));
    emit choice.activated(choice.currentIndex());
    EXPECT_EQ(session.slot(0).id(), "frustum");
    EXPECT_EQ(session.slot(1).id(), "backface");
}

TEST_F(Window, reparentedViewsDrawTheSamePictureAgain) {
    const QImage before = picture(0).picture();
    ViewGrid& views = window.views();
    auto* stack = qobject_cast<QStackedWidget*>(views.parentWidget());
    ASSERT_TRUE(stack);
    const QSize size = views.size();
    // A window of its own has another OpenGL context.
    views.setParent(nullptr);
    views.resize(size);
    views.show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(&views, kPatience));
    settle();
    EXPECT_EQ(picture(0).picture(), before);
    stack->addWidget(&views);
    stack->setCurrentWidget(&views);
    settle();
    EXPECT_EQ(picture(0).picture(), before);
}

TEST_F(Window, aDoubleClickBesideTheMeshKeepsTheCentre) {
    const Camera before = session.camera();
    ASSERT_FALSE(picture(0).surfaceAt({3.0, 3.0}));
    QTest::mouseDClick(&picture(0), Qt::LeftButton, {}, {3, 3});
    EXPECT_EQ(session.camera(), before);
}

TEST_F(Window, aMessageKeepsTheSizeOfTheViewsAndTheFigures) {
    const Viewport size = picture(0).renderSize();
    const Camera camera = session.camera();
    openAndWait(session, QStringLiteral("/nonexistent/file.obj"));
    QApplication::processEvents();
    ASSERT_TRUE(window.message().isVisible());
    EXPECT_EQ(picture(0).renderSize(), size);
    EXPECT_EQ(session.camera(), camera);
    EXPECT_EQ(session.figures(0).state, Figures::State::Ready);
    EXPECT_EQ(session.figures(1).state, Figures::State::Ready);
    // It lies inside the middle of the window, wherever that ends.
    window.resize(900, 650);
    QApplication::processEvents();
    EXPECT_TRUE(window.message().parentWidget()->rect().contains(window.message().geometry()));
}

TEST_F(Window, activatingAViewWithManyParametersKeepsTheSizeOfTheWindow) {
    session.slot(0).choose("frustum");
    window.resize(900, 420);
    settle();
    EXPECT_EQ(window.size(), QSize(900, 420));
    const Viewport size = picture(0).renderSize();
    for (const int view : {0, 1, 0}) {
        session.setActiveView(view);
        QApplication::processEvents();
        QTest::qWait(50);
        EXPECT_EQ(window.size(), QSize(900, 420));
        EXPECT_EQ(picture(0).renderSize(), size);
        EXPECT_EQ(session.figures(0).state, Figures::State::Ready);
    }
}

TEST_F(Window, theTabBarHasANameAndItsPlaceInTheOrderOfTab) {
    window.side().setOpenPage(0);
    session.setActiveView(0);
    session.slot(0).choose("frustum");
    const auto* parameter = window.strategyPanel().form().findChild<QWidget*>(QStringLiteral("box"));
    ASSERT_TRUE(parameter);
    ASSERT_TRUE(waitUntil([&] { return parameter->isVisible(); }));
    QWidget* choice = &window.strategyPanel().choice();
    std::vector<QWidget*> stops;
    QWidget* widget = choice;
    do {
        if ((widget->focusPolicy() & Qt::TabFocus) != 0 && !widget->focusProxy() && widget->isVisible()) stops.push_back(widget);
        widget = widget->nextInFocusChain();
    } while (widget != choice);
    const auto place = [&](const QWidget* wanted) { return std::find(stops.begin(), stops.end(), wanted) - stops.begin(); };
    EXPECT_LT(place(choice), place(parameter));
    EXPECT_LT(place(parameter), place(window.tabs().tabBar()));
    EXPECT_LT(place(window.tabs().tabBar()), place(&window.figures().table()));
    EXPECT_LT(place(&window.figures().table()), std::ptrdiff_t(stops.size()));
    EXPECT_FALSE(window.tabs().tabBar()->accessibleName().isEmpty());
}

TEST_F(Window, theWheelOverTheDockKeepsTheStrategy) {
    QComboBox& choice = window.strategyPanel().choice();
    picture(0).setFocus();
    const int before = choice.currentIndex();
    QWheelEvent event({5.0, 5.0}, choice.mapToGlobal(QPointF(5.0, 5.0)), {}, {0, -120}, Qt::NoButton, {}, Qt::NoScrollPhase,
                      false);
    QApplication::sendEvent(&choice, &event);
    EXPECT_EQ(choice.currentIndex(), before);
}

TEST_F(Window, theCopiedCommandDrawsTheSamePicture) {
    for (const char* strategy : {"backface", "all"}) {
        session.slot(0).choose(strategy);
        session.setCamera(zoomed(turned(session.camera(), UpAxis::Y, Angle::fromDegrees(33.3), Angle::fromDegrees(7.7)),
                                 session.camera().target, 0.8, 1.0));
        settle();
        const QTemporaryDir folder;
        const QString file = folder.filePath(QStringLiteral("view.png"));
        QProcess cullbench;
        cullbench.setWorkingDirectory(folder.path());
        cullbench.start(QStringLiteral(CULLSCOPE_CULLBENCH), cullbenchArguments(picture(0).request(), file));
        ASSERT_TRUE(cullbench.waitForFinished(kPatience));
        ASSERT_EQ(cullbench.exitCode(), 0) << cullbench.readAllStandardError().toStdString();
        EXPECT_EQ(pixelsAlone(QImage(file), QImage::Format_RGB888), picture(0).picture().convertToFormat(QImage::Format_RGB888));
    }
}

TEST(FileDialog, typesHaveNamesBesideTheirPatterns) {
    const QString meshes = DocumentCommands::fileTypes().section(QStringLiteral(";;"), 0, 0);
    EXPECT_TRUE(meshes.startsWith(QStringLiteral("Meshes (obj, "))) << meshes.toStdString();
    EXPECT_TRUE(meshes.contains(QStringLiteral(" (*.obj *.OBJ "))) << meshes.toStdString();
}

TEST(StartSize, theWindowFitsTheScreenWithItsFrame) {
    const QMargins frame(4, 40, 4, 4);
    const QSize wanted(1366, 768);
    const Start small = startOn({0, 0, 1366, 768}, frame, wanted);
    EXPECT_TRUE(small.maximized);
    EXPECT_EQ(small.size, QSize(1358, 724));
    // What Qt makes of 1366x768 at a scale of 1.5.
    EXPECT_EQ(startOn({0, 0, 911, 512}, frame, wanted).size, QSize(903, 468));
    const Start large = startOn({0, 27, 1920, 1053}, frame, wanted);
    EXPECT_FALSE(large.maximized);
    EXPECT_EQ(large.size, wanted);
}

TEST_F(Window, theLeastSizeFitsASmallScaledScreen) {
    // The window at 1366x768 and a scale of 1.5 leaves 911x472.
    EXPECT_LE(window.minimumSizeHint().width(), 900);
    EXPECT_LE(window.minimumSizeHint().height(), 400);
}

TEST_F(Window, thePictureOfALargeSceneIsTakenOnceItIsDrawn) {
    const QTemporaryDir folder;
    const QString file = folder.filePath(QStringLiteral("window.png"));
    int status = -1;
    // Figures of so many triangles are made on request alone.
    session.open(QStringLiteral("sphere:triangles=5.1e6"));
    WindowPicture shot(window, session, file);
    QObject::connect(&shot, &WindowPicture::done, [&](int result) { status = result; });
    ASSERT_TRUE(waitUntil([&] { return status >= 0; }));
    ASSERT_EQ(status, 0);
    ASSERT_EQ(session.figures(0).state, Figures::State::OnRequest);
    const QPoint middle = picture(0).mapTo(&window, picture(0).rect().center());
    const QPoint corner = picture(0).mapTo(&window, picture(0).rect().topRight() + QPoint(-4, 4));
    const QImage saved(file);
    EXPECT_NE(saved.pixelColor(middle * window.devicePixelRatioF()), saved.pixelColor(corner * window.devicePixelRatioF()));
}

TEST_F(Window, pictureOfTheWindowIsSaved) {
    const QTemporaryDir folder;
    const QString file = folder.filePath(QStringLiteral("window.png"));
    int status = -1;
    WindowPicture shot(window, session, file);
    QObject::connect(&shot, &WindowPicture::done, [&](int result) { status = result; });
    ASSERT_TRUE(waitUntil([&] { return status >= 0; }));
    EXPECT_EQ(status, 0);
    EXPECT_EQ(QImage(file).size(), window.size() * window.devicePixelRatioF());
}

}  // namespace
}  // namespace cullscope::ui
