#include <algorithm>
#include <regex>

#include "tests/rules/source_rules.h"
#include "tests/rules/text_files.h"

namespace cullscope::rules {

namespace fs = std::filesystem;

namespace {

constexpr size_t kLongestLine = 120;
constexpr size_t kMostLinesOfReadme = 90;

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

std::vector<Offence> offencesOfPage(const fs::path& root, const fs::path& page) {
    const bool widthMatters = *page.begin() != "resources";
    std::vector<Offence> offences;
    bool inCode = false;
    for (const Line& line : linesOf(root / page)) {
        const size_t length = lengthWithoutAddresses(line.text);
        if (widthMatters && length > kLongestLine)
            offences.push_back({page, line.number, "has " + std::to_string(length) + " characters"});
        if (line.text.starts_with("```")) inCode = !inCode;
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

}  // namespace cullscope::rules
