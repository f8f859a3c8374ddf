#pragma once

#include <filesystem>
#include <functional>
#include <initializer_list>
#include <string>
#include <string_view>

#include "core/base/error.h"
#include "core/scene/scene.h"

namespace cullscope::fuzz {

/// The longest input that a target takes, in bytes: readers treat the second thousand of lines as the first one, and short inputs
/// are tried more often.
inline constexpr size_t kMostBytes = 8192;

/// The memory that readers and generators may plan with. An input needs a part of it, unless a reader believes a count that the
/// file states and does not contain.
inline constexpr size_t kMemory = size_t{64} << 20;

/// Throws std::logic_error: what holds of every input did not hold of this one. It leaves the target, as every exception besides
/// an expected Error does, and is a finding.
void require(bool holds, const char* what);

/// Runs `work`, which may refuse the input by an Error of one of these kinds, with a sentence. True where it did not.
bool accepted(std::initializer_list<ErrorKind> kinds, const std::function<void()>& work);
/// The same for a file: the only kind is Input, and the sentence is one line that names the file and ends with a full stop.
bool acceptedFile(const std::filesystem::path& file, const std::function<void()>& work);

/// A file of this name and content in a folder of the process's own, the only one there. Empty apart from it, so that no name in
/// an input means a file of the machine.
[[nodiscard]] std::filesystem::path fileOf(std::string_view content, const std::string& name);
/// That folder.
[[nodiscard]] const std::filesystem::path& scratchFolder();

/// Reads a mesh file and requires that its meshes are sound.
void readMeshFile(std::string_view content, const std::string& name);

/// Reads a file of any format, which its name says, and requires that the scene is sound; `check` may require more.
void readSceneFile(
    std::string_view content, const std::string& name,
    const std::function<void(const Scene& scene)>& check = [](const Scene&) {});

/// Requires that every mesh of a scene is sound, and that its instances and bounds are finite.
void requireSound(const Scene& scene);

}  // namespace cullscope::fuzz
