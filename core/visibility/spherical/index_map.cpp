#include "core/visibility/spherical/index_map.h"

#include <algorithm>
#include <cmath>
#include <mutex>
#include <numbers>

#include "core/base/message.h"
#include "core/spatial/spherical_triangle.h"
#include "core/visibility/spherical/cell_directions.h"
#include "core/visibility/spherical/index_map_words.h"
#include "core/visibility/spherical/judged_cells.h"
#include "core/visibility/spherical/map_values.h"

namespace cullscope::spherical {
namespace {

/// Values for which the legend reserves room: their labels are wider than most.
constexpr double kUsualStep = 22.5 * std::numbers::pi / 180.0;
constexpr uint32_t kUsualSector = 98;

std::optional<TriangleState> stateOfCell(CellState state) {
    switch (state) {
        case CellState::Drawn:
            return TriangleState::Visible;
        case CellState::BackFacing:
            return TriangleState::BackFacing;
        case CellState::Hidden:
            return TriangleState::Hidden;
        case CellState::OutsideFrustum:
            return TriangleState::OutsideFrustum;
        case CellState::Undecided:
            return TriangleState::Undecided;
        case CellState::Empty:
            break;
    }
    return std::nullopt;
}

MapCircles circlesOf(const ContourBands& bands) {
    MapCircles circles = bands;
    circles.every = uint32_t(std::lround(contourStep(bands.width) / bands.width));
    return circles;
}

class IndexMapSource final : public CellMapSource {
public:
    explicit IndexMapSource(MapSnapshot map) : m_map(std::move(map)), m_maps(*m_map.maps) {}

    [[nodiscard]] const MapSnapshot& map() const { return m_map; }
    [[nodiscard]] const SphericalGrid& grid() const { return m_maps.grid(); }

    [[nodiscard]] const void* key() const override { return &m_maps; }
    [[nodiscard]] std::span<const uint32_t> owned(uint32_t cell) const override { return m_maps.centroids(cell); }
    [[nodiscard]] std::span<const uint32_t> touching(uint32_t cell) const override { return m_maps.triangles(cell); }
    [[nodiscard]] SphericalGrid::Cell ownerOf(uint32_t triangle) const override {
        const auto [a, b, c] = m_maps.corners(triangle);
        return grid().cellOf((a + b + c) / 3.0);
    }
    [[nodiscard]] std::vector<SphericalGrid::Cell> cellsOf(uint32_t triangle) const override {
        const auto [a, b, c] = m_maps.corners(triangle);
        std::vector<SphericalGrid::Cell> cells;
        SphericalTriangle(a, b, c).forEachCell(grid(), [&](const SphericalGrid::Cell& cell) { cells.push_back(cell); });
        std::ranges::sort(cells, {}, [this](const SphericalGrid::Cell& cell) { return grid().number(cell); });
        return cells;
    }
    [[nodiscard]] MapValues values(std::string_view colouring) const override {
        return cellValues(m_map, mapQuantityFromId(colouring));
    }
    [[nodiscard]] const std::vector<std::optional<TriangleState>>& states() const override {
        std::call_once(m_statesMade, [this] {
            for (const CellState state : cellStates(m_map)) m_states.push_back(stateOfCell(state));
        });
        return m_states;
    }
    [[nodiscard]] std::optional<TriangleState> stateBetween(uint32_t cell) const override {
        if (!m_map.tree) return std::nullopt;
        std::call_once(m_directionsMade, [this] { m_directions.emplace(grid()); });
        return stateBetweenCentroids(m_map, m_directions->middle(grid().cell(cell)));
    }
    [[nodiscard]] std::vector<Words> words(uint32_t cell) const override { return cellWords(m_map, grid().cell(cell)); }
    [[nodiscard]] std::vector<std::vector<Vec2>> outlines(double leastSize) const override {
        return cellOutlines(m_map, leastSize);
    }
    [[nodiscard]] std::vector<std::vector<Vec2>> partEdges(uint32_t part) const override {
        const ContourBands& bands = *m_map.decision.bands;
        std::vector<std::vector<Vec2>> edges;
        for (const uint32_t edge : {part - 1, part})
            for (std::vector<Vec2>& line : meridianOnMap(bands, edge * kTurn / bands.sectors)) edges.push_back(std::move(line));
        return edges;
    }
    [[nodiscard]] Words partWords(uint32_t part) const override { return sectorWords(part - 1); }

private:
    MapSnapshot m_map;
    const SphericalMaps& m_maps;
    mutable std::once_flag m_statesMade, m_directionsMade;
    mutable std::vector<std::optional<TriangleState>> m_states;
    mutable std::optional<CellDirections> m_directions;
};

std::vector<MapColouring> colouringsOf(const MapSnapshot& map) {
    std::vector<MapColouring> colourings{
        {mapQuantityId(MapQuantity::Entries), {CULLSCOPE_TR("Entries a cell")}, {CULLSCOPE_TR("triangles a cell, logarithmic")}},
        {mapQuantityId(MapQuantity::Radius), {CULLSCOPE_TR("Farthest R")}, {CULLSCOPE_TR("farthest R, mesh units")}},
        {mapQuantityId(MapQuantity::State), {CULLSCOPE_TR("State")}}};
    colourings[0].fixed = colourings[1].fixed = colourings[2].states = true;
    if (hasQuantity(map, MapQuantity::Level))
        colourings.push_back(
            {mapQuantityId(MapQuantity::Level), {CULLSCOPE_TR("Level")}, {CULLSCOPE_TR("level where the walk ended")}});
    if (!hasQuantity(map, MapQuantity::Kernel)) return colourings;
    colourings.push_back(
        {mapQuantityId(MapQuantity::Kernel), {CULLSCOPE_TR("Kernel")}, {CULLSCOPE_TR("R of the kernel, of the sphere's")}});
    colourings.back().fixed = true;
    return colourings;
}

std::vector<MapLegendRoom> legendRooms(bool tree) {
    using enum TriangleState;
    if (tree) return {{{Visible, InVain, OutsideFrustum, BackFacing, Hidden}, {}, walkLegend(true)}};
    MapLegendRoom region{{Visible, InVain, OutsideFrustum, WronglyCulled}, {}, regionLegend()};
    MapLegendRoom bands{{Visible, InVain, Hidden, WronglyCulled}, {Hidden}, bandLegend(kUsualStep)};
    bands.entries.push_back({MapSymbol::Part, sectorWords(kUsualSector)});
    return {std::move(region), std::move(bands)};
}

void addRegion(CellMap& map, const SphericalDecision& decision) {
    const VisibleRegion& region = *decision.region;
    map.boxes = region.boxes;
    if (!region.outline.empty()) map.curves.push_back({MapSymbol::Region, region.outline, !region.winds});
    if (region.winds && region.caseNumber == 1)
        map.curves.back().pole = region.boxes.front().firstRow == 0 ? 0.0 : std::numbers::pi;
    for (const CornerRay& ray : decision.rays)
        for (const WalkedCell& walked : ray.walkedCells) map.walked.push_back(walked.cell);
    for (size_t corner = 0; corner < decision.rays.size(); ++corner) {
        const CornerRay& ray = decision.rays[corner];
        map.marks.push_back({ray.hit ? MapSymbol::Hit : MapSymbol::Miss, mapAngles(ray.point), uint32_t(corner + 1),
                             cornerWords(decision, corner)});
    }
    map.legend = regionLegend();
}

void addBands(CellMap& map, const ContourBands& bands) {
    map.circles = circlesOf(bands);
    map.axis = bands.axis;
    map.parts = bands.sectors;
    map.legend = bandLegend(contourStep(bands.width));
}

void addWalk(CellMap& map, const MapSnapshot& snapshot) {
    std::vector<Vec2> horizon = horizonLine(snapshot);
    map.legend = walkLegend(!horizon.empty());
    if (horizon.empty()) return;
    map.curves.push_back({MapSymbol::Horizon, std::move(horizon), false});
    map.axis = snapshot.decision.eye;
}

}  // namespace

CellMapPointer indexMap(MapSnapshot snapshot, const std::string& object, size_t objects) {
    const auto source = std::make_shared<const IndexMapSource>(std::move(snapshot));
    const MapSnapshot& shown = source->map();
    const SphericalDecision& decision = shown.decision;
    auto map = std::make_shared<CellMap>();
    map->title = {CULLSCOPE_TR("Triangle index map")};
    map->object = decision.instance;
    map->grid = source->grid();
    map->colourings = colouringsOf(shown);
    map->objectWords = objectWords(shown, object, objects);
    map->decisionWords = decisionWords(shown);
    map->lines = walkWords(shown);
    // One line by test, one for triangles left out one by one, one for the kernel; the reason why there is none may take two.
    if (shown.tree) map->lineRoom = shown.kernel && shown.kernel->filled() ? 3 : 4;
    map->veiled = decision.bands.has_value();
    map->rooms = legendRooms(shown.tree != nullptr);
    if (decision.bands) addBands(*map, *decision.bands);
    if (decision.region) addRegion(*map, decision);
    if (decision.walk) addWalk(*map, shown);
    map->source = source;
    return map;
}

}  // namespace cullscope::spherical
