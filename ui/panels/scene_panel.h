#pragma once

#include <QLabel>
#include <QListView>
#include <QTableView>
#include <QWidget>

#include "ui/models/report_model.h"
#include "ui/models/scene_model.h"
#include "ui/session/session.h"

namespace cullscope::ui {

/// What the scene is, and what was repaired when its file was read.
class ScenePanel : public QWidget {
    Q_OBJECT

public:
    explicit ScenePanel(Session& session, QWidget* parent = nullptr);

protected:
    void changeEvent(QEvent* event) override;

private:
    void refresh();
    void retranslate();

    Session& m_session;
    SceneModel* m_scene;
    ReportModel* m_report;
    QTableView* m_facts;
    QLabel* m_reportTitle;
    QListView* m_sentences;
};

}  // namespace cullscope::ui
