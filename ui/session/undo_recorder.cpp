#include "ui/session/undo_recorder.h"

#include <QCoreApplication>
#include <QMouseEvent>

#include "ui/session/undo_step.h"

namespace cullscope::ui {

namespace {

constexpr int kRest = 400;  // ms
constexpr int kMostSteps = 200;

QString nameOf(const QUndoStack& stack, int index) { return static_cast<const UndoStep*>(stack.command(index))->name(); }

}  // namespace

UndoRecorder::UndoRecorder(Session& session, QObject* parent) : QObject(parent), m_session(session) {
    m_stack.setUndoLimit(kMostSteps);
    m_rest.setSingleShot(true);
    m_rest.setInterval(kRest);
    connect(&m_rest, &QTimer::timeout, this, [this] {
        // While the user holds the mouse button the drag has not ended.
        if (!m_buttonDown) settle();
    });
    connect(&session, &Session::cameraChanged, this, &UndoRecorder::noteChange);
    connect(&session, &Session::camerasFollowedWindow, this, &UndoRecorder::takeCameras);
    connect(&session, &Session::setupChanged, this, &UndoRecorder::noteChange);
    connect(&session, &Session::strategyChosen, this, &UndoRecorder::noteChange);
    connect(&session, &Session::hiddenChanged, this, &UndoRecorder::noteChange);
    connect(&session, &Session::sceneChanged, this, &UndoRecorder::startAnew);
    QCoreApplication::instance()->installEventFilter(this);
    startAnew();
}

bool UndoRecorder::eventFilter(QObject* watched, QEvent* event) {
    const QEvent::Type type = event->type();
    if (type == QEvent::MouseButtonPress || type == QEvent::MouseButtonDblClick) m_buttonDown = true;
    // The release may go to another program: a later mouse move without a button counts as the release.
    const bool moved = type == QEvent::MouseButtonRelease || type == QEvent::MouseMove;
    if (moved && m_buttonDown && static_cast<QMouseEvent*>(event)->buttons() == Qt::NoButton) {
        m_buttonDown = false;
        // Queued: the handler of the release may change the session first.
        if (m_changing) QMetaObject::invokeMethod(this, &UndoRecorder::settle, Qt::QueuedConnection);
    }
    return QObject::eventFilter(watched, event);
}

void UndoRecorder::noteChange() {
    if (m_applying || !m_session.opened()) return;
    m_rest.start();
    if (!std::exchange(m_changing, true)) emit changed();
}

/// Takes the present cameras as the former ones: a change of the window size is not a step for the user to undo.
void UndoRecorder::takeCameras() {
    m_before.camera = m_session.camera();
    for (int view = 0; view < Session::kMostViews; ++view) {
        ViewSetup& before = m_before.views[size_t(view)].setup;
        const ViewSetup& now = m_session.setup(view);
        if (before.role == Role::Observer && now.role == Role::Observer) before.viewing = now.viewing;
    }
}

void UndoRecorder::settle() {
    m_rest.stop();
    if (!std::exchange(m_changing, false)) return;
    SessionState now = captureState(m_session);
    if (differInUndoable(m_before, now))
        m_stack.push(new UndoStep(
            m_before, now, [this] { return captureState(m_session); }, [this](const SessionState& state) { apply(state); }));
    m_before = std::move(now);
    emit changed();
}

void UndoRecorder::startAnew() {
    m_rest.stop();
    m_changing = false;
    m_stack.clear();
    m_before = captureState(m_session);
    emit changed();
}

void UndoRecorder::apply(const SessionState& state) {
    m_applying = true;
    applyState(m_session, state);
    m_applying = false;
}

void UndoRecorder::walk(void (QUndoStack::*way)()) {
    settle();
    (m_stack.*way)();
    m_before = captureState(m_session);
    emit changed();
}

void UndoRecorder::undo() { walk(&QUndoStack::undo); }

void UndoRecorder::redo() { walk(&QUndoStack::redo); }

QString UndoRecorder::undoText() const {
    const int index = m_stack.index() - 1;
    return index < 0 || m_changing ? tr("Undo") : tr("Undo: %1").arg(nameOf(m_stack, index));
}

QString UndoRecorder::redoText() const { return canRedo() ? tr("Redo: %1").arg(nameOf(m_stack, m_stack.index())) : tr("Redo"); }

}  // namespace cullscope::ui
