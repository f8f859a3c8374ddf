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
        {baseline::allInfo(), baseline::makeAll},
        {baseline::backfaceInfo(), baseline::makeBackface},
        {frustum::frustumInfo(), frustum::makeFrustum},
        {frustum::frustumOctreeInfo(), frustum::makeFrustumOctree},
        {frustum::frustumSelectInfo(), frustum::makeFrustumSelect},
        {frustum::frustumQueryInfo(), frustum::makeFrustumQuery},
        {spherical::sphericalInfo(), spherical::makeSpherical},
        {spherical::sphericalHorizonInfo(), spherical::makeSphericalHorizon},
        {spherical::sphericalLosslessInfo(), spherical::makeSphericalLossless},
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

StrategyPointer makeStrategy(std::string_view id) {
    const RegisteredStrategy& found = findStrategy(id);
    return found.make(ParameterSet(found.info.parameters));
}

StrategyPointer makeStrategy(std::string_view id, ParameterSet parameters) {
    return findStrategy(id).make(std::move(parameters));
}

}  // namespace cullscope
