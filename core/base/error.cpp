#include "core/base/error.h"

#include <cerrno>
#include <new>
#include <system_error>

namespace cullscope {

Message sentenceOf(const std::exception& failure, const char* other, const char* noMemory) {
    if (const auto* error = dynamic_cast<const Error*>(&failure)) return error->message();
    if (noMemory != nullptr && dynamic_cast<const std::bad_alloc*>(&failure) != nullptr) return {noMemory, {}};
    return {other, {failure.what()}};
}

std::string systemReason(int errorNumber) {
    switch (errorNumber) {
        case ENOENT:
            return CULLSCOPE_TR("there is no such file or folder");
        case ENOTDIR:
            return CULLSCOPE_TR("a part of the path is no folder");
        case EACCES:
        case EPERM:
            return CULLSCOPE_TR("permission is denied");
        case EROFS:
            return CULLSCOPE_TR("the place is read-only");
        case ENOSPC:
        case EDQUOT:
            return CULLSCOPE_TR("no space is left");
        case EISDIR:
            return CULLSCOPE_TR("it is a folder");
        case ENAMETOOLONG:
            return CULLSCOPE_TR("the name is too long");
        case EPIPE:
            return CULLSCOPE_TR("the program that reads it has ended");
        case EIO:
            return CULLSCOPE_TR("the device reports an error");
        default:
            return std::error_code(errorNumber, std::generic_category()).message();
    }
}

void throwUsage(std::string_view text, std::vector<std::string> arguments) {
    throw Error(ErrorKind::Usage, {std::string(text), std::move(arguments)});
}

void throwInput(std::string_view text, std::vector<std::string> arguments) {
    throw Error(ErrorKind::Input, {std::string(text), std::move(arguments)});
}

void throwOpenGl(std::string_view text, std::vector<std::string> arguments) {
    throw Error(ErrorKind::OpenGl, {std::string(text), std::move(arguments)});
}

void throwInterrupted() { throw Error(ErrorKind::Interrupted, {CULLSCOPE_TR("Stopped."), {}}); }

}  // namespace cullscope
