#include "ui/panels/structure_panel.h"

#include <QEvent>
#include <QScopedValueRollback>
#include <QTabBar>
#include <QVBoxLayout>

#include "ui/panels/shown_strategy.h"

namespace cullscope::ui {

StructurePanel::StructurePanel(Session& session, SnapshotReader& reader, QWidget* parent)
    : QWidget(parent), m_tabs(new QTabWidget), m_session(session) {
    m_families = makeFamilyPages(session, reader, this, m_tabs);
    m_tabs->setParent(this);
    m_tree = new StructureTree(session, reader, m_tabs);
    m_listing = new ListingPanel(session, reader, m_tabs);
    m_bars = new BarsPanel(session, reader, m_tabs);
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
    for (QWidget* page : std::initializer_list<QWidget*>{m_tree, m_listing, m_bars, m_why, m_losses})
        m_tabs->addTab(page, QString());
    m_tabs->setCurrentWidget(m_tree);
    m_tabs->setDocumentMode(true);
    layout->addWidget(m_tabs, 1);
    connect(m_tabs, &QTabWidget::currentChanged, this, [this] {
        if (!m_showing) m_left = nullptr;
    });
    followShownStrategy(session, this, [this] { showDeclaredTabs(); });
    reader.readFor(this);
    retranslate();
    showDeclaredTabs();
}

void StructurePanel::showDeclaredTabs() {
    const StrategyInfo& strategy = shownStrategy(m_session);
    showTab(m_listing, strategy.first(Show::Kind::Listing) != nullptr);
    showTab(m_bars, strategy.first(Show::Kind::Bars) != nullptr);
}

void StructurePanel::showTab(QWidget* page, bool shown) {
    const QScopedValueRollback guard(m_showing, true);
    const int tab = m_tabs->indexOf(page);
    if (shown == m_tabs->isTabVisible(tab)) return;
    const bool leaves = !shown && m_tabs->currentWidget() == page;
    m_tabs->setTabVisible(tab, shown);
    if (leaves) {
        m_left = page;
        m_tabs->setCurrentWidget(m_tree);
    } else if (shown && m_left == page) {
        m_left = nullptr;
        m_tabs->setCurrentWidget(page);
    }
}

void StructurePanel::retranslate() {
    m_tabs->tabBar()->setAccessibleName(tr("Inside the strategy"));
    for (const FamilyPages* family : m_families) m_tabs->setTabText(m_tabs->indexOf(family->page()), family->pageName());
    m_tabs->setTabText(m_tabs->indexOf(m_tree), tr("Tree"));
    m_tabs->setTabText(m_tabs->indexOf(m_listing), tr("Listing"));
    m_tabs->setTabText(m_tabs->indexOf(m_bars), tr("Counts"));
    m_tabs->setTabText(m_tabs->indexOf(m_why), tr("Why"));
    m_tabs->setTabText(m_tabs->indexOf(m_losses), tr("Losses"));
}

void StructurePanel::changeEvent(QEvent* event) {
    if (event->type() == QEvent::LanguageChange) retranslate();
    QWidget::changeEvent(event);
}

}  // namespace cullscope::ui
