#include "ui/panels/structure_panel.h"

#include <QEvent>
#include <QTabBar>
#include <QVBoxLayout>

namespace cullscope::ui {

StructurePanel::StructurePanel(Session& session, SnapshotReader& reader, QWidget* parent)
    : QWidget(parent), m_tabs(new QTabWidget) {
    m_families = makeFamilyPages(session, reader, this, m_tabs);
    m_tabs->setParent(this);
    m_tree = new StructureTree(session, reader, m_tabs);
    m_why = new WhyPanel(session, reader, m_tabs);
    m_losses = new LossPanel(session, m_tabs);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 4, 0, 0);
    layout->setSpacing(4);
    for (FamilyPages* family : m_families) {
        m_tabs->addTab(family->page(), QString());
        layout->addWidget(family->top());
        connect(m_tabs, &QTabWidget::currentChanged, family, [this, family] { family->setCurrent(m_tabs->currentWidget()); });
    }
    for (QWidget* page : std::initializer_list<QWidget*>{m_tree, m_why, m_losses}) m_tabs->addTab(page, QString());
    m_tabs->setCurrentWidget(m_tree);
    m_tabs->setDocumentMode(true);
    layout->addWidget(m_tabs, 1);
    reader.readFor(this);
    retranslate();
}

void StructurePanel::retranslate() {
    m_tabs->tabBar()->setAccessibleName(tr("Inside the strategy"));
    for (const FamilyPages* family : m_families) m_tabs->setTabText(m_tabs->indexOf(family->page()), family->pageName());
    m_tabs->setTabText(m_tabs->indexOf(m_tree), tr("Tree"));
    m_tabs->setTabText(m_tabs->indexOf(m_why), tr("Why"));
    m_tabs->setTabText(m_tabs->indexOf(m_losses), tr("Losses"));
}

void StructurePanel::changeEvent(QEvent* event) {
    if (event->type() == QEvent::LanguageChange) retranslate();
    QWidget::changeEvent(event);
}

}  // namespace cullscope::ui
