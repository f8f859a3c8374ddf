#include "tests/fuzz/support.h"
#include "tests/fuzz/targets.h"

namespace cullscope::fuzz {

void rvm(std::string_view input) { readSceneFile(input, "input.rvm"); }

}  // namespace cullscope::fuzz
