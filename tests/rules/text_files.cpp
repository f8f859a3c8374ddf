#include "tests/rules/text_files.h"

#include <algorithm>
#include <fstream>

namespace cullscope::rules {

namespace fs = std::filesystem;

std::vector<Line> linesOf(const fs::path& file) {
    std::vector<Line> lines;
    std::ifstream stream(file);
    std::string text;
    for (int number = 1; std::getline(stream, text); ++number) lines.push_back({number, text});
    return lines;
}

std::vector<fs::path> filesBelow(const fs::path& folder, const std::set<std::string>& namesOrExtensions) {
    std::vector<fs::path> files;
    if (!fs::is_directory(folder)) return files;
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder)) {
        const fs::path& path = entry.path();
        const bool wanted =
            namesOrExtensions.contains(path.extension().string()) || namesOrExtensions.contains(path.filename().string());
        if (entry.is_regular_file() && wanted) files.push_back(path);
    }
    std::sort(files.begin(), files.end());
    return files;
}

std::vector<std::string> matches(const std::string& text, const std::regex& pattern) {
    std::vector<std::string> found;
    for (std::sregex_iterator match(text.begin(), text.end(), pattern), end; match != end; ++match) found.push_back((*match)[1]);
    return found;
}

}  // namespace cullscope::rules
