// Scenes of the gallery: depths, sizes, places far from the origin, and order.
#include <array>
#include <cmath>

#include "core/geometry/random.h"
#include "core/mesh/parametric.h"
#include "core/scene/gallery/gallery_parts.h"

namespace cullscope::gallery {
namespace {

constexpr Vec3 kFar(1e7, -1e7, 1e7);

/// Four bodies, one of them mirrored; what is far away is looked at by cameras moved as exactly.
std::array<MeshPointer, 4> bodies() { return {knotMesh(1500), starMesh(7, 1000), torusMesh(800), teapotMesh(1000)}; }
std::array<Mat4, 4> places() {
    return {Mat4(1.0), moved({3, 0, -2}), moved({-3, .5, -1}) * scaled({-1, 1, 1}), moved({0, -2, 2}) * scaled(Vec3(.3))};
}

/// Views whose numbers are multiples of 2^-20, so that moving eye and target by whole numbers is exact.
std::vector<Camera> movedCameras(const Vec3& by) {
    Random random(21);
    const auto rounded = [](const Vec3& at) {
        return Vec3(std::round(at.x * 0x1p20), std::round(at.y * 0x1p20), std::round(at.z * 0x1p20)) * 0x1p-20;
    };
    std::vector<Camera> cameras;
    for (int i = 0; i < 4; ++i) {
        const double distance = random.between(3, 9);
        const Vec3 eye = rounded(random.direction() * distance), target = rounded(random.direction());
        cameras.push_back({eye + by, target + by, {0, 1, 0}, Angle::fromDegrees(60), 0.05, 100});
    }
    return cameras;
}

/// A star of a size, from near enough to fill the picture.
Camera cameraOn(double size) {
    Camera camera = cameraAt({0.5 * size, size, 3 * size}, 45);
    camera.nearDistance = size;
    camera.farDistance = 100 * size;
    return camera;
}

Vec3f randomCorner(Random& random) {
    const double x = random.between(-1, 1), y = random.between(-1, 1), z = random.between(-1, 1);
    return Vec3f(Vec3(x, y, z));
}

}  // namespace

Parts twoDepths() {
    Camera camera = usualCamera();
    camera.nearDistance = 0.01;
    camera.farDistance = 1e6;
    return Parts().add(square(4000, -1000.0f)).add(square(4000, -1000.01f)).from(camera);
}

Parts tiny() { return Parts().add(starMesh(9, 2000), scaled(Vec3(1e-18))).from(cameraOn(1e-18)); }
Parts huge() { return Parts().add(starMesh(9, 2000), scaled(Vec3(1e18))).from(cameraOn(1e18)); }

Parts mixedSizes() { return Parts().add(starMesh(9, 2000), scaled(Vec3(1e-18))).copy(scaled(Vec3(1e18))).from(cameraOn(1e18)); }

Parts atTheOrigin() {
    Parts parts;
    for (size_t i = 0; i < 4; ++i) parts.add(bodies()[i], places()[i]);
    return parts.from(movedCameras(Vec3(0.0)));
}

Parts movedByTransforms() {
    Parts parts;
    for (size_t i = 0; i < 4; ++i) parts.add(bodies()[i], moved(kFar) * places()[i]);
    return parts.from(movedCameras(kFar));
}

Parts movedByCoordinates() {
    Parts parts;
    for (size_t i = 0; i < 4; ++i) {
        const MeshPointer mesh = bodies()[i];
        TriangleMesh::Data data;
        data.name = mesh->name();
        data.origin = kFar;
        data.positions.assign(mesh->positions().begin(), mesh->positions().end());
        data.normals.assign(mesh->normals().begin(), mesh->normals().end());
        data.indices.assign(mesh->indices().begin(), mesh->indices().end());
        // A mesh whose origin is far away is turned and scaled about that origin.
        Mat4 place = places()[i];
        place[3] += Vec4(kFar - Mat3(place) * kFar, 0.0);
        parts.add(std::make_shared<TriangleMesh>(std::move(data)), place);
    }
    return parts.from(movedCameras(kFar));
}

Parts boxAroundTheEye() {
    return Parts().add(box({-1, -1, -3}, {1, 1, 3})).add(box(Vec3(-1000), Vec3(1000))).from(usualCamera());
}

Parts turningBehindWalls() {
    // Twelve walls around the eye with gaps between them, and bodies behind them that come into the gaps.
    Parts parts = Parts().add(box({-0.9, -2, -0.05}, {0.9, 2, 0.05}), moved({0, 0, -4}));
    constexpr int kWalls = 12;
    for (int i = 1; i < kWalls; ++i) parts.copy(turned({0, 1, 0}, kTurn * i / kWalls) * moved({0, 0, -4}));
    parts.add(starMesh(3, 320), moved({0, 0, -7}) * scaled(Vec3(0.4)));
    constexpr int kBodies = 60;
    for (int i = 1; i < kBodies; ++i)
        parts.copy(turned({0, 1, 0}, kTurn * i / kBodies) * moved({0, 0.4 * (i % 3 - 1), -7 - i % 4}) * scaled(Vec3(0.4)));
    // 180° a second at 60 frames a second. The eye also goes to the side, or no wall would uncover anything.
    for (int i = 0; i < 40; ++i) {
        const double turn = Angle::fromDegrees(3.0 * i).radians();
        const Vec3 eye(0.06 * i - 1.2, 0.0, 0.5 * std::sin(turn)), ahead(-std::sin(turn), 0.0, -std::cos(turn));
        parts.from(Camera{eye, eye + ahead, {0, 1, 0}, Angle::fromDegrees(60), 0.05, 100});
    }
    return parts;
}

Parts boxAroundTheView() {
    // Two squares to be seen, and triangles in the corners that stretch the object's box far around the eye and the far plane.
    std::vector<Vec3f> corners;
    for (const float z : {-5.0f, 15.0f})
        for (const Vec3f& corner :
             {Vec3f(-2, -2, z), Vec3f(2, -2, z), Vec3f(2, 2, z), Vec3f(-2, -2, z), Vec3f(2, 2, z), Vec3f(-2, 2, z)})
            corners.push_back(corner);
    for (const float side : {-20.0f, 20.0f})
        for (const Vec3f& offset : {Vec3f(0, 0, 0), Vec3f(0.01f, 0, 0), Vec3f(0, 0.01f, 0)})
            corners.push_back(Vec3f(side) - (side > 0 ? 1.0f : -1.0f) * offset);
    Camera outside = usualCamera();
    outside.eye = {0, 0, 20.05};
    outside.target = {0, 0, 19};
    return Parts().add(soup(std::move(corners))).from({usualCamera(), outside});
}

Parts smallAbuttingParts() {
    constexpr double kDistance = 100.0, kSize = 0.0038 * kDistance;
    Parts parts;
    parts.meshes.push_back(square(0.5f, 0.0f));
    for (int i = 0; i < 200 * 200; ++i)
        parts.copy(moved({kSize * (i % 200 - 99.5), kSize * (i / 200 - 99.5), -kDistance}) * scaled({kSize, kSize, 1.0}));
    return parts.from(Camera{Vec3(0.0), {0, 0, -1}, {0, 1, 0}, Angle::fromDegrees(60), 1.0, 1000.0});
}

Parts oneRoundingApart() {
    return Parts().add(square(3, -5.0f)).add(square(3, std::nextafterf(-5.0f, -6.0f))).from(usualCamera());
}

Parts acrossTheNearPlane() {
    // Every corner lies outside the view, two of them behind the eye, and the surface fills the lower half of the picture.
    return Parts()
        .add(soup({{-50, -1, 20}, {50, -1, 20}, {0, -1, -200}}))
        .add(soup({{-3, -4, 0.2f}, {4, 5, 0.1f}, {0.3f, 0.2f, -4}}))
        .from(usualCamera());
}

Parts nothingBesideSomething() {
    return Parts()
        .add(meshOf({}, {}))
        .add(soup({{0, 0, -3}, {0, 0, -3}, {0, 0, -3}, {0, 0, -2}, {1, 0, -2}, {2, 0, -2}}))
        .add(square(1, -4.0f))
        .from(usualCamera());
}

Parts barsInACycle() {
    std::vector<Vec3f> corners;
    for (int turn = 0; turn < 3; ++turn) {
        const double angle = kTurn * turn / 3, c = std::cos(angle), s = std::sin(angle);
        const auto at = [&](double x, double y, double z) { return Vec3f(Vec3(c * x - s * y, s * x + c * y, z)); };
        const Vec3f a = at(-3, -1.2, .5), b = at(3, -1.2, -.5), d = at(3, -.8, -.5), e = at(-3, -.8, .5);
        for (const Vec3f& corner : {a, b, d, a, d, e}) corners.push_back(corner);
    }
    return Parts().add(soup(std::move(corners))).from(Camera{{0, 0, 6}, Vec3(0.0), {0, 1, 0}, Angle::fromDegrees(60), 0.1, 100});
}

Parts pixelRule() {
    // In a picture of 8 × 8 pixels, half a pixel is 1/8 at distance 1; every number is a float.
    const auto at = [](float column, float row) { return Vec3f(column / 4 - 1, row / 4 - 1, -1); };
    const Vec3f corner = at(.5f, .5f), right = at(4.5f, .5f), up = at(.5f, 4.5f), both = at(4.5f, 4.5f);
    return Parts().add(soup({corner, right, up})).add(soup({right, both, up})).from(usualCamera());
}

Parts coplanar() {
    std::vector<Vec3f> positions;
    std::vector<uint32_t> indices;
    constexpr uint32_t kSide = 71;  // twice its square: 10,082 triangles
    for (uint32_t y = 0; y <= kSide; ++y)
        for (uint32_t x = 0; x <= kSide; ++x)
            positions.emplace_back(4.0f * float(x) / kSide - 2.0f, 4.0f * float(y) / kSide - 2.0f, -2.5f);
    for (uint32_t y = 0; y < kSide; ++y)
        for (uint32_t x = 0; x < kSide; ++x) {
            const uint32_t at = y * (kSide + 1) + x;
            for (const uint32_t index : {at, at + 1, at + kSide + 2, at, at + kSide + 2, at + kSide + 1})
                indices.push_back(index);
        }
    return Parts().add(meshOf(std::move(positions), std::move(indices))).from(usualCamera());
}

Parts sharedEdges() {
    Random random(31);
    std::vector<Vec3f> corners;
    for (int fan = 0; fan < 8; ++fan) {
        const Vec3f a = randomCorner(random), b = randomCorner(random);
        for (int i = 0; i < 12; ++i)
            for (const Vec3f& corner : {a, b, randomCorner(random)}) corners.push_back(corner);
    }
    return Parts().add(soup(std::move(corners))).from({cameraAt({0, 0.3, 3.5}, 45), cameraAt({2.5, 2, -1}, 45)});
}

Parts slivers() {
    Random random(11);
    std::vector<Vec3f> corners;
    for (int i = 0; i < 60; ++i) {
        const float y = float(random.between(-1, 1)), z = float(random.between(-1, 1));
        for (const Vec3f& corner : {Vec3f(-1, y, z), Vec3f(1, y, -z), Vec3f(0, y + 1e-6f, 0)}) corners.push_back(corner);
    }
    // Flattened by its transform to 1e-9 of its length.
    const Mat4 flattened = turned({0, 0, 1}, 0.3) * scaled({1, 1e-3, 1});
    std::vector<Vec3f> whole;
    for (int i = 0; i < 40; ++i)
        for (int corner = 0; corner < 3; ++corner) whole.push_back(randomCorner(random));
    return Parts()
        .add(soup(std::move(corners)), flattened)
        .add(soup(std::move(whole)))
        .from({cameraAt({0, 0.3, 3.5}, 45), cameraAt({2.5, 2, -1}, 45)});
}

Parts randomTriangles() {
    Random random(8);
    std::vector<Vec3f> corners;
    for (int i = 0; i < 10'000; ++i) {
        const Vec3f middle = randomCorner(random);
        for (int corner = 0; corner < 3; ++corner) corners.push_back(middle + 0.1f * Vec3f(random.direction()));
    }
    return Parts().add(soup(std::move(corners))).from(cameraAt({0, 0.3, 3.5}, 45));
}

}  // namespace cullscope::gallery
