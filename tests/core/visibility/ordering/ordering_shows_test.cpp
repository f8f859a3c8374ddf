// What the methods by order tell of a frame: their listings, the parts of objects, the nodes of the tree, and that they stop.

#include <gmock/gmock.h>

#include <map>
#include <set>

#include "core/frame/prediction.h"
#include "core/scene/scene_source.h"
#include "core/visibility/subject_shape.h"
#include "tests/support/culler.h"
#include "tests/support/cut_scenes.h"
#include "tests/support/stopped_work.h"

namespace cullscope::test::ordering_shows_test {
namespace {

using testing::Each;
using testing::ElementsAre;
using testing::Gt;

constexpr Viewport kSize{160, 120};

CullerPointer strategy(const char* id, const std::vector<std::pair<const char*, const char*>>& values = {}) {
    ParameterSet parameters(findStrategy(id).info.parameters);
    for (const auto& [key, value] : values) parameters.setFromText(key, value);
    return makeCuller(id, parameters);
}

/// The lecture's quiz, and the tree of its own planes.
struct OrderingShows : testing::Test {
    ScenePointer scene = openScene("quiz").scene;
    CullerPointer tree = strategy("bsp", {{"plane", "given"}});
    View view{*scene->remarks().camera, kSize};
    FrameLog log;

    void SetUp() override {
        tree->build(*scene);
        log = tree->cull(view, Recording::On).log;
    }
    [[nodiscard]] NamedParts parts() const { return tree->built()->parts(log); }
};

TEST_F(OrderingShows, everyLineOfTheListingsIsReached) {
    EXPECT_THAT(tree->built()->listing(log)->decisions, ElementsAre(1, 7, 7, 10, 7))
        << "a first and a last child of each plane, ten polygons";
    const CullerPointer painter = strategy("painter");
    std::vector<uint64_t> sum(kMostListingLines, 0);
    for (uint64_t seed = 0; seed < 12; ++seed) {
        const ScenePointer hard = hardScene(seed);
        painter->build(*hard);
        const View from({{0.3, 0.2, 3}, Vec3(0.0), {0, 1, 0}, Angle::fromDegrees(50), 0.05, 100}, kSize);
        const ListingState state = *painter->built()->listing(painter->cull(from, Recording::On).log);
        for (size_t line = 0; line < state.decisions.size(); ++line) sum[line] += state.decisions[line];
    }
    EXPECT_THAT(sum, Each(Gt(0u)));
}

TEST_F(OrderingShows, listingOfTheTreeRunsForwardInBothOrders) {
    for (const char* order : {"back-to-front", "front-to-back"}) {
        const CullerPointer culler = strategy("bsp", {{"order", order}});
        const ScenePointer hard = hardScene(5);
        culler->build(*hard);
        const View from({{0.3, 0.2, 3}, Vec3(0.0), {0, 1, 0}, Angle::fromDegrees(50), 0.05, 100}, kSize);
        std::map<uint32_t, std::vector<int>> linesOfNodes;  // a node's side, its children and what lies in its plane
        for (const Decision& decision : culler->cull(from, Recording::On).log.decisions) {
            const bool drawn = decision.subject.kind == Subject::Kind::Fragment;
            if (decision.line < 2 || (!drawn && decision.subject.kind != Subject::Kind::Node)) continue;
            linesOfNodes[uint32_t(decision.operands[drawn ? 2 : 1])].push_back(decision.line);
        }
        size_t withBoth = 0;
        for (const auto& [node, lines] : linesOfNodes) {
            EXPECT_TRUE(std::ranges::is_sorted(lines)) << order << ", node " << node << ": " << testing::PrintToString(lines);
            withBoth += std::ranges::count(lines, 3) == 1 && std::ranges::count(lines, 5) == 1 ? 1 : 0;
        }
        EXPECT_GT(withBoth, 3u) << order;
    }
}

TEST_F(OrderingShows, partsOfTheQuizAreNamedAndPlacedAsInTheKey) {
    const NamedParts quiz = parts();
    std::vector<std::string> names, places;
    for (const NamedParts::Part& part : quiz.parts) {
        names.push_back(part.name);
        places.push_back(part.place ? quiz.places[*part.place] : "");
    }
    EXPECT_THAT(names, ElementsAre("A1", "A2", "B", "C1", "C2"));
    EXPECT_THAT(places, ElementsAre("C4", "C2", "C1", "C8", "C6"));
    EXPECT_EQ(quiz.places.size(), 8u);
    EXPECT_TRUE(quiz.divides());
    // By a point: A1 is the half of A before P2.
    EXPECT_EQ(quiz.partAt(*scene, scene->firstTriangle(0), Vec3(-1, 0.9, 1.2)), 0u);
    EXPECT_EQ(quiz.partAt(*scene, scene->firstTriangle(0), Vec3(-1, 0.9, -1.2)), 1u);
    EXPECT_NEAR(quiz.middleOf(*scene, 0).z, 0.75, 1e-6);
    EXPECT_NEAR(quiz.middleOf(*scene, 1).z, -0.75, 1e-6);
}

TEST_F(OrderingShows, questionsAboutOrderAndLeafAreAnsweredAsInTheKey) {
    const NamedParts quiz = parts();
    Prediction order{Prediction::Question::Order, Prediction::Items::Parts};
    for (const uint64_t part : {2, 1, 0, 4, 3}) order.toggle(part);  // B, A2, A1, C2, C1
    std::vector<PredictionRow> rows = answerTo(order, *scene, log, quiz);
    EXPECT_EQ(rows.size(), 5u);
    EXPECT_EQ(rightRows(rows), 5u);
    order.toggle(4);
    order.toggle(4);
    EXPECT_EQ(rightRows(answerTo(order, *scene, log, quiz)), 3u) << "C2 named after C1";
    Prediction leaf{Prediction::Question::Place, Prediction::Items::Parts};
    leaf.toggle(2);
    leaf.place(0);
    leaf.toggle(0);
    leaf.place(1);
    leaf.toggle(1);
    rows = answerTo(leaf, *scene, log, quiz);
    EXPECT_THAT(rows, ElementsAre(PredictionRow{0, 1, 3}, PredictionRow{1, std::nullopt, 1}, PredictionRow{2, 0, 0}))
        << "only what was named, by its number";
    leaf.toggle(2);
    EXPECT_THAT(leaf.items, ElementsAre(0, 1));
    EXPECT_THAT(leaf.places, ElementsAre(std::optional<size_t>(1), std::nullopt));
}

TEST_F(OrderingShows, orderOfPartsFollowsTheEye) {
    const NamedParts before = parts();
    View other({{-5, 20, -5}, Vec3(0.0), {0, 1, 0.1}, Angle::fromDegrees(50), 0.05, 100}, kSize);
    const NamedParts after = tree->built()->parts(tree->cull(other, Recording::On).log);
    ASSERT_EQ(before.parts.size(), after.parts.size());
    EXPECT_LT(before.parts[2].drawn.front().first, before.parts[3].drawn.front().first) << "B before C1";
    EXPECT_GT(after.parts[2].drawn.front().first, after.parts[3].drawn.front().first);
    for (size_t i = 0; i < before.parts.size(); ++i) EXPECT_EQ(before.parts[i].place, after.parts[i].place);
}

TEST_F(OrderingShows, objectsThatNothingCutAreOnePart) {
    const CullerPointer painter = strategy("painter");
    painter->build(*scene);
    const NamedParts whole = painter->built()->parts(painter->cull(view, Recording::On).log);
    EXPECT_EQ(whole.parts.size(), 3u);
    EXPECT_FALSE(whole.divides());
    EXPECT_TRUE(whole.places.empty());
    const ScenePointer bars = sceneOf({threeBars()});
    painter->build(*bars);
    const FrameLog cut =
        painter->cull({{{0, 0, 6}, Vec3(0.0), {0, 1, 0}, Angle::fromDegrees(60), 0.1, 100}, kSize}, Recording::On).log;
    const NamedParts pieces = painter->built()->parts(cut);
    EXPECT_TRUE(pieces.divides());
    const auto cuts = std::ranges::find(cut.counters.figures, "cuts", &NamedFigure::name);
    EXPECT_EQ(double(pieces.parts.size()), 6.0 + cuts->value) << "every cut makes one more polygon of six";
    EXPECT_EQ(pieces.parts[0].name, bars->instances()[0].name + "1");
}

TEST_F(OrderingShows, nodesAreNamedAndKnowTheirPlaneAndTheirPolygons) {
    const StructureSnapshot snapshot = tree->snapshot(log);
    ASSERT_EQ(snapshot.nodes.size(), 15u);
    EXPECT_EQ(snapshot.nodes[0].name, "P1");
    std::vector<std::string> leaves;
    for (const SnapshotNode& node : snapshot.nodes)
        if (node.name.front() == 'C') leaves.push_back(node.name);
    std::ranges::sort(leaves);
    EXPECT_THAT(leaves, ElementsAre("C1", "C2", "C3", "C4", "C5", "C6", "C7", "C8"));
    const SubjectShape root = tree->built()->groupShape(snapshot, 0);
    ASSERT_EQ(root.polygons.size(), 1u);
    EXPECT_EQ(root.polygons[0].size(), 4u);
    for (const Vec3& corner : root.polygons[0]) EXPECT_NEAR(corner.x, 0.0, 1e-9) << "P1 within the scene's box";
    EXPECT_TRUE(root.triangles.empty());
    // A1's leaf: found by a point of it, with its triangles and without a plane.
    const std::optional<uint32_t> leaf = tree->built()->groupAt(scene->firstTriangle(0), Vec3(-1, 0.9, 1.2));
    ASSERT_TRUE(leaf);
    EXPECT_EQ(snapshot.nodes[*leaf].name, "C4");
    const SubjectShape shape = tree->built()->groupShape(snapshot, *leaf);
    EXPECT_TRUE(shape.polygons.empty());
    EXPECT_FALSE(shape.triangles.empty());
    for (const auto& corners : shape.triangles)
        for (const Vec3& corner : corners) EXPECT_GE(corner.z, -1e-6);
    EXPECT_EQ(shape.node, leaf);
}

TEST(OrderingGroups, everyPartIsFoundAtTheNodeThatKeepsIt) {
    const ScenePointer scene = hardScene(5);
    const CullerPointer tree = strategy("bsp");
    tree->build(*scene);
    const StructureSnapshot snapshot = tree->snapshot({});
    const View view({{0.3, 0.2, 3}, Vec3(0.0), {0, 1, 0}, Angle::fromDegrees(50), 0.05, 100}, kSize);
    const FrameLog log = tree->cull(view, Recording::On).log;
    for (uint32_t node = 0; node < snapshot.nodes.size(); ++node) {
        const SubjectShape shape = tree->built()->groupShape(snapshot, node);
        ASSERT_FALSE(shape.triangles.empty());
        EXPECT_EQ(snapshot.nodes[node].name, std::to_string(node));
        ASSERT_EQ(shape.polygons.size(), 1u);
    }
    const OwnTriangles& own = *std::get<OwnTrianglesPointer>(log.commands.front());
    std::set<uint32_t> triangles, nodes;
    size_t found = 0;
    for (const Decision& decision : log.decisions) {
        if (decision.subject.kind != Subject::Kind::Fragment) continue;
        const auto node = uint32_t(decision.operands[2]);
        for (uint32_t i = decision.places.first; i < decision.places.first + decision.places.count; ++i) {
            const auto [a, b, c] = worldCorners(own, i, *scene, decision.subject.object);
            // The middle of a sliver may be rounded into its neighbour.
            const double longest = std::max({glm::length(b - a), glm::length(c - b), glm::length(a - c)});
            if (glm::length(glm::cross(b - a, c - a)) < 1e-5 * longest) continue;
            ++found;
            EXPECT_EQ(tree->built()->groupAt(own.triangles[i], (a + b + c) / 3.0), node) << "triangle " << own.triangles[i];
        }
        triangles.insert(decision.subject.number);
        nodes.insert(node);
    }
    EXPECT_EQ(triangles.size(), scene->triangleCount());
    EXPECT_EQ(nodes.size(), snapshot.nodes.size());
    EXPECT_GT(found, own.triangles.size() / 2);
}

TEST_F(OrderingShows, partsAndNodesAreCalledAsInTheTree) {
    const StructureSnapshot snapshot = tree->snapshot(log);
    std::vector<std::string> drawn;
    for (size_t i = 0; i < log.decisions.size(); ++i) {
        const FrameEntry entry{nullptr, &log.decisions[i], i};
        const EntryNames names = entryNames(snapshot, entry);
        if (entry.decision->subject.kind == Subject::Kind::Node) {
            EXPECT_EQ(names.subject, snapshot.nodes[entry.decision->subject.number].name);
        }
        if (entry.decision->subject.kind != Subject::Kind::Fragment) continue;
        const std::string words = names.subject + " in " + names.operands[2];
        if (drawn.empty() || drawn.back() != words) drawn.push_back(words);
        const SubjectShape shape = subjectShape(*scene, log, snapshot, entry);
        EXPECT_EQ(shape.node, uint32_t(entry.decision->operands[2])) << "lit with its node";
        EXPECT_EQ(shape.triangles.size(), entry.decision->places.count);
        EXPECT_TRUE(shape.boxes.empty());
    }
    EXPECT_THAT(drawn, ElementsAre("B in C1", "A2 in C2", "A1 in C4", "C2 in C6", "C1 in C8"));
    const auto sentence = [&](size_t decision) {
        const FrameEntry entry{nullptr, &log.decisions[decision], decision};
        return entryLine(*scene, entry, entryNames(snapshot, entry));
    };
    EXPECT_EQ(sentence(1).substr(0, 9), "Node P1: ");
    EXPECT_NE(sentence(1).find("the plane of node P1"), std::string::npos) << sentence(1);
    EXPECT_EQ(entryLine(*scene, {nullptr, &log.decisions[1], 1}).substr(0, 8), "Node 0: ") << "without names by number";
}

TEST_F(OrderingShows, linesOfATriangleAreThoseOfItsPartsAndTheNodesAroundThem) {
    // The first triangle of B lies in one part, in the leaf behind all planes: its path has the root and two more nodes.
    const ListingState b = *tree->built()->listing(log, scene->firstTriangle(1));
    EXPECT_EQ(b.current, 4) << "drawn where it lies";
    EXPECT_EQ(b.decisions[1], 3u) << "the sides of P1, P2 and P3";
    EXPECT_EQ(b.decisions[2] + b.decisions[4], 3u) << "the ways to its leaf";
    EXPECT_EQ(b.decisions[3], 1u);
    const CullerPointer painter = strategy("painter");
    painter->build(*scene);
    const FrameLog painted = painter->cull(view, Recording::On).log;
    uint64_t sum = 0;
    for (uint64_t triangle = 0; triangle < scene->triangleCount(); ++triangle) {
        const ListingState own = *painter->built()->listing(painted, triangle);
        EXPECT_EQ(own.current, 10) << "drawn at last";
        EXPECT_EQ(own.decisions[1], own.decisions[9]) << "taken once, drawn once";
        sum += own.total();
    }
    EXPECT_EQ(sum, painter->built()->listing(painted)->total() - 1) << "all but the sorting are about one triangle each";
}

TEST(OrderingGroups, groupOfAnOctreeIsItsBox) {
    const ScenePointer scene = openScene("field:mesh=sphere:triangles=80,n=4").scene;
    const CullerPointer octree = makeCuller("frustum-octree");
    octree->build(*scene);
    const View view({{0, 0, 20}, Vec3(0.0), {0, 1, 0}, Angle::fromDegrees(50), 0.05, 100}, kSize);
    const StructureSnapshot snapshot = octree->snapshot(octree->cull(view, Recording::On).log);
    const auto group = std::ranges::find_if(snapshot.nodes, &SnapshotNode::isGroup);
    ASSERT_NE(group, snapshot.nodes.end());
    const SubjectShape shape = octree->built()->groupShape(snapshot, group->number);
    ASSERT_EQ(shape.boxes.size(), 1u);
    EXPECT_EQ(shape.boxes[0].min, group->box.min);
    EXPECT_EQ(shape.node, group->number);
    EXPECT_FALSE(octree->built()->groupAt(0, Vec3(0.0))) << "its groups hold objects";
}

TEST(OrderingFrames, framesOfThePainterStopAtTheNextLook) {
    const ScenePointer scenes[] = {sceneOf({randomTriangles(1, 2'000, 2.0)}), coplanarTriangles(60'000)};
    for (const ScenePointer& scene : scenes) {
        const CullerPointer painter = strategy("painter");
        painter->build(*scene);
        const View view({{0, 0, 6}, Vec3(0.0), {0, 1, 0}, Angle::fromDegrees(60), 0.1, 100}, kSize);
        const StoppedWork stopped = stoppedAfter(50'000, [&](const Progress& progress) {
            FrameContext frame(*scene, view, false);
            frame.stopBy(progress.stop);
            painter->built()->draw(frame, painter->state());
        });
        EXPECT_TRUE(stopped.interrupted);
        EXPECT_LE(stopped.stepsAfter, WorkCheck::kBetween);
    }
}

TEST(OrderingFrames, walksOfTheTreeStopAtTheNextLook) {
    // One tree with a node for nearly every triangle, one with all polygons at one node, one of triangles without area.
    std::vector<Vec3f> flat;
    for (int i = 0; i < 6'000; ++i) flat.insert(flat.end(), {{float(i), 0, 0}, {float(i), 0, 0}, {float(i) + 0.5f, 0, 0}});
    for (const ScenePointer& scene :
         {sceneOf({randomTriangles(1, 4'000, 0.02)}), coplanarTriangles(6'000), sceneOf({soupMesh(std::move(flat))})}) {
        const CullerPointer tree = strategy("bsp");
        tree->build(*scene);
        const View view({{0, 0, 6}, Vec3(0.0), {0, 1, 0}, Angle::fromDegrees(60), 0.1, 100}, kSize);
        for (const uint64_t steps : {1, 3'000}) {
            const StoppedWork stopped = stoppedAfter(steps, [&](const Progress& progress) {
                FrameContext frame(*scene, view, false);
                frame.stopBy(progress.stop);
                tree->built()->draw(frame, tree->state());
            });
            EXPECT_TRUE(stopped.interrupted) << steps;
            EXPECT_LE(stopped.stepsAfter, WorkCheck::kBetween) << steps;
        }
    }
}

TEST(OrderingGroups, leavesCanBeAskedForWithoutGivenPlanes) {
    const ScenePointer scene = openScene("quiz").scene;
    const CullerPointer tree = strategy("bsp", {{"plane", "fewest"}});
    tree->build(*scene);
    const View view{*scene->remarks().camera, kSize};
    const FrameLog log = tree->cull(view, Recording::On).log;
    const NamedParts parts = tree->built()->partsByLeaf(log);
    const StructureSnapshot snapshot = tree->snapshot(log);
    ASSERT_EQ(parts.places.size(), snapshot.nodes.size());
    ASSERT_LE(parts.places.size(), NamedParts::kMostLeaves);
    for (size_t place = 0; place < parts.places.size(); ++place)
        EXPECT_EQ(parts.places[place], snapshot.nodes[place].name) << "as the tree calls it";
    // A part is what one node has of an object: it is drawn with that node.
    std::set<std::pair<uint32_t, size_t>> seen;
    size_t drawn = 0;
    for (const NamedParts::Part& part : parts.parts) {
        ASSERT_TRUE(part.place);
        EXPECT_TRUE(seen.insert({part.object, *part.place}).second) << part.name;
        drawn += part.drawn.size();
        for (const PlaceRun& run : part.drawn) {
            const auto said = std::ranges::find_if(log.decisions, [&](const Decision& decision) {
                return decision.subject.kind == Subject::Kind::Fragment && decision.places == run;
            });
            ASSERT_NE(said, log.decisions.end());
            EXPECT_EQ(size_t(said->operands[2]), *part.place);
            EXPECT_EQ(said->subject.object, part.object);
        }
    }
    EXPECT_EQ(drawn, tree->built()->listing(log)->decisions[3]) << "every part that is drawn";
    EXPECT_GE(parts.parts.size(), 3u);
    EXPECT_TRUE(tree->built()->parts(log).places.empty()) << "an order is asked of what cuts made";
    const ScenePointer large = sceneOf({randomTriangles(1, 300, 0.2)});
    tree->build(*large);
    const NamedParts many = tree->built()->partsByLeaf(tree->cull(view, Recording::On).log);
    EXPECT_TRUE(many.places.empty());
    EXPECT_GT(many.leaves, NamedParts::kMostLeaves);
}

}  // namespace
}  // namespace cullscope::test::ordering_shows_test
