// What colours the cells of the index map.

#include <algorithm>
#include <cmath>

#include "core/base/error.h"
#include "core/gpu/colour.h"
#include "core/measure/map_picture.h"
#include "core/measure/view_picture.h"

namespace cullscope {
namespace {

/// Brewer's Blues without its palest (Harrower & Brewer 2003): even steps of lightness, and none of the colours of what lies over
/// the map.
constexpr std::array<uint32_t, 8> kRamp{0xDEEBF7, 0xC6DBEF, 0x9ECAE1, 0x6BAED6, 0x4292C6, 0x2171B5, 0x08519C, 0x08306B};
/// Cividis, which is told apart in every sight (Nuñez, Anderton & Renslow 2018), begun a little brighter.
constexpr std::array<uint32_t, 5> kRelief{0x2C4478, 0x434E6C, 0x7D7C78, 0xBCAF6F, 0xFEE838};

Vec3f stateColour(CellState state, const Vec3f& background) {
    const auto palette = verdictPalette(background);
    switch (state) {
        case CellState::Drawn:
            return palette[size_t(TriangleState::Visible)].colour;
        case CellState::OutsideFrustum:
            return palette[size_t(TriangleState::OutsideFrustum)].colour;
        case CellState::Hidden:
            return palette[size_t(TriangleState::Hidden)].colour;
        case CellState::Empty:
            break;
    }
    return background;
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

constexpr std::array kColouringIds{"entries", "radius", "state"};

}  // namespace

const char* mapColouringId(MapColouring colouring) { return kColouringIds[size_t(colouring)]; }

MapColouring mapColouringFromId(std::string_view id) {
    for (size_t i = 0; i < kColouringIds.size(); ++i)
        if (id == kColouringIds[i]) return MapColouring(i);
    throwUsage(CULLSCOPE_TR("There is no colouring of the index map \"%1\". Known: %2."),
               {std::string(id), "entries, radius, state"});
}

CellShares cellShares(const SphericalMaps& maps, MapColouring colouring) {
    return colouring == MapColouring::Radius ? radiusShares(maps) : entryShares(maps);
}

Vec3f rampColour(double share, const Vec3f& background) {
    const double place = std::clamp(isLight(background) ? share : 1.0 - share, 0.0, 1.0) * (kRamp.size() - 1);
    const size_t from = std::min(size_t(place), kRamp.size() - 2);
    return glm::mix(colourFromHexadecimal(kRamp[from]), colourFromHexadecimal(kRamp[from + 1]), float(place - double(from)));
}

std::array<Vec3f, 5> reliefColours() {
    std::array<Vec3f, 5> colours;
    std::transform(kRelief.begin(), kRelief.end(), colours.begin(), colourFromHexadecimal);
    return colours;
}

std::vector<Vec3f> cellColours(const InsideMap& map, MapColouring colouring, const Vec3f& background) {
    if (colouring != MapColouring::State) {
        std::vector<Vec3f> colours;
        for (const float share : cellShares(*map.maps, colouring).shares)
            colours.push_back(share < 0.0f ? background : rampColour(share, background));
        return colours;
    }
    std::vector<Vec3f> colours;
    for (const CellState state : cellStates(map)) colours.push_back(stateColour(state, background));
    return colours;
}

}  // namespace cullscope
