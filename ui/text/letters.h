#pragma once

#include <QFont>
#include <QLocale>

namespace cullscope::ui {

/// The font with the forms of characters that a language uses. Chinese characters look different in China, Taiwan, Japan and
/// Korea, and without a family that is made for the language the system takes any that has them, on most systems the Japanese
/// one. Latin letters stay those of the font.
[[nodiscard]] QFont lettersOf(const QLocale& language, QFont font);

}  // namespace cullscope::ui
