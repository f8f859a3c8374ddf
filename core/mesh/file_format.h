#pragma once

#include <filesystem>

#include "core/mesh/byte_source.h"

namespace cullscope {

enum class MeshFormat { Obj, Ply, Stl, Off, Om };

/// Of a file's name: lower case without the dot, that of ".gz" or ".xz" set aside; "obj" of "A.OBJ.xz". Empty where it has none.
[[nodiscard]] std::string extensionOf(const std::filesystem::path& path);

/// Passes over the byte-order mark that some editors write before UTF-8 text, at the begin of a file.
void skipByteOrderMark(ByteSource& source);

/// The format of a file: by its first bytes where they are unambiguous, else by the extension, that of ".gz" or ".xz" set aside.
/// A byte-order mark before text is passed over. Throws Error(Input), with what to do, for archives, files compressed twice,
/// UTF-16 text, Git LFS pointers and all other files that are no mesh.
[[nodiscard]] MeshFormat formatOf(const std::filesystem::path& path, ByteSource& source);

/// Whether the size of `source` is that of a binary STL with its triangle count: 84 bytes and 50 for each triangle.
[[nodiscard]] bool hasSizeOfBinaryStl(ByteSource& source);

}  // namespace cullscope
