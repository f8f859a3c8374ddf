// What Han & Hong 2008 leave open: each reading does what it says, from random eyes.
#include <gmock/gmock.h>

#include "core/visibility/spherical/recorded_decisions.h"
#include "core/visibility/why.h"
#include "tests/support/long_mode.h"
#include "tests/support/spherical_scenes.h"
#include "tests/support/spherical_views.h"

namespace cullscope::test::readings_test {
namespace {

using spherical::CornerRay;
using spherical::SphereRelation;
using spherical::SphericalDecision;

using Values = std::vector<std::pair<const char*, const char*>>;

/// Views without drawing: no sample is small.
uint64_t viewsOf(uint64_t all, uint64_t sample) { return longMode() ? all : sample; }

/// `spherical` with these readings, and one recorded frame of the first object.
struct Reader {
    Reader(const ScenePointer& scene, const Values& values) : culler(strategyWith("spherical", values)) { culler->build(*scene); }

    [[nodiscard]] SphericalDecision decide(const View& view) const {
        return spherical::decisionsOf(culler->cull(view, Recording::On).log).at(0);
    }

    CullerPointer culler;
};

size_t hitsOf(const SphericalDecision& decision) {
    return size_t(std::ranges::count_if(decision.rays, [](const CornerRay& ray) { return ray.hit.has_value(); }));
}

/// From 1.1 to 4 radii of a unit object, at any field of view, past its centre by up to a radius.
View aroundUnit(Random& random) {
    const double distance = random.between(1.1, 4.0);
    const Vec3 eye = distance * random.direction();
    const double aside = random.between(0.0, 1.0);
    return lookingAt(eye, aside * random.direction(), random.between(5.0, 100.0), {64, 48});
}

std::vector<ScenePointer> unitScenes() {
    return {sceneOf({sphereMesh(3'000)}), sceneOf({bumpyMesh(3, 3'000, 0.3)}), sceneOf({knotMesh(3'000)}),
            sceneOf({boxMesh({-1, -0.3f, -0.7f}, {0.9f, 0.4f, 0.8f})})};
}

/// Whether a point of the polar axis of a unit object, from its centre to beyond its surface, lies in the view.
bool holdsAPole(const View& view, const Sphere& sphere) {
    for (const double side : {1.0, -1.0})
        for (int step = 0; step <= 400; ++step) {
            const Vec3 point = sphere.centre + Vec3(0, 0, side * 1.001 * sphere.radius * step / 400.0);
            const auto& planes = view.frustum().planes;
            if (std::ranges::all_of(planes, [&](const Plane& plane) { return plane.distance(point - view.eye()) >= -0.01; }))
                return true;
        }
    return false;
}

TEST(SphericalReadings, noViewWithoutAPoleIsCaseOne) {
    Random random(2008);
    size_t without = 0, with = 0;
    for (const ScenePointer& scene : unitScenes()) {
        const Reader text(scene, {});
        for (uint64_t i = 0; i < viewsOf(10'000, 600) / 4; ++i) {
            // Half of them narrow, as most wide ones hold a pole.
            View view = aroundUnit(random);
            if (i % 2 == 0) view = lookingAt(view.eye(), view.camera().target, random.between(1.0, 25.0), {64, 48});
            const int number = text.culler->cull(view).caseNumber;
            const bool pole = holdsAPole(view, scene->boundingSphere());
            if (!pole) {
                EXPECT_NE(number, 1) << "eye " << view.eye().x << " " << view.eye().y << " " << view.eye().z << ", view " << i;
            }
            ++(pole ? with : without);
        }
    }
    EXPECT_GT(without, 50u);
    EXPECT_GT(with, 50u);
}

TEST(SphericalReadings, poleInViewAndOutlineThatWindsAreTwoRules) {
    Random random(5);
    size_t byOutlineAlone = 0, byDirectionAlone = 0, both = 0;
    for (const ScenePointer& scene : unitScenes()) {
        const Reader direction(scene, {{"branch", "appendix"}}), outline(scene, {{"branch", "appendix"}, {"pole", "outline"}});
        for (uint64_t i = 0; i < viewsOf(2'000, 500); ++i) {
            const View view = aroundUnit(random);
            const SphericalDecision a = direction.decide(view), b = outline.decide(view);
            if (!a.region) continue;
            EXPECT_EQ(a.region->winds, b.region->winds);
            EXPECT_EQ(b.region->caseNumber == 1, b.region->winds);
            const bool one = a.region->caseNumber == 1, other = b.region->caseNumber == 1;
            both += one && other ? 1 : 0;
            byDirectionAlone += one && !other ? 1 : 0;
            byOutlineAlone += other && !one ? 1 : 0;
            // Full rows hold whatever the outline alone holds.
            if (one && !other) {
                EXPECT_GE(a.drawnTriangles, b.drawnTriangles);
            }
        }
    }
    EXPECT_GT(both, 20u);
    EXPECT_GT(byDirectionAlone, 5u);
    EXPECT_GT(byOutlineAlone, 0u);
}

TEST(SphericalReadings, objectThatNoRayMeetsIsDecidedByBandsAsTheTextSays) {
    Random random(23);
    size_t missed = 0;
    for (const ScenePointer& scene : unitScenes()) {
        const Reader text(scene, {}), appendix(scene, {{"branch", "appendix"}});
        for (uint64_t i = 0; i < viewsOf(1'000, 60); ++i) {
            const View view = aroundUnit(random);
            const SphericalDecision read = text.decide(view), other = appendix.decide(view);
            ASSERT_EQ(read.relation, other.relation);
            if (read.relation != SphereRelation::Cut) continue;
            EXPECT_TRUE(other.region && !other.bands) << i;
            EXPECT_EQ(read.bands.has_value(), hitsOf(read) == 0) << i;
            EXPECT_EQ(read.region.has_value(), hitsOf(read) > 0) << i;
            if (hitsOf(read) > 0) {
                EXPECT_EQ(read.drawn, other.drawn) << i;
                continue;
            }
            ++missed;
            // The bands are those of an object inside the frustum, seen from the same eye.
            Camera wide = view.camera();
            wide.fovy = Angle::fromDegrees(179.0);
            wide.target = scene->boundingSphere().centre;
            wide.nearDistance = 1e-3;
            const SphericalDecision whole = text.decide(View(wide, {64, 64}));
            ASSERT_TRUE(whole.bands);
            if (whole.relation == SphereRelation::Within) {
                EXPECT_EQ(read.drawn, whole.drawn) << i;
            }
        }
    }
    EXPECT_GT(missed, 50u);
}

TEST(SphericalReadings, raysThatMissTakeTheirPointLeaveItOutOrLeadToBands) {
    Random random(31);
    std::array<size_t, 5> byHits{};
    for (const ScenePointer& scene : unitScenes()) {
        const Reader nearest(scene, {{"branch", "appendix"}}), left(scene, {{"branch", "appendix"}, {"missed", "left-out"}}),
            bands(scene, {{"branch", "appendix"}, {"missed", "bands"}});
        for (uint64_t i = 0; i < viewsOf(1'000, 60); ++i) {
            const View view = aroundUnit(random);
            const SphericalDecision of = nearest.decide(view);
            if (of.relation != SphereRelation::Cut) continue;
            const size_t hits = hitsOf(of);
            ++byHits[hits];
            EXPECT_EQ(of.region->outline.size(), 5u);
            const SphericalDecision leftOut = left.decide(view), byBands = bands.decide(view);
            EXPECT_EQ(leftOut.region.has_value(), hits > 0);
            if (hits > 0) {
                EXPECT_EQ(leftOut.region->outline.size(), hits + 1);
            } else {
                EXPECT_EQ(leftOut.drawnTriangles, 0u);
            }
            EXPECT_EQ(byBands.bands.has_value(), hits < 4);
            EXPECT_EQ(byBands.region.has_value(), hits == 4);
            if (hits == 4) {
                EXPECT_EQ(leftOut.drawn, of.drawn);
                EXPECT_EQ(byBands.drawn, of.drawn);
            }
        }
    }
    for (size_t hits = 0; hits <= 4; ++hits) EXPECT_GT(byHits[hits], 3u) << hits << " hits";
}

TEST(SphericalReadings, raysHitTheSameFromSphereAndBox) {
    Random random(37);
    size_t missed = 0, hit = 0;
    for (const ScenePointer& scene : unitScenes()) {
        const Values values{{"branch", "appendix"}, {"rays", "box"}};
        const Reader sphere(scene, {{"branch", "appendix"}}), box(scene, values);
        const Sphere bounds = scene->boundingSphere();
        const Box3 around = scene->instanceBox(0);
        for (uint64_t i = 0; i < viewsOf(1'000, 60); ++i) {
            const View view = aroundUnit(random);
            const SphericalDecision a = sphere.decide(view), b = box.decide(view);
            if (a.relation != SphereRelation::Cut) continue;
            for (size_t corner = 0; corner < 4; ++corner) {
                const CornerRay &of = a.rays[corner], &other = b.rays[corner];
                ASSERT_EQ(of.hit.has_value(), other.hit.has_value()) << i;
                if (of.hit) {
                    ++hit;
                    EXPECT_NEAR(glm::distance(of.point, other.point), 0.0, 1e-9);
                    continue;
                }
                ++missed;
                EXPECT_LE(glm::length(of.point), bounds.radius * (1.0 + 1e-9)) << "of the sphere";
                const Vec3 point = other.point + bounds.centre;
                for (int axis = 0; axis < 3; ++axis) {
                    EXPECT_GE(point[axis], around.min[axis] - 1e-6);
                    EXPECT_LE(point[axis], around.max[axis] + 1e-6);
                }
            }
        }
    }
    EXPECT_GT(hit, 100u);
    EXPECT_GT(missed, 100u);
}

TEST(SphericalReadings, cutByBandDrawsWhatTheCutForGoodDrawsAndWhatRisesAgainBehindIt) {
    Random random(41);
    size_t more = 0;
    for (const ScenePointer& scene : {sceneOf({bumpyMesh(3, 8'000, 0.5)}), sceneOf({knotMesh(8'000)})}) {
        const Reader forGood(scene, {}), byBand(scene, {{"cut", "by-band"}});
        for (uint64_t i = 0; i < viewsOf(200, 20); ++i) {
            const View view = lookingAt(4.0 * random.direction(), Vec3(0.0), 60.0, {64, 48});
            const SphericalDecision a = forGood.decide(view), b = byBand.decide(view);
            ASSERT_TRUE(a.bands && b.bands);
            for (uint32_t sector = 0; sector < a.bands->sectors; ++sector) {
                std::optional<uint32_t> first;
                for (uint32_t band = 0; band < a.bands->bands; ++band) {
                    const spherical::BandSector &cut = a.bands->at(band, sector), &own = b.bands->at(band, sector);
                    if (own.size == 0.0) continue;
                    ASSERT_EQ(cut.size, own.size);
                    if (first) {
                        EXPECT_FALSE(cut.drawn);
                        EXPECT_EQ(cut.cutBy, *first);
                    } else {
                        EXPECT_EQ(cut.drawn, own.drawn);
                        EXPECT_EQ(cut.cutBy, spherical::BandSector::kUncut);
                    }
                    EXPECT_EQ(own.cutBy, spherical::BandSector::kUncut);
                    if (!own.drawn && !first) first = band;
                    more += own.drawn && !cut.drawn ? 1 : 0;
                }
            }
        }
    }
    EXPECT_GT(more, 10u) << "nothing rises again behind a band that was hidden";
}

TEST(SphericalReadings, whyNamesTheBandThatCut) {
    const ScenePointer scene = sceneOf({bumpyMesh(3, 8'000, 0.5)});
    const Reader reader(scene, {});
    const View view = lookingAt({4, 0.3, 0.2}, Vec3(0.0), 60.0, {64, 48});
    const Culled frame = reader.culler->cull(view, Recording::On);
    size_t named = 0;
    for (const Decision& decision : frame.log.decisions) {
        if (decision.subject.kind != Subject::Kind::Band || decision.operandCount < 5) continue;
        ++named;
        // The band that it names was said before, was hidden, and was itself not cut.
        const auto cutter = std::ranges::find_if(frame.log.decisions, [&](const Decision& other) {
            return other.subject.kind == Subject::Kind::Band && other.operands[3] == decision.operands[3] &&
                   std::abs(other.operands[2] - decision.operands[4]) < 1e-9;
        });
        ASSERT_NE(cutter, frame.log.decisions.end());
        EXPECT_EQ(cutter->operandCount, 4u);
        EXPECT_LE(cutter->operands[0], cutter->operands[1]);
        EXPECT_LT(cutter->operands[2], decision.operands[2]);
    }
    EXPECT_GT(named, 50u);
}

}  // namespace
}  // namespace cullscope::test::readings_test
