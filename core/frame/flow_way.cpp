#include "core/frame/flow_way.h"

#include <algorithm>
#include <functional>
#include <optional>

namespace cullscope {
namespace {

/// Marks the ways through a chart.
class WayFinder {
public:
    explicit WayFinder(const FlowChart& chart) : m_chart(chart) {
        m_way.boxes.resize(chart.boxes.size());
        m_way.arrows.resize(chart.arrows.size());
    }

    /// Goes on to the box of a listing's line.
    void passLine(uint8_t line) {
        const auto box = std::ranges::find_if(
            m_chart.boxes, [line](const FlowBox& each) { return std::ranges::find(each.lines, line) != each.lines.end(); });
        if (box == m_chart.boxes.end()) return;
        const auto wanted = size_t(box - m_chart.boxes.begin());
        if (wanted == m_here && m_way.boxes[wanted]) return;
        goOn([wanted](size_t number) { return number == wanted; });
        m_way.boxes[wanted] = true;
        m_here = wanted;
    }

    void end() {
        goOn([this](size_t number) {
            return std::ranges::none_of(m_chart.arrows, [number](const FlowArrow& arrow) { return arrow.from == number; });
        });
    }

    [[nodiscard]] FlowWay take() && { return std::move(m_way); }

private:
    /// Marks the shortest way from here to a box; nothing where there is none.
    void goOn(const std::function<bool(size_t number)>& wanted) {
        std::vector<std::optional<size_t>> arrivedBy(m_chart.boxes.size());
        std::vector<size_t> reached{m_here};
        for (size_t next = 0; next < reached.size(); ++next) {
            if (wanted(reached[next])) return mark(reached[next], arrivedBy);
            for (size_t arrow = 0; arrow < m_chart.arrows.size(); ++arrow) {
                const size_t to = m_chart.arrows[arrow].to;
                if (m_chart.arrows[arrow].from != reached[next] || std::ranges::find(reached, to) != reached.end()) continue;
                arrivedBy[to] = arrow;
                reached.push_back(to);
            }
        }
    }

    void mark(size_t box, const std::vector<std::optional<size_t>>& arrivedBy) {
        m_way.boxes[box] = true;
        for (; arrivedBy[box]; box = m_chart.arrows[*arrivedBy[box]].from) {
            m_way.arrows[*arrivedBy[box]] = true;
            m_way.boxes[m_chart.arrows[*arrivedBy[box]].from] = true;
        }
    }

    const FlowChart& m_chart;
    size_t m_here = 0;
    FlowWay m_way;
};

}  // namespace

FlowWay flowWay(const FlowChart& chart, const FrameLog& log, bool ended) {
    if (chart.empty()) return {};
    WayFinder finder(chart);
    for (const Decision& decision : log.decisions)
        if (decision.line > 0) finder.passLine(decision.line);
    if (ended) finder.end();
    return std::move(finder).take();
}

}  // namespace cullscope
