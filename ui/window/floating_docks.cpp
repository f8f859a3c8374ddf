#include "ui/window/floating_docks.h"

#include <QKeyEvent>
#include <algorithm>

namespace cullscope::ui {

FloatingDocks::FloatingDocks(QWidget& window, QWidget& views) : QObject(&window), m_window(window), m_views(views) {
    window.installEventFilter(this);
    views.installEventFilter(this);
}

void FloatingDocks::add(QDockWidget& dock, Place place) {
    dock.installEventFilter(this);
    m_docks.push_back({&dock, std::move(place), dock.allowedAreas(), !dock.isHidden()});
}

void FloatingDocks::setFloating(bool floating) {
    if (floating == m_floating) return;
    m_floating = floating;
    for (Floating& entry : m_docks) {
        if (floating) entry.openBefore = !entry.dock->isHidden();
        entry.dock->hide();
        setUp(entry);
        if (!floating) entry.dock->setVisible(entry.openBefore);
    }
}

void FloatingDocks::adopt(bool floating) {
    m_floating = floating;
    for (const Floating& entry : m_docks) {
        const bool open = !entry.dock->isHidden();
        entry.dock->hide();
        setUp(entry);
        entry.dock->setVisible(open);
    }
}

void FloatingDocks::setUp(const Floating& entry) {
    // While it floats the user cannot dock it: neither by a drag to the window's edge nor by a double click.
    entry.dock->setFeatures(QDockWidget::DockWidgetClosable | QDockWidget::DockWidgetMovable |
                            (m_floating ? QDockWidget::NoDockWidgetFeatures : QDockWidget::DockWidgetFloatable));
    entry.dock->setAllowedAreas(m_floating ? Qt::NoDockWidgetArea : entry.areas);
    entry.dock->setFloating(m_floating);
}

void FloatingDocks::showBeside(QDockWidget& dock) {
    dock.setAttribute(Qt::WA_ShowWithoutActivating);
    dock.show();
    dock.setAttribute(Qt::WA_ShowWithoutActivating, false);
}

void FloatingDocks::putInPlace(const Floating& entry) {
    entry.dock->setGeometry(entry.place(QRect(m_views.mapToGlobal(QPoint()), m_views.size())));
}

bool FloatingDocks::close() {
    bool closed = false;
    for (const Floating& entry : m_docks) {
        closed = closed || entry.dock->isVisible();
        entry.dock->hide();
    }
    if (closed) m_window.activateWindow();
    return closed;
}

bool FloatingDocks::eventFilter(QObject* watched, QEvent* event) {
    if (!m_floating) return QObject::eventFilter(watched, event);
    const auto entry = std::find_if(m_docks.begin(), m_docks.end(), [&](const Floating& each) { return each.dock == watched; });
    switch (event->type()) {
        case QEvent::Show:
            if (entry == m_docks.end()) break;
            putInPlace(*entry);
            // The Tab key does not move the focus into another window.
            if (!entry->dock->testAttribute(Qt::WA_ShowWithoutActivating)) entry->dock->activateWindow();
            break;
        case QEvent::Move:
        case QEvent::Resize:
            if (entry != m_docks.end()) break;
            for (const Floating& each : m_docks)
                if (each.dock->isVisible()) putInPlace(each);
            break;
        case QEvent::KeyPress:
            if (watched != &m_views && static_cast<QKeyEvent*>(event)->key() == Qt::Key_Escape && close()) return true;
            break;
        default:
            break;
    }
    return QObject::eventFilter(watched, event);
}

}  // namespace cullscope::ui
