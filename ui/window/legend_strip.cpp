#include "ui/window/legend_strip.h"

#include <QLabel>
#include <QPainter>
#include <algorithm>
#include <set>

#include "core/image/view_picture.h"
#include "core/visibility/registry.h"
#include "ui/look/in_hand.h"
#include "ui/look/meaning_colour.h"
#include "ui/look/plane_swatch.h"
#include "ui/look/verdict_swatch.h"
#include "ui/panels/shown_strategy.h"
#include "ui/plots/map_cells.h"
#include "ui/statistics/flow_layout.h"
#include "ui/text/translated.h"

namespace cullscope::ui {

namespace {

constexpr int kLegendGap = 18, kRowGap = 4;
constexpr int kLettersOfLecture = 20;  // pixels, at 1280 × 720
constexpr int kLeastSwatch = 12;       // pixels

/// A rectangle in the colour that is explained.
class LegendSwatch : public QWidget {
public:
    LegendSwatch(const std::optional<TriangleState>& state, const QColor& colour, int size, QWidget* parent)
        : QWidget(parent), m_state(state), m_colour(colour) {
        setFixedSize(size, size);
    }

protected:
    void paintEvent(QPaintEvent*) override {
        QPainter painter(this);
        const QRectF place = QRectF(rect()).adjusted(1, 1, -1, -1);
        if (m_state)
            drawVerdictSwatch(painter, place, *m_state, palette());
        else
            painter.fillRect(place, m_colour);
    }

private:
    std::optional<TriangleState> m_state;
    QColor m_colour;
};

/// A line in the colour that is explained: a filled square would say that surfaces have it.
class LineSwatch : public QWidget {
public:
    LineSwatch(const QColor& colour, int size, QWidget* parent) : QWidget(parent), m_colour(colour) {
        setFixedSize(kLineLength * size, size);
    }

protected:
    void paintEvent(QPaintEvent*) override {
        QPainter painter(this);
        const double middle = 0.5 * height();
        painter.setPen(QPen(m_colour, kLineWidth, Qt::SolidLine, Qt::FlatCap));
        painter.drawLine(QPointF(0, middle), QPointF(width(), middle));
    }

private:
    static constexpr int kLineLength = 2;  // heights of a swatch
    static constexpr double kLineWidth = 3.0;
    QColor m_colour;
};

/// The tones of a map's cells, from least to most.
class TonesSwatch : public QWidget {
public:
    TonesSwatch(int size, QWidget* parent) : QWidget(parent) { setFixedSize(3 * size, size); }

protected:
    void paintEvent(QPaintEvent*) override {
        QPainter painter(this);
        paintTones(painter, QRectF(rect()).adjusted(1, 1, -1, -1), false, palette());
    }
};

/// The outline of what a step has in hand.
class InHandSwatch : public QWidget {
public:
    InHandSwatch(int size, QWidget* parent) : QWidget(parent) { setFixedSize(size, size); }

protected:
    void paintEvent(QPaintEvent*) override {
        QPainter painter(this);
        painter.setBrush(Qt::NoBrush);
        const double edge = kInHandEdgeWidth / 2.0;
        const QRectF place = QRectF(rect()).adjusted(edge, edge, -edge, -edge);
        for (const auto& [colour, width] : {std::pair(kInHandEdge, kInHandEdgeWidth), std::pair(kInHandColour, kInHandWidth)}) {
            painter.setPen(QPen(colour, width, Qt::SolidLine, Qt::SquareCap, Qt::MiterJoin));
            painter.drawRect(place);
        }
    }
};

/// A line or a mark of a map.
class SymbolSwatch : public QWidget {
public:
    SymbolSwatch(MapSymbol symbol, const QFont& letters, QWidget* parent)
        : QWidget(parent), m_symbol(symbol), m_unit(unitOfLetters(QFontMetricsF(letters))) {
        setFixedSize(int(kSymbolWidth * m_unit), QFontMetrics(letters).height());
    }

protected:
    void paintEvent(QPaintEvent*) override {
        QPainter painter(this);
        painter.setRenderHint(QPainter::Antialiasing);
        MapColours colours(palette());
        colours.unit = m_unit;
        paintSymbol(painter, rect(), m_symbol, colours);
    }

private:
    static constexpr double kSymbolWidth = 24.0;
    MapSymbol m_symbol;
    double m_unit;
};

/// The states in whose colours a look shows boxes and other lines.
std::set<TriangleState> statesOfLines(const ViewLook& look, const StrategyInfo& strategy) {
    std::set<TriangleState> states;
    const auto add = [&](const Show& show) { states.insert(show.legend.begin(), show.legend.end()); };
    if (look.inPlace()) return states;
    for (const Show& show : strategy.shows)
        if (show.kind == Show::Kind::Overlay && look.shows(show.id)) add(show);
    const bool boxes = look.has(Show::Kind::Boxes) && !look.has(Show::Kind::Planes);
    if (boxes && !strategy.first(Show::Kind::Boxes)) add(commonShow(Show::Kind::Boxes));
    return states;
}

}  // namespace

LegendStrip::LegendStrip(Session& session, QWidget* parent) : QWidget(parent), m_session(session) {
    auto* rows = new FlowLayout(this, kLegendGap, kRowGap);
    rows->setContentsMargins(0, 0, 0, 0);
}

std::vector<LegendStrip::Entry> LegendStrip::entriesOf(const std::vector<int>& views, const More& more) const {
    std::array<bool, kTriangleStateCount> states{};
    // All that a bar may have, so that the row keeps its height while the views move.
    if (more.bars && !m_session.question()) states.fill(true);
    states[size_t(TriangleState::Undecided)] = false;
    for (const TriangleState state : more.states) states[size_t(state)] = true;
    bool planes = false, marks = false, differences = false, snapped = false, added = false;
    const bool stepped = std::ranges::any_of(views, [&](int view) { return m_session.stepOf(view) != nullptr; });
    for (const int view : views) {
        const ViewSetup& setup = m_session.setup(view);
        if (m_session.question()) break;
        marks = marks || setup.wipe.mode == Wipe::Mode::Loss;
        differences = differences || setup.wipe.mode == Wipe::Mode::Difference;
        planes = planes || (setup.look.has(Show::Kind::Planes) && setup.look.has(Show::Kind::Boxes));
        const StrategyInfo& strategy = findStrategy(m_session.slot(m_session.culledBy(view)).id()).info;
        for (const TriangleState state : statesOfLines(setup.look, strategy)) states[size_t(state)] = true;
        const ViewMetrics& figures = m_session.figures(view);
        const bool known = figures.state == ViewMetrics::State::Ready && figures.states;
        const ViewPicturePointer& picture = m_session.picture(view);
        const bool marked = setup.wipe.mode == Wipe::Mode::Loss && picture && picture->request.wipe == Wipe::Mode::Loss;
        snapped = snapped || (marks && more.bars) || (marked && picture->withinSnapping > 0);
        added = added || (marks && more.bars) || (marked && picture->added > 0);
        if (!setup.look.has(Show::Kind::Verdicts)) continue;
        for (const Show::Kind kind : {Show::Kind::Verdicts, Show::Kind::Left})
            for (const TriangleState state : commonShow(kind).legend)
                if (setup.look.has(kind) && (!known || figures.states->counts[size_t(state)] > 0)) states[size_t(state)] = true;
        if (m_session.stepOf(view)) states[size_t(TriangleState::Undecided)] = true;
    }
    std::vector<Entry> entries;
    for (size_t state = 0; state < states.size(); ++state)
        if (states[state]) entries.push_back({translated(triangleStateName(TriangleState(state))), TriangleState(state), {}});
    if (marks) entries.push_back({tr("missed pixels"), {}, verdictColour(TriangleState::WronglyCulled, palette())});
    if (snapped) entries.push_back({tr("within snapping"), {}, snappedPixelColour()});
    if (added) entries.push_back({tr("nearer than the truth"), {}, addedPixelColour()});
    if (differences) entries.push_back({tr("pixels that differ"), {}, verdictColour(TriangleState::WronglyCulled, palette())});
    if (planes)
        for (size_t plane = 0; plane < kFrustumPlaneCount; ++plane)
            entries.push_back({translated(planeName(FrustumPlane(plane))), {}, planeColour(FrustumPlane(plane), palette())});
    // A map's line that means the same stands for both.
    for (const ShowMeaning& meaning : m_session.question() ? std::vector<ShowMeaning>() : meaningsIn(m_session, views))
        if (std::ranges::find(more.lines, translated(meaning.words), &MapLegend::Entry::words) == more.lines.end())
            entries.push_back({translated(meaning.words), {}, meaningColour(meaning, palette()), {}, false, true});
    if (stepped) entries.push_back({tr("in hand"), {}, {}, {}, true});
    for (const MapLegend::Entry& line : more.lines) entries.push_back({line.words, {}, {}, line.symbol});
    for (const QString& scale : more.scales) entries.push_back({scale, {}, {}, {}, false, false, true});
    return entries;
}

bool LegendStrip::explain(const std::vector<int>& views, int letters, const More& more) {
    std::vector<Entry> entries = entriesOf(views, more);
    if (entries == m_entries && letters == m_letters) return false;
    m_entries = std::move(entries);
    m_letters = letters;
    for (QWidget* former : findChildren<QWidget*>(Qt::FindDirectChildrenOnly)) delete former;
    QFont font = this->font();
    font.setPixelSize(letters);
    for (const Entry& entry : m_entries) {
        auto* item = new QWidget(this);
        auto* row = new QHBoxLayout(item);
        // Larger letters stand farther apart.
        row->setContentsMargins(0, 0, std::max(0, kLegendGap * (letters - kLettersOfLecture) / kLettersOfLecture), 0);
        row->setSpacing(letters / 3);
        const int size = std::max(kLeastSwatch, letters * 3 / 4);
        if (entry.symbol)
            row->addWidget(new SymbolSwatch(*entry.symbol, font, item));
        else if (entry.inHand)
            row->addWidget(new InHandSwatch(size, item));
        else if (entry.tones)
            row->addWidget(new TonesSwatch(size, item));
        else if (entry.line)
            row->addWidget(new LineSwatch(entry.colour, size, item));
        else
            row->addWidget(new LegendSwatch(entry.state, entry.colour, size, item));
        auto* words = new QLabel(entry.words, item);
        words->setFont(font);
        row->addWidget(words);
        layout()->addWidget(item);
        item->show();
    }
    updateGeometry();
    return true;
}

QStringList LegendStrip::words() const {
    QStringList words;
    for (const Entry& entry : m_entries) words << entry.words;
    return words;
}

}  // namespace cullscope::ui
