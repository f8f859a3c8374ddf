#include "ui/session/session_state.h"

#include <gtest/gtest.h>

#include <QTemporaryDir>

#include "core/geometry/random.h"
#include "core/visibility/registry.h"
#include "tests/ui/test_scene.h"
#include "ui/session/session_opener.h"

namespace cullscope::ui::session_state_test {
namespace {

size_t below(Random& random, size_t count) { return size_t(random.unit() * double(count)); }

/// A captured state, applied to another session with the same scene, is captured there unchanged.
TEST(SessionState, appliesToAllRoles) {
    Session from(sessionOptions(false)), to(sessionOptions(false));
    openAndWait(from, QStringLiteral("field:n=3"));
    openAndWait(to, QStringLiteral("field:n=3"));
    Random random(3);
    for (int i = 0; i < 100; ++i) {
        from.setViewCount(Session::kViewCounts[below(random, 4)]);
        from.setActiveView(int(below(random, size_t(from.viewCount()))));
        for (int view = 0; view < Session::kMostViews; ++view) {
            from.slot(view).choose(strategies()[below(random, strategies().size())].info.id);
            if (random.unit() < 0.3) from.observe(view, int(below(random, 8)));
            if (random.unit() < 0.2) from.setFrozen(view, random.unit() < 0.7);
            if (random.unit() < 0.2) from.setLinked(view);
            if (random.unit() < 0.5)
                from.setViewingCamera(view, turned(from.viewingCamera(view), from.upAxis(),
                                                   Angle::fromDegrees(random.between(-90.0, 90.0)), Angle::fromDegrees(3.0)));
            ViewSetup setup = from.setup(view);
            setup.look.show("frustum", random.unit() < 0.5);
            setup.wipe.position = random.unit();
            from.setSetup(view, setup);
        }
        if (random.unit() < 0.3) from.setUpAxis(from.upAxis() == UpAxis::Y ? UpAxis::Z : UpAxis::Y);
        if (random.unit() < 0.3) from.setChosenNear(random.between(0.1, 2.0));
        std::vector<bool> hidden = from.hidden();
        hidden[below(random, hidden.size())].flip();
        from.setHidden(hidden);
        const SessionState state = captureState(from);
        applyState(to, state);
        ASSERT_EQ(captureState(to), state) << i;
        for (int view = 0; view < Session::kMostViews; ++view) {
            EXPECT_EQ(to.cullingCamera(view), from.cullingCamera(view));
            EXPECT_EQ(to.viewingCamera(view), from.viewingCamera(view));
            EXPECT_EQ(to.culledBy(view), from.culledBy(view));
        }
    }
}

TEST(SessionState, whatIsAlreadySoIsNotTouched) {
    Session session(sessionOptions(false));
    openAndWait(session, QStringLiteral("field:n=3"));
    session.observe(1, 0);
    session.setFrozen(2, true);
    const SessionState state = captureState(session);
    int changes = 0;
    const auto count = [&] { ++changes; };
    QObject::connect(&session, &Session::cameraChanged, count);
    QObject::connect(&session, &Session::setupChanged, count);
    QObject::connect(&session, &Session::strategyChosen, count);
    QObject::connect(&session, &Session::hiddenChanged, count);
    applyState(session, state);
    EXPECT_EQ(changes, 0);
}

TEST(SessionState, hiddenObjectsOfAnotherSceneAreShown) {
    Session session(sessionOptions(false));
    openAndWait(session, QStringLiteral("field:n=3"));
    std::vector<std::string> said;
    QObject::connect(&session, &Session::messageRaised,
                     [&](Severity, const Message& message) { said.push_back(message.english()); });
    session.setHidden({true, false, false, false, false, false, false, false, false});
    SessionState state = captureState(session);
    state.hidden = {true, true};
    applyState(session, state);
    EXPECT_EQ(session.hidden(), std::vector<bool>(9, false));
    EXPECT_EQ(said, (std::vector<std::string>{"The scene has 9 objects now, no longer 2: all of them are shown."}));
}

/// After a change of the whole state, opening the session file restores the same pictures.
TEST(SessionState, picturesComeBackPixelForPixel) {
    QTemporaryDir folder;
    Session session(sessionOptions(true));
    CameraBookmarks bookmarks;
    SessionOpener opener(session, bookmarks);
    for (int view = 0; view < 4; ++view) session.setViewport(view, {160, 120});
    const auto settle = [&] {
        ASSERT_TRUE(waitUntil([&] { return session.buffers() && session.metricsSettled() && !session.pictures()->busy(); }));
        for (const int view : session.shownViews()) ASSERT_TRUE(session.pictures()->isCurrent(view)) << view;
    };
    openAndWait(session, QStringLiteral("field:n=4"));
    session.setViewCount(4);
    session.slot(0).choose("frustum");
    session.slot(2).choose("frustum");
    session.setCamera(zoomed(session.camera(), session.camera().target, 0.4, 10.0));
    session.observe(1, 0);
    ViewSetup observer = session.setup(1);
    observer.look = {"verdicts", "frustum", "boxes"};
    session.setSetup(1, observer);
    session.setFrozen(2, true);
    session.setViewingCamera(2, turned(session.viewingCamera(2), UpAxis::Y, Angle::fromDegrees(50.0), {}));
    std::vector<bool> hidden(16, false);
    hidden[3] = hidden[7] = true;
    session.setHidden(hidden);
    ViewSetup sized = session.setup(3);
    sized.size = Viewport{200, 90};
    session.setSetup(3, sized);
    settle();
    std::vector<QImage> before;
    for (int view = 0; view < 4; ++view) before.push_back(session.picture(view)->colour);
    const QString file = folder.filePath(QStringLiteral("s.cullscope"));
    ASSERT_TRUE(opener.save(file, {}));

    openAndWait(session, QStringLiteral("torus:triangles=500"));
    session.setViewCount(2);
    for (int view = 0; view < 4; ++view) {
        session.setSetup(view, ViewSetup{});
        session.slot(view).choose("all");
    }
    session.setUpAxis(UpAxis::Z);
    settle();
    QSignalSpy restored(&opener, &SessionOpener::restored);
    opener.open(file);
    ASSERT_TRUE(waitUntil([&] { return restored.count() == 1; }));
    settle();
    for (int view = 0; view < 4; ++view) EXPECT_EQ(session.picture(view)->colour, before[size_t(view)]) << view;
    EXPECT_NE(before[0], before[1]);
    EXPECT_NE(before[0], before[2]);
}

}  // namespace
}  // namespace cullscope::ui::session_state_test
