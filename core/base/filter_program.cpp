#include "core/base/filter_program.h"

#include <poll.h>
#include <spawn.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <cstring>
#include <thread>
#include <vector>

#include "core/base/error.h"

namespace cullscope {
namespace {

/// A file in memory that a process can have as a standard stream: unlike a pipe, it needs no reader meanwhile.
class StreamInMemory {
public:
    StreamInMemory() : m_file(memfd_create("cullscope", MFD_CLOEXEC)) {
        if (m_file < 0) refuse();
    }
    ~StreamInMemory() { close(m_file); }
    StreamInMemory(const StreamInMemory&) = delete;
    StreamInMemory& operator=(const StreamInMemory&) = delete;

    [[nodiscard]] int file() const { return m_file; }

    void fill(std::string_view content) {
        while (!content.empty()) {
            const ssize_t written = write(m_file, content.data(), content.size());
            if (written < 0 && errno == EINTR) continue;
            if (written <= 0) refuse();
            content.remove_prefix(size_t(written));
        }
        lseek(m_file, 0, SEEK_SET);
    }

    [[nodiscard]] std::string content() const {
        struct stat about {};
        fstat(m_file, &about);
        std::string text(size_t(about.st_size), '\0');
        size_t got = 0;
        while (got < text.size()) {
            const ssize_t read = pread(m_file, text.data() + got, text.size() - got, off_t(got));
            if (read < 0 && errno == EINTR) continue;
            if (read <= 0) break;
            got += size_t(read);
        }
        text.resize(got);
        return text;
    }

private:
    [[noreturn]] static void refuse() {
        throwInput(CULLSCOPE_TR("A file cannot be converted in memory: %1. Close other programs."), {std::strerror(errno)});
    }

    int m_file;
};

int statusOf(pid_t process, const Progress& progress) {
    for (;;) {
        int status = 0;
        const pid_t ended = waitpid(process, &status, WNOHANG);
        if (ended == process) return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
        if (ended < 0 && errno != EINTR) return -1;
        if (progress.stopRequested()) {
            kill(process, SIGKILL);
            waitpid(process, &status, 0);
            progress.check();
        }
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
}

}  // namespace

std::filesystem::path ownLibraryFile(std::string_view name) {
    std::error_code unknown;
    const std::filesystem::path program = std::filesystem::read_symlink("/proc/self/exe", unknown);
    return (program.parent_path() / ".." / "lib" / "cullscope" / name).lexically_normal();
}

Filtered runFilter(const std::filesystem::path& program, std::span<const std::string> arguments, std::string_view input,
                   const Progress& progress) {
    std::array<StreamInMemory, 3> streams;
    streams[STDIN_FILENO].fill(input);
    std::string name = program.string();
    std::vector<std::string> words(arguments.begin(), arguments.end());
    std::vector<char*> pointers{name.data()};
    for (std::string& word : words) pointers.push_back(word.data());
    pointers.push_back(nullptr);

    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    for (int i = 0; i < 3; ++i) posix_spawn_file_actions_adddup2(&actions, streams[size_t(i)].file(), i);
    pid_t process = 0;
    const int failure = posix_spawn(&process, name.c_str(), &actions, nullptr, pointers.data(), environ);
    posix_spawn_file_actions_destroy(&actions);
    if (failure != 0)
        throwUsage(CULLSCOPE_TR("%1 cannot be started: %2. Install or build Cullscope again."), {name, std::strerror(failure)});
    const int status = statusOf(process, progress);
    return {streams[STDOUT_FILENO].content(), streams[STDERR_FILENO].content(), status};
}

}  // namespace cullscope
