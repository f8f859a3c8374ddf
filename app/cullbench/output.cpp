#include "app/cullbench/output.h"

#include <cerrno>

#include "core/base/error.h"
#include "core/base/terminal_text.h"

namespace cullscope::cullbench {
namespace {

[[noreturn]] void refuseOutput(int errorNumber) {
    if (errorNumber == EPIPE) throw ReaderGone{};
    throwUsage(CULLSCOPE_TR("Standard output cannot be written: %1. Send it somewhere else."),
               {systemReason(errorNumber != 0 ? errorNumber : EIO)});
}

}  // namespace

void printText(std::FILE* out, std::string_view text) {
    const std::string shown = terminalText(text);
    errno = 0;
    const bool written = std::fwrite(shown.data(), 1, shown.size(), out) == shown.size();
    if (!written && out == stdout) refuseOutput(errno);
}

void flushOutput() {
    errno = 0;
    if (std::fflush(stdout) != 0) refuseOutput(errno);
}

}  // namespace cullscope::cullbench
