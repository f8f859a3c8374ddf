#include "ui/panels/structure_panel.h"

#include <QEvent>
#include <QScopedValueRollback>
#include <QTabBar>
#include <QVBoxLayout>
#include <algorithm>

#include "ui/text/translated.h"

#include "ui/panels/shown_strategy.h"

namespace cullscope::ui {

StructurePanel::StructurePanel(Session& session, SnapshotReader& reader, QWidget* parent)
    : QWidget(parent), m_session(session), m_reader(reader), m_tabs(new QTabWidget) {
    m_map = new MapPanel(session, reader, this);
    m_tabs->setParent(this);
    m_tree = new StructureTree(session, reader, m_tabs);
    m_listing = new ListingPanel(session, reader, m_tabs);
    m_bars = new BarsPanel(session, reader, m_tabs);
    m_why = new WhyPanel(session, reader, m_tabs);
    m_losses = new LossPanel(session, m_tabs);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 4, 0, 0);
    layout->setSpacing(4);
    layout->addWidget(m_map);
    for (QWidget* page : std::initializer_list<QWidget*>{m_tree, m_listing, m_bars, m_why, m_losses})
        m_tabs->addTab(page, QString());
    m_tabs->setCurrentWidget(m_tree);
    m_tabs->setDocumentMode(true);
    layout->addWidget(m_tabs, 1);
    connect(m_tabs, &QTabWidget::currentChanged, this, [this] {
        if (!m_showing) m_left = nullptr;
        if (m_tabs->tabBar()->hasFocus()) chooseWhileStepping();
        markPart();
    });
    connect(m_tabs->tabBar(), &QTabBar::tabBarClicked, this, &StructurePanel::chooseWhileStepping);
    followShownStrategy(session, this, [this] { followStrategy(); });
    followStrategy();
    reader.readFor(this);
    retranslate();
}

void StructurePanel::showSteps() {
    if (!m_chosenWhileStepping && m_tabs->isTabVisible(m_tabs->indexOf(m_listing))) m_tabs->setCurrentWidget(m_listing);
}

void StructurePanel::chooseWhileStepping() { m_chosenWhileStepping = m_chosenWhileStepping || m_session.step().has_value(); }

void StructurePanel::showTab(QWidget* page, bool shown) {
    const int tab = m_tabs->indexOf(page);
    if (shown == m_tabs->isTabVisible(tab)) return;
    if (!shown) leave(page);
    m_tabs->setTabVisible(tab, shown);
    if (shown) comeBack(page);
}

void StructurePanel::leave(QWidget* page) {
    if (m_tabs->currentWidget() != page) return;
    m_left = page;
    m_tabs->setCurrentWidget(m_tree);
}

void StructurePanel::comeBack(QWidget* page) {
    if (m_left != page) return;
    m_left = nullptr;
    m_tabs->setCurrentWidget(page);
}

void StructurePanel::followStrategy() { setShows(shownStrategy(m_session).shows); }

void StructurePanel::setShows(const std::vector<Show>& shows) {
    const QScopedValueRollback guard(m_showing, true);
    const auto declares = [&](const std::string& id) {
        return std::ranges::any_of(shows, [&](const Show& show) { return show.kind == Show::Kind::Curve && show.id == id; });
    };
    for (CurvePanel* curve : std::vector(m_curves)) {
        if (declares(curve->declared().id)) continue;
        leave(curve);
        m_tabs->removeTab(m_tabs->indexOf(curve));
        std::erase(m_curves, curve);
    }
    for (const Show& show : shows) {
        const auto has = [&](const CurvePanel* curve) { return curve->declared().id == show.id; };
        if (show.kind != Show::Kind::Curve || std::ranges::any_of(m_curves, has)) continue;
        m_curves.push_back(curveOf(show));
        m_tabs->insertTab(m_tabs->indexOf(m_tree), m_curves.back(), translated(show.title));
        comeBack(m_curves.back());
    }
    const auto has = [&](Show::Kind kind) {
        return std::ranges::any_of(shows, [=](const Show& show) { return show.kind == kind; });
    };
    showTab(m_listing, has(Show::Kind::Listing));
    showTab(m_bars, has(Show::Kind::Bars));
    markPart();
}

CurvePanel* StructurePanel::curveOf(const Show& show) {
    CurvePanel*& curve = m_madeCurves[show.id];
    if (curve) return curve;
    curve = new CurvePanel(m_session, m_reader, show, m_tabs);
    connect(curve, &CurvePanel::partChanged, this, &StructurePanel::markPart);
    return curve;
}

void StructurePanel::markPart() {
    // The mark belongs to the curve in the tab: while the curve is not shown, the mark would need an explanation.
    const auto* curve = qobject_cast<const CurvePanel*>(m_tabs->currentWidget());
    m_map->setPart(curve ? curve->shownPart() : std::nullopt);
}

void StructurePanel::retranslate() {
    m_tabs->tabBar()->setAccessibleName(tr("Inside the strategy"));
    for (CurvePanel* curve : m_curves) m_tabs->setTabText(m_tabs->indexOf(curve), translated(curve->declared().title));
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
