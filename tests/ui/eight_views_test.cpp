// What issue 3 asks of the views: sizes, turns, roles, and that nothing is shown that nobody wants any more.
#include <gtest/gtest.h>

#include <QApplication>
#include <QElapsedTimer>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QMouseEvent>
#include <QProcess>
#include <QTemporaryDir>

#include "core/scene/camera_path.h"
#include "tests/ui/cullbench_picture.h"
#include "ui/session/object_pick.h"
#include "ui/window/main_window.h"

namespace cullscope::ui {
namespace {

struct EightViews : ::testing::Test {
    void SetUp() override {
        window.resize(1366, 768);
        window.show();
        ASSERT_TRUE(QTest::qWaitForWindowExposed(&window, kPatience));
    }

    void open(const QString& scene) {
        openAndWait(session, scene);
        settle();
    }

    void settle() {
        ASSERT_TRUE(waitUntil([&] { return session.buffers() && session.figuresSettled() && !session.pictures()->busy(); }));
        QApplication::processEvents();
    }

    SceneView& picture(int view) { return window.views().pane(view).picture(); }
    QImage shown(int view) { return session.picture(view)->colour; }

    void setSizes(const std::optional<Viewport>& size) {
        for (int view = 0; view < Session::kMostViews; ++view) {
            ViewSetup setup = session.setup(view);
            setup.size = size;
            session.setSetup(view, setup);
        }
    }

    void drag(int view, const QPoint& way, int steps) {
        QWidget& widget = picture(view);
        const QPointF from(widget.width() / 2.0, widget.height() / 2.0);
        const auto send = [&](QEvent::Type type, const QPointF& at, Qt::MouseButton button, Qt::MouseButtons buttons) {
            QMouseEvent event(type, at, widget.mapToGlobal(at), button, buttons, {});
            QApplication::sendEvent(&widget, &event);
        };
        send(QEvent::MouseButtonPress, from, Qt::LeftButton, Qt::LeftButton);
        for (int step = 1; step <= steps; ++step) {
            send(QEvent::MouseMove, from + QPointF(way) * step / steps, Qt::NoButton, Qt::LeftButton);
            QApplication::processEvents();
        }
        send(QEvent::MouseButtonRelease, from + QPointF(way), Qt::LeftButton, {});
    }

    Session session{sessionOptions(true)};
    Language language;
    Appearance appearance;
    MainWindow window{session, language, appearance};
};

const QString kScene = QStringLiteral("star:seed=7,triangles=20000");
const QString kObjects = QStringLiteral("split:mesh=star:seed=7,triangles=20000,by=clusters,triangles=500");

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

/// What `cullbench measure` says of a strategy at one camera.
QJsonObject measured(const PictureRequest& request, const QString& strategies) {
    const QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("path.json")), json = folder.filePath(QStringLiteral("out.json"));
    writeCameraPath(path.toStdString(), {"pose",
                                         request.camera.fovy,
                                         request.camera.nearDistance,
                                         request.camera.farDistance,
                                         {{request.camera.eye, request.camera.target, request.camera.up}}});
    QProcess cullbench;
    cullbench.start(QStringLiteral(CULLSCOPE_CULLBENCH),
                    {QStringLiteral("measure"), QString::fromStdString(request.scene), QStringLiteral("-s"), strategies,
                     QStringLiteral("--path"), path, QStringLiteral("--size"),
                     QStringLiteral("%1x%2").arg(request.size.width).arg(request.size.height), QStringLiteral("--repeat"),
                     QStringLiteral("1"), QStringLiteral("--json"), json});
    EXPECT_TRUE(cullbench.waitForFinished(kPatience));
    QFile file(json);
    EXPECT_TRUE(file.open(QIODevice::ReadOnly)) << cullbench.readAllStandardError().toStdString();
    return QJsonDocument::fromJson(file.readAll()).object();
}

TEST_F(EightViews, figuresOfAFixedSizeStayWhateverTheWindowAndEqualCullbenchs) {
    open(kObjects);
    session.setCamera(zoomed(session.camera(), session.camera().target, 0.3, 1.0));
    setSizes(Viewport{640, 480});
    session.slot(0).choose("frustum");
    settle();
    const QJsonObject result = measured(picture(0).request(), QStringLiteral("frustum,backface"));
    const QJsonArray runs = result[QStringLiteral("runs")].toArray();
    const auto frame = [&](const char* strategy) {
        for (const auto& run : runs)
            if (run.toObject()[QStringLiteral("strategy")].toString() == QLatin1String(strategy))
                return run.toObject()[QStringLiteral("frames")].toArray().at(0).toObject();
        return QJsonObject();
    };
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
                const Figures& figures = session.figures(view);
                ASSERT_EQ(figures.state, Figures::State::Ready);
                EXPECT_EQ(figures.size, (Viewport{640, 480}));
                EXPECT_EQ(double(figures.accuracy.missedPixels), truth[QStringLiteral("missed_pixels")].toDouble())
                    << session.slot(view).id() << " in " << count;
                EXPECT_EQ(double(figures.consideredTriangles), truth[QStringLiteral("considered_triangles")].toDouble());
                EXPECT_EQ(double(figures.accuracy.coveredPixels), truth[QStringLiteral("covered_pixels")].toDouble());
            }
        }
    }
}

TEST_F(EightViews, freezingKeepsFiguresAndNeighboursWhileTheViewFlies) {
    open(kScene);
    session.setViewCount(4);
    session.setActiveView(1);
    session.slot(1).choose("backface");
    session.setCamera(zoomed(session.camera(), session.camera().target, 0.6, 1.0));
    settle();
    std::vector<QImage> before;
    for (int view = 0; view < 4; ++view) before.push_back(shown(view));
    const Figures figures = session.figures(1);
    window.actions().freeze->trigger();
    settle();
    EXPECT_EQ(shown(1), before[1]) << "freezing alone changes nothing";
    session.setViewingCamera(1, turned(session.viewingCamera(1), UpAxis::Y, Angle::fromDegrees(90.0), {}));
    settle();
    EXPECT_NE(shown(1), before[1]);
    for (const int view : {0, 2, 3}) EXPECT_EQ(shown(view), before[size_t(view)]) << "view " << view;
    EXPECT_EQ(session.figures(1).consideredTriangles, figures.consideredTriangles);
    EXPECT_EQ(session.figures(1).accuracy.missedPixels, figures.accuracy.missedPixels);
    EXPECT_EQ(session.figures(1).frameMilliseconds, figures.frameMilliseconds) << "measured anew although nothing changed";
    EXPECT_TRUE(window.views().pane(1).chipText().contains(QStringLiteral("frozen")));
    EXPECT_TRUE(window.views().pane(1).header().firstLine().contains(QStringLiteral("frozen")));
    // The linked camera goes on without it.
    const QImage frozen = shown(1);
    session.setCamera(turned(session.camera(), UpAxis::Y, Angle::fromDegrees(20.0), {}));
    settle();
    EXPECT_EQ(shown(1), frozen);
    EXPECT_NE(shown(0), before[0]);
    window.actions().freeze->trigger();
    settle();
    EXPECT_EQ(session.setup(1).role, Role::Linked);
}

TEST_F(EightViews, anotherLayoutKeepsWhatAFrozenViewCulls) {
    open(kObjects);
    session.slot(0).choose("frustum");
    session.setActiveView(0);
    session.setCamera(zoomed(session.camera(), session.camera().target, 0.3, 1.0));
    settle();
    session.setFrozen(0, true);
    settle();
    const Figures before = session.figures(0);
    ASSERT_LT(before.consideredTriangles, before.sceneTriangles);
    for (const int count : {1, 8, 2}) {
        session.setViewCount(count);
        window.resize(1366, count == 8 ? 700 : 768);
        settle();
        EXPECT_EQ(session.figures(0).consideredTriangles, before.consideredTriangles) << count;
        EXPECT_EQ(session.figures(0).accuracy.coveredPixels, before.accuracy.coveredPixels) << count;
        EXPECT_EQ(session.figures(0).frameMilliseconds, before.frameMilliseconds) << "measured anew";
        EXPECT_EQ(session.viewRequest(0)->cullingSize, before.size) << count;
    }
}

TEST_F(EightViews, aWatchedViewThatIsNotShownKeepsItsShape) {
    open(kObjects);
    session.slot(0).choose("frustum");
    session.setCamera(zoomed(session.camera(), session.camera().target, 0.3, 1.0));
    session.observe(1, 0);
    settle();
    const uint64_t before = session.figures(1).consideredTriangles;
    session.setActiveView(1);
    session.setViewCount(1);
    settle();
    EXPECT_EQ(session.figures(1).consideredTriangles, before);
}

TEST_F(EightViews, aPickIsMarkedInEveryLinkedPicture) {
    open(kObjects);
    session.setLinked(1);
    settle();
    const QImage before[2] = {picture(0).grabFramebuffer(), picture(1).grabFramebuffer()};
    QTest::mouseClick(&picture(0), Qt::LeftButton, {}, QPoint(picture(0).width() / 2, picture(0).height() / 2));
    ASSERT_TRUE(waitUntil([&] { return session.pick().has_value(); }));
    EXPECT_EQ(window.inside().tabs().currentWidget(), &window.inside().why());
    for (const int view : {0, 1}) EXPECT_NE(picture(view).grabFramebuffer(), before[view]) << view;
    // What the tree or a list picks is marked too, and leaves the tab as it is.
    window.inside().tabs().setCurrentIndex(0);
    const QImage marked = picture(1).grabFramebuffer();
    pickObject(session, session.pick()->object == 0 ? 1 : 0);
    EXPECT_NE(picture(1).grabFramebuffer(), marked);
    EXPECT_EQ(window.inside().tabs().currentIndex(), 0) << "walking through the tree jumped to Why at every row";
}

TEST_F(EightViews, flyingWithTheRightButtonOpensNoMenu) {
    open(kScene);
    QSignalSpy menus(&picture(0), &SceneView::menuRequested);
    const QPoint middle(picture(0).width() / 2, picture(0).height() / 2);
    picture(0).setFocus();
    const Camera before = session.camera();
    QTest::mousePress(&picture(0), Qt::RightButton, {}, middle);
    QTest::keyPress(&picture(0), Qt::Key_W);
    ASSERT_TRUE(waitUntil([&] { return !(session.camera() == before); }));
    QTest::keyRelease(&picture(0), Qt::Key_W);
    QTest::mouseRelease(&picture(0), Qt::RightButton, {}, middle);
    EXPECT_EQ(menus.count(), 0);
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

TEST_F(EightViews, whatAFrozenFrustumLeftOutIsAHole) {
    open(kObjects);
    session.setActiveView(0);
    session.slot(0).choose("frustum");
    session.setCamera(zoomed(session.camera(), session.camera().target, 0.25, 1.0));
    settle();
    ASSERT_LT(session.figures(0).consideredTriangles, session.figures(0).sceneTriangles);
    session.setFrozen(0, true);
    session.setViewingCamera(0, framed(session.viewingCamera(0), UpAxis::Y, session.scene()->boundingSphere(), 4.0 / 3.0));
    settle();
    const QImage holes = shown(0);
    const uint64_t before = session.picture(0)->consideredTriangles;
    session.setFrozen(0, false);
    session.setCamera(framed(session.camera(), UpAxis::Y, session.scene()->boundingSphere(), 4.0 / 3.0));
    settle();
    EXPECT_LT(before, session.picture(0)->consideredTriangles);
    EXPECT_NE(holes, shown(0));
}

TEST_F(EightViews, aDraggedParameterEndsWithItsLastPictureAndNothingComesAfter) {
    open(kObjects);
    session.setViewCount(8);
    session.setActiveView(0);
    setSizes(Viewport{320, 240});
    for (int view = 0; view < 8; ++view) session.slot(view).choose("frustum");
    session.setCamera(zoomed(session.camera(), session.camera().target, 0.3, 1.0));
    settle();
    // Five seconds of a slider that is never still; the camera's lens stands for any of them beside the strategy's parameter.
    QElapsedTimer clock;
    clock.start();
    std::vector<size_t> drawn;
    for (int step = 0; clock.elapsed() < 5000; ++step) {
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
    const int current = int(clock.elapsed());
    EXPECT_GE(current, 5000);
    // The last parameters are built beside the window; their pictures are the last ones.
    EXPECT_TRUE(waitUntil([&] {
        for (int view = 0; view < 8; ++view)
            if (session.slot(view).building()) return false;
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
        EXPECT_EQ(pixelsAlone(shown(view), QImage::Format_RGB888), cullbenchPicture(picture(view).request())) << "view " << view;
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
    order.clear();
    for (int i = 0; order.size() < 40; ++i) {
        session.setCamera(turned(session.camera(), UpAxis::Y, Angle::fromDegrees(1.0), {}));
        QTest::qWait(1);
    }
    QObject::disconnect(seen);
    for (int view = 0; view < 8; ++view)
        EXPECT_GT(std::count(order.begin(), order.end(), view), 0)
            << "view " << view << " was never drawn while the camera moved";
    EXPECT_GE(std::count(order.begin(), order.end(), 5), 15);
}

TEST_F(EightViews, anObserverShowsTheVerdictsOfAnotherViewFromItsOwnCamera) {
    open(kObjects);
    session.slot(0).choose("frustum");
    session.setCamera(zoomed(session.camera(), session.camera().target, 0.25, 1.0));
    session.observe(1, 0);
    ViewSetup setup = session.setup(1);
    setup.look = {Colouring::Verdicts, true, true, false};
    session.setSetup(1, setup);
    settle();
    EXPECT_EQ(session.culledBy(1), 0);
    EXPECT_NE(session.viewingCamera(1).eye, session.camera().eye);
    EXPECT_EQ(session.figures(1).consideredTriangles, session.figures(0).consideredTriangles);
    ASSERT_TRUE(session.picture(1)->request.states) << "verdicts against the truth, once it is known";
    const QImage before = shown(0);
    const Figures figures = session.figures(0);
    session.setActiveView(1);
    drag(1, {80, 30}, 5);
    settle();
    EXPECT_EQ(shown(0), before) << "turning the observer moved what it watches";
    EXPECT_EQ(session.figures(0).frameMilliseconds, figures.frameMilliseconds);
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
    ASSERT_TRUE(waitUntil([&] { return session.figuresSettled() && !session.pictures()->busy(); }));
    EXPECT_EQ(session.figures(0).accuracy.coveredPixels, 0u);
    hidden.assign(hidden.size(), false);
    session.setHidden(hidden);
    settle();
    EXPECT_EQ(session.figures(0).accuracy.coveredPixels, covered);
}

TEST_F(EightViews, aClickPicksAndADragDoesNot) {
    open(kObjects);
    session.setViewCount(2);
    QPointF middle(picture(0).width() / 2.0, picture(0).height() / 2.0);
    ASSERT_TRUE(picture(0).surfaceAt(middle));
    QTest::mouseClick(&picture(0), Qt::LeftButton, {}, middle.toPoint());
    ASSERT_TRUE(waitUntil([&] { return session.pick().has_value(); }));
    const Pick pick = *session.pick();
    EXPECT_EQ(session.opened()->scene->instanceOf(pick.triangle), pick.object);
    EXPECT_NEAR(glm::length(pick.point - *picture(0).surfaceAt(middle)), 0.0, 0.05);
    drag(0, {60, 0}, 4);
    QTest::qWait(100);
    EXPECT_EQ(session.pick(), pick);
    QTest::mouseClick(&picture(0), Qt::LeftButton, {}, QPoint(2, 2));
    EXPECT_TRUE(waitUntil([&] { return !session.pick(); })) << "a click beside the scene picks nothing";
}

TEST_F(EightViews, aWipeShowsTheTruthOnTheLeftAndItsLineIsDragged) {
    open(kScene);
    session.setLinked(1);
    session.setActiveView(0);
    window.actions().truth->trigger();
    settle();
    const ViewPicturePointer shownPicture = session.picture(0);
    ASSERT_FALSE(shownPicture->other.isNull());
    EXPECT_EQ(shownPicture->missed, session.figures(0).accuracy.missedPixels);
    const size_t drawn = picture(0).drawnPictures();
    const Camera camera = session.camera();
    drag(0, {int(-0.25 * picture(0).width()), 0}, 6);
    settle();
    EXPECT_NEAR(session.setup(0).wipe.position, 0.25, 0.01);
    EXPECT_EQ(session.camera(), camera);
    EXPECT_EQ(picture(0).drawnPictures(), drawn) << "the line moves without drawing the scene again";
}

TEST_F(EightViews, theLectureBorrowsAViewAndGivesItBack) {
    open(kScene);
    session.setActiveView(0);
    settle();
    window.actions().lecture->trigger();
    auto* lecture = window.lecture();
    ASSERT_TRUE(lecture);
    ASSERT_TRUE(QTest::qWaitForWindowExposed(lecture, kPatience));
    EXPECT_EQ(lecture->shownView(), 0);
    QTest::keyClick(lecture, Qt::Key_PageDown);
    EXPECT_EQ(lecture->shownView(), 1);
    settle();
    QTest::keyClick(lecture, Qt::Key_B);
    EXPECT_TRUE(lecture->blank());
    QTest::keyClick(lecture, Qt::Key_B);
    EXPECT_FALSE(lecture->blank());
    QTest::keyClick(lecture, Qt::Key_Escape);
    ASSERT_TRUE(waitUntil([&] { return window.lecture() == nullptr; }));
    settle();
    EXPECT_EQ(window.views().pane(1).parentWidget(), &window.views());
    EXPECT_TRUE(window.views().pane(1).isVisible());
}

}  // namespace
}  // namespace cullscope::ui
