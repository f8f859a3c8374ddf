#include <algorithm>
#include <cctype>
#include <regex>
#include <set>

#include "tests/rules/source_rules.h"
#include "tests/rules/text_files.h"

namespace cullscope::rules {

namespace fs = std::filesystem;

namespace {

/// "FrustumOctree" for "frustum-octree".
std::string typeNameOf(const std::string& id) {
    std::string name;
    bool upper = true;
    for (const char c : id) {
        if (c != '-') name += upper ? char(std::toupper(static_cast<unsigned char>(c))) : c;
        upper = c == '-';
    }
    return name;
}

/// An id as a word of a sentence, and within an identifier.
struct IdPatterns {
    std::string id;
    std::regex word, identifier;

    explicit IdPatterns(const std::string& strategy)
        : id(strategy), word("(^|[^A-Za-z0-9_-])" + id + "($|[^A-Za-z0-9_-])"), identifier(identifierPattern(id)) {}

private:
    static std::string identifierPattern(const std::string& id) {
        const std::string name = typeNameOf(id);
        std::string first = name;
        first[0] = char(std::tolower(static_cast<unsigned char>(first[0])));
        return "([A-Za-z0-9_]" + name + "|\\b" + name + "|\\b" + first + ")([^a-z]|$)";
    }
};

}  // namespace

std::vector<Offence> strategyWordOffences(const fs::path& root, const std::vector<std::string>& ids) {
    // Words of other things, too: of what any view shows, and in identifiers of Qt's and OpenGL's.
    static const std::set<std::string> kOrdinary{"all", "frustum", "painter", "spherical"};
    static const std::set<std::string> kOthersIdentifiers{"depth-buffer", "scan-line"};
    static const std::regex kLiteral(R"re("(([^"\\]|\\.)*)")re");
    std::vector<IdPatterns> patterns;
    for (const std::string& id : ids)
        if (!kOrdinary.contains(id)) patterns.emplace_back(id);
    std::vector<Offence> offences;
    for (const char* folder : {"ui", "app", "core/image", "core/measure"}) {
        for (const fs::path& file : filesBelow(root / folder, {".h", ".cpp"})) {
            const fs::path relative = fs::relative(file, root);
            for (const Line& line : linesOf(file)) {
                if (line.text.starts_with("#include")) continue;
                const std::string code = std::regex_replace(line.text, kLiteral, "\"\"");
                const std::string named = code.substr(0, code.find("//"));
                for (const IdPatterns& pattern : patterns) {
                    bool found = !kOthersIdentifiers.contains(pattern.id) && std::regex_search(named, pattern.identifier);
                    for (std::sregex_iterator match(line.text.begin(), line.text.end(), kLiteral), end; match != end; ++match) {
                        const std::string text = std::regex_replace((*match)[1].str(), std::regex(R"(\\n)"), " ");
                        found = found || std::regex_search(text, pattern.word);
                    }
                    if (found) offences.push_back({relative, line.number, "has the strategy " + pattern.id + " in a word"});
                }
            }
        }
    }
    return offences;
}

}  // namespace cullscope::rules
