#pragma once

#include <QWidget>
#include <set>
#include <vector>

#include "ui/views/view_pane.h"

namespace cullscope::ui {

/// The views in one row of one or two, or in two rows of two or four. All pictures have exactly the same size, so that they share
/// one truth.
class ViewGrid : public QWidget {
    Q_OBJECT

public:
    explicit ViewGrid(Session& session, QWidget* parent = nullptr);

    [[nodiscard]] ViewPane& pane(int view) { return *m_panes[size_t(view)]; }
    /// The places of views, as many as there are numbers, within a rectangle: a row of up to two, or two rows. A row with strips
    /// below its pictures is higher.
    [[nodiscard]] std::vector<QRect> cells(const QRect& place, const std::vector<int>& views) const;
    /// Lends a view's pane to another window, such as the lecture; take() returns it.
    [[nodiscard]] ViewPane* lend(int view);
    void take(ViewPane* pane);
    /// Places the panes anew: a strip was added to one, or taken away.
    void arrange();

signals:
    void menuRequested(int view, const QPoint& globalPosition);

protected:
    void resizeEvent(QResizeEvent* event) override;
    void paintEvent(QPaintEvent* event) override;

private:
    /// Shows the loupe at the same pixel in linked views of the same picture size, and hides it in the others.
    void moveLoupes(int view, const std::optional<QPointF>& place);

    Session& m_session;
    std::vector<ViewPane*> m_panes;
    std::set<ViewPane*> m_lent;
};

}  // namespace cullscope::ui
