#include <algorithm>
#include <regex>

#include "tests/rules/source_rules.h"
#include "tests/rules/text_files.h"

namespace cullscope::rules {

namespace fs = std::filesystem;

namespace {

constexpr size_t kLongestLine = 120;
constexpr size_t kMostLinesOfReadme = 90;
constexpr size_t kMostLinesOfSource = 350;

/// The number of UTF-8 characters of a line without its URLs, which cannot be broken.
size_t lengthWithoutAddresses(const std::string& text) {
    static const std::regex kAddress(R"(https?://[^\s)>]+)");
    const std::string rest = std::regex_replace(text, kAddress, "");
    return size_t(std::count_if(rest.begin(), rest.end(), [](char c) { return (c & 0xC0) != 0x80; }));
}

/// The link targets in a line of a page; text in code is no link.
std::vector<std::string> linkedFiles(const std::string& text) {
    static const std::regex kCode("`[^`]*`");
    static const std::regex kLink(R"(\]\(([^)\s#]+)[^)]*\))");
    std::vector<std::string> files = matches(std::regex_replace(text, kCode, ""), kLink);
    std::erase_if(files, [](const std::string& target) { return target.find("://") != std::string::npos; });
    return files;
}

/// The error in a page's link to a file; empty where there is none.
std::string wrongTarget(const fs::path& root, const fs::path& page, const std::string& target) {
    const fs::path place = (page.parent_path() / target).lexically_normal();
    if (!fs::exists(root / place)) return "links to nothing: " + target;
    const bool inHelpWindow = *place.begin() == "docs" || place.generic_string().starts_with("resources/help/");
    // README and CONTRIBUTING, at the top of the tree, are read only on a code hosting site.
    if (page.has_parent_path() && !inHelpWindow) return "links to what the help window has not: " + target;
    return "";
}

/// Whether the lines of a page's C++ block from its second on are those of the file that its first line names, as in
/// "// core/visibility/strategy.h"; a block that names none is a sketch.
std::vector<Offence> offencesOfBlock(const fs::path& root, const fs::path& page, const std::vector<Line>& block) {
    static const std::regex kFile(R"(// ((?:[\w-]+/)+[\w-]+\.(?:h|cpp)))");
    std::smatch named;
    if (block.empty() || !std::regex_match(block.front().text, named, kFile)) return {};
    const std::string file = named[1].str();
    if (!fs::exists(root / file)) return {{page, block.front().number, "shows a file that is not there: " + file}};
    const std::vector<Line> lines = linesOf(root / file);
    size_t same = 0;
    while (same < lines.size() && same + 1 < block.size() && lines[same].text == block[same + 1].text) ++same;
    if (same == lines.size() && same + 1 == block.size()) return {};
    const int number = same + 1 < block.size() ? block[same + 1].number : block.back().number;
    return {{page, number, "differs from " + file + " at its line " + std::to_string(same + 1)}};
}

std::vector<Offence> offencesOfPage(const fs::path& root, const fs::path& page) {
    const bool widthMatters = *page.begin() != "resources";
    std::vector<Offence> offences;
    bool inCode = false;
    std::vector<Line> block;  // of C++
    bool inBlock = false;
    for (const Line& line : linesOf(root / page)) {
        const size_t length = lengthWithoutAddresses(line.text);
        if (widthMatters && length > kLongestLine)
            offences.push_back({page, line.number, "has " + std::to_string(length) + " characters"});
        if (line.text.starts_with("```")) {
            inCode = !inCode;
            if (inBlock) std::ranges::move(offencesOfBlock(root, page, block), std::back_inserter(offences));
            inBlock = inCode && line.text == "```cpp";
            block.clear();
        } else if (inBlock) {
            block.push_back(line);
        }
        if (inCode) continue;
        for (const std::string& target : linkedFiles(line.text))
            if (const std::string what = wrongTarget(root, page, target); !what.empty())
                offences.push_back({page, line.number, what});
    }
    return offences;
}

}  // namespace

std::vector<Offence> pageOffences(const fs::path& root) {
    std::vector<fs::path> pages{root / "README.md", root / "CONTRIBUTING.md"};
    for (const char* folder : {"docs", "resources/help"})
        std::ranges::copy(filesBelow(root / folder, {".md"}), std::back_inserter(pages));
    std::vector<Offence> offences;
    for (const fs::path& page : pages)
        std::ranges::move(offencesOfPage(root, fs::relative(page, root)), std::back_inserter(offences));
    if (const size_t lines = linesOf(root / "README.md").size(); lines > kMostLinesOfReadme)
        offences.push_back({"README.md", 0, "has " + std::to_string(lines) + " lines"});
    return offences;
}

std::vector<Offence> longSourceOffences(const fs::path& root) {
    std::vector<Offence> offences;
    for (const char* folder : {"app", "core", "tests", "ui"}) {
        for (const fs::path& file : filesBelow(root / folder, {".cpp", ".h"}))
            if (const size_t lines = linesOf(file).size(); lines > kMostLinesOfSource)
                offences.push_back({fs::relative(file, root), 0, "has " + std::to_string(lines) + " lines"});
    }
    return offences;
}

}  // namespace cullscope::rules
