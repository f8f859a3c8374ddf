#pragma once

#include <string>
#include <string_view>
#include <vector>

/// Marks an English sentence of the library for translation. `lupdate` looks for this macro (see ui/CMakeLists.txt). The library
/// itself does not translate; the desktop does when it shows the sentence.
#define CULLSCOPE_TR(text) text

namespace cullscope {

/// An English sentence with the placeholders `%1`, `%2`, … and the values for them. Both are kept apart so that a user interface
/// can translate the sentence and then fill in the values.
struct Message {
    std::string text;
    std::vector<std::string> arguments;

    /// The English sentence with its arguments filled in.
    [[nodiscard]] std::string english() const;
    [[nodiscard]] bool empty() const { return text.empty(); }
};

/// Replaces `%1` … `%9` of `text` by the arguments; a `%n` without an argument stays as it is.
[[nodiscard]] std::string fillIn(std::string_view text, const std::vector<std::string>& arguments);

}  // namespace cullscope
