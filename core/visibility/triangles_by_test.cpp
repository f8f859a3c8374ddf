#include "core/visibility/triangles_by_test.h"

#include <array>

#include "core/base/message.h"
#include "core/visibility/left_out_triangles.h"

namespace cullscope {

Show trianglesByTestShow() { return barsShow("triangles-by-test", CULLSCOPE_TR("Triangles by the test that left them out")); }

Bars trianglesByTest(const FrameLog& log, const Scene& scene, const char* hiding) {
    std::array<uint64_t, kCauseCount> culled{};
    std::vector<char> byCells(scene.instances().size(), 0);
    for (const Decision& decision : log.decisions) {
        if (decision.subject.kind == Subject::Kind::Cell) byCells[decision.subject.object] = 1;
        if (decision.outcome == Decision::Outcome::DrawnAfterAll) culled[size_t(decision.cause)] -= decision.places.count;
        if (decision.outcome != Decision::Outcome::Culled) continue;
        uint64_t& count = culled[size_t(decision.cause)];
        if (decision.subject.kind == Subject::Kind::Cell) count += decision.places.count;
        for (const uint32_t instance : log.objectsOf(decision)) count += scene.meshOf(instance).triangleCount();
        // An object whose cells were decided one by one was counted with them.
        if (decision.subject.kind == Subject::Kind::Object && byCells[decision.subject.number] == 0)
            count += scene.meshOf(decision.subject.number).triangleCount();
    }
    std::array<uint64_t, kCauseCount> oneByOne{};
    bool tested = false;
    forEachLeftOut(log, [&](uint32_t /*instance*/, const LeftOutTriangles& triangles) {
        tested = true;
        for (const LeftOutTriangles::Run& run : triangles.runs) oneByOne[size_t(run.cause)] += run.places.count;
    });
    const auto bar = [&](const char* name, Cause cause) { return Bar{name, culled[size_t(cause)], stateOfCause(cause)}; };
    Bars bars{{},
              {bar(CULLSCOPE_TR("planes of the frustum"), Cause::OutsideFrustum),
               bar(CULLSCOPE_TR("normal cones"), Cause::BackFacing), bar(hiding, Cause::Hidden)}};
    if (!tested) return bars;
    const auto single = [&](const char* name, Cause cause) {
        bars.bars.push_back({name, oneByOne[size_t(cause)], stateOfCause(cause)});
    };
    single(CULLSCOPE_TR("facing away, one by one"), Cause::BackFacing);
    single(CULLSCOPE_TR("without a pixel centre"), Cause::NoSample);
    return bars;
}

}  // namespace cullscope
