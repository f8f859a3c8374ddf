#include "core/visibility/strategy.h"

#include "core/base/error.h"
#include "core/visibility/facing.h"

namespace cullscope {

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

Facing Strategy::facing(const Scene& scene, const ParameterSet& parameters) const { return resolveFacing(parameters, scene); }

}  // namespace cullscope
