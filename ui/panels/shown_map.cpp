#include "ui/panels/shown_map.h"

#include <algorithm>

namespace cullscope::ui {

QString ShownMap::name() const { return QString::fromStdString(scene->instances()[decision().instance].name); }

ShownMap shownMap(const Session& session, const InsideReader& reader) {
    const InsideReadingPointer& reading = reader.reading();
    // Between a change of the scene and its first reading the numbers are of the old one.
    if (!reading || reading->inside->maps.empty() || reading->strategy->scene != session.scene()) return {};
    const std::vector<InsideMap>& maps = reading->inside->maps;
    const auto place = [&](const auto& matches) {
        return size_t(std::find_if(maps.begin(), maps.end(), matches) - maps.begin());
    };
    size_t found = maps.size();
    if (const std::optional<Pick>& pick = session.pick())
        if (const std::optional<uint32_t> instance = session.instanceOf(pick->object))
            found = place([&](const InsideMap& map) { return map.decision.instance == *instance; });
    if (found == maps.size())
        found = place([](const InsideMap& map) { return map.decision.relation != SphereRelation::Outside; });
    return {session.scene(), reading->inside, found == maps.size() ? 0 : found};
}

}  // namespace cullscope::ui
