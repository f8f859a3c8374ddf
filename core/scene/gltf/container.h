#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>

namespace cullscope::gltf {

using RequireMemory = std::function<void(uint64_t bytes)>;

/// The parts of a file in memory: of a .gltf its JSON text, of a .glb the chunks JSON and BIN (glTF 2.0, section 4).
struct Container {
    std::string_view json;
    std::string_view binary;  ///< empty where there is none
    bool isBinary = false;
};

/// Checks the lengths that a .glb states against what `content` has; the begin says whether it is one. Throws Error(Input) with
/// the byte at which it goes wrong, also for other versions than 2.
[[nodiscard]] Container containerOf(std::string_view content, const std::string& fileName);

/// Prepares JSON for tinygltf, which copies values recursively, reads the files of images and refuses files for their images
/// although nothing of them is shown. Objects and arrays deeper in each other than kDeepest are refused with the byte; the names
/// of the sections images, textures, materials and samplers are changed in place, so that they are passed over; and
/// `requireMemory` is asked for what the values can take, a buffer that has the whole BIN chunk for each of its buffers included.
void prepareJson(char* json, size_t length, size_t firstByte, size_t binaryBytes, const std::string& fileName,
                 const RequireMemory& requireMemory);

inline constexpr size_t kDeepest = 64;

}  // namespace cullscope::gltf
