#include "core/visibility/spherical/cell_walk.h"

#include "core/base/message.h"
#include "core/visibility/spherical/listings.h"

namespace cullscope::spherical {
namespace {

// Cells of fewer triangles are drawn faster than the horizon test takes.
constexpr uint32_t kLeastForHorizon = 96;

constexpr PartWalkLines kLines{.planes = uint8_t(WalkLine::Planes),
                               .cones = uint8_t(WalkLine::Cones),
                               .hiding = uint8_t(WalkLine::Horizon),
                               .draw = uint8_t(WalkLine::Draw)};

/// Whether the kernel's horizon hides a cell.
class HorizonTest final : public HidingTest {
public:
    explicit HorizonTest(const KernelHorizon& horizon) : HidingTest(kLeastForHorizon), m_horizon(horizon) {}

    [[nodiscard]] Reach test(const Vec3& middle, const Vec3& half, Decision* said) const override {
        const KernelHorizon::Comparison compared = m_horizon.compare(middle, glm::length(half));
        if (said != nullptr) *said = decisionOf(compared);
        return compared.reach;
    }

private:
    static Decision decisionOf(const KernelHorizon::Comparison& compared) {
        Decision test;
        test.sentence = CULLSCOPE_TR(
            "Its sphere reaches the slope %1; the kernel's horizon before it is not everywhere higher (%2): part of it may be "
            "visible.");
        if (compared.reach == KernelHorizon::Reach::Hidden) {
            test.containment = Containment::Outside;
            test.sentence =
                CULLSCOPE_TR("Its sphere reaches the slope %1; the kernel's horizon before it is higher, at least %2: hidden.");
        } else if (compared.reach == KernelHorizon::Reach::Visible) {
            test.containment = Containment::Inside;
            test.sentence = CULLSCOPE_TR(
                "Its sphere begins at the slope %1, above the kernel's horizon, at most %2: the kernel hides none of it.");
        }
        test.operands = {compared.slope, compared.horizon};
        test.operandCount = 2;
        return test;
    }

    const KernelHorizon& m_horizon;
};

}  // namespace

CellWalk walkCells(const CellTree& tree, const ObjectSpaceView& view, const CellTests& tests, ObjectRecord* record) {
    std::optional<HorizonTest> horizon;
    if (tests.horizon != nullptr) horizon.emplace(*tests.horizon);
    return {
        walkParts(SurfaceNodes(tree.nodes()), view, {tests.planes, tests.cones, horizon ? &*horizon : nullptr, kLines}, record),
        {}};
}

}  // namespace cullscope::spherical
