#include "tests/fuzz/support.h"
#include "tests/fuzz/targets.h"

namespace cullscope::fuzz {

void stl(std::string_view input) { readMeshFile(input, "input.stl"); }

}  // namespace cullscope::fuzz
