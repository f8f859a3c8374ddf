#pragma once

#include <filesystem>
#include <functional>
#include <ostream>
#include <string_view>

namespace cullscope {

/// Writes a file whole or not at all: `write` fills a temporary file beside `path`, which then takes its place.
/// "-" is standard output; devices and pipes are written as they are. Throws Error(Usage) naming the path and the system's
/// reason; the old file, if any, stays.
void writeFileAtomically(const std::filesystem::path& path, const std::function<void(std::ostream&)>& write);

/// The same for libraries that want a file name: `write` gets the temporary name (with the same extension) to write to.
void writeFileAtomicallyByName(const std::filesystem::path& path, const std::function<void(const std::filesystem::path&)>& write);

}  // namespace cullscope
