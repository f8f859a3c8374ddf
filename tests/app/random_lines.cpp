#include "tests/app/random_lines.h"

#include <algorithm>
#include <array>
#include <random>

#include "tests/app/line_pieces.h"

namespace cullbench_random_lines {
namespace {

using cullscope::test::Stream;

/// An option with its value, or a positional word where the option is empty.
struct Part {
    std::string option;
    std::string value;
    bool repeatable = false;
};

class Maker {
public:
    explicit Maker(uint64_t seed) : m_random(seed) {}

    RandomLine make() {
        const size_t hostile = below(8) == 0 ? 0 : 1 + below(3);
        addCommand();
        for (size_t i = 0; i < hostile; ++i) spoil();
        if (below(6) == 0) disturbStreams();
        return finished();
    }

private:
    size_t below(size_t count) { return static_cast<size_t>(m_random() % count); }
    template <typename List>
    const auto& oneOf(const List& list) {
        return list[below(list.size())];
    }

    // ---- Valid lines

    void addCommand() {
        constexpr std::array kCommands{"list",   "render",  "render",  "measure", "measure",  "sweep",
                                       "export", "inspect", "inspect", "path",    "reproduce"};
        m_command = oneOf(kCommands);
        if (m_command == "list") return addList();
        if (m_command == "reproduce") return addReproduce();
        if (m_command == "path") add("", oneOf(kPaths));
        add("", oneOf(kScenes));
        if (m_command == "render" || m_command == "inspect") add("-s", oneOf(kStrategies));
        if (m_command == "measure") add("-s", oneOf(kStrategies), true);
        if (m_command == "sweep") {
            add("-s", "spherical", true);
            add("--vary", "rows=45,90", true);
        }
        if (m_command == "measure" || m_command == "sweep") {
            add("--path", oneOf(kPaths));
            add("--repeat", "1");
            if (below(3) == 0) add("--windows", oneOf(std::array{"1", "4"}));
            if (below(3) == 0) add("--upload", oneOf(std::array{"vbo", "vertex-array"}));
        }
        if (m_command == "render") addCamera();
        if (m_command != "export" && m_command != "inspect" && m_command != "path") add("--size", oneOf(kSizes));
        addOutputs();
        if (below(8) == 0) add("--models", "none", true);
    }
    void addList() {
        if (below(2) == 0) add("", oneOf(std::array{"scenes", "strategies", "experiments"}));
        m_hasFlag = below(2) == 0;
        m_flag = "--json";
    }
    void addReproduce() {
        add("", oneOf(std::array{"quiz", "example"}));
        if (below(2) == 0) add("--json", output("out.json"));
    }
    void addCamera() {
        switch (below(4)) {
            case 0:
                add("--eye", "3,1,2");
                add("--target", "0,0,0");
                break;
            case 1:
                add("--path", oneOf(kPaths));
                add("--pose", "0");
                break;
            case 2:
                add("--fovx", "40");
                add("--near", "0.1");
                add("--far", "50");
                break;
            default:
                break;
        }
        if (below(4) == 0) add("--overlay", "verdicts", true);
        if (below(4) == 0) add("--step", "0");
        if (below(4) == 0) add("--background", "00FF7f");
    }
    void addOutputs() {
        if (m_command == "render") add("-o", below(4) == 0 ? "-" : output(oneOf(std::array{"out.png", "out.jpg"})));
        if (m_command == "export")
            add("-o", below(4) == 0 ? "-" : output(oneOf(std::array{"out.obj", "out.ply", "out.stl", "o\x1b[1m.obj"})));
        if (m_command == "path") add("-o", below(4) == 0 ? "-" : output("out.json"));
        const bool results = m_command == "measure" || m_command == "sweep";
        if (results || m_command == "inspect")
            if (const size_t which = below(3); which > 0) add("--json", which == 1 ? "-" : output("out.json"));
        if (results && below(2) == 0) add("--csv", output("out.csv"));
    }

    void add(const std::string& option, const std::string& value, bool repeatable = false) {
        m_parts.push_back({option, value, repeatable});
    }
    std::string output(const std::string& name) {
        m_outputs.push_back(name);
        return name;
    }

    // ---- Hostile pieces

    void allow(const std::set<int>& statuses) {
        m_mayPass = m_mayPass && statuses.contains(0);
        for (const int status : statuses)
            if (status != 0) m_errors.insert(status);
    }

    void spoil() {
        switch (below(6)) {
            case 0:
                return spoilWords();
            case 1:
                return addHostileOption();
            default:
                return spoilValue();
        }
    }

    /// A hostile value in place of a valid one.
    void spoilValue() {
        if (m_parts.empty()) return spoilWords();
        const size_t at = below(m_parts.size());
        // A value that was spoilt already may have had another kind of status.
        if (m_spoilt.contains(at)) return;
        m_spoilt.insert(at);
        const HostileValue& hostile = oneOf(hostileValues(m_command, m_parts[at].option, at));
        m_parts[at].value = hostile.value;
        allow(hostile.statuses);
    }
    void addHostileOption() {
        const std::string option =
            oneOf(std::array{"--near", "--fovx", "--hide", "--json", "--path", "-p", "--size", "--models"});
        const bool given =
            std::ranges::any_of(m_parts, [&](const Part& part) { return part.option == option && !part.repeatable; });
        m_spoilt.insert(m_parts.size());
        const HostileValue& hostile = oneOf(hostileValues(m_command, option, 1));
        add(option, hostile.value, option == "--models" || option == "-p");
        if (given || !commandTakes(m_command, option))
            allow({2});
        else
            allow(hostile.statuses);
    }
    void spoilWords() {
        switch (below(6)) {
            case 0:  // an unknown option
                m_last = {oneOf(std::array{"--nonsense", "-x", "---", "--sizes=1", "--\x1b[31m"})};
                return allow({2});
            case 1:  // a word too many
                m_last = {"more", "words", "than", "it takes"};
                return allow({2});
            case 2:  // an option without its value
                m_last = {commandTakes(m_command, "-s") ? "-s" : "--models"};
                return allow({2});
            case 3:  // an option that may be given once
                for (const Part& part : m_parts)
                    if (!part.option.empty() && !part.repeatable) {
                        m_last = {part.option, part.value};
                        return allow({2});
                    }
                return;
            case 4:  // another command
                m_command = oneOf(std::array{"frobnicate", "", "-", "Measure", "\x1b[2J", "measure measure"});
                return allow({2});
            default:  // what is required
                if (m_parts.empty() || !m_spoilt.empty() || m_shortened || m_command == "reproduce") return;
                m_parts.erase(m_parts.begin());
                m_shortened = true;
                return allow(m_command == "list" ? std::set<int>{0} : std::set<int>{2, 3});
        }
    }

    // ---- Surroundings

    [[nodiscard]] bool dataOnOutput() const {
        return std::ranges::any_of(m_parts, [](const Part& part) { return part.value == "-"; });
    }
    void disturbStreams() {
        switch (below(5)) {
            case 0:
                m_line.out = oneOf(std::array{Stream::Closed, Stream::Full});
                return allow({2});
            case 1:
                m_line.err = oneOf(std::array{Stream::Closed, Stream::Full});
                return;
            case 2:
                m_line.in = Stream::Closed;
                return;
            case 3:
                m_line.out = Stream::ReaderGone;
                if (dataOnOutput()) allow({0, 2});
                return;
            default:
                // Files are neither found from a folder that is gone, nor written there.
                m_line.folderGone = true;
                return allow({0, 2, 3});
        }
    }

    RandomLine finished() {
        RandomLine made{m_line, m_errors, m_outputs};
        if (m_mayPass) made.statuses.insert(0);
        made.line.words.push_back(m_command);
        const bool positionalLast = below(2) == 0 && !m_shortened && m_command != "path";
        for (int pass = 0; pass < 2; ++pass)
            for (const Part& part : m_parts) {
                if (part.option.empty() != ((pass == 1) == positionalLast)) continue;
                if (part.option.starts_with("--") && below(3) == 0)
                    made.line.words.push_back(part.option + "=" + part.value);
                else {
                    if (!part.option.empty()) made.line.words.push_back(part.option);
                    made.line.words.push_back(part.value);
                }
            }
        if (m_hasFlag) made.line.words.push_back(m_flag);
        made.line.words.insert(made.line.words.end(), m_last.begin(), m_last.end());
        return made;
    }

    std::mt19937_64 m_random;
    cullscope::test::CommandLine m_line;
    std::string m_command, m_flag;
    std::vector<Part> m_parts;
    std::vector<std::string> m_last, m_outputs;
    std::set<size_t> m_spoilt;
    std::set<int> m_errors;
    bool m_mayPass = true, m_hasFlag = false, m_shortened = false;
};

}  // namespace

RandomLine randomLine(uint64_t seed) { return Maker(seed).make(); }

}  // namespace cullbench_random_lines
