#pragma once

#include <array>
#include <filesystem>

#include "core/scene/scene_files.h"

namespace cullscope {

/// Of the files' names, without the dot: JSON text and the binary container.
inline constexpr std::array<const char*, 2> kGltfExtensions{"gltf", "glb"};
/// Whether a file is to be read as glTF, by its extension.
[[nodiscard]] bool isGltfFile(const std::filesystem::path& path);

/// Reads glTF 2.0. A node with a mesh becomes an object of the node's name, or else the mesh's; nodes with the same mesh share
/// it, as do the instances of EXT_mesh_gpu_instancing. Triangle lists, strips and fans are read, with indices or without, from
/// sparse accessors, quantised (KHR_mesh_quantization) or compressed with Draco (KHR_draco_mesh_compression). Buffers lie in the
/// file, in data URIs, or in files of its folder or below. Metres, y up. Points and lines, skins, morph targets and animations
/// are left out with a remark; images and materials are not read. Throws Error(Input) that says where and what, or where it needs
/// more memory than `options` allow; Error(Interrupted) on a stop request.
[[nodiscard]] FileScene readGltfFile(const std::filesystem::path& path, const LoadOptions& options = {},
                                     const Progress& progress = {});

/// The same of what such a file contains. `path` is its name in messages, and beside it lie its buffers.
[[nodiscard]] FileScene readGltf(std::string content, const std::filesystem::path& path, const LoadOptions& options,
                                 const Progress& progress);

}  // namespace cullscope
