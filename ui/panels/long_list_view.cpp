#include "ui/panels/long_list_view.h"

#include <QHeaderView>

namespace cullscope::ui {

LongListView::LongListView(QWidget* parent) : QTreeView(parent) {
    setFrameShape(QFrame::NoFrame);
    setUniformRowHeights(true);
    setAlternatingRowColors(true);
    setTabKeyNavigation(false);
    setTextElideMode(Qt::ElideMiddle);
    header()->setStretchLastSection(false);
}

void LongListView::dataChanged(const QModelIndex& topLeft, const QModelIndex& bottomRight, const QList<int>& roles) {
    if (topLeft == bottomRight)
        QTreeView::dataChanged(topLeft, bottomRight, roles);
    else
        viewport()->update();
}

}  // namespace cullscope::ui
