// The BSP tree: its planes part what lies below them, nothing is lost, and it ends on whatever it is given.
#include "core/spatial/bsp_tree.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

#include "core/base/error.h"
#include "core/mesh/parametric.h"
#include "core/scene/polygon_scene.h"
#include "core/scene/scene_source.h"
#include "tests/support/cut_scenes.h"
#include "tests/support/long_mode.h"
#include "tests/support/stopped_work.h"

namespace cullscope::test::bsp_tree_test {
namespace {

constexpr BspPlane kOwnPlanes[] = {BspPlane::First, BspPlane::Fewest, BspPlane::Balance};

/// The shares of every triangle's parts are all of it.
void expectAreasConserved(const BspTree& tree, const Scene& scene) {
    std::vector<double> shares(scene.triangleCount(), 0.0);
    for (const BspTree::Part& part : tree.parts()) {
        EXPECT_GE(part.share, -1e-12) << "a part is turned over";
        shares[part.triangle] += part.share;
    }
    for (size_t i = 0; i < shares.size(); ++i) ASSERT_NEAR(shares[i], 1.0, 1e-9) << "triangle " << i;
}

/// What hangs below the front of a node lies before its plane, up to the rounding of corners.
void expectSorted(const BspTree& tree, double tolerance) {
    for (const BspTree::Node& node : tree.nodes()) {
        if (node.partCount == 0 || node.parent == BspTree::kNone) continue;
        const OwnTriangles& drawn = tree.drawn();
        for (int32_t below = int32_t(&node - tree.nodes().data()), above = node.parent; above != BspTree::kNone;
             below = above, above = tree.nodes()[size_t(above)].parent) {
            const BspTree::Node& plane = tree.nodes()[size_t(above)];
            const double sign = plane.front == below ? 1.0 : -1.0;
            for (const BspTree::Part& part : tree.partsOf(node))
                for (uint32_t corner = 3 * part.first; corner < 3 * (part.first + part.count); ++corner)
                    ASSERT_GE(sign * plane.plane.distance(Vec3(drawn.positions[corner])), -tolerance);
        }
    }
}

TEST(BspTree, partsLieOnTheirSidesAndNothingIsLost) {
    for (uint64_t seed = 0; seed < howMany(60, 24); ++seed)
        for (const BspPlane plane : kOwnPlanes) {
            SCOPED_TRACE("seed " + std::to_string(seed) + " plane " + std::to_string(int(plane)));
            const ScenePointer scene = hardScene(seed);
            const BspTree tree(*scene, {.plane = plane});
            expectAreasConserved(tree, *scene);
            expectSorted(tree, 1e-6);
            EXPECT_EQ(tree.parts().size(), scene->triangleCount() + tree.cuts());
        }
}

TEST(BspTree, convexSolidIsAListWithoutCuts) {
    const ScenePointer scene = sceneOf({sphereMesh(320)});
    const BspTree tree(*scene, {.plane = BspPlane::First});
    EXPECT_EQ(tree.cuts(), 0u);
    EXPECT_EQ(tree.nodes().size(), tree.depth() + 1u);
    EXPECT_EQ(tree.nodes().size(), scene->triangleCount());
    // A box has six planes, each with two triangles.
    const ScenePointer box = sceneOf({boxMesh({-1, -2, -3}, {1, 2, 3})});
    const BspTree sides(*box, {});
    EXPECT_EQ(sides.nodes().size(), 6u);
    for (const BspTree::Node& node : sides.nodes()) EXPECT_EQ(node.partCount, 2u);
}

TEST(BspTree, cycleIsCut) {
    const BspTree tree(*sceneOf({threeBars()}), {});
    EXPECT_GE(tree.cuts(), 1u);
}

TEST(BspTree, walkComesToEveryPartOnceAndNeverFromNearToFar) {
    const ScenePointer scene = hardScene(5);
    const BspTree tree(*scene, {});
    Random random(2);
    for (int i = 0; i < 50; ++i) {
        const Vec3 eye = 3.0 * random.direction() * random.unit();
        std::vector<uint32_t> farFirst, nearFirst;
        tree.walk(
            eye, false, [](uint32_t, int) {}, [&](uint32_t node) { farFirst.push_back(node); });
        tree.walk(
            eye, true, [](uint32_t, int) {}, [&](uint32_t node) { nearFirst.push_back(node); });
        ASSERT_EQ(farFirst.size(), tree.nodes().size());
        std::ranges::reverse(nearFirst);
        EXPECT_EQ(farFirst, nearFirst);
        std::vector<size_t> place(farFirst.size());
        for (size_t at = 0; at < farFirst.size(); ++at) place[farFirst[at]] = at;
        for (uint32_t node = 1; node < tree.nodes().size(); ++node) {
            const BspTree::Node& parent = tree.nodes()[size_t(tree.nodes()[node].parent)];
            const int side = BspTree::sideOf(parent, eye);
            const bool sameSide = parent.front == int32_t(node) ? side >= 0 : side < 0;
            EXPECT_EQ(place[node] > place[size_t(tree.nodes()[node].parent)], sameSide);
        }
    }
}

TEST(BspTree, coplanarPolygonsStayAtOneNode) {
    std::vector<Vec3f> corners;
    for (int x = 0; x < 100; ++x)
        for (int y = 0; y < 50; ++y) {
            const Vec3f at(0.1f * float(x), 0.1f * float(y), 0.0f);
            corners.insert(corners.end(), {at, at + Vec3f(0.1f, 0, 0), at + Vec3f(0.1f, 0.1f, 0)});
            corners.insert(corners.end(), {at, at + Vec3f(0.1f, 0.1f, 0), at + Vec3f(0, 0.1f, 0)});
        }
    const MeshPointer plate = soupMesh(std::move(corners));
    const BspTree flat(*sceneOf({plate}), {});
    EXPECT_EQ(flat.nodes().size(), 1u);
    EXPECT_EQ(flat.parts().size(), 10'000u);
    // Turned, the corners are rounded: planes differ by rounding, which must neither lose anything nor cut without end.
    const Mat4 turned = glm::rotate(Mat4(1.0), 0.7, glm::normalize(Vec3(1, 2, 3)));
    const ScenePointer oblique = sceneOf({plate}, {turned});
    const BspTree tree(*oblique, {});
    expectAreasConserved(tree, *oblique);
    EXPECT_LT(tree.parts().size(), 200'000u);
}

TEST(BspTree, trianglesInOnePlaceAreCutEachOnLinesOfItsOwn) {
    for (uint64_t seed = 0; seed < 6; ++seed)
        for (const BspPlane plane : kOwnPlanes) {
            SCOPED_TRACE("seed " + std::to_string(seed) + " plane " + std::to_string(int(plane)));
            const MeshPointer once = randomTriangles(seed, 30, 1.5);
            std::vector<Vec3f> corners;
            for (size_t i = 0; i < once->indices().size(); i += 3) {
                const auto at = [&](size_t corner) { return once->positions()[once->indices()[i + corner]]; };
                // The same, turned by a corner, and from its other side.
                corners.insert(corners.end(), {at(0), at(1), at(2), at(1), at(2), at(0), at(0), at(2), at(1)});
            }
            const ScenePointer scene = sceneOf({soupMesh(std::move(corners))});
            const BspTree tree(*scene, {.plane = plane});
            EXPECT_GT(tree.cuts(), 10u);
            expectAreasConserved(tree, *scene);
        }
}

TEST(BspTree, millionCoplanarTrianglesEndWithALookInEveryTenthOfASecond) {
    const ScenePointer scene = coplanarTriangles(howMany(1'000'000, 100'000));
    const WatchedWork watched;
    const BspTree tree(*scene, {});
    EXPECT_LT(watched.longestGap(), fewSamples() ? 1000.0 : 100.0);
    EXPECT_EQ(tree.nodes().size(), 1u);
    EXPECT_EQ(tree.parts().size(), scene->triangleCount());
    // Another thread requests the stop on the way: while it is read, divided and finished.
    const uint64_t all = watched.steps();
    for (const uint64_t share : {2, 5, 9}) {
        const StoppedWork stopped =
            stoppedAfter(all * share / 10, [&](const Progress& progress) { (void)BspTree(*scene, {}, progress); });
        EXPECT_TRUE(stopped.interrupted) << share;
        EXPECT_GE(stopped.stepsBefore, all * share / 10);
        EXPECT_LE(stopped.stepsAfter, WorkCheck::kBetween) << share;
    }
}

TEST(BspTree, sliversOfAspectABillionKeepTheirAreas) {
    Random random(11);
    std::vector<Vec3f> corners;
    for (int i = 0; i < 60; ++i) {
        const float y = float(random.between(-1, 1)), z = float(random.between(-1, 1));
        corners.insert(corners.end(), {{-1, y, z}, {1, y, -z}, {0, y + 2e-9f * (y == 0 ? 1 : 0) + 1e-6f, 0}});
    }
    // Flattened by their transform to 1e-9 of their length.
    const ScenePointer scene = sceneOf({soupMesh(std::move(corners)), randomTriangles(4, 40, 1.0)},
                                       {glm::rotate(Mat4(1.0), 0.3, Vec3(0, 0, 1)) * scaling({1, 1e-3, 1})});
    const BspTree tree(*scene, {});
    expectAreasConserved(tree, *scene);
}

TEST(BspTree, limitStopsItWithASentence) {
    const ScenePointer scene = sceneOf({randomTriangles(1, 2'000, 2.0)});
    for (const BspPlane plane : {BspPlane::Balance, BspPlane::First, BspPlane::Fewest}) {
        try {
            const BspTree tree(*scene, {.plane = plane, .limit = 20'000});
            FAIL() << tree.parts().size();
        } catch (const Error& error) {
            const std::string sentence = error.what();
            EXPECT_EQ(error.kind(), ErrorKind::Usage);
            EXPECT_NE(sentence.find("more than 20000 polygons: its 2000 triangles were cut"), std::string::npos) << sentence;
            EXPECT_EQ(sentence.find("plane=fewest") == std::string::npos, plane == BspPlane::Fewest)
                << "no advice to take what was taken: " << sentence;
        }
    }
}

TEST(BspTree, limitCountsWholeTrianglesAndNodes) {
    const auto refusal = [](const Scene& scene, const BspOptions& options) -> std::string {
        try {
            return "built: " + std::to_string(BspTree(scene, options).nodes().size());
        } catch (const Error& error) {
            EXPECT_EQ(error.kind(), ErrorKind::Usage);
            return error.what();
        }
    };
    const ScenePointer box = sceneOf({boxMesh({-1, -2, -3}, {1, 2, 3})});
    EXPECT_NE(refusal(*box, {.limit = 11}).find("more than 11 polygons: it has 12 triangles. Take fewer"), std::string::npos);
    EXPECT_EQ(refusal(*box, {.limit = 12}), "built: 6");
    // Each given plane doubles the cells: sixty of them would never end.
    std::string text = "polygon A 0 0 0  1 0 0  0 1 0\n";
    for (int i = 0; i < 60; ++i) text += "plane P" + std::to_string(i) + " 1 0 0 " + std::to_string(i) + "\n";
    const ScenePointer scene = readPolygonText(text, "planes").scene;
    EXPECT_NE(refusal(*scene, {.plane = BspPlane::Given}).find("more than 1000000 nodes: each of its 60 planes"),
              std::string::npos);
    const ScenePointer quiz = openScene("quiz").scene;
    EXPECT_EQ(refusal(*quiz, {.plane = BspPlane::Given, .limit = 15}), "built: 15");
    EXPECT_NE(refusal(*quiz, {.plane = BspPlane::Given, .limit = 14}).find("more than 14 nodes"), std::string::npos);
}

TEST(BspTree, buildStopsAtTheNextLookWhereverItIs) {
    const ScenePointer scene = sceneOf({randomTriangles(1, 10'000, 2.0)});
    for (const uint64_t steps : {1'000, 50'000, 500'000}) {
        const StoppedWork stopped =
            stoppedAfter(steps, [&](const Progress& progress) { (void)BspTree(*scene, {.limit = 100'000'000}, progress); });
        EXPECT_TRUE(stopped.interrupted) << steps;
        EXPECT_GE(stopped.stepsBefore, steps);
        EXPECT_LE(stopped.stepsAfter, WorkCheck::kBetween) << steps;
    }
}

TEST(BspTree, trianglesWithoutAreaAreKeptAside) {
    const ScenePointer scene = sceneOf({soupMesh({{0, 0, 0}, {1, 1, 1}, {2, 2, 2}, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}})});
    const BspTree tree(*scene, {});
    EXPECT_EQ(tree.nodes().size(), 1u);
    EXPECT_EQ(tree.flatParts().size(), 1u);
    EXPECT_EQ(tree.parts().size(), 2u);
}

TEST(BspTree, givenPlanesNeedAScene) {
    EXPECT_THROW(BspTree(*sceneOf({squareMesh(1, 0)}), {.plane = BspPlane::Given}), Error);
    const ScenePointer quiz = openScene("quiz").scene;
    const BspTree tree(*quiz, {.plane = BspPlane::Given});
    EXPECT_EQ(tree.nodes().size(), 15u) << "three levels of planes, eight leaves";
    expectAreasConserved(tree, *quiz);
}

/// The objects whose parts lie in each node of the tree of a text's given planes, and the cuts: "|BB|AA cuts 0".
std::string placesOf(const char* text) {
    const ScenePointer scene = readPolygonText(text, "own").scene;
    const BspTree tree(*scene, {.plane = BspPlane::Given});
    std::string places;
    for (size_t node = 0; node < tree.nodes().size(); ++node) {
        places += node > 0 ? "|" : "";
        for (const BspTree::Part& part : tree.partsOf(tree.nodes()[node]))
            places += scene->instances()[scene->instanceOf(part.triangle)].name;
    }
    return places + " cuts " + std::to_string(tree.cuts());
}

TEST(BspTree, polygonsThatTouchAGivenPlaneAreNotCutByIt) {
    // The root, behind and before it; each polygon is two triangles. No float and no double is 0.7.
    EXPECT_EQ(placesOf("polygon A 0.7 0 0  1 0 0  1 1 0  0.7 1 0\n"
                       "polygon B 0.7 0 -1  0.7 1 -1  0.2 1 -1  0.2 0 -1\n"
                       "plane P1 1 0 0 -0.7"),
              "|BB|AA cuts 0");
    EXPECT_EQ(placesOf("polygon A 0.7 0 0  1 0 0  1 1 0  0.7 1 0\n"
                       "polygon B 0.7 0 -1  0.7 1 -1  0.2 1 -1  0.2 0 -1\n"
                       "plane P1 1 0 0 -0.3\n"
                       "plane P2 1 0 0 -0.7"),
              "|||BB||BB|AA cuts 2")
        << "B is cut at 0.3 alone";
    EXPECT_EQ(placesOf("polygon A 0.1 0.2 0.3  0.7 0.2 0.9  0.3 0.9 0.3\nplane P1 0.2 0.2 0.3  0 0 1"), "||A cuts 0");
    // An edge that touches a plane is cut by another one: its new end touches it, too.
    EXPECT_EQ(placesOf("polygon A 0.7 0 0  1 0 0  1 1 0  0.7 1 0\nplane P1 0 1 0 -0.45\nplane P2 1 0 0 -0.7"),
              "||||AA||AA cuts 2");
    EXPECT_EQ(placesOf("polygon A 0.7 -0.1 -1   0.7 0.9 1   1.3 0.9 1\nplane P1 0 0 1 0\nplane P2 1 0 0 -0.7"),
              "||||A||A cuts 1");
}

TEST(BspTree, polygonsThatLieInAGivenPlaneAsWrittenAreAtItsNode) {
    EXPECT_EQ(placesOf("polygon A 0 1 -1   1 -3 0   -1 3 0\npolygon B 0 0 3  1 0 3  0 1 3\nplane P1 3 1 1 0"), "A||B cuts 0");
    EXPECT_EQ(placesOf("polygon A 3 0 0   0 1.5 0   0 0 9\npolygon B 1 1 0   2 0 3   1 0 6\nplane P1 0.3 0.6 0.1 -0.9"),
              "BA|| cuts 0");
}

TEST(BspTree, polygonsBesideAGivenPlaneAreNotInIt) {
    EXPECT_EQ(placesOf("polygon A 0 0 0.3000000001  1 0 0.3000000001  0 1 0.3000000001\nplane P1 0 0 1 -0.3"), "||A cuts 0");
    EXPECT_EQ(placesOf("polygon A 0 0 0.2999999999  1 0 0.2999999999  0 1 0.2999999999\nplane P1 0 0 1 -0.3"), "|A| cuts 0");
    EXPECT_EQ(placesOf("polygon A 0.70001 0 0  1 1 0  0.69999 1 0\nplane P1 1 0 0 -0.7"), "|A|A cuts 1");
}

TEST(BspTree, anEyeInAGivenPlaneAsWrittenLiesInIt) {
    const ScenePointer scene = readPolygonText("polygon A 0 0 0  1 0 0  0 1 0\nplane P1 0.3 0.6 0.1 -0.9", "own").scene;
    const BspTree tree(*scene, {.plane = BspPlane::Given});
    EXPECT_EQ(BspTree::sideOf(tree.nodes()[0], {3, 0, 0}), 0);
    EXPECT_EQ(BspTree::sideOf(tree.nodes()[0], {3.000001, 0, 0}), 1);
    EXPECT_EQ(BspTree::sideOf(tree.nodes()[0], {2.999999, 0, 0}), -1);
}

TEST(BspTree, nodesSumUpWhatLiesBelowThem) {
    for (uint64_t seed = 0; seed < 12; ++seed)
        for (const BspPlane plane : kOwnPlanes) {
            const ScenePointer scene = hardScene(seed);
            const BspTree tree(*scene, {.plane = plane});
            for (const BspTree::Node& node : tree.nodes()) {
                uint32_t polygons = node.partCount;
                Box3 below;
                for (const int32_t child : {node.front, node.back}) {
                    if (child == BspTree::kNone) continue;
                    polygons += tree.nodes()[size_t(child)].polygons;
                    below.add(tree.nodes()[size_t(child)].box);
                }
                EXPECT_EQ(node.polygons, polygons);
                if (!below.empty()) {
                    EXPECT_TRUE(glm::all(glm::lessThanEqual(node.box.min, below.min)));
                    EXPECT_TRUE(glm::all(glm::greaterThanEqual(node.box.max, below.max)));
                }
                const auto parts = tree.partsOf(node);
                EXPECT_TRUE(std::ranges::is_sorted(parts, std::greater<>(), &BspTree::Part::triangle));
            }
            EXPECT_EQ(tree.nodes().front().polygons, tree.parts().size());
        }
}

TEST(BspTree, candidatesAreJudgedByCutsOrByBalance) {
    const ScenePointer scene = sceneOf({randomTriangles(3, 1'000, 0.3)});
    const BspTree first(*scene, {.plane = BspPlane::First}), fewest(*scene, {.plane = BspPlane::Fewest});
    const BspTree balance(*scene, {.plane = BspPlane::Balance});
    EXPECT_LT(fewest.cuts(), balance.cuts());
    EXPECT_LT(balance.depth(), fewest.depth());
    EXPECT_LT(fewest.cuts(), first.cuts());
    EXPECT_LT(balance.depth(), first.depth());
}

TEST(BspTree, limitRefusesTheFirstCutThatIsTooMany) {
    const ScenePointer piercing = sceneOf({soupMesh({{-1, -1, -1}, {1, -1, 1}, {0, 1, 0}, {-1, -1, 1}, {1, -1, -1}, {0, 1, 0}})});
    try {
        const BspTree tree(*piercing, {.limit = 2});
        FAIL() << "a cut makes a third polygon";
    } catch (const Error& error) {
        EXPECT_NE(std::string(error.what()).find("were cut 0 times"), std::string::npos) << error.what();
    }
    EXPECT_EQ(BspTree(*piercing, {.limit = 3}).cuts(), 1u);
}

}  // namespace
}  // namespace cullscope::test::bsp_tree_test
