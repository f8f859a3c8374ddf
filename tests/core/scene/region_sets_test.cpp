#include "core/scene/region_sets.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/geometry/random.h"

namespace cullscope::test::region_sets_test {
namespace {

/// Four regions along x: below 1, below 2, below 3, and the rest.
std::vector<RegionSets::Node> fourAlongX() {
    return {{{1, 0, 0}, 2.0, {1, 2}}, {{1, 0, 0}, 3.0, {-4, -3}}, {{1, 0, 0}, 1.0, {-2, -1}}};
}

TEST(RegionSets, placesHaveTheRegionOnTheirSideOfThePlanes) {
    RegionSets sets(fourAlongX(), 4, 3, {Vec3(0.0), Vec3(4.0)});
    for (uint32_t region = 0; region < 4; ++region)
        if (region != 2) sets.setOf(region, std::vector<uint8_t>{1, 0, 1});
    EXPECT_EQ(sets.regionAt({0.5, 1, 1}), 0u);
    EXPECT_EQ(sets.regionAt({1.0, 1, 1}), 1u) << "a place on the plane is in front";
    EXPECT_EQ(sets.regionAt({2.5, 1, 1}), std::nullopt) << "without a set everything may be seen";
    EXPECT_EQ(sets.regionAt({3.5, 1, 1}), 3u);
    EXPECT_EQ(sets.regionAt({4.5, 1, 1}), std::nullopt);
    EXPECT_EQ(sets.regionAt({0.5, -0.1, 1}), std::nullopt);
    EXPECT_EQ(sets.setCount(), 1u) << "equal sets are kept once";
}

TEST(RegionSets, setsComeBackAsTheyWereAdded) {
    Random random(3);
    for (const size_t objects : {size_t(1), size_t(8), size_t(9), size_t(700), size_t(5000)}) {
        RegionSets sets(fourAlongX(), 4, objects);
        std::vector<std::vector<uint32_t>> expected(4);
        for (uint32_t region = 0; region < 4; ++region) {
            std::vector<uint8_t> visible(objects, 0);
            const double share = region == 0 ? 0.0 : region == 1 ? 1.0 : region == 2 ? 0.001 : 0.5;
            for (uint32_t i = 0; i < objects; ++i)
                if (random.unit() < share) {
                    visible[i] = 1;
                    expected[region].push_back(i);
                }
            sets.setOf(region, visible);
        }
        for (uint32_t region = 0; region < 4; ++region) EXPECT_EQ(sets.objectsOf(region), expected[region]) << objects;
        if (objects == 5000) {
            EXPECT_LT(sets.bytes(), 5000u / 8 * 4) << "runs of zero bytes are counted";
        }
    }
}

TEST(RegionSets, ofSomeObjectsKeepsWhatIsSeenOfThem) {
    RegionSets sets(fourAlongX(), 4, 4);
    sets.setOf(0, std::vector<uint8_t>{1, 0, 1, 1});
    sets.setOf(3, std::vector<uint8_t>{0, 1, 0, 1});
    const RegionSets some = sets.ofObjects(std::vector<uint32_t>{1, 3});
    EXPECT_EQ(some.objectCount(), 2u);
    EXPECT_THAT(some.objectsOf(0), testing::ElementsAre(1u));
    EXPECT_THAT(some.objectsOf(3), testing::ElementsAre(0u, 1u));
    EXPECT_FALSE(some.hasSet(1));
}

}  // namespace
}  // namespace cullscope::test::region_sets_test
