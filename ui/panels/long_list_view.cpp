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

void LongListView::dataChanged(const QModelIndex& topLeft, const QModelIndex& bottomRight, const QList<int>& roles) {
    if (topLeft == bottomRight)
        QTreeView::dataChanged(topLeft, bottomRight, roles);
    else
        viewport()->update();
}

}  // namespace cullscope::ui
