#pragma once

#include <QObject>
#include <QSettings>

#include "ui/dialogs/screenshot_taker.h"
#include "ui/dialogs/section_dialog.h"
#include "ui/views/view_grid.h"
#include "ui/window/view_menu.h"
#include "ui/window/window_actions.h"

namespace cullscope::ui {

/// Commands for one view: the Picture menu for the active view, and each view's context menu.
class ViewCommands : public QObject {
    Q_OBJECT

public:
    ViewCommands(Session& session, ViewGrid& views, WindowActions& actions, ScreenshotTaker& screenshots, QWidget* window);

    void fillMenu(QMenu& menu, int view);
    /// Adds what can be done with the object that a view shows at a place of the screen, and with hidden ones.
    void addObjects(QMenu& menu, int view, const QPoint& position);
    void showMenuOf(int view, const QPoint& position);
    /// Copies the picture of a view to the clipboard; `overlays`: with its overlays.
    void copyPicture(int view, bool overlays);
    /// Gives all pictures the size that was chosen for all at an earlier start.
    void restoreSize();

private:
    void refresh();
    void refreshProjection();
    void addObject(QMenu& menu, uint32_t object);
    /// Changes the active view's setup.
    void edit(const std::function<void(ViewSetup&)>& change);
    void fillSizes();
    void setSizeOfAll(const std::optional<Viewport>& size);
    /// A shown view that watches the culling of the active one from outside; none: there is none.
    [[nodiscard]] std::optional<int> watcher() const;
    void watch(bool on);
    void wire();

    Session& m_session;
    ViewGrid& m_views;
    WindowActions& m_actions;
    QWidget* m_window;
    ScreenshotTaker& m_screenshots;
    SectionDialog* m_clippingPlane = nullptr;  ///< made when it is first opened
    QSettings m_settings;
};

}  // namespace cullscope::ui
