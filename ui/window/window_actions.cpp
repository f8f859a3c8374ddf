#include "ui/window/window_actions.h"

#include <QRegularExpression>
#include <algorithm>

#include "core/scene/camera_path.h"
#include "core/scene/scene_source.h"
#include "core/visibility/registry.h"
#include "ui/look/tinted_icon.h"
#include "ui/session/named_views.h"
#include "ui/text/language.h"
#include "ui/text/translated.h"

namespace cullscope::ui {

WindowActions::WindowActions(QWidget* window) : QObject(window), m_window(window) {
    views = new QActionGroup(this);
    upAxis = new QActionGroup(this);
    projection = new QActionGroup(this);
    languages = new QActionGroup(this);
    appearance = new QActionGroup(this);
    for (QMenu** menu : {&generate, &builtInPaths, &recent, &lessons, &m_editMenu, &bookmarks, &lookFrom, &pictureSize, &panels,
                         &m_fileMenu, &m_viewMenu, &m_pictureMenu, &m_pathMenu, &m_upMenu, &m_projectionMenu, &m_appearanceMenu,
                         &m_languageMenu, &m_helpMenu})
        *menu = new QMenu(window);
    makeFile();
    makeView();
    makePicture();
    keys = command(Qt::Key_H, QStringLiteral("keys"));
    help = command(QKeySequence::HelpContents, QStringLiteral("help"));
    about = command({});
    about->setMenuRole(QAction::AboutRole);
    makeLanguages();
    retranslate();
}

void WindowActions::makeFile() {
    open = command(QKeySequence::Open, QStringLiteral("open"));
    saveSession = command(QKeySequence::Save, QStringLiteral("save"));
    saveSessionAs = command(QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_S));
    screenshot = command(QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_F12), QStringLiteral("screenshot"));
    screenshotNow = command(Qt::Key_F12);
    screenshotBare = command(QKeySequence(Qt::CTRL | Qt::Key_F12));
    quit = command(QKeySequence::Quit);
    openLesson = command({});
    addLessonStep = command({});
    handout = command({});
    lessonOn = command(Qt::Key_PageDown);
    lessonBack = command(Qt::Key_PageUp);
    lessonFirst = command(QKeySequence(Qt::CTRL | Qt::Key_Home));
    lessonLast = command(QKeySequence(Qt::CTRL | Qt::Key_End));
    leaveLesson = command({});
    undo = command(QKeySequence::Undo, QStringLiteral("undo"));
    redo = command(QKeySequence::Redo, QStringLiteral("redo"));
}

void WindowActions::makeView() {
    oneView = option(views, QStringLiteral("1"), Qt::CTRL | Qt::Key_1, QStringLiteral("one-view"));
    twoViews = option(views, QStringLiteral("2"), Qt::CTRL | Qt::Key_2, QStringLiteral("two-views"));
    fourViews = option(views, QStringLiteral("4"), Qt::CTRL | Qt::Key_4, QStringLiteral("four-views"));
    sixViews = option(views, QStringLiteral("6"), Qt::CTRL | Qt::Key_6, QStringLiteral("six-views"));
    eightViews = option(views, QStringLiteral("8"), Qt::CTRL | Qt::Key_8, QStringLiteral("eight-views"));
    home = command(Qt::Key_Home, QStringLiteral("home"));
    frame = command(Qt::Key_Period, QStringLiteral("frame"));
    perspective = option(projection, QStringLiteral("perspective"));
    parallel = option(projection, QStringLiteral("parallel"));
    clippingPlane = command({});
    upY = option(upAxis, QStringLiteral("y"));
    upZ = option(upAxis, QStringLiteral("z"));
    stepThrough = toggle(Qt::Key_F8, QStringLiteral("step-forward"));
    questionFirst = toggle(Qt::Key_F9);
    stepOn = command(Qt::Key_PageDown);
    stepBack = command(Qt::Key_PageUp);
    stepFirst = command(QKeySequence(Qt::SHIFT | Qt::Key_PageUp));
    stepLast = command(QKeySequence(Qt::SHIFT | Qt::Key_PageDown));
    stepToBreakpoint = command(QKeySequence(Qt::CTRL | Qt::Key_PageDown));
    stepBackToBreakpoint = command(QKeySequence(Qt::CTRL | Qt::Key_PageUp));
    lecture = command(Qt::Key_F5, QStringLiteral("lecture"));
    reproduce = command({});
    figures = command({});
    stability = command({});
    advise = command({});
    worst = command({});
    reports = command({});
    resetLayout = command({});
    systemAppearance = option(appearance, QStringLiteral("system"));
    lightAppearance = option(appearance, QStringLiteral("light"));
    darkAppearance = option(appearance, QStringLiteral("dark"));
}

void WindowActions::makePicture() {
    freeze = toggle(Qt::Key_F, QStringLiteral("freeze"));
    watch = toggle(Qt::Key_O);
    for (const Show* show : pictureShows())
        if (!show->action.empty())
            shows.emplace_back(show, toggle(QKeySequence(QString::fromStdString(show->key)), QString::fromStdString(show->icon)));
    truth = toggle(Qt::Key_T, QStringLiteral("wipe"));
    loss = toggle(Qt::Key_M);
    // One comparison at most; the chosen one can be chosen again, to end it.
    auto* comparisons = new QActionGroup(this);
    comparisons->setExclusionPolicy(QActionGroup::ExclusionPolicy::ExclusiveOptional);
    for (QAction* action : {truth, loss}) comparisons->addAction(action);
    nextLoss = command(Qt::Key_N);
    loupe = toggle(Qt::Key_L);
    axes = toggle(Qt::Key_X);
    record = toggle({});
    addPose = command(QKeySequence(Qt::CTRL | Qt::Key_K));
    savePath = command({});
    openPath = command({});
    play = toggle(Qt::Key_Space);
    stop = command({});
    poseOn = command(QKeySequence(Qt::ALT | Qt::Key_Right));
    poseBack = command(QKeySequence(Qt::ALT | Qt::Key_Left));
}

QAction* WindowActions::command(const QKeySequence& shortcut, const QString& icon) {
    auto* action = new QAction(m_window);
    action->setShortcut(shortcut);
    if (!icon.isEmpty()) action->setIcon(tintedIcon(icon));
    m_window->addAction(action);
    return action;
}

QAction* WindowActions::show(const std::string& id) const {
    const auto found = std::ranges::find_if(shows, [&](const auto& entry) { return entry.first->id == id; });
    return found == shows.end() ? nullptr : found->second;
}

void WindowActions::offerProjection(QAction& other) {
    for (QAction* action : projection->actions())
        action->setShortcut(action == &other ? QKeySequence(Qt::Key_5) : QKeySequence());
}

QList<QAction*> WindowActions::ofCameraPictures() const {
    QList<QAction*> actions;
    for (const auto& [show, action] : shows)
        if (!show->inPlace()) actions << action;
    return actions << axes << truth << loss << nextLoss;
}

QAction* WindowActions::toggle(const QKeySequence& shortcut, const QString& icon) {
    QAction* action = command(shortcut, icon);
    action->setCheckable(true);
    // In a menu the box that is checked stands in the icon's place.
    action->setIconVisibleInMenu(false);
    return action;
}

QAction* WindowActions::option(QActionGroup* group, const QString& data, const QKeySequence& shortcut, const QString& icon) {
    QAction* action = command(shortcut, icon);
    action->setCheckable(true);
    action->setData(data);
    group->addAction(action);
    return action;
}

void WindowActions::makeLanguages() {
    for (const Language::Known& language : Language::known()) {
        QAction* action = option(languages, language.id);
        action->setText(language.nativeName);
        connect(action, &QAction::triggered, this, [this, id = language.id] { emit languageChosen(id); });
    }
}

void WindowActions::fill(QMenuBar& bar) {
    m_fileMenu->addAction(open);
    m_fileMenu->addMenu(recent);
    m_fileMenu->addMenu(generate);
    m_fileMenu->addMenu(lessons);
    m_fileMenu->addSeparator();
    m_fileMenu->addActions({saveSession, saveSessionAs});
    m_fileMenu->addSeparator();
    m_fileMenu->addActions({screenshot, screenshotNow, screenshotBare});
    m_fileMenu->addSeparator();
    m_fileMenu->addAction(quit);
    m_editMenu->addActions({undo, redo});
    m_viewMenu->addActions(views->actions());
    m_viewMenu->addActions({lecture, stepThrough, questionFirst, reproduce, figures, stability, advise, worst, reports});
    m_viewMenu->addSeparator();
    m_viewMenu->addActions({home, frame});
    m_viewMenu->addMenu(lookFrom);
    m_viewMenu->addMenu(m_projectionMenu);
    m_projectionMenu->addActions(projection->actions());
    m_viewMenu->addAction(clippingPlane);
    m_viewMenu->addMenu(bookmarks);
    m_viewMenu->addMenu(pictureSize);
    m_viewMenu->addMenu(m_upMenu);
    m_upMenu->addActions(upAxis->actions());
    m_viewMenu->addSeparator();
    m_viewMenu->addMenu(panels);
    m_viewMenu->addAction(resetLayout);
    m_viewMenu->addMenu(m_appearanceMenu);
    m_appearanceMenu->addActions(appearance->actions());
    m_pictureMenu->addActions({freeze, watch});
    for (const auto& [show, action] : shows) m_pictureMenu->addAction(action);
    m_pictureMenu->addAction(axes);
    m_pictureMenu->setToolTipsVisible(true);
    m_pictureMenu->addSeparator();
    m_pictureMenu->addActions({truth, loss, nextLoss, loupe});
    m_pathMenu->addActions({record, addPose, savePath});
    m_pathMenu->addSeparator();
    m_pathMenu->addMenu(builtInPaths);
    m_pathMenu->addActions({openPath, play, poseOn, poseBack, stop});
    m_languageMenu->addActions(languages->actions());
    m_helpMenu->addActions({help, keys, about});
    for (QMenu* menu : {m_fileMenu, m_editMenu, m_viewMenu, m_pictureMenu, m_pathMenu, m_languageMenu, m_helpMenu})
        bar.addMenu(menu);
}

void WindowActions::fill(QToolBar& bar) {
    bar.addAction(open);
    bar.addAction(generate->menuAction());
    bar.addSeparator();
    bar.addActions(views->actions());
    bar.addSeparator();
    bar.addActions({home, frame});
    bar.addSeparator();
    bar.addAction(freeze);
    for (const auto& [show, action] : shows)
        if (!show->icon.empty()) bar.addAction(action);
    bar.addAction(truth);
    bar.addSeparator();
    bar.addActions({undo, redo});
    bar.addSeparator();
    bar.addActions({screenshot, lecture, keys});
    // Rarer actions show an icon only, their text is in the tooltip: the whole bar must fit the least screen in every language.
    for (QAction* action : bar.actions())
        if (auto* button = qobject_cast<QToolButton*>(bar.widgetForAction(action));
            button && action != open && action != generate->menuAction())
            button->setToolButtonStyle(Qt::ToolButtonIconOnly);
}

void WindowActions::fillGenerate() {
    generate->clear();
    generate->setToolTipsVisible(true);
    const std::vector<GeneratorInfo>& generators = sceneGenerators();
    for (size_t i = 0; i < generators.size(); ++i) {
        const GeneratorInfo& generator = generators[i];
        const QString name = QString::fromStdString(generator.id);
        QAction* action = generate->addAction(generator.parameters.empty() ? name : name + QStringLiteral("…"));
        action->setToolTip(translated(generator.description));
        connect(action, &QAction::triggered, this, [this, i] { emit generatorChosen(int(i)); });
    }
}

void WindowActions::fillPaths() {
    constexpr const char* kPoses = "16";  // as many as the command line takes of itself
    builtInPaths->clear();
    builtInPaths->setToolTipsVisible(true);
    for (const BuiltInPath& path : cullscope::builtInPaths()) {
        const QString name =
            QString::fromStdString(path.id).replace(QStringLiteral(":N"), QStringLiteral(":") + QLatin1String(kPoses));
        // Its sentence in the user's language, with the number in place of N; right of the tab the name in files.
        QString words = translated(path.description);
        static const QRegularExpression number(QStringLiteral("\\bN\\b|N(?=[^A-Za-z])"));
        words.replace(number, QLatin1String(kPoses));
        QAction* action = builtInPaths->addAction(words + QLatin1Char('\t') + name);
        action->setToolTip(translated(path.description));
        connect(action, &QAction::triggered, this, [this, name] { emit builtInPathChosen(name); });
    }
}

void WindowActions::fillLookFrom() {
    lookFrom->clear();
    for (size_t i = 0; i < namedViews().size(); ++i)
        connect(lookFrom->addAction(translated(namedViews()[i].name)), &QAction::triggered, this,
                [this, i] { emit namedViewChosen(int(i)); });
}

QString WindowActions::modelStandsInPlace() {
    return tr("Not while the view shows the model in spherical coordinates: what a camera sees has no place there");
}

void WindowActions::setPictureUsable(bool scene, bool model) {
    for (QAction* action : {freeze, watch, loupe}) action->setEnabled(scene);
    for (const auto& [show, action] : shows)
        if (show->inPlace()) action->setEnabled(scene);
    for (QAction* action : ofCameraPictures()) action->setEnabled(scene && !model);
    // The orientation gizmo does not depend on a scene: it can be switched before one is opened.
    axes->setEnabled(!model);
    if (std::exchange(m_modelShown, model) != model) retranslatePicture();
}

}  // namespace cullscope::ui
