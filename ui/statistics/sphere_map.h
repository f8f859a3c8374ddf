#pragma once

#include "ui/statistics/pose_plot.h"

namespace cullscope::ui {

/// From which directions something is missed: a dot a pose where its eye stands as seen from the scene's centre, azimuth to the
/// right, elevation upwards.
class SphereMap : public PosePlot {
    Q_OBJECT

public:
    using PosePlot::PosePlot;

    [[nodiscard]] std::vector<LinePlot> plots(const QPalette& palette) const override;

protected:
    [[nodiscard]] QString subject() const override;
    [[nodiscard]] int poseAt(const QPointF& place) const override;
};

}  // namespace cullscope::ui
