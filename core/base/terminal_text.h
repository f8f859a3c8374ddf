#pragma once

#include <string>
#include <string_view>

namespace cullscope {

/// A text that a terminal shows and does not obey: control characters other than line ends and tabs, and bytes that are no UTF-8,
/// are question marks. Names of files and what stands in files may have them, and a terminal takes them as commands.
[[nodiscard]] std::string terminalText(std::string_view text);

/// The same on one line: line ends and tabs are question marks as well. For names within a sentence.
[[nodiscard]] std::string terminalLine(std::string_view text);

/// A name for a text file of one name a line: what a terminal could obey, line ends and tabs included, is an underscore. Names in
/// other encodings than UTF-8 keep their letters.
[[nodiscard]] std::string plainName(std::string_view name);

/// A JSON text with the control characters from U+007F to U+009F escaped, which JSON allows to stand in strings as they are.
/// Those below U+0020 it does not allow.
[[nodiscard]] std::string plainJson(std::string_view json);

}  // namespace cullscope
