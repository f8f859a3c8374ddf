#pragma once

#include "core/visibility/spherical/map_details.h"
#include "core/visibility/subject_place.h"

namespace cullscope::spherical {

/// Where rays, walked cells, regions, boxes, ranges of cells and bands lie that decisions about objects with maps speak of: in
/// the scene on the objects' bounding spheres, and on their maps.
[[nodiscard]] std::shared_ptr<const SubjectPlaces> placesOnMaps(std::shared_ptr<const MapDetails> maps);

}  // namespace cullscope::spherical
