// Many views at once: sizes, metrics, turns, and no pictures of outdated requests.
#include <gtest/gtest.h>

#include <QElapsedTimer>
#include <algorithm>

#include "core/scene/camera_path.h"
#include "tests/support/long_mode.h"
#include "tests/ui/cullbench_measure.h"
#include "tests/ui/cullbench_picture.h"
#include "tests/ui/eight_views.h"

namespace cullscope::ui::eight_views_test {
namespace {

TEST_F(EightViews, picturesAreExactly320By240OnTheLeastScreenInEveryLanguage) {
    open(kScene);
    session.setViewCount(8);
    for (const char* id : {"ko", "zh_CN", "en"}) {
        language.use(QString::fromLatin1(id));
        settle();
        ASSERT_EQ(window.size(), QSize(1366, 768)) << id;
        for (int view = 0; view < 8; ++view) {
            EXPECT_EQ(session.renderSize(view), (Viewport{320, 240})) << id << " view " << view;
            EXPECT_EQ(shown(view).size(), QSize(320, 240)) << id << " view " << view;
            EXPECT_DOUBLE_EQ(picture(view).pictureLayout().scale(), 1.0);
        }
    }
}

TEST_F(EightViews, figuresOfAFixedSizeStayWhateverTheWindowAndEqualCullbenchs) {
    open(kObjects);
    session.setCamera(zoomed(session.camera(), session.camera().target, 0.3, 1.0));
    setSizes(Viewport{640, 480});
    session.slot(0).choose("frustum");
    settle();
    const QJsonObject result = measuredByCullbench(picture(0).subject(), QStringLiteral("frustum,backface"));
    const auto frame = [&](const char* strategy) { return firstFrameOf(result, strategy); };
    EXPECT_GT(frame("frustum")[QStringLiteral("covered_pixels")].toInt(), 1000);
    for (const QSize& size : {QSize(1920, 1000), QSize(1366, 768)}) {
        window.resize(size);
        for (const int count : {1, 2, 4, 8}) {
            session.setActiveView(0);
            session.setViewCount(count);
            settle();
            for (const int view : session.shownViews()) {
                const QJsonObject truth = frame(session.slot(view).id().c_str());
                if (truth.isEmpty()) continue;
                const ViewMetrics& figures = session.figures(view);
                ASSERT_EQ(figures.state, ViewMetrics::State::Ready);
                EXPECT_EQ(figures.size, (Viewport{640, 480}));
                EXPECT_EQ(double(figures.accuracy.missedPixels), truth[QStringLiteral("missed_pixels")].toDouble())
                    << session.slot(view).id() << " in " << count;
                EXPECT_EQ(double(figures.consideredTriangles), truth[QStringLiteral("considered_triangles")].toDouble());
                EXPECT_EQ(double(figures.accuracy.coveredPixels), truth[QStringLiteral("covered_pixels")].toDouble());
            }
        }
    }
}

TEST_F(EightViews, whatWasRepairedInAFileIsSaidWithCounts) {
    const QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("part.obj"));
    QFile file(path);
    ASSERT_TRUE(file.open(QIODevice::WriteOnly));
    file.write("v 0 0 0\nv 1 0 0\nv 0 1 0\nv nan 0 0\nf 1 2 3\nf 1 1 2\nf 1 2 3\nf 1 2 4\n");
    file.close();
    QSignalSpy messages(&session, &Session::messageRaised);
    openAndWait(session, path);
    ASSERT_EQ(messages.count(), 1);
    EXPECT_EQ(messages[0][0].value<Severity>(), Severity::Warning);
    const std::string said = messages[0][1].value<Message>().english();
    EXPECT_NE(said.find("degenerate 1, duplicate 1"), std::string::npos) << said;
    EXPECT_TRUE(window.message().isVisible());
}

TEST_F(EightViews, aDraggedParameterEndsWithItsLastPictureAndNothingComesAfter) {
    open(kObjects);
    session.setViewCount(8);
    session.setActiveView(0);
    setSizes(Viewport{320, 240});
    for (int view = 0; view < 8; ++view) session.slot(view).choose("frustum");
    session.setCamera(zoomed(session.camera(), session.camera().target, 0.3, 1.0));
    settle();
    // Moves a slider without a pause, in a long run for five seconds. The camera's field of view stands for all sliders besides
    // those of parameters.
    const int span = test::longMode() ? 5000 : 2000;
    QElapsedTimer clock;
    clock.start();
    std::vector<size_t> drawn;
    for (int step = 0; clock.elapsed() < span; ++step) {
        for (int view = 0; view < 8; ++view) {
            ParameterSet parameters = session.slot(view).parameters();
            parameters.setFromText("box", (step + view) % 2 == 0 ? "length" : "p-vertex");
            session.slot(view).setParameters(parameters);
        }
        Camera camera = session.camera();
        camera.fovy = Angle::fromDegrees(30.0 + step % 50);
        session.setCamera(camera);
        QTest::qWait(10);
    }
    // The strategy with the last parameters is built in the background; its pictures are the last ones.
    EXPECT_TRUE(waitUntil([&] {
        for (int view = 0; view < 8; ++view)
            if (session.slot(view).building() || !picture(view).pictureIsCurrent()) return false;
        return !session.pictures()->busy();
    }));
    for (int view = 0; view < 8; ++view) drawn.push_back(picture(view).drawnPictures());
    settle();
    QTest::qWait(300);
    for (int view = 0; view < 8; ++view) {
        EXPECT_EQ(picture(view).drawnPictures(), drawn[size_t(view)]) << "a picture came late in view " << view;
        EXPECT_TRUE(picture(view).pictureIsCurrent());
    }
    for (int view = 0; view < 8; ++view)
        EXPECT_EQ(pixelsAlone(shown(view), QImage::Format_RGB888), cullbenchPicture(picture(view).subject())) << "view " << view;
}

TEST_F(EightViews, theActiveViewComesFirstAndNoViewStarves) {
    open(kScene);
    session.setViewCount(8);
    session.setActiveView(5);
    settle();
    std::vector<int> order;
    const QMetaObject::Connection seen =
        QObject::connect(&session, &Session::pictureChanged, [&](int view) { order.push_back(view); });
    session.setCamera(turned(session.camera(), UpAxis::Y, Angle::fromDegrees(5.0), {}));
    ASSERT_TRUE(waitUntil([&] { return !session.pictures()->busy(); }));
    ASSERT_EQ(order.size(), 8u) << "each view is drawn once";
    EXPECT_TRUE(order[0] == 5 || order[1] == 5);
    // The camera moves with every picture that arrives, so that few are drawn of one camera, however slow the machine is.
    order.clear();
    const auto move = [&] { session.setCamera(turned(session.camera(), UpAxis::Y, Angle::fromDegrees(1.0), {})); };
    const QMetaObject::Connection moving =
        QObject::connect(&session, &Session::pictureChanged, &session, move, Qt::QueuedConnection);
    move();
    ASSERT_TRUE(waitUntil([&] { return order.size() >= 60; }));
    QObject::disconnect(moving);
    QObject::disconnect(seen);
    const auto pictures = [&](int view) { return std::count(order.begin(), order.end(), view); };
    for (int view = 0; view < 8; ++view) {
        EXPECT_GT(pictures(view), 0) << "view " << view << " was never drawn while the camera moved";
        if (view == 5) continue;
        EXPECT_GT(pictures(5), pictures(view)) << "view " << view << " is drawn as often as the active one";
    }
}

TEST_F(EightViews, hidingAnObjectTakesItOutOfPictureTruthAndCounts) {
    open(kObjects);
    session.setViewCount(2);
    session.setLinked(1);
    settle();
    const uint64_t all = session.figures(0).sceneTriangles;
    const uint64_t covered = session.figures(0).accuracy.coveredPixels;
    std::vector<bool> hidden(session.opened()->scene->instances().size(), false);
    for (size_t i = 0; i < hidden.size() / 2; ++i) hidden[i] = true;
    session.setHidden(hidden);
    settle();
    EXPECT_LT(session.figures(0).sceneTriangles, all);
    EXPECT_LT(session.figures(0).accuracy.coveredPixels, covered);
    EXPECT_EQ(session.figures(0).lostPixels(), 0u);
    EXPECT_TRUE(window.views().pane(0).chipText().contains(QStringLiteral("hidden")));
    hidden.assign(hidden.size(), true);
    session.setHidden(hidden);
    ASSERT_TRUE(waitUntil([&] { return session.metricsSettled() && !session.pictures()->busy(); }));
    EXPECT_EQ(session.figures(0).accuracy.coveredPixels, 0u);
    hidden.assign(hidden.size(), false);
    session.setHidden(hidden);
    settle();
    EXPECT_EQ(session.figures(0).accuracy.coveredPixels, covered);
}

}  // namespace
}  // namespace cullscope::ui::eight_views_test
