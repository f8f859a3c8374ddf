#include "ui/statistics/flow_layout.h"

#include <QWidget>
#include <algorithm>

namespace cullscope::ui {

FlowLayout::FlowLayout(QWidget* parent, int between, int rows) : QLayout(parent), m_between(between), m_rows(rows) {}

FlowLayout::~FlowLayout() { qDeleteAll(m_items); }

QLayoutItem* FlowLayout::takeAt(int index) { return index >= 0 && index < m_items.size() ? m_items.takeAt(index) : nullptr; }

QSize FlowLayout::minimumSize() const {
    QSize size;
    for (const QLayoutItem* item : m_items) size = size.expandedTo(item->minimumSize());
    const QMargins margins = contentsMargins();
    return size + QSize(margins.left() + margins.right(), margins.top() + margins.bottom());
}

void FlowLayout::setGeometry(const QRect& place) {
    QLayout::setGeometry(place);
    arrange(place, true);
}

int FlowLayout::arrange(const QRect& place, bool apply) const {
    const QMargins margins = contentsMargins();
    const QRect inner = place.marginsRemoved(margins);
    QList<QLayoutItem*> line;
    int x = 0, top = inner.top(), height = 0;
    const auto finishLine = [&] {
        int left = inner.left();
        for (QLayoutItem* item : std::as_const(line)) {
            const QSize size = item->sizeHint();
            if (apply) item->setGeometry(QRect(QPoint(left, top + (height - size.height()) / 2), size));
            left += size.width() + m_between;
        }
        line.clear();
    };
    for (QLayoutItem* item : m_items) {
        if (item->isEmpty()) continue;
        const QSize size = item->sizeHint();
        if (!line.isEmpty() && x + size.width() > inner.width()) {
            finishLine();
            top += height + m_rows;
            x = height = 0;
        }
        line.append(item);
        x += size.width() + m_between;
        height = std::max(height, size.height());
    }
    finishLine();
    return top + height - place.top() + margins.bottom();
}

}  // namespace cullscope::ui
