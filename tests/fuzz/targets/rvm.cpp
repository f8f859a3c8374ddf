#include "core/scene/rvm/rvm_scene.h"

#include "tests/fuzz/support.h"
#include "tests/fuzz/targets.h"

namespace cullscope::fuzz {

void rvm(std::string_view input) {
    const std::filesystem::path file = fileOf(input, "input.rvm");
    acceptedFile(file, [&] {
        LoadOptions options;
        options.memoryLimitBytes = kMemory;
        requireSound(*readRvmFile(file, options).scene);
    });
}

}  // namespace cullscope::fuzz
