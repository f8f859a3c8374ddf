#include "core/geometry/frustum.h"

#include <cmath>

#include "core/geometry/random.h"

// The cases of the battery of extremes keep their numbers: camera at the origin looking down −z, 90°, aspect 1, near 0.1, far 10
// unless said.

namespace cullscope::frustum_test {
namespace {

constexpr Vec3 kForward(0, 0, -1);
constexpr Vec3 kRight(1, 0, 0);
constexpr Vec3 kUp(0, 1, 0);

Frustum standardFrustum(double farDistance = 10.0) { return makeFrustum(kForward, kRight, kUp, 1.0, 1.0, 0.1, farDistance); }

EyeBox box(const Vec3& min, const Vec3& max) { return {0.5 * (min + max), 0.5 * (max - min)}; }

TEST(Frustum, planesPointInward) {
    const Frustum frustum = standardFrustum();
    for (const Plane& plane : frustum.planes) {
        EXPECT_NEAR(glm::length(plane.normal), 1.0, 1e-15);
        EXPECT_GT(plane.distance({0, 0, -5}), 0.0);
    }
    const auto plane = [&](FrustumPlane which) { return frustum.planes[static_cast<size_t>(which)]; };
    EXPECT_LT(plane(FrustumPlane::Left).distance({-6, 0, -5}), 0.0);
    EXPECT_LT(plane(FrustumPlane::Right).distance({6, 0, -5}), 0.0);
    EXPECT_LT(plane(FrustumPlane::Bottom).distance({0, -6, -5}), 0.0);
    EXPECT_LT(plane(FrustumPlane::Top).distance({0, 6, -5}), 0.0);
    EXPECT_NEAR(plane(FrustumPlane::Near).distance({3, 2, -1}), 0.9, 1e-15);
    EXPECT_NEAR(plane(FrustumPlane::Far).distance({3, 2, -1}), 9.0, 1e-15);
}

TEST(Frustum, cornersLieOnTheirPlanes) {
    const Frustum frustum = makeFrustum(kForward, kRight, kUp, 1.7, 0.6, 1e-6, 1e9);
    const auto corners = frustum.corners();
    for (size_t i = 0; i < corners.size(); ++i) {
        const double size = glm::length(corners[i]);
        const auto on = [&](FrustumPlane plane) {
            return std::abs(frustum.planes[static_cast<size_t>(plane)].distance(corners[i])) < 1e-15 * size;
        };
        EXPECT_TRUE(on(i < 4 ? FrustumPlane::Near : FrustumPlane::Far)) << i;
        EXPECT_TRUE(on(i % 4 == 0 || i % 4 == 3 ? FrustumPlane::Left : FrustumPlane::Right)) << i;
        EXPECT_TRUE(on(i % 4 < 2 ? FrustumPlane::Bottom : FrustumPlane::Top)) << i;
    }
}

TEST(Frustum, case1SphereThatPassesEveryPlaneButLiesOutsideIsAKnownFalsePositive) {
    const Sphere sphere{{13, 13, -11}, 1.5};
    EXPECT_EQ(classify(standardFrustum(), sphere), Containment::Straddles);
    // The nearest point of the frustum is its far corner (10, 10, −10): 4.36 away, beyond the radius.
    EXPECT_NEAR(glm::distance(sphere.centre, Vec3(10, 10, -10)), 4.36, 0.005);
}

TEST(Frustum, case2BoxThatPassesEveryPlaneButLiesOutsideIsAKnownFalsePositive) {
    EXPECT_EQ(classify(standardFrustum(), box({15, -5, -30}, {40, 5, -9.5})), Containment::Straddles);
    // It is outside nevertheless: the frustum's points have x <= −z and −z <= 10, so x <= 10 < 15.
}

TEST(Plane, case3BoxThatOnlyItsExtentLengthKeepsIsOutside) {
    const Plane below{{0, -1, 0}, 0.0};
    const EyeBox flat{{0, 10, 0}, {60, 1, 1}};
    EXPECT_EQ(pVertexDistance(below, flat), -9.0) << "p-vertex: outside";
    EXPECT_GT(below.distance(flat.centre) + glm::length(flat.halfExtent), 0.0) << "extent length: kept";
    EXPECT_EQ(classify(below, flat, 0.0), Containment::Outside);
}

TEST(Plane, case4SphereFarFromTheOriginIsJudgedRightInDouble) {
    const Vec3 on(1e7 + 5.5, 0, -1e7 + 6.5);
    const Vec3 normal(.6, 0, -.8);
    const Sphere sphere{{1e7 + 8.5, 0, -1e7 + 7.5}, 1.0};
    const Plane plane{normal, -glm::dot(normal, on)};
    EXPECT_NEAR(plane.distance(sphere.centre), 1.0, 1e-8);

    // The result of a test in float, so that the case stays relevant: −2 instead of +1.
    const Vec3f normalf(normal);
    const float offset = -glm::dot(normalf, Vec3f(on));
    EXPECT_LT(glm::dot(normalf, Vec3f(sphere.centre)) + offset, 0.5f);

    // Relative to an eye nearby no digits are lost.
    const Vec3 eye = on;
    const Plane fromEye{normal, 0.0};
    EXPECT_NEAR(fromEye.distance(sphere.centre - eye), 1.0, 1e-15);
}

TEST(Frustum, case14SphereThatEveryCornerRayMissesStraddles) {
    EXPECT_EQ(classify(standardFrustum(100.0), Sphere{{11, 0, -10}, 2.0}), Containment::Straddles);
}

TEST(Frustum, case22BoxAroundTheCameraOrBeyondFarStraddles) {
    EXPECT_EQ(classify(standardFrustum(), box({-1, -1, -3}, {1, 1, 3})), Containment::Straddles);
    EXPECT_EQ(classify(standardFrustum(), box(Vec3(-1000), Vec3(1000))), Containment::Straddles);
    EXPECT_EQ(classify(standardFrustum(), Sphere{Vec3(0.0), 1000.0}), Containment::Straddles);
}

TEST(Frustum, case23ExtremeFieldsAndSizesAreJudgedRight) {
    for (const double fovy : {0.01, 179.0})
        for (const double aspect : {1.0 / 16384, 1.0, 16384.0}) {
            const double tanHalfHeight = std::tan(Angle::fromDegrees(fovy).radians() / 2);
            const Frustum frustum = makeFrustum(kForward, kRight, kUp, tanHalfHeight * aspect, tanHalfHeight, 1e-6, 1e9);
            for (const Plane& plane : frustum.planes) EXPECT_NEAR(glm::length(plane.normal), 1.0, 1e-15);
            const double x = tanHalfHeight * aspect;
            const double y = tanHalfHeight;
            for (const double depth : {1e-3, 1.0, 1e6}) {
                const Vec3 room(1e-4 * depth * x, 1e-4 * depth * y, 1e-4 * depth);
                const EyeBox inView{depth * Vec3(0.5 * x, 0.5 * y, -1), room};
                EXPECT_NE(classify(frustum, inView), Containment::Outside) << fovy << "° aspect " << aspect << " depth " << depth;
                const EyeBox behind{depth * Vec3(0.5 * x, 0.5 * y, 1), room};
                EXPECT_EQ(classify(frustum, behind), Containment::Outside) << fovy << "° aspect " << aspect << " depth " << depth;
                const EyeBox above{depth * Vec3(0, 1.1 * y + 0.01, -1), Vec3(1e-4 * depth * x, 1e-4 * depth * y, 1e-5 * depth)};
                EXPECT_EQ(classify(frustum, above) == Containment::Outside, 1e-4 * x < 1.0 || y > 1.0)
                    << fovy << "° aspect " << aspect << " depth " << depth;
            }
        }
}

TEST(Frustum, onlyWhatLiesWhollyWithinIsInside) {
    EXPECT_EQ(classify(standardFrustum(), box({-1, -1, -6}, {1, 1, -4})), Containment::Inside);
    EXPECT_EQ(classify(standardFrustum(), box({-1, -1, -6}, {5, 1, -4})), Containment::Straddles);
    EXPECT_EQ(classify(standardFrustum(), Sphere{{0, 0, -5}, 1}), Containment::Inside);
    EXPECT_EQ(classify(standardFrustum(), Sphere{{0, 0, -9.5}, 1}), Containment::Straddles);
    EXPECT_EQ(classify(standardFrustum(), Sphere{{0, 0, 1}, 1}), Containment::Outside);
}

TEST(Frustum, boxIsOutsideOrInsideOnlyWhereAllItsCornersAre) {
    // A box is outside only if all its corners are outside one plane; inside only if all are inside every plane.
    Random random(5);
    int outside = 0, inside = 0;
    for (int i = 0; i < 20000; ++i) {
        const EyeBox some{random.direction() * random.between(0, 15),
                          {random.between(0, 4), random.between(0, 4), random.between(0, 4)}};
        const Frustum frustum = standardFrustum();
        bool allInside = true, separated = false;
        for (const Plane& plane : frustum.planes) {
            bool all = true, none = true;
            for (int corner = 0; corner < 8; ++corner) {
                const Vec3 sign((corner & 1) != 0 ? 1 : -1, (corner & 2) != 0 ? 1 : -1, (corner & 4) != 0 ? 1 : -1);
                const bool in = plane.distance(some.centre + sign * some.halfExtent) >= 0;
                all = all && in;
                none = none && !in;
            }
            allInside = allInside && all;
            separated = separated || none;
        }
        const Containment answer = classify(frustum, some);
        EXPECT_TRUE(separated || answer != Containment::Outside);
        EXPECT_TRUE(allInside || answer != Containment::Inside);
        outside += answer == Containment::Outside ? 1 : 0;
        inside += answer == Containment::Inside ? 1 : 0;
    }
    EXPECT_GT(outside, 1000);
    EXPECT_GT(inside, 100);
}

TEST(Frustum, boxFromTheEyeHoldsItsCorners) {
    Random random(6);
    for (int i = 0; i < 10000; ++i) {
        const Vec3 eye = random.direction() * std::pow(10.0, random.between(-6, 9));
        const Vec3 centre = random.direction() * std::pow(10.0, random.between(-6, 9));
        const Vec3 half = glm::abs(random.direction()) * std::pow(10.0, random.between(-9, 3));
        const Box3 world{centre - half, centre + half};
        const EyeBox relative = relativeToEye(world, eye);
        for (const Vec3& corner : {world.min, world.max})
            for (int axis = 0; axis < 3; ++axis) {
                const long double exact = static_cast<long double>(corner[axis]) - static_cast<long double>(eye[axis]);
                EXPECT_LE(std::abs(exact - static_cast<long double>(relative.centre[axis])),
                          static_cast<long double>(relative.halfExtent[axis]));
            }
    }
}

}  // namespace
}  // namespace cullscope::frustum_test
