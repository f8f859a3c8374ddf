#include "core/image/picture_metadata.h"

#include <array>

#include "core/image/picture_file.h"
#include "tests/fuzz/support.h"
#include "tests/fuzz/targets.h"

namespace cullscope::fuzz {

void picture_metadata(std::string_view input) {
    constexpr std::array kNames{"input.png", "input.jpg", "input.tif", "input.exr"};
    if (input.empty()) return;
    const std::filesystem::path file = fileOf(input.substr(1), kNames[uint8_t(input[0]) % kNames.size()]);
    accepted({ErrorKind::Input}, [&] {
        for (const auto& [name, text] : readPictureMetadata(file))
            require(name.starts_with("cullscope:"), "metadata of another program");
    });
}

}  // namespace cullscope::fuzz
