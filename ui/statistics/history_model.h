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
    qint64 number = 0;  ///< in the store; 0: of none
};

/// "fibonacci:16 · 320 × 240": path and size of a measurement.
[[nodiscard]] QString pathAndSize(const std::string& path, const Viewport& size);

/// Experiments beside each other: a column each, the newest first, and a row for each strategy that one of them measured. A cell
/// has the speed against the baseline that draws the same sides, and the missed pixels of a million; empty: not measured.
class HistoryModel : public QAbstractTableModel {
    Q_OBJECT

public:
    using QAbstractTableModel::QAbstractTableModel;

    void setExperiments(std::vector<PastExperiment> experiments);
    /// Only experiments with this in their scene, path, date or a strategy are shown.
    void setFilter(const QString& text);
    void retranslate();

    [[nodiscard]] qint64 number(int column) const { return m_experiments[size_t(column)].number; }

    [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
    [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

private:
    [[nodiscard]] const ResultRow* row(const QModelIndex& index) const;

    [[nodiscard]] bool shown(const PastExperiment& experiment) const;
    void show();

    std::vector<PastExperiment> m_all;          ///< the newest first
    std::vector<PastExperiment> m_experiments;  ///< those that are shown
    QString m_filter;
    QStringList m_strategies;
};

}  // namespace cullscope::ui
