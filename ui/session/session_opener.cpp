#include "ui/session/session_opener.h"

#include <QCoreApplication>
#include <QFileInfo>
#include <algorithm>
#include <new>

#include "core/base/error.h"
#include "core/image/picture_file.h"
#include "ui/session/session_file.h"

namespace cullscope::ui {

namespace {

constexpr std::array kSessionTypes{kSessionExtension, "json"};
constexpr std::array kPictureTypes{"png", "jpg", "jpeg", "tif", "tiff", "exr"};

template <typename Types>
bool isOneOf(const QString& suffix, const Types& types) {
    return std::any_of(types.begin(), types.end(), [&](const char* type) { return suffix == QLatin1String(type); });
}

/// Throws Error(Input) if the picture holds no session or an invalid one.
SessionState readPictureState(const std::filesystem::path& file) {
    for (const auto& [name, text] : readPictureMetadata(file))
        if (name == kSessionMetadata)
            if (std::optional<SessionState> state = stateFromText(text, file)) return *state;
    throwInput(QT_TRANSLATE_NOOP("core", "%1 does not say what it shows: only pictures that Cullscope saved can be opened."),
               {file.string()});
}

SessionState readStateOf(const std::filesystem::path& file, SessionOpener::Kind kind) {
    return kind == SessionOpener::Kind::Picture ? readPictureState(file) : loadSession(file);
}

}  // namespace

SessionOpener::SessionOpener(Session& session, CameraBookmarks& bookmarks, QObject* parent)
    : QObject(parent), m_session(session), m_bookmarks(bookmarks) {
    SceneLoader& loader = session.loader();
    connect(&loader, &SceneLoader::started, this, [this] {
        if (m_starting) return;
        m_reading.cancel();
        m_pending.reset();
    });
    // Does not cancel m_reading: a file being read now was opened after this scene.
    connect(&loader, &SceneLoader::failed, this, [this] {
        m_pending.reset();
        emit failed();
    });
    connect(&loader, &SceneLoader::cancelled, this, [this] { m_pending.reset(); });
    // Slots run in the order of connection: the session was connected earlier and has shown the scene.
    connect(&loader, &SceneLoader::loaded, this, &SessionOpener::finish);
}

SessionOpener::Kind SessionOpener::kindOf(const QString& what) {
    const QString suffix = QFileInfo(what).suffix().toLower();
    const bool isFile = !what.contains(QLatin1Char(':')) || QFileInfo::exists(what);
    if (isFile && isOneOf(suffix, kSessionTypes)) return Kind::Session;
    if (isFile && isOneOf(suffix, kPictureTypes)) return Kind::Picture;
    return Kind::Scene;
}

QStringList SessionOpener::pictureExtensions() {
    QStringList extensions;
    for (const char* type : kPictureTypes) extensions << QString::fromLatin1(type);
    return extensions;
}

void SessionOpener::open(const QString& what) {
    const Kind kind = kindOf(what);
    if (kind == Kind::Scene) return m_session.open(what);
    read(QString::fromStdString(absoluteFile(what.toStdString())), kind);
}

void SessionOpener::read(const QString& file, Kind kind) {
    const auto work = [this, file, kind](const std::stop_token&) -> Background::Delivery {
        return [this, file, state = readStateOf(file.toStdString(), kind)] { restore(state, file); };
    };
    m_reading.start(work, [this, file](const std::exception& error) -> Background::Delivery {
        Message failure{QT_TRANSLATE_NOOP("core", "%1 cannot be opened: %2"), {file.toStdString(), error.what()}};
        if (const auto* known = dynamic_cast<const Error*>(&error)) failure = known->message();
        return [this, failure] {
            m_session.raise(Severity::Error, failure);
            emit failed();
        };
    });
}

void SessionOpener::restore(const SessionState& state, const QString& origin) {
    m_reading.cancel();
    m_pending = Pending{state, origin};
    m_starting = true;
    m_session.open(QString::fromStdString(state.scene));
    m_starting = false;
}

void SessionOpener::finish() {
    const std::optional<Pending> pending = std::exchange(m_pending, std::nullopt);
    if (pending) {
        applyState(m_session, pending->state);
        m_bookmarks.setPlaces(pending->state.bookmarks);
        if (pending->state.style) m_session.setDrawStyle(*pending->state.style);
    }
    emit opened(pending && !pending->origin.isEmpty() ? pending->origin
                                                      : QString::fromStdString(m_session.opened()->specification));
    if (pending) emit restored(pending->state);
}

SessionState SessionOpener::current(const QString& arrangement) const {
    SessionState state = captureState(m_session);
    state.arrangement = arrangement.toStdString();
    state.bookmarks = m_bookmarks.places();
    state.style = m_session.drawStyle();
    m_addWindowState(state);
    return state;
}

bool SessionOpener::save(const QString& file, const QString& arrangement) {
    try {
        saveSession(file.toStdString(), current(arrangement));
        return true;
    } catch (const Error& error) {
        m_session.raise(Severity::Error, error.message());
        return false;
    }
}

}  // namespace cullscope::ui
