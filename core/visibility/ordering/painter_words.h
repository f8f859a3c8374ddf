#pragma once

#include "core/spatial/painters_order.h"

namespace cullscope::ordering {

/// Lines of the listing.
enum class PainterLine : uint8_t { Sort = 1, Farthest, Candidates, Extents, Behind, Before, Projections, Cut, Swap, Draw };

struct ToldTest {
    PainterLine line;
    const char* sentence;
};

/// The line and the sentence of a test; %1 and %2 are the triangles P and Q, %3 and %4 what was compared.
[[nodiscard]] ToldTest toldTest(const NewellStep& step);

/// What is said of a triangle, or a part of it, that is drawn: %1 is the share of its area, %2 the triangle, %3 the distance of
/// its centroid. `whole`: nothing of it was cut off.
[[nodiscard]] const char* toldDrawn(NewellStep::Cause cause, bool whole);

}  // namespace cullscope::ordering
