#pragma once

#include <QAction>
#include <QActionGroup>
#include <QMenu>
#include <QMenuBar>
#include <QToolBar>
#include <QWidget>
#include <memory>

namespace cullscope::ui {

/// Every command of the window, its place in menus and toolbar, and its words. What a command does is wired by the window.
class WindowActions : public QObject {
    Q_OBJECT

public:
    explicit WindowActions(QWidget* window);

    void fill(QMenuBar& bar);
    void fill(QToolBar& bar);
    /// Words, and the Generate menu from the scene generators.
    void retranslate();
    /// Greys what has no place over a model in spherical coordinates and says so, while the active view shows one; the rest of
    /// the pictures' commands is to be used where there is a `scene`.
    void setPictureUsable(bool scene, bool model);
    /// Why a command is grey while a view shows a model in spherical coordinates.
    [[nodiscard]] static QString modelStandsInPlace();

    // File
    QAction *open, *saveSession, *saveSessionAs, *screenshot, *screenshotNow, *screenshotBare, *quit;
    QMenu *generate, *recent;
    // Edit: their words say what they undo, and come from the undo recorder
    QAction *undo, *redo;
    // View
    QAction *oneView, *twoViews, *fourViews, *eightViews;
    QAction *home, *frame;
    QAction *upY, *upZ;
    QAction *lecture, *resetLayout;
    QAction* reproduce;
    QAction *systemAppearance, *lightAppearance, *darkAppearance;
    QMenu* bookmarks;
    /// The docks' own actions go here.
    QMenu* panels;
    // Picture: of the active view
    QAction *freeze, *verdicts, *frustum, *boxes, *boxesByPlane, *bands, *kernel, *sphericalModel, *truth, *loss, *nextLoss,
        *loupe, *axes;
    // Path
    QAction *record, *addPose, *savePath, *openPath, *play, *stop;
    // Help
    QAction *help, *keys, *about;
    QActionGroup *views, *upAxis, *languages, *appearance;

signals:
    /// A generator of core's list was chosen.
    void generatorChosen(int index);
    void languageChosen(const QString& id);

private:
    QAction* command(const QKeySequence& shortcut, const QString& icon = {});
    /// A command that is on or off.
    QAction* toggle(const QKeySequence& shortcut, const QString& icon = {});
    void makeFile();
    void makeView();
    void makePicture();
    void retranslateFile();
    void retranslateView();
    void retranslatePicture();
    /// What needs a camera's picture.
    [[nodiscard]] QList<QAction*> ofCameraPictures() const {
        return {verdicts, frustum, boxes, boxesByPlane, bands, kernel, axes, truth, loss, nextLoss};
    }
    QAction* option(QActionGroup* group, const QString& data, const QKeySequence& shortcut = {}, const QString& icon = {});
    void makeLanguages();
    void fillGenerate();

    QWidget* m_window;
    bool m_modelShown = false;  ///< in the active view, in spherical coordinates
    QMenu *m_editMenu, *m_fileMenu, *m_viewMenu, *m_pictureMenu, *m_pathMenu, *m_upMenu, *m_appearanceMenu, *m_languageMenu,
        *m_helpMenu;
};

}  // namespace cullscope::ui
