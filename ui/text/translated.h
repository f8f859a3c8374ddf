#pragma once

#include <QString>
#include <string_view>

#include "core/base/message.h"

namespace cullscope::ui {

/// The translation context of every sentence that core marks with CULLSCOPE_TR (see ui/translation/mark_core.cmake).
inline constexpr const char* kCoreContext = "core";

/// A sentence of core in the user's language, with its arguments inserted. Arguments that are marked texts of several words
/// themselves (systemReason) are translated too.
[[nodiscard]] QString translated(const Message& message);
/// A name or sentence of core without arguments, in the user's language.
[[nodiscard]] QString translated(std::string_view text);

}  // namespace cullscope::ui
