#include "ui/statistics/sphere_map.h"

#include <algorithm>
#include <cmath>

namespace cullscope::ui {

namespace {

constexpr double kLeast = 8.0;
constexpr double kLargest = 16.0;
constexpr double kReachOfDot = 12.0;  // how far from a dot a click still counts
constexpr double kWidest = 3.0;       // times the height

/// A ring where nothing is missed, else a disc, larger where more is.
PlotMark dot(const QString& name, const PlotPoint& at, const std::optional<double>& missedPpm, const PlotColours& colours) {
    const double share = missedPpm ? lossShare(*missedPpm) : 0.0;
    const bool loses = share > 0.0;
    const PlotPen outline{(loses ? colours.ground : colours.noLoss).rgba(), loses ? 1.0 : 1.6};
    return {name.toStdString(),
            at,
            PlotShape::Disc,
            outline,
            loses ? colours.loss.rgba() : 0,
            {},
            kLeast + (kLargest - kLeast) * share};
}

PlotAxis degreesUpTo(int most) {
    PlotAxis axis{{}, PlotScale::Linear, double(-most), double(most)};
    for (int angle = -most; angle <= most; angle += 90)
        axis.ticks.push_back({double(angle), (angle < 0 ? "−" : "") + std::to_string(std::abs(angle)) + "°"});
    return axis;
}

}  // namespace

QString SphereMap::subject() const { return tr("Loss by direction of view"); }

int SphereMap::poseAt(const QPointF& place) const {
    const PlotPlace map = drawing().places.front();
    int nearest = -1;
    double least = kReachOfDot;
    for (size_t i = 0; i < run().poses.size(); ++i) {
        const PlotPoint dot = map.pixel({run().poses[i].azimuth, run().poses[i].elevation});
        const double distance = std::hypot(dot.x - place.x(), dot.y - place.y());
        if (distance > least) continue;
        least = distance;
        nearest = int(i);
    }
    return nearest;
}

std::vector<LinePlot> SphereMap::plots(const QPalette& palette) const {
    const PlotColours colours(palette);
    LinePlot plot;
    plot.x = degreesUpTo(180);
    plot.y = degreesUpTo(90);
    plot.y.title = title().toStdString();
    plot.widest = kWidest;
    for (const auto& [ppm, words] : {std::pair(0.0, tr("nothing missed")), std::pair(10.0, tr("%1 per million").arg(10)),
                                     std::pair(1000.0, tr("%1 per million").arg(1000)), std::pair(1e5, tr("a tenth"))})
        plot.marks.push_back(dot(words, kNoPlace, ppm, colours));
    // The worst last, so that nothing lies over it.
    std::vector<const PoseFigures*> order;
    for (const PoseFigures& pose : run().poses) order.push_back(&pose);
    std::stable_sort(order.begin(), order.end(),
                     [](const PoseFigures* a, const PoseFigures* b) { return a->missedPixels < b->missedPixels; });
    for (const PoseFigures* pose : order)
        plot.marks.push_back(dot({}, {pose->azimuth, pose->elevation}, pose->missedPpm, colours));
    if (current() >= 0) {
        const PoseFigures& chosen = run().poses[size_t(current())];
        plot.marks.push_back({{},
                              {chosen.azimuth, chosen.elevation},
                              PlotShape::Disc,
                              {colours.chosen.rgba(), 2.0},
                              0,
                              {},
                              2.0 * (kReachOfDot - 1.0)});
    }
    return {std::move(plot)};
}

}  // namespace cullscope::ui
