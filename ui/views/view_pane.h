#pragma once

#include <QLabel>
#include <QWidget>

#include "ui/session/session.h"
#include "ui/views/budget_bar.h"
#include "ui/views/scene_view.h"
#include "ui/views/view_header.h"

namespace cullscope::ui {

/// A view's picture with its header, its budget bar, and a chip over the picture that states unusual settings. A panel can
/// replace the picture.
class ViewPane : public QWidget {
    Q_OBJECT

public:
    ViewPane(Session& session, int view, QWidget* parent = nullptr);

    [[nodiscard]] int view() const { return m_view; }
    [[nodiscard]] SceneView& picture() { return *m_picture; }
    [[nodiscard]] ViewHeader& header() { return *m_header; }
    /// What the chip says; empty: no chip.
    [[nodiscard]] QString chipText() const;
    /// In compare mode pictures that are fitted to the window have an aspect ratio of 4 : 3: eight of them are 320 × 240 on the
    /// least screen.
    void setCompare(bool compare);
    enum class Lent {
        No,
        Alone,  ///< to a lecture: without the header, whose contents the lecture shows itself
        Beside  ///< to a lecture, one of several: the header says which strategy it is
    };
    /// In a lecture letters have so many pixels.
    void setLent(Lent lent, int letters);
    /// Hides what the header and the budget bar tell of figures.
    void setFiguresHidden(bool hidden);
    /// Replaces the picture by a panel, which this pane then owns; null: shows the picture again.
    void setPanel(QWidget* panel);
    [[nodiscard]] QWidget* panel() const { return m_panel; }
    /// Puts a strip below the picture, which this pane then owns; null: there is none.
    void setStrip(QWidget* strip);
    [[nodiscard]] QWidget* strip() const { return m_strip; }

protected:
    void changeEvent(QEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

private:
    void arrange();
    void refresh();
    void refreshChip();
    [[nodiscard]] QPoint chipPlace() const;
    /// Between the shown picture and the lower edge of its widget.
    [[nodiscard]] int roomBelow() const;
    void retranslate();
    [[nodiscard]] QStringList lensParts() const;
    /// How many pixels the picture marks as missed or added, and how many of the former are no loss.
    [[nodiscard]] QString markedPixels(const ViewPicture& shown) const;
    /// The differences between the visible set and that of the compared view; empty: no view is compared, or the sets are not
    /// known.
    [[nodiscard]] QString visibleSets() const;

    Session& m_session;
    int m_view;
    ViewHeader* m_header;
    SceneView* m_picture;
    BudgetBar* m_budget;
    QLabel* m_chip;
    QWidget* m_panel = nullptr;
    QWidget* m_strip = nullptr;
    bool m_compare = false;
    Lent m_lent = Lent::No;
    int m_letters = 0;  ///< in pixels, lent
    bool m_figuresHidden = false;
};

}  // namespace cullscope::ui
