#include "ui/window/document_commands.h"

#include <QFileDialog>
#include <QFileInfo>
#include <QInputDialog>

#include "core/mesh/unpacker.h"
#include "core/scene/scene_files.h"
#include "ui/session/session_file.h"

namespace cullscope::ui {

namespace {

constexpr const char* kFolderSetting = "folder";

QString pattern(const QString& extension) {
    return QStringLiteral("*.") + extension + QStringLiteral(" *.") + extension.toUpper();
}

}  // namespace

DocumentCommands::DocumentCommands(Session& session, ViewGrid& views, WindowActions& actions, QWidget* window)
    : QObject(window),
      m_session(session),
      m_actions(actions),
      m_window(window),
      m_opener(new SessionOpener(session, m_bookmarks, this)),
      m_undo(new UndoRecorder(session, this)),
      m_screenshots(new ScreenshotTaker(session, window)) {
    m_screenshots->setParent(this);
    m_screenshots->setSessionText([this] { return stateToText(m_opener->current(m_arrangement()), {}); });
    m_screenshots->setExtras([&views](int view) { return views.pane(view).picture().extras(); });
    wire();
    fillRecent();
    fillBookmarks();
}

void DocumentCommands::wire() {
    connect(m_actions.open, &QAction::triggered, this, &DocumentCommands::openByDialog);
    connect(m_actions.saveSession, &QAction::triggered, this, [this] { save(false); });
    connect(m_actions.saveSessionAs, &QAction::triggered, this, [this] { save(true); });
    connect(m_actions.screenshot, &QAction::triggered, m_screenshots, &ScreenshotTaker::askAndTake);
    connect(m_actions.screenshotNow, &QAction::triggered, this, [this] { m_screenshots->take(true); });
    connect(m_actions.screenshotBare, &QAction::triggered, this, [this] { m_screenshots->take(false); });
    connect(m_screenshots, &ScreenshotTaker::failed, this,
            [this](const Message& message) { m_session.raise(Severity::Error, message); });
    connect(m_screenshots, &ScreenshotTaker::done, this, [this](const QString& path) { m_session.tellSaved(path); });
    const auto enable = [this] {
        for (QAction* action : {m_actions.saveSession, m_actions.saveSessionAs, m_actions.screenshot, m_actions.screenshotNow,
                                m_actions.screenshotBare})
            action->setEnabled(m_session.opened() != nullptr);
    };
    connect(&m_session, &Session::sceneChanged, this, enable);
    enable();
    connect(m_actions.undo, &QAction::triggered, m_undo, &UndoRecorder::undo);
    connect(m_actions.redo, &QAction::triggered, m_undo, &UndoRecorder::redo);
    connect(m_undo, &UndoRecorder::changed, this, &DocumentCommands::showUndo);
    // Queued: the menu must not be refilled while one of its actions runs.
    connect(&m_recent, &RecentFiles::changed, this, &DocumentCommands::fillRecent, Qt::QueuedConnection);
    connect(&m_bookmarks, &CameraBookmarks::changed, this, &DocumentCommands::fillBookmarks, Qt::QueuedConnection);
    connect(&m_session, &Session::sceneChanged, this, &DocumentCommands::fillBookmarks);
    connect(m_opener, &SessionOpener::opened, this, [this](const QString& what) {
        m_recent.add(what);
        m_file = SessionOpener::kindOf(what) == SessionOpener::Kind::Session ? what : QString();
    });
    connect(m_opener, &SessionOpener::restored, this, [this] { m_undo->startAnew(); });
}

QString DocumentCommands::fileTypes() {
    QStringList names, patterns;
    for (const std::string& extension : readableSceneExtensions()) {
        names << QString::fromStdString(extension);
        patterns << pattern(names.back());
        for (const std::string& packed : packedExtensions())
            patterns << pattern(names.back() + QLatin1Char('.') + QString::fromStdString(packed));
    }
    QStringList pictures;
    for (const QString& extension : SessionOpener::pictureExtensions()) pictures << pattern(extension);
    const QString models = patterns.join(QLatin1Char(' ')), sessions = pattern(QString::fromLatin1(kSessionExtension));
    const QString taken = pictures.join(QLatin1Char(' '));
    // All in one first, so that a session is found without choosing what is looked for.
    return QStringLiteral("%1 (%2 %3 %4);;%5 (%2);;%6 (%3);;%7 (%4);;%8 (*)")
        .arg(tr("Models, sessions and pictures"), models, sessions, taken,
             tr("Meshes (%1)").arg(names.join(QStringLiteral(", "))), tr("Sessions"), tr("Pictures that Cullscope took"),
             tr("All files"));
}

void DocumentCommands::openByDialog() {
    const QString file =
        QFileDialog::getOpenFileName(m_window, tr("Open"), m_settings.value(QLatin1String(kFolderSetting)).toString(),
                                     fileTypes(), nullptr, QFileDialog::HideNameFilterDetails);
    if (file.isEmpty()) return;
    m_settings.setValue(QLatin1String(kFolderSetting), QFileInfo(file).absolutePath());
    m_opener->open(file);
}

void DocumentCommands::save(bool askWhere) {
    if (!m_session.opened()) return;
    QString file = m_file;
    if (file.isEmpty() || askWhere)
        file = QFileDialog::getSaveFileName(m_window, tr("Save the session"),
                                            m_settings.value(QLatin1String(kFolderSetting)).toString(),
                                            tr("Sessions") + QStringLiteral(" (*.%1)").arg(QLatin1String(kSessionExtension)));
    if (file.isEmpty()) return;
    if (QFileInfo(file).suffix().isEmpty()) file += QLatin1Char('.') + QLatin1String(kSessionExtension);
    if (!m_opener->save(file, m_arrangement())) return;
    m_file = file;
    m_recent.add(file);
    m_session.tellSaved(file);
}

void DocumentCommands::fillRecent() {
    m_actions.recent->clear();
    for (const QString& entry : m_recent.entries())
        m_actions.recent->addAction(entry, this, [this, entry] {
            if (m_recent.keepIfThere(entry))
                m_opener->open(entry);
            else
                m_session.raise(Severity::Warning, RecentFiles::goneMessage(entry));
        });
    m_actions.recent->setEnabled(!m_recent.entries().isEmpty());
}

void DocumentCommands::fillBookmarks() {
    QMenu& menu = *m_actions.bookmarks;
    menu.clear();
    QMenu* names = new QMenu(tr("Name a camera"), &menu);
    for (int place = 0; place < CameraBookmarks::kCount; ++place) {
        const std::optional<CameraBookmark>& bookmark = m_bookmarks.places()[size_t(place)];
        const QString name = bookmark ? QString::fromStdString(bookmark->name) : QString();
        QString shown = name;
        shown.replace(QLatin1Char('&'), QStringLiteral("&&"));
        QAction* recall =
            menu.addAction(name.isEmpty() ? tr("Go to camera %1").arg(place + 1)
                                          : tr("Go to camera %1: %2", "its number, its name").arg(place + 1).arg(shown),
                           this, [this, place] { m_bookmarks.recall(place, m_session); });
        recall->setShortcut(QKeySequence(int(Qt::ALT) | (Qt::Key_1 + place)));
        recall->setEnabled(bookmark && m_session.opened());
        names->addAction(tr("Camera %1…").arg(place + 1), this, [this, place] { nameBookmark(place); })
            ->setEnabled(bookmark.has_value());
    }
    menu.addSeparator();
    for (int place = 0; place < CameraBookmarks::kCount; ++place) {
        QAction* store = menu.addAction(tr("Keep as camera %1").arg(place + 1), this, [this, place] { keepBookmark(place); });
        store->setShortcut(QKeySequence(int(Qt::ALT) | int(Qt::SHIFT) | (Qt::Key_1 + place)));
        store->setEnabled(m_session.opened() != nullptr);
    }
    menu.addSeparator();
    menu.addMenu(names);
}

void DocumentCommands::keepBookmark(int place) {
    m_bookmarks.store(place, m_session);
    // The keys of it change nothing in sight.
    const std::string number = std::to_string(place + 1);
    m_session.raise(Severity::Information, {QT_TRANSLATE_NOOP("core", "Kept as camera %1. Alt+%1 goes back to it."), {number}});
}

void DocumentCommands::nameBookmark(int place) {
    const std::optional<CameraBookmark> bookmark = m_bookmarks.places()[size_t(place)];
    if (!bookmark) return;
    bool named = false;
    const QString name = QInputDialog::getText(m_window, tr("Name a camera"), tr("Name of camera %1").arg(place + 1),
                                               QLineEdit::Normal, QString::fromStdString(bookmark->name), &named);
    if (named) m_bookmarks.name(place, name.trimmed().toStdString());
}

void DocumentCommands::retranslate() {
    showUndo();
    fillBookmarks();
}

void DocumentCommands::showUndo() {
    m_actions.undo->setText(m_undo->undoText());
    m_actions.redo->setText(m_undo->redoText());
    m_actions.undo->setToolTip(m_undo->undoText());
    m_actions.redo->setToolTip(m_undo->redoText());
    m_actions.undo->setEnabled(m_undo->canUndo());
    m_actions.redo->setEnabled(m_undo->canRedo());
}

}  // namespace cullscope::ui
