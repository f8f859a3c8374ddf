// The colours of the index map's cells.

#include <algorithm>
#include <cmath>

#include "core/base/error.h"
#include "core/gpu/colour.h"
#include "core/visibility/spherical/cell_directions.h"
#include "core/visibility/spherical/judged_cells.h"
#include "core/visibility/spherical/map_picture.h"
#include "core/visibility/verdict_palette.h"

namespace cullscope::spherical {
namespace {

/// Brewer's Blues without the lightest one (Harrower & Brewer 2003): even steps of lightness, and no colour that overlays use.
constexpr std::array<uint32_t, 8> kRamp{0xDEEBF7, 0xC6DBEF, 0x9ECAE1, 0x6BAED6, 0x4292C6, 0x2171B5, 0x08519C, 0x08306B};

Vec3f stateColour(CellState state, const Vec3f& background) {
    const auto palette = verdictPalette(background);
    switch (state) {
        case CellState::Drawn:
            return palette[size_t(TriangleState::Visible)].colour;
        case CellState::OutsideFrustum:
            return palette[size_t(TriangleState::OutsideFrustum)].colour;
        case CellState::BackFacing:
            return palette[size_t(TriangleState::BackFacing)].colour;
        case CellState::Hidden:
            return palette[size_t(TriangleState::Hidden)].colour;
        case CellState::Empty:
            break;
    }
    return background;
}

/// The colour of a direction whose display cell holds no centroid but whose quadtree cell does: display cells may be smaller than
/// the quadtree's.
Vec3f colourBetween(const MapSnapshot& map, const Vec3& direction, const Vec3f& background) {
    if (map.tree->leafAt(direction) == nullptr) return background;
    const JudgedCell* judged = judgedCellAt(map, direction);
    if (judged == nullptr) return stateColour(CellState::OutsideFrustum, background);
    const TriangleState state = judged->cause ? stateOfCause(*judged->cause) : TriangleState::Visible;
    return verdictPalette(background)[size_t(state)].colour;
}

CellShares entryShares(const SphericalMaps& maps) {
    size_t most = 1;
    for (uint32_t cell = 0; cell < maps.grid().cellCount(); ++cell) most = std::max(most, maps.triangles(cell).size());
    CellShares result{std::vector<float>(maps.grid().cellCount(), -1.0f), 1.0, double(most)};
    const double span = std::max(std::log(double(most)), 1e-9);
    for (uint32_t cell = 0; cell < result.shares.size(); ++cell)
        if (const size_t entries = maps.triangles(cell).size(); entries > 0)
            result.shares[cell] = float(std::log(double(entries)) / span);
    return result;
}

CellShares radiusShares(const SphericalMaps& maps) {
    CellShares result{std::vector<float>(maps.grid().cellCount(), -1.0f), maps.sphere().radius, 0.0};
    for (uint32_t cell = 0; cell < result.shares.size(); ++cell) {
        if (maps.extent(cell).empty()) continue;
        result.least = std::min(result.least, double(maps.extent(cell).farthest));
        result.most = std::max(result.most, double(maps.extent(cell).farthest));
    }
    result.least = std::min(result.least, result.most);
    const double span = std::max(result.most - result.least, 1e-9 * maps.sphere().radius);
    for (uint32_t cell = 0; cell < result.shares.size(); ++cell)
        if (const SphericalMaps::Extent& extent = maps.extent(cell); !extent.empty())
            result.shares[cell] = float((extent.farthest - result.least) / span);
    return result;
}

CellShares levelShares(const MapSnapshot& map) {
    const SphericalGrid& grid = map.maps->grid();
    const CellDirections directions(grid);
    CellShares result{std::vector<float>(grid.cellCount(), -1.0f), 0.0, 1.0};
    for (uint32_t cell = 0; cell < result.shares.size(); ++cell) {
        const Vec3 middle = directions.middle(grid.cell(cell));
        const CellTree::Node* node = map.tree->leafAt(middle);
        if (node == nullptr) continue;
        // The scale is fixed by the leaves at the cells' middles, so that it does not change with the view. A few leaves may lie
        // much deeper, where many triangles share a place.
        result.most = std::max(result.most, double(node->level));
        if (const JudgedCell* judged = judgedCellAt(map, middle)) node = &map.tree->nodes()[judged->node];
        result.shares[cell] = float(node->level);
    }
    for (float& share : result.shares) share = share < 0.0f ? share : float(share / result.most);
    return result;
}

CellShares kernelShares(const MapSnapshot& map) {
    const SphericalGrid& grid = map.maps->grid();
    const CellDirections directions(grid);
    const double most = map.maps.sphere().radius;
    CellShares result{std::vector<float>(grid.cellCount(), -1.0f), 0.0, most};
    for (uint32_t cell = 0; cell < result.shares.size(); ++cell)
        result.shares[cell] =
            float(map.kernel->radius(octahedralCell(directions.middle(grid.cell(cell)), map.kernel->level())) / most);
    return result;
}

constexpr std::array kColouringIds{"entries", "radius", "state", "level", "kernel"};

}  // namespace

const char* mapColouringId(MapColouring colouring) { return kColouringIds[size_t(colouring)]; }

MapColouring mapColouringFromId(std::string_view id) {
    for (size_t i = 0; i < kColouringIds.size(); ++i)
        if (id == kColouringIds[i]) return MapColouring(i);
    throwUsage(CULLSCOPE_TR("There is no colouring of the index map \"%1\". Known: %2."),
               {std::string(id), "entries, radius, state, level, kernel"});
}

bool hasColouring(const MapSnapshot& map, MapColouring colouring) {
    if (colouring == MapColouring::Level) return map.tree != nullptr;
    return colouring != MapColouring::Kernel || (map.kernel && map.kernel->filled());
}

CellShares cellShares(const MapSnapshot& map, MapColouring colouring) {
    if (!hasColouring(map, colouring)) return {std::vector<float>(map.maps->grid().cellCount(), -1.0f), 0.0, 0.0};
    if (colouring == MapColouring::Level) return levelShares(map);
    if (colouring == MapColouring::Kernel) return kernelShares(map);
    return colouring == MapColouring::Radius ? radiusShares(*map.maps) : entryShares(*map.maps);
}

Vec3f rampColour(double share, const Vec3f& background) {
    const double place = std::clamp(isLight(background) ? share : 1.0 - share, 0.0, 1.0) * (kRamp.size() - 1);
    const size_t from = std::min(size_t(place), kRamp.size() - 2);
    return glm::mix(colourFromHexadecimal(kRamp[from]), colourFromHexadecimal(kRamp[from + 1]), float(place - double(from)));
}

std::vector<Vec3f> cellColours(const MapSnapshot& map, MapColouring colouring, const Vec3f& background) {
    if (colouring != MapColouring::State) {
        std::vector<Vec3f> colours;
        for (const float share : cellShares(map, colouring).shares)
            colours.push_back(share < 0.0f ? background : rampColour(share, background));
        return colours;
    }
    std::vector<Vec3f> colours;
    const std::vector<CellState> states = cellStates(map);
    const CellDirections directions(map.maps->grid());
    for (uint32_t cell = 0; cell < states.size(); ++cell) {
        const bool between = states[cell] == CellState::Empty && map.tree;
        colours.push_back(between ? colourBetween(map, directions.middle(map.maps->grid().cell(cell)), background)
                                  : stateColour(states[cell], background));
    }
    return colours;
}

}  // namespace cullscope::spherical
