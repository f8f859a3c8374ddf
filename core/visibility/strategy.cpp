#include "core/visibility/strategy.h"

#include <cassert>

namespace cullscope {
namespace {

using Clock = std::chrono::steady_clock;

double millisecondsSince(Clock::time_point start) {
    return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

}  // namespace

const char* promiseId(Promise promise) {
    switch (promise) {
        case Promise::Exact:
            return "exact";
        case Promise::Conservative:
            return "conservative";
        case Promise::Approximate:
            break;
    }
    return "approximate";
}

void Strategy::build(const Scene& scene, const Progress& progress) {
    m_scene = &scene;
    m_structure = {};
    const Clock::time_point start = Clock::now();
    buildStructures(scene, progress, m_structure);
    m_structure.buildMilliseconds = millisecondsSince(start);
}

Verdict Strategy::cull(const View& view, Trace* trace) {
    assert(m_scene != nullptr);
    Verdict verdict;
    const Clock::time_point start = Clock::now();
    verdict.drawList.facing = facing();
    decide(view, verdict, trace);
    verdict.consideredTriangles = verdict.drawList.triangleCount();
    verdict.cullMilliseconds = millisecondsSince(start);
    return verdict;
}

}  // namespace cullscope
