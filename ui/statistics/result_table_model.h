#pragma once

#include <QAbstractTableModel>
#include <vector>

#include "ui/statistics/result_rows.h"

namespace cullscope::ui {

/// One row per strategy: its speed and its losses, and behind them the field's figures.
class ResultTableModel : public QAbstractTableModel {
    Q_OBJECT

public:
    enum Column {
        Name,
        Speedup,
        Headroom,
        SpeedupOverTriangles,
        Fps,
        FpsRange,
        CullShare,
        Submitted,
        Missed,
        Snapped,
        MissedPpm,
        Worst,
        FirstFigure  ///< of the field's, in their order, without the one that MissedPpm shows
    };
    /// How many, figures included.
    [[nodiscard]] static int columns();
    /// The number of the worst pose as an int, if there is one.
    static constexpr int kPoseRole = Qt::UserRole;

    using QAbstractTableModel::QAbstractTableModel;

    void setRows(std::vector<ResultRow> rows);
    [[nodiscard]] const std::vector<ResultRow>& rows() const { return m_rows; }

    [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override {
        return parent.isValid() ? 0 : int(m_rows.size());
    }
    [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const override { return parent.isValid() ? 0 : columns(); }
    [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
    [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation, int role) const override;
    void retranslate();

    /// The name of a column in settings, the same in every language.
    [[nodiscard]] static QString id(int column);
    [[nodiscard]] static QString title(int column);
    [[nodiscard]] static QString value(const ResultRow& row, int column);

private:
    /// Missed pixels of a million; of n views that lost nothing "0 (< 3/n)".
    [[nodiscard]] static QString missedRateText(const ResultRow& row);
    [[nodiscard]] static QString explanation(int column);
    [[nodiscard]] static QString rowExplanation(const ResultRow& row, int column);

    std::vector<ResultRow> m_rows;
};

}  // namespace cullscope::ui
