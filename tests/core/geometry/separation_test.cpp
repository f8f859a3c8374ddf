#include "core/geometry/separation.h"

#include <cmath>

// The cases of the battery of extremes keep their numbers: camera at the origin looking down −z, 90°, aspect 1, near 0.1, far 10
// unless said.

namespace cullscope::separation_test {
namespace {

Frustum standardFrustum(double farDistance = 10.0) {
    return makeFrustum({0, 0, -1}, {1, 0, 0}, {0, 1, 0}, 1.0, 1.0, 0.1, farDistance);
}

EyeBox box(const Vec3& min, const Vec3& max) { return {0.5 * (min + max), 0.5 * (max - min)}; }

OrientedBox oriented(const EyeBox& box) {
    return {box.centre, {Vec3(box.halfExtent.x, 0, 0), Vec3(0, box.halfExtent.y, 0), Vec3(0, 0, box.halfExtent.z)}, 0.0};
}

TEST(Separation, case1FalsePositiveSphereIsSeparated) {
    const Sphere sphere{{13, 13, -11}, 1.5};
    EXPECT_EQ(classify(standardFrustum(), sphere), Containment::Straddles) << "of the planes, it is one";
    EXPECT_TRUE(separated(standardFrustum(), sphere, 1e-5));
    // 4.3589 = √(3² + 3² + 1²) away.
    EXPECT_TRUE(separated(standardFrustum(), Sphere{sphere.centre, std::sqrt(19.0) - 1e-9}, 0.0));
    EXPECT_FALSE(separated(standardFrustum(), Sphere{sphere.centre, std::sqrt(19.0)}, 0.0));
    EXPECT_FALSE(separated(standardFrustum(), sphere, 3.0)) << "margin";
}

TEST(Separation, case2FalsePositiveBoxIsSeparated) {
    const EyeBox wide = box({15, -5, -30}, {40, 5, -9.5});
    EXPECT_EQ(classify(standardFrustum(), wide), Containment::Straddles) << "of the planes, it is one";
    EXPECT_EQ(classify(standardFrustum(), oriented(wide)), Containment::Straddles);
    EXPECT_TRUE(separated(standardFrustum(), wide, 1e-5));
    EXPECT_TRUE(separated(standardFrustum(), oriented(wide), 1e-5));
    EXPECT_TRUE(separated(standardFrustum(), wide, 4.99));
    EXPECT_FALSE(separated(standardFrustum(), wide, 5.01)) << "x <= 10 in the frustum, x >= 15 in the box";
    EXPECT_FALSE(separated(standardFrustum(), box({10, -5, -30}, {40, 5, -9.5}), 0.0)) << "touches an edge";
}

TEST(Separation, case3BoxThatOnlyItsExtentLengthKeepsIsSeparated) {
    const Frustum below = makeFrustum({0, 0, -1}, {1, 0, 0}, {0, 1, 0}, 100.0, 1e-3, 0.1, 100);
    const EyeBox flat{{0, 10, -50}, {60, 1, 1}};
    EXPECT_EQ(classify(below, flat), Containment::Outside);
    EXPECT_TRUE(separated(below, flat, 1e-4));
    EXPECT_TRUE(separated(below, oriented(flat), 1e-4));
}

TEST(Separation, case4TouchingSphereFarFromTheOriginIsNotSeparated) {
    // Relative to the eye it is 1 from the plane, and its radius 1.
    const Vec3 normal(.6, 0, -.8), right(.8, 0, .6);
    const Frustum frustum = makeFrustum(normal, right, glm::cross(right, normal), 1, 1, 3, 1e7);
    EXPECT_FALSE(separated(frustum, Sphere{normal * 2.0, 1.0}, 0.0));
    EXPECT_TRUE(separated(frustum, Sphere{normal * 2.0, 1.0 - 1e-9}, 0.0));
    const Vec3 far = 1e7 * normal + 1e7 * right;
    EXPECT_FALSE(separated(frustum, Sphere{far + normal * 0.5, 0.5}, 0.0));
}

TEST(Separation, case14SphereThatEveryCornerRayMissesIsNotSeparated) {
    EXPECT_FALSE(separated(standardFrustum(100.0), Sphere{{11, 0, -10}, 2.0}, 0.0));
    EXPECT_TRUE(separated(standardFrustum(100.0), Sphere{{11, 0, -10}, 0.7}, 0.0)) << "1/√2 away";
}

TEST(Separation, case22BoxAroundTheCameraOrBeyondFarIsNotSeparated) {
    for (const EyeBox& around : {box({-1, -1, -3}, {1, 1, 3}), box(Vec3(-1000), Vec3(1000))}) {
        EXPECT_FALSE(separated(standardFrustum(), around, 0.0));
        EXPECT_FALSE(separated(standardFrustum(), oriented(around), 0.0));
        EXPECT_TRUE(meetsNearRectangle(standardFrustum(), around, 0.0));
    }
    EXPECT_FALSE(separated(standardFrustum(), Sphere{Vec3(0.0), 1000.0}, 0.0));
}

TEST(Separation, case23ExtremeFieldsAreNotSeparatedFromWhatTheyShow) {
    for (const double fovy : {0.01, 179.0})
        for (const double aspect : {1.0 / 16384, 1.0, 16384.0}) {
            const double y = std::tan(Angle::fromDegrees(fovy).radians() / 2);
            const double x = y * aspect;
            const Frustum frustum = makeFrustum({0, 0, -1}, {1, 0, 0}, {0, 1, 0}, x, y, 1e-6, 1e9);
            for (const double depth : {1e-3, 1.0, 1e6})
                for (const Vec3 corner : {Vec3(1, 1, -1), Vec3(-1, 1, -1), Vec3(0, -1, -1), Vec3(0.5, 0.5, -1)}) {
                    const Vec3 at = depth * corner * Vec3(x, y, 1);
                    EXPECT_FALSE(separated(frustum, EyeBox{at, Vec3(0.0)}, 0.0)) << fovy << "° " << aspect << " " << depth;
                    EXPECT_FALSE(separated(frustum, Sphere{at, 0.0}, 0.0));
                    const Vec3 beyond = at + Vec3(1e-5 * glm::length(at), 0, 0) * corner.x;
                    if (std::abs(corner.x) == 1.0 && x < 1.0) {
                        EXPECT_TRUE(separated(frustum, Sphere{beyond, 0.0}, 0.0)) << fovy << "° " << aspect << " " << depth;
                    }
                }
        }
}

TEST(Separation, whatIsNotFiniteIsNotSeparated) {
    const double inf = std::numeric_limits<double>::infinity(), nan = std::nan("");
    for (const double bad : {inf, -inf, nan, 1e300, -1e300}) {
        EXPECT_FALSE(separated(standardFrustum(), EyeBox{{0, 0, -5}, Vec3(std::abs(bad))}, 0.0));
        EXPECT_FALSE(separated(standardFrustum(), Sphere{{0, 0, -5}, std::abs(bad)}, 0.0));
    }
    for (const double bad : {inf, -inf, nan}) {
        EXPECT_FALSE(separated(standardFrustum(), EyeBox{{bad, 0, -5}, Vec3(1)}, 0.0));
        EXPECT_FALSE(separated(standardFrustum(), Sphere{{bad, 0, -5}, 1}, 0.0));
    }
    EXPECT_FALSE(separated(standardFrustum(), orientedBox(Box3(), Mat4(1.0), Vec3(0.0)), 0.0)) << "an empty box";
}

TEST(MayBeSeparated, needsTwoPlanesThatAreNotOpposite) {
    const auto bits = [](std::initializer_list<FrustumPlane> planes) {
        uint32_t mask = 0;
        for (const FrustumPlane plane : planes) mask |= 1u << uint32_t(plane);
        return mask;
    };
    using enum FrustumPlane;
    EXPECT_FALSE(mayBeSeparated(0));
    for (const FrustumPlane plane : {Left, Right, Bottom, Top, Near, Far}) EXPECT_FALSE(mayBeSeparated(bits({plane})));
    for (const auto& pair : {bits({Left, Right}), bits({Bottom, Top}), bits({Near, Far})}) EXPECT_FALSE(mayBeSeparated(pair));
    for (const auto& some : {bits({Left, Bottom}), bits({Right, Top}), bits({Right, Far}), bits({Top, Near}), 0b111111u})
        EXPECT_TRUE(mayBeSeparated(some));
}

}  // namespace
}  // namespace cullscope::separation_test
