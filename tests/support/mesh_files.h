#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "core/mesh/load.h"

namespace cullscope::test {

/// A test with a folder of its own for small files.
class MeshFiles : public testing::Test {
protected:
    MeshFiles();
    ~MeshFiles() override;

    [[nodiscard]] std::filesystem::path write(const std::string& name, std::string_view bytes) const;
    [[nodiscard]] LoadedFile load(const std::string& name, std::string_view bytes) const {
        return loadMeshFile(write(name, bytes));
    }
    /// The error sentence for the file; fails the test where it loads, or fails with another error than Error(Input).
    [[nodiscard]] std::string refusal(const std::string& name, std::string_view bytes) const;

    std::filesystem::path m_folder;
};

[[nodiscard]] std::string refusalOf(const std::filesystem::path& path);

/// Appends values in memory order (little-endian).
template <typename... Values>
void append(std::string& bytes, const Values&... values) {
    (bytes.append(reinterpret_cast<const char*>(&values), sizeof(values)), ...);
}

/// The result of loading a file in a child process with limited memory and time.
enum class Outcome { Loaded, Refused, Wrong };

/// Loads every file in one child process with limited memory (not under the address sanitizer, which needs the whole address
/// space) and time. `Wrong` for all files when the child crashed or hung. The invariants of loaded meshes are checked.
[[nodiscard]] std::vector<Outcome> loadInChild(const std::vector<std::filesystem::path>& files, unsigned seconds);

/// Runs `work` in such a child; true where `work` returned true.
[[nodiscard]] bool succeedsInChild(const std::function<bool()>& work, unsigned seconds);

/// Whether the file loads into valid meshes or is refused with one sentence that names it.
[[nodiscard]] Outcome tryLoading(const std::filesystem::path& path);

}  // namespace cullscope::test
