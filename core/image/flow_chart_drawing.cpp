#include "core/image/flow_chart_drawing.h"

#include <algorithm>

namespace cullscope {
namespace {

constexpr double kMargin = 6.0, kPadding = 8.0;
constexpr double kGapShare = 0.14;  ///< of a column, between two boxes
constexpr double kRowGap = 26.0;    ///< between two rows, for arrows and their words
constexpr double kPartGap = 8.0;    ///< besides, around the words of a part that begins there
constexpr double kHead = 7.0;       ///< of an arrow
constexpr double kSlope = 16.0;     ///< by how much a question's sides stand out
constexpr double kLitWidth = 3.0, kWayWidth = 2.5;

class ChartDrawer {
public:
    ChartDrawer(const FlowChart& chart, uint8_t line, double width, const PlotStyle& style, const FlowColours& colours,
                const std::function<std::string(const std::string&)>& say, const FlowWay& way)
        : m_chart(chart), m_line(line), m_width(width), m_style(style), m_colours(colours), m_say(say), m_way(way) {
        double columns = 1.0;
        for (const FlowBox& box : chart.boxes) {
            columns = std::max(columns, box.column + 1.0);
            m_rows = std::max(m_rows, size_t(box.row) + 1);
        }
        m_column = (width - 2 * kMargin) / columns;
        m_box = m_column * (1.0 - kGapShare);
        for (const FlowBox& box : chart.boxes) m_words.push_back(linesOf(say(box.text), m_box - 2 * kPadding, style));
        m_tops.assign(m_rows + 1, kMargin);
        for (size_t row = 0; row < m_rows; ++row) {
            m_tops[row] += roomAbove(row);
            m_tops[row + 1] = m_tops[row] + heightOf(row) + kRowGap;
        }
    }

    [[nodiscard]] double height() const { return m_tops.back() - kRowGap + kMargin; }

    [[nodiscard]] PlotDrawing draw() {
        for (const FlowPart& part : m_chart.parts) draw(part);
        // The way lies over arrows that were not passed.
        for (const bool passed : {false, true})
            for (size_t i = 0; i < m_chart.arrows.size(); ++i)
                if (m_way.passesArrow(i) == passed) draw(m_chart.arrows[i], passed);
        for (size_t i = 0; i < m_chart.boxes.size(); ++i) draw(m_chart.boxes[i], m_words[i], m_way.passesBox(i));
        return std::move(m_drawing);
    }

private:
    [[nodiscard]] double heightOf(size_t row) const {
        size_t lines = 1;
        for (size_t i = 0; i < m_chart.boxes.size(); ++i)
            if (size_t(m_chart.boxes[i].row) == row) lines = std::max(lines, m_words[i].size());
        return double(lines) * m_style.height + 2 * kPadding;
    }

    [[nodiscard]] std::vector<std::string> linesOfPart(const FlowPart& part) const {
        return linesOf(m_say(part.words), m_box, m_style);
    }
    /// Above a row with which another part begins: for a line across and its words. The first part has them beside its boxes.
    [[nodiscard]] double roomAbove(size_t row) const {
        for (const FlowPart& part : m_chart.parts)
            if (part.row == row && row > 0) return double(linesOfPart(part).size()) * m_style.height + kPartGap;
        return 0.0;
    }
    /// A line across between two parts, and below it when its boxes happen, in the left column.
    void draw(const FlowPart& part) {
        const double across = m_tops[part.row] - roomAbove(part.row) - kRowGap / 2;
        if (part.row > 0) path({{kMargin, across}, {m_width - kMargin, across}}, {m_style.grid, 1.0, PlotStroke::Dashed});
        double baseline = (part.row > 0 ? across + kPartGap / 2 : m_tops[0]) + m_style.ascent;
        for (const std::string& line : linesOfPart(part)) {
            m_drawing.items.emplace_back(DrawnText{{kMargin, baseline}, line, m_style.faint, TextAnchor::Start, true});
            baseline += m_style.height;
        }
    }

    [[nodiscard]] PlotBox placeOf(const FlowBox& box) const {
        const double left = kMargin + box.column * m_column + (m_column - m_box) / 2, top = m_tops[size_t(box.row)];
        return {left, top, left + m_box, top + heightOf(size_t(box.row))};
    }

    void path(std::vector<PlotPoint> points, const PlotPen& pen, PlotColour fill = 0) {
        m_drawing.items.emplace_back(DrawnPath{std::move(points), pen, fill});
    }

    void draw(const FlowBox& box, const std::vector<std::string>& words, bool passed) {
        const PlotBox place = placeOf(box);
        const bool lit = m_line > 0 && std::ranges::find(box.lines, m_line) != box.lines.end();
        const PlotPen pen = lit      ? PlotPen{m_colours.litText, kLitWidth}
                            : passed ? PlotPen{m_colours.way, kWayWidth}
                                     : PlotPen{m_colours.line, 1.0};
        const PlotColour text = lit ? m_colours.litText : passed ? m_colours.passedText : m_style.text;
        const PlotColour fill = lit                                    ? m_colours.lit
                                : passed                               ? m_colours.passed
                                : box.kind == FlowBox::Kind::Structure ? m_colours.structure
                                                                       : 0;
        const double middle = (place.top + place.bottom) / 2;
        if (box.kind == FlowBox::Kind::Question)
            path({{place.left - kSlope / 2, middle},
                  {place.left + kSlope / 2, place.top},
                  {place.right - kSlope / 2, place.top},
                  {place.right + kSlope / 2, middle},
                  {place.right - kSlope / 2, place.bottom},
                  {place.left + kSlope / 2, place.bottom},
                  {place.left - kSlope / 2, middle}},
                 pen, fill);
        else
            path({{place.left, place.top},
                  {place.right, place.top},
                  {place.right, place.bottom},
                  {place.left, place.bottom},
                  {place.left, place.top}},
                 pen, fill);
        double baseline = middle - double(words.size()) * m_style.height / 2 + m_style.ascent;
        for (const std::string& line : words) {
            m_drawing.items.emplace_back(DrawnText{{(place.left + place.right) / 2, baseline}, line, text, TextAnchor::Middle});
            baseline += m_style.height;
        }
    }

    void draw(const FlowArrow& arrow, bool passed) {
        const FlowBox &from = m_chart.boxes[arrow.from], &to = m_chart.boxes[arrow.to];
        const PlotBox a = placeOf(from), b = placeOf(to);
        const PlotPoint middleOfA{(a.left + a.right) / 2, (a.top + a.bottom) / 2},
            middleOfB{(b.left + b.right) / 2, (b.top + b.bottom) / 2};
        const double side = middleOfB.x < middleOfA.x ? -1.0 : 1.0;
        const double edge = side < 0.0 ? a.left : a.right;
        const double stand = from.kind == FlowBox::Kind::Question ? side * kSlope / 2 : 0.0;
        std::vector<PlotPoint> points;
        if (arrow.way == FlowArrow::Way::Across && from.kind == FlowBox::Kind::Question)
            points = {{edge + stand, middleOfA.y}, {middleOfB.x, middleOfA.y}, {middleOfB.x, b.top}};
        else if (arrow.way == FlowArrow::Way::Across)
            points = {{middleOfA.x, a.bottom}, {middleOfA.x, middleOfB.y}, {side < 0.0 ? b.right : b.left, middleOfB.y}};
        else if (from.row == to.row)
            points = {{edge + stand, middleOfA.y}, {side < 0.0 ? b.right : b.left, middleOfB.y}};
        else
            points = {{middleOfA.x, a.bottom}, {middleOfB.x, b.top}};
        const PlotColour colour = passed ? m_colours.way : m_colours.line;
        path(points, {colour, passed ? kWayWidth : 1.2});
        addHead(points[points.size() - 2], points.back(), colour);
        if (!arrow.words.empty()) addWords(arrow, points);
    }

    void addHead(const PlotPoint& from, const PlotPoint& tip, PlotColour colour) {
        const double dx = tip.x > from.x   ? 1.0
                          : tip.x < from.x ? -1.0
                                           : 0.0,
                     dy = tip.y > from.y   ? 1.0
                          : tip.y < from.y ? -1.0
                                           : 0.0;
        path({tip,
              {tip.x - kHead * dx - kHead / 2 * dy, tip.y - kHead * dy - kHead / 2 * dx},
              {tip.x - kHead * dx + kHead / 2 * dy, tip.y - kHead * dy + kHead / 2 * dx},
              tip},
             {}, colour);
    }

    /// Beside an arrow that goes down, above a box to the side, above an arrow that goes across.
    void addWords(const FlowArrow& arrow, const std::vector<PlotPoint>& points) {
        const bool down = points[0].x == points[1].x, left = points[1].x < points[0].x;
        PlotPoint at{points[0].x + (left ? -4.0 : 4.0), points[0].y - 4.0};
        if (down) at = {points[0].x + 6.0, points[0].y + kRowGap / 2 + m_style.ascent / 2 - 1.0};
        if (!down && arrow.way == FlowArrow::Way::Straight) at = {points[1].x, placeOf(m_chart.boxes[arrow.to]).top - 4.0};
        m_drawing.items.emplace_back(
            DrawnText{at, m_say(arrow.words), m_style.text, left && !down ? TextAnchor::End : TextAnchor::Start});
    }

    const FlowChart& m_chart;
    uint8_t m_line;
    double m_width;
    const PlotStyle& m_style;
    const FlowColours& m_colours;
    const std::function<std::string(const std::string&)>& m_say;
    const FlowWay& m_way;
    double m_column = 0.0, m_box = 0.0;
    size_t m_rows = 1;
    std::vector<double> m_tops;
    std::vector<std::vector<std::string>> m_words;
    PlotDrawing m_drawing;
};

}  // namespace

PlotDrawing drawFlowChart(const FlowChart& chart, uint8_t line, double width, double& height, const PlotStyle& style,
                          const FlowColours& colours, const std::function<std::string(const std::string& text)>& say,
                          const FlowWay& way) {
    ChartDrawer drawer(chart, line, width, style, colours, say, way);
    height = drawer.height();
    return drawer.draw();
}

}  // namespace cullscope
