// The cells that `spherical-lossless` tested, and the outline of the kernel that hides some of them, as lines on the map.

#include "core/visibility/spherical/judged_cells.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "core/geometry/angle.h"
#include "core/geometry/map_line.h"

namespace cullscope::spherical {
namespace {

/// The corners on the map's unit square, counter-clockwise; the first one again at the end.
std::array<Vec2, 5> cornersOf(const MapCell& cell) {
    const double size = 1.0 / double(1U << cell.level);
    const Vec2 low(cell.x * size, cell.y * size);
    return {low, low + Vec2(size, 0.0), low + Vec2(size), low + Vec2(0.0, size), low};
}

/// The outline of a cell of rows and columns: straight on the map, with points between the corners for callers that draw it on a
/// sphere.
std::vector<Vec2> rectangleOutline(const MapCell& cell) {
    const std::array<Vec2, 5> corners = cornersOf(cell);
    const auto angles = [](const Vec2& point) { return Vec2(std::min(kTurn * point.y, std::numbers::pi), kTurn * point.x); };
    const int pieces = std::max(1, int(180U >> cell.level));
    std::vector<Vec2> outline{angles(corners[0])};
    for (size_t i = 1; i < corners.size(); ++i)
        for (int piece = 1; piece <= pieces; ++piece)
            outline.push_back(glm::mix(angles(corners[i - 1]), angles(corners[i]), double(piece) / pieces));
    return outline;
}

/// The extent of a cell of level 1 or more in θ and φ, from its corners.
Vec2 sizeOf(MapLayout layout, const MapCell& cell) {
    if (layout == MapLayout::LatitudeLongitude) {
        const double size = kTurn / double(1U << cell.level);
        return {std::min(size, std::numbers::pi), size};
    }
    // Such a cell lies within one quarter of the azimuths, so that its extent in φ needs no handling of the seam.
    const Vec3 snapshot = directionAt(layout, 0.5 * (cornersOf(cell)[0] + cornersOf(cell)[2]));
    const double quarter = std::floor(std::atan2(snapshot.y, snapshot.x) / kRightAngle) * kRightAngle;
    Vec2 low(kTurn), high(0.0);
    for (const Vec2& corner : cornersOf(cell)) {
        const Vec3 direction = directionAt(layout, corner);
        const Vec3 turned(std::cos(quarter) * direction.x + std::sin(quarter) * direction.y,
                          std::cos(quarter) * direction.y - std::sin(quarter) * direction.x, direction.z);
        const double across = std::hypot(turned.x, turned.y), theta = std::atan2(across, turned.z);
        low.x = std::min(low.x, theta);
        high.x = std::max(high.x, theta);
        if (across < 1e-12) continue;  // a pole has no azimuth of its own
        const double phi = std::atan2(turned.y, turned.x);
        low.y = std::min(low.y, phi);
        high.y = std::max(high.y, phi);
    }
    return high - low;
}

}  // namespace

const JudgedCell* judgedCellAt(const MapSnapshot& map, const Vec3& direction) {
    if (!map.tree || !map.decision.walk) return nullptr;
    const CellTree::Node* leaf = map.tree->leafAt(direction);
    if (leaf == nullptr) return nullptr;
    const std::vector<JudgedCell>& judged = map.decision.walk->judged;
    const auto& nodes = map.tree->nodes();
    const auto after =
        std::ranges::upper_bound(judged, leaf->first, {}, [&](const JudgedCell& cell) { return nodes[cell.node].first; });
    return after == judged.begin() ? nullptr : &*std::prev(after);
}

std::vector<Vec2> cellOutline(MapLayout layout, const MapCell& cell) {
    if (cell.level == 0) return {};
    if (layout == MapLayout::LatitudeLongitude) return rectangleOutline(cell);
    // On a face of the octahedron a straight line on the square is a great circle, and the edges of cells of level 1 and more do
    // not cross the borders of faces.
    const std::array<Vec2, 5> corners = cornersOf(cell);
    MapLine line(directionAt(layout, corners[0]));
    for (size_t i = 1; i < corners.size(); ++i) line.arc(directionAt(layout, corners[i - 1]), directionAt(layout, corners[i]));
    std::vector<Vec2> outline = std::move(line).take();
    // At a pole the line may end at another azimuth than its start.
    if (outline.back() != outline.front()) outline.push_back(outline.front());
    return outline;
}

std::vector<std::vector<Vec2>> cellOutlines(const MapSnapshot& map, double leastSize) {
    std::vector<std::vector<Vec2>> outlines;
    if (!map.tree || !map.decision.walk) return outlines;
    const MapLayout layout = map.tree->layout();
    for (const JudgedCell& judged : map.decision.walk->judged) {
        const CellTree::Node& node = map.tree->nodes()[judged.node];
        if (node.level == 0) continue;
        const Vec2 size = sizeOf(layout, node.cell());
        if (std::min(size.x, size.y) >= leastSize) outlines.push_back(cellOutline(layout, node.cell()));
    }
    return outlines;
}

std::vector<Vec2> horizonLine(const MapSnapshot& map) {
    if (!map.decision.walk || map.decision.walk->outline.empty()) return {};
    const std::vector<Vec3>& outline = map.decision.walk->outline;
    MapLine line(outline.front());
    for (size_t i = 1; i <= outline.size(); ++i) line.arc(outline[i - 1], outline[i % outline.size()]);
    return std::move(line).take();
}

}  // namespace cullscope::spherical
