#include "core/base/error.h"

namespace cullscope {

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
