#include "tests/fuzz/support.h"
#include "tests/fuzz/targets.h"

namespace cullscope::fuzz {

void ply(std::string_view input) { readMeshFile(input, "input.ply"); }

}  // namespace cullscope::fuzz
