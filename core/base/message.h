#pragma once

#include <string>
#include <string_view>
#include <vector>

/// Marks an English sentence of the library for translation. `lupdate` is told of this macro
/// (see ui/CMakeLists.txt); the library itself never translates, the desktop does when it shows the sentence.
#define CULLSCOPE_TR(text) text

namespace cullscope {

/// An English sentence with numbered places `%1`, `%2`, … and the values that go there.
/// Kept apart so that a user interface can translate the sentence and then fill in the values.
struct Message {
    std::string text;
    std::vector<std::string> arguments;

    /// The English sentence with its arguments filled in.
    [[nodiscard]] std::string english() const;
    [[nodiscard]] bool empty() const { return text.empty(); }
};

/// Replaces `%1` … `%9` of `text` by the arguments; a place without an argument stays as it is.
[[nodiscard]] std::string fillIn(std::string_view text, const std::vector<std::string>& arguments);

}  // namespace cullscope
