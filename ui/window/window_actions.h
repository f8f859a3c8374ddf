#pragma once

#include <QAction>
#include <QActionGroup>
#include <QMenu>
#include <QMenuBar>
#include <QToolBar>
#include <QWidget>
#include <memory>
#include <string>
#include <vector>

#include "core/visibility/show.h"

namespace cullscope::ui {

/// All actions of the window, with their menus, toolbar and texts. The window connects their signals.
class WindowActions : public QObject {
    Q_OBJECT

public:
    explicit WindowActions(QWidget* window);

    void fill(QMenuBar& bar);
    void fill(QToolBar& bar);
    /// Sets the texts in the present language and fills the Generate menu from core's list of generators.
    void retranslate();
    /// Enables the actions of pictures. `scene`: a scene is open. `model`: the active view shows a model in spherical
    /// coordinates, which disables the actions that need a camera's picture and gives the reason.
    void setPictureUsable(bool scene, bool model);
    /// Why an action is disabled while a view shows a model in spherical coordinates.
    [[nodiscard]] static QString modelStandsInPlace();

    // File
    QAction *open, *saveSession, *saveSessionAs, *screenshot, *screenshotNow, *screenshotBare, *quit;
    QMenu *generate, *recent;
    QMenu* lessons;
    QAction *openLesson, *addLessonStep, *handout;
    QAction *lessonOn, *lessonBack, *lessonFirst, *lessonLast, *leaveLesson;  ///< only in a lesson
    // Edit: the undo recorder sets their texts, which name the step
    QAction *undo, *redo;
    // View
    QAction *oneView, *twoViews, *fourViews, *sixViews, *eightViews;
    QAction *home, *frame;
    QAction *upY, *upZ;
    QAction *stepThrough, *questionFirst;
    QAction *stepOn, *stepBack, *stepFirst, *stepLast, *stepToBreakpoint, *stepBackToBreakpoint;  ///< only while stepping
    QAction *lecture, *resetLayout;
    QAction *reproduce, *figures, *stability, *advise, *worst, *reports;
    QAction *systemAppearance, *lightAppearance, *darkAppearance;
    QMenu* bookmarks;
    QMenu* lookFrom;  ///< filled from namedViews()
    QAction* clippingPlane;
    QAction *perspective, *parallel;  ///< for the active view
    QMenu* pictureSize;               ///< of all views
    /// Menu for the docks' toggle actions.
    QMenu* panels;
    // Picture: actions for the active view
    QAction *freeze, *watch, *truth, *loss, *nextLoss, *loupe, *axes;
    /// What a picture shows or not (visibility/show.h), in the order of the menu.
    std::vector<std::pair<const Show*, QAction*>> shows;
    [[nodiscard]] QAction* show(const std::string& id) const;
    // Path
    QAction *record, *addPose, *savePath, *openPath, *play, *stop, *poseOn, *poseBack;
    QMenu* builtInPaths;  ///< filled from core's list
    // Help
    QAction *help, *keys, *about;
    QActionGroup *views, *upAxis, *projection, *languages, *appearance;

    /// Gives the key that changes the projection to the one that is not in use.
    void offerProjection(QAction& other);

signals:
    /// A generator of core's list was chosen.
    void generatorChosen(int index);
    /// A view of namedViews() was chosen.
    void namedViewChosen(int index);
    /// A built-in path was chosen: its name with a number of poses, where it takes one.
    void builtInPathChosen(const QString& name);
    void languageChosen(const QString& id);

private:
    QAction* command(const QKeySequence& shortcut, const QString& icon = {});
    /// Makes a checkable action.
    QAction* toggle(const QKeySequence& shortcut, const QString& icon = {});
    void makeFile();
    void makeView();
    void makePicture();
    void retranslateFile();
    void retranslateView();
    void retranslatePicture();
    /// The actions that need a camera's picture.
    [[nodiscard]] QList<QAction*> ofCameraPictures() const;
    QAction* option(QActionGroup* group, const QString& data, const QKeySequence& shortcut = {}, const QString& icon = {});
    void makeLanguages();
    void fillGenerate();
    void fillPaths();
    void fillLookFrom();

    QWidget* m_window;
    bool m_modelShown = false;  ///< the active view shows a model in spherical coordinates
    QMenu *m_editMenu, *m_fileMenu, *m_viewMenu, *m_pictureMenu, *m_pathMenu, *m_upMenu, *m_projectionMenu, *m_appearanceMenu,
        *m_languageMenu, *m_helpMenu;
};

}  // namespace cullscope::ui
