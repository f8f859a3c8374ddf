// The planes of a frustum by their source: the blog's as printed, and mended.
#include "core/visibility/frustum/plane_sources.h"

#include <gmock/gmock.h>

#include "tests/support/culler.h"
#include "tests/support/exact_visibility.h"
#include "tests/support/random_views.h"
#include "tests/support/spherical_scenes.h"

namespace cullscope::test::plane_sources_test {
namespace {

using frustum::PlaneSource;

std::vector<bool> drawnBy(Culler& culler, const View& view, size_t instances) {
    std::vector<bool> drawn(instances, false);
    for (const DrawRange& range : culler.cull(view).drawList.ranges) drawn[range.instance] = true;
    return drawn;
}

TEST(PlaneSources, thoseOfRowsAndCornersAreTheBasisOrAreNotUsed) {
    Random random(11);
    size_t kept = 0, replaced = 0;
    for (uint64_t seed = 1; seed <= 200; ++seed) {
        const ScenePointer scene = randomScene(seed);
        for (int i = 0; i < 10; ++i) {
            const RandomView of = randomView(*scene, random);
            const View view(of.camera, of.viewport);
            for (const PlaneSource source : {PlaneSource::Rows, PlaneSource::Corners}) {
                const frustum::SourcedFrustum sourced = frustumFrom(view, source);
                ++(sourced.kept ? kept : replaced);
                for (size_t plane = 0; plane < kFrustumPlaneCount; ++plane) {
                    const Plane &own = sourced.frustum.planes[plane], &basis = view.frustum().planes[plane];
                    EXPECT_LE(glm::length(own.normal - basis.normal), 0x1p-24);
                    EXPECT_LE(std::abs(own.offset - basis.offset), 0x1p-24 * std::abs(basis.offset));
                }
            }
        }
    }
    EXPECT_GT(kept, 1000u);
    EXPECT_GT(replaced, 0u) << "near : far beyond all measure";
}

TEST(PlaneSources, thoseAsPrintedAreTheNearPlaneFiveTimesAndAFarPlaneAtDistanceOne) {
    // From the origin near and far corners fall together at distance 1, for the division by w is missing.
    const View view({Vec3(0.0), {0, 0, -1}, {0, 1, 0}, Angle::fromDegrees(90), 0.5, 100}, {100, 100});
    const FrustumPlanes planes = frustum::publishedPlanes(view);
    for (const FrustumPlane plane : {FrustumPlane::Left, FrustumPlane::Right, FrustumPlane::Bottom, FrustumPlane::Top}) {
        EXPECT_EQ(planes[size_t(plane)].normal, planes[size_t(FrustumPlane::Near)].normal);
        EXPECT_EQ(planes[size_t(plane)].offset, planes[size_t(FrustumPlane::Near)].offset);
    }
    const Plane &near = planes[size_t(FrustumPlane::Near)], &far = planes[size_t(FrustumPlane::Far)];
    // Outward, and four times as long as a unit normal: twice the width times twice the height at distance 1.
    EXPECT_NEAR(near.normal.z, 4.0, 1e-12);
    EXPECT_NEAR(far.normal.z, -4.0, 1e-12);
    EXPECT_NEAR(near.distance({0, 0, -1}), 0.0, 1e-12);
    EXPECT_NEAR(far.distance({0, 0, -1}), 0.0, 1e-12);
    EXPECT_GT(far.distance({0, 0, -5}), 0.0) << "what lies beyond is outside";
}

TEST(PlaneSources, blogAsPrintedLosesObjectsAndMendedItDoesNot) {
    std::vector<Mat4> places;
    for (int i = 0; i < 100; ++i) places.push_back(translation({3.0 * (i % 10), 0.0, 3.0 * (i / 10)}));
    const ScenePointer scene = copiesOf(sphereMesh(80), places);
    for (const char* box : {"sphere", "length"}) {
        const CullerPointer printed = strategyWith("frustum", {{"planes", "as-published"}, {"box", box}});
        const CullerPointer mended = strategyWith("frustum", {{"planes", "corners"}, {"box", box}});
        printed->build(*scene);
        mended->build(*scene);
        EXPECT_EQ(printed->promise(), Promise::Approximate);
        EXPECT_EQ(mended->promise(), Promise::Conservative);
        Random random(4);
        uint64_t visible = 0, lost = 0, wasted = 0;
        for (int i = 0; i < 100; ++i) {
            const Vec3 eye(random.between(-10, 40), random.between(1, 15), random.between(-10, 40));
            const Camera camera{eye, {13.5, 0, 13.5}, {0, 1, 0}, Angle::fromDegrees(random.between(20, 70)), 0.1, 200};
            const View view(camera, {64, 48});
            const ExactVisibility exact(camera, {64, 48});
            const std::vector<bool> drawn = drawnBy(*printed, view, places.size()), right = drawnBy(*mended, view, places.size());
            for (uint32_t object = 0; object < places.size(); ++object) {
                const bool seen = exact.judge(*scene, object).visible;
                visible += seen ? 1 : 0;
                lost += seen && !drawn[object] ? 1 : 0;
                wasted += !seen && drawn[object] ? 1 : 0;
                EXPECT_TRUE(right[object] || !seen) << "view " << i << " object " << object;
            }
        }
        EXPECT_GT(lost, visible / 4) << box;
        RecordProperty(std::string(box) + "_lost_percent", int(100 * lost / visible));
        RecordProperty(std::string(box) + "_drawn_in_vain", int(wasted));
    }
}

}  // namespace
}  // namespace cullscope::test::plane_sources_test
