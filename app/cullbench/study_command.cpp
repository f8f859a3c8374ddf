#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>
#include <wordexp.h>

#include <algorithm>
#include <array>
#include <csignal>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <stop_token>

#include "app/cullbench/commands.h"
#include "app/cullbench/output.h"
#include "core/base/error.h"

namespace cullscope::cullbench {
namespace {

struct StudyOptions {
    std::string file, store, shard = "1/1";
};

/// A command of a study, without the program's name.
struct StudyLine {
    int number = 0;  ///< in the file, from 1
    std::vector<std::string> words;
};

/// Commands whose results go into a store.
constexpr std::array<std::string_view, 8> kCommands{"measure", "sweep",     "race",  "certify",
                                                    "advise",  "stability", "worst", "judge"};

std::string commands() {
    std::string list;
    for (const std::string_view command : kCommands) list.append(list.empty() ? "" : ", ").append(command);
    return list;
}

/// Cut into words as a shell does: quotes, variables such as $HOME, patterns such as *.obj; no command is run for it.
std::vector<std::string> wordsOf(const std::string& line, const std::string& place) {
    wordexp_t cut{};
    const int failure = wordexp(line.c_str(), &cut, WRDE_NOCMD | WRDE_UNDEF);
    std::vector<std::string> words;
    if (failure == 0) words.assign(cut.we_wordv, cut.we_wordv + cut.we_wordc);
    if (failure == 0 || failure == WRDE_NOSPACE) wordfree(&cut);
    if (failure == WRDE_BADVAL)
        throwInput(CULLSCOPE_TR("%1: names a variable that is not set. Set it, or write it out."), {place});
    if (failure == WRDE_BADCHAR)
        throwInput(CULLSCOPE_TR("%1: has one of the characters | & ; < > ( ) { } outside of quotes. A line is one command of "
                                "cullbench."),
                   {place});
    if (failure != 0) throwInput(CULLSCOPE_TR("%1: cannot be cut into words. Close its quotes."), {place});
    return words;
}

std::vector<StudyLine> linesOf(const std::string& file) {
    std::ifstream in(file);
    if (!in) throwInput(CULLSCOPE_TR("%1 cannot be opened: check the name and that you may read it."), {file});
    std::vector<StudyLine> lines;
    int number = 0;
    for (std::string text; std::getline(in, text);) {
        ++number;
        const size_t begin = text.find_first_not_of(" \t\r");
        if (begin == std::string::npos || text[begin] == '#') continue;
        const std::string place = file + ", line " + std::to_string(number);
        StudyLine line{number, wordsOf(text, place)};
        if (!line.words.empty() && line.words.front() == "cullbench") line.words.erase(line.words.begin());
        if (line.words.empty() || std::ranges::find(kCommands, line.words.front()) == kCommands.end())
            throwInput(CULLSCOPE_TR("%1: does not begin with one of the commands %2."), {place, commands()});
        for (const std::string& word : line.words)
            if (word == "--store" || word.starts_with("--store="))
                throwInput(CULLSCOPE_TR("%1: leave out --store, which is that of the study."), {place});
        lines.push_back(std::move(line));
    }
    if (lines.empty())
        throwInput(CULLSCOPE_TR("%1 has no command. Write one a line, such as measure bunny -s all,frustum."), {file});
    return lines;
}

/// A command without the store that it writes to, which a line of a study has last: what was merged was written to another one.
std::string withoutStore(const std::string& command) { return command.substr(0, command.rfind(" --store ")); }

/// What the line measured is in the store as a whole. Certificates have state files of their own.
bool isDone(const store::ResultStore& opened, const std::string& command) {
    const std::vector<store::Listed> all = opened.list();
    const std::vector<store::StoredReport> reports = opened.reports();
    const auto same = [&](const std::string& other) { return withoutStore(other) == withoutStore(command); };
    return std::ranges::any_of(
               all, [&](const store::Listed& one) { return same(one.origin.command) && one.ended && !one.interrupted; }) ||
           std::ranges::any_of(reports, [&](const store::StoredReport& one) { return same(one.report.command); });
}

/// Measurements that a killed run of the line left unfinished: they would stand beside those that replace them.
void removeUnfinished(const store::ResultStore& opened, const std::string& command) {
    for (const store::Listed& one : opened.list())
        if (withoutStore(one.origin.command) == withoutStore(command) && (!one.ended || one.interrupted))
            opened.remove(one.number);
}

/// Runs the program with these words and returns its exit status; a signal's is 128 and its number, as a shell has it. A stop
/// request reaches it as Ctrl-C does.
int run(std::vector<std::string> words, const std::stop_token& stop) {
    words.insert(words.begin(), "cullbench");
    std::vector<char*> pointers;
    for (std::string& word : words) pointers.push_back(word.data());
    pointers.push_back(nullptr);
    pid_t process = 0;
    if (const int failure = posix_spawn(&process, "/proc/self/exe", nullptr, nullptr, pointers.data(), environ); failure != 0)
        throwUsage(CULLSCOPE_TR("A command of the study cannot be started: %1."), {std::strerror(failure)});
    const std::stop_callback passOn(stop, [process] { kill(process, SIGINT); });
    int status = 0;
    while (waitpid(process, &status, 0) < 0 && errno == EINTR) {
    }
    return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

void study(const StudyOptions& options, Context& context) {
    const auto [shard, shards] = shardFromText(options.shard);
    const std::vector<StudyLine> lines = linesOf(options.file);
    const store::ResultStore opened(options.store);
    std::vector<std::string> failures;
    for (size_t i = shard - 1; i < lines.size() && !context.stop.stop_requested(); i += shards) {
        const StudyLine& line = lines[i];
        std::vector<std::string> words;
        for (const std::filesystem::path& folder : context.sceneOptions.modelFolders)
            words.insert(words.end(), {"--models", folder.string()});
        words.insert(words.end(), line.words.begin(), line.words.end());
        const bool certifies = line.words.front() == "certify";
        if (certifies && std::ranges::find(words, "--state") == words.end())
            words.insert(words.end(), {"--state", options.store + ".line-" + std::to_string(line.number) + ".json"});
        words.insert(words.end(), {"--store", options.store});
        const std::string command = commandLine(words);
        if (!certifies && isDone(opened, command)) {
            say(stderr, "cullbench: line {} is done: {}\n", line.number, command);
            continue;
        }
        if (!certifies) removeUnfinished(opened, command);
        say(stderr, "cullbench: line {}: {}\n", line.number, command);
        const int status = run(std::move(words), context.stop);
        if (status == static_cast<int>(ErrorKind::Interrupted)) break;
        if (status > 1) failures.push_back(std::to_string(line.number) + " (" + std::to_string(status) + ")");
        if (status > 0) context.exitStatus = std::max(context.exitStatus, 1);
    }
    if (context.stop.stop_requested()) context.exitStatus = static_cast<int>(ErrorKind::Interrupted);
    if (failures.empty()) return;
    std::string list;
    for (const std::string& each : failures) list += (list.empty() ? "" : ", ") + each;
    throwInput(CULLSCOPE_TR("Lines of the study that failed, with their exit status: %1. What they said stands above; the other "
                            "lines are done, and starting the study again tries these alone."),
               {list});
}

}  // namespace

void addStudyCommand(CLI::App& app, Context& context) {
    CLI::App* command = app.add_subcommand("study", "Many commands, one after the other or on many machines, into one store");
    auto options = std::make_shared<StudyOptions>();
    command->add_option("FILE", options->file, "text file: " + commands() + " with their options, one a line")->required();
    command->add_option("--store", options->store, "result store (SQLite) that everything goes into")->required();
    command->add_option("--shard", options->shard, "I/N: the I-th of every N lines, from 1");
    command->callback([options, &context] { study(*options, context); });
}

}  // namespace cullscope::cullbench
