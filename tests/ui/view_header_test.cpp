// The header of a view of 320 pixels states strategy and promise in every language.
#include "ui/views/view_header.h"

#include <gtest/gtest.h>

#include "tests/ui/test_scene.h"
#include "ui/text/language.h"
#include "ui/text/wording.h"

namespace cullscope::ui::view_header_test {
namespace {

constexpr int kLeastWidth = 320;

struct HeaderOfView : ::testing::Test {
    void SetUp() override {
        session.setViewCount(8);
        header.resize(kLeastWidth, 2 * ViewHeader::kLineHeight);
        openAndWait(session, QStringLiteral("torus:triangles=200"));
    }
    void TearDown() override { language.use(QStringLiteral("en")); }

    void watch(Role role, const std::string& strategy) {
        session.setLinked(1);
        if (role == Role::Observer) session.observe(1, 0);
        if (role == Role::Frozen) session.setFrozen(1, true);
        StrategySlot& slot = session.slot(session.culledBy(1));
        slot.choose(strategy);
        ASSERT_TRUE(waitUntil([&] { return slot.built() && !slot.building(); }));
    }

    Language language;
    Session session{sessionOptions(false)};
    ViewHeader header{session, 1};
};

TEST_F(HeaderOfView, promiseAndIdOrNameStandWholeInANarrowView) {
    for (const char* spoken : {"en", "ko", "zh_CN"}) {
        language.use(QString::fromLatin1(spoken));
        for (const Role role : {Role::Linked, Role::Observer, Role::Frozen}) {
            for (const char* id : {"all", "backface", "frustum"}) {
                watch(role, id);
                header.grab();
                const QString shown = header.shownFirstLine();
                const std::string context = std::string(spoken) + ": " + shown.toStdString();
                EXPECT_FALSE(header.elided()) << context;
                const Promise promise = session.slot(session.culledBy(1)).built()->promise();
                const QString name = translated(findStrategy(id).info.name);
                EXPECT_TRUE(shown.endsWith(promiseWord(promise) + QLatin1Char(' ') + QString::fromLatin1(id)) ||
                            shown.endsWith(name + QLatin1Char(' ') + promiseWord(promise)) || shown.endsWith(name))
                    << context;
                EXPECT_TRUE(shown.startsWith(QStringLiteral("B "))) << context;
                EXPECT_TRUE(header.toolTip().contains(header.firstLine())) << context;
            }
        }
    }
}

TEST_F(HeaderOfView, doesNotPromiseWhatTheStrategyBeforePromised) {
    watch(Role::Linked, "all");
    session.slot(1).choose("spherical");
    // The strategy is not built yet.
    ASSERT_EQ(session.slot(1).built()->id(), "all");
    EXPECT_FALSE(header.shownFirstLine().contains(promiseWord(Promise::Conservative))) << header.shownFirstLine().toStdString();
    ASSERT_TRUE(waitUntil([&] { return session.slot(1).built()->id() == "spherical"; }));
    EXPECT_TRUE(waitUntil([&] { return header.shownFirstLine().contains(promiseWord(Promise::Approximate)); }));
}

TEST_F(HeaderOfView, theNameStandsWhereItHasRoomAndTheIdWhereBothHaveOrTheNameHasNot) {
    watch(Role::Observer, "backface");
    EXPECT_EQ(header.shownFirstLine(), QStringLiteral("B watches A · Back-face culling")) << "the promise's mark says the rest";
    int narrow = kLeastWidth;
    while (header.shownFirstLine().contains(QStringLiteral("culling"))) header.resize(--narrow, header.height());
    EXPECT_EQ(header.shownFirstLine(), QStringLiteral("B watches A lossless backface"));
    header.resize(2 * kLeastWidth, header.height());
    EXPECT_EQ(header.shownFirstLine(), QStringLiteral("B watches A · Back-face culling lossless backface"));
    int width = 2 * kLeastWidth;
    while (header.shownFirstLine().endsWith(QStringLiteral("backface"))) header.resize(--width, header.height());
    EXPECT_EQ(header.shownFirstLine(), QStringLiteral("B watches A · Back-face culling lossless"));
    watch(Role::Linked, "all");
    header.resize(kLeastWidth, header.height());
    EXPECT_EQ(header.shownFirstLine(), QStringLiteral("B All triangles lossless all"));
}

TEST_F(HeaderOfView, theLargeLettersOfALectureSayTheNameAndNotTheId) {
    header.setLetters(20);
    for (const Role role : {Role::Linked, Role::Observer, Role::Frozen}) {
        watch(role, "backface");
        header.resize(role == Role::Linked ? 300 : 430, header.height());
        header.grab();
        const QString shown = header.shownFirstLine();
        EXPECT_TRUE(shown.contains(QStringLiteral("Back-face culling"))) << shown.toStdString();
        EXPECT_FALSE(shown.contains(QStringLiteral("backface"))) << shown.toStdString();
        EXPECT_FALSE(header.elided()) << shown.toStdString();
    }
}

TEST_F(HeaderOfView, whatHasNoRoomAtAllIsKnownToBeCut) {
    watch(Role::Observer, "backface");
    header.resize(80, header.height());
    header.grab();
    EXPECT_TRUE(header.elided());
}

}  // namespace
}  // namespace cullscope::ui::view_header_test
