#pragma once

#include "core/scene/plant/equipment.h"
#include "core/scene/plant/pipe_fittings.h"

namespace cullscope::plant {

/// Room for a pipeline along a rack.
struct Lane {
    uint32_t tier = 0;
    double y = 0.0;
    bool taken = false;
};
/// All lanes of a unit's rack: narrow ones on the lower tiers, wide ones on the top.
[[nodiscard]] std::vector<Lane> lanesOfRack();

/// Lays a pipeline from one nozzle over the rack to another, in a lane that is free, which it takes. `corner`: of the rack. The
/// size, and what is built in on the way, are drawn from `random`.
void addPipeline(PipeFitter& fitter, Random& random, const Vec3& corner, const Nozzle& from, const Nozzle& to,
                 std::vector<Lane>& lanes);

}  // namespace cullscope::plant
