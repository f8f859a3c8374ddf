#include "ui/jobs/snapshot_reading.h"

#include <algorithm>

namespace cullscope::ui {

size_t placeOfMap(const StructureSnapshot& snapshot, const std::optional<uint32_t>& instance) {
    const std::vector<spherical::MapSnapshot>& maps = snapshot.maps;
    const auto place = [&](const auto& matches) {
        return size_t(std::find_if(maps.begin(), maps.end(), matches) - maps.begin());
    };
    size_t found = maps.size();
    if (instance) found = place([&](const spherical::MapSnapshot& map) { return map.decision.instance == *instance; });
    if (found == maps.size())
        found =
            place([](const spherical::MapSnapshot& map) { return map.decision.relation != spherical::SphereRelation::Outside; });
    return found == maps.size() ? 0 : found;
}

}  // namespace cullscope::ui
