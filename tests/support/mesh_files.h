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
    /// The sentence with which the file is refused; fails the test where it is not, or not with Error(Input).
    [[nodiscard]] std::string refusal(const std::string& name, std::string_view bytes) const;

    std::filesystem::path m_folder;
};

[[nodiscard]] std::string refusalOf(const std::filesystem::path& path);

/// Appends values as they lie in memory (little-endian).
template <typename... Values>
void append(std::string& bytes, const Values&... values) {
    (bytes.append(reinterpret_cast<const char*>(&values), sizeof(values)), ...);
}

/// How loading a file ended in a child process that may use little memory and time.
enum class Outcome { Loaded, Refused, Wrong };

/// Loads every file in one child process with limited memory (not under the address sanitizer, which needs the whole address
/// space) and time. `Wrong` for all when the child crashed or hung. Loaded meshes are checked to hold their invariants.
[[nodiscard]] std::vector<Outcome> loadInChild(const std::vector<std::filesystem::path>& files, unsigned seconds);

/// Runs `work` in such a child; true where it ended by returning true.
[[nodiscard]] bool succeedsInChild(const std::function<bool()>& work, unsigned seconds);

/// Whether the file loads into sound meshes or is refused with one sentence that names it.
[[nodiscard]] Outcome tryLoading(const std::filesystem::path& path);

}  // namespace cullscope::test
