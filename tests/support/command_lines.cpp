#include "tests/support/command_lines.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <csignal>
#include <fstream>
#include <mutex>
#include <thread>

#include "core/base/terminal_text.h"

namespace cullscope::test {
namespace {

/// The longest sentence besides the words that it repeats.
constexpr size_t kLongestSentence = 500;
/// So much of an output is looked at.
constexpr size_t kMostOutput = size_t{1} << 20;

std::string contents(const std::filesystem::path& path) {
    std::ifstream in(path, std::ios::binary);
    std::string text(kMostOutput, '\0');
    in.read(text.data(), static_cast<std::streamsize>(text.size()));
    text.resize(static_cast<size_t>(in.gcount()));
    return text;
}

/// Arguments or environment as `execve` takes them.
class Words {
public:
    explicit Words(const std::vector<std::string>& words) : m_words(words) {
        for (std::string& word : m_words) m_pointers.push_back(word.data());
        m_pointers.push_back(nullptr);
    }
    [[nodiscard]] char* const* data() const { return m_pointers.data(); }

private:
    std::vector<std::string> m_words;
    std::vector<char*> m_pointers;
};

std::vector<std::string> environmentOf(const CommandLine& line) {
    std::vector<std::string> all;
    for (char** each = environ; *each != nullptr; ++each) {
        const std::string pair = *each;
        const std::string name = pair.substr(0, pair.find('='));
        if (std::ranges::none_of(line.set, [&](const auto& set) { return set.first == name; })) all.push_back(pair);
    }
    for (const auto& [name, value] : line.set)
        if (!value.empty()) all.push_back(name + "=" + value);
    return all;
}

/// In the child: nothing here may allocate, because other threads may have been in the allocator.
void connect(Stream stream, int descriptor, const char* file, int flags) {
    if (stream == Stream::Closed) {
        close(descriptor);
        return;
    }
    std::array<int, 2> ends{-1, -1};
    int opened = -1;
    if (stream == Stream::ReaderGone && pipe(ends.data()) == 0) {
        close(ends[0]);
        opened = ends[1];
    } else {
        opened = open(stream == Stream::Full ? "/dev/full" : file, flags, 0600);
    }
    if (opened == descriptor) return;
    dup2(opened, descriptor);
    close(opened);
}

/// In the child. The limit is on all threads of a user, and does not hold for root.
bool limitThreads(uint64_t most) {
    constexpr uid_t kNobody = 65534;
    const rlimit threads{most, most};
    return setrlimit(RLIMIT_NPROC, &threads) == 0 && (geteuid() != 0 || setuid(kNobody) == 0);
}

class Runner {
public:
    Runner(std::string program, std::filesystem::path folder, double mostSeconds)
        : m_program(std::move(program)),
          m_work(folder / "work"),
          m_out((folder / "out").string()),
          m_err((folder / "err").string()),
          m_mostSeconds(mostSeconds) {
        std::filesystem::create_directories(folder);
    }

    [[nodiscard]] CommandEnd run(const CommandLine& line) const {
        std::filesystem::remove_all(m_work);
        std::filesystem::create_directories(m_work);
        std::filesystem::remove(m_out);
        std::filesystem::remove(m_err);
        std::vector<std::string> words = line.words;
        words.insert(words.begin(), m_program);
        const Words arguments(words), environment(environmentOf(line));
        const std::string work = m_work.string();
        const pid_t child = fork();
        if (child == 0) {
            if (chdir(work.c_str()) != 0 || (line.folderGone && rmdir(work.c_str()) != 0)) _exit(126);
            const rlimit memory{line.mostMemory, line.mostMemory};
            if (line.mostMemory > 0 && setrlimit(RLIMIT_AS, &memory) != 0) _exit(126);
            connect(line.out, STDOUT_FILENO, m_out.c_str(), O_WRONLY | O_CREAT | O_TRUNC);
            connect(line.err, STDERR_FILENO, m_err.c_str(), O_WRONLY | O_CREAT | O_TRUNC);
            connect(line.in, STDIN_FILENO, "/dev/null", O_RDONLY);
            // Last, because the user for whom it holds may open nothing here.
            if (line.mostThreads > 0 && !limitThreads(line.mostThreads)) _exit(126);
            execve(m_program.c_str(), arguments.data(), environment.data());
            _exit(127);
        }
        return endOf(child);
    }

private:
    [[nodiscard]] CommandEnd endOf(pid_t child) const {
        using Clock = std::chrono::steady_clock;
        CommandEnd end;
        end.folder = m_work;
        const Clock::time_point last =
            Clock::now() + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(m_mostSeconds));
        int status = 0;
        while (waitpid(child, &status, WNOHANG) == 0) {
            std::this_thread::sleep_for(std::chrono::milliseconds(2));
            if (Clock::now() < last || end.tooLong) continue;
            end.tooLong = true;
            kill(child, SIGKILL);
        }
        if (WIFEXITED(status)) end.status = WEXITSTATUS(status);
        if (WIFSIGNALED(status)) end.signal = WTERMSIG(status);
        end.out = contents(m_out);
        end.err = contents(m_err);
        return end;
    }

    std::string m_program;
    std::filesystem::path m_work;
    std::string m_out, m_err;
    double m_mostSeconds;
};

std::string quoted(const std::string& word) {
    constexpr std::string_view kPlain = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-./=:,%+@";
    if (!word.empty() && word.find_first_not_of(kPlain) == std::string::npos) return word;
    const bool visible = terminalLine(word) == word;
    std::string text = visible ? "'" : "$'";
    for (const char c : word) {
        const auto byte = static_cast<unsigned char>(c);
        if (visible)
            text += c == '\'' ? std::string("'\\''") : std::string(1, c);
        else if (byte < 0x20 || byte > 0x7E)
            text += fmt::format("\\x{:02x}", byte);
        else
            text += c == '\'' || c == '\\' ? std::string("\\") + c : std::string(1, c);
    }
    return text + "'";
}

std::string redirected(const char* descriptor, Stream stream) {
    if (stream == Stream::Closed) return std::string(" ") + descriptor + "&-";
    if (stream == Stream::Full) return std::string(" ") + descriptor + "/dev/full";
    return "";
}

bool isBinary(const std::string& out) { return out.starts_with("\x89PNG") || out.find('\0') != std::string::npos; }

std::string faultOfSentences(const std::string& program, const CommandLine& line, const CommandEnd& end, Said said) {
    if (line.err != Stream::Usual) return "";
    size_t longest = kLongestSentence;
    for (const std::string& word : line.words) longest += word.size();
    // Where data go to standard output, what else is printed comes before the error.
    const bool alone = said == Said::ByProgram && std::ranges::find(line.words, "-") == line.words.end();
    bool named = false;
    for (size_t from = 0; from < end.err.size();) {
        const size_t to = std::min(end.err.find('\n', from), end.err.size());
        const std::string sentence = end.err.substr(from, to - from);
        const bool ofProgram = sentence.starts_with(program + ": ");
        named = named || ofProgram;
        if (alone && !ofProgram && sentence != "Run with --help for more information.")
            return "a line of the error does not begin with the program's name";
        if (sentence.size() > longest) return "a sentence is too long";
        from = to + 1;
    }
    return named ? "" : "it does not say the error";
}

}  // namespace

std::string CommandLine::text(const std::string& program) const {
    std::string text;
    if (mostMemory > 0) text += fmt::format("ulimit -v {}; ", mostMemory / 1024);
    if (mostThreads > 0) text += fmt::format("ulimit -u {}; ", mostThreads);
    if (folderGone) text += "mkdir gone; cd gone; rmdir ../gone; ";
    for (const auto& [name, value] : set) text += name + "=" + quoted(value) + " ";
    text += program;
    for (const std::string& word : words) text += " " + quoted(word);
    text += redirected("<", in) + redirected(">", out) + redirected("2>", err);
    if (out == Stream::ReaderGone) text += " | true";
    return text;
}

void runCommandLines(const std::string& program, const std::vector<CommandLine>& lines, const std::filesystem::path& folder,
                     int together, double mostSeconds, const std::function<void(size_t, const CommandEnd&)>& done) {
    std::atomic<size_t> next{0};
    std::mutex mutex;
    std::vector<std::jthread> threads;
    for (int i = 0; i < together; ++i)
        threads.emplace_back([&, runner = Runner(program, folder / std::to_string(i), mostSeconds)] {
            for (size_t line = next++; line < lines.size(); line = next++) {
                const CommandEnd end = runner.run(lines[line]);
                const std::lock_guard lock(mutex);
                done(line, end);
            }
        });
    threads.clear();
    std::filesystem::remove_all(folder);
}

std::string faultOf(const std::string& program, const CommandLine& line, const CommandEnd& end, Said said) {
    constexpr std::array kStatuses{0, 1, 2, 3, 4, 130};
    if (end.tooLong) return "it does not end";
    if (end.signal != 0) return fmt::format("signal {} ends it", end.signal);
    if (std::ranges::find(kStatuses, end.status) == kStatuses.end()) return "its exit status is none of the table";
    for (const char* words : {"terminate called", "what():", "std::", "basic_string", "filesystem error", "Assertion", "stoi",
                              "vector::", "map::at", "bad_alloc"})
        if (end.err.find(words) != std::string::npos) return fmt::format("it says \"{}\"", words);
    if (terminalText(end.err) != end.err) return "standard error has control characters";
    if (!isBinary(end.out) && terminalText(end.out) != end.out) return "standard output has control characters";
    if (end.status >= 2)
        if (const std::string fault = faultOfSentences(program, line, end, said); !fault.empty()) return fault;
    std::error_code gone;
    for (std::filesystem::directory_iterator entry(end.folder, gone), last; !gone && entry != last; entry.increment(gone))
        if (entry->path().filename().string().ends_with(".cullscope-part")) return "a temporary file is left";
    return "";
}

}  // namespace cullscope::test
