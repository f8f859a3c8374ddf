#pragma once

#include <QDialog>
#include <QTableWidget>

#include "core/experiments/store/comparison.h"
#include "ui/plots/line_plot_widget.h"

namespace cullscope::ui {

/// Two measurements of a store beside each other: of each strategy that both have, how many times as fast the later one is, with
/// its interval, and what either lost; and the times of its frames by pose.
class ComparisonDialog : public QDialog {
    Q_OBJECT

public:
    /// Throws what store::compared throws.
    ComparisonDialog(const store::Stored& a, const store::Stored& b, QWidget* parent = nullptr);

    [[nodiscard]] QTableWidget& table() { return *m_table; }
    [[nodiscard]] LinePlotWidget& plot() { return *m_plot; }

private:
    void fill();
    void showPlot(int row);

    store::Stored m_a, m_b;
    std::vector<store::Compared> m_compared;
    QTableWidget* m_table;
    LinePlotWidget* m_plot;
};

}  // namespace cullscope::ui
