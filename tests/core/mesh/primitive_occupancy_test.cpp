#include "core/mesh/primitive/occupancy.h"

#include <gtest/gtest.h>

#include "core/geometry/random.h"
#include "core/mesh/primitive/tessellate.h"
#include "tests/support/long_mode.h"

namespace cullscope::primitive::primitive_occupancy_test {
using test::howMany;
namespace {

/// A primitive of a kind with random sizes, thin, flat and ordinary; none where the sizes make no such solid.
std::optional<Primitive> randomPrimitive(size_t kind, Random& random) {
    const auto size = [&] { return std::pow(10.0, random.between(-1.5, 1.0)); };
    const auto angle = [&] { return Angle::fromDegrees(random.between(-50, 50)); };
    const auto sweep = [&] { return Angle::fromDegrees(random.between(1, 360)); };
    const auto mitre = [&] { return Mitre{angle(), angle()}; };
    const Vec3 three{size(), size(), size()};
    const double inner = size(), outer = inner + size();
    const std::array<Primitive, kKinds> all{Sphere{size()},
                                            Cylinder{size(), size()},
                                            Cone{size(), random.unit() < 0.5 ? 0.0 : size(), size()},
                                            EccentricCone{size(), size(), size(), {size(), -size()}, mitre(), mitre()},
                                            MitredCylinder{size(), size(), mitre(), mitre()},
                                            CircularTorus{outer, inner, sweep()},
                                            RectangularTorus{inner, outer, size(), sweep()},
                                            EllipsoidalDish{size(), size()},
                                            SphericalDish{size(), size()},
                                            TorisphericalHead{1.0, random.between(1.0, 3.0), random.between(0.0, 1.0)},
                                            Box{three},
                                            Wedge{three},
                                            Pyramid{{size(), size()}, size(), {size(), -size()}},
                                            PyramidFrustum{{size(), size()}, {size(), size()}, size(), {-size(), size()}},
                                            Prism{uint32_t(random.between(3, 12)), size(), size()},
                                            Disc{size()},
                                            Ring{inner, outer},
                                            HollowCylinder{inner, outer, size()}};
    // The list is in the order of the kinds.
    EXPECT_EQ(all[kind].index(), kind);
    return whyImpossible(all[kind]) ? std::nullopt : std::optional(all[kind]);
}

/// Half the length of a surface's projection on a line.
double halfLengthAlong(const Surface& surface, const Vec3& direction) {
    double least = std::numeric_limits<double>::infinity(), most = -least;
    for (const Vec3& position : surface.positions) {
        least = std::min(least, glm::dot(position, direction));
        most = std::max(most, glm::dot(position, direction));
    }
    return 0.5 * (most - least);
}

TEST(Occupancy, boundsEveryProjectionAndIsWithinOneAndAHalfOfTheLongest) {
    constexpr double kLoosest = 1.5;
    std::array<double, kKinds> loosest{};
    const uint64_t directions = howMany(1'000, 1'000);
    for (size_t kind = 0; kind < kKinds; ++kind) {
        uint64_t tested = 0;
        for (uint64_t seed = 1; tested < howMany(100, 6) && seed < 10'000; ++seed) {
            Random random(seed * 100 + kind);
            const std::optional<Primitive> primitive = randomPrimitive(kind, random);
            if (!primitive) continue;
            ++tested;
            Surface surface;
            appendSurface(surface, *primitive, {.chordError = 0.0, .segments = 32});
            const double value = occupancy(*primitive);
            double longest = 0.0;
            for (uint64_t i = 0; i < directions; ++i) longest = std::max(longest, halfLengthAlong(surface, random.direction()));
            // Needles are longest along directions that a thousand random ones miss.
            Vec3 first = surface.positions.front();
            for (int step = 0; step < 4; ++step) {
                Vec3 farthest = first;
                for (const Vec3& position : surface.positions)
                    if (glm::length(position - first) > glm::length(farthest - first)) farthest = position;
                if (farthest != first) longest = std::max(longest, halfLengthAlong(surface, glm::normalize(farthest - first)));
                first = farthest;
            }
            EXPECT_LE(longest, value * (1.0 + 1e-9)) << kindName(kind) << " seed " << seed;
            EXPECT_LE(value, kLoosest * longest) << kindName(kind) << " seed " << seed;
            loosest[kind] = std::max(loosest[kind], value / longest);
        }
        EXPECT_GT(tested, 0u) << kindName(kind);
    }
    for (size_t kind = 0; kind < kKinds; ++kind)
        std::printf("long: occupancy of %s at most %.3f\n", kindName(kind), loosest[kind]);
}

}  // namespace
}  // namespace cullscope::primitive::primitive_occupancy_test
