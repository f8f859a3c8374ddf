#include "ui/families/spherical/bands_panel.h"

#include <gtest/gtest.h>

#include <QTranslator>

#include "tests/ui/made_up_map.h"
#include "tests/ui/test_scene.h"
#include "ui/look/verdict_swatch.h"
#include "ui/plots/plot_file.h"

namespace cullscope::ui::bands_panel_test {
namespace {

constexpr double kDegree = std::numbers::pi / 180.0;

struct BandsPanelTest : ::testing::Test {
    void SetUp() override {
        openAndWait(session, QStringLiteral("torus:triangles=800"));
        shown = shownAlone(session.scene(), SphericalGrid(32, 16));
        panel.resize(400, 260);
        panel.showMap(shown);
        panel.show();
        ASSERT_TRUE(QTest::qWaitForWindowExposed(&panel, kPatience));
    }

    void change(const std::function<void(spherical::SphericalDecision&)>& how) {
        shown = changed(shown, how);
        panel.showMap(shown);
    }
    [[nodiscard]] QColor colourAt(double degrees, double size) {
        const QPoint place = panel.plot().placeOf(degrees * kDegree, size).toPoint();
        return panel.plot().grab().toImage().pixelColor(place);
    }

    Session session{sessionOptions(false)};
    SnapshotReader reader{session};
    BandsPanel panel{session, reader};
    ShownMap shown;
};

TEST_F(BandsPanelTest, allSectorsHaveTheLargestOfEach) {
    panel.sector().setValue(0);
    const spherical::ContourBands& table = *shown.decision().bands;
    const std::vector<BandsPlot::Band> bands = panel.plot().bands();
    ASSERT_EQ(bands.size(), table.bands);
    for (uint32_t band = 0; band < table.bands; ++band) {
        double largest = 0.0, horizon = 0.0;
        for (uint32_t sector = 0; sector < table.sectors; ++sector) {
            largest = std::max(largest, table.at(band, sector).size);
            horizon = std::max(horizon, table.at(band, sector).horizon);
        }
        EXPECT_EQ(bands[band].anyDrawn, band < 11);
        EXPECT_DOUBLE_EQ(std::max(bands[band].drawn, bands[band].hidden), largest);
        EXPECT_DOUBLE_EQ(bands[band].horizon, horizon);
    }
    panel.sector().setValue(3);
    EXPECT_EQ(panel.plot().sector(), 2U);
    EXPECT_DOUBLE_EQ(panel.plot().bands()[4].drawn, table.at(4, 2).size);
    panel.sector().setValue(0);
    EXPECT_FALSE(panel.plot().sector());
}

TEST_F(BandsPanelTest, theLargestNearerIsDrawnForOneSectorOnly) {
    const QColor ground = PlotColours(panel.plot().palette()).ground;
    const double horizon = shown.decision().bands->at(17, 7).horizon;
    panel.sector().setValue(8);
    EXPECT_NE(colourAt(175, horizon), ground);
    EXPECT_TRUE(panel.plot().accessibleDescription().contains(QStringLiteral("largest nearer")));
    panel.sector().setValue(0);
    EXPECT_EQ(colourAt(175, horizon), ground) << "drawn bands are compared with another sector's";
    EXPECT_FALSE(panel.plot().accessibleDescription().contains(QStringLiteral("largest nearer")));
    EXPECT_TRUE(panel.plot().accessibleDescription().contains(QStringLiteral("Each sector is compared by itself")));
    EXPECT_TRUE(plotSvg(panel.plot(), {960, 420}).contains("drawn in some sectors</text>"));
}

TEST_F(BandsPanelTest, untilOneIsChosenTheSectorIsTheOneDrawnFarthest) {
    EXPECT_EQ(panel.sector().value(), 1) << "all are cut at the same band";
    change([](spherical::SphericalDecision& decision) {
        decision.bands->table[14 * 8 + 5].drawn = true;
        for (uint32_t band = 0; band < 18; ++band) decision.bands->table[band * 8 + 3].drawn = true;
    });
    EXPECT_EQ(panel.sector().value(), 6) << "the fourth is not cut";
    EXPECT_EQ(panel.plot().sector(), 5U);
    panel.sector().setValue(2);
    change([](spherical::SphericalDecision& decision) { decision.bands->table[15 * 8 + 4].drawn = true; });
    EXPECT_EQ(panel.sector().value(), 2) << "it was chosen";
}

TEST_F(BandsPanelTest, drawnAndHiddenBandsDiffer) {
    panel.sector().setValue(0);
    const QPalette palette = panel.plot().palette();
    EXPECT_EQ(colourAt(45, 0.2), verdictColour(TriangleState::Visible, palette));
    EXPECT_EQ(colourAt(145, 0.2), verdictColour(TriangleState::Hidden, palette));
    change([](spherical::SphericalDecision& decision) {
        for (uint32_t sector = 0; sector < 4; ++sector) decision.bands->table[14 * 8 + sector].drawn = true;
    });
    // Some sectors of this band are drawn and others hidden, so it shows both colours.
    EXPECT_EQ(colourAt(142, 0.2), verdictColour(TriangleState::Visible, palette));
    EXPECT_EQ(colourAt(148, 0.2), verdictColour(TriangleState::Hidden, palette));
}

TEST_F(BandsPanelTest, theCutIsWhereTheLastDrawnBandEnds) {
    panel.sector().setValue(0);
    ASSERT_TRUE(panel.plot().cut());
    EXPECT_NEAR(*panel.plot().cut(), 110.0 * kDegree, 1e-12);
    change([](spherical::SphericalDecision& decision) { decision.bands->table[14 * 8 + 5].drawn = true; });
    EXPECT_NEAR(*panel.plot().cut(), 150.0 * kDegree, 1e-12);
    panel.sector().setValue(2);
    EXPECT_NEAR(*panel.plot().cut(), 110.0 * kDegree, 1e-12) << "that of another sector";
    change([](spherical::SphericalDecision& decision) {
        for (spherical::BandSector& sector : decision.bands->table) sector.drawn = true;
    });
    EXPECT_FALSE(panel.plot().cut());
}

TEST_F(BandsPanelTest, sectorsInWhichNothingLiesAreNeitherDrawnNorHidden) {
    panel.sector().setValue(0);
    change([](spherical::SphericalDecision& decision) {
        for (uint32_t sector = 0; sector < 8; ++sector) decision.bands->table[17 * 8 + sector].size = 0.0;
        decision.bands->table[16 * 8].size = std::numeric_limits<double>::infinity();
    });
    const std::vector<BandsPlot::Band> bands = panel.plot().bands();
    EXPECT_FALSE(bands[17].anyDrawn || bands[17].anyHidden);
    EXPECT_TRUE(std::isfinite(bands[16].hidden));
    const QPointF place = panel.plot().placeOf(175.0 * kDegree, 0.1);
    EXPECT_TRUE(panel.plot().wordsAt(place).contains(QStringLiteral("Nothing lies here.")));
}

TEST_F(BandsPanelTest, theAxisSaysSOrSlope) {
    EXPECT_TRUE(panel.plot().accessibleDescription().contains(QStringLiteral("S, mesh units")));
    change([](spherical::SphericalDecision& decision) { decision.bands->slopes = true; });
    EXPECT_TRUE(panel.plot().accessibleDescription().contains(QStringLiteral("slope")));
    EXPECT_FALSE(panel.plot().accessibleDescription().contains(QStringLiteral("mesh units")));
}

TEST_F(BandsPanelTest, filesHaveTheirWordsAsText) {
    const QByteArray svg = plotSvg(panel.plot(), {960, 420});
    EXPECT_TRUE(svg.contains(">150°</text>"));
    EXPECT_TRUE(svg.contains("110°</text>")) << "the cut";
    EXPECT_TRUE(plotPdf(panel.plot(), {960, 420}).startsWith("%PDF"));
    const QTemporaryDir folder;
    const QString file = folder.filePath(QStringLiteral("bands.png"));
    panel.pictures().save(file.toStdString());
    EXPECT_TRUE(waitUntil([&] { return !QImage(file).isNull(); }));
}

TEST_F(BandsPanelTest, withoutBandsASentenceSaysWhy) {
    change([](spherical::SphericalDecision& decision) { decision = cutDecision({0.9, 1.0}, {1.9, 2.0}, 2); });
    EXPECT_TRUE(panel.plot().empty());
    EXPECT_TRUE(panel.plot().accessibleDescription().contains(QStringLiteral("cut by the frustum")));
    EXPECT_FALSE(panel.sector().isVisible());
    panel.showMap({});
    EXPECT_EQ(panel.plot().accessibleDescription(), QStringLiteral("The strategy is being prepared…"));
    panel.plot().setAbsence(MapAbsence::NoMaps);
    EXPECT_TRUE(panel.plot().accessibleDescription().startsWith(QStringLiteral("This strategy has no bands.")));
    change([](spherical::SphericalDecision& decision) { decision = withinDecision({0, 0, 5}); });
    EXPECT_FALSE(panel.plot().empty());
    EXPECT_TRUE(panel.sector().isVisible());
}

TEST_F(BandsPanelTest, aChosenSectorOutlivesAnObjectWithoutBands) {
    panel.sector().setValue(8);
    const ShownMap before = shown;
    panel.showMap({});
    panel.showMap(before);
    EXPECT_EQ(panel.plot().sector(), 7U);
    change([](spherical::SphericalDecision& decision) {
        decision.bands->sectors = 4;
        decision.bands->bands = 36;
        decision.bands->width /= 2;
    });
    EXPECT_EQ(panel.sector().value(), 1) << "there is no eighth sector any more";
    EXPECT_EQ(panel.plot().sector(), 0U);
}

TEST(BandsPanelLive, readsWhatTheStrategyTested) {
    Session session{sessionOptions(true)};
    SnapshotReader reader{session};
    BandsPanel panel{session, reader};
    session.setViewport(1, {160, 120});
    session.slot(1).choose("spherical");
    openAndWait(session, QStringLiteral("star:seed=3,triangles=2000"));
    reader.readFor(&panel);
    panel.resize(400, 260);
    panel.show();
    Camera camera = session.camera();
    camera.eye = camera.target + 2.0 * (camera.eye - camera.target);
    session.setCamera(camera);
    ASSERT_TRUE(waitUntil([&] { return !session.slot(1).building() && reader.fresh(); }));
    ASSERT_FALSE(panel.plot().empty());
    const std::optional<double> cut = panel.plot().cut();
    ASSERT_TRUE(cut);
    EXPECT_GE(*cut, 90.0 * kDegree);
    EXPECT_LT(*cut, 180.0 * kDegree);
}

}  // namespace
}  // namespace cullscope::ui::bands_panel_test
