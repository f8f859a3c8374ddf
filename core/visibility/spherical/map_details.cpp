#include "core/visibility/spherical/map_details.h"

#include <algorithm>

#include "core/base/message.h"
#include "core/visibility/spherical/subject_places.h"

namespace cullscope::spherical {

void setMaps(StructureSnapshot& snapshot, std::vector<MapSnapshot> maps) {
    auto details = std::make_shared<MapDetails>();
    details->maps = std::move(maps);
    snapshot.places = placesOnMaps(details);
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

namespace {

/// `decisionOf` gives the decision of one of the items.
template <typename Item, typename DecisionOf>
size_t placeOf(std::span<const Item> items, const std::optional<uint32_t>& instance, const DecisionOf& decisionOf) {
    const auto place = [&](const auto& matches) {
        const auto found = std::ranges::find_if(items, [&](const Item& item) { return matches(decisionOf(item)); });
        return size_t(found - items.begin());
    };
    size_t found = items.size();
    if (instance) found = place([&](const SphericalDecision& decision) { return decision.instance == *instance; });
    if (found == items.size())
        found = place([](const SphericalDecision& decision) { return decision.relation != SphereRelation::Outside; });
    return found == items.size() ? 0 : found;
}

}  // namespace

size_t placeOfDecision(std::span<const SphericalDecision> decisions, const std::optional<uint32_t>& instance) {
    return placeOf(decisions, instance, [](const SphericalDecision& decision) -> const SphericalDecision& { return decision; });
}

size_t placeOfMap(std::span<const MapSnapshot> maps, const std::optional<uint32_t>& instance) {
    return placeOf(maps, instance, [](const MapSnapshot& map) -> const SphericalDecision& { return map.decision; });
}

}  // namespace cullscope::spherical
