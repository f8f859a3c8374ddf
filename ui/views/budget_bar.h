#pragma once

#include <QWidget>
#include <array>

#include "ui/jobs/view_metrics.h"

namespace cullscope::ui {

/// Where a view's triangles went, as a bar under its picture: drawn and visible | drawn in vain | culled by cause | wrongly
/// culled, in proportion. What is wrongly culled is never narrower than 2 pixels. The numbers are in the tooltip.
class BudgetBar : public QWidget {
    Q_OBJECT

public:
    explicit BudgetBar(QWidget* parent = nullptr);

    /// While they are stale the last known ones stay, pale.
    void setFigures(const ViewMetrics& figures);
    /// Another scene: what was known is of no use any more.
    void clear();

    /// Where the segments of the states lie, in the states' order, in whole pixels from the left; they add up to the width, or
    /// are all 0 where nothing is known.
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
