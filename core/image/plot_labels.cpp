#include "core/image/plot_labels.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace cullscope {
namespace {

constexpr double kGap = 2.0;
constexpr int kMostRows = 8;  // that words may be away from their point
// How far to the side, pixels, that they may be moved.
constexpr std::array kAside{0.0, 14.0, -14.0, 28.0, -28.0, 42.0, -42.0};

bool overlap(const PlotBox& a, const PlotBox& b) {
    return a.left < b.right && b.left < a.right && a.top < b.bottom && b.top < a.bottom;
}

/// Words so many rows above the point, below where negative, and so many pixels aside; moved sideways into the bounds.
PlotBox placeAt(const PlotPoint& point, double width, double height, int row, double aside, const PlotBox& bounds,
                double marker) {
    const double away = marker / 2 + kGap + (std::abs(row) - 1) * height;
    const double top = row > 0 ? point.y - away - height : point.y + away;
    const double left = std::max(bounds.left, std::min(point.x + aside - width / 2, bounds.right - width));
    return {left, top, left + width, top + height};
}

}  // namespace

std::vector<PlotBox> placeLabels(const std::vector<PointLabel>& labels, const PlotStyle& style, const PlotBox& bounds,
                                 double marker) {
    std::vector<PlotBox> taken;
    const double half = marker / 2;
    for (const auto& [point, words] : labels) taken.push_back({point.x - half, point.y - half, point.x + half, point.y + half});
    std::vector<PlotBox> places;
    for (const PointLabel& label : labels) {
        const double width = style.width(label.words) + kGap;
        const auto isFree = [&](const PlotBox& place) {
            return place.top >= bounds.top && place.bottom <= bounds.bottom &&
                   std::none_of(taken.begin(), taken.end(), [&](const PlotBox& other) { return overlap(other, place); });
        };
        const auto freePlace = [&] {
            for (int distance = 1; distance <= kMostRows; ++distance)
                for (const double aside : kAside)
                    for (const int row : {distance, -distance})
                        if (const PlotBox place = placeAt(label.point, width, style.height, row, aside, bounds, marker);
                            isFree(place))
                            return place;
            return placeAt(label.point, width, style.height, 1, 0.0, bounds, marker);
        };
        const PlotBox place = freePlace();
        taken.push_back(place);
        places.push_back(place);
    }
    return places;
}

void drawLabels(PlotDrawing& drawing, const std::vector<PointLabel>& labels, const PlotStyle& style, const PlotBox& bounds,
                double marker) {
    const std::vector<PlotBox> places = placeLabels(labels, style, bounds, marker);
    for (size_t i = 0; i < labels.size(); ++i) {
        const PlotPoint& point = labels[i].point;
        const PlotBox& place = places[i];
        const PlotPoint nearest{std::clamp(point.x, place.left, place.right), point.y > place.bottom ? place.bottom : place.top};
        if (std::hypot(nearest.x - point.x, nearest.y - point.y) > marker)
            drawing.items.push_back(DrawnPath{{point, nearest}, {style.text, 0.6}});
        drawing.items.push_back(DrawnText{
            {(place.left + place.right) / 2, place.top + style.ascent}, labels[i].words, style.text, TextAnchor::Middle});
    }
}

}  // namespace cullscope
