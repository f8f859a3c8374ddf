#include "tests/fuzz/support.h"
#include "tests/fuzz/targets.h"

namespace cullscope::fuzz {

void off(std::string_view input) { readMeshFile(input, "input.off"); }

}  // namespace cullscope::fuzz
