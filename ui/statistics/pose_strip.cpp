#include "ui/statistics/pose_strip.h"

#include <QLocale>
#include <algorithm>

#include "ui/text/wording.h"

namespace cullscope::ui {

namespace {

// Upwards, in shares of the longest frame.
constexpr double kLowest = -0.55;
constexpr double kLargestLoss = -0.5;
constexpr double kRing = -0.12;
constexpr double kRingSize = 6.0;      // pixels
constexpr double kWidestColumn = 0.4;  // of the plot's height

constexpr double kWholeLoss = 100'000.0;  // parts per million: the end of lossShare's scale

/// A loss in parts per million as a share: "0.001 %".
QString lossTick(double ppm) { return QLocale().toString(ppm / 1e4, 'g', 3) + QStringLiteral(" %"); }

PlotBox column(const PoseFigures& pose, double top, double bottom) {
    return {double(pose.pose) - 0.5, top, double(pose.pose) + 0.5, bottom};
}

}  // namespace

QString PoseStrip::subject() const { return tr("Time and loss by pose"); }

int PoseStrip::poseAt(const QPointF& place) const {
    const PlotBox area = drawing().places.front().box;
    if (!area.contains({place.x(), place.y()})) return -1;
    const auto pose = size_t((place.x() - area.left) / (area.right - area.left) * double(poseCount()));
    const auto found = std::find_if(run().poses.begin(), run().poses.end(), [&](const PoseFigures& p) { return p.pose == pose; });
    return found == run().poses.end() ? -1 : int(found - run().poses.begin());
}

std::vector<LinePlot> PoseStrip::plots(const QPalette& palette) const {
    const PlotColours colours(palette);
    double longest = 0.0;
    for (const PoseFigures& pose : run().poses) longest = std::max(longest, pose.frameMilliseconds);
    LinePlot plot;
    plot.widest = kWidestColumn * double(poseCount());
    plot.x = {{}, PlotScale::Linear, -0.5, double(poseCount()) - 0.5, false, true};
    plot.y = {title().toStdString(), PlotScale::Linear, kLowest, 1.0};
    plot.y.ticks = {{1.0, millisecondsText(longest).toStdString()}, {0.5, tr("frame").toStdString()}};
    // The scale of losses is logarithmic: its ticks are decades, so that a column's length can be read. Where there is room for
    // few of them, its ends come first.
    for (const double ppm : {kWholeLoss, 10.0, 1'000.0})
        plot.y.ticks.push_back(
            {kLargestLoss * lossShare(ppm), tr("missed %1", "a loss in parts per million").arg(lossTick(ppm)).toStdString()});
    PlotBars times{{}, colours.draw.rgba(), {}}, losses{{}, colours.loss.rgba(), {}};
    for (const PoseFigures& pose : run().poses) {
        times.boxes.push_back(column(pose, pose.frameMilliseconds / longest, 0.0));
        if (!pose.missedPpm) continue;
        // Nothing missed is a ring of its own, not a short bar.
        if (pose.missedPixels == 0)
            plot.marks.push_back(
                {{}, {double(pose.pose), kRing}, PlotShape::Disc, {colours.noLoss.rgba(), 1.2}, 0, {}, kRingSize});
        else
            losses.boxes.push_back(column(pose, 0.0, kLargestLoss * lossShare(*pose.missedPpm)));
    }
    plot.bars = {std::move(times), std::move(losses)};
    if (current() >= 0) {
        const PlotBox box = column(run().poses[size_t(current())], 1.0, kLowest);
        plot.lines = {plainLine(
            {},
            {{box.left, box.bottom}, {box.left, box.top}, {box.right, box.top}, {box.right, box.bottom}, {box.left, box.bottom}},
            {colours.chosen.rgba(), 2.0})};
    }
    return {std::move(plot)};
}

}  // namespace cullscope::ui
