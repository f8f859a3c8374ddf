#include "tests/benchmark/frustum_objects.h"

#include <cmath>
#include <type_traits>

#include "core/geometry/random.h"

namespace cullscope::benchmark {
namespace {

constexpr double kFar = 100.0;
/// Half the edge of the cube around the eye in which objects outside the frustum lie.
constexpr double kRoom = 1.5 * kFar;
constexpr double kSmallest = 0.1, kLargest = 0.5;

Vec3 inCube(Random& random, double half) {
    return {random.between(-half, half), random.between(-half, half), random.between(-half, half)};
}

Vec3 inFrustum(Random& random, const Frustum& frustum) {
    const double depth = frustum.farDistance * std::cbrt(random.unit());
    return frustum.forward * depth + frustum.right * (depth * frustum.tanHalfWidth * random.between(-1, 1)) +
           frustum.up * (depth * frustum.tanHalfHeight * random.between(-1, 1));
}

Vec3 smallHalf(Random& random) {
    return {random.between(kSmallest, kLargest), random.between(kSmallest, kLargest), random.between(kSmallest, kLargest)};
}

template <typename Object>
Object smallObject(Random& random, const Vec3& centre) {
    if constexpr (std::is_same_v<Object, EyeBox>)
        return {centre, smallHalf(random)};
    else
        return {centre, random.between(kSmallest, kLargest)};
}

/// Relative to the eye; at every choice the number taken is in proportion to those still needed among those still to come.
template <typename Object>
std::vector<Object> scattered(const Frustum& frustum, size_t count, double share) {
    Random random(count);
    auto wanted = size_t(std::llround(double(count) * share));
    std::vector<Object> objects;
    objects.reserve(count);
    while (objects.size() < count) {
        const bool visible = random.unit() * double(count - objects.size()) < double(wanted);
        Object object;
        do object = smallObject<Object>(random, visible ? inFrustum(random, frustum) : inCube(random, kRoom));
        while ((classify(frustum, object) != Containment::Outside) != visible);
        if (visible) --wanted;
        objects.push_back(object);
    }
    return objects;
}

template <typename Objects, typename IsOutside>
void testEach(const Objects& objects, const NaivePlanes& planes, std::vector<uint8_t>& outside, const IsOutside& isOutside) {
    for (size_t i = 0; i < objects.size(); ++i) {
        bool rejected = false;
        for (const NaivePlane& plane : planes)
            if (isOutside(objects[i], plane)) {
                rejected = true;
                break;
            }
        outside[i] = rejected ? 1 : 0;
    }
}

}  // namespace

View frustumView() {
    Camera camera;
    camera.eye = {12, 3, -7};
    camera.target = {12, 3, -8};
    camera.fovy = Angle::fromDegrees(60);
    camera.nearDistance = 0.1;
    camera.farDistance = kFar;
    return {camera, {640, 480}};
}

std::vector<Box3> scatteredBoxes(const View& view, size_t count, double share) {
    std::vector<Box3> boxes;
    boxes.reserve(count);
    for (const EyeBox& box : scattered<EyeBox>(view.frustum(), count, share))
        boxes.push_back({view.eye() + box.centre - box.halfExtent, view.eye() + box.centre + box.halfExtent});
    return boxes;
}

std::vector<Sphere> scatteredSpheres(const View& view, size_t count, double share) {
    std::vector<Sphere> spheres = scattered<Sphere>(view.frustum(), count, share);
    for (Sphere& sphere : spheres) sphere.centre += view.eye();
    return spheres;
}

std::vector<Box3> evenBoxes(const View& view, size_t count) {
    const Frustum& frustum = view.frustum();
    const double volume = 4.0 / 3.0 * frustum.tanHalfWidth * frustum.tanHalfHeight * std::pow(frustum.farDistance, 3.0);
    const double edge = std::cbrt(volume * double(count) / kConstantVisible);
    Random random(count);
    std::vector<Box3> boxes;
    boxes.reserve(count);
    for (size_t i = 0; i < count; ++i) {
        const Vec3 centre = view.eye() + inCube(random, edge / 2), half = smallHalf(random);
        boxes.push_back({centre - half, centre + half});
    }
    return boxes;
}

NaivePlanes naivePlanes(const View& view) {
    NaivePlanes planes;
    for (size_t p = 0; p < planes.size(); ++p) {
        const Plane& plane = view.frustum().planes[p];
        planes[p] = {plane.normal, glm::abs(plane.normal), plane.offset - glm::dot(plane.normal, view.eye())};
    }
    return planes;
}

std::vector<NaiveBox> naiveObjects(const std::vector<Box3>& boxes) {
    std::vector<NaiveBox> objects;
    objects.reserve(boxes.size());
    for (const Box3& box : boxes) objects.push_back({box.centre(), box.halfExtent()});
    return objects;
}

std::vector<NaiveSphere> naiveObjects(const std::vector<Sphere>& spheres) {
    std::vector<NaiveSphere> objects;
    objects.reserve(spheres.size());
    for (const Sphere& sphere : spheres) objects.push_back({sphere.centre, sphere.radius});
    return objects;
}

void testNaively(const std::vector<NaiveBox>& boxes, const NaivePlanes& planes, std::vector<uint8_t>& outside) {
    testEach(boxes, planes, outside, [](const NaiveBox& box, const NaivePlane& plane) {
        return glm::dot(plane.normal, box.centre) + plane.offset + glm::dot(plane.absNormal, box.halfExtent) < 0.0;
    });
}

void testNaively(const std::vector<NaiveSphere>& spheres, const NaivePlanes& planes, std::vector<uint8_t>& outside) {
    testEach(spheres, planes, outside, [](const NaiveSphere& sphere, const NaivePlane& plane) {
        return glm::dot(plane.normal, sphere.centre) + plane.offset + sphere.radius < 0.0;
    });
}

#ifdef __x86_64__
[[gnu::target_clones("avx512f", "avx2", "default")]]
#endif
double
sumOf(const double* blocks, size_t doubles) {
    using Wide = double __attribute__((vector_size(64), may_alias));
    constexpr size_t kWide = 8, kSums = 4;
    const auto* wide = reinterpret_cast<const Wide*>(blocks);
    Wide a{}, b{}, c{}, d{};
    size_t i = 0;
    for (; i + kSums <= doubles / kWide; i += kSums) {
        a += wide[i];
        b += wide[i + 1];
        c += wide[i + 2];
        d += wide[i + 3];
    }
    for (; i < doubles / kWide; ++i) a += wide[i];
    a += b + (c + d);
    double sum = 0.0;
    for (size_t lane = 0; lane < kWide; ++lane) sum += a[lane];
    return sum;
}

}  // namespace cullscope::benchmark
