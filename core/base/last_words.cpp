#include "core/base/last_words.h"

#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <exception>

#include "core/base/error.h"
#include "core/base/memory_limit.h"

namespace cullscope {
namespace {

void writeError(const char* text) { [[maybe_unused]] const ssize_t written = write(STDERR_FILENO, text, std::strlen(text)); }

std::atomic<void (*)()> s_look{nullptr};
std::atomic<bool> s_exitsAreLibraries{false};

void endWhereShort() {
    if (memoryIsShort() || threadsAreShort()) endForWant();
}

void onExit() {
    if (s_exitsAreLibraries) endWhereShort();
}

void endOrCrash(int signal) {
    endWhereShort();
    if (void (*const look)() = s_look) look();
    // The handler was removed when it was called, and its signal is not blocked.
    std::raise(signal);
}

}  // namespace

ExitsForWant::ExitsForWant() {
    static const int registered = std::atexit(onExit);
    static_cast<void>(registered);
    s_exitsAreLibraries = true;
}

ExitsForWant::~ExitsForWant() { s_exitsAreLibraries = false; }

void endForWant() {
    // Threads may crash at the same time.
    static std::atomic_flag ending = ATOMIC_FLAG_INIT;
    while (ending.test_and_set()) pause();
    writeError(program_invocation_short_name);
    writeError(
        ": It cannot go on, most likely for want of memory or threads. Use a smaller scene, close other programs, or allow this "
        "one more (ulimit).\n");
    _exit(static_cast<int>(ErrorKind::Input));
}

void lookAtCrashes(void (*look)()) { s_look = look; }

void endWithSentenceOnTerminate() { std::set_terminate(endForWant); }

void endWithSentenceOnWant() {
    // The main thread's stack may be what cannot grow.
    static std::array<char, size_t{64} << 10> stack;
    const stack_t own{stack.data(), 0, stack.size()};
    sigaltstack(&own, nullptr);
    struct sigaction action {};
    action.sa_handler = endOrCrash;
    action.sa_flags = SA_RESETHAND | SA_NODEFER | static_cast<int>(SA_ONSTACK);
    for (const int signal : {SIGSEGV, SIGBUS, SIGABRT, SIGILL, SIGFPE, SIGTRAP}) sigaction(signal, &action, nullptr);
}

}  // namespace cullscope
