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

    QAction *open, *quit;
    QAction *oneView, *twoViews;
    QAction *home, *frame;
    QAction *upY, *upZ;
    QAction *systemAppearance, *lightAppearance, *darkAppearance;
    QAction *keys, *about;
    QActionGroup *views, *upAxis, *languages, *appearance;
    QMenu* generate;
    /// The docks' own actions go here.
    QMenu* viewMenu;

signals:
    /// A generator of core's list was chosen.
    void generatorChosen(int index);
    void languageChosen(const QString& id);

private:
    QAction* command(const QKeySequence& shortcut, const QString& icon = {});
    QAction* option(QActionGroup* group, const QString& data, const QKeySequence& shortcut = {}, const QString& icon = {});
    void makeLanguages();
    void fillGenerate();

    QWidget* m_window;
    QMenu *m_fileMenu, *m_upMenu, *m_appearanceMenu, *m_languageMenu, *m_helpMenu;
};

}  // namespace cullscope::ui
