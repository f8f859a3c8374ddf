#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/scene/scene.h"

namespace cullscope {

/// `scene` without the instances that `hidden` marks; instances beyond its size are shown. The meshes and their numbers stay, so
/// that uploaded buffers can be shared; instances and triangles are renumbered. With nothing hidden the same pointer; with
/// everything hidden a scene without instances, whose bounds are empty.
[[nodiscard]] ScenePointer withoutInstances(const ScenePointer& scene, const std::vector<bool>& hidden);

/// Parses object numbers and ranges as in "3,7-9", counted from 0, to one mark for each object. Empty text hides nothing. Throws
/// Error(Usage) naming the number and how many objects there are.
[[nodiscard]] std::vector<bool> hiddenFromText(std::string_view text, size_t objects);
/// The shortest text of this form for the marks.
[[nodiscard]] std::string hiddenToText(const std::vector<bool>& hidden);

}  // namespace cullscope
