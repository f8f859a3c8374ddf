#include "core/image/plot_drawing.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/gpu/colour.h"
#include "core/image/plot_labels.h"
#include "core/image/plot_legend.h"

namespace cullscope {
namespace {

constexpr double kPlotMargin = 4.0;
constexpr double kTickGap = 5.0;        // between an axis and its numbers
constexpr double kNumberGap = 12.0;     // at least, between two numbers along x
constexpr double kNumberLeading = 1.3;  // of their height, between two numbers along y
constexpr double kBehind = 6.0;         // between a level and its number
constexpr double kLeastHeight = 80.0;   // between the axes
constexpr double kBesideFrom = 560.0;   // width of two plots
constexpr double kBold = 1.15;          // how much wider bold letters are, at most
constexpr double kMark = 11.0;
constexpr double kDot = 2.5;
constexpr double kGapFrom = 4.0;  // width of a bar
constexpr size_t kMostDots = 60;

// After Okabe and Ito, darkened or lightened for the contrast; the sixth is a grey, as their second blue is too near the first.
constexpr std::array<PlotColour, 8> kOnLight{0xFF0072B2, 0xFFC44E00, 0xFF00805A, 0xFFA8447E,
                                             0xFF7A5C00, 0xFF55606A, 0xFF5B3FA8, 0xFF8A2B2B};
constexpr std::array<PlotColour, 8> kOnDark{0xFF56B4E9, 0xFFFF9A4D, 0xFF2BD4A4, 0xFFF0A6D0,
                                            0xFFF0E442, 0xFFC8CCD0, 0xFFB79CFF, 0xFFFF8A8A};

/// Black or white letters, whichever contrasts more with a ground.
PlotColour lettersOn(PlotColour ground) { return isLight(colourFromHexadecimal(ground & 0xFFFFFF)) ? 0xFF111111 : 0xFFFFFFFF; }

/// Where a Chinese character begins, as UTF-8.
bool beginsCharacter(char byte) { return static_cast<unsigned char>(byte) >= 0xE4 && static_cast<unsigned char>(byte) <= 0xE9; }

/// What is written around a plot.
struct PlacedWords {
    std::vector<std::string> title, up, across;
    double top = 0.0;  ///< between the lines above and the plot
    double below = 0.0;

    PlacedWords(const LinePlot& plot, double width, const PlotStyle& style)
        : title(linesOf(plot.title, width / kBold, style)),
          up(linesOf(plot.y.title, width, style)),
          across(linesOf(plot.x.title, width, style)) {
        // Words without a mark stand above what they are about; else half of the uppermost number stands above the plot.
        const bool words = std::any_of(plot.marks.begin(), plot.marks.end(),
                                       [](const PlotMark& mark) { return mark.shape == PlotShape::None && !mark.label.empty(); });
        top = words ? style.height + kMark : style.height / 2 + 1.0;
        below = kTickGap + style.height * double(1 + across.size());
    }
    [[nodiscard]] double above(const PlotStyle& style) const { return style.height * double(title.size() + up.size()) + top; }
};

/// As many of an axis' ticks as there is room for.
std::vector<PlotTick> ticksOf(const PlotAxis& axis, const PlotRange& range, double room, const PlotStyle& style) {
    const auto most = size_t(std::max(2.0, room));
    if (!axis.ticks.empty()) return everyNth(axis.ticks, most);
    std::vector<PlotTick> ticks;
    for (const double value : range.fewTicks(most)) ticks.push_back({value, style.number(value)});
    return ticks;
}

/// The named ticks of an axis upwards whose labels do not overlap: of two that would, the former one. They need not lie at equal
/// distances, so that a number of them says nothing about the room.
std::vector<PlotTick> ticksApart(const std::vector<PlotTick>& named, const PlotRange& range, double length,
                                 const PlotStyle& style) {
    std::vector<PlotTick> kept;
    for (const PlotTick& tick : named) {
        const auto overlaps = [&](const PlotTick& other) {
            return std::abs(range.share(tick.value) - range.share(other.value)) * length < style.height;
        };
        if (std::ranges::none_of(kept, overlaps)) kept.push_back(tick);
    }
    return kept;
}

double widest(const std::vector<PlotTick>& ticks, const PlotStyle& style) {
    double widest = 0.0;
    for (const PlotTick& tick : ticks) widest = std::max(widest, style.width(tick.label));
    return widest;
}

/// In the middle of a pixel, so that a thin line is sharp.
double crisp(double pixel) { return std::floor(pixel) + 0.5; }

class Drawer {
public:
    Drawer(const LinePlot& plot, const PlotBox& box, const PlotStyle& style, PlotDrawing& drawing)
        : m_plot(plot), m_style(style), m_drawing(drawing), m_words(plot, box.right - box.left, style) {
        place(box);
        drawAxes(box);
        for (const PlotBars& bars : plot.bars) drawBars(bars);
        for (const PlotReference& reference : plot.references) drawReference(reference);
        for (size_t i = 0; i < plot.lines.size(); ++i) drawLine(plot.lines[i], penOf(plot.lines[i], i, style));
        drawMarks();
        drawing.places.push_back(m_place);
    }
    [[nodiscard]] double end() const { return m_place.box.right + m_beyond; }

private:
    void line(const PlotPoint& from, const PlotPoint& to, const PlotPen& pen) {
        m_drawing.items.push_back(DrawnPath{{from, to}, pen});
    }
    void text(double x, double baseline, const std::string& words, TextAnchor anchor, bool bold = false) {
        m_drawing.items.push_back(DrawnText{{x, baseline}, words, m_style.text, anchor, bold});
    }

    void place(const PlotBox& box) {
        m_place = {box, rangeAlongX(m_plot), rangeAlongY(m_plot)};
        PlotBox& inner = m_place.box;
        inner.top += m_words.above(m_style);
        inner.bottom -= m_words.below;
        const double length = inner.bottom - inner.top;
        m_up = m_plot.y.ticks.empty() ? ticksOf(m_plot.y, m_place.y, length / (kNumberLeading * m_style.height), m_style)
                                      : ticksApart(m_plot.y.ticks, m_place.y, length, m_style);
        inner.left = crisp(inner.left + widest(m_up, m_style) + kTickGap);
        const double number = widest(ticksOf(m_plot.x, m_place.x, 1e9, m_style), m_style);
        m_beyond = number / 2;
        for (const PlotReference& reference : m_plot.references)
            if (m_place.y.places(reference.y))
                m_beyond = std::max(m_beyond, kBehind + m_style.width(m_style.number(reference.y)));
        for (const PlotBars& bars : m_plot.bars)
            for (const std::string& label : bars.within ? std::vector<std::string>() : bars.labels)
                m_beyond = std::max(m_beyond, kBehind + m_style.width(label));
        inner.right -= m_beyond;
        if (m_plot.widest > 0.0) inner.right = std::min(inner.right, inner.left + m_plot.widest * (inner.bottom - inner.top));
        m_across = ticksOf(m_plot.x, m_place.x, (inner.right - inner.left) / (number + kNumberGap), m_style);
    }

    void drawAxes(const PlotBox& box) {
        const PlotBox& inner = m_place.box;
        double baseline = box.top + m_style.ascent;
        for (const auto& [lines, bold] : {std::pair(&m_words.title, true), std::pair(&m_words.up, false)})
            for (const std::string& words : *lines) {
                text(box.left, baseline, words, TextAnchor::Start, bold);
                baseline += m_style.height;
            }
        const PlotPen grid{m_style.grid};
        for (const PlotTick& tick : m_up) {
            const double y = m_place.pixel({m_place.x.first, tick.value}).y;
            line({inner.left, crisp(y)}, {inner.right, crisp(y)}, grid);
            text(inner.left - kTickGap, y + m_style.ascent - m_style.height / 2, tick.label, TextAnchor::End);
        }
        baseline = inner.bottom + kTickGap + m_style.ascent;
        for (const PlotTick& tick : m_across) {
            const double x = m_place.pixel({tick.value, m_place.y.first}).x;
            line({crisp(x), inner.top}, {crisp(x), inner.bottom}, grid);
            text(x, baseline, tick.label, TextAnchor::Middle);
        }
        for (const std::string& words : m_words.across)
            text((inner.left + inner.right) / 2, baseline += m_style.height, words, TextAnchor::Middle);
        m_drawing.items.push_back(DrawnPath{
            {{inner.left, inner.top}, {inner.left, crisp(inner.bottom)}, {inner.right, crisp(inner.bottom)}}, {m_style.faint}});
    }

    void drawBars(const PlotBars& bars) {
        for (size_t i = 0; i < bars.boxes.size(); ++i) {
            const PlotBox& box = bars.boxes[i];
            const PlotPoint low = m_place.pixel({box.left, box.bottom}), high = m_place.pixel({box.right, box.top});
            // Whole pixels, with a gap to the next one where there is room for it.
            const double gap = high.x - low.x > kGapFrom ? 1.0 : 0.0, left = std::round(low.x);
            const double right = std::max(left + 1.0, std::round(high.x) - gap);
            if (i < bars.labels.size() && !bars.within)
                text(high.x + kBehind, (low.y + high.y) / 2 + m_style.ascent - m_style.height / 2, bars.labels[i],
                     TextAnchor::Start);
            if (high.x <= low.x) continue;
            m_drawing.items.push_back(
                DrawnPath{{{left, high.y}, {right, high.y}, {right, low.y}, {left, low.y}}, {}, bars.colour});
            // Words that do not fit into their box are left out.
            if (i < bars.labels.size() && bars.within && m_style.width(bars.labels[i]) < right - left)
                m_drawing.items.push_back(
                    DrawnText{{(left + right) / 2, (low.y + high.y) / 2 + m_style.ascent - m_style.height / 2},
                              bars.labels[i],
                              lettersOn(bars.colour),
                              TextAnchor::Middle});
        }
    }

    void drawReference(const PlotReference& reference) {
        if (!m_place.y.places(reference.y)) return;
        const PlotBox& inner = m_place.box;
        const double y = m_place.pixel({m_place.x.first, reference.y}).y;
        line({inner.left, crisp(y)}, {inner.right, crisp(y)}, referencePen(m_style));
        text(inner.right + kBehind, y + m_style.ascent - m_style.height / 2, m_style.number(reference.y), TextAnchor::Start);
    }

    void drawLine(const PlotLine& line, const PlotPen& pen) {
        for (const std::vector<PlotPoint>& piece : unbrokenPieces(line, m_place.x, m_place.y)) {
            DrawnPath path{{}, pen};
            for (const PlotPoint& point : piece) path.points.push_back(m_place.pixel(point));
            // One point alone is no line.
            if (piece.size() == 1 || (line.dots && line.points.size() <= kMostDots))
                for (const PlotPoint& point : path.points) m_drawing.items.push_back(DrawnDisc{point, kDot, {}, pen.colour});
            if (piece.size() > 1) m_drawing.items.push_back(std::move(path));
        }
    }

    void drawMarks() {
        std::vector<PointLabel> labels;
        for (const PlotMark& mark : m_plot.marks) {
            if (!m_place.x.places(mark.at.x) || !m_place.y.places(mark.at.y)) continue;
            const PlotPoint at = m_place.pixel(mark.at);
            drawShape(m_drawing, mark, at);
            if (!mark.label.empty()) labels.push_back({at, mark.label});
        }
        PlotBox bounds = m_place.box;
        bounds.top -= m_words.top;
        drawLabels(m_drawing, labels, m_style, bounds, kMark);
    }

    const LinePlot& m_plot;
    const PlotStyle& m_style;
    PlotDrawing& m_drawing;
    PlacedWords m_words;
    PlotPlace m_place;
    std::vector<PlotTick> m_across, m_up;
    double m_beyond = 0.0;  ///< what stands beyond the right end: a half of the last number, or the words of levels and bars
};

}  // namespace

std::vector<std::string> linesOf(const std::string& words, double width, const PlotStyle& style) {
    std::vector<std::string> lines;
    for (size_t from = 0; from < words.size();) {
        size_t to = from + 1;
        while (to < words.size() && words[to] != ' ' && !beginsCharacter(words[to])) ++to;
        const std::string piece = words.substr(from, to - from);
        if (lines.empty() || style.width(lines.back() + piece) > width)
            lines.push_back(piece.substr(piece.front() == ' ' ? 1 : 0));
        else
            lines.back() += piece;
        from = to;
    }
    return lines;
}

void moveBy(PlotDrawing& drawing, const PlotPoint& by) {
    const auto move = [&](PlotPoint& point) { point = {point.x + by.x, point.y + by.y}; };
    for (auto& item : drawing.items) {
        if (auto* path = std::get_if<DrawnPath>(&item)) std::ranges::for_each(path->points, move);
        if (auto* disc = std::get_if<DrawnDisc>(&item)) move(disc->centre);
        if (auto* text = std::get_if<DrawnText>(&item)) move(text->at);
    }
}

void scaleBy(PlotDrawing& drawing, double scale) {
    const auto move = [&](PlotPoint& point) { point = {scale * point.x, scale * point.y}; };
    for (auto& item : drawing.items) {
        if (auto* path = std::get_if<DrawnPath>(&item)) {
            std::ranges::for_each(path->points, move);
            path->pen.width *= scale;
        }
        if (auto* disc = std::get_if<DrawnDisc>(&item)) {
            move(disc->centre);
            disc->radius *= scale;
            disc->pen.width *= scale;
        }
        if (auto* text = std::get_if<DrawnText>(&item)) move(text->at);
    }
    for (PlotPlace& place : drawing.places)
        place.box = {scale * place.box.left, scale * place.box.top, scale * place.box.right, scale * place.box.bottom};
}

PlotPoint PlotPlace::pixel(const PlotPoint& value) const {
    return {box.left + x.share(value.x) * (box.right - box.left), box.bottom - y.share(value.y) * (box.bottom - box.top)};
}

std::span<const PlotColour> plotSeries(bool dark) { return dark ? kOnDark : kOnLight; }

PlotDrawing drawPlots(const std::vector<LinePlot>& plots, double width, double height, const PlotStyle& style) {
    PlotDrawing drawing;
    PlotLegend legend(plots.front(), style);
    const PlotBox inner = legend.takeFrom({kPlotMargin, kPlotMargin, width - kPlotMargin, height - kPlotMargin});
    const bool beside = width >= kBesideFrom;
    const double across = (inner.right - inner.left) / (beside ? double(plots.size()) : 1.0);
    const double down = (inner.bottom - inner.top) / (beside ? 1.0 : double(plots.size()));
    double end = 0.0;
    for (size_t i = 0; i < plots.size(); ++i) {
        const double left = inner.left + (beside ? across * double(i) : 0.0);
        const double top = inner.top + (beside ? 0.0 : down * double(i));
        end = Drawer(plots[i], {left, top, left + across, top + down}, style, drawing).end();
    }
    legend.draw(drawing, end);
    return drawing;
}

double neededHeight(const std::vector<LinePlot>& plots, double width, const PlotStyle& style) {
    const PlotLegend legend(plots.front(), style);
    const bool beside = width >= kBesideFrom;
    const double inner = width - 2 * kPlotMargin;
    const double across = legend.widthBeside(inner) / (beside ? double(plots.size()) : 1.0);
    double most = 0.0;
    for (const LinePlot& plot : plots) {
        const PlacedWords words(plot, across, style);
        most = std::max(most, words.above(style) + kLeastHeight + words.below);
    }
    return legend.heightWith(beside ? most : most * double(plots.size()), inner) + 2 * kPlotMargin;
}

std::vector<double> dashesOf(PlotStroke stroke) {
    if (stroke == PlotStroke::Dashed) return {7.0, 4.0};
    if (stroke == PlotStroke::Dotted) return {2.0, 3.0};
    return {};
}

}  // namespace cullscope
