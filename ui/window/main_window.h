#pragma once

#include <QLabel>
#include <QMainWindow>
#include <QSettings>
#include <QStackedWidget>

#include "ui/look/appearance.h"
#include "ui/panels/empty_state.h"
#include "ui/panels/legend_panel.h"
#include "ui/panels/lesson_bar.h"
#include "ui/panels/loading_strip.h"
#include "ui/panels/message_bar.h"
#include "ui/panels/metrics_panel.h"
#include "ui/panels/path_bar.h"
#include "ui/panels/question_bar.h"
#include "ui/panels/question_tree.h"
#include "ui/panels/scene_panel.h"
#include "ui/panels/step_bar.h"
#include "ui/panels/strategy_panel.h"
#include "ui/panels/structure_panel.h"
#include "ui/session/session.h"
#include "ui/session/snapshot_reader.h"
#include "ui/text/language.h"
#include "ui/views/view_grid.h"
#include "ui/window/document_commands.h"
#include "ui/window/floating_docks.h"
#include "ui/window/lecture_window.h"
#include "ui/window/legend_strip.h"
#include "ui/window/lesson_commands.h"
#include "ui/window/paper_commands.h"
#include "ui/window/path_commands.h"
#include "ui/window/placed_panels.h"
#include "ui/window/presenter_page.h"
#include "ui/window/side_panel.h"
#include "ui/window/statistics_dock.h"
#include "ui/window/step_commands.h"
#include "ui/window/view_commands.h"
#include "ui/window/window_actions.h"
#include "ui/window/window_memory.h"

class QDockWidget;
class QScrollArea;
class QTabWidget;
class QToolBar;
class QVBoxLayout;

namespace cullscope::ui {

/// The main window: arranges views and panels around a session and connects the commands. Holds no part of the document.
class MainWindow : public QMainWindow {
    Q_OBJECT

public:
    MainWindow(Session& session, Language& language, Appearance& appearance, QWidget* parent = nullptr);
    ~MainWindow() override;

    [[nodiscard]] ViewGrid& views() { return *m_views; }
    [[nodiscard]] SidePanel& side() { return *m_side; }
    [[nodiscard]] WindowActions& actions() { return *m_actions; }
    [[nodiscard]] MessageBar& message() { return *m_message; }
    [[nodiscard]] StrategyPanel& strategyPanel() { return *m_strategy; }
    [[nodiscard]] LegendPanel& legend() { return *m_legend; }
    /// The row below the views that explains colours where the legend is folded away.
    [[nodiscard]] LegendStrip& legendStrip() { return *m_colours; }
    [[nodiscard]] MetricsPanel& figures() { return *m_figures; }
    /// The lecture's window; null: no lecture is running.
    [[nodiscard]] LectureWindow* lecture() { return m_lecture; }
    [[nodiscard]] QTabWidget& tabs() { return *m_tabs; }
    [[nodiscard]] StructurePanel& structurePanel() { return *m_structure; }
    [[nodiscard]] DocumentCommands& document() { return *m_document; }
    [[nodiscard]] PathCommands& paths() { return *m_paths; }
    [[nodiscard]] StatisticsDock& statistics() { return *m_statistics; }
    [[nodiscard]] Stepper& stepper() { return m_steps->stepper(); }
    [[nodiscard]] StepBar& stepBar() { return *m_stepBar; }
    [[nodiscard]] PathBar& pathBar() { return *m_pathBar; }
    [[nodiscard]] QuestionBar& questionBar() { return *m_questionBar; }
    [[nodiscard]] QuestionTree& questionTree() { return *m_questionTree; }
    [[nodiscard]] PaperCommands& papers() { return *m_papers; }
    [[nodiscard]] LessonCommands& lessons() { return *m_lessons; }
    [[nodiscard]] PresenterPage& presenter() { return *m_presenter; }
    [[nodiscard]] LessonBar& lessonBar() { return *m_lessonBar; }

    /// Restores geometry, panels and, if `viewCount`, the number of views from the last start. Returns false if none are stored.
    bool restoreLayout(bool viewCount);
    /// Whether the layout is stored when the window is closed.
    void setKeepsLayout(bool keeps) { m_keepsLayout = keeps; }

protected:
    void closeEvent(QCloseEvent* event) override;
    void changeEvent(QEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void dragEnterEvent(QDragEnterEvent* event) override;
    void dropEvent(QDropEvent* event) override;

private:
    static constexpr int kDockWidth = 400;
    static constexpr int kStrategyPage = 0;
    static constexpr const char* kLectureArrangement = "lecture";

    void makeCentre();
    void makeSide();
    void makeDocks();
    void fixBarHeights();
    void addRailButton(QAction* action);
    void makeStatusBar();
    void wireCommands();
    void wireSession();
    /// Arranges the panels. With at most two views (explore) all panels are docked; with more (compare) they are folded into
    /// rails, from which they open over the views.
    void arrange();
    void showRightRail();
    void wireLegend();
    void explainColours();
    void resetLayout();
    /// The id of the window's arrangement, as stored in sessions and settings.
    [[nodiscard]] QString arrangement() const;
    void showState();
    /// What a state says of the window's panels and of stepping.
    void showPanels(const SessionState& state);
    void retranslate();
    void generate(int generator);
    void beginLecture();
    void showHelp();

    Session& m_session;
    Language& m_language;
    Appearance& m_appearance;
    WindowActions* m_actions;
    QToolBar* m_toolBar;
    MessageBar* m_message;
    QVBoxLayout* m_middle = nullptr;  ///< the views with what lies over and under them
    QStackedWidget* m_stack;
    EmptyState* m_empty;
    ViewGrid* m_views;
    ViewCommands* m_viewCommands;
    StepCommands* m_steps;
    StepBar* m_stepBar;
    PathBar* m_pathBar;
    QuestionBar* m_questionBar;
    QuestionTree* m_questionTree;
    QWidget* m_answers;  ///< what a question hides
    SidePanel* m_side;
    LectureWindow* m_lecture = nullptr;
    LegendStrip* m_colours;  ///< explains colours where the panel "Inside" does not
    QWidget* m_rightRail;
    QDockWidget* m_dock;
    QScrollArea* m_dockScroll;
    StrategyPanel* m_strategy;
    QTabWidget* m_tabs;
    SnapshotReader* m_reader;
    StructurePanel* m_structure;
    Experiments* m_experiments;
    StatisticsDock* m_statistics;
    FloatingDocks* m_floatingDocks;
    PlacedPanels* m_panels;
    DocumentCommands* m_document;
    PathCommands* m_paths;
    PaperCommands* m_papers;
    LessonCommands* m_lessons;
    LessonBar* m_lessonBar;
    PresenterPage* m_presenter = nullptr;
    MetricsPanel* m_figures;
    ScenePanel* m_scene;
    LegendPanel* m_legend;
    LoadingStrip* m_loading;
    QLabel* m_gl;
    QLabel* m_software;
    QSettings m_settings;
    std::unique_ptr<WindowMemory> m_memory;
    bool m_keepsLayout = false;
    std::optional<bool> m_arrangedCompare, m_arrangedWide;  ///< the state that the panels are arranged for
};

}  // namespace cullscope::ui
