#include "ui/jobs/inside_reading.h"

#include <algorithm>

namespace cullscope::ui {

size_t placeOfMap(const Inside& inside, const std::optional<uint32_t>& instance) {
    const std::vector<InsideMap>& maps = inside.maps;
    const auto place = [&](const auto& matches) {
        return size_t(std::find_if(maps.begin(), maps.end(), matches) - maps.begin());
    };
    size_t found = maps.size();
    if (instance) found = place([&](const InsideMap& map) { return map.decision.instance == *instance; });
    if (found == maps.size())
        found = place([](const InsideMap& map) { return map.decision.relation != SphereRelation::Outside; });
    return found == maps.size() ? 0 : found;
}

}  // namespace cullscope::ui
