// A frame that takes minutes ends when it is not wanted any more: with another strategy, and with the window.

#include <QTemporaryDir>
#include <cmath>
#include <fstream>
#include <future>

#include "tests/support/stopped_work.h"
#include "tests/ui/shown_window.h"

namespace cullscope::ui::long_frame_test {
namespace {

using test::WatchedWork;

constexpr uint64_t kUnderWay = 300'000;  ///< steps of work that only the long frame makes
/// Work sleeps so long at each look for a stop request, and may look so often before the session's end has requested the stop:
/// that is a thousandth of what the frame would need.
constexpr int kPause = 10;
constexpr uint64_t kLooks = 50;

/// 2,000 triangles that fill the scene: the painter cuts them into millions.
struct LongFrame : Window {
    void SetUp() override {
        Window::SetUp();
        std::ofstream soup(file().toStdString());
        for (int i = 0; i < 2'000; ++i) {
            for (int corner = 0; corner < 3; ++corner)
                soup << "v " << std::sin(3 * i + corner) << ' ' << std::cos(7 * i + 2 * corner) << ' '
                     << std::sin(11 * i + 5 * corner) << '\n';
            soup << "f -3 -2 -1\n";
        }
        soup.close();
        openAndWait(session, file());
        // Building makes steps, too, also for views that are not shown.
        ASSERT_TRUE(waitUntil([&] {
            for (int view = 0; view < Session::kMostViews; ++view)
                if (session.slot(view).building()) return false;
            return session.pictures()->isCurrent(0) && session.pictures()->isCurrent(1);
        }));
        settle();
    }

    [[nodiscard]] QString file() const { return folder.filePath(QStringLiteral("soup.obj")); }

    static void workForMinutes(Session& session, const char* id) {
        ParameterSet parameters(findStrategy(id).info.parameters);
        parameters.setFromText("limit", "100000000");
        session.slot(0).choose(id);
        session.slot(0).setParameters(parameters);
    }

    QTemporaryDir folder;
};

TEST_F(LongFrame, endsWhenAnotherStrategyIsChosen) {
    QSignalSpy messages(&session, &Session::messageRaised);
    const WatchedWork watched;
    workForMinutes(session, "painter");
    ASSERT_TRUE(waitUntil([&] { return watched.steps() > kUnderWay; }));
    session.slot(0).choose("all");
    const uint64_t asked = watched.steps();
    ASSERT_TRUE(waitUntil([&] {
        return !session.slot(0).building() && session.pictures()->isCurrent(0) && session.metricsSettled() &&
               session.picture(0)->consideredTriangles == session.scene()->triangleCount();
    }));
    EXPECT_LE(watched.steps() - asked, WorkCheck::kBetween);
    for (const auto& message : messages) EXPECT_NE(message.at(0).value<Severity>(), Severity::Error);
}

// The frame of the former strategy is asked for, but not begun: it waits for work that the thread is at.
TEST_F(LongFrame, isNotBegunOnceAnotherStrategyIsBuilt) {
    const WatchedWork watched;
    std::promise<void> letGoOn;
    session.gpu()->post([waits = letGoOn.get_future().share()] { waits.wait(); }, Urgency::Picture);
    workForMinutes(session, "painter");
    ASSERT_TRUE(waitUntil([&] { return !session.slot(0).building() && session.slot(0).built()->id() == "painter"; }));
    QApplication::processEvents();  // the picture is asked for
    session.slot(0).choose("all");
    ASSERT_TRUE(waitUntil([&] { return !session.slot(0).building() && session.slot(0).built()->id() == "all"; }));
    letGoOn.set_value();
    ASSERT_TRUE(waitUntil([&] { return session.pictures()->isCurrent(0) && session.metricsSettled(); }));
    EXPECT_LT(watched.steps(), kUnderWay);
    EXPECT_EQ(session.picture(0)->consideredTriangles, session.scene()->triangleCount());
}

// What a window shows waits for the GPU thread when it goes.
TEST_F(LongFrame, endsWithTheWindow) {
    auto own = std::make_unique<Session>(sessionOptions(true));
    auto its = std::make_unique<MainWindow>(*own, language, appearance);
    its->show();
    openAndWait(*own, file());
    const WatchedWork watched;
    workForMinutes(*own, "painter");
    ASSERT_TRUE(waitUntil([&] { return watched.steps() > kUnderWay; }));
    watched.pauseAtEachLook(kPause);
    const uint64_t asked = watched.steps();
    its.reset();
    own.reset();
    EXPECT_LE(watched.steps() - asked, kLooks * WorkCheck::kBetween);
}

// A million triangles take a tenth of a second to draw, and each part of a closing window waits for the frame in hand: between
// two of them no other one is timed.
TEST_F(LongFrame, isNotTimedAnyMoreOnceTheWindowCloses) {
    auto own = std::make_unique<Session>(sessionOptions(true));
    for (int view = 0; view < 2; ++view) own->setViewport(view, {320, 240});
    openAndWait(*own, file());
    ASSERT_TRUE(waitUntil([&] { return own->pictures()->isCurrent(0) && own->metricsSettled(); }));
    QSignalSpy measured(own->meter(), &ViewMeter::measured);
    const size_t references = own->meter()->referencesComputed();
    std::promise<void> letGoOn;
    own->gpu()->post([waits = letGoOn.get_future().share()] { waits.wait(); }, Urgency::Picture);
    MetricsSubject moved = own->figures(0).subject;
    moved.culling.eye *= 1.1;
    own->meter()->measure({{0, moved}});
    own->endFrames();
    letGoOn.set_value();
    for (int step = 0; step < 8; ++step) EXPECT_EQ(own->meter()->referencesComputed(), references);
    settle();
    EXPECT_EQ(measured.count(), 0);
}

TEST_F(LongFrame, andALongBuildEndWithTheSession) {
    for (const char* id : {"painter", "bsp"}) {
        auto own = std::make_unique<Session>(sessionOptions(true));
        for (int view = 0; view < 2; ++view) own->setViewport(view, {320, 240});
        openAndWait(*own, file());
        const WatchedWork watched;
        workForMinutes(*own, id);
        ASSERT_TRUE(waitUntil([&] { return watched.steps() > kUnderWay; })) << id;
        watched.pauseAtEachLook(kPause);
        const uint64_t asked = watched.steps();
        own.reset();
        EXPECT_LE(watched.steps() - asked, kLooks * WorkCheck::kBetween) << id;
    }
}

}  // namespace
}  // namespace cullscope::ui::long_frame_test
