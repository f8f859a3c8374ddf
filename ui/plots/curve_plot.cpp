#include "ui/plots/curve_plot.h"

#include <QHelpEvent>
#include <QToolTip>
#include <cmath>

#include "ui/look/in_hand.h"
#include "ui/look/verdict_swatch.h"
#include "ui/text/terms.h"

namespace cullscope::ui {
namespace {

PlotAxis plotAxis(const CurveAxis& axis) {
    PlotAxis made{translated(axis.title).toStdString(), PlotScale::Linear, axis.least, axis.most, axis.zero};
    if (axis.tickStep <= 0.0) return made;
    for (int tick = 0; axis.least + tick * axis.tickStep <= axis.most; ++tick) {
        const double value = axis.least + tick * axis.tickStep;
        made.ticks.push_back({value, QString::number(value).toStdString() + axis.unit});
    }
    return made;
}

}  // namespace

CurvePlot::CurvePlot(QWidget* parent) : PlotWidget(parent) {
    setMouseTracking(true);
    setFocusPolicy(Qt::StrongFocus);
}

void CurvePlot::setCurve(std::optional<Curve> curve) {
    m_curve = std::move(curve);
    contentsChanged();
}

void CurvePlot::setBrief() {
    m_brief = true;
    contentsChanged();
}

void CurvePlot::setInHand(const std::optional<Vec2>& values) {
    if (values == m_inHand) return;
    m_inHand = values;
    contentsChanged();
}

void CurvePlot::setAbsence(const QString& sentence) {
    m_absence = sentence;
    contentsChanged();
}

QString CurvePlot::title() const { return m_curve ? translated(m_curve->title) : m_name; }

QString CurvePlot::emptySentence() const {
    if (m_curve) return translated(m_curve->absence);
    return m_absence.isEmpty() ? tr("This frame has nothing to show here.") : m_absence;
}

QString CurvePlot::description() const {
    QStringList lines;
    for (const Words& words : m_curve->summary) lines << translated(words);
    for (const CurveInterval& interval : m_curve->intervals)
        if (!interval.empty) lines << translatedLines(interval.words).join(QLatin1String(", "));
    return lines.join(QLatin1Char('\n'));
}

QPointF CurvePlot::placeOf(double x, double y) const {
    const PlotPoint place = drawing().places.front().pixel({x, y});
    return {place.x, place.y};
}

void CurvePlot::addUprights(LinePlot& plot, const QPalette& palette) const {
    const PlotColours colours(palette);
    const double most = rangeAlongY(plot).last;
    for (const CurveUpright& upright : m_curve->uprights) {
        const PlotPen pen = upright.limit ? PlotPen{colours.loss.rgba(), 2.0, PlotStroke::Dashed}
                                          : PlotPen{colours.faintText.rgba(), 1.2, PlotStroke::Dotted};
        PlotLine line = plainLine(translated(upright.name).toStdString(), {}, pen);
        if (upright.at) {
            line.points = {{*upright.at, 0.0}, {*upright.at, most}};
            if (!upright.label.empty()) {
                PlotMark words;
                words.at = line.points.back();
                words.label = translated(upright.label).toStdString();
                plot.marks.push_back(std::move(words));
            }
        }
        plot.lines.push_back(std::move(line));
    }
}

void CurvePlot::addInHand(LinePlot& plot) const {
    if (!m_inHand) return;
    const double most = rangeAlongY(plot).last;
    const std::vector<PlotPoint> column{{m_inHand->x, 0.0}, {m_inHand->x, most}, {m_inHand->y, most}, {m_inHand->y, 0.0}};
    plot.lines.push_back(plainLine({}, column, {kInHandEdge.rgba(), kInHandEdgeWidth}));
    plot.lines.push_back(plainLine({}, column, {kInHandColour.rgba(), kInHandWidth}));
}

std::vector<LinePlot> CurvePlot::plots(const QPalette& palette) const {
    const PlotColours colours(palette);
    LinePlot plot;
    plot.x = plotAxis(m_curve->x);
    plot.y = plotAxis(m_curve->y);
    for (const CurveArea& area : m_curve->areas) {
        PlotBars bars{
            m_brief ? std::string() : translated(area.name).toStdString(), verdictColour(area.state, palette).rgba(), {}};
        for (const CurveArea::Box& box : area.boxes) bars.boxes.push_back({box.left, box.top, box.right, 0.0});
        plot.bars.push_back(std::move(bars));
    }
    for (const CurveLine& line : m_curve->lines) {
        std::vector<PlotPoint> points;
        for (const Vec2& point : line.points) points.push_back({point.x, point.y});
        // On areas as dark as itself it has an edge.
        plot.lines.push_back(plainLine({}, points, {colours.ground.rgba(), 3.5}));
        plot.lines.push_back(plainLine(translated(line.name).toStdString(), std::move(points), {colours.text.rgba(), 1.6}));
    }
    addUprights(plot, palette);
    addInHand(plot);
    return {std::move(plot)};
}

QString CurvePlot::wordsAt(const QPointF& place) const {
    if (empty()) return {};
    const PlotPlace where = drawing().places.front();
    if (!where.box.contains({place.x(), place.y()})) return {};
    const double share = (place.x() - where.box.left) / (where.box.right - where.box.left);
    const CurveInterval* interval = m_curve->intervalAt(where.x.first + share * (where.x.last - where.x.first));
    return interval ? translatedLines(interval->words).join(QLatin1Char('\n')) : QString();
}

bool CurvePlot::event(QEvent* event) {
    if (event->type() != QEvent::ToolTip) return PlotWidget::event(event);
    const auto* help = static_cast<QHelpEvent*>(event);
    const QString words = wordsAt(help->pos());
    if (words.isEmpty())
        QToolTip::hideText();
    else
        QToolTip::showText(help->globalPos(), words, this);
    return true;
}

}  // namespace cullscope::ui
