// The panels of curves and maps with what a strategy declares that only the tests know.
#include <gtest/gtest.h>

#include "tests/support/directions_strategy.h"
#include "tests/ui/test_scene.h"
#include "ui/look/verdict_swatch.h"
#include "ui/panels/structure_panel.h"
#include "ui/plots/plot_file.h"

namespace cullscope::ui::declared_shows_test {
namespace {

struct DeclaredShows : ::testing::Test {
    void SetUp() override {
        openAndWait(session, QStringLiteral("sphere:triangles=800"));
        built = buildStrategy(strategy, ParameterSet(strategy.info.parameters), session.scene(), structures);
        log = built->decide(View(session.camera(), {160, 120}), *built->begin(), true);
        panel.resize(440, 900);
        panel.setShows(strategy.info.shows);
        panel.show();
        ASSERT_TRUE(QTest::qWaitForWindowExposed(&panel, kPatience));
    }

    Session session{sessionOptions(false)};
    SnapshotReader reader{session};
    StructurePanel panel{session, reader};
    StructureStore structures;
    RegisteredStrategy strategy = test::directionsStrategy();
    BuiltStrategyPointer built;
    FrameLog log;
};

TEST_F(DeclaredShows, curveHasItsTabItsPartsAndItsWords) {
    ASSERT_EQ(panel.curves().size(), 1U);
    CurvePanel& curve = *panel.curves().front();
    EXPECT_EQ(panel.tabs().tabText(panel.tabs().indexOf(&curve)), QStringLiteral("Columns"));
    panel.tabs().setCurrentWidget(&curve);
    curve.show([this](const std::optional<uint32_t>& part) { return built->curve("by-column", log, {}, part); });
    ASSERT_FALSE(curve.plot().empty());
    EXPECT_EQ(curve.plot().title(), QStringLiteral("Triangles by azimuth"));
    EXPECT_FALSE(curve.shownPart());
    EXPECT_EQ(curve.part().maximum(), 4);
    EXPECT_EQ(curve.part().text(), QStringLiteral("all rows"));
    curve.part().setValue(2);
    EXPECT_EQ(curve.shownPart(), 2U);
    const double count = curve.plot().curve()->areas.front().boxes.front().top;
    const QPointF place = curve.plot().placeOf(20.0, count / 2);
    EXPECT_EQ(curve.plot().wordsAt(place), QStringLiteral("%1 triangles here").arg(int(count)));
    const QImage image = curve.plot().grab().toImage();
    EXPECT_EQ(image.pixelColor(place.toPoint()), verdictColour(TriangleState::Visible, curve.plot().palette()));
    EXPECT_TRUE(plotSvg(curve.plot(), {960, 420}).contains(">270°</text>"));
    panel.setShows({});
    EXPECT_TRUE(panel.curves().empty());
    EXPECT_EQ(panel.tabs().indexOf(&curve), -1);
}

TEST_F(DeclaredShows, mapHasItsColouringsItsMarksAndItsPicks) {
    MapPanel& map = panel.map();
    const CellMapPointer shown = built->directionMap("by-direction", log);
    map.showMap({session.scene(), shown});
    EXPECT_TRUE(map.sentence().isEmpty());
    ASSERT_EQ(map.colouring().count(), 2);
    EXPECT_EQ(map.colouring().itemText(1), QStringLiteral("Fate"));
    EXPECT_EQ(map.map().colouring(), "number");
    EXPECT_EQ(map.map().title(), QStringLiteral("Triangles by direction"));
    EXPECT_TRUE(map.map().accessibleDescription().contains(QStringLiteral("All of it is drawn.")));
    const MapLayout layout = map.map().layoutOfMap();
    EXPECT_EQ(map.map().wordsAt(layout.placeOf(shown->marks.front().place)), QStringLiteral("the seventh place"));
    const QPointF cell = layout.rectOf(shown->grid, SphericalGrid::Cell{3, 6}).center();
    EXPECT_TRUE(map.map().wordsAt(cell).startsWith(QStringLiteral("cell 30\ntriangles: ")));
    map.map().setColouring("fate");
    EXPECT_EQ(map.map().grab().toImage().pixelColor(cell.toPoint()), verdictColour(TriangleState::Visible, map.map().palette()));
    map.setPart(8);
    EXPECT_EQ(map.map().contents().part, 8U);
    EXPECT_TRUE(plotSvg(map.map(), {960, 560}).contains("column 8</text>"));
    map.setPart(9);
    EXPECT_FALSE(map.map().contents().part) << "there are eight";
    map.pickIn(30);
    ASSERT_TRUE(session.pick());
    EXPECT_EQ(session.pick()->triangle, shown->source->owned(30).back());
}

}  // namespace
}  // namespace cullscope::ui::declared_shows_test
