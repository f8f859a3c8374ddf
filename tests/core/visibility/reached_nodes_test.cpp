// Which nodes of a tree the first entries of a frame have reached.
#include <gtest/gtest.h>

#include "core/scene/scene_source.h"
#include "core/visibility/registry.h"
#include "core/visibility/structure_snapshot.h"
#include "tests/support/culler.h"
#include "tests/support/gl_environment.h"
#include "tests/support/test_scenes.h"

namespace cullscope::test::reached_nodes_test {
namespace {

size_t reachedIn(const StructureSnapshot& snapshot) {
    return size_t(std::ranges::count(snapshot.nodes, true, &SnapshotNode::reached));
}

TEST(ReachedNodes, growWithTheStepsUntilTheWholeFrameHasAll) {
    const ScenePointer scene = openScene("layers:count=8,triangles=50").scene;
    const View view({{0, 0, 20}, Vec3(0.0), {0, 1, 0}, Angle::fromDegrees(45), 0.1, 100}, {80, 60});
    size_t trees = 0;
    for (const RegisteredStrategy& registered : strategies()) {
        if (registered.info.first(Show::Kind::Tree) == nullptr || unavailable(registered.info, GlEnvironment::info())) continue;
        SCOPED_TRACE(registered.info.id);
        const CullerPointer culler = makeCuller(registered.info.id.c_str());
        culler->build(*scene);
        const Culled frame = culler->cull(view, Recording::On, &GlEnvironment::renderer());
        const StructureSnapshot whole = culler->snapshot(frame.log);
        if (whole.nodes.empty()) continue;
        ++trees;
        EXPECT_EQ(reachedIn(whole), whole.nodes.size());
        EXPECT_EQ(reachedIn(culler->snapshot(frame.log.upTo(0))), 0u) << "before the first step";
        size_t before = 0;
        for (size_t k = 0; k < frame.log.entries(); k += 1 + frame.log.entries() / 40) {
            const StructureSnapshot part = culler->snapshot(frame.log.upTo(k));
            const size_t reached = reachedIn(part);
            EXPECT_GE(reached, before) << "step " << k;
            before = reached;
            for (const SnapshotNode& node : part.nodes)
                if (node.reached && node.parent >= 0)
                    EXPECT_TRUE(part.nodes[size_t(node.parent)].reached) << "what it lies in, step " << k;
        }
    }
    EXPECT_GE(trees, 5u);
}

}  // namespace
}  // namespace cullscope::test::reached_nodes_test
