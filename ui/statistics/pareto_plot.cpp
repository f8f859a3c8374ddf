#include "ui/statistics/pareto_plot.h"

#include <QHelpEvent>
#include <QKeyEvent>
#include <QLocale>
#include <QMouseEvent>
#include <QToolTip>
#include <algorithm>
#include <cmath>

#include "ui/plots/plot_painter.h"
#include "ui/text/translated.h"
#include "ui/text/wording.h"

namespace cullscope::ui {

namespace {

constexpr double kPpmOfAll = 1e6;
constexpr double kPointReach = 12.0;  // pixels

}  // namespace

ParetoPlot::ParetoPlot(QWidget* parent)
    : PlotWidget(parent), m_across(&tradeFigure(kUsualAcross)), m_up(&tradeFigure(kUsualUp)), m_plot({}, *m_across, *m_up) {
    setFocusPolicy(Qt::StrongFocus);
    setMouseTracking(true);
    contentsChanged();
}

void ParetoPlot::setRuns(const std::vector<RunFigures>& runs) {
    m_runs = runs;
    m_current.reset();
    layOut();
}

void ParetoPlot::setAxes(const TradeFigure& across, const TradeFigure& up) {
    m_across = &across;
    m_up = &up;
    layOut();
}

TradePoint ParetoPlot::pointFor(size_t number) const {
    const RunFigures& run = m_runs[number];
    TradePoint point;
    point.name = run.label.toStdString();
    point.promise = run.promise;
    point.role = run.role;
    point.views = run.poses.size();
    point.judged = run.judged;
    point.values = run.values;
    point.values[kUsualAcross] = run.speedup;
    // What counts as lost is decided where the pixels are counted.
    if (!run.missedPpm)
        point.values.erase(kUsualUp);
    else if (const auto known = point.values.find(kUsualUp); known == point.values.end())
        point.values[kUsualUp] = {*run.missedPpm / kPpmOfAll, {}, false};
    return point;
}

void ParetoPlot::layOut() {
    std::vector<RunFigures> placed;
    m_placed.clear();
    for (size_t i = 0; i < m_runs.size(); ++i) {
        const TradePoint point = pointFor(i);
        if (point.value(*m_across) == nullptr || point.value(*m_up) == nullptr) continue;
        m_placed.push_back(i);
        placed.push_back(m_runs[i]);
    }
    m_sweepLines = runSweeps(placed);
    std::vector<TradePoint> points;
    for (size_t i = 0; i < m_placed.size(); ++i) {
        points.push_back(pointFor(m_placed[i]));
        points.back().label = shortLabel(i).toStdString();
    }
    std::vector<TradeSweep> sweeps;
    for (const RunSweep& sweep : m_sweepLines) sweeps.push_back({sweepName(sweep.id, sweep.key).toStdString(), sweep.runs});
    m_plot = TradePlot(std::move(points), *m_across, *m_up, std::move(sweeps));
    contentsChanged();
}

QString ParetoPlot::title() const {
    if (m_across->key == kUsualAcross && m_up->key == kUsualUp) return tr("Speed against loss");
    //: Two figures, as the axes of a plot.
    return tr("%1 by %2").arg(translated(m_up->title), translated(m_across->title));
}

QString ParetoPlot::emptySentence() const {
    if (m_runs.empty()) return PlotWidget::emptySentence();
    return m_up->key == kUsualUp && m_across->key == kUsualAcross
               ? tr("The missed pixels were not measured, so there is no loss to show.")
               : tr("No strategy has both of these figures.");
}

QString ParetoPlot::pointText(size_t run) const {
    const auto place = std::ranges::find(m_placed, run);
    if (place == m_placed.end()) return {};
    const TradePoint& point = m_plot.points()[size_t(place - m_placed.begin())];
    QStringList lines{QStringLiteral("%1, %2").arg(m_runs[run].label, promiseWord(m_runs[run].promise))};
    for (const TradeFigure* figure : {m_across, m_up})
        lines << tr("%1: %2", "a figure and its value")
                     .arg(translated(figure->title), QString::fromStdString(tradeValueText(point, *figure, look(palette()))));
    return lines.join(QLatin1Char('\n'));
}

QString ParetoPlot::description() const {
    if (m_current && *m_current < m_placed.size())
        return tr("%1. Enter shows this strategy in the active view.").arg(pointText(m_placed[*m_current]));
    QStringList lines;
    for (const size_t run : m_placed) lines << pointText(run).replace(QLatin1Char('\n'), QStringLiteral(", "));
    return lines.join(QLatin1Char('\n'));
}

int ParetoPlot::lowestDecade() const { return m_plot.lowestDecade(*m_up); }

double ParetoPlot::height(double missedPpm) const { return m_plot.along(*m_up, missedPpm / kPpmOfAll); }

QString ParetoPlot::zeroLabel() const { return QString::fromStdString(m_plot.zeroLabel(*m_up, look(palette()))); }

QString ParetoPlot::shortLabel(size_t placed) const {
    QStringList values;
    for (const RunSweep& sweep : m_sweepLines)
        for (size_t i = 0; i < sweep.runs.size(); ++i)
            if (sweep.runs[i] == placed) values << sweep.values[qsizetype(i)];
    if (!values.isEmpty()) return values.join(QStringLiteral(" · "));
    // Ids are shorter; they do where they tell the runs apart.
    const RunFigures& run = m_runs[m_placed[placed]];
    const auto same = std::ranges::count_if(m_placed, [&](size_t other) { return m_runs[other].id == run.id; });
    return same > 1 ? run.label : run.id;
}

TradeLook ParetoPlot::look(const QPalette& palette) const {
    const PlotColours colours(palette);
    TradeLook look;
    look.style = plotStyle(font(), colours);
    look.darkBaseline = colours.baselineCull.rgba();
    look.lightBaseline = colours.ground.rgba();
    look.words = [](const Message& message) { return translated(message).toStdString(); };
    look.decade = [](double value) {
        return QLocale().toString(value, 'f', std::max(0, -int(std::floor(std::log10(value) + 0.5)))).toStdString();
    };
    return look;
}

std::vector<LinePlot> ParetoPlot::plots(const QPalette& palette) const { return {m_plot.plot(look(palette))}; }

std::optional<QPointF> ParetoPlot::pointOf(size_t run) const {
    const auto place = std::ranges::find(m_placed, run);
    if (place == m_placed.end()) return std::nullopt;
    const PlotDrawing drawn = drawing();
    if (drawn.places.empty()) return std::nullopt;
    const PlotPoint pixel = drawn.places.front().pixel(m_plot.place(m_plot.points()[size_t(place - m_placed.begin())]));
    return QPointF(pixel.x, pixel.y);
}

std::optional<size_t> ParetoPlot::runAt(const QPointF& place) const {
    if (empty()) return std::nullopt;
    const PlotDrawing drawn = drawing();
    std::optional<size_t> nearest;
    double reach = kPointReach;
    for (size_t i = 0; i < m_placed.size() && !drawn.places.empty(); ++i) {
        const PlotPoint pixel = drawn.places.front().pixel(m_plot.place(m_plot.points()[i]));
        const double distance = std::hypot(pixel.x - place.x(), pixel.y - place.y());
        if (distance > reach) continue;
        reach = distance;
        nearest = m_placed[i];
    }
    return nearest;
}

bool ParetoPlot::event(QEvent* event) {
    if (event->type() != QEvent::ToolTip) return PlotWidget::event(event);
    const auto* help = static_cast<QHelpEvent*>(event);
    showValues(help->pos(), help->globalPos());
    return true;
}

void ParetoPlot::mouseMoveEvent(QMouseEvent* event) {
    setCursor(runAt(event->position()) ? Qt::PointingHandCursor : Qt::ArrowCursor);
    showValues(event->position(), event->globalPosition().toPoint());
}

void ParetoPlot::showValues(const QPointF& place, const QPoint& onScreen) {
    const std::optional<size_t> run = runAt(place);
    if (!run)
        QToolTip::hideText();
    else
        QToolTip::showText(onScreen, pointText(*run) + QLatin1Char('\n') + tr("A click shows it in the active view."), this);
}

void ParetoPlot::choose(size_t run) { emit strategyChosen({m_runs[run].id.toStdString(), m_runs[run].parameters}); }

void ParetoPlot::mouseReleaseEvent(QMouseEvent* event) {
    const std::optional<size_t> run = event->button() == Qt::LeftButton ? runAt(event->position()) : std::nullopt;
    if (!run) return PlotWidget::mouseReleaseEvent(event);
    choose(*run);
}

void ParetoPlot::keyPressEvent(QKeyEvent* event) {
    if (empty()) return PlotWidget::keyPressEvent(event);
    const size_t last = m_placed.size() - 1;
    switch (event->key()) {
        case Qt::Key_Left:
            m_current = m_current && *m_current > 0 ? *m_current - 1 : 0;
            return contentsChanged();
        case Qt::Key_Right:
            m_current = m_current ? std::min(last, *m_current + 1) : 0;
            return contentsChanged();
        case Qt::Key_Return:
        case Qt::Key_Enter:
        case Qt::Key_Space:
            if (m_current) choose(m_placed[*m_current]);
            return;
        default:
            PlotWidget::keyPressEvent(event);
    }
}

}  // namespace cullscope::ui
