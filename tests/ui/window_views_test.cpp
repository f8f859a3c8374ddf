// The views of a window: their pictures, and the effects of mouse, wheel and keys.
#include <gtest/gtest.h>

#include <QMouseEvent>
#include <QProcess>
#include <QStackedWidget>
#include <QTemporaryDir>
#include <QWindow>

#include "tests/ui/shown_window.h"
#include "ui/session/cullbench_command.h"

namespace cullscope::ui::window_views_test {
namespace {

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

TEST_F(Window, isPaintedPartByPartAndNotComposedByOpenGl) {
    // A window of another surface is drawn and swapped as a whole for each changed label and each step.
    EXPECT_EQ(window.windowHandle()->surfaceType(), QSurface::RasterSurface);
}

TEST_F(Window, picturesAreTheFramebuffersPixels) {
    window.actions().axes->trigger();  // off: the axes are painted over the picture
    const QImage shown = picture(0).grab().toImage().convertToFormat(QImage::Format_RGB888);
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

TEST_F(Window, reparentedViewsDrawTheSamePictureAgain) {
    const QImage before = picture(0).picture();
    ViewGrid& views = window.views();
    auto* stack = qobject_cast<QStackedWidget*>(views.parentWidget());
    ASSERT_TRUE(stack);
    const QSize size = views.size();
    // A top-level widget gets another OpenGL context.
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
        cullbench.start(QStringLiteral(CULLSCOPE_CULLBENCH), cullbenchArguments(picture(0).subject(), file));
        ASSERT_TRUE(cullbench.waitForFinished(kPatience));
        ASSERT_EQ(cullbench.exitCode(), 0) << cullbench.readAllStandardError().toStdString();
        EXPECT_EQ(pixelsAlone(QImage(file), QImage::Format_RGB888), picture(0).picture().convertToFormat(QImage::Format_RGB888));
    }
}

}  // namespace
}  // namespace cullscope::ui::window_views_test
