#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace cullscope::rules {

/// The output of a command as lines. Throws std::runtime_error with the command where it fails.
[[nodiscard]] std::vector<std::string> outputOf(const std::string& command);

/// The ELF programs directly in a folder, in alphabetical order.
[[nodiscard]] std::vector<std::filesystem::path> programsIn(const std::filesystem::path& folder);

/// The shared libraries that a program loads, directly or indirectly, by name ("libQt6Core.so.6"), as reported by `ldd`.
[[nodiscard]] std::vector<std::string> loadedLibraries(const std::filesystem::path& program);

/// The files of the shared libraries that a program is linked with itself, without the dependencies of those libraries.
[[nodiscard]] std::vector<std::filesystem::path> neededLibraries(const std::filesystem::path& program);

/// The files outside the tree and the build folder that the last build read, from Ninja's dependency log: headers of the compiler
/// and of libraries.
[[nodiscard]] std::vector<std::filesystem::path> headersReadByBuild(const std::filesystem::path& buildFolder);

}  // namespace cullscope::rules
