#pragma once

#include <QWidget>
#include <array>

#include "ui/jobs/view_metrics.h"

namespace cullscope::ui {

/// A bar under a view's picture that divides its triangles: drawn and visible | drawn in vain | culled by cause | wrongly culled,
/// in proportion. The wrongly culled part is at least 2 pixels wide. The tooltip states the numbers.
class BudgetBar : public QWidget {
    Q_OBJECT

public:
    explicit BudgetBar(QWidget* parent = nullptr);

    /// Sets the metrics. While they are stale the last known ones stay, paled.
    void setFigures(const ViewMetrics& figures);
    /// Clears the last known metrics, as for another scene.
    void clear();

    /// The widths of the segments in the order of the states, in whole pixels. They add up to the width of the bar, or are all 0
    /// if no metrics are known.
    [[nodiscard]] std::array<int, kTriangleStateCount> widths() const;
    [[nodiscard]] bool stale() const { return m_stale; }
    [[nodiscard]] QSize sizeHint() const override { return {kTriangleStateCount * 8, kHeight}; }
    [[nodiscard]] QSize minimumSizeHint() const override { return {0, kHeight}; }

protected:
    void paintEvent(QPaintEvent* event) override;
    void changeEvent(QEvent* event) override;

private:
    static constexpr int kHeight = 12;

    void describe();

    std::array<uint64_t, kTriangleStateCount> m_counts{};
    bool m_known = false;
    bool m_stale = false;
};

}  // namespace cullscope::ui
