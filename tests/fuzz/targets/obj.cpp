#include "tests/fuzz/support.h"
#include "tests/fuzz/targets.h"

namespace cullscope::fuzz {

void obj(std::string_view input) { readMeshFile(input, "input.obj"); }

}  // namespace cullscope::fuzz
