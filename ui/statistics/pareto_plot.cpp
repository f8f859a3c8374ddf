#include "ui/statistics/pareto_plot.h"

#include <QLocale>
#include <algorithm>
#include <cmath>

#include "ui/text/wording.h"

namespace cullscope::ui {

namespace {

PlotShape shapeOf(Promise promise) {
    if (promise == Promise::Exact) return PlotShape::Disc;
    return promise == Promise::Conservative ? PlotShape::Square : PlotShape::Triangle;
}

}  // namespace

ParetoPlot::ParetoPlot(QWidget* parent) : PlotWidget(parent) { contentsChanged(); }

void ParetoPlot::setRuns(const std::vector<RunFigures>& runs) {
    m_runs.clear();
    std::copy_if(runs.begin(), runs.end(), std::back_inserter(m_runs),
                 [](const RunFigures& run) { return run.missedPpm.has_value(); });
    m_lossUnknown = m_runs.empty() && !runs.empty();
    m_sweepLines = runSweeps(m_runs);
    contentsChanged();
}

QString ParetoPlot::title() const { return tr("Speed against loss"); }

QString ParetoPlot::emptySentence() const {
    return m_lossUnknown ? tr("The missed pixels were not measured, so there is no loss to show.") : PlotWidget::emptySentence();
}

QString ParetoPlot::description() const {
    QStringList lines;
    for (const RunFigures& run : m_runs)
        lines << tr("%1, %2: ×%3, %4 per million missed")
                     .arg(run.label, promiseWord(run.promise), ratioText(run.speedup.ratio),
                          *run.missedPpm > 0.0 ? ppmText(*run.missedPpm) : zeroLabel());
    return lines.join(QLatin1Char('\n'));
}

int ParetoPlot::lowestDecade() const {
    int lowest = 0;
    for (const RunFigures& run : m_runs)
        if (*run.missedPpm > 0.0) lowest = std::min(lowest, int(std::floor(std::log10(*run.missedPpm))));
    return lowest;
}

int ParetoPlot::highestDecade() const {
    int highest = 3;
    for (const RunFigures& run : m_runs)
        if (*run.missedPpm > 0.0) highest = std::max(highest, int(std::ceil(std::log10(*run.missedPpm))));
    return highest;
}

double ParetoPlot::height(double missedPpm) const { return missedPpm > 0.0 ? std::log10(missedPpm) : lowestDecade() - 1.0; }

QString ParetoPlot::zeroLabel() const {
    size_t views = 0;
    for (const RunFigures& run : m_runs) views = std::max(views, run.poses.size());
    //: Nothing missed in %1 views: with 95 % confidence, the share of views that lose something is below 3/%1.
    return tr("0 (< 3/%1)").arg(views);
}

const RunSweep* ParetoPlot::sweepOf(size_t run) const {
    const auto found = std::find_if(m_sweepLines.begin(), m_sweepLines.end(), [&](const RunSweep& sweep) {
        return std::find(sweep.runs.begin(), sweep.runs.end(), run) != sweep.runs.end();
    });
    return found == m_sweepLines.end() ? nullptr : &*found;
}

QString ParetoPlot::shortLabel(size_t run) const {
    QStringList values;
    for (const RunSweep& sweep : m_sweepLines)
        for (size_t i = 0; i < sweep.runs.size(); ++i)
            if (sweep.runs[i] == run) values << sweep.values[qsizetype(i)];
    if (!values.isEmpty()) return values.join(QStringLiteral(" · "));
    // Ids are shorter; they do where they tell the runs apart.
    const auto same =
        std::count_if(m_runs.begin(), m_runs.end(), [&](const RunFigures& other) { return other.id == m_runs[run].id; });
    return same > 1 ? m_runs[run].label : m_runs[run].id;
}

std::vector<QColor> ParetoPlot::runColours(const PlotColours& colours) const {
    std::vector<QColor> ofRuns;
    size_t single = m_sweepLines.size();
    for (size_t run = 0; run < m_runs.size(); ++run) {
        const RunSweep* sweep = sweepOf(run);
        if (sweep)
            ofRuns.push_back(colours.series(size_t(sweep - m_sweepLines.data())));
        else
            ofRuns.push_back(m_runs[run].baseline ? colours.faintText : colours.series(single++));
    }
    return ofRuns;
}

PlotAxis ParetoPlot::lossAxis() const {
    const int lowest = lowestDecade(), highest = highestDecade();
    PlotAxis axis{tr("Missed per million").toStdString(), PlotScale::Linear, lowest - 1.5, highest + 0.2};
    axis.ticks = {{lowest - 1.0, zeroLabel().toStdString()}};
    for (int decade = lowest; decade <= highest; ++decade)
        axis.ticks.push_back(
            {double(decade), QLocale().toString(std::pow(10.0, decade), 'f', std::max(0, -decade)).toStdString()});
    return axis;
}

void ParetoPlot::addSweeps(LinePlot& plot, const PlotColours& colours) const {
    for (size_t number = 0; number < m_sweepLines.size(); ++number) {
        std::vector<PlotPoint> points;
        for (const size_t run : m_sweepLines[number].runs)
            points.push_back({m_runs[run].speedup.ratio, height(*m_runs[run].missedPpm)});
        const std::string name = sweepName(m_sweepLines[number].id, m_sweepLines[number].key).toStdString();
        plot.lines.push_back(plainLine(name, std::move(points), {colours.series(number).rgba(), 1.4}));
    }
}

void ParetoPlot::addRuns(LinePlot& plot, const PlotColours& colours) const {
    const std::vector<QColor> ofRuns = runColours(colours);
    for (size_t i = 0; i < m_runs.size(); ++i) {
        const RunFigures& run = m_runs[i];
        const double y = height(*run.missedPpm);
        // Paler than the sweeps, which run the same way where nothing is missed.
        QColor pale = ofRuns[i];
        pale.setAlphaF(0.5F);
        if (run.speedup.hasInterval)
            plot.lines.push_back(plainLine({}, {{run.speedup.ci95[0], y}, {run.speedup.ci95[1], y}}, {pale.rgba(), 1.5}));
        // The baselines, both grey, are a dark and a light one.
        const QColor grey = run.role == BaselineRole::Triangles ? colours.baselineCull : colours.ground;
        plot.marks.push_back({sweepOf(i) ? std::string() : run.label.toStdString(),
                              {run.speedup.ratio, y},
                              shapeOf(run.promise),
                              {colours.text.rgba(), 1.2},
                              (run.baseline ? grey : ofRuns[i]).rgba(),
                              shortLabel(i).toStdString()});
    }
    for (const Promise promise : {Promise::Exact, Promise::Conservative, Promise::Approximate})
        if (std::any_of(m_runs.begin(), m_runs.end(), [&](const RunFigures& run) { return run.promise == promise; }))
            plot.marks.push_back({tr("shape: %1").arg(promiseWord(promise)).toStdString(),
                                  kNoPlace,
                                  shapeOf(promise),
                                  {colours.faintText.rgba(), 1.2, PlotStroke::Dotted}});
}

std::vector<LinePlot> ParetoPlot::plots(const QPalette& palette) const {
    const PlotColours colours(palette);
    LinePlot plot;
    const QString axis = tr("Speed against a baseline that draws the same sides");
    plot.x = {axis.toStdString(), PlotScale::Linear, 0.0, 0.0, true};
    plot.y = lossAxis();
    plot.lines = {plainLine({}, {{1.0, plot.y.least}, {1.0, plot.y.most}}, {colours.faintText.rgba(), 1.0, PlotStroke::Dashed})};
    addSweeps(plot, colours);
    addRuns(plot, colours);
    // The band on which nothing missed stands.
    plot.bars = {{{}, colours.grid.rgba(), {{0.0, lowestDecade() - 0.5, rangeAlongX(plot).last, plot.y.least}}}};
    return {std::move(plot)};
}

}  // namespace cullscope::ui
