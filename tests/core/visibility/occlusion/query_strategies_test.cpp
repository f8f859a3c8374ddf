// What holds of every strategy that asks OpenGL about the groups of an octree.

#include <map>

#include "core/spatial/instance_octree.h"
#include "tests/support/gl_environment.h"
#include "tests/support/stopped_work.h"
#include "tests/support/wall_scene.h"

namespace cullscope::test::query_strategies_test {
namespace {

using Settings = std::map<std::string, std::string>;

constexpr const char* kStrategies[] = {"octree-query", "occlusion-chc"};

CullerPointer cullerOf(const std::string& id, const Settings& settings) {
    ParameterSet parameters(findStrategy(id).info.parameters);
    for (const auto& [key, value] : settings) parameters.setFromText(key, value);
    return makeCuller(id, parameters);
}

View standardView() { return {{Vec3(0.0), Vec3(0, 0, -1), Vec3(0, 1, 0), Angle::fromDegrees(90), 0.1, 100}, {100, 100}}; }

Culled frameOf(Culler& culler, const View& view, Recording recording = Recording::On) {
    return culler.cull(view, recording, &GlEnvironment::renderer());
}

TEST(QueryStrategies, copiesOfAMemoryDecideTheSame) {
    for (const char* id : kStrategies) {
        SCOPED_TRACE(id);
        const ScenePointer scene = wallBeforeSpheres();
        const SceneBuffers buffers(scene, Upload::Vbo);
        const CullerPointer culler = cullerOf(id, {{"latency", "1"}});
        culler->build(*scene);
        (void)frameOf(*culler, standardView());
        std::vector<uint64_t> counts;
        const View view = standardView();
        for (int i = 0; i < 3; ++i) {
            const ViewStatePointer copy = culler->state().clone();
            GpuFrame frame(GlEnvironment::renderer(), buffers, view);
            culler->built()->draw(frame, *copy);
            counts.push_back(frame.take().consideredTriangles());
        }
        EXPECT_EQ(counts, std::vector<uint64_t>(3, counts[0]));
        EXPECT_LT(counts[0], scene->triangleCount() / 2);
    }
}

TEST(QueryStrategies, answersOfAnotherRendererThatIsGoneCountAsVisible) {
    for (const char* id : kStrategies) {
        SCOPED_TRACE(id);
        const ScenePointer scene = wallBeforeSpheres();
        const CullerPointer culler = cullerOf(id, {{"latency", "1"}});
        culler->build(*scene);
        {
            Renderer other;
            (void)culler->cull(standardView(), &other);
            EXPECT_GT(culler->cull(standardView(), &other).culledTriangles[size_t(Cause::Hidden)], 0u);
        }
        EXPECT_EQ(frameOf(*culler, standardView()).culledTriangles[size_t(Cause::Hidden)], 0u);
    }
}

TEST(QueryStrategies, needsOpenGl) {
    for (const char* id : kStrategies) {
        SCOPED_TRACE(id);
        const ScenePointer scene = wallBeforeSpheres();
        for (const char* latency : {"0", "1"}) {
            const CullerPointer culler = cullerOf(id, {{"latency", latency}});
            culler->build(*scene);
            EXPECT_THROW((void)culler->cull(standardView()), Error);
        }
    }
}

TEST(QueryStrategies, decisionsNestAndNameEveryObjectOnce) {
    for (const char* id : kStrategies) {
        SCOPED_TRACE(id);
        const ScenePointer scene = wallBeforeSpheres();
        for (const char* leaf : {"1", "3"})
            for (const char* batch : {"1", "3", "64"})
                for (const char* latency : {"0", "1"}) {
                    SCOPED_TRACE(std::string(leaf) + " " + batch + " " + latency);
                    const InstanceOctree octree(*scene, uint32_t(std::stoi(leaf)));
                    const CullerPointer culler = cullerOf(id, {{"batch", batch}, {"latency", latency}, {"leaf", leaf}});
                    culler->build(*scene);
                    (void)frameOf(*culler, standardView());
                    const Culled frame = frameOf(*culler, standardView());
                    const size_t lines = culler->built()->info().first(Show::Kind::Listing)->lines.size();
                    std::vector<int> ends(scene->instances().size(), 0);
                    for (const Decision& decision : frame.log.decisions) {
                        ASSERT_TRUE(decision.line >= 1 && decision.line <= lines);
                        const bool node = decision.subject.kind == Subject::Kind::Node;
                        if (node) {
                            EXPECT_EQ(decision.nesting, octree.nodes()[decision.subject.number].depth);
                        }
                        if (decision.outcome == Decision::Outcome::Open) continue;
                        if (!node) ++ends[decision.subject.number];
                        for (const uint32_t instance : frame.log.objectsOf(decision)) ++ends[instance];
                    }
                    EXPECT_THAT(ends, testing::Each(1));
                    // The listing of a triangle has what was said of all groups around its object.
                    for (uint32_t i = 0; i < scene->instances().size(); ++i) {
                        std::vector<uint64_t> counts(lines, 0);
                        for (const Decision& decision : frame.log.decisions) {
                            const bool node = decision.subject.kind == Subject::Kind::Node;
                            const auto objects = octree.instancesOf(octree.nodes()[node ? decision.subject.number : 0]);
                            const bool about =
                                node ? std::ranges::find(objects, i) != objects.end() : decision.subject.number == i;
                            if (about) ++counts[decision.line - 1];
                        }
                        EXPECT_EQ(culler->built()->listing(frame.log, scene->firstTriangle(i))->decisions, counts) << i;
                    }
                }
    }
}

TEST(QueryStrategies, stopsAtTheNextLookAndThenRemembersWhatItDidBefore) {
    for (const char* id : kStrategies) {
        SCOPED_TRACE(id);
        const ScenePointer scene = boxesBehindHalfAWall();
        const SceneBuffers buffers(scene, Upload::Vbo);
        for (const char* latency : {"0", "1"}) {
            SCOPED_TRACE(latency);
            Settings settings{{"latency", latency}};
            // So many boxes are asked about that a frame takes long.
            if (std::string(id) == "occlusion-chc") settings["retest"] = "1";
            const CullerPointer culler = cullerOf(id, settings), other = cullerOf(id, settings);
            for (Culler* one : {culler.get(), other.get()}) {
                one->build(*scene);
                for (int i = 0; i < 2; ++i) (void)frameOf(*one, standardView(), Recording::Off);
            }
            for (const uint64_t steps : {1, 5'000, 10'000}) {
                const StoppedWork stopped = stoppedAfter(steps, [&](const Progress& progress) {
                    const View view = standardView();
                    GpuFrame frame(GlEnvironment::renderer(), buffers, view);
                    frame.stopBy(progress.stop);
                    culler->built()->draw(frame, culler->state());
                });
                EXPECT_TRUE(stopped.interrupted) << steps;
                EXPECT_LE(stopped.stepsAfter, WorkCheck::kBetween) << steps;
            }
            // The frames that were stopped asked questions; no later frame takes their answers for those of a whole one.
            const WatchedWork watched;
            const Culled frame = frameOf(*culler, standardView(), Recording::Off);
            EXPECT_GE(double(watched.steps() + WorkCheck::kBetween), 64.0 * figure(frame, "queries")) << "a question takes long";
            const Culled expected = frameOf(*other, standardView(), Recording::Off);
            EXPECT_EQ(drawn(frame), drawn(expected));
            EXPECT_GT(frame.culledTriangles[size_t(Cause::Hidden)], 0u);
            EXPECT_EQ(frame.culledTriangles, expected.culledTriangles);
            EXPECT_EQ(figure(frame, "queries"), figure(expected, "queries"));
        }
    }
}

}  // namespace
}  // namespace cullscope::test::query_strategies_test
