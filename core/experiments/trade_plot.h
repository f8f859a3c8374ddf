#pragma once

#include <functional>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/experiments/result_table.h"
#include "core/image/plot_drawing.h"
#include "core/visibility/strategy.h"

namespace cullscope {

/// A figure of a run that may be an axis of the plot of what one thing costs in another.
struct TradeFigure {
    std::string key;        ///< of the cells of a run (rowCells), as in files
    std::string title;      ///< English, marked for translation
    double scale = 1.0;     ///< of what the axis shows
    int decimals = 0;       ///< of what words show
    bool least = false;     ///< less is better
    bool decades = false;   ///< by powers of ten, with zero on a band of its own
    bool ofLoss = false;    ///< zero says that no view lost anything: "0 (< 3/n)"
    bool ofRatio = false;   ///< 1 is a baseline's
    std::string meaning{};  ///< FieldFigure::meaning, of the field's figures
    std::string brief{};    ///< the title where there is little room, marked for translation; empty: the title
};
[[nodiscard]] const std::vector<TradeFigure>& tradeFigures();
/// Throws Error(Usage) naming the known keys where there is no such figure.
[[nodiscard]] const TradeFigure& tradeFigure(std::string_view key);
/// The axes that are shown unasked: ratio to the baseline that draws the same sides, and missed of the covered pixels.
inline constexpr const char* kUsualAcross = "ratio_to_same_sides";
inline constexpr const char* kUsualUp = "lost_pixel_rate";

/// A strategy with its parameters as a point.
struct TradePoint {
    std::string name;   ///< in the legend, and in full
    std::string label;  ///< beside it
    std::string sweep;  ///< its name, of points that are joined by a line in their order; empty: of none
    Promise promise = Promise::Approximate;
    BaselineRole role = BaselineRole::None;
    size_t views = 0;                               ///< judged, if it was
    bool judged = true;                             ///< its loss was counted; false: a loss of 0 is what it promises
    std::map<std::string, RatioEstimate> values{};  ///< by key of a figure; what was not measured is missing

    /// Its number for a figure; none where it was not measured.
    [[nodiscard]] const RatioEstimate* value(const TradeFigure& figure) const;
    /// Whether it was judged and lost nothing in any view.
    [[nodiscard]] bool lossless() const;
};
/// Points that are joined by a line, in its order.
struct TradeSweep {
    std::string name;
    std::vector<size_t> points;
};
/// The figures among the cells of a run.
[[nodiscard]] std::map<std::string, RatioEstimate> tradeValues(const Row& cells);
/// The rows of a sweep's table (sweepExperiment).
[[nodiscard]] std::vector<TradePoint> tradePoints(const ResultTable& table);

/// The points as CSV: name, promise, views, and every figure that one of them has, with its interval.
[[nodiscard]] std::string tradeCsv(const std::vector<TradePoint>& points);

/// The points that no other one surpasses in one figure without being behind in the other, by the first figure ascending: of
/// those that lost nothing, or of the others. Points without both numbers, and the limit of culling, are on none.
[[nodiscard]] std::vector<size_t> paretoFront(std::span<const TradePoint> points, const TradeFigure& across,
                                              const TradeFigure& up, bool lossless);

/// Colours, and words in the reader's language.
struct TradeLook {
    PlotStyle style{};
    PlotColour darkBaseline = 0xFF777777, lightBaseline = 0xFFFFFFFF;
    std::function<std::string(const Message& english)> words{};  ///< empty: English
    std::function<std::string(double decade)> decade{};          ///< a power of ten at a tick; empty: plotNumber
};

/// The plot of two figures. Points have the shape of their promise, their intervals along both axes, and their labels; sweeps
/// are lines; the fronts of lossless and lossy points are stepped lines.
class TradePlot {
public:
    /// `sweeps`: of these points, which may lie on several; empty: those that the points name.
    TradePlot(std::vector<TradePoint> points, const TradeFigure& across, const TradeFigure& up,
              std::vector<TradeSweep> sweeps = {});

    [[nodiscard]] const std::vector<TradePoint>& points() const { return m_points; }  ///< those that have a place
    [[nodiscard]] const TradeFigure& across() const { return *m_across; }
    [[nodiscard]] const TradeFigure& up() const { return *m_up; }
    [[nodiscard]] bool empty() const { return m_points.empty(); }
    /// Where a point stands on the plot's axes.
    [[nodiscard]] PlotPoint place(const TradePoint& point) const;
    /// Where a value stands on an axis: that of a figure by decades, its power of ten, or one below the lowest for zero.
    [[nodiscard]] double along(const TradeFigure& figure, double value) const;
    /// The lower end of a figure's decades, as a power of ten.
    [[nodiscard]] int lowestDecade(const TradeFigure& figure) const;
    /// "0 (< 3/16)": nothing lost in 16 views; "0" of a figure that is no loss, and where this holds of points for different
    /// numbers of views: they say it themselves.
    [[nodiscard]] std::string zeroLabel(const TradeFigure& figure, const TradeLook& look = {}) const;
    [[nodiscard]] LinePlot plot(const TradeLook& look) const;

private:
    [[nodiscard]] int highestDecade(const TradeFigure& figure) const;
    /// Whether the points at 0 of a loss were judged at different numbers of views, or not.
    [[nodiscard]] bool zerosDiffer(const TradeFigure& figure) const;
    /// A name, and what a loss of 0 says of the point where the axis does not.
    [[nodiscard]] std::string withZero(const TradePoint& point, const std::string& name, const TradeLook& look) const;
    [[nodiscard]] PlotAxis axis(const TradeFigure& figure, const TradeLook& look) const;
    /// The first sweep that a point lies on; as many as there are where it is on none.
    [[nodiscard]] size_t sweepOf(size_t point) const;
    void addSweeps(LinePlot& plot, const TradeLook& look) const;
    void addPoints(LinePlot& plot, const TradeLook& look) const;
    void addFronts(LinePlot& plot, const TradeLook& look) const;
    void addBands(LinePlot& plot, const TradeLook& look) const;

    std::vector<TradePoint> m_points;
    std::vector<TradeSweep> m_sweeps;
    const TradeFigure *m_across, *m_up;
};

/// The value of a point in words: "1.90 [1.70, 2.10]", "0 (< 3/16)".
[[nodiscard]] std::string tradeValueText(const TradePoint& point, const TradeFigure& figure, const TradeLook& look = {});

}  // namespace cullscope
