// Listings and counts: what strategies declare, and what a recorded frame says of them.

#include "core/frame/listing.h"

#include <map>

#include "core/mesh/parametric.h"
#include "core/spatial/instance_octree.h"
#include "tests/support/culler.h"
#include "tests/support/decisions.h"
#include "tests/support/every_second_object.h"
#include "tests/support/gl_environment.h"
#include "tests/support/long_mode.h"
#include "tests/support/test_scenes.h"

namespace cullscope::test::listings_test {
namespace {

/// Rows of stars before and behind the eye of `ahead`; those of every third row have triangles enough for cells.
ScenePointer rows(size_t manyTriangles = 2500) {
    std::vector<MeshPointer> meshes;
    std::vector<Mat4> places;
    for (int z = 0; z < 6; ++z)
        for (int x = -4; x <= 4; ++x) {
            meshes.push_back(starMesh(uint64_t(x + 5), z % 3 == 0 ? manyTriangles : 100));
            places.push_back(translation({4.0 * x, 0.3 * x, 12.0 - 6.0 * z}));
        }
    return sceneOf(std::move(meshes), places);
}

// A picture with few rows has a short log where each span of a row is a step.
View ahead() {
    const Viewport size = fewSamples() ? Viewport{40, 30} : Viewport{80, 60};
    return {{Vec3(0.0), {0.2, 0.1, -1}, {0, 1, 0}, Angle::fromDegrees(40), 0.5, 60}, size};
}

Culled recorded(Culler& culler) { return culler.cull(ahead(), Recording::On, &GlEnvironment::renderer()); }

std::map<std::string, CullerPointer> withListings(const Scene& scene) {
    const EverySecondObject sets(scene);
    std::map<std::string, CullerPointer> cullers;
    for (const RegisteredStrategy& strategy : strategies()) {
        if (strategy.info.first(Show::Kind::Listing) == nullptr || unavailable(strategy.info, GlEnvironment::info())) continue;
        cullers[strategy.info.id] = makeCuller(strategy.info.id, sets.parametersOf(strategy.info));
        cullers[strategy.info.id]->build(scene);
    }
    return cullers;
}

const std::vector<ListingLine>& linesOf(const Culler& culler) { return culler.built()->info().first(Show::Kind::Listing)->lines; }

TEST(Listings, areShortAndStrategiesWithoutOneNameNoLines) {
    const ScenePointer scene = rows();
    for (const RegisteredStrategy& strategy : strategies()) {
        SCOPED_TRACE(strategy.info.id);
        EXPECT_LE(std::ranges::count(strategy.info.shows, Show::Kind::Listing, &Show::kind), 1);
        const Show* show = strategy.info.first(Show::Kind::Listing);
        if (show != nullptr) {
            EXPECT_LE(show->lines.size(), kMostListingLines);
            for (const ListingLine& line : show->lines) EXPECT_LE(line.text.size() + 2u * line.indentation, 40u) << line.text;
            continue;
        }
        if (unavailable(strategy.info, GlEnvironment::info())) continue;
        Culler culler(strategy);
        culler.build(*scene);
        const Culled frame = recorded(culler);
        for (const Decision& decision : frame.log.decisions) EXPECT_EQ(decision.line, 0);
        EXPECT_FALSE(culler.built()->listing(frame.log));
    }
}

TEST(Listings, stateIsThatOfTheDecisionsSoFar) {
    const ScenePointer scene = rows(fewSamples() ? 1000 : 2500);
    for (const auto& [id, culler] : withListings(*scene)) {
        SCOPED_TRACE(id);
        const FrameLog log = recorded(*culler).log;
        const size_t lines = linesOf(*culler).size();
        std::vector<uint64_t> counts(lines, 0);
        uint8_t current = 0;
        size_t decisions = 0, named = 0;
        const size_t step = std::max<size_t>(log.entries() / howMany(40, 20), 1);
        for (size_t k = 0; k <= log.entries(); k += k < log.entries() ? std::min(step, log.entries() - k) : 1) {
            const FrameLog part = log.upTo(k);
            for (; decisions < part.decisions.size(); ++decisions) {
                const uint8_t line = log.decisions[decisions].line;
                ASSERT_LE(line, lines);
                if (line == 0) continue;
                ++counts[line - 1];
                ++named;
                current = line;
            }
            const std::optional<ListingState> state = culler->built()->listing(part);
            ASSERT_TRUE(state);
            EXPECT_EQ(*state, (ListingState{counts, current})) << "after " << k;
            EXPECT_EQ(state->total(), named);
        }
        EXPECT_GE(named, scene->instances().size()) << "decisions fall at lines";
    }
}

TEST(Listings, frustumTestsThenLeavesOutOrDraws) {
    const ScenePointer scene = rows();
    const CullerPointer frustum = makeCuller("frustum");
    frustum->build(*scene);
    const FrameLog log = recorded(*frustum).log;
    const auto count = [&](Decision::Outcome outcome) {
        return uint64_t(std::ranges::count(log.decisions, outcome, &Decision::outcome));
    };
    using enum Decision::Outcome;
    const auto isOutside = [](const Decision& test) { return test.outcome == Open && test.containment == Containment::Outside; };
    const auto beyond = uint64_t(std::ranges::count_if(log.decisions, isOutside));
    EXPECT_EQ(frustum->built()->listing(log)->decisions,
              (std::vector<uint64_t>{0, 0, count(Open) - beyond, beyond, 0, count(Culled), count(Drawn)}));
    EXPECT_GT(count(Culled), 5u);
    EXPECT_GT(count(Drawn), 5u);
    for (uint32_t i = 0; i < scene->instances().size(); ++i) {
        uint64_t tests = 0, outside = 0;
        bool culled = false;
        for (const Decision& decision : log.decisions) {
            if (!(decision.subject == Subject::ofObject(i))) continue;
            tests += decision.outcome == Open && !isOutside(decision) ? 1 : 0;
            outside += isOutside(decision) ? 1 : 0;
            culled = culled || decision.outcome == Culled;
        }
        const ListingState about = *frustum->built()->listing(log, scene->firstTriangle(i) + 7);
        EXPECT_EQ(about, (ListingState{{0, 0, tests, outside, 0, culled ? 1u : 0u, culled ? 0u : 1u}, uint8_t(culled ? 6 : 7)}))
            << i;
    }
}

TEST(Listings, ofATriangleHaveTheDecisionsAboutTheGroupsAroundItsObject) {
    const ScenePointer scene = rows();
    const InstanceOctree octree(*scene);
    const CullerPointer groups = makeCuller("frustum-octree");
    groups->build(*scene);
    const FrameLog log = recorded(*groups).log;
    size_t byGroup = 0;
    for (uint32_t i = 0; i < scene->instances().size(); ++i) {
        std::vector<uint64_t> counts(linesOf(*groups).size(), 0);
        uint8_t last = 0;
        for (const Decision& decision : log.decisions) {
            const bool node = decision.subject.kind == Subject::Kind::Node;
            const auto objects = octree.instancesOf(octree.nodes()[node ? decision.subject.number : 0]);
            const bool about = node ? std::ranges::find(objects, i) != objects.end() : decision.subject.number == i;
            if (!about) continue;
            ++counts[decision.line - 1];
            last = decision.line;
        }
        const ListingState state = *groups->built()->listing(log, scene->firstTriangle(i));
        EXPECT_EQ(state, (ListingState{counts, last})) << i;
        byGroup += state.current == 4 ? 1 : 0;
    }
    EXPECT_GT(byGroup, 2u) << "groups that are left out as a whole";
}

TEST(Listings, ofATriangleEndAtTheLineThatDecidedItsCell) {
    const ScenePointer scene = rows();
    ParameterSet parameters(findStrategy("spherical-lossless").info.parameters);
    parameters.setFromText("facing", "front");
    Culler lossless(findStrategy("spherical-lossless"), parameters);
    lossless.build(*scene);
    const Culled frame = recorded(lossless);
    std::vector<bool> given(scene->triangleCount(), false);
    for (const DrawRange& range : frame.drawList.ranges)
        for (uint64_t place = range.firstIndex / 3; place < (range.firstIndex + range.indexCount) / 3; ++place)
            given[scene->firstTriangle(range.instance) +
                  frame.drawList.triangleAt(scene->instances()[range.instance].mesh, place)] = true;
    const TriangleStates states = triangleStates(*scene, frame.log, std::nullopt);
    std::map<uint8_t, size_t> ends;
    size_t left = 0;  // one by one
    for (uint64_t triangle = 0; triangle < scene->triangleCount(); triangle += 61) {
        const uint8_t line = lossless.built()->listing(frame.log, triangle)->current;
        ++ends[line];
        const bool decided = line != 10;  // at the last line some are left out, others drawn
        if (decided) EXPECT_EQ(given[triangle], line == 3 || line == 9) << triangle << " at line " << int(line);
        if (given[triangle] || !decided) {
            left += given[triangle] ? 0 : 1;
            continue;
        }
        const TriangleState state = states.states[triangle];
        EXPECT_EQ(state == TriangleState::BackFacing, line == 7) << triangle;
        EXPECT_EQ(state == TriangleState::Hidden, line == 8) << triangle;
        EXPECT_EQ(state == TriangleState::OutsideFrustum, line == 2 || line == 4 || line == 6) << triangle;
    }
    for (const uint8_t line : {2, 3, 6, 7, 10}) EXPECT_GT(ends[line], 0u) << "line " << int(line);
    EXPECT_GT(left, 0u);
}

TEST(Counts, ofObjectsByPlaneAreThoseOfTheDecisions) {
    const ScenePointer scene = rows();
    for (const char* id : {"frustum", "frustum-octree"}) {
        SCOPED_TRACE(id);
        const CullerPointer culler = makeCuller(id);
        culler->build(*scene);
        const Culled frame = recorded(*culler);
        const std::vector<Bars> bars = culler->built()->bars(frame.log);
        ASSERT_EQ(bars.size(), 1u);
        EXPECT_EQ(bars.front().title, "Objects by the plane that rejected them");
        std::vector<uint64_t> counts(bars.front().bars.size(), 0);
        std::map<uint32_t, std::optional<FrustumPlane>> rejections;  // of objects and groups
        for (const Decision& decision : frame.log.decisions) {
            const bool rejects = decision.outcome == Decision::Outcome::Open && decision.containment == Containment::Outside;
            if (!rejects) continue;
            // Of several planes the first: a batch goes on with an object that is outside, for others of it are not.
            const bool node = decision.subject.object == Subject::kNoObject;
            const auto [found, first] = rejections.try_emplace(decision.subject.number + (node ? 1'000'000 : 0), decision.plane);
            if (!first && (node || decision.plane < found->second)) found->second = decision.plane;
        }
        uint64_t culled = 0;
        for (const Decision& decision : frame.log.decisions) {
            if (decision.outcome != Decision::Outcome::Culled) continue;
            const bool node = decision.subject.kind == Subject::Kind::Node;
            const auto plane = rejections.at(decision.subject.number + (node ? 1'000'000 : 0));
            const uint64_t objects = node ? decision.objectCount : 1;
            counts[plane ? size_t(*plane) : 6] += objects;
            culled += objects;
        }
        for (size_t bar = 0; bar < counts.size(); ++bar)
            EXPECT_EQ(bars.front().bars[bar].value, counts[bar]) << bars.front().bars[bar].name;
        EXPECT_GT(culled, 10u);
        const Bars before = culler->built()->bars(frame.log.upTo(0)).front();
        for (const Bar& none : before.bars) EXPECT_EQ(none.value, 0u) << none.name;
    }
}

TEST(Counts, ofTrianglesByTestAreThoseOfTheFramesCounters) {
    const ScenePointer scene = rows();
    ParameterSet parameters(findStrategy("spherical-lossless").info.parameters);
    parameters.setFromText("facing", "front");
    Culler lossless(findStrategy("spherical-lossless"), parameters);
    lossless.build(*scene);
    const Culled frame = recorded(lossless);
    const std::vector<Bars> bars = lossless.built()->bars(frame.log);
    ASSERT_EQ(bars.size(), 1u);
    constexpr std::array kCauses{Cause::OutsideFrustum, Cause::BackFacing, Cause::Hidden};
    ASSERT_EQ(bars.front().bars.size(), kCauses.size() + 2) << "and two of triangles that were tested one by one";
    const uint64_t away = bars.front().bars[3].value, without = bars.front().bars[4].value;
    EXPECT_EQ(away + without, frame.parts[3].culledTriangles);
    EXPECT_EQ(without, frame.culledTriangles[size_t(Cause::NoSample)]);
    for (size_t i = 0; i < kCauses.size(); ++i) {
        const uint64_t alone = kCauses[i] == Cause::BackFacing ? away : 0;
        EXPECT_EQ(bars.front().bars[i].value + alone, frame.culledTriangles[size_t(kCauses[i])]) << bars.front().bars[i].name;
        EXPECT_EQ(bars.front().bars[i].colour, stateOfCause(kCauses[i]));
    }
    EXPECT_GT(bars.front().bars[0].value, 1000u);
    EXPECT_GT(bars.front().bars[1].value, 100u);
}

}  // namespace
}  // namespace cullscope::test::listings_test
