#include "ui/text/letters.h"

#include <QFontInfo>
#include <QStringList>

namespace cullscope::ui {

namespace {

/// Families with the characters of mainland China, best first; one that is not installed is passed over.
QStringList simplifiedChinese(bool fixedPitch) {
    QStringList families{QStringLiteral("Noto Sans CJK SC"), QStringLiteral("Noto Sans SC"), QStringLiteral("Source Han Sans SC"),
                         QStringLiteral("WenQuanYi Micro Hei"), QStringLiteral("WenQuanYi Zen Hei")};
    if (fixedPitch) families.prepend(QStringLiteral("Noto Sans Mono CJK SC"));
    return families;
}

}  // namespace

QFont lettersOf(const QLocale& language, QFont font) {
    if (language.language() != QLocale::Chinese) return font;
    // The real family: a list that begins with a generic name, as "Sans Serif", would give Latin letters to the next one, too.
    const QFontInfo real(font);
    font.setFamilies(QStringList{real.family()} + simplifiedChinese(real.fixedPitch()));
    return font;
}

}  // namespace cullscope::ui
