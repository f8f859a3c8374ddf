#pragma once

#include <filesystem>

#include "core/mesh/byte_source.h"

namespace cullscope {

enum class MeshFormat { Obj, Ply, Stl, Off, Om };

/// The format of a file: by its first bytes where they are unmistakable, else by the extension. Throws Error(Input) with what to
/// do for compressed files, UTF-16 text, Git LFS pointers and everything else that is no mesh.
[[nodiscard]] MeshFormat formatOf(const std::filesystem::path& path, ByteSource& source);

/// Whether `source` holds a binary STL by the size rule: 84 bytes and 50 a triangle.
[[nodiscard]] bool hasSizeOfBinaryStl(ByteSource& source);

}  // namespace cullscope
