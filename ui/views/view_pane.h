#pragma once

#include <QLabel>
#include <QWidget>

#include "ui/session/session.h"
#include "ui/views/budget_bar.h"
#include "ui/views/scene_view.h"
#include "ui/views/view_header.h"

namespace cullscope::ui {

/// A view with its header, its budget bar, and a chip in the picture that says what is not as usual. In its place a panel can
/// stand.
class ViewPane : public QWidget {
    Q_OBJECT

public:
    ViewPane(Session& session, int view, QWidget* parent = nullptr);

    [[nodiscard]] int view() const { return m_view; }
    [[nodiscard]] SceneView& picture() { return *m_picture; }
    [[nodiscard]] ViewHeader& header() { return *m_header; }
    /// What the chip says; empty: no chip.
    [[nodiscard]] QString chipText() const;
    /// Among many views pictures that fit the window are of 4 by 3: eight of them are 320 × 240 on the least screen.
    void setCompare(bool compare);
    /// Lent to a lecture, which says around the picture what the header says: without the header, and letters for the back row.
    void setLent(bool lent);
    /// Takes the picture's place and belongs to this pane; null: the picture again.
    void setPanel(QWidget* panel);
    [[nodiscard]] QWidget* panel() const { return m_panel; }

protected:
    void changeEvent(QEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

private:
    void arrange();
    void refresh();
    void refreshChip();
    void retranslate();
    [[nodiscard]] QStringList lensParts() const;
    /// How the visible set differs from that of the view compared with; empty: nothing is compared, or not known.
    [[nodiscard]] QString visibleSets() const;

    Session& m_session;
    int m_view;
    ViewHeader* m_header;
    SceneView* m_picture;
    BudgetBar* m_budget;
    QLabel* m_chip;
    QWidget* m_panel = nullptr;
    bool m_compare = false;
    bool m_lent = false;
};

}  // namespace cullscope::ui
