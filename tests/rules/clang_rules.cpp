#include <map>
#include <regex>
#include <set>

#include "tests/rules/source_rules.h"
#include "tests/rules/text_files.h"

namespace cullscope::rules {

namespace fs = std::filesystem;

namespace {

/// What is compiled in common: "core/mesh" for a source of that layer, "ui" and "app" for theirs.
std::string libraryOf(const fs::path& file) {
    auto part = file.begin();
    const std::string top = part->string();
    return top == "core" ? top + "/" + (++part)->string() : top;
}

}  // namespace

std::vector<Offence> aliasOffences(const fs::path& root) {
    static const std::regex kOfTheFile(R"(^using (\w+) =.*)");
    static const std::regex kOfAFunction(R"(^\s+using (\w+) =.*)");
    std::map<std::string, std::set<std::string>> ofFiles;
    std::vector<Offence> offences;
    for (const std::regex* pattern : {&kOfTheFile, &kOfAFunction}) {
        for (const char* folder : {"core", "ui", "app"}) {
            for (const fs::path& path : filesBelow(root / folder, {".cpp"})) {
                const fs::path file = fs::relative(path, root);
                for (const Line& line : linesOf(path)) {
                    std::smatch alias;
                    if (!std::regex_match(line.text, alias, *pattern)) continue;
                    std::set<std::string>& names = ofFiles[libraryOf(file)];
                    if (pattern == &kOfTheFile)
                        names.insert(alias[1]);
                    else if (names.contains(alias[1]))
                        offences.push_back({file, line.number, "hides an alias of another source: " + alias[1].str()});
                }
            }
        }
    }
    return offences;
}

std::vector<Offence> rangesOffences(const fs::path& root) {
    static const std::regex kOfASubrange(
        R"(\b(ranges::(subrange|equal_range|search|search_n|find_end|unique|remove|remove_if|rotate|partition|stable_partition)\b|views::\w+))");
    std::vector<Offence> offences;
    for (const char* folder : {"core", "ui", "app", "tests"}) {
        for (const fs::path& path : filesBelow(root / folder, {".cpp", ".h"})) {
            if (path.filename().string().starts_with("clang_rules")) continue;
            for (const Line& line : linesOf(path)) {
                std::smatch use;
                if (std::regex_search(line.text, use, kOfASubrange))
                    offences.push_back({fs::relative(path, root), line.number, "is not compiled by Clang 14: " + use[1].str()});
            }
        }
    }
    return offences;
}

}  // namespace cullscope::rules
