#include "ui/window_actions.h"

#include <QRegularExpression>

#include "core/scene/scene_source.h"
#include "ui/text/language.h"
#include "ui/text/translated.h"
#include "ui/views/tinted_icon.h"

namespace cullscope::ui {

namespace {

/// A menu's words as a toolbar shows them: without the letter to press, which Korean and Chinese put in parentheses.
QString withoutMnemonic(QString text) {
    static const QRegularExpression inParentheses(QStringLiteral("\\(&.\\)"));
    return text.remove(inParentheses).remove(QLatin1Char('&')).remove(QChar(u'…'));
}

}  // namespace

WindowActions::WindowActions(QWidget* window) : QObject(window), m_window(window) {
    views = new QActionGroup(this);
    upAxis = new QActionGroup(this);
    languages = new QActionGroup(this);
    appearance = new QActionGroup(this);
    generate = new QMenu(window);
    viewMenu = new QMenu(window);
    m_fileMenu = new QMenu(window);
    m_upMenu = new QMenu(window);
    m_appearanceMenu = new QMenu(window);
    m_languageMenu = new QMenu(window);
    m_helpMenu = new QMenu(window);

    open = command(QKeySequence::Open, QStringLiteral("open"));
    quit = command(QKeySequence::Quit);
    oneView = option(views, QStringLiteral("1"), Qt::CTRL | Qt::Key_1, QStringLiteral("one-view"));
    twoViews = option(views, QStringLiteral("2"), Qt::CTRL | Qt::Key_2, QStringLiteral("two-views"));
    home = command(Qt::Key_Home, QStringLiteral("home"));
    frame = command(Qt::Key_Period, QStringLiteral("frame"));
    upY = option(upAxis, QStringLiteral("y"));
    upZ = option(upAxis, QStringLiteral("z"));
    systemAppearance = option(appearance, QStringLiteral("system"));
    lightAppearance = option(appearance, QStringLiteral("light"));
    darkAppearance = option(appearance, QStringLiteral("dark"));
    keys = command(Qt::Key_H, QStringLiteral("keys"));
    about = command({});
    about->setMenuRole(QAction::AboutRole);
    makeLanguages();
    retranslate();
}

QAction* WindowActions::command(const QKeySequence& shortcut, const QString& icon) {
    auto* action = new QAction(m_window);
    action->setShortcut(shortcut);
    if (!icon.isEmpty()) action->setIcon(tintedIcon(icon));
    m_window->addAction(action);
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
    m_fileMenu->addMenu(generate);
    m_fileMenu->addSeparator();
    m_fileMenu->addAction(quit);
    viewMenu->addActions(views->actions());
    viewMenu->addSeparator();
    viewMenu->addActions({home, frame});
    viewMenu->addMenu(m_upMenu);
    m_upMenu->addActions(upAxis->actions());
    viewMenu->addSeparator();
    viewMenu->addMenu(m_appearanceMenu);
    m_appearanceMenu->addActions(appearance->actions());
    m_languageMenu->addActions(languages->actions());
    m_helpMenu->addActions({keys, about});
    for (QMenu* menu : {m_fileMenu, viewMenu, m_languageMenu, m_helpMenu}) bar.addMenu(menu);
}

void WindowActions::fill(QToolBar& bar) {
    bar.addAction(open);
    bar.addAction(generate->menuAction());
    bar.addSeparator();
    bar.addActions(views->actions());
    bar.addSeparator();
    bar.addActions({home, frame});
    bar.addSeparator();
    bar.addAction(keys);
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

void WindowActions::retranslate() {
    const auto say = [](QAction* action, const QString& text, const QString& tip) {
        action->setText(text);
        action->setIconText(withoutMnemonic(text));
        action->setToolTip(action->shortcut().isEmpty()
                               ? tip
                               : QStringLiteral("%1 (%2)").arg(tip, action->shortcut().toString(QKeySequence::NativeText)));
    };
    m_fileMenu->setTitle(tr("&File"));
    viewMenu->setTitle(tr("&View"));
    m_upMenu->setTitle(tr("&Up axis"));
    m_appearanceMenu->setTitle(tr("&Appearance"));
    // The English word stays beside the translation, so that the menu can be found again from any language.
    m_languageMenu->setTitle(tr("&Language"));
    m_helpMenu->setTitle(tr("&Help"));
    generate->setTitle(tr("&Generate"));
    generate->menuAction()->setIconText(withoutMnemonic(generate->title()));
    generate->setIcon(tintedIcon(QStringLiteral("generate")));
    say(open, tr("&Open…"), tr("Open a mesh file"));
    say(quit, tr("&Quit"), tr("Leave the program"));
    say(oneView, tr("&1 view"), tr("Show one view"));
    say(twoViews, tr("&2 views"), tr("Show two views beside each other"));
    say(home, tr("&Home"), tr("Back to the first view of the scene"));
    say(frame, tr("&Frame the scene"), tr("Show the whole scene from the present direction"));
    say(upY, tr("&y up"), tr("The y axis points up"));
    say(upZ, tr("&z up"), tr("The z axis points up"));
    say(systemAppearance, tr("As the &system"), tr("Light or dark as the system is set"));
    say(lightAppearance, tr("&Light"), tr("Dark on light"));
    say(darkAppearance, tr("&Dark"), tr("Light on dark"));
    say(keys, tr("Mouse and &keys"), tr("Show all mouse moves and keys"));
    say(about, tr("&About Cullscope"), tr("Version and licences"));
    fillGenerate();
}

}  // namespace cullscope::ui
