#include "core/experiments/trade_plot.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/measure/field_figures.h"
#include "core/visibility/registry.h"

namespace cullscope {
namespace {

PlotShape shapeOf(Promise promise) {
    if (promise == Promise::Exact) return PlotShape::Disc;
    return promise == Promise::Conservative ? PlotShape::Square : PlotShape::Triangle;
}

const char* shapeName(Promise promise) {
    if (promise == Promise::Exact) return CULLSCOPE_TR("shape: exact set");
    return promise == Promise::Conservative ? CULLSCOPE_TR("shape: lossless") : CULLSCOPE_TR("shape: lossy");
}

std::string wordsOf(const TradeLook& look, const Message& message) {
    return look.words ? look.words(message) : message.english();
}

PlotColour seriesOf(const TradeLook& look, size_t number) {
    const std::span<const PlotColour> series = look.style.series.empty() ? plotSeries(false) : look.style.series;
    return series[number % series.size()];
}

PlotColour paler(PlotColour colour) { return (colour & 0x00FFFFFF) | 0x80000000; }

/// What a loss of 0 says of one point.
std::string zeroText(const TradePoint& point, const TradeLook& look) {
    return wordsOf(look, point.judged ? noLossIn(point.views) : Message{CULLSCOPE_TR("0 as promised, not judged"), {}});
}

bool better(const TradeFigure& figure, double one, double other) { return figure.least ? one < other : one > other; }

}  // namespace

std::vector<size_t> paretoFront(std::span<const TradePoint> points, const TradeFigure& across, const TradeFigure& up,
                                bool lossless) {
    std::vector<size_t> candidates, front;
    for (size_t i = 0; i < points.size(); ++i)
        if (points[i].value(across) != nullptr && points[i].value(up) != nullptr && points[i].lossless() == lossless &&
            !points[i].name.starts_with(limitOfCulling().id))
            candidates.push_back(i);
    const auto value = [&](size_t point, const TradeFigure& figure) { return points[point].value(figure)->ratio; };
    for (const size_t one : candidates) {
        const bool surpassed = std::ranges::any_of(candidates, [&](size_t other) {
            const bool behind =
                better(across, value(one, across), value(other, across)) || better(up, value(one, up), value(other, up));
            const bool ahead =
                better(across, value(other, across), value(one, across)) || better(up, value(other, up), value(one, up));
            return ahead && !behind;
        });
        if (!surpassed) front.push_back(one);
    }
    std::ranges::stable_sort(front, {}, [&](size_t point) { return value(point, across); });
    return front;
}

TradePlot::TradePlot(std::vector<TradePoint> points, const TradeFigure& across, const TradeFigure& up,
                     std::vector<TradeSweep> sweeps)
    : m_sweeps(std::move(sweeps)), m_across(&across), m_up(&up) {
    if (m_sweeps.empty())
        for (size_t i = 0; i < points.size(); ++i) {
            if (points[i].sweep.empty()) continue;
            const auto known = std::ranges::find(m_sweeps, points[i].sweep, &TradeSweep::name);
            if (known == m_sweeps.end())
                m_sweeps.push_back({points[i].sweep, {i}});
            else
                known->points.push_back(i);
        }
    // The numbers of those points that have a place.
    std::vector<std::optional<size_t>> number(points.size());
    for (size_t i = 0; i < points.size(); ++i) {
        if (points[i].value(across) == nullptr || points[i].value(up) == nullptr) continue;
        number[i] = m_points.size();
        m_points.push_back(std::move(points[i]));
    }
    for (TradeSweep& sweep : m_sweeps) {
        std::erase_if(sweep.points, [&](size_t point) { return !number[point]; });
        for (size_t& point : sweep.points) point = *number[point];
    }
}

size_t TradePlot::sweepOf(size_t point) const {
    return size_t(
        std::ranges::find_if(
            m_sweeps, [&](const TradeSweep& sweep) { return std::ranges::find(sweep.points, point) != sweep.points.end(); }) -
        m_sweeps.begin());
}

int TradePlot::lowestDecade(const TradeFigure& figure) const {
    int lowest = 0;
    for (const TradePoint& point : m_points)
        if (const double value = point.value(figure)->ratio * figure.scale; value > 0.0)
            lowest = std::min(lowest, int(std::floor(std::log10(value))));
    return lowest;
}

int TradePlot::highestDecade(const TradeFigure& figure) const {
    int highest = figure.scale == 100.0 ? 2 : 3;  // percentages end at 100
    for (const TradePoint& point : m_points)
        if (const double value = point.value(figure)->ratio * figure.scale; value > 0.0)
            highest = std::max(highest, int(std::ceil(std::log10(value))));
    return highest;
}

double TradePlot::along(const TradeFigure& figure, double value) const {
    const double shown = value * figure.scale;
    if (!figure.decades) return shown;
    const int lowest = lowestDecade(figure);
    return shown > 0.0 ? std::max(double(lowest) - 0.4, std::log10(shown)) : lowest - 1.0;
}

PlotPoint TradePlot::place(const TradePoint& point) const {
    return {along(*m_across, point.value(*m_across)->ratio), along(*m_up, point.value(*m_up)->ratio)};
}

std::string TradePlot::zeroLabel(const TradeFigure& figure, const TradeLook& look) const {
    if (!figure.ofLoss || m_points.empty() || zerosDiffer(figure)) return "0";
    size_t views = 0;
    for (const TradePoint& point : m_points)
        if (point.judged) views = std::max(views, point.views);
    for (const TradePoint& point : m_points)
        if (point.judged && point.value(figure)->ratio == 0.0) views = point.views;
    return views > 0 ? wordsOf(look, noLossIn(views)) : std::string("0");
}

bool TradePlot::zerosDiffer(const TradeFigure& figure) const {
    const TradePoint* first = nullptr;
    for (const TradePoint& point : m_points) {
        if (!figure.ofLoss || point.value(figure)->ratio != 0.0) continue;
        if (first == nullptr) first = &point;
        if (point.judged != first->judged || (point.judged && point.views != first->views)) return true;
    }
    return first != nullptr && !first->judged;
}

std::string TradePlot::withZero(const TradePoint& point, const std::string& name, const TradeLook& look) const {
    for (const TradeFigure* figure : {m_up, m_across})
        if (point.value(*figure)->ratio == 0.0 && zerosDiffer(*figure)) return fmt::format("{}: {}", name, zeroText(point, look));
    return name;
}

PlotAxis TradePlot::axis(const TradeFigure& figure, const TradeLook& look) const {
    PlotAxis axis{wordsOf(look, {figure.title, {}}), PlotScale::Linear, 0.0, 0.0, true};
    if (!figure.decades) return axis;
    const int lowest = lowestDecade(figure), highest = highestDecade(figure);
    axis = {axis.title, PlotScale::Linear, lowest - 1.5, highest + 0.2};
    axis.ticks = {{lowest - 1.0, zeroLabel(figure, look)}};
    for (int decade = lowest; decade <= highest; ++decade) {
        const double value = std::pow(10.0, decade);
        axis.ticks.push_back({double(decade), look.decade ? look.decade(value) : plotNumber(value)});
    }
    return axis;
}

void TradePlot::addSweeps(LinePlot& plot, const TradeLook& look) const {
    for (size_t number = 0; number < m_sweeps.size(); ++number) {
        std::vector<PlotPoint> places;
        for (const size_t point : m_sweeps[number].points) places.push_back(place(m_points[point]));
        plot.lines.push_back(plainLine(m_sweeps[number].name, std::move(places), {seriesOf(look, number), 1.4}));
    }
}

void TradePlot::addPoints(LinePlot& plot, const TradeLook& look) const {
    size_t next = m_sweeps.size();
    for (size_t i = 0; i < m_points.size(); ++i) {
        const TradePoint& point = m_points[i];
        const PlotPoint at = place(point);
        const size_t sweep = sweepOf(i);
        PlotColour colour = 0;
        if (sweep < m_sweeps.size())
            colour = seriesOf(look, sweep);
        else if (point.role != BaselineRole::None)
            colour = point.role == BaselineRole::Triangles ? look.darkBaseline : look.lightBaseline;
        else
            colour = seriesOf(look, next++);
        // Paler than the sweeps, which run the same way where nothing is missed.
        const PlotPen pale{paler(point.role == BaselineRole::None ? colour : look.style.faint), 1.5};
        if (const RatioEstimate& x = *point.value(*m_across); x.hasInterval)
            plot.lines.push_back(plainLine({}, {{along(*m_across, x.ci95[0]), at.y}, {along(*m_across, x.ci95[1]), at.y}}, pale));
        if (const RatioEstimate& y = *point.value(*m_up); y.hasInterval)
            plot.lines.push_back(plainLine({}, {{at.x, along(*m_up, y.ci95[0])}, {at.x, along(*m_up, y.ci95[1])}}, pale));
        const bool single = sweep == m_sweeps.size();
        plot.marks.push_back({single ? withZero(point, point.name, look) : std::string(),
                              at,
                              shapeOf(point.promise),
                              {look.style.text, 1.2},
                              colour,
                              single ? point.label : withZero(point, point.label, look)});
    }
    for (const Promise promise : {Promise::Exact, Promise::Conservative, Promise::Approximate})
        if (std::ranges::any_of(m_points, [&](const TradePoint& point) { return point.promise == promise; }))
            plot.marks.push_back({wordsOf(look, {shapeName(promise), {}}),
                                  kNoPlace,
                                  shapeOf(promise),
                                  {look.style.faint, 1.2, PlotStroke::Dotted}});
}

void TradePlot::addFronts(LinePlot& plot, const TradeLook& look) const {
    for (const bool lossless : {true, false}) {
        const std::vector<size_t> front = paretoFront(m_points, *m_across, *m_up, lossless);
        if (front.size() < 2) continue;
        std::vector<PlotPoint> steps;
        for (const size_t number : front) {
            const PlotPoint at = place(m_points[number]);
            // What lies between two points of a front is as good as the worse of both in each figure: from the point that is
            // better across, one goes to the other's height first.
            if (!steps.empty())
                steps.push_back(m_across->least ? PlotPoint{at.x, steps.back().y} : PlotPoint{steps.back().x, at.y});
            steps.push_back(at);
        }
        const Message name{lossless ? CULLSCOPE_TR("front: nothing lost") : CULLSCOPE_TR("front: something lost"), {}};
        plot.lines.push_back(plainLine(wordsOf(look, name), std::move(steps),
                                       {look.style.text, 1.2, lossless ? PlotStroke::Dashed : PlotStroke::Dotted}));
    }
}

void TradePlot::addBands(LinePlot& plot, const TradeLook& look) const {
    const PlotRange x = rangeAlongX(plot), y = rangeAlongY(plot);
    if (m_up->decades) plot.bars.push_back({{}, look.style.grid, {{x.first, lowestDecade(*m_up) - 0.5, x.last, plot.y.least}}});
    if (m_across->decades)
        plot.bars.push_back({{}, look.style.grid, {{plot.x.least, y.last, lowestDecade(*m_across) - 0.5, y.first}}});
}

LinePlot TradePlot::plot(const TradeLook& look) const {
    LinePlot plot;
    plot.x = axis(*m_across, look);
    plot.y = axis(*m_up, look);
    addSweeps(plot, look);
    addFronts(plot, look);
    addPoints(plot, look);
    const PlotPen level{look.style.faint, 1.0, PlotStroke::Dashed};
    const PlotRange x = rangeAlongX(plot), y = rangeAlongY(plot);
    if (m_across->ofRatio) plot.lines.insert(plot.lines.begin(), plainLine({}, {{1.0, y.first}, {1.0, y.last}}, level));
    if (m_up->ofRatio) plot.lines.insert(plot.lines.begin(), plainLine({}, {{x.first, 1.0}, {x.last, 1.0}}, level));
    addBands(plot, look);
    return plot;
}

std::string tradeValueText(const TradePoint& point, const TradeFigure& figure, const TradeLook& look) {
    const RatioEstimate* const value = point.value(figure);
    if (value == nullptr) return "–";
    if (value->ratio == 0.0 && figure.ofLoss) return zeroText(point, look);
    const auto number = [&](double one) { return fmt::format("{:.{}f}", one * figure.scale, figure.decimals); };
    if (!value->hasInterval) return number(value->ratio);
    return fmt::format("{} [{}, {}]", number(value->ratio), number(value->ci95[0]), number(value->ci95[1]));
}

}  // namespace cullscope
