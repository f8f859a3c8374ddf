#include <gtest/gtest.h>

#include "core/scene/camera_moves.h"
#include "core/visibility/spherical/map_details.h"
#include "tests/ui/test_scene.h"
#include "ui/panels/map_panel.h"
#include "ui/session/object_pick.h"
#include "ui/session/stepper.h"
#include "ui/text/terms.h"

namespace cullscope::ui::map_panel_live_test {
namespace {

/// A panel that shows the reading of a real strategy on a field of stars.
struct LiveMapPanelTest : ::testing::Test {
    void SetUp() override {
        session.slot(1).choose("spherical");
        session.setViewport(0, {160, 120});
        session.setViewport(1, {160, 120});
        openAndWait(session, QStringLiteral("field:mesh=star:seed=7,triangles=2000,n=3,spacing=3"));
        reader.readFor(&panel);
        panel.resize(400, 330);
        panel.show();
        ASSERT_TRUE(QTest::qWaitForWindowExposed(&panel, kPatience));
        settle();
    }

    void settle() {
        ASSERT_TRUE(waitUntil([&] { return !session.slot(1).building() && reader.fresh() && session.metricsSettled(); }));
        QApplication::processEvents();
    }
    [[nodiscard]] const ShownMap& shown() { return panel.map().contents().shown; }

    Session session{sessionOptions(true)};
    SnapshotReader reader{session};
    MapPanel panel{session, reader};
};

TEST_F(LiveMapPanelTest, showsThePickedObjectElseTheFirstThatIsNotOutside) {
    ASSERT_FALSE(shown().empty());
    const std::vector<spherical::MapSnapshot>& maps = spherical::mapsOf(*reader.reading()->snapshot);
    ASSERT_EQ(maps.size(), 9U);
    const auto first = std::find_if(maps.begin(), maps.end(), [](const spherical::MapSnapshot& map) {
        return map.decision.relation != spherical::SphereRelation::Outside;
    });
    ASSERT_NE(first, maps.end());
    const uint32_t shownFirst = first->decision.instance;
    EXPECT_EQ(shown().map->object, shownFirst);
    pickObject(session, 5);
    settle();
    EXPECT_EQ(shown().map->object, 5U);
    EXPECT_TRUE(translated(shown().map->objectWords).contains(QStringLiteral("(6 of 9)")));
    EXPECT_TRUE(panel.map().contents().picked);
    session.setPick(std::nullopt);
    settle();
    EXPECT_EQ(shown().map->object, shownFirst);
    EXPECT_FALSE(panel.map().contents().picked);
}

TEST_F(LiveMapPanelTest, hiddenObjectsDoNotShiftThePicks) {
    std::vector<bool> hidden(session.hidden().size(), false);
    hidden[0] = hidden[2] = true;
    session.setHidden(hidden);
    settle();
    pickObject(session, 5);
    settle();
    EXPECT_EQ(shown().map->object, 3U);
    uint32_t cell = 0;
    while (shown().source().owned(cell).empty()) ++cell;
    panel.pickIn(cell);
    EXPECT_EQ(session.pick()->object, 5U);
    const auto own = uint32_t(session.pick()->triangle - session.opened()->scene->firstTriangle(5));
    EXPECT_EQ(own, shown().source().owned(cell).back());
}

TEST_F(LiveMapPanelTest, theMapStaysWhileANewOneIsRead) {
    session.setCamera(turned(session.camera(), UpAxis::Y, Angle::fromDegrees(20.0), {}));
    EXPECT_FALSE(reader.fresh());
    EXPECT_FALSE(shown().empty());
    EXPECT_TRUE(panel.sentence().isEmpty());
    const CellMapPointer before = shown().map;
    settle();
    EXPECT_NE(shown().map, before);
}

TEST_F(LiveMapPanelTest, aStepIsPaintedOnce) {
    struct Paints : QObject {
        int count = 0;
        bool eventFilter(QObject* /*watched*/, QEvent* event) override {
            count += event->type() == QEvent::Paint ? 1 : 0;
            return false;
        }
    } paints;
    Stepper stepper(session);
    stepper.start();
    ASSERT_TRUE(waitUntil([&] { return stepper.place() && session.step(); }));
    panel.map().installEventFilter(&paints);
    const FrameLog& log = session.step()->frame->log;
    const auto atStep = [&] { return reader.fresh() && reader.reading()->upTo == session.step()->place; };
    stepper.toEnd();
    ASSERT_TRUE(waitUntil([&] { return atStep() && !shown().empty(); }));
    QApplication::processEvents();
    int painted = 0;
    size_t looked = 0;
    for (size_t step = 1; step < log.decisions.size() && looked < 8; ++step) {
        const Subject& subject = log.decisions[step - 1].subject;
        if (subject.kind == Subject::Kind::Object || shown().empty() || subject.object != shown().map->object) continue;
        paints.count = 0;
        stepper.jump(step);
        ASSERT_TRUE(waitUntil(atStep));
        QApplication::processEvents();
        EXPECT_LE(paints.count, 1) << step;
        painted += paints.count;
        ++looked;
    }
    EXPECT_GT(painted, 0);
}

TEST_F(LiveMapPanelTest, aStrategyThatIsStillBuiltIsSaidToBePrepared) {
    session.slot(1).choose("all");
    settle();
    session.slot(1).choose("spherical");
    QCoreApplication::sendPostedEvents();
    EXPECT_EQ(panel.sentence(), QStringLiteral("The strategy is being prepared…"));
    bool denied = false;
    EXPECT_TRUE(waitUntil([&] {
        denied = denied || panel.sentence() == QStringLiteral("This strategy has no index map.");
        return panel.map().isVisible();
    }));
    EXPECT_FALSE(denied);
}

TEST_F(LiveMapPanelTest, beforeTheStepThatMakesTheMapItIsSaidThatThereIsNoneYet) {
    session.slot(1).choose("spherical");
    settle();
    Stepper stepper(session);
    stepper.start();
    ASSERT_TRUE(waitUntil([&] { return stepper.place() && session.step(); }));
    const auto atStep = [&] { return reader.fresh() && reader.reading()->upTo == session.step()->place; };
    stepper.jump(0);
    ASSERT_TRUE(waitUntil([&] { return stepper.place()->step() == 0 && atStep(); }));
    EXPECT_EQ(panel.sentence(), QStringLiteral("Up to this step there is no index map."));
    EXPECT_TRUE(panel.map().isHidden());
    stepper.toEnd();
    EXPECT_TRUE(waitUntil([&] { return atStep() && !shown().empty(); }));
}

TEST(LiveMapPanel, withoutASceneThereIsNothingToPrepare) {
    Session session{sessionOptions(false)};
    SnapshotReader reader{session};
    const MapPanel panel{session, reader};
    EXPECT_TRUE(panel.sentence().startsWith(QStringLiteral("Open a scene"))) << panel.sentence().toStdString();
}

TEST_F(LiveMapPanelTest, theMapGoesWithTheStrategyAndFollowsTheScene) {
    session.slot(1).choose("all");
    settle();
    EXPECT_EQ(panel.sentence(), QStringLiteral("This strategy has no index map."));
    EXPECT_TRUE(panel.map().isHidden());
    session.slot(1).choose("spherical");
    settle();
    EXPECT_TRUE(panel.map().isVisible());
    openAndWait(session, QStringLiteral("torus:triangles=800"));
    settle();
    EXPECT_EQ(shown().scene, session.scene());
    EXPECT_FALSE(translated(shown().map->objectWords).contains(QLatin1Char('(')));
}

}  // namespace
}  // namespace cullscope::ui::map_panel_live_test
