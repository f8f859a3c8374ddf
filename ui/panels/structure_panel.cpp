#include "ui/panels/structure_panel.h"

#include <QEvent>
#include <QHeaderView>
#include <QLabel>
#include <QProxyStyle>
#include <QScopedValueRollback>
#include <QScrollArea>
#include <QStyledItemDelegate>
#include <QTabBar>
#include <QTableView>
#include <QVBoxLayout>
#include <algorithm>

#include "ui/text/translated.h"

#include "ui/panels/shown_strategy.h"

namespace cullscope::ui {

namespace {

/// Paints all items in letters as large as the view's own.
class LargeLetters : public QStyledItemDelegate {
public:
    explicit LargeLetters(QWidget* view) : QStyledItemDelegate(view), m_view(view) {}

protected:
    void initStyleOption(QStyleOptionViewItem* option, const QModelIndex& index) const override {
        QStyledItemDelegate::initStyleOption(option, index);
        option->font.setPixelSize(QFontInfo(m_view->font()).pixelSize());
        option->fontMetrics = QFontMetrics(option->font);
    }

private:
    QWidget* m_view;
};

/// The application's style with less room beside the words of a tab: seven tabs stand side by side in the dock.
class CloseTabs final : public QProxyStyle {
public:
    using QProxyStyle::pixelMetric;
    int pixelMetric(PixelMetric metric, const QStyleOption* option, const QWidget* widget) const override {
        constexpr int kBesideWords = 12;  // pixels, on both sides together
        const int usual = QProxyStyle::pixelMetric(metric, option, widget);
        return metric == PM_TabBarTabHSpace ? std::min(kBesideWords, usual) : usual;
    }
};

}  // namespace

StructurePanel::StructurePanel(Session& session, SnapshotReader& reader, QWidget* parent)
    : QWidget(parent), m_session(session), m_reader(reader), m_tabs(new QTabWidget) {
    m_map = new MapPanel(session, reader, this);
    m_tabs->setParent(this);
    m_tree = new StructureTree(session, reader, m_tabs);
    m_listing = new ListingPanel(session, reader, m_tabs);
    m_chart = new FlowChartPanel(session, reader, m_tabs);
    m_bars = new BarsPanel(session, reader, m_tabs);
    m_why = new WhyPanel(session, reader, m_tabs);
    m_losses = new LossPanel(session, m_tabs);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 4, 0, 0);
    layout->setSpacing(4);
    m_mapRow = new QHBoxLayout;
    m_mapRow->addWidget(m_map);
    layout->addLayout(m_mapRow);
    const std::array<std::pair<QWidget*, const char*>, 6> pages{{{m_tree, "tree"},
                                                                 {m_listing, "listing"},
                                                                 {m_chart, "flow-chart"},
                                                                 {m_bars, "counts"},
                                                                 {m_why, "why"},
                                                                 {m_losses, "losses"}}};
    for (const auto& [page, id] : pages) {
        page->setObjectName(QLatin1String(id));
        m_tabs->addTab(page, QString());
    }
    m_tabs->setCurrentWidget(m_tree);
    m_tabs->setDocumentMode(true);
    auto* const close = new CloseTabs;
    close->setParent(m_tabs);
    m_tabs->tabBar()->setStyle(close);
    layout->addWidget(m_tabs, 1);
    connect(m_tabs, &QTabWidget::currentChanged, this, [this] {
        emit needsChanged();
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

void StructurePanel::showToAudience() {
    m_audience = true;
    m_map->setBrief();
    // The lines alone: a stepped frame has its sentence under the pictures.
    for (QLabel* words : m_listing->findChildren<QLabel*>()) words->hide();
    for (QTableView* lines : m_listing->findChildren<QTableView*>()) {
        lines->horizontalHeader()->hide();
        // The hidden row header asks for margins of its own: without them ten lines have room below a map.
        QFont small = lines->verticalHeader()->font();
        small.setPixelSize(1);
        lines->verticalHeader()->setFont(small);
        lines->setItemDelegate(new LargeLetters(lines));
    }
    // What a lecture has no room for is cut within a page, and does not push the tabs under the map.
    m_tabs->setMinimumSize(1, 1);
    for (QWidget* part : std::initializer_list<QWidget*>{m_tabs, m_listing, &m_listing->view()}) part->installEventFilter(this);
    for (CurvePanel* curve : m_curves) curve->setBrief();
    followStrategy();
}

void StructurePanel::setAudienceMap(int height, int left) {
    m_map->setFixedHeight(height);
    m_mapRow->setContentsMargins(left, 0, 0, 0);
}

bool StructurePanel::showsCurve() const {
    return std::ranges::any_of(m_curves, [this](const CurvePanel* curve) { return curve == m_tabs->currentWidget(); });
}

bool StructurePanel::event(QEvent* event) {
    const bool done = QWidget::event(event);
    if (event->type() == QEvent::LayoutRequest) emit needsChanged();
    return done;
}

bool StructurePanel::eventFilter(QObject* watched, QEvent* event) {
    // Other words on the tabs or in the pages: they lay themselves out without asking the panel, whose least heights are given.
    if (event->type() == QEvent::LayoutRequest) emit needsChanged();
    return QWidget::eventFilter(watched, event);
}

int StructurePanel::leastBelowMap(int width) const {
    const auto curve = std::ranges::find_if(m_curves, [this](const CurvePanel* one) { return one == m_tabs->currentWidget(); });
    const int needed = curve != m_curves.end()                ? (*curve)->neededHeight(width)
                       : m_tabs->currentWidget() == m_listing ? m_listing->view().wholeHeight()
                                                              : m_tabs->currentWidget()->minimumSizeHint().height();
    const int gaps = layout()->contentsMargins().top() + layout()->spacing();
    return gaps + m_tabs->tabBar()->sizeHint().height() + needed;
}

std::vector<TriangleState> StructurePanel::statesOfCurve() const {
    const auto* curve = qobject_cast<const CurvePanel*>(m_tabs->currentWidget());
    return curve ? curve->states() : std::vector<TriangleState>();
}

std::string StructurePanel::page() const { return m_tabs->currentWidget()->objectName().toStdString(); }

void StructurePanel::showPage(const std::string& id) {
    for (int tab = 0; tab < m_tabs->count(); ++tab)
        if (m_tabs->isTabVisible(tab) && m_tabs->widget(tab)->objectName().toStdString() == id) m_tabs->setCurrentIndex(tab);
}

void StructurePanel::showSteps() {
    if (!m_chosenWhileStepping && m_tabs->isTabVisible(m_tabs->indexOf(m_listing))) m_tabs->setCurrentWidget(m_listing);
}

void StructurePanel::showWhy() {
    m_tabs->setCurrentWidget(m_why);
    // In a low window the tabs reach below what their place shows. Queued: the page is laid out first.
    const auto scroll = [this] {
        for (QWidget* place = parentWidget(); place != nullptr; place = place->parentWidget())
            if (auto* area = qobject_cast<QScrollArea*>(place); area != nullptr) area->ensureWidgetVisible(m_tabs, 0, 0);
    };
    QMetaObject::invokeMethod(this, scroll, Qt::QueuedConnection);
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
    showTab(m_chart, std::ranges::any_of(shows, [](const Show& show) { return !show.chart.empty(); }));
    showTab(m_bars, has(Show::Kind::Bars));
    // An audience has no use for a tree that a strategy does not have.
    if (m_audience && m_tabs->currentWidget() == m_tree && !has(Show::Kind::Tree) && has(Show::Kind::Listing))
        m_tabs->setCurrentWidget(m_listing);
    m_map->setVisible(!m_audience || has(Show::Kind::DirectionMap));
    markPart();
}

CurvePanel* StructurePanel::curveOf(const Show& show) {
    CurvePanel*& curve = m_madeCurves[show.id];
    if (curve) return curve;
    curve = new CurvePanel(m_session, m_reader, show, m_tabs);
    if (m_audience) curve->setBrief();
    curve->setObjectName(QString::fromStdString(show.id));
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
    m_tabs->setTabText(m_tabs->indexOf(m_chart), tr("Chart", "a tab: a flow chart"));
    m_tabs->setTabText(m_tabs->indexOf(m_bars), tr("Counts"));
    m_tabs->setTabText(m_tabs->indexOf(m_why), tr("Why"));
    m_tabs->setTabText(m_tabs->indexOf(m_losses), tr("Losses"));
}

void StructurePanel::changeEvent(QEvent* event) {
    if (event->type() == QEvent::LanguageChange) retranslate();
    QWidget::changeEvent(event);
}

}  // namespace cullscope::ui
