#include "ui/families/spherical/shown_map.h"

namespace cullscope::ui {

QString ShownMap::name() const { return QString::fromStdString(scene->instances()[decision().instance].name); }

ShownMap shownMap(const Session& session, const SnapshotReader& reader) {
    const SnapshotReadingPointer& reading = reader.reading();
    // After a change of the scene, until the first new reading, the reading numbers the objects of the former scene.
    if (!reading || spherical::mapsOf(*reading->snapshot).empty() || reading->strategy->scenePointer() != session.scene())
        return {};
    std::optional<uint32_t> picked;
    if (const std::optional<Pick>& pick = session.pick()) picked = session.instanceOf(pick->object);
    const std::vector<spherical::MapSnapshot>& maps = spherical::mapsOf(*reading->snapshot);
    std::optional<uint32_t> read;
    if (reading->triangle) read = uint32_t(session.scene()->instanceOf(*reading->triangle));
    const size_t place = spherical::placeOfMap(maps, picked), prepared = spherical::placeOfMap(maps, read);
    // Maps with a quadtree are made by the reader on request: until then the map before stays.
    const bool made = !maps[place].tree || maps[place].maps == maps[prepared].maps;
    return {session.scene(), reading->snapshot, made ? place : prepared};
}

MapAbsence mapAbsence(Session& session, const SnapshotReader& reader) {
    if (!session.scene()) return session.loader().loading() ? MapAbsence::Preparing : MapAbsence::NoScene;
    const StrategySlot& slot = session.slot(session.culledBy(session.activeView()));
    if (slot.building()) return MapAbsence::Preparing;
    if (!slot.built() || slot.built()->id() != slot.id()) return MapAbsence::NotBuilt;
    // The present reading may be of the former strategy.
    const bool read = reader.reading() && reader.reading()->strategy == slot.built();
    return read ? MapAbsence::NoMaps : MapAbsence::Preparing;
}

void followShownMap(Session& session, SnapshotReader& reader, QObject* context, const std::function<void()>& then) {
    QObject::connect(&reader, &SnapshotReader::changed, context, then);
    for (const auto signal :
         {&Session::pickChanged, &Session::hiddenChanged, &Session::sceneChanged, &Session::activeViewChanged})
        QObject::connect(&session, signal, context, then);
}

void followMapAbsence(Session& session, QObject* context, const std::function<void()>& then) {
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
