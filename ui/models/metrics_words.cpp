#include "ui/models/metrics_words.h"

#include <QCoreApplication>
#include <QLocale>
#include <QStringList>
#include <algorithm>

#include "ui/text/translated.h"
#include "ui/text/wording.h"

namespace cullscope::ui {

QString heldWords(const FrameLog& log) {
    QStringList words;
    for (const HeldParameter& held : log.counters.held)
        words << QStringLiteral("%1 %2%3").arg(
            QString::fromStdString(held.key), QLocale().toString(held.value, 'g', 3),
            held.unit.empty() ? QString() : QStringLiteral(" ") + QString::fromStdString(held.unit));
    return words.join(QStringLiteral(" · "));
}

QString metricsLine(const ViewMetrics& figures) {
    switch (figures.state) {
        case ViewMetrics::State::Nothing:
            return {};
        case ViewMetrics::State::Stale:
            return QStringLiteral("…");
        case ViewMetrics::State::OnRequest:
            return QCoreApplication::translate("Wording", "large scene: figures on request");
        case ViewMetrics::State::Failed:
            return QCoreApplication::translate("Wording", "no figures");
        case ViewMetrics::State::Ready:
            break;
    }
    const QString speed = figures.speedup ? speedText(*figures.speedup) : QStringLiteral("×…");
    //: Line 2 of a view's header: speed against the baseline, share of the triangles submitted, missed pixels.
    const QString line = QCoreApplication::translate("Wording", "%1 · %2 % · %3 missed")
                             .arg(speed, percentText(figures.submittedShare()), countText(figures.lostPixels()));
    const QString held = figures.frame ? heldWords(figures.frame->log) : QString();
    return held.isEmpty() ? line : line + QStringLiteral(" · ") + held;
}

QString speedSentence(const ViewFigures& figures) {
    QStringList lines;
    const auto add = [&](const std::optional<RatioEstimate>& speed, const QString& against) {
        if (speed) lines << against.arg(speedWithInterval(*speed));
    };
    //: Speed against a baseline, %2, and its 95 % interval: "×3.1 (2.93 – 3.31)".
    add(figures.speedup,
        QCoreApplication::translate("Wording", "%1 against %2, which draws the same sides, with its 95 % interval")
            .arg(QStringLiteral("%1"), QString::fromStdString(figures.baseline)));
    //: The same against a baseline that draws front faces alone.
    add(figures.speedupOverFrontFaces, QCoreApplication::translate("Wording", "%1 against %2, which draws front faces only")
                                           .arg(QStringLiteral("%1"), baselineWord(BaselineRole::FrontFaces)));
    return lines.join(QLatin1Char('\n'));
}

QString headroomSentence(const ViewHeadroom& headroom) {
    if (headroom.most.ratio < 1.0)
        //: The speed of drawing exactly the visible triangles over a baseline, %2, and its 95 % interval: "×0.92 (0.81 – 1.02)".
        return QCoreApplication::translate("Wording",
                                           "Nothing could be gained here: drawing the visible triangles alone is %1 against %2")
            .arg(speedWithInterval(headroom.most), QString::fromStdString(headroom.baseline));
    //: What drawing exactly the visible triangles gains over a baseline, %2, and its 95 % interval: "×3.1 (2.93 – 3.31)".
    const QString most =
        QCoreApplication::translate("Wording", "Any culling could gain at most %1 against %2: the visible triangles alone")
            .arg(speedWithInterval(headroom.most), QString::fromStdString(headroom.baseline));
    if (!headroom.share) return most;
    //: The share of what any culling could gain that this strategy gains.
    return most + QLatin1Char('\n') +
           QCoreApplication::translate("Wording", "Of this headroom: %1").arg(headroomText(*headroom.share));
}

namespace {

/// Whether the times of both were taken in the same turns, of different strategies at the same view.
bool comparable(const ViewMetrics& one, const ViewMetrics& other) {
    const MetricsSubject &a = one.subject, &b = other.subject;
    return one.timing == other.timing && a.buffers == b.buffers && a.culling == b.culling && a.size == b.size &&
           (a.strategy->id() != b.strategy->id() || a.strategy->parameters() != b.strategy->parameters());
}

}  // namespace

QString fastestSentence(const std::vector<NamedMetrics>& views) {
    std::vector<NamedMetrics> timed;
    for (const NamedMetrics& view : views)
        if (view.figures->state == ViewMetrics::State::Ready && view.figures->timed && view.figures->subject.strategy)
            timed.push_back(view);
    std::ranges::stable_sort(timed, {}, [](const NamedMetrics& view) { return view.figures->frameMilliseconds; });
    if (timed.empty()) return {};
    const NamedMetrics& fastest = timed.front();
    // Beside views of other cameras, or timed at another moment, it is no more than a number.
    const auto next = std::find_if(timed.begin() + 1, timed.end(),
                                   [&](const NamedMetrics& other) { return comparable(*fastest.figures, *other.figures); });
    if (next == timed.end()) return {};
    const ViewTimes times{next->figures->frameTimes, fastest.figures->frameTimes};
    const RatioEstimate ratio = ratioOfTotals({&times, 1});
    const auto words = [&](const QString& sentence) {
        return sentence.arg(fastest.name, QLocale().toString(ratio.ratio, 'f', 2), next->name);
    };
    //: A view's letter, how many times as fast, another view's letter.
    if (!ratio.hasInterval) return words(QCoreApplication::translate("Wording", "%1 is %2 times as fast as %3."));
    //: The same with the 95 % interval.
    const QString sentence =
        words(QCoreApplication::translate("Wording", "%1 is %2 times as fast as %3 (%4).")).arg(intervalText(ratio));
    if (ratio.ci95[0] > 1.0) return sentence;
    return sentence + QLatin1Char(' ') + QCoreApplication::translate("Wording", "Which one is faster is not decided.");
}

QString missedSentence(const ViewMetrics& figures) {
    const uint64_t lost = figures.lostPixels();
    const QString missed =
        QCoreApplication::translate("Wording", "Missed: %1 of %2 covered pixels, largest hole %3")
            .arg(countText(lost), countText(figures.accuracy.coveredPixels), countText(figures.accuracy.largestHolePixels));
    const QString explained = snappedSentence(figures);
    return explained.isEmpty() ? missed : missed + QLatin1Char('\n') + explained;
}

QString snappedSentence(const ViewFigures& figures) {
    const uint64_t explained = figures.accuracy.missedPixels - figures.lostPixels();
    if (explained == 0) return {};
    //: Pixels that differ from the truth's only because OpenGL rounds corners to 1/256 pixel.
    return QCoreApplication::translate("Wording", "Within the raster's snapping, and not lost: %1").arg(countText(explained));
}

QString fragmentsSentence(const Submitted& submitted) {
    return QCoreApplication::translate("Wording", "Submitted in %1 fragments that the strategy made of them")
        .arg(countText(submitted.fragments));
}

QString metricsDetails(const ViewMetrics& figures, const GlInfo& gl) {
    if (figures.state == ViewMetrics::State::Failed) return translated(figures.failure);
    QStringList lines;
    if (figures.state == ViewMetrics::State::Ready) {
        const double fps = figures.frameMilliseconds > 0.0 ? 1000.0 / figures.frameMilliseconds : 0.0;
        if (figures.speedup) lines << speedSentence(figures);
        if (figures.headroom) lines << headroomSentence(*figures.headroom);
        if (figures.timed)
            lines << QCoreApplication::translate("Wording", "Speed: %1 fps = 1 / (cull + draw), %2 a frame, of which %3 culling")
                         .arg(ratioText(fps), millisecondsText(figures.frameMilliseconds),
                              millisecondsText(figures.cullMilliseconds));
        lines << QCoreApplication::translate("Wording", "Submitted: %1 of %2 triangles. Visible, drawn or not: %3")
                     .arg(countText(figures.submitted.triangles), countText(figures.sceneTriangles),
                          countText(figures.accuracy.visibleTriangles))
              << missedSentence(figures);
        if (figures.frame && !figures.frame->log.counters.held.empty())
            lines << QCoreApplication::translate("Wording", "In force, to hold the frame time: %1")
                         .arg(heldWords(figures.frame->log));
        if (figures.submitted.fragments > 0) lines << fragmentsSentence(figures.submitted);
        lines << QCoreApplication::translate("Wording", "Truth: item buffer of %1 × %2 pixels, %3")
                     .arg(figures.size.width)
                     .arg(figures.size.height)
                     .arg(facingWord(figures.truthFacing));
    }
    if (!gl.renderer.empty()) {
        const QString renderer = QString::fromStdString(gl.renderer);
        lines << (gl.software ? QCoreApplication::translate("Wording", "Software OpenGL: %1").arg(renderer)
                              : QCoreApplication::translate("Wording", "OpenGL: %1").arg(renderer));
    }
    return lines.join(QLatin1Char('\n'));
}

}  // namespace cullscope::ui
