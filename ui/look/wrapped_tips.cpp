#include "ui/look/wrapped_tips.h"

#include <QAbstractItemView>
#include <QFontMetricsF>
#include <QHeaderView>
#include <QHelpEvent>
#include <QMenu>
#include <QTextLayout>
#include <QToolTip>

namespace cullscope::ui {

namespace {

constexpr int kTipWidth = 70;  // in the tip's font, in letters x

QString tipOfView(const QAbstractItemView& view, const QPoint& place) {
    if (const auto* header = qobject_cast<const QHeaderView*>(&view)) {
        const int section = header->logicalIndexAt(place);
        return section < 0 || !header->model()
                   ? QString()
                   : header->model()->headerData(section, header->orientation(), Qt::ToolTipRole).toString();
    }
    return view.indexAt(place).data(Qt::ToolTipRole).toString();
}

/// The tip that a widget shows at a place; empty: none, or one that it composes itself.
QString tipOf(const QWidget& widget, const QPoint& place) {
    if (const auto* menu = qobject_cast<const QMenu*>(&widget)) {
        const QAction* action = menu->actionAt(place);
        return action && menu->toolTipsVisible() ? action->toolTip() : QString();
    }
    const auto* view = qobject_cast<const QAbstractItemView*>(widget.parentWidget());
    if (view && view->viewport() == &widget) return tipOfView(*view, place);
    return widget.toolTip();
}

}  // namespace

QString wrappedTip(const QString& text) {
    const QFont font = QToolTip::font();
    const double width = kTipWidth * QFontMetricsF(font).horizontalAdvance(QLatin1Char('x'));
    QStringList lines;
    for (const QString& paragraph : text.split(QLatin1Char('\n'))) {
        QTextLayout layout(paragraph, font);
        layout.beginLayout();
        for (QTextLine line = layout.createLine(); line.isValid(); line = layout.createLine()) {
            line.setLineWidth(width);
            lines << paragraph.mid(line.textStart(), line.textLength()).trimmed();
        }
        layout.endLayout();
    }
    return lines.join(QLatin1Char('\n'));
}

bool WrappedTips::eventFilter(QObject* watched, QEvent* event) {
    auto* widget = event->type() == QEvent::ToolTip ? qobject_cast<QWidget*>(watched) : nullptr;
    if (!widget) return QObject::eventFilter(watched, event);
    const auto* help = static_cast<QHelpEvent*>(event);
    const QString tip = tipOf(*widget, help->pos());
    const QString wrapped = wrappedTip(tip);
    // Short ones are shown as Qt shows them.
    if (tip.isEmpty() || wrapped == tip) return false;
    QToolTip::showText(help->globalPos(), wrapped, widget);
    return true;
}

}  // namespace cullscope::ui
