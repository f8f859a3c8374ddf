#pragma once

#include <QAbstractTableModel>
#include <vector>

#include "ui/jobs/view_metrics.h"

namespace cullscope::ui {

/// The metrics of the shown views: one row a metric, one column a view, "…" while a value is stale.
class MetricsModel : public QAbstractTableModel {
    Q_OBJECT

public:
    struct Column {
        int view = 0;
        ViewMetrics figures;
    };

    using QAbstractTableModel::QAbstractTableModel;

    void setColumns(std::vector<Column> columns);
    void setFigures(int view, const ViewMetrics& figures);

    [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override { return parent.isValid() ? 0 : RowCount; }
    [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const override {
        return parent.isValid() ? 0 : int(m_columns.size());
    }
    [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
    [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation, int role) const override;
    void retranslate();

private:
    enum Row {
        Speedup,
        Interval,
        Most,
        Share,
        Frame,
        Fps,
        Cull,
        Submitted,
        Visible,
        InVain,
        Missed,
        Snapped,
        Hole,
        Covered,
        RowCount
    };

    [[nodiscard]] static QString title(int row);
    [[nodiscard]] static QString explanation(int row);
    /// The same with the value's interval, where it has one.
    [[nodiscard]] static QString explanation(const ViewMetrics& figures, int row);
    [[nodiscard]] static QString value(const ViewMetrics& figures, int row);

    std::vector<Column> m_columns;
};

}  // namespace cullscope::ui
