#pragma once

#include <QLineEdit>
#include <QPushButton>
#include <QTableView>
#include <QWidget>
#include <vector>

#include "ui/statistics/history_model.h"

namespace cullscope::ui {

/// The experiments of the store beside each other, with a filter; two that are chosen can be compared, and those that are shown
/// exported.
class HistoryPanel : public QWidget {
    Q_OBJECT

public:
    explicit HistoryPanel(HistoryModel& model, QWidget* parent = nullptr);

    void retranslate();

    [[nodiscard]] QLineEdit& filter() { return *m_filter; }
    [[nodiscard]] QTableView& table() { return *m_table; }
    [[nodiscard]] QPushButton& compare() { return *m_compare; }

signals:
    /// The earlier one first.
    void compareRequested(qint64 a, qint64 b);
    void exportRequested(const std::vector<qint64>& numbers, const QString& path);

private:
    /// The chosen experiments' numbers, the earlier first; of a store alone.
    [[nodiscard]] std::vector<qint64> chosen() const;
    void refresh();
    void askWhereTo();

    HistoryModel& m_model;
    QLineEdit* m_filter;
    QPushButton* m_compare;
    QPushButton* m_export;
    QTableView* m_table;
};

}  // namespace cullscope::ui
