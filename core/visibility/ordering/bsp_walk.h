#pragma once

#include <cstddef>
#include <cstdint>

#include "core/frame/frame_context.h"
#include "core/spatial/bsp_tree.h"
#include "core/visibility/ordering/named_subjects.h"

namespace cullscope::ordering {

/// The first nodes, level by level, that a recorded frame and the tree panel speak of one by one.
constexpr uint32_t kRecordedNodes = 20'000;

constexpr size_t kNodeOfFragment = 2;  ///< the operand of a drawn part that is its node

/// Lines of the listing. Back to front the child that is drawn first lies away from V, front to back on its side.
enum class BspLine : uint8_t { Start = 1, Side, FirstChild, OnPlane, LastChild };

/// The triangles of a frame in the order of the walk, far to near or near to far; says each step to a frame that is recorded.
[[nodiscard]] OwnTrianglesPointer walkOfFrame(FrameContext& frame, const BspTree& tree, bool nearFirst);

/// What an operand of a decision that walkOfFrame() said stands for.
[[nodiscard]] OperandRole roleInBspWalk(const Decision& decision, size_t operand);

}  // namespace cullscope::ordering
