#pragma once

#include <string_view>
#include <utility>

#include "core/mesh/byte_source.h"

namespace cullscope {

/// Reads the numbers of a text file row by row; a row begins on a new line and may continue on the next ones.
class TextRows {
public:
    /// `comment`: the character that begins a comment; '\0' where the format has no comments.
    TextRows(ByteSource& source, char comment) : m_source(source), m_comment(comment) {}

    /// Advances to the next line that is not empty; false at the end of the file.
    [[nodiscard]] bool nextRow();
    /// The next word of the row, taken from the following line where this one has none left. Throws Error(Input) at the end of
    /// the file.
    [[nodiscard]] std::string_view word();
    [[nodiscard]] double real();
    [[nodiscard]] int64_t integer();
    /// Whether the line has another word.
    [[nodiscard]] bool hasMore() const { return m_rest.find_first_not_of(" \t\r\v\f") != std::string_view::npos; }
    [[nodiscard]] std::string_view rest() const { return m_rest; }
    /// Returns and consumes the rest of the line.
    std::string_view restOfRow() { return std::exchange(m_rest, {}); }

    [[noreturn]] void refuseEnd() const;
    [[noreturn]] void refuseNumber(std::string_view word) const;

private:
    ByteSource& m_source;
    char m_comment;
    std::string_view m_rest;
};

}  // namespace cullscope
