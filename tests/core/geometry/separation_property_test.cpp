#include <cmath>
#include <cstdio>

#include "core/geometry/random.h"
#include "core/geometry/separation.h"
#include "tests/support/exact_frustum.h"
#include "tests/support/long_mode.h"

namespace cullscope::test::separation_property_test {
namespace {

double powerOfTen(Random& random, double low, double high) { return std::pow(10.0, random.between(low, high)); }

Frustum randomFrustum(Random& random) {
    const Vec3 forward = random.direction();
    const Vec3 right = glm::normalize(glm::cross(forward, random.direction()));
    const bool mild = random.unit() < 0.5;
    const double tall =
        mild ? random.between(0.2, 1.5) : std::tan(Angle::fromDegrees(powerOfTen(random, -2, 2.252)).radians() / 2);
    const double aspect = mild ? random.between(0.5, 2) : std::pow(2.0, random.between(-14, 14));
    const double nearDistance = mild ? powerOfTen(random, -2, 1) : powerOfTen(random, -6, 6);
    const double farDistance = mild ? nearDistance * powerOfTen(random, 0.1, 2) : nearDistance + powerOfTen(random, -6, 9);
    return makeFrustum(forward, right, glm::cross(right, forward), tall * aspect, tall, nearDistance, farDistance);
}

/// By how much the near and far planes of a parallel view lie farther out than its distances, by which the exact tests go.
double roomOf(const Frustum& frustum) { return frustum.parallel() ? 1.001 * depthRoom(frustum.farDistance) : 0.0; }

Frustum randomParallelFrustum(Random& random) {
    const Frustum lens = randomFrustum(random);
    const double size = std::sqrt(lens.nearDistance * lens.farDistance) * powerOfTen(random, -2, 2);
    return makeParallelFrustum(lens.forward, lens.right, lens.up, size * random.between(0.5, 2), size, lens.nearDistance,
                               lens.farDistance);
}

/// Every fourth view is a parallel one.
Frustum randomVolume(uint64_t seed, Random& random) {
    return seed % 4 == 0 ? randomParallelFrustum(random) : randomFrustum(random);
}

/// A point of the frustum's surface, mostly on an edge or corner, and a direction in which the frustum does not extend beyond it.
struct Contact {
    Vec3 point, outward;
};

Contact randomContact(const Frustum& frustum, Random& random) {
    const double low = frustum.nearDistance, high = frustum.farDistance;
    const double depths[4] = {low, high, random.between(low, high), std::exp(random.between(std::log(low), std::log(high)))};
    const uint64_t kind = random.bits() % 4;
    const double depth = std::clamp(depths[kind], low, high);
    double x = random.between(-1, 1), y = random.between(-1, 1);
    Contact contact{};
    const auto side = [&](double& coordinate, size_t negative, size_t positive) {
        if (random.unit() > 0.6) return;
        coordinate = coordinate < 0.0 ? -1.0 : 1.0;
        contact.outward -= frustum.planes[coordinate < 0.0 ? negative : positive].normal * (random.unit() + 1e-3);
    };
    side(x, 0, 1);
    side(y, 2, 3);
    if (kind < 2) contact.outward -= frustum.planes[4 + kind].normal * (random.unit() + 1e-3);
    contact.point =
        depth * frustum.forward + x * frustum.halfWidthAt(depth) * frustum.right + y * frustum.halfHeightAt(depth) * frustum.up;
    if (contact.outward != Vec3(0.0)) contact.outward = glm::normalize(contact.outward);
    return contact;
}

/// A place where edges, corners and faces meet, because plane tests err there: loosely, or touching to within 1e-17 … 1e-3.
Vec3 placeOf(const std::array<Vec3, 3>& halves, const Frustum& frustum, Random& random) {
    const Contact contact = randomContact(frustum, random);
    double size = 0.0;
    Vec3 toCentre(0.0);
    for (const Vec3& half : halves) {
        size += glm::length(half);
        toCentre += half * (glm::dot(half, contact.outward) < 0.0 ? -1.0 : 1.0);
    }
    if (random.unit() < 0.4) return contact.point + random.direction() * (size * random.between(0, 2.5));
    const double shift = powerOfTen(random, -17, -3) * (random.unit() < 0.5 ? -1.0 : 1.0);
    return contact.point + toCentre + contact.outward * (shift * (glm::length(contact.point) + size));
}

Vec3 randomHalf(double size, Random& random) {
    Vec3 half = size * glm::abs(random.direction());
    if (random.unit() < 0.3) half[int(random.bits() % 3)] *= random.unit() < 0.3 ? 0.0 : powerOfTen(random, -9, 0);
    return half;
}

double randomSize(const Frustum& frustum, Random& random) {
    return random.unit() < 0.2 ? powerOfTen(random, -9, 9)
                               : powerOfTen(random, -2, 2) * (random.unit() < 0.5 ? frustum.nearDistance : frustum.farDistance);
}

/// A box and the unit directions of its edges, which are known even where it is flat.
struct SampleBox {
    OrientedBox box;
    std::array<Vec3, 3> directions;

    /// The box grown so that each face lies at least `by` farther out: 3 / det bounds the loss by a shear.
    [[nodiscard]] QuadBox exact(double by = 0.0) const {
        const double sheared = std::abs(glm::dot(glm::cross(directions[0], directions[1]), directions[2]));
        const Quad outward = sheared > 1.0 - 1e-9 ? by * (1 + 1e-8) : 3 * by / sheared;
        QuadBox result{quad(box.centre), {}};
        for (size_t i = 0; i < 3; ++i) result.halves[i] = plus(quad(box.axes[i]), scaled(quad(directions[i]), outward));
        return result;
    }
    [[nodiscard]] bool flat() const {
        return std::ranges::any_of(box.axes, [](const Vec3& axis) { return axis == Vec3(0.0); });
    }
};

struct PairTally {
    uint64_t pairs = 0, apart = 0, byPlanes = 0, refined = 0;
    uint64_t withinMargin = 0;  ///< separate, but by no more than the margin: kept

    void print(const char* what) const {
        std::printf("long: separation %s pairs %llu apart %llu by-planes %llu refined %llu apart-within-margin %llu\n", what,
                    static_cast<unsigned long long>(pairs), static_cast<unsigned long long>(apart),
                    static_cast<unsigned long long>(byPlanes), static_cast<unsigned long long>(refined),
                    static_cast<unsigned long long>(withinMargin));
    }
};

uint64_t pairsToTest() { return howMany(1'000'000, 60'000); }

/// Both directions for one pair, with a margin and without: objects that touch are never reported as separate, and objects that
/// are apart by more than margin and rounding always are.
template <typename Box>
void checkBox(const Frustum& frustum, const Box& box, const SampleBox& same, PairTally& tally, uint64_t seed) {
    const ExactFrustum exact(frustum);
    const double margin = conservativeMargin(same.box.farthest());
    const bool meets = exact.meets(same.exact());
    const bool byPlanes = classify(frustum, box) == Containment::Outside;
    const bool refined = separated(frustum, box, margin);
    ++tally.pairs;
    tally.apart += meets ? 0 : 1;
    tally.byPlanes += byPlanes ? 1 : 0;
    tally.refined += !byPlanes && refined ? 1 : 0;
    EXPECT_FALSE(meets && byPlanes) << "planes cull what is visible: " << seed;
    EXPECT_FALSE(meets && refined) << "refinement culls what is visible: " << seed;
    EXPECT_FALSE(meets && separated(frustum, box, 0.0)) << "without margin the test's own rounding shows: " << seed;
    // A flat box without a normal is separated by the axes of its edges only, which are inexact: not checked to the last digits
    // of the margin.
    if (meets || refined || byPlanes || same.flat()) return;
    ++tally.withinMargin;
    const double room = roomOf(frustum);
    EXPECT_TRUE(exact.meets(same.exact(1.001 * margin + room))) << "apart by more than the margin, and not seen: " << seed;
}

void expectAllKinds(const PairTally& tally) {
    EXPECT_GT(tally.refined, tally.pairs / 50);
    EXPECT_GT(tally.apart, tally.pairs / 4);
    EXPECT_LT(tally.apart, tally.pairs * 3 / 4);
}

/// A box in a random frame: rotated, sheared, mirrored or flat.
SampleBox randomBox(const Frustum& frustum, const Vec3& half, Random& random) {
    const Vec3 first = random.direction(), second = glm::normalize(glm::cross(first, random.direction()));
    SampleBox sample{{}, {first, second, glm::cross(first, second)}};
    for (size_t i = 0; i < 3; ++i) sample.box.axes[i] = sample.directions[i] * half[int(i)];
    if (random.unit() < 0.3 && half.x > 0.0) {
        sample.box.axes[0] += 0.7 * half.x * sample.directions[1];
        sample.directions[0] = glm::normalize(sample.box.axes[0]);
    }
    if (random.unit() < 0.3) {
        sample.box.axes[2] *= -1.0;
        sample.directions[2] *= -1.0;
    }
    sample.box.centre = placeOf(sample.box.axes, frustum, random);
    return sample;
}

EyeBox randomEyeBox(const Frustum& frustum, double size, Random& random) {
    const Vec3 half = randomHalf(size, random);
    return {placeOf({Vec3(half.x, 0, 0), Vec3(0, half.y, 0), Vec3(0, 0, half.z)}, frustum, random), half};
}

TEST(SeparationProperty, boxIsPartedExactlyWhereItLiesApart) {
    PairTally tally;
    for (uint64_t seed = 1; seed <= pairsToTest() && !testing::Test::HasFailure(); ++seed) {
        Random random(seed);
        const Frustum frustum = randomVolume(seed, random);
        const double size = randomSize(frustum, random);
        const EyeBox some = randomEyeBox(frustum, size, random);
        const std::array<Vec3, 3> axes{Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1)};
        checkBox(
            frustum, some,
            {{some.centre, {some.halfExtent.x * axes[0], some.halfExtent.y * axes[1], some.halfExtent.z * axes[2]}, 0.0}, axes},
            tally, seed);
    }
    tally.print("boxes");
    expectAllKinds(tally);
}

TEST(SeparationProperty, orientedBoxIsPartedExactlyWhereItLiesApart) {
    PairTally tally;
    for (uint64_t seed = 1; seed <= pairsToTest() && !testing::Test::HasFailure(); ++seed) {
        Random random(seed + 0x100000000);
        const Frustum frustum = randomVolume(seed, random);
        const double size = randomSize(frustum, random);
        const SampleBox some = randomBox(frustum, randomHalf(size, random), random);
        checkBox(frustum, some.box, some, tally, seed);
    }
    tally.print("oriented");
    expectAllKinds(tally);
}

TEST(SeparationProperty, sphereIsPartedExactlyWhereItLiesApart) {
    PairTally tally;
    for (uint64_t seed = 1; seed <= pairsToTest() && !testing::Test::HasFailure(); ++seed) {
        Random random(seed + 0x200000000);
        const Frustum frustum = randomVolume(seed, random);
        const double size = randomSize(frustum, random);
        Sphere sphere{placeOf({Vec3(size), Vec3(0.0), Vec3(0.0)}, frustum, random), size};
        const ExactFrustum exact(frustum);
        const Quad distance = exact.distance(quad(sphere.centre));
        // Now and then the sphere touches to the last digits, from inside or outside.
        if (random.unit() < 0.5) sphere.radius = double(distance) * (1.0 + random.between(-1, 1) * powerOfTen(random, -16, -1));
        const double magnitude = glm::length(sphere.centre) + sphere.radius;
        const double margin = conservativeMargin(magnitude);
        const bool byPlanes = classify(frustum, sphere) == Containment::Outside;
        const bool refined = separated(frustum, sphere, margin);
        const bool meets = distance <= sphere.radius;
        ++tally.pairs;
        tally.apart += meets ? 0 : 1;
        tally.byPlanes += byPlanes ? 1 : 0;
        tally.refined += refined && !byPlanes ? 1 : 0;
        EXPECT_FALSE(meets && byPlanes) << seed;
        EXPECT_FALSE(meets && separated(frustum, sphere, 0.0)) << seed;
        EXPECT_FALSE(distance < Quad(sphere.radius) + margin && refined) << "nearer than the margin: " << seed;
        EXPECT_TRUE(distance < Quad(sphere.radius) + 1.001 * margin + roomOf(frustum) || refined)
            << "apart, and not seen: " << seed;
        tally.withinMargin += !meets && !refined ? 1 : 0;
    }
    tally.print("spheres");
    expectAllKinds(tally);
}

TEST(SeparationProperty, everySeparatedBoxMayBeSeparated) {
    uint64_t refined = 0;
    for (uint64_t seed = 1; seed <= pairsToTest(); ++seed) {
        Random random(seed + 0x300000000);
        const Frustum frustum = randomVolume(seed, random);
        const double size = randomSize(frustum, random);
        const EyeBox some = randomEyeBox(frustum, size, random);
        const double margin = conservativeMargin(glm::length(some.centre) + glm::length(some.halfExtent));
        uint32_t planes = 0;
        bool outside = false;
        for (uint32_t p = 0; p < 6; ++p) {
            const Containment side = classify(frustum.planes[p], some, margin);
            outside = outside || side == Containment::Outside;
            planes |= (side == Containment::Straddles ? 1u : 0u) << p;
        }
        if (outside || !separated(frustum, some, margin)) continue;
        ++refined;
        EXPECT_TRUE(mayBeSeparated(planes)) << seed << " planes " << planes;
    }
    EXPECT_GT(refined, pairsToTest() / 100);
}

TEST(SeparationProperty, boxIsSaidToMeetTheNearRectangleExactlyWhereItDoes) {
    uint64_t on = 0, off = 0;
    for (uint64_t seed = 1; seed <= pairsToTest() && !testing::Test::HasFailure(); ++seed) {
        Random random(seed + 0x400000000);
        const Frustum frustum = randomVolume(seed, random);
        const double size = random.unit() < 0.1 ? powerOfTen(random, -9, 9) : frustum.nearDistance * powerOfTen(random, -2, 2);
        Frustum thin = frustum;
        thin.farDistance = frustum.nearDistance;
        const EyeBox some = randomEyeBox(thin, size, random);
        const double magnitude = glm::length(some.centre) + glm::length(some.halfExtent);
        const double margin = random.unit() < 0.5 ? 0.0 : conservativeMargin(magnitude);
        // For a rectangle without thickness the exact test, too, would miss a box that only touches it.
        const ExactFrustum rectangle(frustum, Quad(frustum.nearDistance) + 1e-25 * magnitude);
        const auto meetsWhenGrown = [&](Quad by) {
            QuadBox grown{quad(some.centre), {}};
            for (int i = 0; i < 3; ++i) grown.halves[size_t(i)][size_t(i)] = Quad(some.halfExtent[i]) + by;
            return rectangle.meets(grown);
        };
        const bool meets = meetsNearRectangle(frustum, some, margin);
        (meets ? on : off) += 1;
        EXPECT_TRUE(meets || !meetsWhenGrown(margin)) << seed;
        // Of a parallel view the rectangle is as thick as the rounding of the depth, at the near distance once more.
        EXPECT_TRUE(!meets || meetsWhenGrown(margin + 0x1p-38 * magnitude + 2.0 * roomOf(frustum))) << seed;
    }
    EXPECT_GT(on, pairsToTest() / 10);
    EXPECT_GT(off, pairsToTest() / 10);
}

TEST(OrientedBox, holdsEveryCornerOfTheMeshBox) {
    for (uint64_t seed = 1; seed <= 20'000; ++seed) {
        Random random(seed);
        const Vec3 centre = random.direction() * powerOfTen(random, -6, 7), half = randomHalf(powerOfTen(random, -6, 3), random);
        const Box3 local{centre - half, centre + half};
        Mat4 place(1.0);
        for (int column = 0; column < 3; ++column) place[column] = Vec4(random.direction() * powerOfTen(random, -3, 3), 0.0);
        place[3] = Vec4(random.direction() * powerOfTen(random, -6, 7), 1.0);
        const Vec3 eye = random.direction() * powerOfTen(random, -6, 7);
        const Vec3 origin = seed % 2 == 0 ? Vec3(0.0) : random.direction() * powerOfTen(random, -6, 7);
        const OrientedBox box = orientedBox(local, place, eye, origin);
        const Vec3 axis = random.direction();
        for (size_t corner = 0; corner < 8; ++corner) {
            QuadVector point = minus(quad(Vec3(place[3])), quad(eye));
            for (int i = 0; i < 3; ++i)
                point = plus(point, scaled(quad(Vec3(place[i])),
                                           Quad(origin[i]) + ((corner >> i & 1) != 0 ? local.max[i] : local.min[i])));
            const Quad along = dot(quad(axis), minus(point, quad(box.centre)));
            EXPECT_LE(double(along < 0 ? -along : along), reachAlong(axis, box) * (1 + 1e-15)) << seed;
        }
        EXPECT_LT(box.room, 1e-9 * (1e7 + box.farthest())) << "more than rounding";
    }
}

}  // namespace
}  // namespace cullscope::test::separation_property_test
