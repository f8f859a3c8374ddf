#include "core/experiments/certify/random_scenes.h"

#include "core/mesh/parametric.h"
#include "core/scene/gallery/gallery_parts.h"

namespace cullscope::certify {
namespace {

double logBetween(Random& random, double low, double high) { return std::exp(random.between(std::log(low), std::log(high))); }

Mat3 randomRotation(Random& random) {
    const Vec3 first = random.direction();
    const Vec3 second = glm::normalize(glm::cross(first, random.direction()));
    return {first, second, glm::cross(first, second)};
}

Mat4 randomPlace(Random& random, double spread, const Vec3& offset) {
    Vec3 stretch(logBetween(random, 0.01, 3.0));
    const double kind = random.unit();
    if (kind < 0.2)
        stretch[int(random.bits() % 3)] *= -1.0;
    else if (kind < 0.4)
        stretch[int(random.bits() % 3)] *= logBetween(random, 1e-6, 1e-1);
    else if (kind < 0.5)
        stretch *= Vec3(logBetween(random, 0.1, 10), -logBetween(random, 0.1, 10), 1.0);
    Mat4 place(randomRotation(random) * Mat3(gallery::scaled(stretch)));
    // Sheared now and then, because any affine transform is supported.
    if (random.unit() < 0.1) place[0] += 0.7 * place[1];
    place[3] = Vec4(random.direction() * (spread * random.unit()) + offset, 1.0);
    return place;
}

/// The same mesh with its float coordinates relative to another origin.
MeshPointer withOrigin(const TriangleMesh& mesh, const Vec3& origin) {
    TriangleMesh::Data data;
    data.name = mesh.name();
    data.origin = origin;
    data.positions.assign(mesh.positions().begin(), mesh.positions().end());
    data.normals.assign(mesh.normals().begin(), mesh.normals().end());
    data.indices.assign(mesh.indices().begin(), mesh.indices().end());
    return std::make_shared<TriangleMesh>(std::move(data));
}

/// A box with its float coordinates relative to another origin.
MeshPointer boxAbout(const Vec3& centre, const Vec3& half, const Vec3& origin) {
    const Vec3 min(Vec3f(centre - half)), max(Vec3f(centre + half));
    return withOrigin(*gallery::box(min, max), origin);
}

ScenePointer sceneOf(std::vector<MeshPointer> meshes, const std::vector<Mat4>& places) {
    std::vector<Instance> instances;
    for (uint32_t i = 0; i < meshes.size(); ++i) instances.push_back({i, places[i], "box " + std::to_string(i)});
    return std::make_shared<Scene>("boxes", std::move(meshes), std::move(instances));
}

const std::vector<MeshPointer>& shapes() {
    static const std::vector<MeshPointer> kShapes{sphereMesh(80), torusMesh(120), knotMesh(160), starMesh(7, 180)};
    return kShapes;
}

Vec3 randomOffset(Random& random) {
    const double kind = random.unit();
    if (kind < 0.3) return Vec3(0.0);
    if (kind < 0.5) return {1e7, -1e7, 1e7};
    return random.direction() * logBetween(random, 1.0, 1e7);
}

ScenePointer shapesScene(Random& random, const Vec3& byTransform, const Vec3& byOrigin) {
    std::vector<MeshPointer> meshes;
    for (const MeshPointer& shape : shapes()) meshes.push_back(byOrigin == Vec3(0.0) ? shape : withOrigin(*shape, byOrigin));
    std::vector<Instance> instances;
    for (uint32_t i = 0; i < 24; ++i) {
        Mat4 place = randomPlace(random, 20.0, byTransform);
        // A mesh whose origin is far away is rotated and scaled about that origin, not about the world's.
        place[3] -= Vec4(Mat3(place) * byOrigin - byOrigin, 0.0);
        instances.push_back({i % 4, place, "shape " + std::to_string(i)});
    }
    return std::make_shared<Scene>("shapes", std::move(meshes), std::move(instances));
}

ScenePointer boxesScene(Random& random, const Vec3& byTransform, const Vec3& byOrigin) {
    std::vector<MeshPointer> meshes;
    std::vector<Mat4> places;
    for (int i = 0; i < 60; ++i) {
        const Vec3 centre = random.direction() * (15.0 * random.unit());
        const Vec3 half(logBetween(random, 1e-5, 2.0), logBetween(random, 1e-5, 2.0), logBetween(random, 1e-5, 2.0));
        meshes.push_back(boxAbout(centre, half, byOrigin));
        places.push_back(gallery::moved(byTransform));
    }
    return sceneOf(std::move(meshes), places);
}

/// An orthonormal basis and half the size of the view: what it grows with each unit of distance, and of a parallel view what it
/// is everywhere.
struct Lens {
    Vec3 forward, right, up;
    double tanHalfWidth = 0.0, tanHalfHeight = 0.0, halfWidth = 0.0, halfHeight = 0.0;
    double nearDistance, farDistance;
};

/// A point on a plane of the view (anywhere in it for plane 6), relative to the eye, between near and far.
Vec3 pointOnPlane(const Lens& lens, size_t plane, Random& random) {
    // Depths common in scenes are preferred to the 15 powers of ten between near and far.
    const double low = std::clamp(0.01, lens.nearDistance, lens.farDistance);
    const double high = std::clamp(100.0, lens.nearDistance, lens.farDistance);
    double depth = random.unit() < 0.7 ? logBetween(random, low, high) : logBetween(random, lens.nearDistance, lens.farDistance);
    double x = random.between(-1.0, 1.0);
    double y = random.between(-1.0, 1.0);
    if (plane < 2)
        x = plane == 0 ? -1.0 : 1.0;
    else if (plane < 4)
        y = plane == 2 ? -1.0 : 1.0;
    else if (plane == 4)
        depth = lens.nearDistance;
    else if (plane == 5)
        depth = lens.farDistance;
    return depth * lens.forward + lens.right * (x * (lens.halfWidth + depth * lens.tanHalfWidth)) +
           lens.up * (y * (lens.halfHeight + depth * lens.tanHalfHeight));
}

Vec3 normalOf(const Lens& lens, size_t plane) {
    switch (plane) {
        case 0:
            return glm::normalize(lens.forward * lens.tanHalfWidth + lens.right);
        case 1:
            return glm::normalize(lens.forward * lens.tanHalfWidth - lens.right);
        case 2:
            return glm::normalize(lens.forward * lens.tanHalfHeight + lens.up);
        case 3:
            return glm::normalize(lens.forward * lens.tanHalfHeight - lens.up);
        case 4:
            return lens.forward;
        default:
            return -lens.forward;
    }
}

/// A vertex of an object in world coordinates: the farthest inside a plane, the farthest outside, or any.
Vec3 chosenVertex(const Scene& scene, size_t instance, const Vec3& normal, Random& random) {
    const TriangleMesh& mesh = scene.meshOf(instance);
    const Mat4& place = scene.instances()[instance].worldFromMesh;
    const auto world = [&](size_t v) { return Vec3(place * Vec4(mesh.position(v), 1.0)); };
    const double kind = random.unit();
    if (kind < 0.3) return world(random.bits() % mesh.vertexCount());
    const Vec3 away = kind < 0.75 ? normal : -normal;
    size_t best = 0;
    for (size_t v = 1; v < mesh.vertexCount(); ++v)
        if (glm::dot(world(v) - world(0), away) > glm::dot(world(best) - world(0), away)) best = v;
    return world(best);
}

Viewport randomSize(Random& random, Sizes sizes) {
    const double kind = random.unit();
    if (sizes == Sizes::UpTo1025) {
        if (kind < 0.05) return {1, 1};
        if (kind < 0.1) return {1025, 1};
        if (kind < 0.15) return {1, 1025};
        // Small pictures are drawn soon, so that there are many of them.
        const auto side = [&] { return int(std::min(1025.0, logBetween(random, 1.0, 1026.0))); };
        const int width = side(), height = side();
        return {width, height};
    }
    if (kind < 0.1) return {1, 1};
    if (kind < 0.2) return {16384, 1};
    if (kind < 0.25) return {1, 16384};
    if (kind < 0.6) return {640, 480};
    return {1 + int(random.bits() % 4096), 1 + int(random.bits() % 4096)};
}

Angle randomField(Random& random) {
    const double kind = random.unit();
    if (kind < 0.1) return Angle::fromDegrees(0.01);
    if (kind < 0.2) return Angle::fromDegrees(179.0);
    if (kind < 0.4) return Angle::fromDegrees(logBetween(random, 0.01, 179.0));
    return Angle::fromDegrees(random.between(10.0, 120.0));
}

/// The height of a parallel view: mostly one in which objects of these scenes are more than a point.
double randomHeight(Random& random) {
    return random.unit() < 0.7 ? logBetween(random, 0.01, 100.0) : logBetween(random, 1e-6, 1e9);
}

}  // namespace

ScenePointer randomScene(uint64_t seed) {
    Random random(seed);
    const Vec3 offset = randomOffset(random);
    const bool byTransform = random.unit() < 0.5;
    const bool boxes = random.unit() < 0.5;
    return (boxes ? boxesScene : shapesScene)(random, byTransform ? offset : Vec3(0.0), byTransform ? Vec3(0.0) : offset);
}

RandomView randomView(const Scene& scene, Random& random, Sizes sizes, double parallelShare) {
    RandomView view;
    view.viewport = randomSize(random, sizes);
    Camera& camera = view.camera;
    camera.fovy = randomField(random);
    const double one = logBetween(random, 1e-6, 1e9);
    const double other = random.unit() < 0.5 ? logBetween(random, 1e-6, 1e9) : logBetween(random, 1.0, 100.0);
    camera.nearDistance = std::min(one, other);
    camera.farDistance = std::max(std::max(one, other), camera.nearDistance * 1.001);
    const Vec3 forward = random.direction();
    // Now and then nearly parallel to the view direction; any closer, the basis would depend on rounding.
    camera.up = random.unit() < 0.1 ? forward + random.direction() * logBetween(random, 1e-3, 1.0) : random.direction();
    if (glm::length(glm::cross(forward, camera.up)) < 1e-4)
        camera.up = glm::cross(forward, Vec3(forward.y, forward.z, -forward.x));

    Lens lens{.forward = forward,
              .right = glm::normalize(glm::cross(forward, camera.up)),
              .up = {},
              .nearDistance = camera.nearDistance,
              .farDistance = camera.farDistance};
    lens.up = glm::cross(lens.right, forward);
    const double shape = double(view.viewport.width) / view.viewport.height;
    if (parallelShare > 0.0 && random.unit() < parallelShare) {
        camera.projection = ProjectionKind::Parallel;
        camera.height = randomHeight(random);
        lens.halfHeight = camera.height / 2;
        lens.halfWidth = lens.halfHeight * shape;
    } else {
        lens.tanHalfHeight = std::tan(camera.fovy.radians() / 2);
        lens.tanHalfWidth = lens.tanHalfHeight * shape;
    }

    const size_t instance = random.bits() % scene.instances().size();
    const double kind = random.unit();
    if (kind < 0.08) {
        // The eye inside an object, or exactly at a vertex.
        camera.eye = random.unit() < 0.5 ? scene.instanceBox(instance).centre() : chosenVertex(scene, instance, forward, random);
    } else if (kind < 0.2) {
        camera.eye = scene.bounds().centre() + random.direction() * (0.7 * scene.bounds().diagonal() * random.unit());
    } else {
        // Near planes more often, because they have no tolerance of half a pixel.
        const size_t plane = random.unit() < 0.25 ? 4 : random.bits() % 7;
        const Vec3 point = pointOnPlane(lens, plane, random);
        const double shift = logBetween(random, 1e-12, 1e-3) * (random.unit() < 0.5 ? -1.0 : 1.0);
        const Vec3 normal = normalOf(lens, plane);
        camera.eye = chosenVertex(scene, instance, normal, random) - point - normal * (shift * glm::length(point));
    }
    camera.target = camera.eye + forward * logBetween(random, std::max(1.0, 1e-3 * glm::length(camera.eye)), 1e9);
    return view;
}

}  // namespace cullscope::certify
