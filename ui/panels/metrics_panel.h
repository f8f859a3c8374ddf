#pragma once

#include <QLabel>
#include <QTableView>

#include "ui/models/metrics_model.h"
#include "ui/session/session.h"

namespace cullscope::ui {

/// A table of the metrics of the shown views, with all rows visible; below it a note if OpenGL is rendered by the CPU.
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
    /// Gives all columns the same width if the contents fit, else each the width of its contents, with a scroll bar.
    void fitColumns();

    Session& m_session;
    MetricsModel* m_model;
    QTableView* m_table;
    QLabel* m_software;
};

}  // namespace cullscope::ui
