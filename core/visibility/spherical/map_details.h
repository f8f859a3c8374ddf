#pragma once

#include <span>

#include "core/visibility/spherical/decision.h"
#include "core/visibility/structure_snapshot.h"

namespace cullscope::spherical {

/// What strategies with maps of directions have in a snapshot: the map of each object with triangles, by instance.
struct MapDetails final : StructureDetails {
    std::vector<MapSnapshot> maps;
};

/// Gives a snapshot its maps, and the sentence about objects that are tested as spheres.
void setMaps(StructureSnapshot& snapshot, std::vector<MapSnapshot> maps);
/// The maps of a snapshot; empty where the strategy has none.
[[nodiscard]] const std::vector<MapSnapshot>& mapsOf(const StructureSnapshot& snapshot);
/// The map of an object; null where there is none.
[[nodiscard]] const MapSnapshot* mapOf(const StructureSnapshot& snapshot, uint32_t instance);
/// Index of the decision to show: that about `instance`; without one, the first one that is not outside the frustum, else the
/// first, 0. There may be none.
[[nodiscard]] size_t placeOfDecision(std::span<const SphericalDecision> decisions, const std::optional<uint32_t>& instance);
/// The same for maps. Needs at least one map.
[[nodiscard]] size_t placeOfMap(std::span<const MapSnapshot> maps, const std::optional<uint32_t>& instance);

}  // namespace cullscope::spherical
