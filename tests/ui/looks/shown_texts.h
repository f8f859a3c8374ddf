#pragma once

#include <QString>
#include <QStringList>
#include <QWidget>
#include <vector>

namespace cullscope::ui {

/// A text that a window shows, or says when the pointer rests or a screen reader asks.
struct ShownText {
    QString text;  ///< plain
    QFont font;
    QString where;  ///< for a test's report
    bool painted;   ///< false: a tip or an accessible name
};

/// All of a window's visible widgets, its menus included.
[[nodiscard]] std::vector<ShownText> shownTexts(const QWidget& window);

/// What of the texts that are painted does not fit its place, a sentence each.
[[nodiscard]] QStringList cutTexts(const QWidget& window);

/// The texts with a letter that no font has.
[[nodiscard]] QStringList textsWithMissingLetters(const std::vector<ShownText>& texts);

/// The texts in which three or more Latin words follow each other, less the given words that are names in any language.
[[nodiscard]] QStringList englishSentences(const std::vector<ShownText>& texts, const QStringList& names);

}  // namespace cullscope::ui
