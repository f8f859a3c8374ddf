#pragma once

#include <QWidget>
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
    /// Lends a view's pane to another window, such as the lecture; take() returns it.
    [[nodiscard]] ViewPane* lend(int view);
    void take(ViewPane* pane);

signals:
    void menuRequested(int view, const QPoint& globalPosition);

protected:
    void resizeEvent(QResizeEvent* event) override;
    void paintEvent(QPaintEvent* event) override;

private:
    void arrange();
    /// Shows the loupe at the same pixel in linked views of the same picture size, and hides it in the others.
    void moveLoupes(int view, const std::optional<QPointF>& place);
    [[nodiscard]] QRect cell(int place, int columns, int rows) const;

    Session& m_session;
    std::vector<ViewPane*> m_panes;
    ViewPane* m_lent = nullptr;
};

}  // namespace cullscope::ui
