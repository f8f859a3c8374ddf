#include "core/geometry/frustum_batch.h"

#include <cmath>
#include <fstream>
#include <iterator>

#include "core/geometry/random.h"

namespace cullscope::frustum_batch_test {
namespace {

using Exact = long double;

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

template <typename Batch>
std::vector<uint64_t> outsideOf(const Batch& batch, const BatchFrustum& frustum, SimdLevel level) {
    std::vector<uint64_t> outside;
    findOutside(batch, frustum, level, outside);
    return outside;
}

/// What a single object's distances say.
template <typename Object>
Containment byDistances(const BatchFrustum& frustum, const Object& object) {
    bool outside = false, inside = true;
    for (size_t p = 0; p < 6; ++p) {
        const BatchDistances distances = frustum.distances(FrustumPlane(p), object);
        outside = outside || distances.farthestInside < -distances.margin;
        inside = inside && distances.farthestOutside > distances.margin;
    }
    if (outside) return Containment::Outside;
    return inside ? Containment::Inside : Containment::Straddles;
}

bool bit(const std::vector<uint64_t>& words, size_t i) { return (words[i / 64] >> (i % 64) & 1) != 0; }

/// The result for one object, checked to be the same on all levels.
template <typename Batch, typename Object>
Containment verdict(const Object& object, const Frustum& frustum, const Vec3& eye) {
    const Batch batch(std::span(&object, 1));
    const BatchFrustum batchFrustum(frustum, eye);
    const Containment verdict = byDistances(batchFrustum, object);
    for (const SimdLevel level : availableSimdLevels())
        EXPECT_EQ(bit(outsideOf(batch, batchFrustum, level), 0), verdict == Containment::Outside) << simdLevelName(level);
    return verdict;
}

Containment boxVerdict(const Box3& box, const Frustum& frustum, const Vec3& eye = Vec3(0.0)) {
    return verdict<BoxBatch>(box, frustum, eye);
}

Containment sphereVerdict(const Sphere& sphere, const Frustum& frustum, const Vec3& eye = Vec3(0.0)) {
    return verdict<SphereBatch>(sphere, frustum, eye);
}
Frustum standardFrustum() { return makeFrustum({0, 0, -1}, {1, 0, 0}, {0, 1, 0}, 1.0, 1.0, 0.1, 10.0); }

Frustum onePlane(const Plane& plane) {
    Frustum frustum;
    frustum.planes.fill(plane);
    return frustum;
}

double magnitude(Random& random, double low, double high) { return std::pow(10.0, random.between(low, high)); }

Frustum randomFrustum(Random& random) {
    const Vec3 forward = random.direction();
    const Vec3 right = glm::normalize(glm::cross(forward, random.direction()));
    const double field = random.bits() % 4 == 0 ? 179.0 : random.bits() % 4 == 0 ? 0.01 : random.between(20, 120);
    const double tangent = std::tan(Angle::fromDegrees(field).radians() / 2);
    return makeFrustum(forward, right, glm::cross(right, forward), tangent * random.between(0.5, 2), tangent, 0.1,
                       magnitude(random, 0, 6));
}

/// A place in or near the frustum; with `touching`, its p-vertex is about as far from a plane as the margin.
Vec3 randomCentre(Random& random, const Frustum& frustum, const Vec3& eye, double reach, bool touching) {
    const Vec3 centre = random.direction() * frustum.farDistance * std::pow(random.unit(), 2.0) * 1.5;
    if (!touching) return eye + centre;
    const Plane& plane = frustum.planes[random.bits() % 6];
    const double margin = conservativeMargin(glm::length(centre) + reach);
    return eye + centre - plane.normal * (plane.distance(centre) + reach + margin * random.between(-1, 3));
}

Box3 randomBox(Random& random, const Frustum& frustum, const Vec3& eye) {
    const Vec3 half = Vec3(random.unit(), random.unit(), random.unit()) * frustum.farDistance * magnitude(random, -6, -0.5);
    const Plane& plane = frustum.planes[random.bits() % 6];
    const double reach = glm::dot(glm::abs(plane.normal), half);
    const Vec3 centre = randomCentre(random, frustum, eye, reach, random.bits() % 2 == 0);
    return {centre - half, centre + half};
}

Sphere randomSphere(Random& random, const Frustum& frustum, const Vec3& eye) {
    const double radius = random.unit() * frustum.farDistance * magnitude(random, -6, -0.5);
    return {randomCentre(random, frustum, eye, radius, random.bits() % 2 == 0), radius};
}

/// The value, or now and then NaN, an infinity, a huge or a denormal number, or a zero of either sign.
double spoilt(Random& random, double value) {
    constexpr std::array kBreakers{kNaN,     kInfinity, -kInfinity, 1e300,  -1e300, 1e308,
                                   -1.7e308, 5e-324,    -5e-324,    1e-310, 0.0,    -0.0};
    return random.bits() % 40 == 0 ? kBreakers[random.bits() % kBreakers.size()] : value;
}

Vec3 spoilt(Random& random, const Vec3& value) {
    return {spoilt(random, value.x), spoilt(random, value.y), spoilt(random, value.z)};
}

/// Asserts that every level leaves out exactly the objects that their own distances have outside; returns the verdicts.
template <typename Batch, typename Object>
std::vector<Containment> agreedVerdicts(const std::vector<Object>& objects, const BatchFrustum& frustum) {
    std::vector<Containment> verdicts;
    std::vector<uint64_t> outside((objects.size() + 63) / 64, 0);
    for (size_t i = 0; i < objects.size(); ++i) {
        verdicts.push_back(byDistances(frustum, objects[i]));
        if (verdicts[i] == Containment::Outside) outside[i / 64] |= uint64_t{1} << (i % 64);
    }
    const Batch batch(objects);
    for (const SimdLevel level : availableSimdLevels())
        EXPECT_EQ(outsideOf(batch, frustum, level), outside) << simdLevelName(level) << ", " << objects.size() << " objects";
    return verdicts;
}

/// The distances of a box's or sphere's points farthest inside and outside, exact for doubles in practice.
struct ExactDistances {
    Exact inside, outside;
};

ExactDistances exactDistances(const Plane& plane, const Box3& box, const Vec3& eye) {
    ExactDistances sum{Exact(plane.offset), Exact(plane.offset)};
    for (int axis = 0; axis < 3; ++axis) {
        const Exact low = Exact(plane.normal[axis]) * (Exact(box.min[axis]) - Exact(eye[axis]));
        const Exact high = Exact(plane.normal[axis]) * (Exact(box.max[axis]) - Exact(eye[axis]));
        sum.inside += std::max(low, high);
        sum.outside += std::min(low, high);
    }
    return sum;
}

ExactDistances exactDistances(const Plane& plane, const Sphere& sphere, const Vec3& eye) {
    const Exact centre = exactDistances(plane, Box3{sphere.centre, sphere.centre}, eye).inside;
    return {centre + Exact(sphere.radius), centre - Exact(sphere.radius)};
}

Sphere around(const Box3& box) { return {box.centre(), glm::length(box.halfExtent())}; }
Sphere around(const Sphere& sphere) { return sphere; }

/// The least margin of every plane test of the project (visibility/eye_bounds.h, marginFromEye).
double leastMargin(const Sphere& sphere, const Vec3& eye) {
    return conservativeMargin(glm::length(sphere.centre - eye) + sphere.radius) +
           (glm::length(sphere.centre) + glm::length(eye) + sphere.radius) * 0x1p-49;
}

struct Counts {
    int outside = 0, inside = 0;
};

/// Asserts that a result holds exactly with half the margin to spare, and that an object that is outside or inside by four
/// margins is classified so.
template <typename Object>
void expectExact(const Object& object, const Frustum& frustum, const Vec3& eye, Containment verdict, Counts& counts) {
    const bool outside = verdict == Containment::Outside, inside = verdict == Containment::Inside;
    const BatchFrustum batchFrustum(frustum, eye);
    const Exact margin = Exact(leastMargin(around(object), eye));
    Exact least = Exact(kInfinity), leastOuter = Exact(kInfinity);
    for (size_t p = 0; p < 6; ++p) {
        const ExactDistances distances = exactDistances(frustum.planes[p], object, eye);
        least = std::min(least, distances.inside);
        leastOuter = std::min(leastOuter, distances.outside);
        EXPECT_GE(Exact(batchFrustum.distances(FrustumPlane(p), object).margin), margin);
    }
    EXPECT_TRUE(!outside || least < -margin / 2) << "culled at " << double(least / margin) << " margins";
    EXPECT_TRUE(outside || least > -4 * margin) << "kept at " << double(least / margin) << " margins";
    EXPECT_TRUE(!inside || leastOuter > margin / 2) << "inside at " << double(leastOuter / margin) << " margins";
    EXPECT_TRUE(inside || leastOuter < 4 * margin) << "not inside at " << double(leastOuter / margin) << " margins";
    counts.outside += outside ? 1 : 0;
    counts.inside += inside ? 1 : 0;
}

TEST(FrustumBatch, levelsBeginWithTheScalarAndEndWithTheBest) {
    ASSERT_FALSE(availableSimdLevels().empty());
    EXPECT_EQ(availableSimdLevels().front(), SimdLevel::Scalar);
    EXPECT_EQ(availableSimdLevels().back(), bestSimdLevel());
    std::ifstream file("/proc/cpuinfo");
    const std::string flags{std::istreambuf_iterator<char>(file), {}};
    const bool avx512 = flags.find(" avx512f ") != std::string::npos && flags.find(" avx512dq ") != std::string::npos;
    EXPECT_EQ(bestSimdLevel() == SimdLevel::Avx512, avx512);
}

TEST(FrustumBatch, levelsAgreeAndVerdictsHoldExactly) {
    Random random(601);
    Counts boxCounts, sphereCounts;
    for (int round = 0; round < 400; ++round) {
        const Frustum frustum = randomFrustum(random);
        const Vec3 eye = random.direction() * (round % 4 == 0 ? 1e7 : magnitude(random, -3, 5));
        std::vector<Box3> boxes;
        std::vector<Sphere> spheres;
        for (int i = 0; i < 800; ++i) {
            boxes.push_back(randomBox(random, frustum, eye));
            spheres.push_back(randomSphere(random, frustum, eye));
        }
        const auto ofBoxes = agreedVerdicts<BoxBatch>(boxes, BatchFrustum(frustum, eye));
        const auto ofSpheres = agreedVerdicts<SphereBatch>(spheres, BatchFrustum(frustum, eye));
        for (size_t i = 0; i < boxes.size(); ++i) {
            expectExact(boxes[i], frustum, eye, ofBoxes[i], boxCounts);
            expectExact(spheres[i], frustum, eye, ofSpheres[i], sphereCounts);
        }
        ASSERT_FALSE(HasFailure()) << "round " << round;
    }
    for (const Counts& counts : {boxCounts, sphereCounts}) {
        EXPECT_GT(counts.outside, 50'000);
        EXPECT_GT(counts.inside, 5'000);
    }
}

TEST(FrustumBatch, levelsAgreeOnNumbersThatBreakArithmetic) {
    Random random(602);
    for (int round = 0; round < 200; ++round) {
        Frustum frustum = randomFrustum(random);
        const Vec3 near = random.direction() * magnitude(random, -3, 7);
        const Vec3 eye = round % 3 == 0 ? spoilt(random, near) : near;
        std::vector<Box3> boxes;
        std::vector<Sphere> spheres;
        for (int i = 0; i < 500; ++i) {
            const Box3 box = randomBox(random, frustum, near);
            boxes.push_back({spoilt(random, box.min), spoilt(random, box.max)});
            const Sphere sphere = randomSphere(random, frustum, near);
            spheres.push_back({spoilt(random, sphere.centre), spoilt(random, sphere.radius)});
        }
        if (round % 5 == 0) frustum.planes[random.bits() % 6].offset = kNaN;
        agreedVerdicts<BoxBatch>(boxes, BatchFrustum(frustum, eye));
        agreedVerdicts<SphereBatch>(spheres, BatchFrustum(frustum, eye));
        ASSERT_FALSE(HasFailure()) << "round " << round;
    }
}

TEST(FrustumBatch, nothingIsSaidBeyondTheLastObject) {
    Random random(603);
    const Vec3 eye(1, 2, 3);
    for (int size = 0; size <= 200; ++size) {
        const Frustum frustum = randomFrustum(random);
        std::vector<Box3> boxes;
        std::vector<Sphere> spheres;
        for (int i = 0; i < size; ++i) {
            boxes.push_back(randomBox(random, frustum, eye));
            spheres.push_back(randomSphere(random, frustum, eye));
        }
        agreedVerdicts<BoxBatch>(boxes, BatchFrustum(frustum, eye));
        agreedVerdicts<SphereBatch>(spheres, BatchFrustum(frustum, eye));
        ASSERT_EQ(BoxBatch(boxes).wordCount(), (size_t(size) + 63) / 64);
        // All objects outside, so that every early exit is taken.
        const Vec3 behind = eye - frustum.forward * 100.0;
        const std::vector<Box3> all(size_t(size), {behind, behind});
        const auto verdicts = agreedVerdicts<BoxBatch>(all, BatchFrustum(frustum, eye));
        EXPECT_EQ(std::ranges::count(verdicts, Containment::Outside), size);
    }
}

TEST(FrustumBatch, undecidableObjectStraddlesAndItsNeighboursDoNot) {
    const Box3 behind{Vec3(4, 4, 40), Vec3(5, 5, 50)};
    const std::vector<Box3> boxes{{},
                                  behind,
                                  {Vec3(5, 5, 50), Vec3(4, 4, 40)},
                                  {Vec3(kNaN, 4, 40), Vec3(5, 5, 50)},
                                  {Vec3(4, 4, 40), Vec3(5, kNaN, 50)},
                                  {Vec3(4, 4, 40), Vec3(5, 5, kInfinity)},
                                  {Vec3(-kInfinity, 4, 40), Vec3(5, 5, 50)},
                                  {Vec3(4, 4, 1e302), Vec3(5, 5, 1e305)},
                                  behind};
    std::vector<Containment> onlyBehind(boxes.size(), Containment::Straddles);
    onlyBehind[1] = onlyBehind[8] = Containment::Outside;
    EXPECT_EQ(agreedVerdicts<BoxBatch>(boxes, BatchFrustum(standardFrustum(), Vec3(0.0))), onlyBehind);

    const std::vector<Sphere> spheres{{Vec3(0, 0, 50), -1.0},       {Vec3(0, 0, 50), 1.0},  {Vec3(kNaN, 0, 50), 1.0},
                                      {Vec3(0, 0, kInfinity), 1.0}, {Vec3(0, 0, 50), kNaN}, {Vec3(0, 0, 50), kInfinity}};
    std::vector<Containment> onlySecond(spheres.size(), Containment::Straddles);
    onlySecond[1] = Containment::Outside;
    EXPECT_EQ(agreedVerdicts<SphereBatch>(spheres, BatchFrustum(standardFrustum(), Vec3(0.0))), onlySecond);

    for (const Vec3& eye : {Vec3(0, kNaN, 0), Vec3(0, 0, -kInfinity), Vec3(1e307, 0, 0)})
        EXPECT_EQ(boxVerdict(behind, standardFrustum(), eye), Containment::Straddles);
}

TEST(FrustumBatch, sizesAtTheEndsOfDoubleAreJudgedRight) {
    const auto cube = [](double z, double half) { return Box3{Vec3(-half, -half, z - half), Vec3(half, half, z + half)}; };
    for (const double size : {1e-320, 1e-300, 1e-18, 1e18, 1e290, 1e300}) {
        const Frustum frustum = makeFrustum({0, 0, -1}, {1, 0, 0}, {0, 1, 0}, 1.0, 1.0, 1e-323, 1e308);
        EXPECT_EQ(boxVerdict(cube(-4 * size, size), frustum), Containment::Inside) << size;
        EXPECT_EQ(sphereVerdict({Vec3(0, 0, -4 * size), size}, frustum), Containment::Inside) << size;
        EXPECT_EQ(boxVerdict(cube(4 * size, size), frustum), Containment::Outside) << size;
        EXPECT_EQ(sphereVerdict({Vec3(0, 0, 4 * size), size}, frustum), Containment::Outside) << size;
        EXPECT_EQ(boxVerdict(cube(0, size), frustum), Containment::Straddles) << size;
    }
}

TEST(FrustumBatch, case3BoxThatOnlyItsExtentLengthKeepsIsOutside) {
    const Frustum below = onePlane({{0, -1, 0}, 0.0});
    const Box3 flat{Vec3(-60, 9, -1), Vec3(60, 11, 1)};
    EXPECT_EQ(BatchFrustum(below, Vec3(0.0)).distances(FrustumPlane::Near, flat).farthestInside, -9.0);
    EXPECT_EQ(boxVerdict(flat, below), Containment::Outside);
}

TEST(FrustumBatch, case4SphereFarFromTheOriginIsKept) {
    const Vec3 on(1e7 + 5.5, 0, -1e7 + 6.5), normal(.6, 0, -.8);
    const Sphere sphere{{1e7 + 8.5, 0, -1e7 + 7.5}, 1.0};
    // Seen from nearby, and from the world's origin. The centre lies 1 inside; in float it would lie 2 outside, with the sphere.
    for (const Vec3& eye : {on, on + Vec3(3, 4, 5), Vec3(0.0)}) {
        const Frustum frustum = onePlane({normal, glm::dot(normal, eye - on)});
        const BatchDistances distances = BatchFrustum(frustum, eye).distances(FrustumPlane::Left, sphere);
        EXPECT_NEAR(distances.farthestInside, 2.0, 2e-8);
        EXPECT_NEAR(distances.farthestOutside, 0.0, 2e-8);
        EXPECT_NE(sphereVerdict(sphere, frustum, eye), Containment::Outside);
    }
    const Sphere beyond{sphere.centre - normal * 2.01, 1.0};
    EXPECT_EQ(sphereVerdict(beyond, onePlane({normal, 0.0}), on), Containment::Outside)
        << "the margin hides a sphere that is outside";
}

TEST(FrustumBatch, case22BoxAroundTheCameraOrBeyondFarStraddles) {
    EXPECT_EQ(boxVerdict({Vec3(0.0), Vec3(0.0)}, onePlane({{0, 0, -1}, 0.0})), Containment::Straddles) << "neither: margin 0";
    for (const Vec3& eye : {Vec3(0.0), Vec3(1e7, -1e7, 1e7)}) {
        EXPECT_EQ(boxVerdict({eye + Vec3(-1, -1, -3), eye + Vec3(1, 1, 3)}, standardFrustum(), eye), Containment::Straddles);
        EXPECT_EQ(boxVerdict({eye - Vec3(1000), eye + Vec3(1000)}, standardFrustum(), eye), Containment::Straddles);
        EXPECT_EQ(sphereVerdict({eye, 1000.0}, standardFrustum(), eye), Containment::Straddles);
    }
}

TEST(FrustumBatch, case23ExtremeFieldsAndSizesAreJudgedRight) {
    for (const double fovy : {0.01, 179.0})
        for (const double aspect : {1.0 / 16384, 1.0, 16384.0}) {
            const double y = std::tan(Angle::fromDegrees(fovy).radians() / 2), x = y * aspect;
            const Frustum frustum = makeFrustum({0, 0, -1}, {1, 0, 0}, {0, 1, 0}, x, y, 1e-6, 1e9);
            for (const double depth : {1e-3, 1.0, 1e6}) {
                const Vec3 room(1e-4 * depth * x, 1e-4 * depth * y, 1e-4 * depth);
                const auto at = [&](const Vec3& centre) { return Box3{depth * centre - room, depth * centre + room}; };
                EXPECT_NE(boxVerdict(at({0.5 * x, 0.5 * y, -1}), frustum), Containment::Outside) << fovy << "° " << aspect;
                EXPECT_EQ(boxVerdict(at({0.5 * x, 0.5 * y, 1}), frustum), Containment::Outside) << fovy << "° " << aspect;
                const Sphere behind{depth * Vec3(0, 0, 1), 1e-4 * depth * std::min(1.0, std::min(x, y))};
                EXPECT_EQ(sphereVerdict(behind, frustum), Containment::Outside) << fovy << "° " << aspect;
                EXPECT_NE(sphereVerdict({-behind.centre, behind.radius}, frustum), Containment::Outside)
                    << fovy << "° " << aspect;
            }
        }
}

}  // namespace
}  // namespace cullscope::frustum_batch_test
