// The state of a session after a driver reset destroyed the OpenGL context.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/ui/context_loss.h"
#include "ui/session/undo_recorder.h"

namespace cullscope::ui::context_loss_test {
namespace {

using ::testing::HasSubstr;

TEST_F(ContextLoss, isOneSentenceAndThenAllIsAsItWas) {
    setUp(session);
    settle(session);
    UndoRecorder undo(session);
    const Camera first = session.camera();
    session.setCamera(turned(first, UpAxis::Y, Angle::fromDegrees(10.0), {}));
    undo.settle();
    session.setPick(Pick{2, 4100, Vec3(1.0, 2.0, 3.0)});
    settle(session);
    const Seen before = seenIn(session);
    const SessionState state = captureState(session);
    const size_t references = session.meter()->referencesComputed();
    EXPECT_GT(std::get<0>(before.counts[1]) + std::get<2>(before.counts[1]), 1000u);
    for (int loss = 1; loss <= 2; ++loss) {
        const std::vector<size_t> drawnBefore = drawn();
        lose();
        EXPECT_EQ(seenIn(session), before) << "while the scene was on its way";
        waitForRedrawing(drawnBefore);
        EXPECT_EQ(seenIn(session), before) << "loss " << loss;
        EXPECT_EQ(captureState(session), state);
        EXPECT_EQ(session.pick(), (Pick{2, 4100, Vec3(1.0, 2.0, 3.0)}));
        ASSERT_EQ(said.size(), size_t(loss));
        EXPECT_EQ(severities.back(), Severity::Warning);
        EXPECT_THAT(said.back(), HasSubstr("nothing is lost"));
    }
    EXPECT_EQ(session.meter()->referencesComputed(), references) << "known figures were measured again";
    EXPECT_TRUE(undo.canUndo());
    undo.undo();
    EXPECT_EQ(session.camera(), first);
}

TEST_F(ContextLoss, afterItEverythingIsDrawnMeasuredAndPickedAsInAnotherSession) {
    setUp(session);
    settle(session);
    lose();
    Session other(sessionOptions(true));
    setUp(other);
    for (Session* one : {&session, &other}) {
        one->setCamera(turned(one->camera(), UpAxis::Y, Angle::fromDegrees(25.0), {}));
        one->slot(0).choose("all");
        settle(*one);
    }
    EXPECT_EQ(seenIn(session), seenIn(other));
    for (Session* one : {&session, &other}) one->pickAt(0, kLossSize.width / 2, kLossSize.height / 3);
    ASSERT_TRUE(waitUntil([&] { return session.pick() && other.pick(); }));
    EXPECT_EQ(session.pick(), other.pick());
    EXPECT_EQ(said.size(), 1u);
}

TEST_F(ContextLoss, inTheMiddleOfMeasuringTheFiguresComeAllTheSame) {
    bool lost = false;
    QObject::connect(&session, &Session::metricsChanged, [&](int view) {
        const ViewMetrics& figures = session.figures(view);
        if (figures.state == ViewMetrics::State::Ready && !figures.timed && !std::exchange(lost, true)) driver.reset = 1;
    });
    setUp(session);
    ASSERT_TRUE(waitUntil([&] { return !said.empty(); }));
    settle(session);
    Session other(sessionOptions(true));
    setUp(other);
    settle(other);
    EXPECT_EQ(seenIn(session), seenIn(other));
    for (const int view : {0, 1, 3}) EXPECT_TRUE(session.figures(view).timed) << view;
    EXPECT_EQ(said.size(), 1u);
}

TEST_F(ContextLoss, whileAPictureIsDrawnNothingOfItIsShown) {
    setUp(session);
    settle(session);
    std::vector<QImage> shown;
    QObject::connect(&session, &Session::pictureChanged, [&](int view) {
        if (view == 0) shown.push_back(session.picture(view) ? session.picture(view)->colour : QImage());
    });
    session.setActiveView(0);
    session.setCamera(turned(session.camera(), UpAxis::Y, Angle::fromDegrees(5.0), {}));
    driver.reset = 2;  // the query after the one that precedes the drawing
    ASSERT_TRUE(waitUntil([&] { return !said.empty(); }));
    settle(session);
    ASSERT_FALSE(shown.empty());
    for (const QImage& picture : shown) EXPECT_EQ(picture, session.picture(0)->colour);
}

TEST_F(ContextLoss, objectsHiddenBeforeItIsKnownAreHiddenAfterIt) {
    setUp(session);
    settle(session);
    driver.reset = 1;
    session.gpu()->run([] {});
    std::vector<bool> hidden(session.hidden().size(), false);
    hidden[0] = hidden[10] = true;
    session.setHidden(hidden);  // shares buffers of the lost context
    ASSERT_TRUE(waitUntil([&] { return !said.empty(); }));
    settle(session);
    Session other(sessionOptions(true));
    setUp(other);
    other.setHidden(hidden);
    settle(other);
    EXPECT_EQ(seenIn(session), seenIn(other));
    EXPECT_EQ(said.size(), 1u);
}

TEST_F(ContextLoss, withoutANewContextWhatIsShownStays) {
    setUp(session);
    settle(session);
    const Seen before = seenIn(session);
    driver.broken = true;
    lose();
    ASSERT_EQ(said.size(), 1u);
    EXPECT_EQ(severities.back(), Severity::Error);
    EXPECT_THAT(said.back(), HasSubstr("no new one can be made"));
    EXPECT_EQ(seenIn(session), before);
    // Moving the camera neither blocks nor replaces the pictures by wrong ones.
    const Camera camera = session.camera();
    session.setCamera(turned(camera, UpAxis::Y, Angle::fromDegrees(10.0), {}));
    ASSERT_TRUE(waitUntil([&] { return session.metricsSettled() && !session.pictures()->busy(); }));
    EXPECT_EQ(session.picture(0)->colour, before.pictures[0]);
    EXPECT_EQ(session.figures(0).state, ViewMetrics::State::Failed);
    EXPECT_EQ(said.size(), 1u);
    session.setCamera(camera);
    ASSERT_TRUE(waitUntil([&] { return session.metricsSettled(); }));
    // After the opening of another scene the message appears again, once.
    openAndWait(session, QStringLiteral("torus:triangles=2000"));
    ASSERT_TRUE(waitUntil([&] { return said.size() == 2; }));
    session.gpu()->run([] {});
    QTest::qWait(50);
    EXPECT_EQ(said.size(), 2u);
    EXPECT_EQ(said.back(), said.front());
}

TEST_F(ContextLoss, thatComesAgainAndAgainIsGivenUp) {
    setUp(session);
    settle(session);
    const Seen before = seenIn(session);
    driver.always = true;
    session.gpu()->run([] {});
    ASSERT_TRUE(waitUntil([&] { return !severities.empty() && severities.back() == Severity::Error; }));
    QTest::qWait(100);
    EXPECT_EQ(said.size(), 5u);
    EXPECT_EQ(seenIn(session), before);
}

}  // namespace
}  // namespace cullscope::ui::context_loss_test
