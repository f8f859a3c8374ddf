#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/scene/scene_generators.h"

namespace cullscope {

/// The scenes of the battery of extreme cases (experiments/stability), each with the cameras from which its case looks at it:
/// "gallery/case-16-bowl". They are generators without parameters, which `openScene` knows beside those of sceneGeneratorTable.
[[nodiscard]] const std::vector<Generator>& galleryGenerators();

/// What lists show of them.
[[nodiscard]] const std::vector<GeneratorInfo>& galleryInfos();

/// The scene with this id, which must be one of the gallery's.
[[nodiscard]] ScenePointer galleryScene(std::string_view id);

}  // namespace cullscope
