#pragma once

#include "core/base/progress.h"
#include "core/scene/scene.h"

namespace cullscope {

/// What a scene of layers has.
struct Layers {
    size_t count = 32;
    size_t triangles = 10'000;  ///< of each, at least 2, to the nearest that its grid allows
    double waves = 0.0;         ///< height of the waves of each; 0: flat
};

/// Parallel sheets, one behind the other along z and facing +z, each an object: a scene whose depth overlap is known. Seen from
/// the front (the camera path `front:N`), each of them fills the picture and all but the first one are hidden. They are 8/3 wide
/// and 2 high, evenly spaced over a depth of 2.8; a single one lies in the middle. Their waves are all the same, so that sheets
/// never meet, and the triangles of wavy ones lie in planes of their own. Throws Error(Interrupted) on a stop request.
[[nodiscard]] ScenePointer layersScene(std::string name, const Layers& layers, const Progress& progress = {});

}  // namespace cullscope
