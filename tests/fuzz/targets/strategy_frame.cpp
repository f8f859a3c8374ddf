#include <algorithm>

#include "core/frame/curve.h"
#include "core/frame/listing.h"
#include "core/frame/named_parts.h"
#include "core/visibility/built_strategy.h"
#include "core/visibility/subject_shape.h"
#include "tests/fuzz/small_scene.h"
#include "tests/fuzz/support.h"
#include "tests/fuzz/targets.h"

namespace cullscope::fuzz {
namespace {

/// A value of a parameter. Whole numbers stay near their least one, as structures grow with them.
ParameterValue valueOf(Values& values, const ParameterDeclaration& declaration) {
    constexpr double kMostAboveLeast = 30.0;
    switch (declaration.type) {
        case ParameterType::Boolean:
            return values.below(2) == 1;
        case ParameterType::Integer: {
            const double range = std::min(declaration.maximum - declaration.minimum, kMostAboveLeast);
            return int64_t(declaration.minimum) + int64_t(values.below(size_t(range) + 1));
        }
        case ParameterType::Real:
            return values.between(declaration.minimum, declaration.maximum);
        case ParameterType::File:
            return std::string();  // a file's readers have targets of their own
        case ParameterType::Choice:
            break;
    }
    return declaration.choices[values.below(declaration.choices.size())].id;
}

void requireWithinScene(const FrameLog& log, const Scene& scene) {
    const DrawList drawn = drawnTriangles(scene, log);
    for (const DrawRange& range : drawn.ranges) {
        require(range.instance < scene.instances().size(), "a range is of no instance");
        const TriangleOrder::OfMesh order = drawn.orderOf(scene.instances()[range.instance].mesh);
        const size_t indices = order.indices.empty() ? scene.meshOf(range.instance).indices().size() : order.indices.size();
        require(size_t(range.firstIndex) + range.indexCount <= indices, "a range exceeds its mesh");
    }
}

/// What panels show of a recorded frame.
void readFrame(const BuiltStrategy& built, const FrameLog& log) {
    const StructureSnapshot snapshot = built.snapshot(log);
    for (const SnapshotNode& node : snapshot.nodes)
        if (node.instance == SnapshotNode::kGroup) (void)built.groupShape(snapshot, node.number);
    (void)built.parts(log);
    (void)built.partsByLeaf(log);
    (void)built.bars(log);
    (void)built.listing(log);
    (void)built.frameLine(log);
    for (const Show& show : built.info().shows) {
        (void)built.curve(show.id, log, {}, {});
        (void)built.whyNotShown(show.id, {}, log);
    }
}

}  // namespace

void strategy_frame(std::string_view input) {
    constexpr size_t kMostChanged = 4;
    Values values(input);
    const RegisteredStrategy& strategy = strategies()[values.below(strategies().size())];
    ParameterSet parameters(strategy.info.parameters);
    const std::vector<ParameterDeclaration>& declared = strategy.info.parameters;
    for (size_t changed = declared.empty() ? 0 : values.below(kMostChanged); changed > 0; --changed) {
        const ParameterDeclaration& declaration = declared[values.below(declared.size())];
        parameters.set(declaration.key, valueOf(values, declaration));
    }
    // Cuts of triangles are many times as many as these before a strategy gives up.
    for (const ParameterDeclaration& declaration : declared)
        if (declaration.key == "limit") parameters.set("limit", int64_t{500});
    const ScenePointer scene = sceneOf(values);
    if (!scene) return;
    StructureStore store;
    BuiltStrategyPointer built;
    if (!accepted({ErrorKind::Usage}, [&] { built = buildStrategy(strategy, parameters, scene, store); })) return;
    (void)built->meshStates();
    if (strategy.info.glRequirement != GlRequirement::None) return;
    const ViewStatePointer state = built->begin();
    for (size_t frames = 1 + values.below(3); frames > 0; --frames) {
        const bool recording = values.below(2) == 1;
        const std::optional<View> view = viewOf(values, *scene);
        if (!view) continue;
        // Of some strategies one choice of a parameter asks OpenGL, and there is none here.
        accepted({ErrorKind::Usage, ErrorKind::OpenGl}, [&] {
            const FrameLog log = built->decide(*view, *state, recording);
            requireWithinScene(log, *scene);
            (void)built->promiseAt(*view);
            if (recording) readFrame(*built, log);
        });
    }
}

}  // namespace cullscope::fuzz
