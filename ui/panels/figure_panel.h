#pragma once

#include <QTableView>

#include "ui/models/figure_model.h"
#include "ui/session/session.h"

namespace cullscope::ui {

/// The figures of the shown views beside each other.
class FigurePanel : public QTableView {
    Q_OBJECT

public:
    explicit FigurePanel(Session& session, QWidget* parent = nullptr);

protected:
    void changeEvent(QEvent* event) override;

private:
    void refresh();

    Session& m_session;
    FigureModel* m_model;
};

}  // namespace cullscope::ui
