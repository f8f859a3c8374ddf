#pragma once

#include <string>
#include <string_view>

namespace cullscope {

/// A text that a terminal shows and does not obey: control characters other than line ends and tabs, and bytes that are no UTF-8,
/// are question marks. Names of files and what stands in files may have them, and a terminal takes them as commands.
[[nodiscard]] std::string terminalText(std::string_view text);

}  // namespace cullscope
