#pragma once

#include <stdexcept>

#include "core/base/message.h"

namespace cullscope {

/// The kind of an error that a user can cause; its value is the exit status of both programs.
enum class ErrorKind {
    Usage = 2,         ///< wrong command line, parameter or combination
    Input = 3,         ///< a file that cannot be read or is refused
    OpenGl = 4,        ///< no OpenGL, or its version is too old
    Interrupted = 130  ///< stopped by the user
};

/// An error that a user can cause, as one sentence that says where, what, and what to do.
class Error : public std::runtime_error {
public:
    Error(ErrorKind kind, Message message) : std::runtime_error(message.english()), m_kind(kind), m_message(std::move(message)) {}

    [[nodiscard]] ErrorKind kind() const { return m_kind; }
    [[nodiscard]] const Message& message() const { return m_message; }

private:
    ErrorKind m_kind;
    Message m_message;
};

/// The system's text for an `errno`: a text marked for translation for the errors that users meet, else the system's English.
/// Meant as an argument of a Message; a user interface translates arguments that are marked texts.
[[nodiscard]] std::string systemReason(int errorNumber);

/// What the user is told of a failure: an Error's own message, else `other` with the exception's words in its place %1; where
/// memory is wanting `noMemory`, if there is one. Both are marked for translation.
[[nodiscard]] Message sentenceOf(const std::exception& failure, const char* other, const char* noMemory = nullptr);

[[noreturn]] void throwUsage(std::string_view text, std::vector<std::string> arguments = {});
[[noreturn]] void throwInput(std::string_view text, std::vector<std::string> arguments = {});
[[noreturn]] void throwOpenGl(std::string_view text, std::vector<std::string> arguments = {});
[[noreturn]] void throwInterrupted();

}  // namespace cullscope
