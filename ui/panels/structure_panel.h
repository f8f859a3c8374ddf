#pragma once

#include <QTabWidget>

#include "ui/families/family_pages.h"
#include "ui/panels/bars_panel.h"
#include "ui/panels/listing_panel.h"
#include "ui/panels/loss_panel.h"
#include "ui/panels/structure_tree.h"
#include "ui/panels/why_panel.h"
#include "ui/session/snapshot_reader.h"

namespace cullscope::ui {

/// The structure of the active view's strategy: at the top and in the first tabs what its family has, then the tabs tree,
/// listing and counts (where the strategy declares them), decisions and losses.
class StructurePanel : public QWidget {
    Q_OBJECT

public:
    StructurePanel(Session& session, SnapshotReader& reader, QWidget* parent = nullptr);

    [[nodiscard]] QTabWidget& tabs() { return *m_tabs; }
    [[nodiscard]] StructureTree& tree() { return *m_tree; }
    [[nodiscard]] ListingPanel& listing() { return *m_listing; }
    [[nodiscard]] BarsPanel& bars() { return *m_bars; }
    [[nodiscard]] WhyPanel& why() { return *m_why; }
    [[nodiscard]] LossPanel& losses() { return *m_losses; }
    /// Shows the tab with the decisions on the picked triangle.
    void showWhy() { m_tabs->setCurrentWidget(m_why); }

protected:
    void changeEvent(QEvent* event) override;

private:
    void retranslate();
    /// Shows the tabs that the present strategy declares. One that was current and comes back is current again, unless another
    /// was chosen meanwhile.
    void showDeclaredTabs();
    void showTab(QWidget* page, bool shown);

    QTabWidget* m_tabs;
    std::vector<FamilyPages*> m_families;
    StructureTree* m_tree;
    ListingPanel* m_listing;
    BarsPanel* m_bars;
    WhyPanel* m_why;
    LossPanel* m_losses;
    Session& m_session;
    QWidget* m_left = nullptr;  ///< the page that was current when its tab went
    bool m_showing = false;
};

}  // namespace cullscope::ui
