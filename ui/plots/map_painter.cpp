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
constexpr double kBold = 1.2;              // how much wider bold letters are, at most
constexpr QChar kFirstWideLetter(0x1100);  // of Korean; Chinese letters come later
constexpr double kEndless = 1e4;           // pixels
constexpr double kNarrowMap = 0.45;        // of the width: so narrow is a map that its place's height limits

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

/// The part of a place to the right of the map in it.
QRectF besideMap(QRectF place, const MapLayout& layout, const QFontMetricsF& metrics) {
    place.setLeft(layout.area.right() + metrics.horizontalAdvance(QStringLiteral("360°")));
    return place;
}

QRectF inner(const QRectF& place) { return place.adjusted(kMapMargin, 0, -kMapMargin, 0); }

/// The width of words in bold letters, by the metrics of plain ones. Korean and Chinese letters are as wide in both.
double boldAdvance(const QString& words, const QFontMetricsF& metrics) {
    QString narrow, wide;
    for (const QChar letter : words) (letter >= kFirstWideLetter ? wide : narrow) += letter;
    return kBold * metrics.horizontalAdvance(narrow) + metrics.horizontalAdvance(wide);
}

}  // namespace

double MapPainter::neededHeight(double width, const QFontMetricsF& metrics) const {
    const double across = width - 2 * kMapMargin;
    return std::ceil(captionHeight(across, metrics) + MapLayout::heightFor(across, metrics) + heightBelow(across, metrics) +
                     kMapMargin);
}

int MapPainter::captionLines(double width, const QFontMetricsF& metrics) const {
    if (!m_brief) return 2;
    if (contents().shown.empty()) return 1;
    return boldAdvance(translated(contents().shown.map->decisionWords), metrics) > width ? 2 : 1;
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

std::vector<TriangleState> MapPainter::states() const {
    std::vector<TriangleState> states;
    const std::vector<uint8_t>& cells = m_cells.tones().tones;
    for (size_t number = 0; m_cells.byState() && number < kTriangleStateCount; ++number)
        if (std::find(cells.begin(), cells.end(), CellTones::toneOf(TriangleState(number))) != cells.end())
            states.push_back(TriangleState(number));
    if (m_cells.veiled()) states.push_back(TriangleState::Hidden);
    return states;
}

std::vector<MapLegend::Entry> MapPainter::lines() const {
    const CellMap& map = *contents().shown.map;
    std::vector<MapLegend::Entry> entries;
    for (const MapLegendEntry& entry : map.legend)
        if (hasSymbol(map, entry.symbol)) entries.push_back({entry.symbol, translated(entry.words), {}});
    if (contents().part) entries.push_back({MapSymbol::Part, translated(map.source->partWords(*contents().part)), {}});
    return entries;
}

std::vector<MapLegend::Entry> MapPainter::statesShown(const QPalette& palette) const {
    std::vector<MapLegend::Entry> entries;
    if (!m_cells.byState()) return entries;
    for (const TriangleState state : states())
        entries.push_back({MapSymbol::Cells, stateWords(state, contents().truth != nullptr), verdictColour(state, palette)});
    return entries;
}

QColor MapPainter::veiledColour(const QPalette& palette) const {
    return MapColours(palette).veiled(QColor(toneColours(m_cells.byState(), palette)[CellTones::kTones / 2]));
}

MapLegend MapPainter::legend(const QFontMetricsF& metrics, const QPalette& palette) const {
    std::vector<MapLegend::Entry> entries;
    const CellMap& map = *contents().shown.map;
    entries = statesShown(palette);
    if (m_cells.veiled()) entries.push_back({MapSymbol::Cells, stateWords(TriangleState::Hidden, false), veiledColour(palette)});
    append(entries, translatedEntries(map.legend));
    if (contents().part) entries.push_back({MapSymbol::Part, translated(map.source->partWords(*contents().part)), {}});
    if (contents().picked) entries.push_back({MapSymbol::Picked, pickedWords(), {}});
    return {std::move(entries), metrics};
}

std::optional<MapLayout> MapPainter::layoutBesideCaption(const QRectF& place, const QFontMetricsF& metrics) const {
    const QRectF within = inner(place);
    const MapLayout above(within.adjusted(0, lineHeight(metrics), 0, -kMapMargin), metrics);
    if (!m_brief || contents().shown.empty() || above.area.width() >= kNarrowMap * within.width()) return std::nullopt;
    const QString words = translated(contents().shown.map->decisionWords);
    // A smaller map leaves more room for the caption.
    constexpr double kStep = 8.0;
    for (QRectF rest = within.adjusted(0, 0, 0, -kMapMargin); rest.width() > kStep; rest.setWidth(rest.width() - kStep)) {
        const MapLayout map(rest, metrics);
        const QRectF room = besideMap(within, map, metrics);
        const QRectF needed =
            metrics.boundingRect(QRectF(0.0, 0.0, room.width() / kBold, kEndless), Qt::AlignLeft | Qt::TextWordWrap, words);
        if (kBold * needed.width() <= room.width() && needed.height() <= room.height()) return map;
        if (map.area.width() <= above.area.width()) break;
    }
    return std::nullopt;
}

MapLayout MapPainter::layout(const QRectF& place, const QFontMetricsF& metrics) const {
    if (const std::optional<MapLayout> beside = layoutBesideCaption(place, metrics)) return *beside;
    const QRectF within = inner(place);
    return {within.adjusted(0, captionHeight(within.width(), metrics), 0, -heightBelow(within.width(), metrics) - kMapMargin),
            metrics};
}

void MapPainter::paint(QPainter& painter, const QRectF& place, const QPalette& palette,
                       const std::optional<SphericalGrid::Cell>& cursor) const {
    MapColours colours(palette);
    const QFontMetricsF metrics(painter.font());
    colours.unit = unitOfLetters(metrics);
    const ShownMap& shown = contents().shown;
    const MapLayout layout = this->layout(place, metrics);
    painter.save();
    QRectF caption = inner(place);
    if (layoutBesideCaption(place, metrics)) caption = besideMap(caption, layout, metrics);
    paintCaption(painter, caption, colours);
    m_cells.paint(painter, layout.area, palette, colours.veil);
    const MapOverlay overlay(painter, layout, colours);
    overlay.paint(*shown.map);
    if (contents().part) overlay.paintPart(*shown.map, *contents().part);
    if (contents().picked)
        overlay.paintPicked(shown.grid(), shown.source().cellsOf(*contents().picked), shown.source().ownerOf(*contents().picked));
    if (!contents().inHand.empty()) overlay.paintInHand(contents().inHand);
    overlay.paintLabels(*shown.map);
    if (cursor) overlay.paintCursor(shown.grid(), *cursor);
    paintAxes(painter, layout, colours);
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
        if (i + 1 < words.size()) {
            painter.drawText(line.topLeft() + QPointF(0.0, metrics.ascent()), words[i]);
        } else {
            // The last line takes the remaining height.
            line.setBottom(place.top() + wordsHeight(metrics));
            painter.drawText(line, Qt::AlignLeft | Qt::TextWordWrap | Qt::TextDontClip, words[i]);
        }
        line.translate(0, lineHeight(metrics));
    }
}

void MapPainter::paintAxes(QPainter& painter, const MapLayout& layout, const MapColours& colours) {
    const QRectF& area = layout.area;
    painter.setRenderHint(QPainter::Antialiasing, false);
    painter.setPen(QPen(colours.faintText, 1.0));
    painter.setBrush(Qt::NoBrush);
    painter.drawRect(area);
    for (int eighth = 0; eighth <= 8; ++eighth) {
        const double x = area.left() + eighth / 8.0 * area.width(), y = area.top() + eighth / 4.0 * area.height();
        painter.drawLine(QPointF(x, area.bottom()), QPointF(x, area.bottom() + MapLayout::kTick));
        if (eighth <= 4) painter.drawLine(QPointF(area.left() - MapLayout::kTick, y), QPointF(area.left(), y));
    }
    painter.setPen(colours.text);
    for (const MapLayout::AxisLabel& label : layout.axisLabels(QFontMetricsF(painter.font())))
        painter.drawText(label.place, Qt::AlignCenter | Qt::TextDontClip, label.words);
}

void MapPainter::paintScale(QPainter& painter, const QRectF& place, const QPalette& palette) const {
    const QFontMetricsF metrics(painter.font());
    const QString least = translated(m_cells.tones().least), most = translated(m_cells.tones().most);
    QPointF at = place.topLeft();
    const auto say = [&](const QString& words) {
        painter.setPen(palette.color(QPalette::Text));
        painter.drawText(at + QPointF(0.0, metrics.ascent()), words);
        at.rx() += metrics.horizontalAdvance(words) + kScaleGap;
    };
    say(least);
    const QRectF bar(at, QSizeF(kScaleWidth, metrics.height() - 2.0));
    paintTones(painter, bar, m_cells.byState(), palette);
    at.rx() += kScaleWidth + kScaleGap;
    say(most);
    at.rx() += kScaleGap;
    say(scaleWords());
}

QString MapPainter::scaleWords() const {
    return m_cells.colouring() && !m_cells.byState() ? translated(m_cells.colouring()->scale) : QString();
}

}  // namespace cullscope::ui
