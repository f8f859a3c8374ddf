#include "ui/startup/abrupt_end.h"

#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>
#include <thread>
#include <utility>

#include "core/base/error.h"
#include "core/base/last_words.h"
#include "core/base/memory_limit.h"

namespace cullscope::ui {

namespace {

std::atomic<bool> s_watching{false};
QtMessageHandler s_previous = nullptr;
std::function<bool()> s_keep;
std::thread::id s_keepingThread;

bool kept() {
    if (!s_keep || std::this_thread::get_id() != s_keepingThread) return false;
    try {
        return s_keep();
    } catch (...) {
        return false;
    }
}

enum class Keeping { Yes, No };

[[noreturn]] void end(ErrorKind kind, const char* sentence, Keeping keeping) {
    static std::atomic_flag ending = ATOMIC_FLAG_INIT;
    static thread_local bool endingHere = false;
    // Another thread has begun to end the program.
    while (!endingHere && ending.test_and_set()) pause();
    // What keeps the session may meet the same want.
    const bool isKept = !std::exchange(endingHere, true) && keeping == Keeping::Yes && kept();
    std::fprintf(stderr, "cullscope: %s%s\n", sentence,
                 isKept ? " The session is kept in a file that the next start offers." : "");
    std::_Exit(int(kind));
}

constexpr const char* kDisplayBroke = "The connection to the display broke.";

/// Of `exit`: the program itself ends by returning from main, when this is not watched any more. What ends it so are Xlib and the
/// parts of Qt for X11 and Wayland, on the thread that meets the broken connection, and libraries that are refused memory.
/// Objects that the session needs may be destroyed by then.
void onExit() {
    if (!s_watching) return;
    if (memoryIsShort() || threadsAreShort()) endForWant();
    end(ErrorKind::OpenGl, kDisplayBroke, Keeping::No);
}

// ---- Crashes

/// Where this machine's X server listens, in the file system and beside it.
std::array<sockaddr_un, 2> s_display;
std::atomic<bool> s_displayKnown{false};  ///< not of a display of another kind

void findDisplay() {
    const std::string name = qEnvironmentVariable("DISPLAY").toStdString();
    const std::string number = name.substr(0, name.find('.'));
    if (number.size() < 2 || number.size() > 9 || number[0] != ':') return;
    const std::string file = "/tmp/.X11-unix/X" + number.substr(1);
    for (size_t i = 0; i < s_display.size(); ++i) {
        s_display[i] = {};
        s_display[i].sun_family = AF_UNIX;
        // Linux's names outside of the file system begin with a zero.
        std::memcpy(s_display[i].sun_path + i, file.data(), file.size());
    }
    s_displayKnown = true;
}

bool answers(const sockaddr_un& address) {
    const bool inFileSystem = address.sun_path[0] != '\0';
    const size_t letters = inFileSystem ? std::strlen(address.sun_path) + 1 : std::strlen(address.sun_path + 1) + 1;
    const int descriptor = socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0);
    const int status = connect(descriptor, reinterpret_cast<const sockaddr*>(&address),
                               static_cast<socklen_t>(offsetof(sockaddr_un, sun_path) + letters));
    const bool refused = status != 0 && (errno == ECONNREFUSED || errno == ENOENT);
    close(descriptor);
    return !refused;
}

/// In a signal handler. The libraries of OpenGL use answers that a display did not give.
void endWhereDisplayIsGone() {
    if (!s_watching || !s_displayKnown || answers(s_display[0]) || answers(s_display[1])) return;
    constexpr const char* kSaid = "cullscope: The connection to the display broke.\n";
    static_cast<void>(write(STDERR_FILENO, kSaid, std::strlen(kSaid)) < 0);
    _exit(int(ErrorKind::OpenGl));
}

// ---- Messages

void onMessage(QtMsgType type, const QMessageLogContext& context, const QString& text) {
    endWhereQtCannotGoOn(text);
    if (s_previous != nullptr) s_previous(type, context, text);
}

}  // namespace

AbruptEnd::AbruptEnd() {
    static const int registered = std::atexit(onExit);
    static_cast<void>(registered);
    s_previous = qInstallMessageHandler(onMessage);
    findDisplay();
    lookAtCrashes(endWhereDisplayIsGone);
    s_watching = true;
}

AbruptEnd::~AbruptEnd() {
    s_watching = false;
    s_keep = {};
    lookAtCrashes(nullptr);
    qInstallMessageHandler(s_previous);
}

void endWhereQtCannotGoOn(const QString& warning) {
    if (!s_watching) return;
    // Qt exits behind these.
    if (warning.startsWith(QLatin1String("The X11 connection broke")) ||
        warning.startsWith(QLatin1String("The Wayland connection broke")))
        end(ErrorKind::OpenGl, kDisplayBroke, Keeping::Yes);
    // Qt's connections to other programs and its painting wait for threads of which they do not ask whether they run.
    if (warning.startsWith(QLatin1String("QThread::start: Thread creation error")))
        end(ErrorKind::Input,
            "The system gives no thread. Close other programs, or allow this one more memory and threads (ulimit).",
            Keeping::Yes);
}

void AbruptEnd::keepBy(std::function<bool()> keep) {
    s_keep = std::move(keep);
    s_keepingThread = std::this_thread::get_id();
}

}  // namespace cullscope::ui
