#include "ui/panels/map_panel.h"

#include <gtest/gtest.h>

#include <QTranslator>
#include <set>

#include "tests/ui/made_up_map.h"
#include "tests/ui/test_scene.h"
#include "ui/look/appearance.h"
#include "ui/look/verdict_swatch.h"
#include "ui/plots/plot_file.h"
#include "ui/session/object_pick.h"
#include "ui/text/terms.h"

namespace cullscope::ui::map_panel_test {
namespace {

using Cell = SphericalGrid::Cell;

bool isReddish(QRgb pixel) { return qRed(pixel) > 170 && qGreen(pixel) < 90 && qBlue(pixel) < 90; }

/// Translates every text of the program into itself between two markers.
class Marking : public QTranslator {
public:
    [[nodiscard]] bool isEmpty() const override { return false; }
    [[nodiscard]] QString translate(const char* context, const char* source, const char*, int) const override {
        const bool ours = QByteArray(context).startsWith("cullscope::ui::") || QByteArray(context) == "core";
        return ours ? QStringLiteral("«%1»").arg(QString::fromUtf8(source)) : QString();
    }
};

/// A panel for a session with one object; the tests set its map.
struct MapPanelTest : ::testing::Test {
    void SetUp() override {
        openAndWait(session, QStringLiteral("knot:triangles=4000"));
        made = MadeUpMap(session.scene(), SphericalGrid(64, 32));
        shown = made.shown();
        panel.resize(400, 330);
        panel.showMap(shown);
        panel.show();
        ASSERT_TRUE(QTest::qWaitForWindowExposed(&panel, kPatience));
    }

    void change(const std::function<void(spherical::SphericalDecision&)>& how) {
        how(made.decision);
        shown = made.shown();
        panel.showMap(shown);
    }
    void colourBy(const char* colouring) {
        const int index = panel.colouring().findData(QString::fromLatin1(colouring));
        ASSERT_GE(index, 0);
        panel.colouring().setCurrentIndex(index);
        emit panel.colouring().activated(index);
    }
    [[nodiscard]] QPoint pixelOf(uint32_t cell) {
        return panel.map().layoutOfMap().rectOf(shown.grid(), shown.grid().cell(cell)).center().toPoint();
    }
    [[nodiscard]] uint32_t cellWith(size_t least) const {
        for (uint32_t cell = shown.grid().cellCount() / 4; cell < shown.grid().cellCount(); ++cell)
            if (shown.source().owned(cell).size() >= least) return cell;
        ADD_FAILURE() << "no cell owns so many";
        return 0;
    }
    void click(uint32_t cell) { QTest::mouseClick(&panel.map(), Qt::LeftButton, {}, pixelOf(cell)); }
    [[nodiscard]] QImage picture() { return panel.map().grab().toImage(); }

    Session session{sessionOptions(false)};
    SnapshotReader reader{session};
    MapPanel panel{session, reader};
    MadeUpMap made;
    ShownMap shown;
};

TEST_F(MapPanelTest, clicksGoThroughTheCellFromTheFarthest) {
    const uint32_t cell = cellWith(3);
    const std::span<const uint32_t> owned = shown.source().owned(cell);
    std::set<uint64_t> seen;
    float before = std::numeric_limits<float>::max();
    for (size_t i = 0; i < owned.size(); ++i) {
        click(cell);
        ASSERT_TRUE(session.pick());
        const auto triangle = uint32_t(session.pick()->triangle);
        EXPECT_EQ(shown.grid().number(shown.source().ownerOf(triangle)), cell);
        EXPECT_LE(made.maps->centroidRadius(triangle), before);
        before = made.maps->centroidRadius(triangle);
        EXPECT_TRUE(seen.insert(triangle).second) << "picked twice";
        // A change of the session makes the panel show the reader's map, which is empty: set the map of the test again.
        panel.showMap(shown);
    }
    EXPECT_EQ(seen.size(), owned.size());
    const Vec3 point = session.pick()->point;
    const auto [a, b, c] = made.maps->corners(uint32_t(session.pick()->triangle));
    const Vec3 centroid = made.maps->mesh().origin() + made.maps->sphere().centre + (a + b + c) / 3.0;
    EXPECT_LT(glm::distance(point, centroid), 1e-6);
}

TEST_F(MapPanelTest, cellsThatOnlyTouchTrianglesPickThemToo) {
    uint32_t cell = 0;
    while (shown.source().touching(cell).empty() || !shown.source().owned(cell).empty()) ++cell;
    panel.pickIn(cell);
    ASSERT_TRUE(session.pick());
    EXPECT_EQ(session.pick()->triangle, shown.source().touching(cell).back());
    session.setPick(std::nullopt);
    panel.showMap(shown);
    uint32_t empty = 0;
    while (!shown.source().touching(empty).empty()) ++empty;
    panel.pickIn(empty);
    EXPECT_FALSE(session.pick());
}

TEST_F(MapPanelTest, aPickElsewhereIsMarkedInEveryCellItTouches) {
    const QImage before = picture();
    const uint32_t triangle = 1234;
    session.setPick(pickOfTriangle(session, 0, triangle));
    panel.showMap(shown);
    EXPECT_EQ(panel.map().contents().picked, triangle);
    std::set<uint32_t> marked;
    for (const Cell& cell : shown.source().cellsOf(triangle)) marked.insert(shown.grid().number(cell));
    for (uint32_t cell = 0; cell < shown.grid().cellCount(); ++cell) {
        const std::span<const uint32_t> entries = shown.source().touching(cell);
        const bool entered = std::find(entries.begin(), entries.end(), triangle) != entries.end();
        EXPECT_EQ(marked.contains(cell), entered) << cell;
    }
    const uint32_t centroid = shown.grid().number(shown.source().ownerOf(triangle));
    EXPECT_EQ(QColor(picture().pixel(pixelOf(centroid))), MapColours(panel.map().palette()).picked);
    EXPECT_NE(QColor(before.pixel(pixelOf(centroid))), MapColours(panel.map().palette()).picked);
    session.setPick(std::nullopt);
    panel.showMap(shown);
    EXPECT_EQ(picture(), before);
}

TEST_F(MapPanelTest, drawnAndCulledCellsDiffer) {
    const uint32_t drawn = cellWith(1);
    uint32_t culled = drawn + 3;
    while (shown.source().owned(culled).empty()) ++culled;
    const auto choose = [&](spherical::SphericalDecision& decision) {
        decision.relation = spherical::SphereRelation::Cut;
        decision.bands.reset();
        decision.drawn = {{drawn, drawn + 1}};
    };
    change(choose);
    colourBy("state");
    const QPalette palette = panel.map().palette();
    EXPECT_EQ(QColor(picture().pixel(pixelOf(drawn))), verdictColour(TriangleState::Visible, palette));
    EXPECT_EQ(QColor(picture().pixel(pixelOf(culled))), verdictColour(TriangleState::OutsideFrustum, palette));
    change([&](spherical::SphericalDecision& decision) { decision.drawn = {{culled, culled + 1}}; });
    EXPECT_EQ(QColor(picture().pixel(pixelOf(culled))), verdictColour(TriangleState::Visible, palette));
    for (const char* colouring : {"entries", "radius"}) {
        colourBy(colouring);
        EXPECT_NE(QColor(picture().pixel(pixelOf(culled))), verdictColour(TriangleState::Visible, palette));
    }
}

TEST_F(MapPanelTest, aRegionOverTheSeamIsOutlinedOnBothSides) {
    change([](spherical::SphericalDecision& decision) { decision = cutDecision({0.9, -0.5}, {1.9, 0.7}, 3); });
    const QImage image = picture();
    const QRectF area = panel.map().layoutOfMap().area;
    const auto reds = [&](const QRectF& part) {
        int count = 0;
        for (int y = int(part.top()); y < int(part.bottom()); ++y)
            for (int x = int(part.left()); x < int(part.right()); ++x) count += isReddish(image.pixel(x, y)) ? 1 : 0;
        return count;
    };
    EXPECT_GT(reds({area.left(), area.top(), area.width() / 6, area.height()}), 20);
    EXPECT_GT(reds({area.right() - area.width() / 6, area.top(), area.width() / 6, area.height()}), 20);
    EXPECT_EQ(reds({area.left() + area.width() / 3, area.top(), area.width() / 3, area.height()}), 0);
}

TEST_F(MapPanelTest, casesAreSaidInWords) {
    for (int number = 1; number <= 3; ++number) {
        change([&](spherical::SphericalDecision& decision) { decision = cutDecision({0.9, 1.0}, {1.9, 2.0}, number); });
        EXPECT_TRUE(translated(shown.map->decisionWords).startsWith(QStringLiteral("Case %1:").arg(number)));
        EXPECT_TRUE(panel.map().accessibleDescription().contains(QStringLiteral("Case %1:").arg(number)));
    }
    change([](spherical::SphericalDecision& decision) {
        decision = {};
        decision.relation = spherical::SphereRelation::Outside;
    });
    EXPECT_EQ(translated(shown.map->decisionWords), QStringLiteral("Nothing of it is drawn."));
    EXPECT_TRUE(translated(shown.map->objectWords).endsWith(QStringLiteral("outside the frustum")));
}

TEST_F(MapPanelTest, cornersSayWhetherTheyWereHit) {
    change([](spherical::SphericalDecision& decision) {
        decision = cutDecision({0.9, 1.0}, {1.9, 2.0}, 2);
        decision.rays[0].span = Span{1.0, 2.0};
        decision.rays[0].hit = TriangleHit{17, 1.5};
        decision.rays[2].span = Span{1.0, 2.0};
    });
    const auto at = [&](size_t corner) {
        return panel.map().wordsAt(panel.map().layoutOfMap().placeOf(shown.map->marks[corner].place));
    };
    EXPECT_EQ(at(0), QStringLiteral("Corner ray 1, bottom left: confirmed on triangle 17."));
    EXPECT_TRUE(at(1).contains(QStringLiteral("misses the sphere")));
    EXPECT_TRUE(at(2).contains(QStringLiteral("passes the object by")));
    const MapLayout layout = panel.map().layoutOfMap();
    EXPECT_TRUE(panel.map().wordsAt(layout.area.topLeft() + QPointF(1, 1)).startsWith(QStringLiteral("Row 0, column 0")));
    EXPECT_TRUE(panel.map().wordsAt({1, 1}).isEmpty());
}

TEST_F(MapPanelTest, aChosenSectorIsMarked) {
    const QImage before = picture();
    panel.setPart(3);
    EXPECT_EQ(panel.map().contents().part, 3U);
    EXPECT_NE(picture(), before);
    EXPECT_TRUE(plotSvg(panel.map(), {960, 560}).contains("sector 3</text>"));
    panel.setPart(9);
    EXPECT_FALSE(panel.map().contents().part) << "there are eight";
    EXPECT_EQ(picture(), before);
    panel.setPart(3);
    change([](spherical::SphericalDecision& decision) { decision = cutDecision({0.9, 1.0}, {1.9, 2.0}, 2); });
    EXPECT_FALSE(panel.map().contents().part);
}

TEST_F(MapPanelTest, legendHasTheRightAngleAndTheColourOfTheVeil) {
    const QByteArray svg = plotSvg(panel.map(), {960, 560});
    EXPECT_TRUE(svg.contains("α = 90°</text>"));
    EXPECT_TRUE(svg.contains("every 20°</text>")) << "bands of 10°";
    const QPalette palette = Appearance::palette(false);
    MapPainter painter;
    painter.setContents(panel.map().contents());
    EXPECT_TRUE(svg.contains(painter.veiledColour(palette).name().toUtf8()));
    const MapColours colours(palette);
    QImage image(1, 1, QImage::Format_RGB32);
    image.fill(QColor(200, 40, 90));
    QPainter(&image).fillRect(image.rect(), colours.veil);
    const QColor painted = image.pixelColor(0, 0), said = colours.veiled(QColor(200, 40, 90));
    EXPECT_NEAR(said.red(), painted.red(), 1);
    EXPECT_NEAR(said.green(), painted.green(), 1);
    EXPECT_NEAR(said.blue(), painted.blue(), 1);
}

TEST_F(MapPanelTest, theCaptionOfABriefMapStandsBesideALowOneAndIsWholeAboveANarrowOne) {
    MapWidget map;
    map.setContents({shown, nullptr, {}, {}, {}});
    map.setBrief();
    const double line = QFontMetricsF(map.font()).height();
    map.resize(427, 127);
    EXPECT_LT(map.layoutOfMap().area.top(), line) << "no line above it";
    EXPECT_GT(map.layoutOfMap().area.height(), 127 - 3.5 * line) << "all the height that its numbers leave";
    EXPECT_LT(map.layoutOfMap().area.right(), 427 * 0.6) << "room for the words";
    map.resize(200, 300);
    EXPECT_GT(map.layoutOfMap().area.top(), 2 * line) << "two lines above it";
    EXPECT_LE(map.layoutOfMap().area.bottom() + line, map.wholeHeight(200)) << "and the numbers below";
}

TEST_F(MapPanelTest, arrowKeysGoOverTheSeamAndStopAtThePoles) {
    MapWidget& map = panel.map();
    QTest::mouseClick(&map, Qt::LeftButton, {}, pixelOf(shown.grid().number({0, 0})));
    map.setFocus();
    panel.showMap(shown);
    ASSERT_EQ(map.cursor(), (Cell{0, 0}));
    QTest::keyClick(&map, Qt::Key_Left);
    EXPECT_EQ(map.cursor(), (Cell{0, 63}));
    QTest::keyClick(&map, Qt::Key_Up);
    EXPECT_EQ(map.cursor(), (Cell{0, 63}));
    QTest::keyClick(&map, Qt::Key_Right, Qt::ShiftModifier);
    EXPECT_EQ(map.cursor(), (Cell{0, 9}));
    for (int i = 0; i < 40; ++i) QTest::keyClick(&map, Qt::Key_Down);
    EXPECT_EQ(map.cursor(), (Cell{31, 9}));
    EXPECT_TRUE(map.accessibleDescription().contains(QStringLiteral("Row 31, column 9")));
    const Cell owner = shown.grid().cell(cellWith(1));
    QSignalSpy chosen(&map, &MapWidget::cellChosen);
    while (map.cursor()->row > owner.row) QTest::keyClick(&map, Qt::Key_Up);
    while (map.cursor()->column != owner.column) QTest::keyClick(&map, Qt::Key_Right);
    QTest::keyClick(&map, Qt::Key_Return);
    EXPECT_EQ(chosen.count(), 1);
    ASSERT_TRUE(session.pick());
    EXPECT_EQ(shown.source().ownerOf(uint32_t(session.pick()->triangle)), owner);
}

TEST_F(MapPanelTest, nothingJumpsWhenTheCaseChanges) {
    change([](spherical::SphericalDecision& decision) { decision = cutDecision({0.9, 1.0}, {1.9, 2.0}, 2); });
    const QRectF cut = panel.map().layoutOfMap().area;
    const int height = panel.map().neededHeight(400);
    change([](spherical::SphericalDecision& decision) { decision = withinDecision({0, 0, 5}); });
    EXPECT_EQ(panel.map().layoutOfMap().area, cut);
    EXPECT_EQ(panel.map().neededHeight(400), height);
    // The narrow dock has room for 400 × 200.
    EXPECT_GE(cut.width(), 340.0);
    EXPECT_LE(height, 300);
}

TEST_F(MapPanelTest, filesHaveTheirWordsAsText) {
    change([](spherical::SphericalDecision& decision) { decision = cutDecision({0.9, 1.0}, {1.9, 2.0}, 2); });
    const QByteArray svg = plotSvg(panel.map(), {960, 560});
    EXPECT_TRUE(svg.contains(translated(shown.map->decisionWords).toUtf8())) << "the case is not text";
    EXPECT_TRUE(svg.contains(">270°</text>"));
    const QByteArray pdf = plotPdf(panel.map(), {960, 560});
    EXPECT_TRUE(pdf.startsWith("%PDF"));
    EXPECT_TRUE(pdf.contains("/FontFile2") || pdf.contains("/FontFile3")) << "no fonts, so no text";
    const QImage png = QImage::fromData(plotPng(panel.map(), {960, 560}), "PNG");
    EXPECT_EQ(png.size(), QSize(1920, 1120));
    EXPECT_EQ(png.pixelColor(2, 2), Appearance::palette(false).color(QPalette::Base));
}

TEST_F(MapPanelTest, picturesAreSavedByTheirEndingOrNotAtAll) {
    const QTemporaryDir folder;
    const auto file = [&](const char* name) { return folder.filePath(QLatin1String(name)); };
    QSignalSpy raised(&session, &Session::messageRaised);
    for (const char* name : {"map.svg", "map.pdf", "map.PNG"}) {
        panel.pictures().save(file(name).toStdString());
        EXPECT_TRUE(waitUntil([&] { return QFileInfo(file(name)).size() > 1000; })) << name;
    }
    EXPECT_EQ(raised.count(), 0);
    panel.pictures().save(file("map.gif").toStdString());
    ASSERT_EQ(raised.count(), 1);
    EXPECT_FALSE(QFileInfo::exists(file("map.gif")));
    panel.pictures().save(file("none/map.svg").toStdString());
    EXPECT_TRUE(waitUntil([&] { return raised.count() == 2; }));
    panel.pictures().copy();
    EXPECT_FALSE(QGuiApplication::clipboard()->image().isNull());
}

TEST_F(MapPanelTest, wordsFollowTheLanguage) {
    change([](spherical::SphericalDecision& decision) { decision = cutDecision({0.9, 1.0}, {1.9, 2.0}, 3); });
    // A fixed size, because longer texts need a higher panel.
    const auto look = [&] { return plotImage(panel.map(), {480, 320}); };
    const QImage before = look();
    const int width = panel.colouring().width();
    Marking marking;
    QCoreApplication::installTranslator(&marking);
    QApplication::processEvents();
    EXPECT_TRUE(panel.map().accessibleDescription().contains(QStringLiteral("«Case 3")));
    EXPECT_TRUE(panel.colouring().itemText(0).startsWith(QStringLiteral("«")));
    EXPECT_TRUE(panel.map().accessibleName().startsWith(QStringLiteral("«")));
    EXPECT_TRUE(QTest::qWaitFor([&] { return panel.colouring().width() > width; }, 3000)) << "longer words are cut";
    EXPECT_NE(look(), before);
    QCoreApplication::removeTranslator(&marking);
    QApplication::processEvents();
    EXPECT_EQ(look(), before);
}

TEST_F(MapPanelTest, withoutAMapASentenceStandsInItsPlace) {
    EXPECT_TRUE(panel.sentence().isEmpty());
    panel.showMap({});
    EXPECT_FALSE(panel.sentence().isEmpty());
    EXPECT_TRUE(panel.map().isHidden());
    EXPECT_TRUE(panel.colouring().isHidden() || !panel.colouring().isVisibleTo(&panel));
    EXPECT_EQ(panel.focusProxy(), nullptr);
}

}  // namespace
}  // namespace cullscope::ui::map_panel_test
