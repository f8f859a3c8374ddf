#pragma once

#include <string>

#include "core/measure/frame_measurement.h"

// What summaries need of a judged frame and result files do not have: lists of lost objects, differences of pictures.
namespace cullscope::store {

/// As text; empty: the frame was not judged.
[[nodiscard]] std::string judgedText(const FrameMeasurement& frame);
/// Adds it to a frame. Throws ResultFields::exception where the text is none of judgedText().
void addJudged(const std::string& text, FrameMeasurement& frame);

}  // namespace cullscope::store
