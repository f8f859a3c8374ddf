#include "core/visibility/plane_colours.h"

#include <gtest/gtest.h>

#include "core/image/view_picture.h"
#include "tests/support/colour_difference.h"

// The colours of the six planes can be distinguished from each other, from the verdicts' colours, which appear beside them, and
// from the background: with normal colour vision and with three colour-vision deficiencies. Thirteen greys cannot all be
// distinguished, so luminance alone is not tested.

namespace cullscope::test::plane_colour_test {
namespace {

constexpr double kLeastDifference = 11.0;
constexpr double kLeastAmongPlanes = 13.0;
constexpr double kLeastContrast = 3.0;  ///< of lines to the background (WCAG 2.1, non-text contrast)
const std::array<Vec3f, 2> kBackgrounds{Vec3f(1.0f), Vec3f(0x14, 0x17, 0x1C) / 255.0f};

double luminance(const Vec3f& colour) { return glm::dot(linearOf(Vec3(colour)), Vec3(0.2126, 0.7152, 0.0722)); }

double difference(const Sight& sight, const Vec3f& a, const Vec3f& b) {
    return ciede2000(labOf(sight.seen(linearOf(Vec3(a)))), labOf(sight.seen(linearOf(Vec3(b)))));
}

TEST(PlaneColours, planesAndVerdictsAreToldApart) {
    for (const Vec3f& background : kBackgrounds) {
        const auto planes = planePalette(background);
        const auto verdicts = verdictPalette(background);
        for (const Sight& sight : sights()) {
            if (std::string(sight.name) == "greyscale") continue;
            for (size_t a = 0; a < planes.size(); ++a) {
                for (size_t b = 0; b < a; ++b)
                    EXPECT_GE(difference(sight, planes[a], planes[b]), kLeastAmongPlanes) << sight.name << " " << a << " " << b;
                for (size_t state = 0; state < verdicts.size(); ++state)
                    EXPECT_GE(difference(sight, planes[a], verdicts[state].colour), kLeastDifference)
                        << sight.name << " " << a << " and verdict " << state;
                EXPECT_GE(difference(sight, planes[a], background), kLeastDifference) << sight.name << " " << a;
            }
        }
    }
}

TEST(PlaneColours, linesStandOutFromTheBackground) {
    for (const Vec3f& background : kBackgrounds)
        for (const Vec3f& plane : planePalette(background)) {
            const double one = luminance(plane) + 0.05, other = luminance(background) + 0.05;
            EXPECT_GE(std::max(one, other) / std::min(one, other), kLeastContrast);
        }
}

TEST(PlaneCounts, objectsAreCountedAndGroupsAreNot) {
    const auto node = [](uint32_t instance, bool culled, std::optional<FrustumPlane> plane) {
        SnapshotNode made;
        made.instance = instance;
        made.culled = culled;
        made.rejectedBy = plane;
        return made;
    };
    StructureSnapshot snapshot;
    snapshot.nodes = {node(0, true, FrustumPlane::Far),
                      node(1, true, FrustumPlane::Far),
                      node(2, true, FrustumPlane::Left),
                      node(3, true, std::nullopt),
                      node(4, false, std::nullopt),
                      node(SnapshotNode::kGroup, true, FrustumPlane::Far),
                      node(SnapshotNode::kGroup, false, std::nullopt)};
    EXPECT_EQ(countByPlane(snapshot), (PlaneCounts{{1, 0, 0, 0, 0, 2}, 1, 1}));
    EXPECT_EQ(countByPlane({}), PlaneCounts{});
}

}  // namespace
}  // namespace cullscope::test::plane_colour_test
