#include "ui/text/wording.h"

#include <QCoreApplication>
#include <QLocale>
#include <cmath>

#include "ui/text/translated.h"

namespace cullscope::ui {

QString promiseWord(Promise promise) {
    switch (promise) {
        case Promise::Exact:
            return QCoreApplication::translate("Wording", "exact set");
        case Promise::Conservative:
            return QCoreApplication::translate("Wording", "lossless");
        case Promise::Approximate:
            return QCoreApplication::translate("Wording", "lossy");
    }
    return {};
}

QString promiseSentence(Promise promise) {
    switch (promise) {
        case Promise::Exact:
            return QCoreApplication::translate("Wording", "draws what is visible and nothing in vain");
        case Promise::Conservative:
            return QCoreApplication::translate("Wording", "loses no visible pixel, may draw in vain");
        case Promise::Approximate:
            return QCoreApplication::translate("Wording", "may lose pixels: how many is measured");
    }
    return {};
}

QString facingWord(Facing facing) {
    switch (facing) {
        case Facing::TwoSided:
            return QCoreApplication::translate("Wording", "both sides");
        case Facing::Front:
            return QCoreApplication::translate("Wording", "front faces only");
        case Facing::ByObject:
            return QCoreApplication::translate("Wording", "front faces only of closed objects, both sides of the others");
    }
    return {};
}

QString strategyWords(const StrategyRequest& strategy) {
    QString words = translated(findStrategy(strategy.id).info.name);
    for (const std::string& parameter : changedParameters(strategy.parameters)) words += QString::fromStdString(" " + parameter);
    return words;
}

QString baselineWord(BaselineRole role) { return QString::fromStdString(baselineOf(role).id); }

QString viewLetter(int view) { return QString(QChar(u'A' + view)); }

QString ratioText(double ratio) {
    const int digits = ratio < 0.995 ? 2 : ratio < 9.95 ? 1 : 0;
    return QLocale().toString(ratio, 'f', digits);
}

QString speedText(const RatioEstimate& speed) { return QStringLiteral("×") + ratioText(speed.ratio); }

QString intervalText(const RatioEstimate& speed) {
    // Finer than the ratio: an interval whose ends read alike says nothing of the scatter.
    const auto finer = [](double ratio) { return QLocale().toString(ratio, 'f', 2); };
    return QStringLiteral("%1 – %2").arg(finer(speed.ci95[0]), finer(speed.ci95[1]));
}

QString speedWithInterval(const RatioEstimate& speed) {
    return QStringLiteral("%1 (%2)").arg(speedText(speed), intervalText(speed));
}

QString percentText(double share) {
    const double percent = 100.0 * share;
    if (percent <= 0.0 || percent >= 100.0) return QLocale().toString(percent, 'f', 0);
    if (percent < 0.1) return QStringLiteral("<") + QLocale().toString(0.1, 'f', 1);
    if (percent < 9.95) return QLocale().toString(percent, 'f', 1);
    return QLocale().toString(std::min(percent, 99.0), 'f', 0);
}

QString headroomText(const RatioEstimate& share) {
    // What rounds to 0 from below has no sign.
    const auto whole = [](double value) { return QLocale().toString(std::round(100.0 * value) + 0.0, 'f', 0); };
    if (!share.hasInterval) return QStringLiteral("%1 %").arg(whole(share.ratio));
    return QStringLiteral("%1 % [%2, %3]").arg(whole(share.ratio), whole(share.ci95[0]), whole(share.ci95[1]));
}

QString countText(uint64_t count) { return QLocale().toString(qulonglong(count)); }

QString millisecondsText(double milliseconds) {
    const int digits = milliseconds < 1.0 ? 3 : milliseconds < 10.0 ? 2 : milliseconds < 100.0 ? 1 : 0;
    const QString below = milliseconds > 0.0 && milliseconds < 0.0005 ? QStringLiteral("<") : QString();
    milliseconds = below.isEmpty() ? milliseconds : 0.001;
    return QCoreApplication::translate("Wording", "%1 ms").arg(below + QLocale().toString(milliseconds, 'f', digits));
}

QString pixelText(const Viewport& size) { return QStringLiteral("%1 × %2").arg(size.width).arg(size.height); }

QString bytesText(uint64_t bytes) { return QLocale().formattedDataSize(qint64(bytes), 1, QLocale::DataSizeSIFormat); }

int lineHeight(const QFontMetrics& metrics) { return metrics.size(Qt::TextSingleLine, QStringLiteral("한中Åg")).height(); }

}  // namespace cullscope::ui
