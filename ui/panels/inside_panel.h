#pragma once

#include <QLabel>
#include <QTabWidget>

#include "ui/panels/inside_tree.h"
#include "ui/panels/loss_panel.h"
#include "ui/panels/why_panel.h"
#include "ui/session/inside_reader.h"

namespace cullscope::ui {

/// What happens inside the active view's strategy: on top its map, where it has one, below it bands, tree, decisions and losses.
class InsidePanel : public QWidget {
    Q_OBJECT

public:
    InsidePanel(Session& session, InsideReader& reader, QWidget* parent = nullptr);

    [[nodiscard]] QTabWidget& tabs() { return *m_tabs; }
    [[nodiscard]] InsideTree& tree() { return *m_tree; }
    [[nodiscard]] WhyPanel& why() { return *m_why; }
    [[nodiscard]] LossPanel& losses() { return *m_losses; }
    /// Brings the decisions about what is picked to the front.
    void showWhy() { m_tabs->setCurrentWidget(m_why); }

protected:
    void changeEvent(QEvent* event) override;

private:
    void retranslate();

    QLabel* m_noMap;
    QTabWidget* m_tabs;
    QLabel* m_noBands;
    InsideTree* m_tree;
    WhyPanel* m_why;
    LossPanel* m_losses;
};

}  // namespace cullscope::ui
