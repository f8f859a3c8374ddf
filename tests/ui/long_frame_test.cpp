// A frame that takes minutes ends when it is not wanted any more: with another strategy, and with the window.

#include <QTemporaryDir>
#include <cmath>
#include <fstream>

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
