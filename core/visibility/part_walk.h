#pragma once

#include <array>
#include <optional>
#include <vector>

#include "core/frame/cause.h"
#include "core/frame/decision.h"
#include "core/spatial/surface_bounds.h"
#include "core/visibility/object_record.h"
#include "core/visibility/part_view.h"

namespace cullscope {

/// A node of a tree over an object's triangles at which a walk ended, and the result.
struct JudgedNode {
    uint32_t node = 0;
    std::optional<Cause> cause;  ///< why it was culled; none: it is drawn
    bool bridged = false;        ///< a test left it out, but it is drawn with the ranges on both of its sides
};

/// The result of a walk over one object's tree.
struct PartWalk {
    bool cones = false, hiding = false;          ///< which tests besides the frustum's were applied to the object in this view
    std::vector<PlaceRun> drawn;                 ///< ascending, disjoint
    std::array<uint64_t, kCauseCount> culled{};  ///< triangles, by Cause
    uint64_t nodesVisited = 0;
    std::vector<JudgedNode> judged;  ///< only while a frame is recorded, and as read from it: ascending, disjoint
};

/// A test whether triangles within a box are hidden. What hides them is the strategy's.
class HidingTest {
public:
    /// What is known of the points of a box.
    enum class Reach : uint8_t {
        Hidden,  ///< all are hidden
        Open,    ///< some may be hidden
        Visible  ///< none is hidden by what the test knows
    };

    /// `least`: parts of fewer triangles are not tested.
    explicit HidingTest(uint32_t least) : m_least(least) {}
    virtual ~HidingTest() = default;
    HidingTest(const HidingTest&) = delete;
    HidingTest& operator=(const HidingTest&) = delete;

    [[nodiscard]] uint32_t least() const { return m_least; }
    /// The test of a box in local coordinates. Never Hidden where one of its points may be visible in the picture. `said`: if it
    /// is not null, it gets the containment, the sentence and the numbers of the test.
    [[nodiscard]] virtual Reach test(const Vec3& middle, const Vec3& half, Decision* said) const = 0;

private:
    uint32_t m_least;
};

/// The lines of a strategy's listing at which the walk's decisions fall.
struct PartWalkLines {
    uint8_t planes = 0, cones = 0, hiding = 0, draw = 0;
};

/// The tests that may be applied to an object's nodes in one view.
struct PartTests {
    uint8_t planes = 0x3f;               ///< bit p: FrustumPlane p may cut the object
    bool cones = false;                  ///< normal cones; only where back faces are not drawn
    const HidingTest* hiding = nullptr;  ///< null: nothing hides
    PartWalkLines lines{};
    /// Where it is not null, it gets the leaves that no test leaves out, ascending, and what becomes of them is decided and said
    /// elsewhere: the walk draws nothing.
    std::vector<uint32_t>* leaves = nullptr;
};

/// Walks a tree over an object's triangles. A node that is outside one plane, completely back-facing, or hidden is culled with
/// its subtree; one with no undecided test is drawn without visiting its children; leaves are drawn. Conservative: nothing
/// visible in the picture is culled, its rounding and its snapping to 1/256 pixel included. `record`, if it is not null, is told
/// of the tests where they fall, and of the result for each node at which the walk ended.
[[nodiscard]] PartWalk walkParts(const SurfaceNodes& nodes, const PartView& view, const PartTests& tests,
                                 ObjectRecord* record = nullptr);

}  // namespace cullscope
