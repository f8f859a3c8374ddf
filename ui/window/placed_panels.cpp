#include "ui/window/placed_panels.h"

#include <QScrollArea>
#include <algorithm>

#include "ui/panels/legend_panel.h"
#include "ui/panels/metrics_panel.h"
#include "ui/panels/scene_panel.h"
#include "ui/panels/strategy_panel.h"
#include "ui/panels/structure_panel.h"

namespace cullscope::ui {

namespace {

/// Wraps a panel in a scroll area, because the view may be smaller than the panel's minimum.
QWidget* scrolling(QWidget* panel) {
    auto* scroll = new QScrollArea;
    scroll->setWidget(panel);
    scroll->setWidgetResizable(true);
    scroll->setFrameShape(QFrame::NoFrame);
    scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    scroll->setFocusPolicy(Qt::NoFocus);
    return scroll;
}

}  // namespace

PlacedPanels::PlacedPanels(Session& session, ViewGrid& views, SnapshotReader& reader, Experiments& experiments, QObject* parent)
    : QObject(parent), m_session(session), m_views(views), m_reader(reader), m_experiments(experiments) {
    connect(&session, &Session::setupChanged, this, &PlacedPanels::place);
}

std::vector<PlaceablePanel> PlacedPanels::known() {
    return {{"inside", tr("Inside")}, {"figures", tr("Figures")},   {"statistics", tr("Statistics")},
            {"scene", tr("Scene")},   {"strategy", tr("Strategy")}, {"legend", tr("Legend")}};
}

QWidget* PlacedPanels::make(const std::string& id) const {
    if (id == "inside") return scrolling(new StructurePanel(m_session, m_reader));
    if (id == "figures") return new MetricsPanel(m_session);
    if (id == "statistics") return m_experiments.makePanel();
    if (id == "strategy") return new StrategyPanel(m_session);
    if (id == "legend") return new LegendPanel(m_session);
    if (id != "scene") return nullptr;
    auto* scene = new ScenePanel(m_session);
    scene->setReader(m_reader);
    return scene;
}

std::vector<PlaceablePanel> PlacedPanels::knownBelow() { return {{"map", tr("Map of directions")}}; }

void PlacedPanels::placeBelow(int view) {
    ViewPane& pane = m_views.pane(view);
    const std::string& wanted = m_session.setup(view).below;
    const bool known = std::ranges::any_of(knownBelow(), [&](const PlaceablePanel& panel) { return panel.id == wanted; });
    if (known == (pane.strip() != nullptr)) return;
    MapPanel* map = nullptr;
    if (known) {
        auto* reader = new SnapshotReader(m_session, &pane, view);
        map = new MapPanel(m_session, *reader, &pane);
        map->setBrief();
        reader->readFor(map);
        // After the panel, which knows it.
        connect(map, &QObject::destroyed, reader, &QObject::deleteLater);
    }
    pane.setStrip(map);
    m_views.arrange();
}

void PlacedPanels::place() {
    for (int view = 0; view < Session::kMostViews; ++view) {
        placeBelow(view);
        ViewPane& pane = m_views.pane(view);
        const std::string& wanted = m_session.setup(view).panel;
        const QString placed = pane.panel() ? pane.panel()->objectName() : QString();
        if (placed == QString::fromStdString(wanted)) continue;
        QWidget* panel = wanted.empty() ? nullptr : make(wanted);
        if (panel) {
            panel->setObjectName(QString::fromStdString(wanted));
            panel->setAutoFillBackground(true);
        }
        pane.setPanel(panel);
    }
}

}  // namespace cullscope::ui
