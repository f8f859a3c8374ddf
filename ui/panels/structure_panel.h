#pragma once

#include <QTabWidget>

#include "ui/families/family_pages.h"
#include "ui/panels/loss_panel.h"
#include "ui/panels/structure_tree.h"
#include "ui/panels/why_panel.h"
#include "ui/session/snapshot_reader.h"

namespace cullscope::ui {

/// The structure of the active view's strategy: at the top and in the first tabs what its family has, then the tabs tree,
/// decisions and losses.
class StructurePanel : public QWidget {
    Q_OBJECT

public:
    StructurePanel(Session& session, SnapshotReader& reader, QWidget* parent = nullptr);

    [[nodiscard]] QTabWidget& tabs() { return *m_tabs; }
    [[nodiscard]] StructureTree& tree() { return *m_tree; }
    [[nodiscard]] WhyPanel& why() { return *m_why; }
    [[nodiscard]] LossPanel& losses() { return *m_losses; }
    /// Shows the tab with the decisions on the picked triangle.
    void showWhy() { m_tabs->setCurrentWidget(m_why); }

protected:
    void changeEvent(QEvent* event) override;

private:
    void retranslate();

    QTabWidget* m_tabs;
    std::vector<FamilyPages*> m_families;
    StructureTree* m_tree;
    WhyPanel* m_why;
    LossPanel* m_losses;
};

}  // namespace cullscope::ui
