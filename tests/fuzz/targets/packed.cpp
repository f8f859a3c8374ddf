#include "tests/fuzz/support.h"
#include "tests/fuzz/targets.h"

namespace cullscope::fuzz {

void packed(std::string_view input) { readMeshFile(input, "input.obj.xz"); }

}  // namespace cullscope::fuzz
