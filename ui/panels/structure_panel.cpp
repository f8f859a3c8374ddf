#include "ui/panels/structure_panel.h"

#include <QEvent>
#include <QTabBar>
#include <QVBoxLayout>

namespace cullscope::ui {

StructurePanel::StructurePanel(Session& session, SnapshotReader& reader, QWidget* parent)
    : QWidget(parent),
      m_map(new MapPanel(session, reader, this)),
      m_tabs(new QTabWidget(this)),
      m_bands(new BandsPanel(session, reader, m_tabs)),
      m_tree(new StructureTree(session, reader, m_tabs)),
      m_why(new WhyPanel(session, reader, m_tabs)),
      m_losses(new LossPanel(session, m_tabs)) {
    for (QWidget* page : std::initializer_list<QWidget*>{m_bands, m_tree, m_why, m_losses}) m_tabs->addTab(page, QString());
    m_tabs->setCurrentWidget(m_tree);
    m_tabs->setDocumentMode(true);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 4, 0, 0);
    layout->setSpacing(4);
    layout->addWidget(m_map);
    layout->addWidget(m_tabs, 1);
    connect(m_bands, &BandsPanel::sectorChanged, this, &StructurePanel::markSector);
    connect(m_tabs, &QTabWidget::currentChanged, this, &StructurePanel::markSector);
    markSector();
    reader.readFor(this);
    retranslate();
}

void StructurePanel::markSector() {
    // The mark on the map belongs to the plot below it: while the plot is not shown, the mark would need an explanation.
    m_map->setSector(m_tabs->currentWidget() == m_bands ? m_bands->plot().sector() : std::nullopt);
}

void StructurePanel::retranslate() {
    m_tabs->tabBar()->setAccessibleName(tr("Inside the strategy"));
    m_tabs->setTabText(m_tabs->indexOf(m_bands), tr("Bands"));
    m_tabs->setTabText(m_tabs->indexOf(m_tree), tr("Tree"));
    m_tabs->setTabText(m_tabs->indexOf(m_why), tr("Why"));
    m_tabs->setTabText(m_tabs->indexOf(m_losses), tr("Losses"));
}

void StructurePanel::changeEvent(QEvent* event) {
    if (event->type() == QEvent::LanguageChange) retranslate();
    QWidget::changeEvent(event);
}

}  // namespace cullscope::ui
