#include "core/visibility/spherical/cell_walk.h"

#include <algorithm>
#include <cmath>

namespace cullscope::spherical {
namespace {

// Drawing fewer hidden triangles than this between two ranges is faster than starting another range.
constexpr uint32_t kGap = 8;
// Cells of fewer triangles are drawn faster than the horizon test takes.
constexpr uint32_t kLeastForHorizon = 96;
constexpr uint8_t kNearPlane = 1U << unsigned(FrustumPlane::Near);

/// The tests that are not yet decided for a node; passed on to its children.
struct OpenTests {
    uint8_t planes = 0;
    bool cones = false;
    bool horizon = false;

    [[nodiscard]] bool none() const { return planes == 0 && !cones && !horizon; }
};

class Walker {
public:
    Walker(const CellTree& tree, const ObjectSpaceView& view, const CellTests& tests, bool recording)
        : m_tree(tree), m_view(view), m_horizon(tests.horizon), m_recording(recording), m_snap(snapping(view)) {
        for (size_t p = 0; p < m_spread.size(); ++p) m_spread[p] = glm::abs(view.planesOnMap[p].normal);
    }

    void visit(uint32_t number, OpenTests open) {
        const CellTree::Node& node = m_tree.nodes()[number];
        ++m_walk.nodesVisited;
        const Vec3 low(node.low), high(node.high);
        const Vec3 middle = 0.5 * (low + high), half = 0.5 * (high - low);
        if (outside(middle, half, open.planes)) return leaveOut(number, Cause::OutsideFrustum);
        if (open.cones && facesAway(node, middle, half, open)) return leaveOut(number, Cause::BackFacing);
        if (open.horizon && node.count >= kLeastForHorizon) {
            const KernelHorizon::Reach reach = m_horizon->reach(middle, glm::length(half));
            if (reach == KernelHorizon::Reach::Hidden) return leaveOut(number, Cause::Hidden);
            open.horizon = reach == KernelHorizon::Reach::Open;
        }
        open.horizon = open.horizon && node.count >= kLeastForHorizon;
        if (node.childCount == 0 || open.none()) return draw(number);
        for (uint32_t child = node.firstChild; child < node.firstChild + node.childCount; ++child) visit(child, open);
    }

    [[nodiscard]] CellWalk take(const CellTests& tests) {
        m_walk.cones = tests.cones;
        m_walk.horizon = tests.horizon != nullptr;
        return std::move(m_walk);
    }

private:
    /// Whether the box is outside one plane of the mask. Removes from `planes` those that it lies completely inside.
    [[nodiscard]] bool outside(const Vec3& middle, const Vec3& half, uint8_t& planes) const {
        for (size_t p = 0; p < m_spread.size(); ++p) {
            if ((planes & (1U << p)) == 0) continue;
            const double distance = m_view.planesOnMap[p].distance(middle), reach = glm::dot(m_spread[p], half);
            if (distance + reach < -m_view.margin) return true;
            if (distance - reach > m_view.margin) planes = uint8_t(planes & ~(1U << p));
        }
        return false;
    }

    /// Whether all triangles of a node are back-facing, also after the picture's snapping has moved their vertices: snapping may
    /// flip a triangle whose projected width is less than twice that movement. Clears `open.cones` where none is back-facing.
    [[nodiscard]] bool facesAway(const CellTree::Node& node, const Vec3& middle, const Vec3& half, OpenTests& open) const {
        if (node.coneCosine > 1.0f) return false;
        const Vec3 to = middle - m_view.eye;
        const double distance = glm::length(to), radius = glm::length(half);
        const double along = glm::dot(Vec3(node.coneAxis), to);
        const double across = std::sqrt(std::max(0.0, distance * distance - along * along));
        if (along * node.coneCosine + across * node.coneSine + radius < 0.0) {
            open.cones = false;
            return false;
        }
        // A triangle that the near plane cuts is clipped into new triangles that may be arbitrarily thin, so that no bound on
        // their height is known. Where the cone's axis points towards the eye, the rim of the cone does not bound its normals.
        if ((open.planes & kNearPlane) != 0 || along <= 0.0) return false;
        const double far = distance + radius;
        return along * node.coneCosine - across * node.coneSine > node.planeMargin + 4.0 * m_snap * far / node.leastHeight * far;
    }

    void leaveOut(uint32_t number, Cause cause) {
        const uint32_t count = m_tree.nodes()[number].count;
        m_walk.culled[size_t(cause)] += count;
        m_gap[size_t(cause)] += count;
        if (m_recording) m_walk.judged.push_back({number, cause});
    }

    void draw(uint32_t number) {
        const CellTree::Node& node = m_tree.nodes()[number];
        if (m_recording) m_walk.judged.push_back({number, std::nullopt});
        std::vector<PlaceRun>& drawn = m_walk.drawn;
        if (!drawn.empty() && node.first - (drawn.back().first + drawn.back().count) < kGap) {
            drawn.back().count = node.first + node.count - drawn.back().first;
            for (size_t cause = 0; cause < kCauseCount; ++cause) m_walk.culled[cause] -= m_gap[cause];
            for (size_t i = m_judgedBeforeGap; i < m_walk.judged.size(); ++i) m_walk.judged[i].cause.reset();
        } else {
            drawn.push_back({node.first, node.count});
        }
        m_gap = {};
        m_judgedBeforeGap = m_walk.judged.size();
    }

    const CellTree& m_tree;
    const ObjectSpaceView& m_view;
    const KernelHorizon* m_horizon;
    bool m_recording;
    double m_snap;
    std::array<Vec3, 6> m_spread{};             ///< components |n| of the planes' normals: |n| · half is half the box's extent
                                                ///< along n
    std::array<uint64_t, kCauseCount> m_gap{};  ///< triangles culled since the last range, by cause
    size_t m_judgedBeforeGap = 0;
    CellWalk m_walk;
};

}  // namespace

double snapping(const ObjectSpaceView& view) {
    constexpr double kSteps = 1.0 / 256.0;
    return (kSteps * view.pixelSlope + 0x1p-20) * view.unevenness;
}

CellWalk walkCells(const CellTree& tree, const ObjectSpaceView& view, const CellTests& tests, bool recording) {
    Walker walker(tree, view, tests, recording);
    if (!tree.nodes().empty()) walker.visit(0, {tests.planes, tests.cones && view.eyeKnown, tests.horizon != nullptr});
    return walker.take(tests);
}

}  // namespace cullscope::spherical
