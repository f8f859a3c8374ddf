#include "ui/session/lesson_player.h"

#include <QCoreApplication>
#include <QDir>
#include <QFile>
#include <QFileInfo>

#include "core/base/error.h"

namespace cullscope::ui {

namespace {

constexpr const char* kLessonFolder = ":/lessons";
constexpr const char* kFirstWindow = ":/lessons/first-window.lesson";

/// The files of the program's own lessons, such as 3-cases.lesson: the number is their place.
QStringList ownFiles() {
    return QDir(QLatin1String(kLessonFolder))
        .entryList({QStringLiteral("?-*.") + QLatin1String(kLessonExtension)}, QDir::Files, QDir::Name);
}

QString lessonNameOf(const QString& file) { return QFileInfo(file).completeBaseName().mid(2); }

/// The path of an own lesson; empty: there is none of that name.
QString ownFile(const QString& name) {
    for (const QString& file : ownFiles())
        if (lessonNameOf(file) == name) return QLatin1String(kLessonFolder) + QLatin1Char('/') + file;
    return {};
}

std::string resourceText(const QString& resource) {
    QFile file(resource);
    return file.open(QIODevice::ReadOnly) ? file.readAll().toStdString() : std::string();
}

}  // namespace

LessonPlayer::LessonPlayer(Session& session, QObject* parent) : QObject(parent), m_session(session) {
    SceneLoader& loader = session.loader();
    // The session was connected earlier: where the scene is loaded, it shows it already.
    connect(&loader, &SceneLoader::loaded, this, [this] {
        if (const std::optional<LessonStep> step = std::exchange(m_awaited, std::nullopt)) apply(*step);
    });
    connect(&loader, &SceneLoader::started, this, [this] {
        if (!m_starting) m_awaited.reset();
    });
    connect(&loader, &SceneLoader::failed, this, [this] { m_awaited.reset(); });
    connect(&loader, &SceneLoader::cancelled, this, [this] { m_awaited.reset(); });
}

QStringList LessonPlayer::known() {
    QStringList names;
    for (const QString& file : ownFiles()) names << lessonNameOf(file);
    return names;
}

LessonText LessonPlayer::titleOf(const QString& name) { return lessonTitle(resourceText(ownFile(name))); }

Lesson LessonPlayer::read(const QString& nameOrFile) {
    if (const QString own = ownFile(nameOrFile); !own.isEmpty()) return lessonFromText(resourceText(own), own.toStdString());
    if (!QFileInfo(nameOrFile).isFile())
        throwUsage(QT_TRANSLATE_NOOP("core", "There is no lesson \"%1\": name a lesson's file, or one of %2."),
                   {nameOrFile.toStdString(), known().join(QStringLiteral(", ")).toStdString()});
    return loadLesson(absoluteFile(nameOrFile.toStdString()));
}

int LessonPlayer::cutStep(QString& nameOrFile) {
    const qsizetype colon = nameOrFile.lastIndexOf(QLatin1Char(':'));
    bool number = false;
    const int step = colon > 0 ? nameOrFile.mid(colon + 1).toInt(&number) : 0;
    if (!number || step < 1) return 0;
    nameOrFile.truncate(colon);
    return step - 1;
}

void LessonPlayer::begin(const QString& nameOrFile, int step) {
    try {
        begin(read(nameOrFile), step);
        if (ownFile(nameOrFile).isEmpty()) m_file = QString::fromStdString(absoluteFile(nameOrFile.toStdString()));
    } catch (const Error& error) {
        m_session.raise(Severity::Error, error.message());
    }
}

void LessonPlayer::begin(const Lesson& lesson, int step) {
    m_lesson = lesson;
    m_file.clear();
    go(std::clamp(step, 0, count() - 1));
}

void LessonPlayer::leave() {
    if (!active()) return;
    m_lesson = {};
    m_file.clear();
    m_awaited.reset();
    emit changed();
}

void LessonPlayer::go(int step) {
    if (step < 0 || step >= count()) return;
    m_step = step;
    emit changed();
    show(current());
}

void LessonPlayer::show(const LessonStep& step) {
    const std::string scene = sceneOf(step, m_session.sceneSource());
    const bool open = m_session.opened() && m_session.opened()->specification == scene && !m_session.loader().loading();
    if (open) return apply(step);
    m_awaited = step;
    m_starting = true;
    m_session.open(QString::fromStdString(scene));
    m_starting = false;
}

void LessonPlayer::apply(const LessonStep& step) {
    try {
        applyStep(m_session, step);
    } catch (const Error& error) {
        m_session.raise(Severity::Error, error.message());
    }
    emit shown(step);
}

LessonStep LessonPlayer::firstStep(int viewCount, const std::optional<Viewport>& size) {
    LessonStep step = lessonFromText(resourceText(QLatin1String(kFirstWindow)), kFirstWindow).steps.front();
    step.state.viewCount = viewCount;
    for (SessionState::View& view : step.state.views) view.setup.size = size;
    return step;
}

}  // namespace cullscope::ui
