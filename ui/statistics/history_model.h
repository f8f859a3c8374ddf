#pragma once

#include <QAbstractTableModel>
#include <QDateTime>
#include <vector>

#include "ui/statistics/result_table_model.h"

namespace cullscope::ui {

/// An experiment that was measured, in this session or an earlier one.
struct PastExperiment {
    QString scene;  ///< its name
    QString what;   ///< camera path and size of the pictures, as the statistics say it
    QDateTime when;
    std::vector<ResultRow> rows;
};

/// Experiments beside each other: a column each, the newest first, and a row for each strategy that one of them measured. A cell
/// has the speed against the baseline that draws the same sides, and the missed pixels of a million; empty: not measured.
class HistoryModel : public QAbstractTableModel {
    Q_OBJECT

public:
    using QAbstractTableModel::QAbstractTableModel;

    void setExperiments(std::vector<PastExperiment> experiments);
    void retranslate();

    [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
    [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

private:
    [[nodiscard]] const ResultRow* row(const QModelIndex& index) const;

    std::vector<PastExperiment> m_experiments;  ///< the newest first
    QStringList m_strategies;
};

}  // namespace cullscope::ui
