#pragma once

#include "core/geometry/random.h"
#include "core/scene/camera.h"
#include "core/scene/scene.h"

namespace cullscope::certify {

/// Four shapes under random rotations, scales, reflections and flattenings, or random boxes; moved by up to 1e7 by their
/// transforms or their mesh's origin. The same scene for the same seed.
[[nodiscard]] ScenePointer randomScene(uint64_t seed);

struct RandomView {
    Camera camera;
    Viewport viewport;
};

/// The sizes of random pictures.
enum class Sizes {
    UpTo16384,  ///< one side up to 16384, or both up to 4096
    UpTo1025    ///< each side from 1 to 1025, small ones as often as large ones
};

/// A view of a scene with near and far from 1e-6 to 1e9, and fields of view from 0.01° to 179°. A share of them, 0 to 1, are
/// parallel views, 1e-6 to 1e9 high. In most views an object touches one of the six planes to within 1e-12 … 1e-3 of its
/// distance, from inside, from outside or across it.
[[nodiscard]] RandomView randomView(const Scene& scene, Random& random, Sizes sizes, double parallelShare = 0.0);

}  // namespace cullscope::certify
