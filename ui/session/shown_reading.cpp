#include "ui/session/shown_reading.h"

#include <QCoreApplication>

namespace cullscope::ui {
namespace {

class ShownReading {
    Q_DECLARE_TR_FUNCTIONS(cullscope::ui::ShownReading)
};

}  // namespace

SnapshotReadingPointer shownReading(const Session& session, const SnapshotReader& reader) {
    const SnapshotReadingPointer& reading = reader.reading();
    // After a change of the scene, until the first new reading, the reading numbers the objects of the former scene.
    return reading && reading->strategy->scenePointer() == session.scene() ? reading : nullptr;
}

std::optional<uint32_t> pickedInstance(const Session& session) {
    // The subject in hand of a stepped view comes first.
    if (const ShownStep* step = session.stepOf(session.activeView()); step && step->shape.object) return step->shape.object;
    const std::optional<Pick>& pick = session.pick();
    return pick ? session.instanceOf(pick->object) : std::nullopt;
}

Absence absence(Session& session, const SnapshotReader& reader) {
    if (!session.scene()) return session.loader().loading() ? Absence::Preparing : Absence::NoScene;
    const StrategySlot& slot = session.slot(session.culledBy(reader.view()));
    if (slot.building()) return Absence::Preparing;
    if (!slot.built() || slot.built()->id() != slot.id()) return Absence::NotBuilt;
    // The present reading may be of the former strategy.
    const bool read = reader.reading() && reader.reading()->strategy == slot.built();
    return read ? Absence::Nothing : Absence::Preparing;
}

QString absenceWords(Absence absence) {
    switch (absence) {
        case Absence::NoScene:
            return ShownReading::tr("Open a scene to see what a strategy decides about it.");
        case Absence::Preparing:
            return ShownReading::tr("The strategy is being prepared…");
        case Absence::NotBuilt:
            return ShownReading::tr("The strategy could not be built. Choose another one, or other parameters.");
        case Absence::Nothing:
            break;
    }
    return {};
}

void followReading(Session& session, SnapshotReader& reader, QObject* context, const std::function<void()>& then) {
    QObject::connect(&reader, &SnapshotReader::changed, context, then);
    for (const auto signal : {&Session::pickChanged, &Session::hiddenChanged, &Session::sceneChanged, &Session::activeViewChanged,
                              &Session::stepChanged})
        QObject::connect(&session, signal, context, then);
}

void followAbsence(Session& session, QObject* context, const std::function<void()>& then) {
    for (const auto signal : {&Session::strategyBuilt, &Session::setupChanged})
        QObject::connect(&session, signal, context, [then](int) { then(); });
    // Queued: building and opening begin only after these signals, and have ended only after the message of their failure.
    QObject::connect(
        &session, &Session::strategyChosen, context, [then](int) { then(); }, Qt::QueuedConnection);
    QObject::connect(
        &session, &Session::messageRaised, context, [then](Severity, const Message&) { then(); }, Qt::QueuedConnection);
    QObject::connect(
        &session.loader(), &SceneLoader::started, context, [then](const QString&) { then(); }, Qt::QueuedConnection);
    QObject::connect(&session.loader(), &SceneLoader::cancelled, context, then, Qt::QueuedConnection);
}

}  // namespace cullscope::ui
