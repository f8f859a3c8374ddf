#pragma once

#include "ui/statistics/pose_plot.h"

namespace cullscope::ui {

/// A column a pose: above, how long a frame takes there; below, how much is missed, logarithmically, nothing clearly apart.
class PoseStrip : public PosePlot {
    Q_OBJECT

public:
    using PosePlot::PosePlot;

    void paintPlot(QPainter& painter, const QRectF& place, const QPalette& palette) const override;
    [[nodiscard]] int neededHeight(int width) const override;

protected:
    [[nodiscard]] QString subject() const override;
    [[nodiscard]] int poseAt(const QPointF& place) const override;

private:
    struct Areas {
        QRectF times;    ///< columns upwards from its lower edge
        QRectF losses;   ///< columns downwards from its upper edge
        QRectF labels;   ///< left of both
        QRectF numbers;  ///< below both
    };
    [[nodiscard]] Areas areas(const QFontMetricsF& metrics, const QRectF& place) const;
    [[nodiscard]] QRectF column(const QRectF& area, size_t pose) const;
    [[nodiscard]] double longestFrame() const;
    void paintLabels(QPainter& painter, const Areas& areas, const PlotColours& colours) const;
    void paintNumbers(QPainter& painter, const Areas& areas, const PlotColours& colours) const;
    void paintLoss(QPainter& painter, const QRectF& column, const PoseFigures& pose, const PlotColours& colours) const;
};

}  // namespace cullscope::ui
