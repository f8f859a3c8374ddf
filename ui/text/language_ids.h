#pragma once

#include <array>
#include <string_view>

namespace cullscope::ui {

/// The languages of the program: names on the command line, in the settings and in lessons.
inline constexpr std::array<std::string_view, 3> kLanguageIds{"en", "ko", "zh_CN"};

}  // namespace cullscope::ui
