#include "tests/rules/programs.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <stdexcept>

namespace cullscope::rules {

namespace fs = std::filesystem;

namespace {

/// A path quoted as one word for the shell.
std::string quoted(const fs::path& path) {
    std::string text = "'";
    for (const char letter : path.string()) text += letter == '\'' ? std::string("'\\''") : std::string(1, letter);
    return text + "'";
}

bool isElf(const fs::path& file) {
    std::array<char, 4> start{};
    std::ifstream stream(file, std::ios::binary);
    return stream.read(start.data(), start.size()) && start == std::array<char, 4>{'\x7f', 'E', 'L', 'F'};
}

/// The libraries of a program by name, with the files that the loader chooses, as `ldd` prints them.
std::map<std::string, fs::path> librariesByName(const fs::path& program) {
    static const std::regex kLine(R"(^\s*(\S+) => (/.*) \(0x[0-9a-f]+\)$)");
    static const std::regex kMissing(R"(^\s*(\S+) => not found)");
    std::map<std::string, fs::path> libraries;
    for (const std::string& line : outputOf("ldd " + quoted(program))) {
        std::smatch match;
        if (std::regex_search(line, match, kMissing))
            throw std::runtime_error(program.string() + ": not found: " + match[1].str());
        if (std::regex_match(line, match, kLine)) libraries[match[1]] = match[2].str();
    }
    return libraries;
}

}  // namespace

std::vector<std::string> outputOf(const std::string& command) {
    FILE* const pipe = popen(command.c_str(), "r");
    if (pipe == nullptr) throw std::runtime_error("cannot start: " + command);
    std::string text;
    std::array<char, 65536> buffer{};
    while (const size_t count = fread(buffer.data(), 1, buffer.size(), pipe)) text.append(buffer.data(), count);
    if (pclose(pipe) != 0) throw std::runtime_error("failed: " + command);
    std::vector<std::string> lines;
    for (size_t start = 0; start < text.size();) {
        const size_t end = std::min(text.find('\n', start), text.size());
        lines.push_back(text.substr(start, end - start));
        start = end + 1;
    }
    return lines;
}

std::vector<fs::path> programsIn(const fs::path& folder) {
    std::vector<fs::path> programs;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
        if (entry.is_regular_file() && isElf(entry.path())) programs.push_back(entry.path());
    }
    std::sort(programs.begin(), programs.end());
    return programs;
}

std::vector<std::string> loadedLibraries(const fs::path& program) {
    std::vector<std::string> names;
    for (const auto& [name, file] : librariesByName(program)) names.push_back(name);
    return names;
}

std::vector<fs::path> neededLibraries(const fs::path& program) {
    static const std::regex kNeeded(R"(\(NEEDED\)\s+Shared library: \[([^\]]+)\])");
    const std::map<std::string, fs::path> files = librariesByName(program);
    std::vector<fs::path> needed;
    for (const std::string& line : outputOf("LC_ALL=C readelf -d " + quoted(program))) {
        std::smatch match;
        if (!std::regex_search(line, match, kNeeded)) continue;
        // The loader itself has no line with "=>".
        if (const auto found = files.find(match[1]); found != files.end()) needed.push_back(found->second);
    }
    return needed;
}

std::vector<fs::path> headersReadByBuild(const fs::path& buildFolder) {
    std::set<fs::path> headers;
    // -n: Ninja's dependency log is only read, also during a build.
    for (const std::string& line : outputOf("ninja -n -C " + quoted(buildFolder) + " -t deps")) {
        if (line.starts_with("    /usr/")) headers.insert(fs::path(line.substr(4)).lexically_normal());
    }
    return {headers.begin(), headers.end()};
}

}  // namespace cullscope::rules
