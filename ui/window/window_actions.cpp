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

namespace {

/// A menu text as a toolbar shows it: without the mnemonic, which Korean and Chinese put in parentheses.
QString withoutMnemonic(QString text) {
    static const QRegularExpression inParentheses(QStringLiteral("\\(&.\\)"));
    return text.remove(inParentheses).remove(QLatin1Char('&')).remove(QChar(u'…'));
}

/// Sets an action's text; its tooltip names the shortcut.
void say(QAction* action, const QString& text, const QString& tip) {
    action->setText(text);
    action->setIconText(withoutMnemonic(text));
    action->setToolTip(action->shortcut().isEmpty()
                           ? tip
                           : QStringLiteral("%1 (%2)").arg(tip, action->shortcut().toString(QKeySequence::NativeText)));
}

}  // namespace

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
    stability = command({});
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
    m_viewMenu->addActions({lecture, stepThrough, questionFirst, reproduce, stability});
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

void WindowActions::retranslate() {
    m_fileMenu->setTitle(tr("&File"));
    m_editMenu->setTitle(tr("&Edit"));
    m_viewMenu->setTitle(tr("&View"));
    m_pictureMenu->setTitle(tr("&Picture"));
    m_pathMenu->setTitle(tr("P&ath"));
    // The English word stays beside the translation, so that the user finds the menu in any language.
    m_languageMenu->setTitle(tr("&Language"));
    m_helpMenu->setTitle(tr("&Help"));
    retranslateFile();
    retranslateView();
    retranslatePicture();
    say(keys, tr("Mouse and &keys"), tr("Show all mouse moves and keys"));
    say(help, tr("&Help"), tr("What the views, panels and figures mean"));
    say(about, tr("&About Cullscope"), tr("Version and licences"));
    fillGenerate();
    fillPaths();
    fillLookFrom();
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

void WindowActions::retranslateFile() {
    generate->setTitle(tr("&Generate"));
    generate->menuAction()->setIconText(withoutMnemonic(generate->title()));
    generate->setIcon(tintedIcon(QStringLiteral("generate")));
    recent->setTitle(tr("Open &recent"));
    lessons->setTitle(tr("&Lessons"));
    say(openLesson, tr("&Open a lesson…"), tr("Open a lesson's file"));
    say(addLessonStep, tr("&Add as step…"), tr("Add what the window shows to a lesson of your own"));
    say(handout, tr("&Handout…"), tr("Save all steps of the lesson as a PDF or HTML file: picture, sentence and figures"));
    say(lessonOn, tr("Next step"), tr("Go on to the lesson's next step"));
    say(lessonBack, tr("Step before"), tr("Go back to the lesson's step before"));
    say(lessonFirst, tr("First step"), tr("Go to the lesson's first step"));
    say(lessonLast, tr("Last step"), tr("Go to the lesson's last step"));
    say(leaveLesson, tr("&Leave the lesson"), tr("Leave the lesson: what is shown stays"));
    say(open, tr("&Open…"), tr("Open a mesh file, a session, or a picture that Cullscope took"));
    say(saveSession, tr("&Save the session"), tr("Save scene, views, strategies and cameras as a file"));
    say(saveSessionAs, tr("Save the session &as…"), tr("Save the session under another name"));
    say(screenshot, tr("S&creenshot…"), tr("Save a picture of the views: size, format, legend, background"));
    say(screenshotNow, tr("Screenshot a&gain"), tr("Save a picture as the last time"));
    say(screenshotBare, tr("Screenshot &without overlays"), tr("Save a picture of what was drawn and nothing over it"));
    say(quit, tr("&Quit"), tr("Leave the program"));
}

void WindowActions::retranslateView() {
    m_upMenu->setTitle(tr("&Up axis"));
    m_appearanceMenu->setTitle(tr("&Appearance"));
    bookmarks->setTitle(tr("Camera &bookmarks"));
    lookFrom->setTitle(tr("Look &from"));
    m_projectionMenu->setTitle(tr("Pro&jection"));
    say(perspective, tr("&Perspective"), tr("Lines of sight meet in the eye: what is farther is smaller"));
    say(parallel, tr("P&arallel"), tr("Lines of sight run side by side: sizes do not depend on the distance (orthographic)"));
    say(clippingPlane, tr("Clippin&g plane…"), tr("Cut the pictures by a plane, to look inside: a section"));
    pictureSize->setTitle(tr("Picture si&ze"));
    panels->setTitle(tr("&Panels"));
    say(oneView, tr("&1 view"), tr("Show one view"));
    say(twoViews, tr("&2 views"), tr("Show two views beside each other"));
    say(fourViews, tr("&4 views"), tr("Compare four views"));
    say(sixViews, tr("&6 views"), tr("Compare six views: three columns"));
    say(eightViews, tr("&8 views"), tr("Compare eight views"));
    say(home, tr("&Home"), tr("Back to the first view of the scene"));
    say(frame, tr("&Frame the scene"), tr("Show the whole scene from the present direction"));
    say(upY, tr("&y up"), tr("The y axis points up"));
    say(upZ, tr("&z up"), tr("The z axis points up"));
    say(lecture, tr("&Lecture"), tr("Show the active view full screen, large enough for the back row"));
    say(stepThrough, tr("S&tep through"), tr("Replay the active view's frame step by step, with what the strategy decides"));
    say(questionFirst, tr("&Question first"),
        tr("Hide figures and verdicts until what the audience expects was clicked, then reveal both beside each other"));
    say(stepOn, tr("One step on"), {});
    say(stepBack, tr("One step back"), {});
    say(stepFirst, tr("To the first step"), {});
    say(stepLast, tr("To the last step"), {});
    say(stepToBreakpoint, tr("On to the next breakpoint"), {});
    say(stepBackToBreakpoint, tr("Back to the last breakpoint"), {});
    say(reproduce, tr("Repro&duce a paper's table…"),
        tr("Measure what a paper's table shows, in the paper's windows, and put its numbers beside ours"));
    say(stability, tr("Sta&bility…"), tr("Run the battery of extreme cases, and open their scenes"));
    say(resetLayout, tr("&Reset the layout"), tr("Put all panels back to their places"));
    say(systemAppearance, tr("As the &system"), tr("Light or dark as the system is set"));
    say(lightAppearance, tr("&Light"), tr("Dark on light"));
    say(darkAppearance, tr("&Dark"), tr("Light on dark"));
}

void WindowActions::retranslatePicture() {
    say(freeze, tr("&Freeze culling"), tr("The culling camera stands while you fly on in the active view"));
    say(watch, tr("&Watch from outside"), tr("Another view shows from outside what the active view culls; again: it is linked"));
    for (const auto& [show, action] : shows) say(action, translated(show->action), translated(show->explanation));
    say(truth, tr("Wipe: &truth | strategy"), tr("Put the truth beside the strategy's picture; drag the line"));
    say(loss, tr("&Missed pixels"), tr("Mark the pixels that the strategy missed or added"));
    say(nextLoss, tr("&Next loss"), tr("Go to the next lost pixels, largest hole first"));
    say(axes, tr("A&xes"), tr("Show the axes in a corner of each view; a click on an end looks from there"));
    say(loupe, tr("&Loupe"), tr("Enlarge what is under the pointer"));
    if (m_modelShown)
        for (QAction* action : ofCameraPictures()) action->setToolTip(modelStandsInPlace());
    say(record, tr("&Record"), tr("Record the camera's moves as a path"));
    say(addPose, tr("&Add this pose"), tr("Add the present camera to the path"));
    say(savePath, tr("&Save the path…"), tr("Save the recorded path as a file"));
    say(openPath, tr("&Open a path…"), tr("Open a camera path to play it"));
    say(play, tr("&Play"), tr("Play the path, a picture of every view at every pose"));
    say(stop, tr("S&top"), tr("Stop recording and playing"));
    say(poseOn, tr("One pose o&n"), tr("Show the next pose of the path, without measuring"));
    say(poseBack, tr("One pose bac&k"), tr("Show the pose before, without measuring"));
    builtInPaths->setTitle(tr("&Built-in paths"));
}

}  // namespace cullscope::ui
