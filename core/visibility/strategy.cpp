#include "core/visibility/strategy.h"

#include <cassert>

#include "core/base/error.h"
#include "core/visibility/facing.h"

namespace cullscope {
namespace {

using Clock = std::chrono::steady_clock;

double millisecondsSince(Clock::time_point start) {
    return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

/// Sets a strategy's renderer for the duration of one decision, and clears it also after an exception.
class RendererScope {
public:
    RendererScope(Renderer*& place, Renderer* renderer) : m_place(place) { m_place = renderer; }
    ~RendererScope() { m_place = nullptr; }
    RendererScope(const RendererScope&) = delete;
    RendererScope& operator=(const RendererScope&) = delete;

private:
    Renderer*& m_place;
};

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
    m_facing = resolveFacing(m_parameters, scene);
    buildStructures(scene, progress, m_structure);
    m_structure.buildMilliseconds = millisecondsSince(start);
}

std::optional<Message> unavailable(const StrategyInfo& info, const GlInfo& gl) {
    if (info.glRequirement != GlRequirement::CompatibilityProfile || gl.compatibilityProfile) return std::nullopt;
    return Message{
        CULLSCOPE_TR("\"%1\" draws in OpenGL's selection mode, which was removed from the core profile, and this OpenGL "
                     "(%2) gives no compatibility profile: \"frustum-query\" asks the same without it."),
        {info.id, gl.renderer}};
}

void requireAvailable(const StrategyInfo& info, const GlInfo& gl) {
    if (const std::optional<Message> why = unavailable(info, gl)) throwOpenGl(why->text, why->arguments);
}

Renderer& Strategy::renderer() const {
    if (m_renderer == nullptr)
        throwOpenGl(CULLSCOPE_TR("This strategy asks OpenGL what is visible, and there is no OpenGL context here."));
    return *m_renderer;
}

Verdict Strategy::cull(const View& view, Trace* trace, Renderer* renderer) {
    assert(m_scene != nullptr);
    Verdict verdict;
    const RendererScope scope(m_renderer, renderer);
    const Clock::time_point start = Clock::now();
    verdict.drawList.facing = facing();
    decide(view, verdict, trace);
    verdict.consideredTriangles = verdict.drawList.triangleCount();
    verdict.cullMilliseconds = millisecondsSince(start);
    return verdict;
}

}  // namespace cullscope
