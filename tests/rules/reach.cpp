#include "tests/rules/reach.h"

#include <deque>
#include <fstream>
#include <iterator>
#include <regex>
#include <set>
#include <sstream>

#include "tests/rules/source_rules.h"

namespace cullscope::rules {

namespace fs = std::filesystem;

namespace {

constexpr const char* kRegistry = "core/visibility/registry.cpp";
constexpr size_t kExampleFrom = 12;  // test files that name a strategy

std::string textOf(const fs::path& file) {
    std::ifstream stream(file);
    return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

bool isTestFile(const std::string& file) { return file.starts_with("tests/") && file.ends_with("_test.cpp"); }

/// The program that a test file is compiled into; empty for what is none.
std::string programOf(const std::string& file) {
    std::smatch match;
    static const std::regex kCore(R"(^tests/core/(\w+)/.*)");
    if (!isTestFile(file)) return {};
    if (std::regex_match(file, match, kCore)) return match[1];
    if (file.starts_with("tests/app/")) return "cullbench";
    if (file.starts_with("tests/fuzz/")) return "fuzz";
    if (file.starts_with("tests/ui/looks/")) return "looks";
    if (file.starts_with("tests/ui/")) return "ui";
    if (file.starts_with("tests/benchmark/")) return "benchmark";
    return file.starts_with("tests/rules/") ? "rules" : "";
}

/// A case of a test file.
struct Case {
    std::string suite, filter;
};

std::vector<Case> casesIn(const std::string& text) {
    static const std::regex kCase(R"(\b(TYPED_TEST|TEST|TEST_F|TEST_P)\(\s*(\w+)\s*,\s*(\w+)\s*\))");
    std::vector<Case> cases;
    for (std::sregex_iterator match(text.begin(), text.end(), kCase), end; match != end; ++match) {
        const std::string kind = (*match)[1], suite = (*match)[2], name = (*match)[3];
        const std::string plain = suite + "." + name;
        cases.push_back({suite, kind == "TEST_P" ? "*/" + plain + "/*" : kind == "TYPED_TEST" ? suite + "/*." + name : plain});
    }
    return cases;
}

/// The sources of a tree and who includes what.
class Tree {
public:
    explicit Tree(const fs::path& root) : m_root(root) {
        for (const Include& include : includesBelow(root, {"app", "core", "ui", "tests"})) {
            if (!include.quoted) continue;
            const std::string file = include.file.generic_string();
            m_includers[include.name].push_back(file);
            m_includes[file].push_back(include.name);
        }
        for (const char* folder : {"app", "core", "ui", "tests"}) {
            if (!fs::is_directory(root / folder)) continue;
            for (const fs::directory_entry& entry : fs::recursive_directory_iterator(root / folder)) {
                const std::string extension = entry.path().extension().string();
                if (entry.is_regular_file() && (extension == ".h" || extension == ".cpp"))
                    m_texts[fs::relative(entry.path(), root).generic_string()] = textOf(entry.path());
            }
        }
    }

    [[nodiscard]] const std::map<std::string, std::string>& texts() const { return m_texts; }

    /// Files below tests/ whose text has a word in quotes, alone or as part of a list, a specification or a path.
    [[nodiscard]] std::vector<std::string> testFilesThatName(const std::string& word) const {
        const std::regex named("\"[^\"\\n]*" + std::regex_replace(word, std::regex(R"([.+])"), "\\$&") + "(?![\\w-])[^\"\\n]*\"");
        std::vector<std::string> files;
        for (const auto& [file, text] : m_texts)
            if (file.starts_with("tests/") && !file.starts_with("tests/rules/") && text.find(word) != std::string::npos &&
                std::regex_search(text, named) && nameStandsAlone(text, word))
                files.push_back(file);
        return files;
    }

    /// What a file passes a change on to.
    [[nodiscard]] std::vector<std::string> next(const std::string& file) const {
        if (file == kRegistry) return {};
        std::vector<std::string> files;
        if (const auto found = m_includers.find(file); found != m_includers.end()) files = found->second;
        if (!file.ends_with(".cpp") || isTestFile(file)) return files;
        const std::string header = file.substr(0, file.size() - 4) + ".h";
        // A second source of a class has no header of its own: the first of its folder that it includes is the class's; so have
        // benchmarks. Other sources of programs in tests have none and pass nothing on.
        if (m_texts.contains(header))
            files.push_back(header);
        else if (const auto includes = m_includes.find(file);
                 includes != m_includes.end() && (!file.starts_with("tests/") || file.starts_with("tests/benchmark/")))
            files.push_back(firstOfFolder(includes->second, file.substr(0, file.rfind('/') + 1)));
        for (const std::string& id : strategiesIn(file))
            for (const std::string& test : testsOfStrategy(id, familyOf(file))) files.push_back(test);
        return files;
    }

private:
    /// The first include of a folder; where there is none, the first of all.
    [[nodiscard]] static std::string firstOfFolder(const std::vector<std::string>& includes, const std::string& folder) {
        for (const std::string& include : includes)
            if (include.starts_with(folder)) return include;
        return includes.front();
    }

    /// Whether a strategy's id stands for itself somewhere in quotes: "frustum" does not in "frustum-octree".
    [[nodiscard]] static bool nameStandsAlone(const std::string& text, const std::string& word) {
        for (size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + 1)) {
            const char before = at > 0 ? text[at - 1] : ' ';
            const char after = at + word.size() < text.size() ? text[at + word.size()] : ' ';
            // An id stands in quotes or in a list, with its parameters behind it: "all" is a word of many sentences, too.
            const bool path = word.find('/') != std::string::npos;
            const auto among = [](char c, std::string_view set) { return set.find(c) != std::string_view::npos; };
            if (path || (among(before, "\",") && among(after, "\",:."))) return true;
        }
        return false;
    }

    /// The folder of core/visibility that a source lies in.
    [[nodiscard]] static std::string familyOf(const std::string& file) {
        const size_t slash = file.rfind('/');
        return file.substr(file.rfind('/', slash - 1) + 1, slash - file.rfind('/', slash - 1) - 1);
    }

    /// The test files that judge a strategy. One that few files name is judged by all of them. One that many name is an example
    /// in most: it is judged by the tests of its layer and by those that have its family or a word of its id in their path.
    [[nodiscard]] std::vector<std::string> testsOfStrategy(const std::string& id, const std::string& family) const {
        std::vector<std::string> files = testFilesThatName(id);
        if (files.size() > kExampleFrom)
            std::erase_if(files, [&](const std::string& file) {
                if (file.starts_with("tests/core/visibility/") || file.find(family) != std::string::npos) return false;
                std::istringstream words(id);
                for (std::string word; std::getline(words, word, '-');)
                    if (file.find(word) != std::string::npos) return false;
                return true;
            });
        return files;
    }

    /// The ids of the strategies that a source of a family describes.
    [[nodiscard]] std::vector<std::string> strategiesIn(const std::string& file) const {
        static const std::regex kInfo(R"re(\w\(\)\s*\{\s*(?:return|StrategyInfo\s+\w+)\s*\{+\s*"([a-z][a-z-]*)")re");
        std::vector<std::string> ids;
        if (!file.starts_with("core/visibility/")) return ids;
        const std::string& text = m_texts.at(file);
        for (std::sregex_iterator match(text.begin(), text.end(), kInfo), end; match != end; ++match) ids.push_back((*match)[1]);
        return ids;
    }

    fs::path m_root;
    std::map<std::string, std::string> m_texts;
    std::map<std::string, std::vector<std::string>> m_includers, m_includes;
};

void addCases(TestSelection& selection, const Tree& tree, const std::string& file) {
    const std::string program = programOf(file);
    if (program.empty()) return;
    for (const Case& found : casesIn(tree.texts().at(file))) selection[program].push_back(found.filter);
}

/// Where a change of a file that is no source begins.
std::vector<std::string> startsOf(const Tree& tree, const fs::path& file) {
    const std::string name = file.generic_string();
    if (tree.texts().contains(name)) return {name};
    std::vector<std::string> starts;
    if (name.starts_with("resources/shaders/")) {
        for (const auto& [source, text] : tree.texts())
            if (text.find("#include \"embedded/") != std::string::npos && !source.starts_with("tests/")) starts.push_back(source);
        return starts;
    }
    const bool build = file.filename() == "CMakeLists.txt" || file.extension() == ".cmake" || name.starts_with("packaging/");
    if (!build && (name.starts_with("resources/") || name.starts_with("tests/")))
        starts = tree.testFilesThatName(file.parent_path().generic_string());
    // The rules read sources that are gone, pages, and what the build is made of.
    for (const auto& [source, text] : tree.texts())
        if (source.starts_with("tests/rules/") && isTestFile(source)) starts.push_back(source);
    return starts;
}

}  // namespace

TestSelection testsReached(const fs::path& root, const std::vector<fs::path>& changed) {
    const Tree tree(root);
    std::set<std::string> reached;
    std::deque<std::string> open;
    const auto reach = [&](const std::string& file) {
        if (tree.texts().contains(file) && reached.insert(file).second) open.push_back(file);
    };
    for (const fs::path& file : changed)
        for (const std::string& start : startsOf(tree, file)) reach(start);
    while (!open.empty()) {
        const std::string file = open.front();
        open.pop_front();
        for (const std::string& next : tree.next(file)) reach(next);
    }
    TestSelection selection;
    for (const std::string& file : reached) addCases(selection, tree, file);
    return selection;
}

TestSelection testsNamed(const fs::path& root, const std::string& name) {
    const Tree tree(root);
    TestSelection selection;
    for (const auto& [file, text] : tree.texts()) {
        const std::string program = programOf(file);
        if (program.empty()) continue;
        if (program == name) {
            selection[program] = {"*"};
            continue;
        }
        for (const Case& found : casesIn(text))
            if (found.suite == name) selection[program].push_back(found.filter);
    }
    return selection;
}

std::vector<std::string> testPrograms(const fs::path& root) {
    std::set<std::string> programs;
    const Tree tree(root);
    for (const auto& [file, text] : tree.texts())
        if (const std::string program = programOf(file); !program.empty()) programs.insert(program);
    return {programs.begin(), programs.end()};
}

}  // namespace cullscope::rules
