#pragma once

#include <filesystem>
#include <functional>
#include <ostream>
#include <string_view>

namespace cullscope {

/// Writes a file completely or not at all: `write` fills a temporary file beside `path`, which is then renamed to `path`. "-" is
/// standard output; devices and pipes are written directly. On failure the old file, if any, stays, and Error(Usage) names the
/// path and the system's reason.
void writeFileAtomically(const std::filesystem::path& path, const std::function<void(std::ostream&)>& write);

/// The same for libraries that need a file name: `write` gets the name of the temporary file (with the same extension).
void writeFileAtomicallyByName(const std::filesystem::path& path, const std::function<void(const std::filesystem::path&)>& write);

}  // namespace cullscope
