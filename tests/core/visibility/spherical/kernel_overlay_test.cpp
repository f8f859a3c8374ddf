// Inner kernels and tested cells as lines in the world.

#include <set>

#include "core/gpu/colour.h"
#include "core/visibility/spherical/map_overlays.h"
#include "core/visibility/verdict_palette.h"
#include "tests/support/hand_made_map.h"
#include "tests/support/line_distance.h"
#include "tests/support/lossless_map.h"

namespace cullscope::test::kernel_overlay_test {
namespace {

using namespace spherical;

const DrawStyle kLight{Vec3f(1.0f)};

OverlayContext contextOf(const LosslessMap& seen, const View& viewing) {
    return {*seen.scene, viewing, kLight, verdictPalette(kLight.background), contrastTo(kLight.background)};
}

View viewFrom(const Vec3& eye) {
    return {Camera{eye, Vec3(0.0), {0.1, 0.9, 0.2}, Angle::fromDegrees(45), 0.05, 100.0}, {640, 480}};
}

TEST(KernelOverlay, gridStaysWithinTheKernel) {
    const LosslessMap seen(starMesh(3, 20000), MapLayout::Octahedral, {0.4, 0.3, 3.0});
    const InnerKernel& kernel = *seen.map().kernel;
    const Vec3 centre = seen.map().maps.sphere().centre;
    const View viewing = viewFrom({2.0, 1.0, -2.0});
    const std::vector<OverlayLines> overlays = kernelOverlay(contextOf(seen, viewing), mapsOf(seen.snapshot));
    ASSERT_GT(overlays[0].lines.size(), 200u);
    for (const LineSegment& line : overlays[0].lines) {
        const Vec3 from = line.from - centre, to = line.to - centre;
        for (const double t : {0.0, 0.25, 0.5, 0.75}) {
            const Vec3 point = glm::mix(from, to, t);
            EXPECT_LE(glm::length(point), kernel.radius(octahedralCell(point, kernel.level())) * (1.0 + 1e-6));
        }
        EXPECT_GE(glm::length(from), kernel.leastRadius() * (1.0 - 1e-6));
    }
}

TEST(KernelOverlay, gridThinsOutAndShowsItsNearSideOnly) {
    const LosslessMap seen(sphereMesh(20000), MapLayout::Octahedral, {0.4, 0.3, 3.0});
    const auto grid = [&](const View& viewing) {
        return kernelOverlay(contextOf(seen, viewing), mapsOf(seen.snapshot))[0].lines;
    };
    const View near = viewFrom({0, 0, 3}), far = viewFrom({0, 0, 20}), farther = viewFrom({0, 0, 60});
    for (const LineSegment& line : grid(near)) EXPECT_GT(std::max(line.from.z, line.to.z), -0.2);
    EXPECT_LT(grid(far).size(), grid(near).size() / 2);
    EXPECT_GT(grid(far).size(), 10u);
    EXPECT_TRUE(grid(farther).empty());
}

TEST(KernelOverlay, horizonAndAxisAreDrawn) {
    const LosslessMap seen(starMesh(3, 20000), MapLayout::Octahedral, {0.4, 0.3, 3.0});
    const View viewing = viewFrom({2.0, 1.0, -2.0});
    const std::vector<OverlayLines> overlays = kernelOverlay(contextOf(seen, viewing), mapsOf(seen.snapshot));
    const Vec3 centre = seen.map().maps.sphere().centre;
    const std::vector<Vec3>& outline = seen.map().decision.walk->outline;
    EXPECT_LT(distanceTo(overlays[1].lines, 0.5 * (centre + seen.view.eye())), 1e-6);
    ASSERT_EQ(overlays[2].lines.size(), outline.size());
    for (size_t i = 0; i < outline.size(); ++i) {
        EXPECT_LT(glm::distance(overlays[2].lines[i].from, centre + outline[i]), 1e-9);
        EXPECT_EQ(overlays[2].lines[i].to, overlays[2].lines[(i + 1) % outline.size()].from);
    }
    EXPECT_TRUE(overlays[2].cased);
}

TEST(KernelOverlay, thereIsNoneWhereThereIsNoKernel) {
    const View viewing = viewFrom({2.0, 1.0, -2.0});
    const LosslessMap knot(knotMesh(20000), MapLayout::Octahedral, {0.4, 0.3, 3.0});
    const LosslessMap outside(sphereMesh(20000), MapLayout::Octahedral, {0.4, 0.3, 3.0}, {0.4, 0.3, 6.0});
    for (const LosslessMap* seen : {&knot, &outside}) {
        EXPECT_FALSE(hasKernel(seen->map()));
        for (const OverlayLines& overlay : kernelOverlay(contextOf(*seen, viewing), mapsOf(seen->snapshot)))
            EXPECT_TRUE(overlay.lines.empty());
    }
    // Seen from inside, nothing is hidden, but the kernel exists.
    const LosslessMap within(sphereMesh(20000), MapLayout::Octahedral, {0, 0, 0.3}, {1, 0, 0});
    EXPECT_TRUE(hasKernel(within.map()));
    EXPECT_TRUE(kernelOverlay(contextOf(within, viewing), mapsOf(within.snapshot))[2].lines.empty());
}

TEST(SphereOverlay, judgedCellsLieOnTheSphereInTheirColours) {
    for (const MapLayout layout : kLayouts) {
        const LosslessMap seen(starMesh(3, 20000), layout, {0.4, 0.3, 3.0}, {0.5, 0.0, 0.0}, 25.0);
        const Sphere& sphere = seen.map().maps.sphere();
        std::set<std::array<float, 3>> colours;
        for (const Vec3& eye : {Vec3(0.4, 0.3, 3.0), Vec3(-0.4, -0.3, -3.0)}) {
            const View viewing = viewFrom(eye);
            const OverlayContext context = contextOf(seen, viewing);
            const std::vector<LineSegment> lines = sphereOverlay(context, mapsOf(seen.snapshot)).back().lines;
            EXPECT_GT(lines.size(), 100u);
            for (const LineSegment& line : lines) {
                EXPECT_NEAR(glm::length(line.from - Vec3(sphere.centre)), sphere.radius, 1e-9);
                EXPECT_GT(glm::dot(line.from - Vec3(sphere.centre), eye - Vec3(sphere.centre)), 0.0) << "on the far side";
                colours.insert({line.colour.x, line.colour.y, line.colour.z});
            }
        }
        const auto palette = verdictPalette(kLight.background);
        for (const TriangleState state : {TriangleState::Visible, TriangleState::OutsideFrustum, TriangleState::BackFacing}) {
            const Vec3f& colour = palette[size_t(state)].colour;
            EXPECT_EQ(colours.count({colour.x, colour.y, colour.z}), 1u) << triangleStateName(state);
        }
    }
}

}  // namespace
}  // namespace cullscope::test::kernel_overlay_test
