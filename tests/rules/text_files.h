#pragma once

#include <filesystem>
#include <regex>
#include <set>
#include <string>
#include <vector>

namespace cullscope::rules {

/// A line of a text file and its number.
struct Line {
    int number = 0;
    std::string text;
};

[[nodiscard]] std::vector<Line> linesOf(const std::filesystem::path& file);

/// All files below a folder with one of the names or extensions, in alphabetical order.
[[nodiscard]] std::vector<std::filesystem::path> filesBelow(const std::filesystem::path& folder,
                                                            const std::set<std::string>& namesOrExtensions);

/// The first group of every match in a text.
[[nodiscard]] std::vector<std::string> matches(const std::string& text, const std::regex& pattern);

}  // namespace cullscope::rules
