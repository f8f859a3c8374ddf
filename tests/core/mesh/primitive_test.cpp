#include "core/mesh/primitive/primitive.h"

#include <gmock/gmock.h>

#include <set>

#include "core/base/sha256.h"
#include "core/mesh/primitive/tessellate.h"
#include "core/mesh/primitive/turn.h"

namespace cullscope::primitive::primitive_test {
namespace {

constexpr Angle degrees(double value) { return Angle::fromDegrees(value); }

/// At least one of each kind, with sizes that differ in all directions.
std::vector<Primitive> ordinary() {
    return {Sphere{1.5},
            Cylinder{0.5, 3.0},
            Cone{1.0, 0.0, 2.0},
            Cone{1.0, 0.4, 2.0},
            EccentricCone{1.0, 0.5, 2.0, {0.7, -0.3}},
            EccentricCone{1.0, 0.6, 2.0, {0.7, -0.3}, {degrees(20), degrees(-10)}, {degrees(-15), degrees(5)}},
            MitredCylinder{0.5, 2.0, {degrees(30), degrees(0)}, {degrees(-22.5), degrees(40)}},
            CircularTorus{1.5, 0.5},
            CircularTorus{1.5, 0.5, degrees(90)},
            RectangularTorus{1.0, 1.5, 0.7},
            RectangularTorus{1.0, 1.5, 0.7, degrees(200)},
            EllipsoidalDish{1.0, 0.5},
            EllipsoidalDish{0.5, 1.0},
            EllipsoidalDish{1.0, 1.0},
            SphericalDish{1.0, 0.3},
            SphericalDish{0.5, 1.4},
            TorisphericalHead{1.0, 2.0, 0.2},
            TorisphericalHead{1.0, 1.6, 0.3},
            Box{{1.0, 2.0, 3.0}},
            Wedge{{1.0, 2.0, 3.0}},
            Pyramid{{1.0, 2.0}, 3.0, {0.5, -0.2}},
            PyramidFrustum{{2.0, 3.0}, {1.0, 2.5}, 1.5, {0.4, 0.1}},
            Prism{6, 1.0, 0.8},
            Disc{1.0},
            Ring{0.4, 1.0},
            HollowCylinder{0.8, 1.0, 2.0}};
}

/// Sizes at their limits, of which each is possible.
std::vector<Primitive> extreme() {
    return {Cylinder{1.0, 0.0},
            Cylinder{1e-6, 1e6},
            Cone{0.0, 1.0, 2.0},
            Cone{1.0, 0.5, 0.0},
            Cone{1.0, 0.0, 0.0},
            EccentricCone{1.0, 0.0, 1.0, {3.0, 0.0}},
            EccentricCone{1.0, 1.0, 0.5, {0.0, 2.0}},
            MitredCylinder{0.5, 1.0, {degrees(45), {}}, {degrees(-45), {}}},  // its wall has the height 0 on one side
            CircularTorus{1.0, 1.0},
            CircularTorus{1.0, 1.0, degrees(90)},
            CircularTorus{1.0, 0.01, degrees(0.5)},
            CircularTorus{1.0, 0.25, Angle::fromRadians(double(float(kTurn)))},
            RectangularTorus{0.0, 1.0, 0.5, degrees(90)},
            RectangularTorus{0.0, 1.0, 0.5},
            RectangularTorus{0.5, 1.0, 0.0, degrees(180)},
            EllipsoidalDish{1.0, 0.0},
            SphericalDish{1.0, 0.0},
            SphericalDish{1.0, 1.0},
            SphericalDish{0.01, 1.0},
            SphericalDish{1.0, 1e-6},
            TorisphericalHead{1.0, 1.0, 1.0},
            TorisphericalHead{1.0, 1.0, 0.0},
            TorisphericalHead{1.0, 3.0, 0.0},
            Box{{1.0, 2.0, 0.0}},
            Box{{0.0, 2.0, 1.0}},
            Box{{1.0, 0.0, 1.0}},
            Wedge{{1.0, 2.0, 0.0}},
            Wedge{{0.0, 2.0, 1.0}},
            Wedge{{1.0, 0.0, 1.0}},
            Pyramid{{1.0, 2.0}, 0.0, {0.0, 0.0}},
            Pyramid{{1.0, 2.0}, 1.0, {5.0, 0.0}},
            PyramidFrustum{{0.0, 0.0}, {1.0, 2.0}, 1.0},
            PyramidFrustum{{1.0, 2.0}, {0.0, 2.0}, 1.0},
            Prism{3, 1.0, 0.0},
            Prism{1000, 1.0, 1.0},
            Ring{0.0, 1.0},
            Ring{0.999, 1.0},
            HollowCylinder{0.999, 1.0, 0.0}};
}

std::string shown(const Primitive& primitive, size_t number) {
    return std::string(kindName(primitive.index())) + ", case " + std::to_string(number);
}

Surface surfaceOf(const Primitive& primitive, const Fineness& fineness, const Mat4& transform = Mat4(1.0)) {
    Surface surface;
    appendSurface(surface, primitive, fineness, transform);
    return surface;
}

struct Measured {
    double volume = 0.0, area = 0.0;
    Box3 box;
};

Measured measured(const Surface& surface) {
    Measured sums;
    for (size_t i = 0; i < surface.triangles.size(); i += 3) {
        const Vec3 a = surface.positions[surface.triangles[i]], b = surface.positions[surface.triangles[i + 1]],
                   c = surface.positions[surface.triangles[i + 2]];
        sums.volume += glm::dot(a, glm::cross(b, c)) / 6.0;
        sums.area += 0.5 * glm::length(glm::cross(b - a, c - a));
        for (const Vec3& corner : {a, b, c}) sums.box.add(corner);
    }
    return sums;
}

TEST(Primitives, areEighteenKindsWithNames) {
    EXPECT_EQ(kKinds, 18u);
    std::set<std::string> names;
    std::set<size_t> kinds;
    for (size_t kind = 0; kind < kKinds; ++kind) names.insert(kindName(kind));
    for (const Primitive& primitive : ordinary()) kinds.insert(primitive.index());
    EXPECT_EQ(names.size(), 18u);
    EXPECT_EQ(kinds.size(), 18u) << "the tests below take all of them";
}

TEST(Primitives, areClosedAndFaceOutwardAtAnyFineness) {
    std::vector<Primitive> all = ordinary();
    const std::vector<Primitive> limits = extreme();
    all.insert(all.end(), limits.begin(), limits.end());
    for (size_t i = 0; i < all.size(); ++i) {
        ASSERT_FALSE(whyImpossible(all[i])) << shown(all[i], i);
        for (const Fineness& fineness : {Fineness{0.1, 0}, Fineness{0.003, 0}, Fineness{1, 3}, Fineness{1, 5}, Fineness{1, 24}}) {
            const Surface surface = surfaceOf(all[i], fineness);
            const MeshPointer mesh = meshOf(surface, "a");
            EXPECT_GT(mesh->triangleCount(), 1u) << shown(all[i], i);
            const Topology& topology = mesh->topology();
            EXPECT_EQ(topology.boundaryEdges, 0u) << shown(all[i], i) << ", segments " << fineness.segments;
            EXPECT_EQ(topology.nonManifoldEdges, 0u) << shown(all[i], i) << ", segments " << fineness.segments;
            EXPECT_EQ(topology.inconsistentEdges, 0u) << shown(all[i], i) << ", segments " << fineness.segments;
            if (volume(all[i]) > 1e-9) {
                EXPECT_GT(measured(surface).volume, 0.0) << shown(all[i], i);
            }
        }
    }
}

TEST(Primitives, tessellationsConvergeToTheFormulas) {
    const std::vector<Primitive> all = ordinary();
    for (size_t i = 0; i < all.size(); ++i) {
        const Measured coarse = measured(surfaceOf(all[i], {1, 64})), fine = measured(surfaceOf(all[i], {1, 256}));
        const double cube = std::max(volume(all[i]), 1.0), square = area(all[i]);
        EXPECT_NEAR(fine.volume, volume(all[i]), 2e-3 * cube) << shown(all[i], i);
        EXPECT_NEAR(fine.area, area(all[i]), 2e-3 * square) << shown(all[i], i);
        // Sixteen times as near with four times the chords: the formula is the limit, not only near it.
        EXPECT_LT(std::abs(fine.volume - volume(all[i])), std::abs(coarse.volume - volume(all[i])) / 8.0 + 1e-12 * cube)
            << shown(all[i], i);
        // The walls of an eccentric cone with mitred ends are twisted: two triangles across them have the mean of the ends'
        // widths, not that of all widths between, however many there are around.
        const auto* cone = std::get_if<EccentricCone>(&all[i]);
        if (cone != nullptr && cone->bottom.x != Angle()) continue;
        EXPECT_LT(std::abs(fine.area - area(all[i])), std::abs(coarse.area - area(all[i])) / 8.0 + 1e-9 * square)
            << shown(all[i], i);
    }
}

TEST(Primitives, boxesAreThoseOfTheFormula) {
    std::vector<Primitive> all = ordinary();
    const std::vector<Primitive> limits = extreme();
    all.insert(all.end(), limits.begin(), limits.end());
    for (size_t i = 0; i < all.size(); ++i) {
        const Box3 exact = bounds(all[i]), tessellated = measured(surfaceOf(all[i], {1e-4, 0})).box;
        for (int axis = 0; axis < 3; ++axis) {
            EXPECT_NEAR(tessellated.min[axis], exact.min[axis], 2e-4) << shown(all[i], i) << ", axis " << axis;
            EXPECT_NEAR(tessellated.max[axis], exact.max[axis], 2e-4) << shown(all[i], i) << ", axis " << axis;
            EXPECT_GE(tessellated.min[axis], exact.min[axis] - 1e-9) << "corners lie on the surface; " << shown(all[i], i);
            EXPECT_LE(tessellated.max[axis], exact.max[axis] + 1e-9) << shown(all[i], i);
        }
    }
}

/// The largest distance of a tessellation's triangles from its surface, sampled.
template <typename Distance>
double largestDistance(const Surface& surface, const Distance& distance) {
    double largest = 0.0;
    for (size_t i = 0; i < surface.triangles.size(); i += 3)
        for (int a = 0; a <= 6; ++a)
            for (int b = 0; a + b <= 6; ++b) {
                const Vec3 at = (double(a) * surface.positions[surface.triangles[i]] +
                                 double(b) * surface.positions[surface.triangles[i + 1]] +
                                 double(6 - a - b) * surface.positions[surface.triangles[i + 2]]) /
                                6.0;
                largest = std::max(largest, std::abs(distance(at)));
            }
    return largest;
}

TEST(Primitives, keepTheChordErrorAskedForWithoutWastingTriangles) {
    for (const double error : {0.1, 0.01, 0.001}) {
        const double sphere =
            largestDistance(surfaceOf(Sphere{2.0}, {error, 0}), [](const Vec3& p) { return glm::length(p) - 2.0; });
        EXPECT_LE(sphere, error);
        EXPECT_GT(sphere, error / 4.0) << "finer than asked for";
        const double torus = largestDistance(surfaceOf(CircularTorus{2.0, 0.5}, {error, 0}),
                                             [](const Vec3& p) { return std::hypot(std::hypot(p.x, p.y) - 2.0, p.z) - 0.5; });
        EXPECT_LE(torus, error);
        EXPECT_GT(torus, error / 4.0) << "finer than asked for";
        const double wall = largestDistance(surfaceOf(Cylinder{2.0, 1.0}, {error, 0}), [](const Vec3& p) {
            return std::abs(p.z) < 0.4999 ? std::hypot(p.x, p.y) - 2.0 : 0.0;
        });
        EXPECT_LE(wall, error);
        EXPECT_GT(wall, error / 4.0) << "finer than asked for";
        const double cap = largestDistance(surfaceOf(SphericalDish{1.0, 0.5}, {error, 0}), [](const Vec3& p) {
            return p.z > 1e-9 ? glm::length(p - Vec3(0, 0, -0.75)) - 1.25 : 0.0;
        });
        EXPECT_LE(cap, error);
        const TorisphericalHead head{1.0, 2.0, 0.2};
        const double crown = largestDistance(surfaceOf(head, {error, 0}), [&](const Vec3& p) {
            const double across = std::hypot(p.x, p.y), edge = crownOf(head).edge.x * head.crownRadius;
            if (p.z < 1e-9) return 0.0;
            return across < edge ? glm::length(p - Vec3(0, 0, crownOf(head).centre)) - 2.0 : std::hypot(across - 0.8, p.z) - 0.2;
        });
        EXPECT_LE(crown, error);
    }
}

TEST(Primitives, mirroredOnesFaceOutwardToo) {
    Mat4 mirror(1.0);
    mirror[0][0] = -2.0;
    mirror[3] = Vec4(5.0, -3.0, 2.0, 1.0);
    for (const Primitive& primitive : ordinary()) {
        if (volume(primitive) == 0.0) continue;
        const Surface surface = surfaceOf(primitive, {1, 24}, mirror);
        EXPECT_TRUE(meshOf(surface, "a")->topology().frontFacesSuffice()) << kindName(primitive.index());
        const double plain = measured(surfaceOf(primitive, {1, 24})).volume;
        EXPECT_NEAR(measured(surface).volume, 2.0 * plain, 1e-9 * plain);
    }
}

TEST(Primitives, normalsPointOutward) {
    for (const Primitive& primitive : ordinary()) {
        const Surface surface = surfaceOf(primitive, {1, 24});
        for (size_t i = 0; i < surface.triangles.size(); i += 3) {
            const Vec3 a = surface.positions[surface.triangles[i]], b = surface.positions[surface.triangles[i + 1]],
                       c = surface.positions[surface.triangles[i + 2]];
            const Vec3 face = glm::normalize(glm::cross(b - a, c - a));
            for (size_t corner = 0; corner < 3; ++corner) {
                const Vec3 normal = surface.normals[surface.triangles[i + corner]];
                EXPECT_NEAR(glm::length(normal), 1.0, 1e-12);
                EXPECT_GT(glm::dot(normal, face), 0.7) << kindName(primitive.index());
            }
        }
    }
}

TEST(Primitives, impossibleSizesAreRefusedInASentence) {
    using testing::HasSubstr;
    const auto refusal = [](const Primitive& primitive) {
        const std::optional<Message> why = whyImpossible(primitive);
        return why ? why->english() : std::string();
    };
    const double nan = std::numeric_limits<double>::quiet_NaN(), infinite = std::numeric_limits<double>::infinity();
    EXPECT_THAT(refusal(Cylinder{-1.0, 1.0}), HasSubstr("cylinder: its lengths"));
    EXPECT_THAT(refusal(Sphere{nan}), HasSubstr("sphere: its lengths"));
    EXPECT_THAT(refusal(Box{{1.0, infinite, 1.0}}), HasSubstr("box: its lengths"));
    EXPECT_THAT(refusal(EccentricCone{1.0, 0.5, 1.0, {nan, 0.0}}), HasSubstr("eccentric cone: its lengths"));
    EXPECT_THAT(refusal(Cone{0.0, 0.0, 1.0}), HasSubstr("is a point or a line"));
    EXPECT_THAT(refusal(Box{{1.0, 0.0, 0.0}}), HasSubstr("is a point or a line"));
    EXPECT_THAT(refusal(Pyramid{{0.0, 0.0}, 1.0}), HasSubstr("is a point or a line"));
    EXPECT_THAT(refusal(Disc{0.0}), HasSubstr("is a point or a line"));
    EXPECT_THAT(refusal(CircularTorus{1.0, 1.5}), HasSubstr("thicker than its ring"));
    EXPECT_THAT(refusal(CircularTorus{1.0, 0.5, degrees(0)}), HasSubstr("360 degrees"));
    EXPECT_THAT(refusal(CircularTorus{1.0, 0.5, degrees(361)}), HasSubstr("360 degrees"));
    EXPECT_THAT(refusal(RectangularTorus{1.0, 2.0, 1.0, degrees(-90)}), HasSubstr("360 degrees"));
    EXPECT_THAT(refusal(RectangularTorus{1.0, 1.0, 1.0}), HasSubstr("inner radius"));
    EXPECT_THAT(refusal(Ring{2.0, 1.0}), HasSubstr("ring: its inner radius"));
    EXPECT_THAT(refusal(HollowCylinder{2.0, 1.0, 1.0}), HasSubstr("inner radius"));
    EXPECT_THAT(refusal(TorisphericalHead{1.0, 0.5, 0.1}), HasSubstr("crown"));
    EXPECT_THAT(refusal(TorisphericalHead{1.0, 2.0, 1.1}), HasSubstr("knuckle"));
    EXPECT_THAT(refusal(Prism{2, 1.0, 1.0}), HasSubstr("3 to 1000 sides"));
    EXPECT_THAT(refusal(MitredCylinder{1.0, 1.0, {degrees(90), {}}, {}}), HasSubstr("less than 90 degrees"));
    EXPECT_THAT(refusal(MitredCylinder{1.0, 1.0, {degrees(45), {}}, {degrees(-45), {}}}), HasSubstr("cut each other"));
}

TEST(Primitives, pointsOfTheCircleAreThoseOfTheCLibrary) {
    for (const uint64_t count : {1, 3, 7, 8, 24, 360, 1001})
        for (uint64_t i = 0; i < count; ++i) {
            const double angle = kTurn * double(i) / double(count);
            EXPECT_NEAR(onCircle(i, count).x, std::cos(angle), 1e-15);
            EXPECT_NEAR(onCircle(i, count).y, std::sin(angle), 1e-15);
            EXPECT_NEAR(glm::distance(onCircle(Angle::fromRadians(angle)), onCircle(i, count)), 0.0, 2e-15);
        }
    EXPECT_EQ(onCircle(2, 8), Vec2(0.0, 1.0));
    EXPECT_EQ(onCircle(1, 8).x, onCircle(1, 8).y);
    EXPECT_EQ(onCircle(degrees(90)), Vec2(0.0, 1.0));
    EXPECT_EQ(onCircle(degrees(-180)), Vec2(-1.0, 0.0));
}

TEST(Primitives, areTheSameBitsOnEveryMachine) {
    Sha256 hash;
    for (const Primitive& primitive : ordinary()) {
        const Surface surface = surfaceOf(primitive, {0.01, 0});
        hash.addValues(std::span<const Vec3>(surface.positions));
        hash.addValues(std::span<const uint32_t>(surface.triangles));
    }
    EXPECT_EQ(hash.hexadecimal(), "4cc49a55408dcdfdb863c24220aa39148549cd62d71493f93e20109dbb293a6e");
}

}  // namespace
}  // namespace cullscope::primitive::primitive_test
