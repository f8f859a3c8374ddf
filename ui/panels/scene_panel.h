#pragma once

#include <QComboBox>
#include <QGridLayout>
#include <QLabel>
#include <QListView>
#include <QPushButton>
#include <QTableView>

#include "ui/models/report_model.h"
#include "ui/models/scene_model.h"
#include "ui/panels/outliner.h"

namespace cullscope::ui {

/// The properties of the scene, the report on its file, and the list of its objects with its commands.
class ScenePanel : public QWidget {
    Q_OBJECT

public:
    explicit ScenePanel(Session& session, QWidget* parent = nullptr);

    /// Sets the reader of the outliner's verdicts, which are listed while the truth is not known.
    void setReader(SnapshotReader& reader) { m_outliner->setReader(reader); }

    [[nodiscard]] Outliner& outliner() { return *m_outliner; }
    [[nodiscard]] QPushButton& splitButton() { return *m_split; }
    [[nodiscard]] QComboBox& upAxis() { return *m_up; }
    /// How it is known which axis points up.
    [[nodiscard]] const QLabel& upSource() const { return *m_upSource; }

protected:
    void changeEvent(QEvent* event) override;

private:
    void setUpFacts();
    void setUpReport();
    QHBoxLayout* makeUpRow();
    void showUp();
    QGridLayout* makeButtons();
    void refresh();
    void enableButtons();
    void split();
    void retranslate();

    Session& m_session;
    SceneModel* m_scene;
    ReportModel* m_report;
    QTableView* m_facts;
    QLabel* m_upTitle;
    QComboBox* m_up;
    QLabel* m_upSource;
    QLabel* m_reportTitle;
    QListView* m_sentences;
    Outliner* m_outliner;
    QPushButton* m_hide;
    QPushButton* m_show;
    QPushButton* m_frame;
    QPushButton* m_isolate;
    QPushButton* m_showAll;
    QPushButton* m_split;
};

}  // namespace cullscope::ui
