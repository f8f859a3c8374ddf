#include "ui/text/wording.h"

#include <QCoreApplication>
#include <QLocale>
#include <QStringList>
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
    return facing == Facing::Front ? QCoreApplication::translate("Wording", "front faces only")
                                   : QCoreApplication::translate("Wording", "both sides");
}

QString viewLetter(int view) { return QString(QChar(u'A' + view)); }

QString ratioText(double ratio) {
    const int digits = ratio < 0.995 ? 2 : ratio < 9.95 ? 1 : 0;
    return QLocale().toString(ratio, 'f', digits);
}

QString percentText(double share) {
    const double percent = 100.0 * share;
    if (percent <= 0.0 || percent >= 100.0) return QLocale().toString(percent, 'f', 0);
    if (percent < 0.1) return QStringLiteral("<") + QLocale().toString(0.1, 'f', 1);
    if (percent < 9.95) return QLocale().toString(percent, 'f', 1);
    return QLocale().toString(std::min(percent, 99.0), 'f', 0);
}

QString countText(uint64_t count) { return QLocale().toString(qulonglong(count)); }

QString millisecondsText(double milliseconds) {
    const int digits = milliseconds < 1.0 ? 3 : milliseconds < 10.0 ? 2 : milliseconds < 100.0 ? 1 : 0;
    const QString below = milliseconds > 0.0 && milliseconds < 0.0005 ? QStringLiteral("<") : QString();
    milliseconds = below.isEmpty() ? milliseconds : 0.001;
    return QCoreApplication::translate("Wording", "%1 ms").arg(below + QLocale().toString(milliseconds, 'f', digits));
}

QString bytesText(uint64_t bytes) { return QLocale().formattedDataSize(qint64(bytes), 1, QLocale::DataSizeSIFormat); }

QString figureLine(const Figures& figures) {
    switch (figures.state) {
        case Figures::State::Nothing:
            return {};
        case Figures::State::Stale:
            return QStringLiteral("…");
        case Figures::State::OnRequest:
            return QCoreApplication::translate("Wording", "large scene: figures on request");
        case Figures::State::Failed:
            return QCoreApplication::translate("Wording", "no figures");
        case Figures::State::Ready:
            break;
    }
    const QString speed = figures.speedup ? QStringLiteral("×") + ratioText(*figures.speedup) : QStringLiteral("×…");
    //: Line 2 of a view's header: speed against `backface`, share of the triangles submitted, missed pixels.
    return QCoreApplication::translate("Wording", "%1 · %2 % · %3 missed")
        .arg(speed, percentText(figures.submittedShare()), countText(figures.accuracy.missedPixels));
}

QString figureDetails(const Figures& figures, const GlInfo& gl) {
    if (figures.state == Figures::State::Failed) return translated(figures.failure);
    QStringList lines;
    if (figures.state == Figures::State::Ready) {
        const double fps = figures.frameMilliseconds > 0.0 ? 1000.0 / figures.frameMilliseconds : 0.0;
        lines << QCoreApplication::translate("Wording", "Speed: %1 fps = 1 / (cull + draw), %2 a frame, of which %3 culling")
                     .arg(ratioText(fps), millisecondsText(figures.frameMilliseconds), millisecondsText(figures.cullMilliseconds))
              << QCoreApplication::translate("Wording", "Submitted: %1 of %2 triangles, %3 of them visible")
                     .arg(countText(figures.consideredTriangles), countText(figures.sceneTriangles),
                          countText(figures.accuracy.visibleTriangles))
              << QCoreApplication::translate("Wording", "Missed: %1 of %2 covered pixels, largest hole %3")
                     .arg(countText(figures.accuracy.missedPixels), countText(figures.accuracy.coveredPixels),
                          countText(figures.accuracy.largestHolePixels));
        if (figures.missedBeyondSnapping)
            lines << QCoreApplication::translate("Wording", "Of the missed, beyond the raster's snapping to 1/256 pixel: %1")
                         .arg(countText(*figures.missedBeyondSnapping));
        lines << QCoreApplication::translate("Wording", "Truth: item buffer of %1 × %2 pixels, %3")
                     .arg(figures.size.width)
                     .arg(figures.size.height)
                     .arg(facingWord(figures.facing));
    }
    if (!gl.renderer.empty()) {
        const QString renderer = QString::fromStdString(gl.renderer);
        lines << (gl.software ? QCoreApplication::translate("Wording", "Software OpenGL: %1").arg(renderer)
                              : QCoreApplication::translate("Wording", "OpenGL: %1").arg(renderer));
    }
    return lines.join(QLatin1Char('\n'));
}

}  // namespace cullscope::ui
