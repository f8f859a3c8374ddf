// Pockets that are inside out: found exactly where the winding number is negative somewhere.
#include "core/mesh/inside_out.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <stop_token>

#include "core/base/error.h"
#include "core/geometry/angle.h"
#include "core/geometry/random.h"
#include "core/geometry/triangle.h"
#include "core/mesh/parametric.h"
#include "tests/support/refusal.h"

namespace cullscope::test::inside_out_test {
namespace {

struct Soup {
    std::vector<Vec3f> positions;
    std::vector<uint32_t> indices;

    /// A surface, turned over or as it is.
    void add(std::span<const Vec3f> corners, std::span<const uint32_t> triangles, bool turnedOver) {
        const auto base = static_cast<uint32_t>(positions.size());
        for (size_t i = 0; i < triangles.size(); i += 3)
            for (const size_t corner : {i, turnedOver ? i + 2 : i + 1, turnedOver ? i + 1 : i + 2})
                indices.push_back(base + triangles[corner]);
        positions.insert(positions.end(), corners.begin(), corners.end());
    }
    void add(const TriangleMesh& mesh, const Vec3f& moved, float scale, bool turnedOver) {
        std::vector<Vec3f> corners;
        for (const Vec3f& position : mesh.positions()) corners.push_back(moved + scale * position);
        add(corners, mesh.indices(), turnedOver);
    }
    void addBox(const Vec3f& min, const Vec3f& max, bool turnedOver = false) {
        static constexpr std::array<uint32_t, 36> kBox{0, 4, 6, 0, 6, 2, 1, 3, 7, 1, 7, 5, 0, 1, 5, 0, 5, 4,
                                                       2, 6, 7, 2, 7, 3, 0, 2, 3, 0, 3, 1, 4, 5, 7, 4, 7, 6};
        std::vector<Vec3f> corners;
        for (int i = 0; i < 8; ++i)
            corners.emplace_back((i & 1) != 0 ? max.x : min.x, (i & 2) != 0 ? max.y : min.y, (i & 4) != 0 ? max.z : min.z);
        add(corners, kBox, turnedOver);
    }
    [[nodiscard]] TriangleMesh mesh() const {
        TriangleMesh::Data data;
        data.positions = positions;
        data.indices = indices;
        return TriangleMesh(std::move(data));
    }
};

Pockets pocketsOf(const Soup& soup) { return soup.mesh().pockets(); }

/// By solid angles in double, of a point off the surface.
double windingAt(const Soup& soup, const Vec3& point) {
    double sum = 0.0;
    for (size_t i = 0; i < soup.indices.size(); i += 3) {
        TriangleCorners corners;
        for (size_t corner = 0; corner < 3; ++corner) corners[corner] = Vec3(soup.positions[soup.indices[i + corner]]) - point;
        sum += solidAngle(corners);
    }
    return sum / (2.0 * kTurn);
}

TEST(InsideOut, whatTurnsItsFrontsOutwardHasNoPockets) {
    for (const MeshPointer& mesh : {sphereMesh(2000), torusMesh(2000), bowlMesh(2000), knotMesh(2000), starMesh(3, 2000)})
        EXPECT_EQ(mesh->pockets(), Pockets::None) << mesh->name();
}

TEST(InsideOut, aTurnedOverBoxIsFoundBesideALargerOneAcrossItAndNotAsACavityInIt) {
    Soup beside, across, within;
    for (Soup* soup : {&beside, &across, &within}) soup->addBox(Vec3f(0), Vec3f(10));
    beside.addBox(Vec3f(20), Vec3f(21), true);
    across.addBox(Vec3f(9), Vec3f(11), true);
    within.addBox(Vec3f(4), Vec3f(6), true);
    EXPECT_EQ(pocketsOf(beside), Pockets::Found);
    EXPECT_EQ(pocketsOf(across), Pockets::Found);
    EXPECT_EQ(pocketsOf(within), Pockets::None);
    // What is cut out twice is.
    within.addBox(Vec3f(5), Vec3f(7), true);
    EXPECT_EQ(pocketsOf(within), Pockets::Found);
}

TEST(InsideOut, solidsThatCrossOrTouchHaveNoPockets) {
    Soup crossing, touching, equal;
    for (Soup* soup : {&crossing, &touching, &equal}) soup->addBox(Vec3f(0), Vec3f(10));
    crossing.addBox(Vec3f(5), Vec3f(15));
    touching.addBox(Vec3f(10, 1, 2), Vec3f(12, 8, 9));
    equal.add(*sphereMesh(500), Vec3f(0), 3.0F, false);
    EXPECT_EQ(pocketsOf(crossing), Pockets::None);
    EXPECT_EQ(pocketsOf(touching), Pockets::None);
    EXPECT_EQ(pocketsOf(equal), Pockets::None);
}

TEST(InsideOut, aDentThatIsPushedThroughTheOtherSideIsFound) {
    // The top of a sphere is pulled down, as far as into the body and then out of its bottom.
    for (const float pulled : {1.0F, 1.5F, 2.1F, 4.0F}) {
        const MeshPointer sphere = sphereMesh(2000);
        Soup soup;
        soup.positions.assign(sphere->positions().begin(), sphere->positions().end());
        soup.indices.assign(sphere->indices().begin(), sphere->indices().end());
        for (Vec3f& position : soup.positions)
            if (position.z > 0.9F) position.z -= pulled;
        EXPECT_EQ(pocketsOf(soup), pulled > 2.0F ? Pockets::Found : Pockets::None) << pulled;
    }
}

TEST(InsideOut, boxesOnAGridHavePocketsExactlyWhereTheSumOfTheirSignsIsNegative) {
    constexpr int kSide = 6;
    size_t tried = 0, found = 0;
    for (uint64_t seed = 0; seed < 600; ++seed) {
        Random random(seed);
        const auto upTo = [&](int most) { return static_cast<int>(random.bits() % uint64_t(most)); };
        Soup soup;
        std::array<int, kSide * kSide * kSide> windings{};
        for (int boxes = 2 + upTo(4); boxes > 0; --boxes) {
            std::array<int, 3> least{}, most{};
            for (size_t axis = 0; axis < 3; ++axis) {
                least[axis] = upTo(kSide - 1);
                most[axis] = least[axis] + 1 + upTo(kSide - least[axis] - 1);
            }
            const bool turnedOver = upTo(3) == 0;
            soup.addBox(Vec3f(least[0], least[1], least[2]), Vec3f(most[0], most[1], most[2]), turnedOver);
            for (int x = least[0]; x < most[0]; ++x)
                for (int y = least[1]; y < most[1]; ++y)
                    for (int z = least[2]; z < most[2]; ++z) windings[size_t((x * kSide + y) * kSide + z)] += turnedOver ? -1 : 1;
        }
        const TriangleMesh mesh = soup.mesh();
        if (!mesh.topology().closed || !mesh.topology().consistentlyOriented) continue;  // boxes that share a whole edge
        const bool negative = std::ranges::any_of(windings, [](int winding) { return winding < 0; });
        EXPECT_EQ(mesh.pockets(), negative ? Pockets::Found : Pockets::None) << "seed " << seed;
        ++tried;
        found += negative ? 1 : 0;
    }
    EXPECT_GT(found, 100U);
    EXPECT_GT(tried - found, 100U);
}

TEST(InsideOut, turnedSpheresThatCrossHavePocketsWhereSolidAnglesSayThatTheyDo) {
    const MeshPointer sphere = sphereMesh(320);
    size_t found = 0;
    for (uint64_t seed = 0; seed < 150; ++seed) {
        Random random(seed);
        Soup soup;
        std::vector<std::pair<Vec3, double>> solids;
        for (int i = 0; i < 4; ++i) {
            solids.emplace_back(random.direction() * random.between(0.0, 1.5), random.between(0.3, 1.5));
            soup.add(*sphere, Vec3f(solids.back().first), float(solids.back().second), i > 0 && random.unit() < 0.4);
        }
        const Pockets pockets = pocketsOf(soup);
        EXPECT_NE(pockets, Pockets::NotProven) << "seed " << seed;
        found += pockets == Pockets::Found ? 1 : 0;
        bool negative = false;
        for (int i = 0; i < 400 && !negative; ++i) {
            const auto& [centre, radius] = solids[size_t(i) % solids.size()];
            negative = windingAt(soup, centre + random.direction() * radius * std::cbrt(random.unit())) < -0.5;
        }
        if (negative) EXPECT_EQ(pockets, Pockets::Found) << "seed " << seed;
        if (pockets == Pockets::None) EXPECT_FALSE(negative) << "seed " << seed;
    }
    EXPECT_GT(found, 20U);
    EXPECT_LT(found, 140U);
}

TEST(InsideOut, placeAndSizeDoNotMatter) {
    for (const float scale : {1e-30F, 1e-6F, 1.0F, 1e6F, 1e30F})
        for (const float offset : {0.0F, 100.0F}) {
            Soup crossing, pocket;
            for (Soup* soup : {&crossing, &pocket}) soup->addBox(scale * Vec3f(offset), scale * Vec3f(offset + 10));
            crossing.addBox(scale * Vec3f(offset + 5), scale * Vec3f(offset + 15));
            pocket.addBox(scale * Vec3f(offset + 9), scale * Vec3f(offset + 11), true);
            EXPECT_EQ(pocketsOf(crossing), Pockets::None) << scale << " " << offset;
            EXPECT_EQ(pocketsOf(pocket), Pockets::Found) << scale << " " << offset;
        }
}

TEST(InsideOut, nothingIsProvenOfAnOpenMesh) {
    Soup open;
    open.addBox(Vec3f(0), Vec3f(1));
    open.indices.resize(open.indices.size() - 3);
    EXPECT_EQ(pocketsOf(open), Pockets::NotProven);
}

TEST(InsideOut, aStoppedSearchCanBeginAnew) {
    const MeshPointer sphere = sphereMesh(2000);
    std::stop_source stop;
    stop.request_stop();
    EXPECT_NE(refusalOf([&] { static_cast<void>(sphere->pockets({nullptr, stop.get_token()})); }, ErrorKind::Interrupted), "");
    EXPECT_EQ(sphere->pockets(), Pockets::None);
}

}  // namespace
}  // namespace cullscope::test::inside_out_test
