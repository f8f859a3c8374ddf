// Lessons in the window: every step of every lesson shows what it says, in every language, without waiting for a measurement.
#include <gmock/gmock.h>

#include <QTemporaryDir>
#include <algorithm>

#include "core/scene/camera_path.h"
#include "tests/ui/lesson_window.h"
#include "ui/text/terms.h"

namespace cullscope::ui::lessons_test {
namespace {

using ::testing::IsEmpty;

struct StepsOfLessons : Lessons {
    /// The session shows what the step says.
    void expectShown(const LessonStep& step, const std::string& where) {
        SCOPED_TRACE(where);
        EXPECT_EQ(session.opened()->specification, sceneOf(step, session.sceneSource()));
        EXPECT_EQ(session.viewCount(), step.state.viewCount);
        for (const int view : session.shownViews()) {
            const SessionState::View& wanted = step.state.views[size_t(view)];
            const std::string& strategy = step.state.views[size_t(session.culledBy(view))].strategy;
            EXPECT_EQ(session.setup(view).role, wanted.setup.role) << view;
            EXPECT_EQ(session.setup(view).look, wanted.setup.look) << view;
            EXPECT_EQ(session.setup(view).wipe, wanted.setup.wipe) << view;
            EXPECT_EQ(session.setup(view).size, wanted.setup.size) << view;
            EXPECT_EQ(session.picture(view)->request.strategy->id(), strategy) << view;
            EXPECT_EQ(session.picture(view)->request.culling, session.cullingCamera(view)) << view;
            EXPECT_EQ(window.views().pane(view).strip() != nullptr, !wanted.setup.below.empty()) << view;
            if (wanted.setup.role == Role::Observer) EXPECT_EQ(session.setup(view).observed, wanted.setup.observed) << view;
            if (wanted.setup.role == Role::Frozen && step.culling[size_t(view)].kind == CameraChoice::Kind::Pose) {
                const CameraChoice& choice = step.culling[size_t(view)];
                EXPECT_EQ(session.cullingCamera(view).eye, cameraPath(choice.path, *session.scene()).camera(choice.pose).eye)
                    << view;
            }
        }
        if (step.camera.kind == CameraChoice::Kind::Given) EXPECT_EQ(session.camera().eye, step.state.camera.eye);
        if (step.camera.kind == CameraChoice::Kind::Pose)
            EXPECT_EQ(session.camera().eye, cameraPath(step.camera.path, *session.scene()).camera(step.camera.pose).eye);
        EXPECT_EQ(session.step().has_value(), step.state.place.has_value());
        if (step.state.place && session.step()) {
            const LogPlace &wanted = *step.state.place, &shown = session.step()->place;
            const double share = double(wanted.entries) / double(wanted.whole);
            EXPECT_NEAR(double(shown.entries) / double(shown.whole), share, 0.1);
        }
        EXPECT_EQ(window.lessonBar().sentence().toStdString(), textIn(step.sentence, language.current().toStdString()));
        EXPECT_TRUE(window.lessonBar().isVisible());
    }
};

class OwnLesson : public StepsOfLessons, public ::testing::WithParamInterface<int> {};

TEST_P(OwnLesson, everyStepShowsWhatItSaysAndMeasuresNothing) {
    const QString name = LessonPlayer::known().at(GetParam());
    begin(name);
    for (int step = 0; step < player().count(); ++step) {
        go(step);
        const std::string where = name.toStdString() + ", step " + std::to_string(step + 1);
        ASSERT_FALSE(HasFatalFailure());
        expectShown(player().current(), where);
        for (const int view : session.shownViews())
            EXPECT_NE(session.figures(view).state, ViewMetrics::State::Ready) << where << ": it was measured for the step";
        if (!player().current().state.structurePanel.page.empty())
            EXPECT_EQ(window.structurePanel().page(), player().current().state.structurePanel.page) << where;
    }
    EXPECT_THAT(said, IsEmpty());
}
INSTANTIATE_TEST_SUITE_P(All, OwnLesson, ::testing::Range(0, 9));

TEST_F(Lessons, twoActionsShowTheThreeCasesEachWithCameraObserverMapAndLoss) {
    // Of the menu and of the lesson, as a user has them.
    QAction* entry = window.actions().lessons->actions().at(2);
    entry->trigger();
    ASSERT_TRUE(waitUntil([this] { return onScreen(); }));
    ASSERT_EQ(session.shownViews().size(), 6u);
    for (int column = 0; column < 3; ++column) {
        const int observer = column + 3;
        EXPECT_EQ(session.setup(column).role, Role::Frozen);
        EXPECT_EQ(session.culledBy(observer), column);
        EXPECT_EQ(session.setup(column).wipe.mode, Wipe::Mode::Loss);
        auto* map = qobject_cast<MapPanel*>(window.views().pane(observer).strip());
        ASSERT_TRUE(map);
        ASSERT_TRUE(waitUntil([&] { return !map->map().empty(); })) << map->sentence().toStdString();
        EXPECT_THAT(translated(map->map().contents().shown.map->decisionWords).toStdString(),
                    ::testing::HasSubstr(std::to_string(column + 1)));
        EXPECT_EQ(window.views().pane(observer).x(), window.views().pane(column).x());
        // Another default scene, where the bunny is not installed, may lose nothing there.
        if (session.opened()->specification.find("bunny") != std::string::npos)
            EXPECT_GT(session.picture(column)->missed, 100u) << "column " << column << " shows a loss";
    }
    for (const int other : {1, 2}) EXPECT_NE(session.cullingCamera(0), session.cullingCamera(other));
}

TEST_F(Lessons, presentersKeysWalkThroughTheLessonAndAnotherPairStepsTheFrame) {
    begin(QStringLiteral("frustum"));
    window.activateWindow();
    ASSERT_TRUE(QTest::qWaitForWindowActive(&window, kPatience));
    QWidget* view = &picture(0);
    QTest::keyClick(view, Qt::Key_PageDown);
    EXPECT_EQ(player().step(), 1);
    QTest::keyClick(view, Qt::Key_PageUp);
    EXPECT_EQ(player().step(), 0);
    QTest::keyClick(view, Qt::Key_PageUp);
    EXPECT_EQ(player().step(), 0) << "before the first step";
    QTest::keyClick(view, Qt::Key_End, Qt::ControlModifier);
    EXPECT_EQ(player().step(), player().count() - 1);
    QTest::keyClick(view, Qt::Key_Home, Qt::ControlModifier);
    EXPECT_EQ(player().step(), 0);
    go(5);
    ASSERT_TRUE(waitUntil([&] { return window.stepper().place() != nullptr; }));
    const size_t before = window.stepper().place()->step();
    QTest::keyClick(view, Qt::Key_Right, Qt::ControlModifier);
    EXPECT_EQ(window.stepper().place()->step(), before + 1);
    EXPECT_EQ(player().step(), 5);
    player().leave();
    EXPECT_FALSE(window.lessonBar().isVisible());
    QTest::keyClick(view, Qt::Key_PageDown);
    EXPECT_EQ(window.stepper().place()->step(), before + 2) << "without a lesson the clicker steps the frame";
}

TEST_F(Lessons, whatTheWindowShowsIsAddedAsAStepAndShownAgain) {
    const QTemporaryDir folder;
    const QString file = folder.filePath(QStringLiteral("mine.lesson"));
    openAndWait(session, QStringLiteral("torus:triangles=2000"));
    session.slot(0).choose("spherical");
    Camera camera = session.camera();
    camera.eye *= 0.7;
    session.setCamera(camera);
    ASSERT_TRUE(window.lessons().addStep(file, QStringLiteral("Nearer.")));
    session.setViewCount(4);
    session.slot(3).choose("frustum");
    ASSERT_TRUE(window.lessons().addStep(file, QStringLiteral("Four.")));
    const SessionState four = captureState(session);
    openAndWait(session, QStringLiteral("sphere:triangles=500"));
    begin(file);
    EXPECT_EQ(player().count(), 2);
    EXPECT_EQ(session.viewCount(), 2);
    EXPECT_EQ(session.slot(0).id(), "spherical");
    EXPECT_EQ(session.camera().eye, camera.eye);
    EXPECT_EQ(window.lessonBar().sentence(), QStringLiteral("Nearer."));
    go(1);
    const SessionState again = captureState(session);
    EXPECT_EQ(again.viewCount, 4);
    EXPECT_EQ(again.camera, four.camera);
    for (size_t view = 0; view < 4; ++view) EXPECT_EQ(again.views[view], four.views[view]) << view;
    EXPECT_THAT(said, IsEmpty());
}

TEST_F(Lessons, sceneThatCannotBeOpenedIsSaidAndTheLessonGoesOn) {
    player().begin(
        lessonFromText("title en A\nstep\nsay en One.\nscene torus:triangles=500\nstep\nsay en Two.\nscene gone.obj\n"
                       "step\nsay en Three.\nscene torus:triangles=500\n",
                       "/nowhere/a.lesson"));
    go(0);
    player().go(1);
    ASSERT_TRUE(waitUntil([&] { return !said.empty() && !session.loader().loading(); }));
    EXPECT_THAT(said.back(), ::testing::HasSubstr("/nowhere/gone.obj"));
    EXPECT_EQ(window.lessonBar().sentence(), QStringLiteral("Two."));
    go(2);
    EXPECT_EQ(session.opened()->specification, "torus:triangles=500");
}

}  // namespace
}  // namespace cullscope::ui::lessons_test
