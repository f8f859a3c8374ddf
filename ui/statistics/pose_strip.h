#pragma once

#include "ui/statistics/pose_plot.h"

namespace cullscope::ui {

/// A column a pose: above, how long a frame takes there; below, how much is missed, logarithmically, nothing clearly apart.
class PoseStrip : public PosePlot {
    Q_OBJECT

public:
    using PosePlot::PosePlot;

    [[nodiscard]] std::vector<LinePlot> plots(const QPalette& palette) const override;

protected:
    [[nodiscard]] QString subject() const override;
    [[nodiscard]] int poseAt(const QPointF& place) const override;
};

}  // namespace cullscope::ui
