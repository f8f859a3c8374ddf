#include "core/visibility/registry.h"

#include "core/base/error.h"
#include "core/visibility/baseline/baselines.h"
#include "core/visibility/frustum/frustum_box_tests.h"
#include "core/visibility/frustum/frustum_culling.h"
#include "core/visibility/frustum/frustum_octree.h"
#include "core/visibility/spherical/lossless_culling.h"
#include "core/visibility/spherical/spherical_culling.h"

namespace cullscope {

const std::vector<RegisteredStrategy>& strategies() {
    static const std::vector<RegisteredStrategy> kStrategies{
        baseline::all(),          baseline::backface(),          frustum::frustum(),
        frustum::frustumOctree(), frustum::frustumSelect(),      frustum::frustumQuery(),
        spherical::spherical(),   spherical::sphericalHorizon(), spherical::sphericalLossless(),
    };
    return kStrategies;
}

const RegisteredStrategy& findStrategy(std::string_view id) {
    std::string known;
    for (const RegisteredStrategy& strategy : strategies()) {
        if (strategy.info.id == id) return strategy;
        known += (known.empty() ? "" : ", ") + strategy.info.id;
    }
    throwUsage(CULLSCOPE_TR("There is no strategy \"%1\". Known: %2."), {std::string(id), known});
}

}  // namespace cullscope
