#include "ui/plots/map_painter.h"

#include <QLinearGradient>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "ui/look/verdict_swatch.h"
#include "ui/plots/map_overlay.h"
#include "ui/plots/map_words.h"
#include "ui/text/terms.h"
#include "ui/text/wording.h"

namespace cullscope::ui {

namespace {

constexpr double kMapMargin = 4.0;
constexpr double kScaleLeading = 2.0;
constexpr double kScaleWidth = 110.0;
constexpr double kScaleGap = 5.0;
constexpr double kBold = 1.2;        // how much wider bold letters are, at most
constexpr double kNarrowMap = 0.45;  // of the width: so narrow is a map that its place's height limits

double lineHeight(const QFontMetricsF& metrics) { return metrics.height() + kScaleLeading; }

std::vector<MapLegend::Entry> translatedEntries(const std::vector<MapLegendEntry>& entries) {
    std::vector<MapLegend::Entry> made;
    for (const MapLegendEntry& entry : entries) made.push_back({entry.symbol, translated(entry.words), {}});
    return made;
}

void append(std::vector<MapLegend::Entry>& entries, const std::vector<MapLegend::Entry>& more) {
    entries.insert(entries.end(), more.begin(), more.end());
}

std::vector<MapLegend::Entry> stateEntries(const std::vector<TriangleState>& states, bool truthKnown) {
    std::vector<MapLegend::Entry> entries;
    for (const TriangleState state : states) entries.push_back({MapSymbol::Cells, stateWords(state, truthKnown), {}});
    return entries;
}

QRectF inner(const QRectF& place) { return place.adjusted(kMapMargin, 0, -kMapMargin, 0); }

}  // namespace

double MapPainter::neededHeight(double width, const QFontMetricsF& metrics) const {
    const double across = width - 2 * kMapMargin;
    return std::ceil(captionHeight(across, metrics) + MapLayout::heightFor(across, metrics) + heightBelow(across, metrics) +
                     kMapMargin);
}

int MapPainter::captionLines(double width, const QFontMetricsF& metrics) const {
    if (!m_brief) return 2;
    if (contents().shown.empty()) return 1;
    return kBold * metrics.horizontalAdvance(translated(contents().shown.map->decisionWords)) > width ? 2 : 1;
}

double MapPainter::captionHeight(double width, const QFontMetricsF& metrics) const {
    double line = lineHeight(metrics);
    // Letters of another font than the metrics' may be higher.
    if (m_brief && !contents().shown.empty())
        line = std::max(
            line, metrics.size(Qt::TextSingleLine, translated(contents().shown.map->decisionWords)).height() + kScaleLeading);
    return captionLines(width, metrics) * line;
}

double MapPainter::heightBelow(double width, const QFontMetricsF& metrics) const {
    if (m_brief) return 0.0;
    const bool states = m_cells.byState();
    double most = 0.0;
    if (!contents().shown.empty())
        for (const MapLegendRoom& room : contents().shown.map->rooms) {
            std::vector<MapLegend::Entry> entries = stateEntries(states ? room.states : room.otherStates, states);
            append(entries, translatedEntries(room.entries));
            entries.push_back({MapSymbol::Picked, pickedWords(), {}});
            most = std::max(most, MapLegend(std::move(entries), metrics).heightFor(width));
        }
    return most + (states ? 0.0 : lineHeight(metrics)) + wordsHeight(metrics);
}

double MapPainter::wordsHeight(const QFontMetricsF& metrics) const {
    return m_brief || contents().shown.empty() ? 0.0 : contents().shown.map->lineRoom * lineHeight(metrics);
}

std::vector<MapLegend::Entry> MapPainter::statesShown(const QPalette& palette) const {
    std::vector<MapLegend::Entry> entries;
    const std::vector<uint8_t>& cells = m_cells.tones().tones;
    for (size_t number = 0; number < kTriangleStateCount; ++number) {
        const auto state = TriangleState(number);
        if (std::find(cells.begin(), cells.end(), CellTones::toneOf(state)) == cells.end()) continue;
        entries.push_back({MapSymbol::Cells, stateWords(state, contents().truth != nullptr), verdictColour(state, palette)});
    }
    return entries;
}

QColor MapPainter::veiledColour(const QPalette& palette) const {
    return MapColours(palette).veiled(QColor(toneColours(m_cells.byState(), palette)[CellTones::kTones / 2]));
}

MapLegend MapPainter::legend(const QFontMetricsF& metrics, const QPalette& palette) const {
    std::vector<MapLegend::Entry> entries;
    const CellMap& map = *contents().shown.map;
    if (m_cells.byState()) entries = statesShown(palette);
    if (m_cells.veiled()) entries.push_back({MapSymbol::Cells, stateWords(TriangleState::Hidden, false), veiledColour(palette)});
    append(entries, translatedEntries(map.legend));
    if (contents().part) entries.push_back({MapSymbol::Part, translated(map.source->partWords(*contents().part)), {}});
    if (contents().picked) entries.push_back({MapSymbol::Picked, pickedWords(), {}});
    return {std::move(entries), metrics};
}

bool MapPainter::captionBeside(const QRectF& place, const QFontMetricsF& metrics) const {
    const QRectF within = inner(place);
    const MapLayout above(within.adjusted(0, lineHeight(metrics), 0, -kMapMargin), metrics);
    return m_brief && above.area.width() < kNarrowMap * within.width();
}

MapLayout MapPainter::layout(const QRectF& place, const QFontMetricsF& metrics) const {
    const QRectF within = inner(place);
    const double caption = captionBeside(place, metrics) ? 0.0 : captionHeight(within.width(), metrics);
    return {within.adjusted(0, caption, 0, -heightBelow(within.width(), metrics) - kMapMargin), metrics};
}

void MapPainter::paint(QPainter& painter, const QRectF& place, const QPalette& palette,
                       const std::optional<SphericalGrid::Cell>& cursor) const {
    const MapColours colours(palette);
    const QFontMetricsF metrics(painter.font());
    const ShownMap& shown = contents().shown;
    const MapLayout layout = this->layout(place, metrics);
    painter.save();
    QRectF caption = inner(place);
    if (captionBeside(place, metrics)) caption.setLeft(layout.area.right() + metrics.horizontalAdvance(QStringLiteral("360°")));
    paintCaption(painter, caption, colours);
    m_cells.paint(painter, layout.area, palette, colours.veil);
    const MapOverlay overlay(painter, layout, colours);
    overlay.paint(*shown.map);
    if (contents().part) overlay.paintPart(*shown.map, *contents().part);
    if (contents().picked)
        overlay.paintPicked(shown.grid(), shown.source().cellsOf(*contents().picked), shown.source().ownerOf(*contents().picked));
    if (!contents().inHand.empty()) overlay.paintInHand(contents().inHand);
    if (cursor) overlay.paintCursor(shown.grid(), *cursor);
    paintAxes(painter, layout.area, colours);
    if (m_brief) return painter.restore();
    QRectF below = inner(place);
    below.setTop(layout.area.bottom() + metrics.height() + kMapMargin);
    if (!m_cells.byState()) {
        paintScale(painter, below, palette);
        below.setTop(below.top() + lineHeight(metrics));
    }
    paintWords(painter, below, colours);
    below.setTop(below.top() + wordsHeight(metrics));
    legend(metrics, palette).paint(painter, below, colours);
    painter.restore();
}

void MapPainter::paintCaption(QPainter& painter, const QRectF& place, const MapColours& colours) const {
    const QFontMetricsF metrics(painter.font());
    QRectF line(place.left(), place.top(), place.width(), metrics.height());
    // By its base line: glyphs of another font, as of Korean and Chinese, would move the line down in a rectangle, which cuts it.
    const auto write = [&](const QString& words) { painter.drawText(line.topLeft() + QPointF(0.0, metrics.ascent()), words); };
    painter.setPen(colours.text);
    if (!m_brief) {
        write(metrics.elidedText(translated(contents().shown.map->objectWords), Qt::ElideMiddle, line.width()));
        line.translate(0, lineHeight(metrics));
    }
    QFont bold = painter.font();
    const QFont plain = bold;
    bold.setBold(true);
    painter.setFont(bold);
    const QString words = translated(contents().shown.map->decisionWords);
    if (m_brief && captionLines(line.width(), metrics) > 1)
        painter.drawText(line, Qt::AlignLeft | Qt::AlignTop | Qt::TextWordWrap | Qt::TextDontClip, words);
    else
        write(QFontMetricsF(bold).elidedText(words, Qt::ElideRight, line.width()));
    painter.setFont(plain);
}

void MapPainter::paintWords(QPainter& painter, const QRectF& place, const MapColours& colours) const {
    const QFontMetricsF metrics(painter.font());
    QRectF line(place.left(), place.top(), place.width(), metrics.height());
    painter.setPen(colours.text);
    const QStringList words = translatedLines(contents().shown.map->lines);
    for (qsizetype i = 0; i < words.size(); ++i) {
        // The last line takes the remaining height.
        if (i + 1 == words.size()) line.setBottom(place.top() + wordsHeight(metrics));
        painter.drawText(line, Qt::AlignLeft | Qt::TextWordWrap, words[i]);
        line.translate(0, lineHeight(metrics));
    }
}

void MapPainter::paintAxes(QPainter& painter, const QRectF& area, const MapColours& colours) {
    const QFontMetricsF metrics(painter.font());
    painter.setRenderHint(QPainter::Antialiasing, false);
    painter.setPen(QPen(colours.faintText, 1.0));
    painter.setBrush(Qt::NoBrush);
    painter.drawRect(area);
    const auto degrees = [](int value) { return QStringLiteral("%1°").arg(value); };
    constexpr double kTick = 3.0, kGap = 5.0;
    // In a lecture the letters are large: a number needs its own width.
    const double wide = std::ceil(metrics.horizontalAdvance(degrees(360))) + 2.0;
    // In large letters beside a small map there is room for the ends alone.
    int across = 90, down = 90;
    while (across < 360 && area.width() * across / 360.0 < 1.2 * metrics.horizontalAdvance(degrees(360))) across *= 2;
    if (area.height() / 2 < 1.1 * metrics.height()) down = 180;
    for (int phi = 0; phi <= 360; phi += 45) {
        const double x = area.left() + phi / 360.0 * area.width();
        painter.setPen(colours.faintText);
        painter.drawLine(QPointF(x, area.bottom()), QPointF(x, area.bottom() + kTick));
        if (phi % across != 0) continue;
        painter.setPen(colours.text);
        painter.drawText(QRectF(x - wide / 2, area.bottom() + kTick, wide, metrics.height()), Qt::AlignHCenter | Qt::AlignTop,
                         degrees(phi));
    }
    for (int theta = 0; theta <= 180; theta += 45) {
        const double y = area.top() + theta / 180.0 * area.height();
        painter.setPen(colours.faintText);
        painter.drawLine(QPointF(area.left() - kTick, y), QPointF(area.left(), y));
        if (theta % down != 0) continue;
        painter.setPen(colours.text);
        painter.drawText(QRectF(area.left() - kGap - wide, y - metrics.height() / 2, wide, metrics.height()),
                         Qt::AlignRight | Qt::AlignVCenter, degrees(theta));
    }
    if (across > 90 || down > 90) return;
    const double step = area.width() / 8, quarter = area.height() / 4;
    painter.drawText(QRectF(area.left() + 5 * step - wide / 2, area.bottom() + kTick, wide, metrics.height()), Qt::AlignCenter,
                     QStringLiteral("φ"));
    painter.drawText(QRectF(area.left() - kGap - wide, area.top() + 3 * quarter - metrics.height() / 2, wide, metrics.height()),
                     Qt::AlignRight | Qt::AlignVCenter, QStringLiteral("θ"));
}

void MapPainter::paintScale(QPainter& painter, const QRectF& place, const QPalette& palette) const {
    const QFontMetricsF metrics(painter.font());
    const QList<QRgb> colours = toneColours(m_cells.byState(), palette);
    const QString least = translated(m_cells.tones().least), most = translated(m_cells.tones().most);
    QPointF at = place.topLeft();
    const auto say = [&](const QString& words) {
        painter.setPen(palette.color(QPalette::Text));
        painter.drawText(at + QPointF(0.0, metrics.ascent()), words);
        at.rx() += metrics.horizontalAdvance(words) + kScaleGap;
    };
    say(least);
    const QRectF bar(at, QSizeF(kScaleWidth, metrics.height() - 2.0));
    QLinearGradient gradient(bar.topLeft(), bar.topRight());
    constexpr int kStops = 16;
    for (int stop = 0; stop <= kStops; ++stop)
        gradient.setColorAt(double(stop) / kStops, QColor(colours[1 + stop * qsizetype(CellTones::kTones - 2) / kStops]));
    painter.fillRect(bar, gradient);
    at.rx() += kScaleWidth + kScaleGap;
    say(most);
    at.rx() += kScaleGap;
    if (m_cells.colouring()) say(translated(m_cells.colouring()->scale));
}

}  // namespace cullscope::ui
