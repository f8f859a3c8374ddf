#pragma once

#include <QTabWidget>

#include "ui/panels/bands_panel.h"
#include "ui/panels/loss_panel.h"
#include "ui/panels/map_panel.h"
#include "ui/panels/structure_tree.h"
#include "ui/panels/why_panel.h"
#include "ui/session/snapshot_reader.h"

namespace cullscope::ui {

/// The structure of the active view's strategy: its map at the top, if it has one, and below it the tabs bands, tree, decisions
/// and losses.
class StructurePanel : public QWidget {
    Q_OBJECT

public:
    StructurePanel(Session& session, SnapshotReader& reader, QWidget* parent = nullptr);

    [[nodiscard]] QTabWidget& tabs() { return *m_tabs; }
    [[nodiscard]] MapPanel& map() { return *m_map; }
    [[nodiscard]] BandsPanel& bands() { return *m_bands; }
    [[nodiscard]] StructureTree& tree() { return *m_tree; }
    [[nodiscard]] WhyPanel& why() { return *m_why; }
    [[nodiscard]] LossPanel& losses() { return *m_losses; }
    /// Shows the tab with the decisions on the picked triangle.
    void showWhy() { m_tabs->setCurrentWidget(m_why); }

protected:
    void changeEvent(QEvent* event) override;

private:
    void retranslate();
    void markSector();

    MapPanel* m_map;
    QTabWidget* m_tabs;
    BandsPanel* m_bands;
    StructureTree* m_tree;
    WhyPanel* m_why;
    LossPanel* m_losses;
};

}  // namespace cullscope::ui
