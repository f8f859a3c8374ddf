#include "tests/fuzz/support.h"
#include "tests/fuzz/targets.h"

namespace cullscope::fuzz {

void om(std::string_view input) { readMeshFile(input, "input.om"); }

}  // namespace cullscope::fuzz
