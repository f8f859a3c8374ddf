#pragma once

#include "core/experiments/certify/random_scenes.h"

namespace cullscope::test {

using certify::randomScene;
using certify::RandomView;

/// A random view of any size (core/experiments/certify/random_scenes.h).
[[nodiscard]] inline RandomView randomView(const Scene& scene, Random& random) {
    return certify::randomView(scene, random, certify::Sizes::UpTo16384);
}

}  // namespace cullscope::test
