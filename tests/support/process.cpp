#include "tests/support/process.h"

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <thread>

namespace cullscope::test {
namespace {

std::string contents(const std::string& path) {
    std::ifstream in(path, std::ios::binary);
    std::ostringstream text;
    text << in.rdbuf();
    return text.str();
}

void redirect(const std::string& path, int flags, int descriptor) {
    const int opened = open(path.c_str(), flags, 0600);
    dup2(opened, descriptor);
    close(opened);
}

/// Whether a program has ended or handles SIGINT itself (blocks it for a thread that waits for it, or has a handler), as reported
/// by the kernel.
bool takesInterrupts(pid_t program) {
    std::istringstream status(contents("/proc/" + std::to_string(program) + "/status"));
    const uint64_t interrupt = uint64_t(1) << (SIGINT - 1);
    for (std::string line; std::getline(status, line);) {
        if (line.starts_with("State:") && line.find('Z') != std::string::npos) return true;
        if (!line.starts_with("SigBlk:") && !line.starts_with("SigCgt:")) continue;
        if ((std::stoull(line.substr(line.find('\t') + 1), nullptr, 16) & interrupt) != 0) return true;
    }
    return false;
}

/// On a busy machine a program may need seconds to start; an interrupt before its handler is set would not test it.
void waitUntilItTakesInterrupts(pid_t program) {
    for (int tries = 0; tries < 12000 && !takesInterrupts(program); ++tries)
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
}

}  // namespace

ProcessResult runProcess(const std::vector<std::string>& command, const std::vector<std::string>& environment,
                         double interruptAfterSeconds) {
    // Files instead of pipes: a program that prints much would block without a reader.
    std::string folder = (std::filesystem::temp_directory_path() / "cullscope-process-XXXXXX").string();
    if (mkdtemp(folder.data()) == nullptr) return {};
    std::vector<char*> arguments;
    for (const std::string& word : command) arguments.push_back(const_cast<char*>(word.c_str()));
    arguments.push_back(nullptr);
    const pid_t child = fork();
    if (child == 0) {
        redirect("/dev/null", O_RDONLY, STDIN_FILENO);
        redirect(folder + "/out", O_WRONLY | O_CREAT | O_TRUNC, STDOUT_FILENO);
        redirect(folder + "/err", O_WRONLY | O_CREAT | O_TRUNC, STDERR_FILENO);
        for (const std::string& pair : environment) putenv(const_cast<char*>(pair.c_str()));
        execv(arguments[0], arguments.data());
        _exit(127);
    }
    if (interruptAfterSeconds > 0.0) {
        waitUntilItTakesInterrupts(child);
        std::this_thread::sleep_for(std::chrono::duration<double>(interruptAfterSeconds));
        kill(child, SIGINT);
    }
    int status = 0;
    waitpid(child, &status, 0);
    ProcessResult result{WIFEXITED(status) ? WEXITSTATUS(status) : -1, contents(folder + "/out"), contents(folder + "/err")};
    std::filesystem::remove_all(folder);
    return result;
}

}  // namespace cullscope::test
