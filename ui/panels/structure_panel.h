#pragma once

#include <QHBoxLayout>
#include <QTabWidget>
#include <map>

#include "ui/panels/bars_panel.h"
#include "ui/panels/curve_panel.h"
#include "ui/panels/flow_chart_panel.h"
#include "ui/panels/listing_panel.h"
#include "ui/panels/loss_panel.h"
#include "ui/panels/map_panel.h"
#include "ui/panels/structure_tree.h"
#include "ui/panels/why_panel.h"
#include "ui/session/snapshot_reader.h"

namespace cullscope::ui {

/// The structure of the active view's strategy: at the top its map of directions, then the tabs: the curves that it declares,
/// tree, listing and counts (where it declares them), decisions and losses.
class StructurePanel : public QWidget {
    Q_OBJECT

public:
    StructurePanel(Session& session, SnapshotReader& reader, QWidget* parent = nullptr);

    [[nodiscard]] QTabWidget& tabs() { return *m_tabs; }
    [[nodiscard]] MapPanel& map() { return *m_map; }
    [[nodiscard]] StructureTree& tree() { return *m_tree; }
    [[nodiscard]] ListingPanel& listing() { return *m_listing; }
    [[nodiscard]] FlowChartPanel& flowChart() { return *m_chart; }
    [[nodiscard]] BarsPanel& bars() { return *m_bars; }
    [[nodiscard]] WhyPanel& why() { return *m_why; }
    [[nodiscard]] LossPanel& losses() { return *m_losses; }
    /// The tabs of the curves that the shown strategy declares, in its order.
    [[nodiscard]] const std::vector<CurvePanel*>& curves() const { return m_curves; }
    /// Has the tabs that a strategy declares, and none for those of another one. A tab that was open when its
    /// strategy left is open again when the strategy comes back, unless another tab was chosen meanwhile.
    void setShows(const std::vector<Show>& shows);
    /// Shows the listing, whose lines a step marks; once another tab was chosen during steps, nothing happens.
    void showSteps();
    /// For a lecture: the map in a low strip without a legend, and only where the strategy has one.
    void showToAudience();
    /// The strip's height, and the room that stays free on its left for something that the lecture shows there.
    void setAudienceMap(int height, int left);
    /// Whether the open tab has a curve.
    [[nodiscard]] bool showsCurve() const;
    /// The least height below the map at that width: of the tabs with the page in front, and of the gaps between.
    [[nodiscard]] int leastBelowMap(int width) const;
    /// The states whose colours the open curve has, which it shows to an audience without explaining them.
    [[nodiscard]] std::vector<TriangleState> statesOfCurve() const;
    /// The id of the open tab, and opens the one with an id, where the strategy has it.
    [[nodiscard]] std::string page() const;
    void showPage(const std::string& id);
    /// Shows the tab with the decisions on the picked triangle.
    void showWhy();

signals:
    /// Pages may need another height than before.
    void needsChanged();

protected:
    bool event(QEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;
    void changeEvent(QEvent* event) override;

private:
    void retranslate();
    void followStrategy();
    void chooseWhileStepping();
    [[nodiscard]] CurvePanel* curveOf(const Show& show);
    /// The part of the open tab's curve.
    void markPart();
    void showTab(QWidget* page, bool shown);
    /// Opens the tree in place of a page whose tab goes.
    void leave(QWidget* page);
    /// Opens a page whose tab came back, if it was open when its tab went.
    void comeBack(QWidget* page);

    Session& m_session;
    SnapshotReader& m_reader;
    QTabWidget* m_tabs;
    std::vector<CurvePanel*> m_curves;
    std::map<std::string, CurvePanel*>
        m_madeCurves;  ///< by the show's id: what the user chose in one is kept while it has no tab
    MapPanel* m_map;
    QHBoxLayout* m_mapRow;
    StructureTree* m_tree;
    ListingPanel* m_listing;
    FlowChartPanel* m_chart;
    BarsPanel* m_bars;
    WhyPanel* m_why;
    LossPanel* m_losses;
    QWidget* m_left = nullptr;  ///< the page that was open when its tab went; null: none, or another was chosen since
    bool m_audience = false;
    bool m_chosenWhileStepping = false;
    bool m_showing = false;  ///< tabs come and go by the strategy, and the user chooses none
};

}  // namespace cullscope::ui
