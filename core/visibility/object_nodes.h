#pragma once

#include <initializer_list>

#include "core/frame/frame_context.h"
#include "core/visibility/structure_snapshot.h"

namespace cullscope {

/// One node for each object that a recorded frame decided about, by itself or within a group, in the order of the decisions, with
/// its result: the boxes of strategies that decide about whole objects. The log is of a frame of the scene.
[[nodiscard]] StructureSnapshot objectNodes(const FrameLog& log, const Scene& scene);

/// Says how a frame begins, while it is recorded: at a line of the listing, with what the sentence is about.
void sayBegin(FrameContext& frame, uint8_t line, const char* sentence, std::initializer_list<double> operands);

/// Says of every object with triangles that it is drawn: of strategies that leave no object out.
void sayObjectsAreDrawn(FrameContext& frame);

}  // namespace cullscope
