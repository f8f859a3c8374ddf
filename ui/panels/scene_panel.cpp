#include "ui/panels/scene_panel.h"

#include <QEvent>
#include <QHeaderView>
#include <QVBoxLayout>

namespace cullscope::ui {

ScenePanel::ScenePanel(Session& session, QWidget* parent)
    : QWidget(parent),
      m_session(session),
      m_scene(new SceneModel(this)),
      m_report(new ReportModel(this)),
      m_facts(new QTableView(this)),
      m_reportTitle(new QLabel(this)),
      m_sentences(new QListView(this)) {
    m_facts->setModel(m_scene);
    m_facts->setFrameShape(QFrame::NoFrame);
    m_facts->setShowGrid(false);
    m_facts->setSelectionMode(QAbstractItemView::NoSelection);
    m_facts->setTabKeyNavigation(false);
    m_facts->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    m_facts->setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    m_facts->horizontalHeader()->hide();
    m_facts->verticalHeader()->hide();
    m_facts->horizontalHeader()->setSectionResizeMode(0, QHeaderView::ResizeToContents);
    m_facts->horizontalHeader()->setSectionResizeMode(1, QHeaderView::Stretch);
    m_facts->verticalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    m_facts->verticalHeader()->setMinimumSectionSize(20);
    m_sentences->setModel(m_report);
    m_sentences->setWordWrap(true);
    m_sentences->setResizeMode(QListView::Adjust);
    m_sentences->setSpacing(2);
    m_sentences->setFrameShape(QFrame::NoFrame);
    m_sentences->setSelectionMode(QAbstractItemView::NoSelection);
    m_sentences->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 4, 0, 0);
    layout->addWidget(m_facts);
    layout->addWidget(m_reportTitle);
    layout->addWidget(m_sentences, 1);
    connect(&session, &Session::sceneChanged, this, &ScenePanel::refresh);
    retranslate();
    refresh();
}

void ScenePanel::refresh() {
    const OpenedScenePointer& opened = m_session.opened();
    m_scene->setScene(opened ? opened->scene : nullptr);
    m_report->setReport(opened ? opened->report : std::nullopt);
    const bool reported = m_report->rowCount() > 0;
    m_reportTitle->setVisible(reported);
    m_sentences->setVisible(reported);
    m_facts->setFixedHeight(m_facts->verticalHeader()->length() + 2);
}

void ScenePanel::retranslate() {
    m_scene->retranslate();
    m_report->retranslate();
    m_facts->setAccessibleName(tr("Facts of the scene"));
    m_sentences->setAccessibleName(tr("What was found in the file"));
    m_reportTitle->setText(tr("What was found in the file"));
}

void ScenePanel::changeEvent(QEvent* event) {
    if (event->type() == QEvent::LanguageChange) retranslate();
    QWidget::changeEvent(event);
}

}  // namespace cullscope::ui
