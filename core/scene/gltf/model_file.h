#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "core/base/progress.h"
#include "core/scene/gltf/container.h"

namespace tinygltf {
class Model;
}

namespace cullscope::gltf {

/// A file's description with its buffers. Of images, textures and materials nothing is read.
struct ModelFile {
    std::shared_ptr<const tinygltf::Model> model;
    uint64_t bytes = 0;  ///< of memory that its buffers take
};

/// Reads the content of a .gltf or .glb at `path`, with the buffers that it names: data URIs, and files in its own folder or
/// below. Throws Error(Input) for a file that is none, for buffers elsewhere, and for extensions without which it cannot be
/// shown; and where `requireMemory` does.
[[nodiscard]] ModelFile readModel(std::string content, const std::filesystem::path& path, const RequireMemory& requireMemory,
                                  uint64_t memoryLimit, const Progress& progress);

}  // namespace cullscope::gltf
