#pragma once

#include <QAbstractTableModel>

#include "core/experiments/result_table.h"

namespace cullscope::ui {

/// A paper's table beside the measured one, one row per strategy and setting, with numbers in the user's locale.
class PaperTableModel : public QAbstractTableModel {
    Q_OBJECT

public:
    using QAbstractTableModel::QAbstractTableModel;

    void setTable(const ResultTable& table);
    [[nodiscard]] const ResultTable& table() const { return m_table; }

    [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
    [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

private:
    ResultTable m_table;
};

}  // namespace cullscope::ui
