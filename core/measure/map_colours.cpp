// What colours the cells of the index map.

#include <algorithm>
#include <cmath>

#include "core/base/error.h"
#include "core/gpu/colour.h"
#include "core/measure/map_picture.h"
#include "core/measure/view_picture.h"

namespace cullscope {
namespace {

/// The ramp of cividis, which is told apart in every sight: Nuñez, Anderton & Renslow 2018.
constexpr std::array<uint32_t, 5> kRamp{0x00224E, 0x434E6C, 0x7D7C78, 0xBCAF6F, 0xFEE838};
constexpr uint32_t kDarkestOnDark = 0x2C4478;  ///< cividis begins as dark as a dark background

Vec3f colourOf(uint32_t hexadecimal) {
    return Vec3f(float(hexadecimal >> 16), float(hexadecimal >> 8 & 255), float(hexadecimal & 255)) / 255.0f;
}

double entriesShare(size_t entries, size_t most) { return std::log1p(double(entries)) / std::log1p(double(most)); }

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

std::vector<Vec3f> colouredByEntries(const SphericalMaps& maps, const Vec3f& background) {
    size_t most = 1;
    for (uint32_t cell = 0; cell < maps.grid().cellCount(); ++cell) most = std::max(most, maps.triangles(cell).size());
    std::vector<Vec3f> colours(maps.grid().cellCount(), background);
    for (uint32_t cell = 0; cell < colours.size(); ++cell)
        if (const size_t entries = maps.triangles(cell).size(); entries > 0)
            colours[cell] = rampColour(entriesShare(entries, most), background);
    return colours;
}

std::vector<Vec3f> colouredByRadius(const SphericalMaps& maps, const Vec3f& background) {
    std::vector<Vec3f> colours(maps.grid().cellCount(), background);
    for (uint32_t cell = 0; cell < colours.size(); ++cell)
        if (const SphericalMaps::Extent& extent = maps.extent(cell); !extent.empty())
            colours[cell] = rampColour(double(extent.farthest) / maps.sphere().radius, kRadiusRamp);
    return colours;
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

std::array<Vec3f, 5> rampColours(const Vec3f& background) {
    const bool light = isLight(background);
    std::array<Vec3f, 5> colours;
    for (size_t i = 0; i < colours.size(); ++i) colours[i] = colourOf(kRamp[light ? colours.size() - 1 - i : i]);
    if (!light) colours[0] = colourOf(kDarkestOnDark);
    return colours;
}

Vec3f rampColour(double share, const Vec3f& background) {
    const std::array<Vec3f, 5> colours = rampColours(background);
    const double place = std::clamp(share, 0.0, 1.0) * (colours.size() - 1);
    const size_t from = std::min(size_t(place), colours.size() - 2);
    return glm::mix(colours[from], colours[from + 1], float(place - double(from)));
}

std::vector<Vec3f> cellColours(const InsideMap& map, MapColouring colouring, const Vec3f& background) {
    if (colouring == MapColouring::Entries) return colouredByEntries(*map.maps, background);
    if (colouring == MapColouring::Radius) return colouredByRadius(*map.maps, background);
    std::vector<Vec3f> colours;
    for (const CellState state : cellStates(map)) colours.push_back(stateColour(state, background));
    return colours;
}

}  // namespace cullscope
