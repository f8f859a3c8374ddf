// The model in spherical coordinates: the pixels that a triangle covers, and the triangle picked at a pixel.

#include <numbers>

#include "core/geometry/random.h"
#include "core/mesh/parametric.h"
#include "tests/support/gl_environment.h"
#include "tests/support/spherical_meshes.h"
#include "tests/support/test_scenes.h"

namespace cullscope::test::spherical_drawing_test {
namespace {

constexpr Viewport kSize{360, 180};  // one pixel a degree
constexpr double kDegree = std::numbers::pi / 180.0;
const DrawStyle kWhite{Vec3f(1.0f)};

Vec3 direction(double thetaDegrees, double phiDegrees) {
    const double theta = thetaDegrees * kDegree, phi = phiDegrees * kDegree;
    return {std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta)};
}

Vec3f corner(double theta, double phi, double radius = 1.0) { return Vec3f(radius * direction(theta, phi)); }

View anyView(const Viewport& size) { return {Camera{}, size}; }

/// Small R is red, large R is green.
SphericalModel wholePicture(const Sphere& sphere, const Viewport& size = kSize) {
    SphericalModel model;
    model.sphere = sphere;
    model.ramp = {Vec3f(1, 0, 0), Vec3f(1, 0, 0), Vec3f(1, 0, 0), Vec3f(0, 1, 0), Vec3f(0, 1, 0)};
    model.area = mapArea(size, 0.0);
    return model;
}

/// Access to pixels by the degrees that they show.
struct Map {
    std::vector<uint8_t> rgba;
    std::vector<float> depth;

    [[nodiscard]] const uint8_t* at(int theta, int phi) const { return &rgba[4 * (size_t(179 - theta) * 360 + size_t(phi))]; }
    [[nodiscard]] bool covered(int theta, int phi) const { return at(theta, phi)[2] != 255; }
    [[nodiscard]] size_t count() const {
        size_t pixels = 0;
        for (int theta = 0; theta < 180; ++theta)
            for (int phi = 0; phi < 360; ++phi) pixels += covered(theta, phi) ? 1 : 0;
        return pixels;
    }
};

Map drawn(const MeshPointer& mesh, const Vec3& centre = Vec3(0.0), const DrawList* list = nullptr) {
    const ScenePointer scene = sceneOf({mesh});
    const SceneBuffers buffers(scene, Upload::Vbo);
    Framebuffer target(kSize);
    GlEnvironment::renderer().drawSpherical(buffers, anyView(kSize), list != nullptr ? *list : everything(*scene, Facing::Front),
                                            wholePicture({centre, 2.0}), target, kWhite);
    return {target.readColour(), target.readDepth()};
}

TEST(SphericalDrawing, triangleOverTheSeamIsDrawnOnBothSides) {
    const Map map = drawn(looseTriangles({{corner(80, 340), corner(100, 340), corner(90, 20)}}));
    for (const int phi : {342, 350, 359, 0, 5, 15}) EXPECT_TRUE(map.covered(90, phi)) << phi;
    for (int phi = 21; phi < 339; ++phi)
        for (int theta = 0; theta < 180; ++theta) ASSERT_FALSE(map.covered(theta, phi)) << theta << " " << phi;
    for (const int phi : {350, 0, 10}) {
        EXPECT_FALSE(map.covered(78, phi));
        EXPECT_FALSE(map.covered(102, phi));
    }
}

TEST(SphericalDrawing, triangleOverAPoleCoversIt) {
    for (const bool south : {false, true}) {
        const auto theta = [&](double degrees) { return south ? 180.0 - degrees : degrees; };
        const Map map = drawn(looseTriangles({{corner(theta(30), 10), corner(theta(20), 140), corner(theta(25), 250)}}));
        for (int phi = 0; phi < 360; ++phi) {
            for (int row = 0; row < 8; ++row) ASSERT_TRUE(map.covered(south ? 179 - row : row, phi)) << row << " " << phi;
            for (int row = 31; row < 150; ++row) ASSERT_FALSE(map.covered(south ? 179 - row : row, phi)) << row << " " << phi;
        }
    }
}

TEST(SphericalDrawing, cornerOrEdgeAtAPoleStaysSharp) {
    // A quarter of the cap around the pole, and a half that ends in a line over it.
    const Map quarter = drawn(looseTriangles({{Vec3f(0, 0, 1), corner(20, 30), corner(20, 120)}}));
    const Map half = drawn(looseTriangles({{corner(20, 30), corner(20, 210), corner(20, 120)}}));
    for (const Map& map : {quarter, half}) {
        for (int phi = 32; phi < 119; ++phi) ASSERT_TRUE(map.covered(3, phi)) << phi;
        for (int phi = 215; phi < 360; ++phi) ASSERT_FALSE(map.covered(3, phi)) << phi;
    }
    EXPECT_FALSE(quarter.covered(3, 125));
    EXPECT_TRUE(half.covered(3, 200));
}

TEST(SphericalDrawing, edgeIsAGreatCircleArc) {
    // Between two corners at 60° from the pole and 120° apart the great circle climbs to 40.9°.
    const Map map = drawn(looseTriangles({{corner(60, 100), corner(60, 220), corner(95, 160)}}));
    const double top = std::atan(std::tan(60 * kDegree) * std::cos(60 * kDegree)) / kDegree;
    EXPECT_TRUE(map.covered(int(top) + 1, 160));
    EXPECT_FALSE(map.covered(int(top) - 1, 160));
}

TEST(SphericalDrawing, fartherOutHidesNearerToTheCentre) {
    const std::array<Vec3f, 3> near{corner(80, 80, 0.4), corner(100, 80, 0.4), corner(90, 110, 0.4)};
    const std::array<Vec3f, 3> far{corner(80, 85, 1.8), corner(100, 85, 1.8), corner(90, 105, 1.8)};
    for (const bool nearFirst : {true, false}) {
        const Map map = drawn(nearFirst ? looseTriangles({near, far}) : looseTriangles({far, near}));
        EXPECT_GT(map.at(90, 92)[1], map.at(90, 92)[0]) << "farther out is green";
        EXPECT_GT(map.at(90, 82)[0], map.at(90, 82)[1]) << "beside it, what lies inside";
        EXPECT_TRUE(std::ranges::all_of(map.depth, [](float depth) { return depth == 0.0f; })) << "left depth";
    }
}

TEST(SphericalDrawing, closedMeshCoversEveryDirection) {
    const size_t all = size_t(kSize.width) * size_t(kSize.height);
    EXPECT_EQ(drawn(sphereMesh(20)).count(), all);
    EXPECT_EQ(drawn(sphereMesh(20000)).count(), all);
    EXPECT_EQ(drawn(starMesh(7, 50000)).count(), all);
    EXPECT_EQ(drawn(boxMesh(Vec3f(-1), Vec3f(1))).count(), all) << "edges along the seam and corners on the diagonals";
    EXPECT_EQ(drawn(sphereMesh(5000), Vec3(0.3, -0.2, 0.5)).count(), all) << "about another centre";
}

TEST(SphericalDrawing, everyDirectionShowsWhatItsRayMeets) {
    // The triangle of each pixel is confirmed by intersecting the ray through the pixel.
    Random random(11);
    std::vector<std::array<Vec3f, 3>> all;
    for (int i = 0; i < 40; ++i) {
        const Vec3 middle = random.direction() * random.between(0.5, 1.5);
        std::array<Vec3f, 3> triangle;
        for (Vec3f& each : triangle) each = Vec3f(middle + random.direction() * random.between(0.05, 0.8));
        all.push_back(triangle);
    }
    const auto meets = [](const Vec3& d, const std::array<Vec3f, 3>& t, double margin) {
        const std::array c{Vec3(t[0]), Vec3(t[1]), Vec3(t[2])};
        const Vec3 n = glm::cross(c[1] - c[0], c[2] - c[0]);
        if (glm::dot(n, c[0]) / glm::dot(n, d) <= 0.0) return false;
        double least = 1e30, most = -1e30;
        for (size_t i = 0; i < 3; ++i) {
            const Vec3 plane = glm::normalize(glm::cross(c[i], c[(i + 1) % 3]));
            least = std::min(least, glm::dot(plane, d));
            most = std::max(most, glm::dot(plane, d));
        }
        return least >= -margin || most <= margin;
    };
    const Map map = drawn(looseTriangles(all));
    size_t covered = 0;
    for (int theta = 0; theta < 180; ++theta)
        for (int phi = 0; phi < 360; ++phi) {
            const Vec3 d = direction(theta + 0.5, phi + 0.5);
            const auto any = [&](double margin) {
                return std::ranges::any_of(all, [&](const auto& t) { return meets(d, t, margin); });
            };
            if (map.covered(theta, phi))
                ASSERT_TRUE(any(1e-5)) << theta << " " << phi;
            else
                ASSERT_FALSE(any(-1e-5)) << theta << " " << phi;
            covered += map.covered(theta, phi) ? 1 : 0;
        }
    EXPECT_GT(covered, 5000u);
}

TEST(SphericalDrawing, onlyTheListIsDrawn) {
    const MeshPointer mesh = looseTriangles(
        {{corner(80, 80), corner(100, 80), corner(90, 110)}, {corner(80, 180), corner(100, 180), corner(90, 210)}});
    const DrawList second{Facing::TwoSided, {{0, 3, 3}}};
    EXPECT_FALSE(drawn(mesh, Vec3(0.0), &second).covered(90, 90));
    EXPECT_TRUE(drawn(mesh, Vec3(0.0), &second).covered(90, 190));
    // The first place of another order is the second triangle of the mesh.
    const std::vector<uint32_t> indices{3, 4, 5, 0, 1, 2}, numbers{1, 0};
    auto order = std::make_shared<TriangleOrder>();
    order->meshes.push_back({indices, numbers});
    const DrawList ordered{Facing::TwoSided, {{0, 0, 3}}, order};
    EXPECT_FALSE(drawn(mesh, Vec3(0.0), &ordered).covered(90, 90));
    EXPECT_TRUE(drawn(mesh, Vec3(0.0), &ordered).covered(90, 190));
    const DrawList nothing{};
    EXPECT_EQ(drawn(mesh, Vec3(0.0), &nothing).count(), 0u);
}

TEST(SphericalDrawing, tilesArePartsOfThePicture) {
    const ScenePointer scene = sceneOf({knotMesh(4000)});
    const SceneBuffers buffers(scene, Upload::Vbo);
    const Viewport size{300, 200};
    const auto draw = [&](const PictureTile& tile) {
        Framebuffer target(tile);
        GlEnvironment::renderer().drawSpherical(buffers, anyView(size), everything(*scene, Facing::Front),
                                                wholePicture(scene->meshOf(0).localSphere(), size), target, kWhite);
        return target.readColour();
    };
    const std::vector<uint8_t> whole = draw({0, 0, size}), part = draw({120, 70, {50, 40}});
    size_t differing = 0, covered = 0;
    for (size_t y = 0; y < 40; ++y)
        for (size_t x = 0; x < 50; ++x) {
            const uint8_t* a = &part[4 * (y * 50 + x)];
            const uint8_t* b = &whole[4 * ((y + 70) * 300 + x + 120)];
            differing += std::equal(a, a + 4, b) ? 0 : 1;
            covered += a[2] != 255 ? 1 : 0;
        }
    EXPECT_LE(differing, 4u);
    EXPECT_GT(covered, 200u);
}

TEST(MapArea, isTwiceAsWideAsHighAndInTheMiddle) {
    for (const Viewport& size : {Viewport{640, 480}, Viewport{1000, 100}, Viewport{33, 21}, Viewport{1, 1}}) {
        const MapArea area = mapArea(size, 14.0);
        EXPECT_NEAR(area.width, 2.0 * area.height, 1.0);
        EXPECT_NEAR(area.left + 0.5 * area.width, 0.5 * size.width, 1.0);
        EXPECT_NEAR(area.bottom + 0.5 * area.height, 0.5 * size.height, 1.0);
        EXPECT_GE(area.left, size.width > 20 ? 2.0 : -1.0);
        EXPECT_GE(area.bottom, size.width > 20 ? 2.0 : -1.0);
    }
}

}  // namespace
}  // namespace cullscope::test::spherical_drawing_test
