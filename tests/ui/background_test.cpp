// Work beside the window: what is delivered of it, what it throws, and what happens where no thread can start.
#include "ui/jobs/background.h"

#include <gmock/gmock.h>
#include <pthread.h>

#include <atomic>

#include "core/base/error.h"
#include "tests/ui/test_scene.h"

namespace cullscope::ui::background_test {
namespace {

using ::testing::HasSubstr;

/// While it exists no thread of the usual stack size can start: the size is more than the address space has.
class NoThreads {
public:
    NoThreads() {
        pthread_getattr_default_np(&m_usual);
        pthread_attr_t huge;
        pthread_attr_init(&huge);
        pthread_attr_setstacksize(&huge, size_t{1} << 50);
        pthread_setattr_default_np(&huge);
        pthread_attr_destroy(&huge);
    }
    ~NoThreads() {
        pthread_setattr_default_np(&m_usual);
        pthread_attr_destroy(&m_usual);
    }
    NoThreads(const NoThreads&) = delete;
    NoThreads& operator=(const NoThreads&) = delete;

private:
    pthread_attr_t m_usual{};
};

Background::Delivery nothing(const std::exception&) { return {}; }

TEST(JobNumbers, onlyTheNewestCounts) {
    JobNumbers jobs;
    const uint64_t first = jobs.begin();
    EXPECT_TRUE(jobs.isCurrent(first));
    const uint64_t second = jobs.begin();
    EXPECT_FALSE(jobs.isCurrent(first));
    EXPECT_TRUE(jobs.isCurrent(second));
    jobs.invalidate();
    EXPECT_FALSE(jobs.isCurrent(second));
}

TEST(Background, staleResultsAreDropped) {
    std::vector<int> delivered;
    std::atomic<bool> release{false};
    Background background;
    for (int i = 0; i < 5; ++i)
        background.start(
            [&, i](const std::stop_token&) -> Background::Delivery {
                while (!release) std::this_thread::yield();
                return [&delivered, i] { delivered.push_back(i); };
            },
            nothing);
    release = true;
    ASSERT_TRUE(waitUntil([&] { return !background.busy(); }));
    QTest::qWait(50);
    EXPECT_EQ(delivered, std::vector<int>{4});
}

TEST(Background, cancelledWorkBringsNothing) {
    bool delivered = false;
    Background background;
    background.start(
        [&](const std::stop_token& stop) -> Background::Delivery {
            while (!stop.stop_requested()) std::this_thread::yield();
            return [&delivered] { delivered = true; };
        },
        nothing);
    background.cancel();
    EXPECT_FALSE(background.busy());
    QTest::qWait(50);
    EXPECT_FALSE(delivered);
}

TEST(Background, whatLeavesTheWorkIsDeliveredAsItsFailure) {
    std::string said;
    Background background;
    const auto say = [&](const std::exception& failure) -> Background::Delivery {
        return [&said, words = std::string(failure.what())] { said = words; };
    };
    background.start([](const std::stop_token&) -> Background::Delivery { throw std::runtime_error("the work failed"); }, say);
    ASSERT_TRUE(waitUntil([&] { return !background.busy(); }));
    EXPECT_EQ(said, "the work failed");
}

TEST(Background, withoutAThreadTheFailureIsDeliveredLater) {
    std::string said;
    Background background;
    {
        const NoThreads none;
        background.start([](const std::stop_token&) -> Background::Delivery { return {}; },
                         [&](const std::exception& failure) -> Background::Delivery {
                             return [&said, words = std::string(failure.what())] { said = words; };
                         });
    }
    EXPECT_TRUE(background.busy());
    EXPECT_EQ(said, "");
    ASSERT_TRUE(waitUntil([&] { return !background.busy(); }));
    EXPECT_THAT(said, HasSubstr("The system gives no thread for this"));
    bool done = false;
    background.start([&](const std::stop_token&) -> Background::Delivery { return [&done] { done = true; }; }, nothing);
    ASSERT_TRUE(waitUntil([&] { return !background.busy(); }));
    EXPECT_TRUE(done) << "with threads it goes on";
}

TEST(Session, withoutAThreadASceneIsRefusedAndTheOldOneStays) {
    Session session{sessionOptions(false)};
    openAndWait(session, QStringLiteral("sphere:triangles=80"));
    ASSERT_TRUE(waitUntil([&] { return session.slot(0).built() != nullptr; }));
    const OpenedScenePointer scene = session.opened();
    std::vector<std::string> said;
    QObject::connect(&session, &Session::messageRaised,
                     [&](Severity, const Message& message) { said.push_back(message.english()); });
    {
        const NoThreads none;
        openAndWait(session, QStringLiteral("sphere:triangles=320"));
        EXPECT_EQ(session.opened(), scene);
        session.slot(0).choose("spherical");
        ASSERT_TRUE(waitUntil([&] { return said.size() == 2; }));
    }
    for (const std::string& sentence : said) EXPECT_THAT(sentence, HasSubstr("The system gives no thread for this"));
    openAndWait(session, QStringLiteral("sphere:triangles=320"));
    EXPECT_NE(session.opened(), scene);
    ASSERT_TRUE(waitUntil([&] { return session.slot(0).built() && session.slot(0).built()->id() == "spherical"; }));
}

TEST(GpuThread, withoutAThreadThereIsASentence) {
    const NoThreads none;
    try {
        GpuThread thread;
        FAIL() << "a thread was started";
    } catch (const Error& error) {
        EXPECT_EQ(error.kind(), ErrorKind::OpenGl);
        EXPECT_THAT(error.what(), HasSubstr("no thread for OpenGL"));
    }
}

}  // namespace
}  // namespace cullscope::ui::background_test
