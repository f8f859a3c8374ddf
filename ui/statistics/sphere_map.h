#pragma once

#include "ui/statistics/pose_plot.h"

namespace cullscope::ui {

/// From which directions something is missed: a dot a pose where its eye stands as seen from the scene's centre, azimuth to the
/// right, elevation upwards.
class SphereMap : public PosePlot {
    Q_OBJECT

public:
    using PosePlot::PosePlot;

    void paintPlot(QPainter& painter, const QRectF& place, const QPalette& palette) const override;
    [[nodiscard]] int neededHeight(int width) const override;

protected:
    [[nodiscard]] QString subject() const override;
    [[nodiscard]] int poseAt(const QPointF& place) const override;

private:
    /// The map's rectangle, twice as wide as high, with place for the axes and the legend left around it.
    [[nodiscard]] QRectF map(const QFontMetricsF& metrics, const QRectF& place) const;
    [[nodiscard]] static QPointF dot(const QRectF& map, const PoseFigures& pose);
    void paintAxes(QPainter& painter, const QRectF& map, const PlotColours& colours) const;
    void paintLegend(QPainter& painter, const QRectF& place, const PlotColours& colours) const;
    static void paintDot(QPainter& painter, const QPointF& place, const std::optional<double>& missedPpm,
                         const PlotColours& colours);
};

}  // namespace cullscope::ui
