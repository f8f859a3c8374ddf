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

/// An id as a word of a sentence, and within an identifier. A search for the plain text comes before that for the expression,
/// which takes a hundred times as long and would be asked of every line for every id.
class IdPatterns {
public:
    explicit IdPatterns(const std::string& strategy)
        : id(strategy),
          m_typeName(typeNameOf(id)),
          m_memberName(m_typeName),
          m_word("(^|[^A-Za-z0-9_-])" + id + "($|[^A-Za-z0-9_-])"),
          m_strategy("^([^\\s,]+,)*" + id + "([:,]\\S*)?$") {
        m_memberName[0] = char(std::tolower(static_cast<unsigned char>(m_memberName[0])));
        m_identifier = "([A-Za-z0-9_]" + m_typeName + "|\\b" + m_typeName + "|\\b" + m_memberName + ")([^a-z]|$)";
    }

    [[nodiscard]] bool isWordOf(const std::string& sentence) const {
        return sentence.find(id) != std::string::npos && std::regex_search(sentence, m_word);
    }
    [[nodiscard]] bool isNamedIn(const std::string& code) const {
        return (code.find(m_typeName) != std::string::npos || code.find(m_memberName) != std::string::npos) &&
               std::regex_search(code, m_identifier);
    }

    /// Whether a literal is a strategy as it is named on the command line, by itself or in a list: "all", "frustum:box=length".
    [[nodiscard]] bool isNamedAsStrategyIn(const std::string& literal) const {
        return literal.find(id) != std::string::npos && std::regex_search(literal, m_strategy);
    }

    std::string id;

private:
    std::string m_typeName, m_memberName;
    std::regex m_word, m_strategy, m_identifier;
};

}  // namespace

std::vector<Offence> strategyWordOffences(const fs::path& root, const std::vector<std::string>& ids) {
    // Words of other things, too: of what any view shows, and in identifiers of Qt's and OpenGL's. These are strategies only
    // where a literal has nothing else than strategies. No place outside visibility and experiments needs such a literal.
    static const std::set<std::string> kOrdinary{"all", "clusters", "frustum", "painter", "recorded", "spherical"};
    static const std::set<std::string> kOthersIdentifiers{"depth-buffer", "scan-line"};
    static const std::regex kLiteral(R"re("(([^"\\]|\\.)*)")re"), kNewLine(R"(\\n)");
    std::vector<IdPatterns> patterns;
    for (const std::string& id : ids) patterns.emplace_back(id);
    std::vector<Offence> offences;
    for (const char* folder : {"ui", "app", "core/gpu", "core/image", "core/measure"}) {
        for (const fs::path& file : filesBelow(root / folder, {".h", ".cpp"})) {
            const fs::path relative = fs::relative(file, root);
            for (const Line& line : linesOf(file)) {
                if (line.text.starts_with("#include")) continue;
                std::vector<std::string> sentences;
                for (std::sregex_iterator match(line.text.begin(), line.text.end(), kLiteral), end; match != end; ++match)
                    sentences.push_back(std::regex_replace((*match)[1].str(), kNewLine, " "));
                const std::string code = sentences.empty() ? line.text : std::regex_replace(line.text, kLiteral, "\"\"");
                const std::string named = code.substr(0, code.find("//"));
                // In a comment the id of a strategy may be an example.
                const size_t beforeComment = std::min(sentences.size(), size_t(std::ranges::count(named, '"') / 2));
                for (const IdPatterns& pattern : patterns) {
                    const bool found =
                        kOrdinary.contains(pattern.id)
                            ? std::any_of(sentences.begin(), sentences.begin() + ptrdiff_t(beforeComment),
                                          [&](const std::string& one) { return pattern.isNamedAsStrategyIn(one); })
                            : (!kOthersIdentifiers.contains(pattern.id) && pattern.isNamedIn(named)) ||
                                  std::ranges::any_of(sentences, [&](const std::string& one) { return pattern.isWordOf(one); });
                    if (found) offences.push_back({relative, line.number, "has the strategy " + pattern.id + " in a word"});
                }
            }
        }
    }
    return offences;
}

}  // namespace cullscope::rules
