#include "core/scene/section.h"

#include <gtest/gtest.h>

#include "core/geometry/random.h"

namespace cullscope::section_test {
namespace {

constexpr std::array kAxes{Section::Axis::X, Section::Axis::Y, Section::Axis::Z, Section::Axis::View};

TEST(Section, itsTextReadsBackAsTheSame) {
    Random random(1);
    for (int i = 0; i < 200; ++i) {
        const Section section{kAxes[random.bits() % 4], random.unit(), random.unit() < 0.5};
        EXPECT_EQ(sectionFromText(sectionText(section)), section) << sectionText(section);
    }
    EXPECT_EQ(sectionFromText("view:0.25:flip"), (Section{Section::Axis::View, 0.25, true}));
    for (const char* wrong :
         {"", "x", "w:0.5", "x:", "x:1.5", "x:-0.1", "x:nan", "x:0.5:", "x:0.5:flap", "x:0.5:flip:flip", "x 0.5"})
        EXPECT_FALSE(sectionFromText(wrong)) << wrong;
}

TEST(Section, dividesTheSceneAtItsShareOfTheExtent) {
    Random random(2);
    const Box3 box{{-1, 2, 10}, {3, 4, 11}};
    for (int i = 0; i < 500; ++i) {
        Section section{kAxes[random.bits() % 4], random.unit(), false};
        Camera camera;
        camera.eye = 5.0 * random.direction();
        camera.target = random.direction();
        const Plane plane = sectionPlane(section, box, camera);
        EXPECT_NEAR(glm::length(plane.normal), 1.0, 1e-12);
        // The part of the box's extent along the normal that is kept.
        double least = INFINITY, most = -INFINITY;
        for (int c = 0; c < 8; ++c) {
            const double distance = plane.distance({(c & 1) != 0 ? box.max.x : box.min.x, (c & 2) != 0 ? box.max.y : box.min.y,
                                                    (c & 4) != 0 ? box.max.z : box.min.z});
            least = std::min(least, distance);
            most = std::max(most, distance);
        }
        EXPECT_NEAR(-least / (most - least), section.share, 1e-9) << sectionText(section);
        section.flipped = true;
        const Plane other = sectionPlane(section, box, camera);
        const Vec3 point = 20.0 * random.direction();
        EXPECT_NEAR(plane.distance(point), -other.distance(point), 1e-9);
    }
}

TEST(Section, outlineLiesInThePlaneAndOnTheBox) {
    Random random(3);
    const Box3 box{{-1, 2, 10}, {3, 4, 11}};
    size_t corners = 0;
    for (int i = 0; i < 500; ++i) {
        const Vec3 normal = random.direction();
        const Plane plane{normal, -glm::dot(normal, box.centre()) + random.between(-3, 3)};
        const std::vector<Vec3> polygon = planeInBox(plane, box);
        corners += polygon.size();
        EXPECT_NE(polygon.size(), 1u);
        EXPECT_LE(polygon.size(), 6u);
        for (size_t k = 0; k < polygon.size(); ++k) {
            EXPECT_NEAR(plane.distance(polygon[k]), 0.0, 1e-9);
            for (int axis = 0; axis < 3; ++axis) {
                EXPECT_GE(polygon[k][axis], box.min[axis] - 1e-9);
                EXPECT_LE(polygon[k][axis], box.max[axis] + 1e-9);
            }
            // Convex: each edge turns the same way about the normal.
            const Vec3 a = polygon[k], b = polygon[(k + 1) % polygon.size()], c = polygon[(k + 2) % polygon.size()];
            EXPECT_GT(glm::dot(glm::cross(b - a, c - b), normal), -1e-9);
        }
    }
    EXPECT_GT(corners, 500u);
    EXPECT_TRUE(planeInBox({Vec3(0, 0, 1), 0.0}, box).empty());
}

}  // namespace
}  // namespace cullscope::section_test
