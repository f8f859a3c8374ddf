#pragma once

#include <QLabel>
#include <QMainWindow>
#include <QSettings>
#include <QStackedWidget>

#include "ui/panels/empty_state.h"
#include "ui/panels/figure_panel.h"
#include "ui/panels/legend_panel.h"
#include "ui/panels/loading_strip.h"
#include "ui/panels/message_bar.h"
#include "ui/panels/scene_panel.h"
#include "ui/panels/strategy_panel.h"
#include "ui/session/session.h"
#include "ui/startup/appearance.h"
#include "ui/text/language.h"
#include "ui/views/view_pane.h"
#include "ui/window_actions.h"

class QDockWidget;
class QScrollArea;
class QTabWidget;
class QToolBar;

namespace cullscope::ui {

/// The window: arranges views and panels around a session and wires the commands. Owns none of what it shows.
class MainWindow : public QMainWindow {
    Q_OBJECT

public:
    MainWindow(Session& session, Language& language, Appearance& appearance, QWidget* parent = nullptr);

    [[nodiscard]] ViewGrid& views() { return *m_views; }
    [[nodiscard]] WindowActions& actions() { return *m_actions; }
    [[nodiscard]] MessageBar& message() { return *m_message; }
    [[nodiscard]] StrategyPanel& strategyPanel() { return *m_strategy; }
    [[nodiscard]] LegendPanel& legend() { return *m_legend; }
    [[nodiscard]] FigurePanel& figures() { return *m_figures; }
    [[nodiscard]] QTabWidget& tabs() { return *m_tabs; }
    /// The types that the dialog for opening offers, as QFileDialog takes them.
    [[nodiscard]] static QString meshFileTypes();

protected:
    void changeEvent(QEvent* event) override;
    void dragEnterEvent(QDragEnterEvent* event) override;
    void dropEvent(QDropEvent* event) override;

private:
    void makeCentre();
    void makeDock();
    void makeStatusBar();
    void wireCommands();
    void wireSession();
    void showState();
    void retranslate();
    void openByDialog();
    void generate(int generator);
    void showMenuOf(int view, const QPoint& position);

    Session& m_session;
    Language& m_language;
    Appearance& m_appearance;
    WindowActions* m_actions;
    QToolBar* m_toolBar;
    MessageBar* m_message;
    QStackedWidget* m_stack;
    EmptyState* m_empty;
    ViewGrid* m_views;
    QDockWidget* m_dock;
    QScrollArea* m_dockScroll;
    StrategyPanel* m_strategy;
    QTabWidget* m_tabs;
    FigurePanel* m_figures;
    ScenePanel* m_scene;
    LegendPanel* m_legend;
    LoadingStrip* m_loading;
    QLabel* m_gl;
    QLabel* m_software;
    QSettings m_settings;
};

}  // namespace cullscope::ui
