#include "core/base/last_words.h"

#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <exception>

#include "core/base/error.h"

namespace cullscope {
namespace {

/// Allocates nothing: there may be no memory.
void writeError(const char* text) { [[maybe_unused]] const ssize_t written = write(STDERR_FILENO, text, std::strlen(text)); }

[[noreturn]] void endWithSentence() {
    writeError(program_invocation_short_name);
    writeError(
        ": It cannot go on, most likely for want of memory or threads. Use a smaller scene, close other programs, or allow this "
        "one more (ulimit).\n");
    _exit(static_cast<int>(ErrorKind::Input));
}

}  // namespace

void endWithSentenceOnTerminate() { std::set_terminate(endWithSentence); }

}  // namespace cullscope
