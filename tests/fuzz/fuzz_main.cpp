// The entry of one libFuzzer program; CULLSCOPE_FUZZ_TARGET is the target's function.
#include <tbb/global_control.h>

#include <cstddef>
#include <cstdint>
#include <string_view>

#include "tests/fuzz/support.h"
#include "tests/fuzz/targets.h"

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* bytes, size_t size);

int LLVMFuzzerTestOneInput(const uint8_t* bytes, size_t size) {
    // Other threads would make the coverage of an input differ from run to run, and their wake-up takes longer than a small mesh.
    static const tbb::global_control kOneThread(tbb::global_control::max_allowed_parallelism, 1);
    if (size <= cullscope::fuzz::kMostBytes) cullscope::fuzz::CULLSCOPE_FUZZ_TARGET({reinterpret_cast<const char*>(bytes), size});
    return 0;
}
