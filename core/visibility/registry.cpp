#include "core/visibility/registry.h"

#include <algorithm>

#include "core/base/error.h"
#include "core/visibility/baseline/baselines.h"
#include "core/visibility/baseline/oracle.h"
#include "core/visibility/baseline/recorded.h"
#include "core/visibility/distance/draw_distance.h"
#include "core/visibility/frustum/frustum_box_tests.h"
#include "core/visibility/frustum/frustum_culling.h"
#include "core/visibility/frustum/frustum_octree.h"
#include "core/visibility/occlusion/buffer_occlusion.h"
#include "core/visibility/occlusion/clusters.h"
#include "core/visibility/occlusion/occlusion_chc.h"
#include "core/visibility/occlusion/occlusion_hiz.h"
#include "core/visibility/occlusion/octree_query.h"
#include "core/visibility/occlusion/pvs.h"
#include "core/visibility/ordering/ordering.h"
#include "core/visibility/small_feature/level_of_detail.h"
#include "core/visibility/small_feature/small_feature.h"
#include "core/visibility/small_feature/small_feature_bounded.h"
#include "core/visibility/small_feature/small_feature_triangle.h"
#include "core/visibility/software/software_raster.h"
#include "core/visibility/spherical/lossless_culling.h"
#include "core/visibility/spherical/spherical_culling.h"
#include "core/visibility/spherical/spherical_horizon.h"

namespace cullscope {

const std::vector<RegisteredStrategy>& strategies() {
    // A line for each.
    // clang-format off
    static const std::vector<RegisteredStrategy> kStrategies{
        baseline::all(),
        baseline::backface(),
        baseline::oracle(),
        frustum::frustum(),
        frustum::frustumOctree(),
        frustum::frustumSelect(),
        frustum::frustumQuery(),
        spherical::spherical(),
        spherical::sphericalHorizon(),
        spherical::sphericalLossless(),
        software::depthBuffer(),
        software::scanLine(),
        occlusion::occlusionDepth(),
        occlusion::occlusionMasked(),
        occlusion::octreeQuery(),
        occlusion::occlusionChc(),
        occlusion::occlusionHiz(),
        occlusion::clusters(),
        occlusion::pvs(),
        ordering::painter(),
        ordering::bsp(),
        small_feature::smallFeature(),
        small_feature::smallFeatureTriangle(),
        small_feature::smallFeatureBounded(),
        small_feature::levelOfDetail(),
        distance::drawDistance(),
        baseline::recorded(),
    };
    // clang-format on
    return kStrategies;
}

const StrategyInfo& baselineOf(BaselineRole role) {
    return std::ranges::find(strategies(), role, [](const RegisteredStrategy& strategy) { return strategy.info.baseline; })->info;
}

const StrategyInfo& limitOfCulling() {
    return std::ranges::find_if(strategies(), [](const RegisteredStrategy& strategy) { return strategy.info.limit; })->info;
}

std::vector<const StrategyInfo*> baselines() {
    std::vector<const StrategyInfo*> result;
    for (const RegisteredStrategy& strategy : strategies())
        if (strategy.info.baseline != BaselineRole::None) result.push_back(&strategy.info);
    return result;
}

const std::vector<const Show*>& declaredShows() {
    static const std::vector<const Show*> kShows = [] {
        std::vector<const Show*> shows;
        for (const RegisteredStrategy& strategy : strategies())
            for (const Show& show : strategy.info.shows) {
                const auto known = std::ranges::find_if(shows, [&](const Show* other) { return other->id == show.id; });
                if (known == shows.end())
                    shows.push_back(&show);
                else if (show.colourings.size() > (*known)->colourings.size())
                    *known = &show;
            }
        return shows;
    }();
    return kShows;
}

std::vector<const Show*> declaredShows(Show::Kind kind) {
    std::vector<const Show*> result;
    std::ranges::copy_if(declaredShows(), std::back_inserter(result), [&](const Show* show) { return show->kind == kind; });
    return result;
}

const std::vector<const Show*>& pictureShows() {
    static const std::vector<const Show*> kShows = [] {
        std::vector<const Show*> shows;
        for (const Show& show : commonShows()) shows.push_back(&show);
        const std::vector<const Show*> declared = declaredShows(Show::Kind::Overlay);
        shows.insert(shows.end() - 1, declared.begin(), declared.end());
        return shows;
    }();
    return kShows;
}

const std::vector<const Show*>& namedShows() {
    static const std::vector<const Show*> kShows = [] {
        std::vector<const Show*> shows = pictureShows();
        std::ranges::stable_sort(shows, {}, &Show::kind);
        return shows;
    }();
    return kShows;
}

std::string strategiesShowing(std::string_view id, std::string_view colouring) {
    std::string result;
    for (const RegisteredStrategy& strategy : strategies()) {
        const Show* show = strategy.info.show(id);
        if (show == nullptr) continue;
        const bool has = colouring.empty() ||
                         std::ranges::any_of(show->colourings, [&](const ShowColouring& one) { return one.id == colouring; });
        if (has) result += (result.empty() ? "" : ", ") + strategy.info.id;
    }
    return result;
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
