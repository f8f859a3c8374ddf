#pragma once

#include "core/visibility/object_record.h"
#include "core/visibility/spherical/decision.h"

namespace cullscope::spherical {

/// Says the slopes of an object's bands from the near point on, which are no tests yet.
void sayBandSlopes(const ContourBands& bands, ObjectRecord& record);
/// Says the test of a cell against them.
void saySlopeTest(const SphericalMaps& maps, uint32_t cell, const SlopeTest& test, ObjectRecord& record);

}  // namespace cullscope::spherical
