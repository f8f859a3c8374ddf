#pragma once

#include <QString>
#include <string_view>

#include "core/base/message.h"

namespace cullscope::ui {

/// The translation context of every sentence that core marks with CULLSCOPE_TR (see translation/update_translations.cmake).
inline constexpr const char* kCoreContext = "core";

/// A sentence of core in the user's language, its arguments filled in; arguments that are themselves marked texts of several
/// words (systemReason) are translated too.
[[nodiscard]] QString translated(const Message& message);
/// A name or sentence of core without arguments.
[[nodiscard]] QString translated(std::string_view text);

}  // namespace cullscope::ui
