#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <QMouseEvent>
#include <QWidget>

#include "core/geometry/random.h"
#include "core/visibility/registry.h"
#include "tests/ui/test_scene.h"
#include "ui/session/undo_recorder.h"

namespace cullscope::ui::undo_test {
namespace {

struct Undo : ::testing::Test {
    void SetUp() override {
        openAndWait(session, QStringLiteral("field:n=3"));
        // From here on view 0 has a size, and the initial camera follows it.
        session.setViewport(0, {400, 300});
        session.setViewport(1, {400, 300});
        undo.startAnew();
    }

    [[nodiscard]] Camera turnedBy(double degrees) const {
        return turned(session.camera(), UpAxis::Y, Angle::fromDegrees(degrees), {});
    }
    void chooseBox(int view, const char* box) {
        ParameterSet parameters = session.slot(view).parameters();
        parameters.setFromText("box", box);
        session.slot(view).setParameters(parameters);
    }
    void sendMouse(QEvent::Type type, Qt::MouseButtons held) {
        QMouseEvent event(type, {5, 5}, {5, 5}, type == QEvent::MouseMove ? Qt::NoButton : Qt::LeftButton, held, Qt::NoModifier);
        QApplication::sendEvent(&widget, &event);
    }

    QWidget widget;
    Session session{sessionOptions(false)};
    UndoRecorder undo{session};
};

TEST_F(Undo, thereIsNothingToUndoAtFirst) {
    EXPECT_FALSE(undo.canUndo());
    EXPECT_FALSE(undo.canRedo());
    EXPECT_EQ(undo.undoText(), QStringLiteral("Undo"));
    const SessionState before = captureState(session);
    undo.undo();
    undo.redo();
    EXPECT_EQ(captureState(session), before);
}

TEST_F(Undo, manyQuickMovesAreOneStep) {
    const Camera first = session.camera();
    for (int i = 0; i < 50; ++i) session.setCamera(turnedBy(1.0));
    const Camera last = session.camera();
    EXPECT_TRUE(undo.canUndo());
    ASSERT_TRUE(waitUntil([&] { return undo.undoText() == QStringLiteral("Undo: camera"); }));
    undo.undo();
    EXPECT_EQ(session.camera(), first);
    EXPECT_FALSE(undo.canUndo());
    EXPECT_EQ(undo.redoText(), QStringLiteral("Redo: camera"));
    undo.redo();
    EXPECT_EQ(session.camera(), last);
    EXPECT_FALSE(undo.canRedo());
}

TEST_F(Undo, aDragThatRestsIsOneStepAndEndsWithTheButton) {
    const Camera first = session.camera();
    sendMouse(QEvent::MouseButtonPress, Qt::LeftButton);
    session.setCamera(turnedBy(10.0));
    QTest::qWait(600);
    session.setCamera(turnedBy(10.0));
    sendMouse(QEvent::MouseButtonRelease, Qt::NoButton);
    // The release ends the step at once, without the 400 ms of rest, as soon as its queued event is processed.
    QApplication::processEvents();
    EXPECT_EQ(undo.undoText(), QStringLiteral("Undo: camera"));
    const Camera dragged = session.camera();
    session.setCamera(turnedBy(10.0));
    undo.undo();
    EXPECT_EQ(session.camera(), dragged);
    undo.undo();
    EXPECT_EQ(session.camera(), first);
    EXPECT_FALSE(undo.canUndo());
}

TEST_F(Undo, aLostReleaseIsMadeUpFor) {
    sendMouse(QEvent::MouseButtonPress, Qt::LeftButton);
    session.setCamera(turnedBy(10.0));
    sendMouse(QEvent::MouseMove, Qt::NoButton);
    QApplication::processEvents();
    EXPECT_EQ(undo.undoText(), QStringLiteral("Undo: camera"));
}

TEST_F(Undo, ofACameraDisturbsNothingElse) {
    const Camera first = session.camera();
    session.setCamera(turnedBy(10.0));
    undo.settle();
    // Changes that are no steps of undo stay as they are.
    session.setViewCount(4);
    session.setActiveView(3);
    undo.undo();
    EXPECT_EQ(session.camera(), first);
    EXPECT_EQ(session.viewCount(), 4);
    EXPECT_EQ(session.activeView(), 3);
}

TEST_F(Undo, namesWhatChanged) {
    const auto text = [&] {
        undo.settle();
        return undo.undoText().toStdString();
    };
    session.slot(1).choose("frustum");
    EXPECT_EQ(text(), "Undo: strategy of view B");
    chooseBox(1, "length");
    EXPECT_EQ(text(), "Undo: parameters of view B");
    std::vector<bool> hidden = session.hidden();
    hidden[2] = true;
    session.setHidden(hidden);
    EXPECT_EQ(text(), "Undo: hidden objects");
    session.observe(2, 1);
    EXPECT_EQ(text(), "Undo: display of view C");
    session.setViewingCamera(2, turned(session.viewingCamera(2), UpAxis::Y, Angle::fromDegrees(5.0), {}));
    EXPECT_EQ(text(), "Undo: camera of view C");
    session.setChosenNear(0.3);
    EXPECT_EQ(text(), "Undo: camera");
    session.slot(0).choose("frustum");
    session.slot(3).choose("backface");
    EXPECT_EQ(text(), "Undo: several changes");
}

TEST_F(Undo, goesAllTheWayBackAndForthOverRandomChanges) {
    Random random(5);
    const auto below = [&](size_t count) { return size_t(random.unit() * double(count)); };
    std::vector<SessionState> states{captureState(session)};
    const auto change = [&] {
        const int view = int(below(8));
        std::vector<bool> hidden = session.hidden();
        ViewSetup setup = session.setup(view);
        switch (below(8)) {
            case 0:
                return session.setCamera(turnedBy(random.between(1.0, 90.0)));
            case 1:
                return session.slot(view).choose(strategies()[below(strategies().size())].info.id);
            case 2:
                return session.observe(view, int(below(8)));
            case 3:
                return session.setFrozen(view, random.unit() < 0.6);
            case 4:
                hidden[below(hidden.size())].flip();
                return session.setHidden(hidden);
            case 5:
                setup.wipe.position = random.unit();
                return session.setSetup(view, setup);
            case 6:
                return session.setUpAxis(random.unit() < 0.5 ? UpAxis::Y : UpAxis::Z);
            default:
                return session.setViewingCamera(view, turned(session.viewingCamera(view), session.upAxis(),
                                                             Angle::fromDegrees(random.between(1.0, 90.0)), {}));
        }
    };
    for (int i = 0; i < 150; ++i) {
        change();
        undo.settle();
        if (!(captureState(session) == states.back())) states.push_back(captureState(session));
    }
    ASSERT_GT(states.size(), 80u);
    for (int round = 0; round < 2; ++round) {
        for (size_t i = states.size() - 1; i > 0; --i) {
            ASSERT_TRUE(undo.canUndo()) << i;
            undo.undo();
            ASSERT_EQ(captureState(session), states[i - 1]) << i;
        }
        EXPECT_FALSE(undo.canUndo());
        for (size_t i = 1; i < states.size(); ++i) {
            undo.redo();
            ASSERT_EQ(captureState(session), states[i]) << i;
        }
        EXPECT_FALSE(undo.canRedo());
    }
}

TEST_F(Undo, doesNotGoBackOverTheOpeningOfAScene) {
    session.setCamera(turnedBy(10.0));
    undo.settle();
    ASSERT_TRUE(undo.canUndo());
    // A failed opening does not clear the history.
    openAndWait(session, QStringLiteral("nothing.obj"));
    EXPECT_TRUE(undo.canUndo());
    openAndWait(session, QStringLiteral("sphere:triangles=80"));
    undo.settle();
    EXPECT_FALSE(undo.canUndo());
    EXPECT_FALSE(undo.canRedo());
}

TEST_F(Undo, aWindowThatChangesItsSizeMakesNoStep) {
    session.setActiveView(0);
    session.observe(1, 0);
    session.goHome();
    undo.startAnew();
    const Camera before = session.camera(), observer = session.viewingCamera(1);
    session.setViewport(0, {200, 900});
    ASSERT_NE(session.camera(), before);
    ASSERT_NE(session.viewingCamera(1), observer);
    undo.settle();
    EXPECT_FALSE(undo.canUndo());
    // Going home by hand is a step.
    session.setCamera(turnedBy(30.0));
    undo.settle();
    const Camera turnedCamera = session.camera();
    session.goHome();
    undo.settle();
    undo.undo();
    EXPECT_EQ(session.camera(), turnedCamera);
}

TEST_F(Undo, backAtTheFirstCameraItFollowsTheWindowAgain) {
    session.setActiveView(0);
    session.observe(1, 0);
    session.goHome();
    undo.startAnew();
    session.setCamera(turnedBy(30.0));
    undo.settle();
    undo.undo();
    const Camera before = session.camera(), observer = session.viewingCamera(1);
    session.setViewport(0, {200, 900});
    EXPECT_NE(session.camera(), before);
    EXPECT_NE(session.viewingCamera(1), observer);
}

TEST_F(Undo, aNewChangeEndsTheRedo) {
    session.setCamera(turnedBy(10.0));
    undo.settle();
    undo.undo();
    ASSERT_TRUE(undo.canRedo());
    session.slot(0).choose("frustum");
    EXPECT_FALSE(undo.canRedo());
    undo.settle();
    EXPECT_FALSE(undo.canRedo());
}

TEST_F(Undo, whatReturnsByItselfIsNoStep) {
    const Camera first = session.camera();
    session.setCamera(turnedBy(10.0));
    session.setCamera(first);
    undo.settle();
    EXPECT_FALSE(undo.canUndo());
}

}  // namespace
}  // namespace cullscope::ui::undo_test
