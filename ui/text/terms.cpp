#include "ui/text/terms.h"

#include <QLocale>
#include <cmath>
#include <numbers>

#include "core/base/message.h"
#include "ui/text/translated.h"
#include "ui/text/wording.h"

namespace cullscope::ui {

QString translated(const Term& term) {
    switch (term.form) {
        case Term::Form::Name:
            return QString::fromStdString(term.text);
        case Term::Form::Marked:
            return translated(std::string_view(term.text));
        case Term::Form::Count:
            return countText(uint64_t(term.number));
        case Term::Form::Length:
            return lengthText(term.number);
        case Term::Form::Angle:
            return degreesText(term.number);
        case Term::Form::Share:
            break;
    }
    return percentText(term.number) + QStringLiteral(" %");
}

QString translated(const Words& words) {
    std::vector<std::string> arguments;
    for (const Term& term : words.terms) arguments.push_back(translated(term).toStdString());
    return QString::fromStdString(fillIn(translated(std::string_view(words.text)).toStdString(), arguments));
}

QStringList translatedLines(const std::vector<Words>& lines) {
    QStringList made;
    for (const Words& words : lines) made << translated(words);
    return made;
}

QString lengthText(double length) { return QLocale().toString(length, 'g', 3); }

QString degreesText(double radians) {
    const double degrees = radians * 180.0 / std::numbers::pi;
    // Rounded to 0.01°, without trailing zeros.
    const double rounded = std::round(degrees * 100.0) / 100.0;
    return QLocale().toString(rounded, 'g', 5) + QStringLiteral("°");
}

QString ratioWithTwoDigits(double ratio) { return QLocale().toString(ratio, 'f', 2); }

}  // namespace cullscope::ui
