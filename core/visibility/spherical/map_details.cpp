#include "core/visibility/spherical/map_details.h"

#include <algorithm>

#include "core/base/message.h"

namespace cullscope::spherical {

void MapDetails::prepare(const std::optional<uint32_t>& instance) const {
    if (!maps.empty()) (void)*maps[placeOfMap(maps, instance)].maps;
}

void setMaps(StructureSnapshot& snapshot, std::vector<MapSnapshot> maps) {
    auto details = std::make_shared<MapDetails>();
    details->maps = std::move(maps);
    snapshot.details = std::move(details);
    snapshot.objectSentence = CULLSCOPE_TR("The object \"%1\" is tested as one bounding sphere with %2 triangles.");
}

const std::vector<MapSnapshot>& mapsOf(const StructureSnapshot& snapshot) {
    static const std::vector<MapSnapshot> kNone;
    const auto* details = dynamic_cast<const MapDetails*>(snapshot.details.get());
    return details == nullptr ? kNone : details->maps;
}

const MapSnapshot* mapOf(const StructureSnapshot& snapshot, uint32_t instance) {
    for (const MapSnapshot& map : mapsOf(snapshot))
        if (map.decision.instance == instance) return &map;
    return nullptr;
}

size_t placeOfMap(std::span<const MapSnapshot> maps, const std::optional<uint32_t>& instance) {
    const auto place = [&](const auto& matches) {
        return size_t(std::find_if(maps.begin(), maps.end(), matches) - maps.begin());
    };
    size_t found = maps.size();
    if (instance) found = place([&](const MapSnapshot& map) { return map.decision.instance == *instance; });
    if (found == maps.size())
        found = place([](const MapSnapshot& map) { return map.decision.relation != SphereRelation::Outside; });
    return found == maps.size() ? 0 : found;
}

}  // namespace cullscope::spherical
