#include "core/visibility/part_walk.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/base/message.h"

namespace cullscope {
namespace {

// Drawing fewer hidden triangles than this between two ranges is faster than starting another range.
constexpr uint32_t kGap = 8;
// Where less than one in so many triangles is left out, the whole mesh is faster: it is drawn in vertex-cache order. Triangles
// that face away count half: OpenGL drops them once their vertices are shaded, and before they are set up.
constexpr uint64_t kLeastShareLeftOut = 8;
constexpr uint8_t kNearPlane = 1U << unsigned(FrustumPlane::Near);

/// The tests that are not yet decided for a node; passed on to its children.
struct OpenTests {
    uint8_t planes = 0;
    bool cones = false;
    bool hiding = false;

    [[nodiscard]] bool none() const { return planes == 0 && !cones && !hiding; }
};

class Walker {
public:
    Walker(const SurfaceNodes& nodes, const PartView& view, const PartTests& tests, ObjectRecord* record)
        : m_nodes(nodes),
          m_view(view),
          m_hiding(tests.hiding),
          m_leaves(tests.leaves),
          m_lines(tests.lines),
          m_record(record),
          m_tests(record != nullptr && record->tests()),
          m_snap(snapping(view)) {
        for (size_t p = 0; p < m_spread.size(); ++p) m_spread[p] = glm::abs(view.localPlanes[p].normal);
    }

    void visit(uint32_t number, OpenTests open) {
        const SurfaceNode& node = m_nodes[number];
        ++m_walk.nodesVisited;
        const Vec3 low(node.low), high(node.high);
        const Vec3 middle = 0.5 * (low + high), half = 0.5 * (high - low);
        if (outside(number, middle, half, open.planes)) return leaveOut(number, Cause::OutsideFrustum);
        if (open.cones && facesAway(number, middle, half, open)) return leaveOut(number, Cause::BackFacing);
        if (open.hiding && node.count >= m_hiding->least()) {
            Decision said;
            const HidingTest::Reach reach = m_hiding->test(middle, half, m_tests ? &said : nullptr);
            if (m_tests) say(number, m_lines.hiding, said);
            if (reach == HidingTest::Reach::Hidden) return leaveOut(number, Cause::Hidden);
            open.hiding = reach == HidingTest::Reach::Open;
        }
        open.hiding = open.hiding && node.count >= m_hiding->least();
        if (node.childCount == 0 && m_leaves != nullptr) return m_leaves->push_back(number);
        if (node.childCount == 0 || (open.none() && m_leaves == nullptr)) return draw(number);
        for (uint32_t child = node.firstChild; child < node.firstChild + node.childCount; ++child) visit(child, open);
    }

    [[nodiscard]] PartWalk take(const PartTests& tests) {
        if (m_leaves == nullptr) drawWholeWhereFewAreLeftOut();
        m_walk.cones = tests.cones;
        m_walk.hiding = tests.hiding != nullptr;
        return std::move(m_walk);
    }

private:
    /// Whether the box is outside one plane of the mask. Removes from `planes` those that it lies completely inside.
    [[nodiscard]] bool outside(uint32_t number, const Vec3& middle, const Vec3& half, uint8_t& planes) {
        for (size_t p = 0; p < m_spread.size(); ++p) {
            if ((planes & (1U << p)) == 0) continue;
            const double distance = m_view.localPlanes[p].distance(middle), reach = glm::dot(m_spread[p], half);
            if (m_tests)
                say(number, m_lines.planes,
                    planeTest(cell(number), FrustumPlane(p), distance + reach, distance - reach, m_view.margin));
            if (distance + reach < -m_view.margin) return true;
            if (distance - reach > m_view.margin) planes = uint8_t(planes & ~(1U << p));
        }
        return false;
    }

    /// Whether all triangles of a node are back-facing, also after the picture's snapping has moved their vertices: snapping may
    /// flip a triangle whose projected width is less than twice that movement. Clears `open.cones` where none is back-facing.
    [[nodiscard]] bool facesAway(uint32_t number, const Vec3& middle, const Vec3& half, OpenTests& open) {
        const SurfaceNode& node = m_nodes[number];
        if (!node.hasCone()) return false;
        const Vec3 to = middle - m_view.eye;
        const double distance = glm::length(to), radius = glm::length(half);
        const double along = glm::dot(Vec3(node.coneAxis), to);
        const double across = std::sqrt(std::max(0.0, distance * distance - along * along));
        if (along * node.coneCosine + across * node.coneSine + radius < 0.0) {
            open.cones = false;
            if (m_tests) sayNoneAway(number);
            return false;
        }
        // A triangle that the near plane cuts is clipped into new triangles that may be arbitrarily thin, so that no bound on
        // their height is known. Where the cone's axis points towards the eye, the rim of the cone does not bound its normals.
        if ((open.planes & kNearPlane) != 0 || along <= 0.0) return false;
        const double far = distance + radius;
        const double away = along * node.coneCosine - across * node.coneSine;
        const double needed = node.planeMargin + 4.0 * (m_snap * far + m_view.rounding) / node.leastHeight * far;
        if (m_tests) sayCone(number, away, needed);
        return away > needed;
    }

    /// While the walk is recorded.
    [[nodiscard]] Subject cell(uint32_t number) const { return Subject::ofCell(number, m_record->subject().number); }

    /// Records a decision about a cell.
    void say(uint32_t number, uint8_t line, Decision decision) {
        const SurfaceNode& node = m_nodes[number];
        decision.subject = cell(number);
        decision.places = {node.first, node.count};
        decision.nesting = uint8_t(std::min<uint32_t>(node.level + 1u, 255u));
        m_record->say(atLine(line, decision));
    }

    void sayNoneAway(uint32_t number) {
        Decision test;
        test.containment = Containment::Inside;
        test.sentence = CULLSCOPE_TR("All normals in the cell's cone are turned to the eye: cones are not tested in its parts.");
        say(number, m_lines.cones, test);
    }

    void sayCone(uint32_t number, double away, double needed) {
        Decision test;
        test.containment = away > needed ? Containment::Outside : Containment::Straddles;
        test.sentence = away > needed
                            ? CULLSCOPE_TR(
                                  "The planes of its triangles have the eye behind them by at least %1, more than the %2 that "
                                  "rounding and snapping may undo.")
                            : CULLSCOPE_TR(
                                  "The planes of its triangles have the eye behind them by at least %1: not more than the %2 "
                                  "that rounding and snapping may undo.");
        test.operands = {away, needed};
        test.operandCount = 2;
        say(number, m_lines.cones, test);
    }

    void leaveOut(uint32_t number, Cause cause) {
        const uint32_t count = m_nodes[number].count;
        m_walk.culled[size_t(cause)] += count;
        m_gap[size_t(cause)] += count;
        if (m_record == nullptr) return;
        m_walk.judged.push_back({number, cause});
        say(number, lineOf(cause), ending(cell(number), Decision::Outcome::Culled, cause));
    }

    [[nodiscard]] uint8_t lineOf(Cause cause) const {
        return cause == Cause::BackFacing ? m_lines.cones : cause == Cause::Hidden ? m_lines.hiding : m_lines.planes;
    }

    void draw(uint32_t number) {
        const SurfaceNode& node = m_nodes[number];
        if (m_record != nullptr) {
            m_walk.judged.push_back({number, std::nullopt});
            say(number, m_lines.draw, ending(cell(number), Decision::Outcome::Drawn));
        }
        std::vector<PlaceRun>& drawn = m_walk.drawn;
        if (!drawn.empty() && node.first - (drawn.back().first + drawn.back().count) < kGap) {
            drawn.back().count = node.first + node.count - drawn.back().first;
            for (size_t cause = 0; cause < kCauseCount; ++cause) m_walk.culled[cause] -= m_gap[cause];
            for (size_t i = m_judgedBeforeGap; i < m_walk.judged.size(); ++i)
                bridge(
                    m_walk.judged[i],
                    CULLSCOPE_TR("Left out, but drawn after all: it lies between two ranges, and fewer than %1 triangles are not "
                                 "worth a range of their own."),
                    kGap);
        } else {
            drawn.push_back({node.first, node.count});
        }
        m_gap = {};
        m_judgedBeforeGap = m_walk.judged.size();
    }

    void drawWholeWhereFewAreLeftOut() {
        const uint64_t all = m_nodes[0].count;
        const uint64_t leftOut = std::accumulate(m_walk.culled.begin(), m_walk.culled.end(), uint64_t{0});
        const uint64_t saved = leftOut - m_walk.culled[size_t(Cause::BackFacing)] / 2;
        if (leftOut == 0 || saved * kLeastShareLeftOut >= all) return;
        m_walk.culled = {};
        m_walk.drawn = {{0, uint32_t(all)}};
        for (JudgedNode& judged : m_walk.judged)
            bridge(judged,
                   CULLSCOPE_TR(
                       "Left out, but drawn after all: less than one in %1 triangles of the object is left out, those that face "
                       "away counted half, and drawing all of it in the order of neighbours is faster."),
                   double(kLeastShareLeftOut));
    }

    /// A cell that is drawn although its tests left it out; `sentence` says why, of the number `operand`.
    void bridge(JudgedNode& judged, const char* sentence, double operand) {
        if (!judged.cause) return;
        Decision drawn = ending(cell(judged.node), Decision::Outcome::DrawnAfterAll, *judged.cause);
        judged.cause.reset();
        judged.bridged = true;
        drawn.sentence = sentence;
        drawn.operands[0] = operand;
        drawn.operandCount = 1;
        say(judged.node, m_lines.draw, drawn);
    }

    const SurfaceNodes& m_nodes;
    const PartView& m_view;
    const HidingTest* m_hiding;
    std::vector<uint32_t>* m_leaves;
    PartWalkLines m_lines;
    ObjectRecord* m_record;
    bool m_tests;
    double m_snap;
    std::array<Vec3, 6> m_spread{};             ///< components |n| of the planes' normals: |n| · half is half the box's extent
                                                ///< along n
    std::array<uint64_t, kCauseCount> m_gap{};  ///< triangles culled since the last range, by cause
    size_t m_judgedBeforeGap = 0;
    PartWalk m_walk;
};

}  // namespace

PartWalk walkParts(const SurfaceNodes& nodes, const PartView& view, const PartTests& tests, ObjectRecord* record) {
    if (nodes.size() == 0) return {};
    Walker walker(nodes, view, tests, record);
    walker.visit(0, {tests.planes, tests.cones && view.eyeKnown, tests.hiding != nullptr});
    return walker.take(tests);
}

}  // namespace cullscope
