#include "ui/families/spherical/shown_map.h"

namespace cullscope::ui {

QString ShownMap::name() const { return QString::fromStdString(scene->instances()[decision().instance].name); }

ShownMap shownMap(const Session& session, const SnapshotReader& reader) {
    const SnapshotReadingPointer reading = shownReading(session, reader);
    if (!reading || spherical::mapsOf(*reading->snapshot).empty()) return {};
    const std::vector<spherical::MapSnapshot>& maps = spherical::mapsOf(*reading->snapshot);
    std::optional<uint32_t> read;
    if (reading->triangle) read = uint32_t(session.scene()->instanceOf(*reading->triangle));
    const size_t place = spherical::placeOfMap(maps, pickedInstance(session)), prepared = spherical::placeOfMap(maps, read);
    // Maps with a quadtree are made by the reader on request: until then the map before stays.
    const bool made = !maps[place].tree || maps[place].maps == maps[prepared].maps;
    return {session.scene(), reading->snapshot, made ? place : prepared};
}

}  // namespace cullscope::ui
