#pragma once

#include <QString>
#include <QStringList>
#include <QWidget>
#include <vector>

namespace cullscope::ui {

/// A text that a window shows, or states in a tooltip or to a screen reader.
struct ShownText {
    QString text;  ///< without markup
    QFont font;
    QString where;  ///< location, for a test's report
    bool painted;   ///< false: a tooltip or an accessible name
};

/// The texts of all visible widgets of a window and of its menus.
[[nodiscard]] std::vector<ShownText> shownTexts(const QWidget& window);

/// The painted texts that do not fit, one sentence each.
[[nodiscard]] QStringList cutTexts(const QWidget& window);

/// The texts with a character that no font has.
[[nodiscard]] QStringList textsWithMissingLetters(const std::vector<ShownText>& texts);

/// The texts with three or more consecutive Latin words, after the given untranslated names are removed.
[[nodiscard]] QStringList englishSentences(const std::vector<ShownText>& texts, const QStringList& names);

}  // namespace cullscope::ui
