#include "ui/panels/long_list_view.h"

#include <QHeaderView>
#include <QPaintEvent>
#include <QResizeEvent>

namespace cullscope::ui {

LongListView::LongListView(QWidget* parent) : QTreeView(parent) {
    setFrameShape(QFrame::NoFrame);
    setUniformRowHeights(true);
    setAlternatingRowColors(true);
    setTabKeyNavigation(false);
    setTextElideMode(Qt::ElideMiddle);
    header()->setStretchLastSection(false);
}

void LongListView::expandFirstLevels(int rows) {
    QModelIndexList level{rootIndex()};
    for (int shown = 0; !level.isEmpty();) {
        QModelIndexList next;
        for (const QModelIndex& parent : level) {
            const int count = model()->rowCount(parent);
            shown += count;
            if (shown > rows) return;
            for (int row = 0; row < count; ++row) next.push_back(model()->index(row, 0, parent));
        }
        for (const QModelIndex& parent : level) expand(parent);
        level = next;
    }
}

void LongListView::setWholeRows(bool whole) {
    m_wholeRows = whole;
    viewport()->update();
}

void LongListView::resizeEvent(QResizeEvent* event) {
    const QRect before = currentIndex().isValid() ? visualRect(currentIndex()) : QRect();
    QTreeView::resizeEvent(event);
    if (before.isValid() && before.top() >= 0 && before.top() < event->oldSize().height()) scrollTo(currentIndex());
}

void LongListView::paintEvent(QPaintEvent* event) {
    QRect whole = viewport()->rect();
    if (const QModelIndex last = indexAt({1, whole.bottom()}); m_wholeRows && last.isValid())
        if (const QRect row = visualRect(last); row.bottom() > whole.bottom()) whole.setBottom(row.top() - 1);
    QPaintEvent part(event->region() & whole);
    QTreeView::paintEvent(&part);
}

void LongListView::dataChanged(const QModelIndex& topLeft, const QModelIndex& bottomRight, const QList<int>& roles) {
    if (topLeft == bottomRight)
        QTreeView::dataChanged(topLeft, bottomRight, roles);
    else
        viewport()->update();
}

}  // namespace cullscope::ui
