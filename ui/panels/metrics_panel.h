#pragma once

#include <QLabel>
#include <QTableView>

#include "ui/models/metrics_model.h"
#include "ui/session/session.h"

namespace cullscope::ui {

/// The figures of the shown views beside each other, all rows at once; below them, where the processor draws, that it does.
class MetricsPanel : public QWidget {
    Q_OBJECT

public:
    explicit MetricsPanel(Session& session, QWidget* parent = nullptr);

    [[nodiscard]] QTableView& table() { return *m_table; }

protected:
    void changeEvent(QEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void setUpTable();
    void setColours();
    void refresh();
    /// Columns of one width where all contents fit so, else each as wide as its contents, to be scrolled.
    void fitColumns();

    Session& m_session;
    MetricsModel* m_model;
    QTableView* m_table;
    QLabel* m_software;
};

}  // namespace cullscope::ui
