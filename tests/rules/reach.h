#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace cullscope::rules {

/// Filters of GoogleTest (one a case) by test program: "visibility" → "Spherical.case12…", ….
using TestSelection = std::map<std::string, std::vector<std::string>>;

/// The test cases that a change of files (named from the root) can reach, for working; the whole of packaging/test goes further.
/// A source reaches what includes its header, and so on from there, up to the test files. The registry of strategies includes all
/// of them and is included by nearly everything, so it passes nothing on: a strategy reaches the test files (and what they
/// include of tests/) that name its id in a string; one that many test files name as an example, only those of its layer and
/// those with its family or a word of its id in their path. A shader reaches what its text is compiled into; any other file of
/// resources, tests or docs the test files that name its folder; a file of the build (CMake, packaging) the rules.
[[nodiscard]] TestSelection testsReached(const std::filesystem::path& root, const std::vector<std::filesystem::path>& changed);

/// All cases of a test program, or those of a GoogleTest suite wherever it stands. Empty: there is neither.
[[nodiscard]] TestSelection testsNamed(const std::filesystem::path& root, const std::string& name);

/// The programs that there are tests for, in alphabetical order.
[[nodiscard]] std::vector<std::string> testPrograms(const std::filesystem::path& root);

}  // namespace cullscope::rules
