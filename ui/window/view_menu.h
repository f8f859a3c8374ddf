#pragma once

#include <QCoreApplication>
#include <QMenu>
#include <functional>

#include "ui/views/view_pane.h"

namespace cullscope::ui {

class WindowActions;

/// A panel that can replace the picture of a view.
struct PlaceablePanel {
    std::string id;
    QString name;
};

/// Fills the menu of one view: contents, cameras, colours, comparison and size.
class ViewMenu {
    Q_DECLARE_TR_FUNCTIONS(ViewMenu)

public:
    /// `actions`: what the menu has in common with the window's menus is called as there.
    ViewMenu(Session& session, ViewPane& pane, const WindowActions& actions, QMenu& menu)
        : m_session(session), m_pane(pane), m_actions(actions), m_menu(menu) {}

    void addStrategies();
    void addCameras();
    void addLook();
    void addComparisons();
    void addSizes();
    void addUploads();
    void addPanels(const std::vector<PlaceablePanel>& panels, const std::vector<PlaceablePanel>& below);

private:
    [[nodiscard]] int view() const { return m_pane.view(); }
    [[nodiscard]] const ViewSetup& setup() const { return m_session.setup(view()); }
    QAction* option(QMenu& menu, const QString& text, bool checked, std::function<void()> choose);
    /// Adds an option that changes the view's setup.
    QAction* change(QMenu& menu, const QString& text, bool checked, const std::function<void(ViewSetup&)>& edit);
    /// Adds a submenu whose options exclude each other: they are shown as radio items.
    QMenu* addChoice(const QString& title);

    /// Disables an action with a reason if the view shows a model in spherical coordinates.
    void needsCameraPicture(QAction* action) const;

    Session& m_session;
    ViewPane& m_pane;
    const WindowActions& m_actions;
    QMenu& m_menu;
};

}  // namespace cullscope::ui
