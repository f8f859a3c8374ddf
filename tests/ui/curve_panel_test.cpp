// The panel of curves with those of contour bands.
#include "ui/panels/curve_panel.h"

#include <gtest/gtest.h>

#include "core/visibility/spherical/band_curve.h"
#include "tests/ui/made_up_map.h"
#include "tests/ui/test_scene.h"
#include "ui/look/verdict_swatch.h"
#include "ui/plots/plot_file.h"

namespace cullscope::ui::curve_panel_test {
namespace {

const Show& bandShow() {
    for (const Show& show : findStrategy("spherical").info.shows)
        if (show.kind == Show::Kind::Curve) return show;
    throw std::logic_error("spherical declares no curve");
}

struct CurvePanelTest : ::testing::Test {
    void SetUp() override {
        openAndWait(session, QStringLiteral("torus:triangles=800"));
        panel.resize(400, 260);
        showDecision();
        panel.show();
        ASSERT_TRUE(QTest::qWaitForWindowExposed(&panel, kPatience));
    }

    void showDecision() {
        panel.show([shown = seen](const std::optional<uint32_t>& part) { return bandCurve(shown, "torus", part); });
    }
    void change(const std::function<void(spherical::SphericalDecision&)>& how) {
        how(seen);
        showDecision();
    }
    [[nodiscard]] const Curve& curve() { return *panel.plot().curve(); }
    /// The number of boxes of drawn or of hidden bands.
    [[nodiscard]] size_t boxes(size_t area) { return curve().areas[area].boxes.size(); }
    /// The cut in degrees.
    [[nodiscard]] std::optional<double> cut() { return curve().uprights.back().at; }
    [[nodiscard]] QColor colourAt(double degrees, double size) {
        const QPoint place = panel.plot().placeOf(degrees, size).toPoint();
        return panel.plot().grab().toImage().pixelColor(place);
    }

    Session session{sessionOptions(false)};
    SnapshotReader reader{session};
    CurvePanel panel{session, reader, bandShow()};
    spherical::SphericalDecision seen = withinDecision({0, 0, 5});
};

TEST_F(CurvePanelTest, allSectorsHaveTheLargestOfEach) {
    panel.part().setValue(0);
    const spherical::ContourBands& table = *seen.bands;
    ASSERT_EQ(curve().intervals.size(), table.bands);
    ASSERT_EQ(boxes(0), 11U);
    ASSERT_EQ(boxes(1), table.bands - 11U);
    for (uint32_t band = 0; band < table.bands; ++band) {
        double largest = 0.0, horizon = 0.0;
        for (uint32_t sector = 0; sector < table.sectors; ++sector) {
            largest = std::max(largest, table.at(band, sector).size);
            horizon = std::max(horizon, table.at(band, sector).horizon);
        }
        const CurveArea::Box& box = band < 11 ? curve().areas[0].boxes[band] : curve().areas[1].boxes[band - 11];
        EXPECT_NEAR(box.left, 10.0 * band, 1e-9);
        EXPECT_DOUBLE_EQ(box.top, largest);
        EXPECT_DOUBLE_EQ(curveBands(table, std::nullopt)[band].horizon, horizon);
    }
    panel.part().setValue(3);
    EXPECT_EQ(panel.shownPart(), 3U);
    EXPECT_DOUBLE_EQ(curve().areas[0].boxes[4].top, table.at(4, 2).size);
    panel.part().setValue(0);
    EXPECT_FALSE(panel.shownPart());
}

TEST_F(CurvePanelTest, theLargestNearerIsDrawnForOneSectorOnly) {
    const QColor ground = PlotColours(panel.plot().palette()).ground;
    const double horizon = seen.bands->at(17, 7).horizon;
    panel.part().setValue(8);
    EXPECT_NE(colourAt(175, horizon), ground);
    EXPECT_TRUE(panel.plot().accessibleDescription().contains(QStringLiteral("largest nearer")));
    panel.part().setValue(0);
    EXPECT_EQ(colourAt(175, horizon), ground) << "drawn bands are compared with another sector's";
    EXPECT_FALSE(panel.plot().accessibleDescription().contains(QStringLiteral("largest nearer")));
    EXPECT_TRUE(panel.plot().accessibleDescription().contains(QStringLiteral("Each sector is compared by itself")));
    EXPECT_TRUE(plotSvg(panel.plot(), {960, 420}).contains("drawn in some sectors</text>"));
}

TEST_F(CurvePanelTest, untilOneIsChosenTheSectorIsTheOneDrawnFarthest) {
    EXPECT_EQ(panel.part().value(), 1) << "all are cut at the same band";
    change([](spherical::SphericalDecision& decision) {
        decision.bands->table[14 * 8 + 5].drawn = true;
        for (uint32_t band = 0; band < 18; ++band) decision.bands->table[band * 8 + 3].drawn = true;
    });
    EXPECT_EQ(panel.part().value(), 6) << "the fourth is not cut";
    EXPECT_EQ(panel.shownPart(), 6U);
    panel.part().setValue(2);
    change([](spherical::SphericalDecision& decision) { decision.bands->table[15 * 8 + 4].drawn = true; });
    EXPECT_EQ(panel.part().value(), 2) << "it was chosen";
}

TEST_F(CurvePanelTest, drawnAndHiddenBandsDiffer) {
    panel.part().setValue(0);
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

TEST_F(CurvePanelTest, theCutIsWhereTheLastDrawnBandEnds) {
    panel.part().setValue(0);
    ASSERT_TRUE(cut());
    EXPECT_NEAR(*cut(), 110.0, 1e-9);
    change([](spherical::SphericalDecision& decision) { decision.bands->table[14 * 8 + 5].drawn = true; });
    EXPECT_NEAR(*cut(), 150.0, 1e-9);
    panel.part().setValue(2);
    EXPECT_NEAR(*cut(), 110.0, 1e-9) << "that of another sector";
    change([](spherical::SphericalDecision& decision) {
        for (spherical::BandSector& sector : decision.bands->table) sector.drawn = true;
    });
    EXPECT_FALSE(cut());
}

TEST_F(CurvePanelTest, sectorsInWhichNothingLiesAreNeitherDrawnNorHidden) {
    panel.part().setValue(0);
    change([](spherical::SphericalDecision& decision) {
        for (uint32_t sector = 0; sector < 8; ++sector) decision.bands->table[17 * 8 + sector].size = 0.0;
        decision.bands->table[16 * 8].size = std::numeric_limits<double>::infinity();
    });
    EXPECT_TRUE(curve().intervals[17].empty);
    ASSERT_EQ(boxes(1), 6U);
    EXPECT_TRUE(std::isfinite(curve().areas[1].boxes.back().top));
    const QPointF place = panel.plot().placeOf(175.0, 0.1);
    EXPECT_TRUE(panel.plot().wordsAt(place).contains(QStringLiteral("Nothing lies here.")));
}

TEST_F(CurvePanelTest, theAxisSaysSOrSlope) {
    EXPECT_TRUE(panel.plot().accessibleDescription().contains(QStringLiteral("S, mesh units")));
    change([](spherical::SphericalDecision& decision) { decision.bands->slopes = true; });
    EXPECT_TRUE(panel.plot().accessibleDescription().contains(QStringLiteral("slope")));
    EXPECT_FALSE(panel.plot().accessibleDescription().contains(QStringLiteral("mesh units")));
}

TEST_F(CurvePanelTest, filesHaveTheirWordsAsText) {
    const QByteArray svg = plotSvg(panel.plot(), {960, 420});
    EXPECT_TRUE(svg.contains(">150°</text>"));
    EXPECT_TRUE(svg.contains("110°</text>")) << "the cut";
    EXPECT_TRUE(plotPdf(panel.plot(), {960, 420}).startsWith("%PDF"));
    const QTemporaryDir folder;
    const QString file = folder.filePath(QStringLiteral("bands.png"));
    panel.pictures().save(file.toStdString());
    EXPECT_TRUE(waitUntil([&] { return !QImage(file).isNull(); }));
}

TEST_F(CurvePanelTest, withoutBandsASentenceSaysWhy) {
    change([](spherical::SphericalDecision& decision) { decision = cutDecision({0.9, 1.0}, {1.9, 2.0}, 2); });
    EXPECT_TRUE(panel.plot().empty());
    EXPECT_TRUE(panel.plot().accessibleDescription().contains(QStringLiteral("cut by the frustum")));
    EXPECT_FALSE(panel.part().isVisible());
    panel.show(nullptr);
    EXPECT_EQ(panel.plot().accessibleDescription(), QStringLiteral("The strategy is being prepared…"));
    EXPECT_EQ(panel.plot().accessibleName(), QStringLiteral("Bands"));
    panel.plot().setAbsence({});
    EXPECT_EQ(panel.plot().accessibleDescription(), QStringLiteral("This frame has nothing to show here."));
    change([](spherical::SphericalDecision& decision) { decision = withinDecision({0, 0, 5}); });
    EXPECT_FALSE(panel.plot().empty());
    EXPECT_TRUE(panel.part().isVisible());
}

TEST_F(CurvePanelTest, aChosenSectorOutlivesAnObjectWithoutBands) {
    panel.part().setValue(8);
    panel.show(nullptr);
    EXPECT_FALSE(panel.shownPart());
    showDecision();
    EXPECT_EQ(panel.shownPart(), 8U);
    change([](spherical::SphericalDecision& decision) {
        decision.bands->sectors = 4;
        decision.bands->bands = 36;
        decision.bands->width /= 2;
    });
    EXPECT_EQ(panel.part().value(), 1) << "there is no eighth sector any more";
    EXPECT_EQ(panel.shownPart(), 1U);
}

TEST(CurvePanelLive, readsWhatTheStrategyTested) {
    Session session{sessionOptions(true)};
    SnapshotReader reader{session};
    CurvePanel panel{session, reader, bandShow()};
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
    const std::optional<double> cut = panel.plot().curve()->uprights.back().at;
    ASSERT_TRUE(cut);
    EXPECT_GE(*cut, 90.0);
    EXPECT_LT(*cut, 180.0);
}

}  // namespace
}  // namespace cullscope::ui::curve_panel_test
