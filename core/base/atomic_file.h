#pragma once

#include <filesystem>
#include <functional>
#include <ostream>

namespace cullscope {

/// Writes a file completely or not at all: `write` fills a temporary file beside `path`, which is then renamed to `path`. "-" is
/// standard output; devices and pipes are written directly. On failure the old file, if any, stays, and Error(Usage) names the
/// path and the system's reason. A file that is replaced keeps its mode, its owner where that is allowed, and the symbolic links
/// that lead to it; its other names (hard links) keep the old contents. What a killed program left of a temporary file in that
/// folder is removed.
void writeFileAtomically(const std::filesystem::path& path, const std::function<void(std::ostream&)>& write);

/// Throws what `writeFileAtomically` would throw before it writes: where a folder is missing, is named in place of a file, or
/// allows no new file, where the name is too long, and where the old file is write-protected. Leaves everything as it is.
void requireWritable(const std::filesystem::path& path);

}  // namespace cullscope
