#include "tests/fuzz/support.h"
#include "tests/fuzz/targets.h"

namespace cullscope::fuzz {

void gltf(std::string_view input) { readSceneFile(input, "input.glb"); }

}  // namespace cullscope::fuzz
