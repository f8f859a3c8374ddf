#include "core/visibility/spherical/map_values.h"

#include <algorithm>
#include <cmath>

#include "core/base/error.h"
#include "core/visibility/spherical/cell_directions.h"
#include "core/visibility/spherical/judged_cells.h"
#include "core/visibility/triangle_states.h"

namespace cullscope::spherical {
namespace {

/// The values by cell number, with their range.
struct CellShares {
    std::vector<float> shares;
    double least = 0.0, most = 0.0;
};

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
        const SphericalMaps::Extent extent = maps.extent(cell);
        if (extent.empty()) continue;
        result.least = std::min(result.least, double(extent.farthest));
        result.most = std::max(result.most, double(extent.farthest));
    }
    result.least = std::min(result.least, result.most);
    const double span = std::max(result.most - result.least, 1e-9 * maps.sphere().radius);
    for (uint32_t cell = 0; cell < result.shares.size(); ++cell)
        if (const SphericalMaps::Extent extent = maps.extent(cell); !extent.empty())
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

std::vector<float> kernelShares(const MapSnapshot& map) {
    const SphericalGrid& grid = map.maps->grid();
    const CellDirections directions(grid);
    const double most = map.maps.sphere().radius;
    std::vector<float> shares(grid.cellCount(), -1.0f);
    for (uint32_t cell = 0; cell < shares.size(); ++cell)
        shares[cell] = float(map.kernel->radius(octahedralCell(directions.middle(grid.cell(cell)), map.kernel->level())) / most);
    return shares;
}

constexpr std::array kQuantityIds{"entries", "radius", "state", "level", "kernel"};

}  // namespace

const char* mapQuantityId(MapQuantity quantity) { return kQuantityIds[size_t(quantity)]; }

MapQuantity mapQuantityFromId(std::string_view id) {
    for (size_t i = 0; i < kQuantityIds.size(); ++i)
        if (id == kQuantityIds[i]) return MapQuantity(i);
    throwUsage(CULLSCOPE_TR("There is no colouring of the index map \"%1\". Known: %2."),
               {std::string(id), "entries, radius, state, level, kernel"});
}

bool hasQuantity(const MapSnapshot& map, MapQuantity quantity) {
    if (quantity == MapQuantity::Level) return map.tree != nullptr;
    return quantity != MapQuantity::Kernel || (map.kernel && map.kernel->filled());
}

MapValues cellValues(const MapSnapshot& map, MapQuantity quantity) {
    const auto counted = [](CellShares shares) {
        return MapValues{std::move(shares.shares), Term::count(uint64_t(shares.least)), Term::count(uint64_t(shares.most))};
    };
    if (!hasQuantity(map, quantity)) return counted({std::vector<float>(map.maps->grid().cellCount(), -1.0f)});
    if (quantity == MapQuantity::Level) return counted(levelShares(map));
    if (quantity == MapQuantity::Entries || quantity == MapQuantity::State) return counted(entryShares(*map.maps));
    if (quantity == MapQuantity::Kernel) return {kernelShares(map), Term::share(0.0), Term::share(1.0)};
    CellShares radii = radiusShares(*map.maps);
    return {std::move(radii.shares), Term::length(radii.least), Term::length(radii.most)};
}

std::optional<TriangleState> stateBetweenCentroids(const MapSnapshot& map, const Vec3& direction) {
    if (map.tree->leafAt(direction) == nullptr) return std::nullopt;
    const JudgedCell* judged = judgedCellAt(map, direction);
    if (judged == nullptr) return TriangleState::OutsideFrustum;
    return judged->cause ? stateOfCause(*judged->cause) : TriangleState::Visible;
}

}  // namespace cullscope::spherical
