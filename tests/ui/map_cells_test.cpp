#include "ui/plots/map_cells.h"

#include <gtest/gtest.h>

#include <numbers>

#include "tests/ui/made_up_map.h"
#include "ui/plots/map_layout.h"

namespace cullscope::ui::map_cells_test {
namespace {

constexpr double kTurn = 2.0 * std::numbers::pi;
using Cell = SphericalGrid::Cell;

TEST(MapLayout, aPixelTellsItsCell) {
    const QFontMetricsF metrics{QFont()};
    for (const SphericalGrid& grid : {SphericalGrid(64, 32), SphericalGrid(360, 180), SphericalGrid(1440, 720)})
        for (const QRectF& place : {QRectF(0, 0, 400, 240), QRectF(5.5, 3.25, 480, 900)}) {
            const MapLayout layout(place, metrics);
            EXPECT_DOUBLE_EQ(layout.area.width(), 2 * layout.area.height());
            EXPECT_TRUE(place.contains(layout.area));
            for (uint32_t number = 0; number < grid.cellCount(); number += 7) {
                const Cell cell = grid.cell(number);
                ASSERT_EQ(layout.cellAt(grid, layout.rectOf(grid, cell).center()), cell) << number;
            }
            EXPECT_EQ(layout.cellAt(grid, layout.area.topLeft()), (Cell{0, 0}));
            const QPointF last = layout.area.bottomRight() - QPointF(0.01, 0.01);
            EXPECT_EQ(layout.cellAt(grid, last), (Cell{grid.rows() - 1, grid.columns() - 1}));
            EXPECT_FALSE(layout.cellAt(grid, layout.area.bottomRight() + QPointF(0.01, -1.0)));
            EXPECT_FALSE(layout.cellAt(grid, layout.area.topLeft() - QPointF(0.01, 0.01)));
        }
}

TEST(MapLayout, theSeamIsBothEdges) {
    const MapLayout layout(QRectF(0, 0, 400, 240), QFontMetricsF{QFont()});
    EXPECT_EQ(layout.placeOf({0.0, 0.0}), layout.area.topLeft());
    EXPECT_EQ(layout.placeOf({std::numbers::pi, kTurn}), layout.area.bottomRight());
}

TEST(MapCells, nothingIsLostInASmallPicture) {
    const SphericalGrid grid(400, 200);
    std::vector<uint8_t> tones(grid.cellCount(), 0);
    tones[grid.number({77, 313})] = 9;
    QList<QRgb> colours(256, 0xFF000000U);
    colours[9] = 0xFFFF0000U;
    const QImage image = cellImage(tones, grid, {90, 45}, colours);
    int marked = 0;
    for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x) marked += image.pixel(x, y) == 0xFFFF0000U ? 1 : 0;
    EXPECT_EQ(marked, 1);
    EXPECT_EQ(image.pixel(313 * 90 / 400, 77 * 45 / 200), 0xFFFF0000U);
}

TEST(MapCells, entriesAndReachGrowWithTheTone) {
    const MadeUpMap made(openScene("knot:triangles=4000").scene, SphericalGrid(64, 32));
    const SphericalMaps& maps = *made.maps;
    const CellMapPointer map = made.shown().map;
    const CellTones entries = cellTones(*map, "entries"), reach = cellTones(*map, "radius");
    EXPECT_EQ(entries.least, Term::count(1));
    for (uint32_t a = 0; a < maps.grid().cellCount(); ++a) {
        EXPECT_EQ(entries.tones[a] == 0, maps.triangles(a).empty());
        EXPECT_EQ(reach.tones[a] == 0, maps.extent(a).empty());
        const uint32_t b = (a + 37) % maps.grid().cellCount();
        if (maps.triangles(a).size() < maps.triangles(b).size()) {
            EXPECT_LE(entries.tones[a], entries.tones[b]);
        }
        if (!maps.extent(a).empty() && !maps.extent(b).empty() && maps.extent(a).farthest < maps.extent(b).farthest) {
            EXPECT_LE(reach.tones[a], reach.tones[b]);
        }
    }
    EXPECT_EQ(*std::max_element(entries.tones.begin(), entries.tones.end()), 255);
}

TEST(MapCells, aCellIsAsItsWorstTriangle) {
    const ScenePointer scene = openScene("knot:triangles=4000").scene;
    const ShownMap shown = MadeUpMap(scene, SphericalGrid(64, 32)).shown();
    uint32_t cell = 0;
    while (shown.source().owned(cell).size() < 3) ++cell;
    TriangleStates truth;
    truth.againstTruth = true;
    truth.states.assign(scene->triangleCount(), TriangleState::InVain);
    const auto tone = [&] { return stateTone(shown, &truth, cell); };
    EXPECT_EQ(tone(), CellTones::toneOf(TriangleState::InVain));
    truth.states[shown.source().owned(cell)[0]] = TriangleState::Visible;
    EXPECT_EQ(tone(), CellTones::toneOf(TriangleState::Visible));
    truth.states[shown.source().owned(cell)[1]] = TriangleState::WronglyCulled;
    EXPECT_EQ(tone(), CellTones::toneOf(TriangleState::WronglyCulled));
    EXPECT_EQ(stateTone(shown, nullptr, cell), CellTones::toneOf(TriangleState::Hidden));
    EXPECT_EQ(stateTones(shown, &truth).tones[cell], tone());
}

}  // namespace
}  // namespace cullscope::ui::map_cells_test
