#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/scene/scene.h"

namespace cullscope {

/// `scene` without the instances that `hidden` marks; what it does not reach is shown. The meshes stay, with their numbers, so
/// that uploaded buffers can be shared; instances and triangles are numbered anew. Nothing hidden: the same pointer. Everything
/// hidden: a scene without instances, whose bounds are empty.
[[nodiscard]] ScenePointer withoutInstances(const ScenePointer& scene, const std::vector<bool>& hidden);

/// Object numbers and ranges as in "3,7-9", counted from 0, as one mark an object. Empty text hides nothing.
/// Throws Error(Usage) naming the number and how many objects there are.
[[nodiscard]] std::vector<bool> hiddenFromText(std::string_view text, size_t objects);
/// The shortest such text for the marks.
[[nodiscard]] std::string hiddenToText(const std::vector<bool>& hidden);

}  // namespace cullscope
