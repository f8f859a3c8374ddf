#include "ui/window/lesson_commands.h"

#include <QFileDialog>
#include <QFileInfo>
#include <QInputDialog>
#include <QProgressDialog>

#include "core/base/error.h"

namespace cullscope::ui {

namespace {

constexpr const char* kLessonFolderSetting = "lessonFolder";

}  // namespace

LessonCommands::LessonCommands(Session& session, ViewGrid& views, WindowActions& actions, DocumentCommands& document,
                               const Language& language, QWidget* window)
    : QObject(window),
      m_session(session),
      m_actions(actions),
      m_document(document),
      m_language(language),
      m_window(window),
      m_player(new LessonPlayer(session, this)),
      m_handout(new LessonHandout(session, *m_player, views, language, this)) {
    wire();
    fillMenu();
    refresh();
}

void LessonCommands::wire() {
    connect(m_actions.openLesson, &QAction::triggered, this, &LessonCommands::openByDialog);
    connect(m_actions.addLessonStep, &QAction::triggered, this, &LessonCommands::addByDialog);
    connect(m_actions.handout, &QAction::triggered, this, &LessonCommands::makeHandout);
    connect(m_handout, &LessonHandout::failed, this,
            [this](const Message& message) { m_session.raise(Severity::Error, message); });
    connect(m_handout, &LessonHandout::done, this, [this](const QString& file) { m_session.tellSaved(file); });
    connect(m_actions.leaveLesson, &QAction::triggered, m_player, &LessonPlayer::leave);
    connect(m_actions.lessonOn, &QAction::triggered, m_player, &LessonPlayer::forward);
    connect(m_actions.lessonBack, &QAction::triggered, m_player, &LessonPlayer::back);
    connect(m_actions.lessonFirst, &QAction::triggered, m_player, [this] { m_player->go(0); });
    connect(m_actions.lessonLast, &QAction::triggered, m_player, [this] { m_player->go(m_player->count() - 1); });
    connect(m_player, &LessonPlayer::changed, this, &LessonCommands::refresh);
    // Undo leads back to the step, and not to what was before it.
    connect(m_player, &LessonPlayer::shown, &m_document.undo(), &UndoRecorder::startAnew);
    connect(&m_session, &Session::sceneChanged, this, &LessonCommands::refresh);
}

void LessonCommands::fillMenu() {
    QMenu& menu = *m_actions.lessons;
    menu.clear();
    const QStringList names = LessonPlayer::known();
    for (int i = 0; i < names.size(); ++i) {
        const QString title = QString::fromStdString(textIn(LessonPlayer::titleOf(names[i]), m_language.current().toStdString()));
        menu.addAction(QStringLiteral("&%1 %2").arg(i + 1).arg(title), m_player,
                       [this, name = names[i]] { m_player->begin(name); });
    }
    menu.addSeparator();
    menu.addActions({m_actions.openLesson, m_actions.addLessonStep, m_actions.handout});
    menu.addSeparator();
    menu.addActions(
        {m_actions.lessonOn, m_actions.lessonBack, m_actions.lessonFirst, m_actions.lessonLast, m_actions.leaveLesson});
}

void LessonCommands::openByDialog() {
    const QString folder = m_settings.value(QLatin1String(kLessonFolderSetting)).toString();
    const QString file = QFileDialog::getOpenFileName(
        m_window, tr("Open a lesson"), folder, tr("Lessons") + QStringLiteral(" (*.%1)").arg(QLatin1String(kLessonExtension)));
    if (file.isEmpty()) return;
    m_settings.setValue(QLatin1String(kLessonFolderSetting), QFileInfo(file).absolutePath());
    m_player->begin(file);
}

void LessonCommands::addByDialog() {
    bool given = false;
    const QString sentence = QInputDialog::getMultiLineText(m_window, tr("Add as step"),
                                                            tr("What is said at this step, in one sentence:"), {}, &given);
    if (!given || sentence.trimmed().isEmpty()) return;
    QString file = m_player->file();
    if (file.isEmpty()) file = m_settings.value(QLatin1String(kLessonFolderSetting)).toString();
    file = QFileDialog::getSaveFileName(m_window, tr("The lesson to which the step is added"), file,
                                        tr("Lessons") + QStringLiteral(" (*.%1)").arg(QLatin1String(kLessonExtension)), nullptr,
                                        QFileDialog::DontConfirmOverwrite);
    if (file.isEmpty()) return;
    if (QFileInfo(file).suffix().isEmpty()) file += QLatin1Char('.') + QLatin1String(kLessonExtension);
    m_settings.setValue(QLatin1String(kLessonFolderSetting), QFileInfo(file).absolutePath());
    addStep(file, sentence);
}

void LessonCommands::makeHandout() {
    const QString folder = m_settings.value(QLatin1String(kLessonFolderSetting)).toString();
    const QString file = QFileDialog::getSaveFileName(m_window, tr("Save a handout of the lesson"), folder,
                                                      tr("Handouts") + QStringLiteral(" (*.pdf *.html)"));
    if (file.isEmpty()) return;
    auto* progress =
        new QProgressDialog(tr("The steps are shown one after the other…"), tr("Cancel"), 0, m_player->count(), m_window);
    progress->setAttribute(Qt::WA_DeleteOnClose);
    progress->setWindowModality(Qt::WindowModal);
    connect(m_handout, &LessonHandout::progressed, progress, [progress](int step, int) { progress->setValue(step); });
    connect(progress, &QProgressDialog::canceled, m_handout, &LessonHandout::cancel);
    connect(m_handout, &LessonHandout::done, progress, &QWidget::close);
    connect(m_handout, &LessonHandout::failed, progress, &QWidget::close);
    m_handout->make(file);
}

bool LessonCommands::addStep(const QString& file, const QString& sentence) {
    const std::string language = m_language.current().toStdString();
    try {
        appendStep(file.toStdString(), {{language, QFileInfo(file).completeBaseName().toStdString()}},
                   m_document.opener().current({}), {{language, sentence.trimmed().toStdString()}});
    } catch (const Error& error) {
        m_session.raise(Severity::Error, error.message());
        return false;
    }
    m_session.raise(Severity::Information,
                    {QT_TRANSLATE_NOOP("core", "The step was added to the lesson %1."), {file.toStdString()}});
    return true;
}

void LessonCommands::refresh() {
    const bool on = m_player->active();
    m_actions.addLessonStep->setEnabled(m_session.opened() != nullptr);
    m_actions.handout->setEnabled(on);
    const bool later = on && m_player->step() > 0, more = on && m_player->step() + 1 < m_player->count();
    // At the ends, too: the keys of a presenter must not fall to what lies below.
    for (QAction* action : {m_actions.lessonOn, m_actions.lessonBack, m_actions.leaveLesson}) action->setEnabled(on);
    m_actions.lessonFirst->setEnabled(later);
    m_actions.lessonLast->setEnabled(more);
    // In a lesson, a presenter's clicker walks through the lesson, and a frame is stepped by other keys.
    const QKeySequence forward(Qt::CTRL | Qt::Key_Right), back(Qt::CTRL | Qt::Key_Left);
    m_actions.stepOn->setShortcuts(on ? QList{forward} : QList{QKeySequence(Qt::Key_PageDown), forward});
    m_actions.stepBack->setShortcuts(on ? QList{back} : QList{QKeySequence(Qt::Key_PageUp), back});
}

void LessonCommands::retranslate() { fillMenu(); }

}  // namespace cullscope::ui
