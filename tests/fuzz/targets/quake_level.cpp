#include "tests/fuzz/support.h"
#include "tests/fuzz/targets.h"

namespace cullscope::fuzz {

void quake_level(std::string_view input) { readSceneFile(input, "input.bsp"); }

}  // namespace cullscope::fuzz
