#include "core/visibility/spherical/bands_so_far.h"

#include "core/visibility/spherical/recorded_decisions.h"

namespace cullscope::spherical {

std::map<uint32_t, BandsSoFar> bandsInHand(const FrameLog& log, size_t decisions) {
    std::map<uint32_t, BandsSoFar> objects;
    auto detail = log.details.begin();
    for (size_t number = 0; number < std::min(decisions, log.decisions.size()); ++number) {
        const Decision& decision = log.decisions[number];
        const Subject& subject = decision.subject;
        if (const auto object = objects.find(subject.object); object != objects.end()) {
            std::vector<std::optional<Containment>>& found = object->second.found;
            if (subject.kind == Subject::Kind::Band && subject.number < found.size())
                found[subject.number] = decision.containment;
            else if (subject.kind == Subject::Kind::Object && decision.outcome != Decision::Outcome::Open)
                objects.erase(object);
        }
        for (; detail != log.details.end() && detail->decision == number; ++detail) {
            const auto* bands = dynamic_cast<const BandsDetail*>(detail->detail.get());
            if (bands == nullptr || bands->bands.slopes || decision.outcome != Decision::Outcome::Open) continue;
            BandsSoFar& object = objects[subject.object];
            object.bands = bands->bands;
            object.found.assign(object.bands.table.size(), std::nullopt);
        }
    }
    return objects;
}

CellsSoFar cellsSoFar(const BandCells& cells, const BandsSoFar& of) {
    RunCollector drawn, undecided;
    for (const BandCells::Cell& cell : cells.cells) {
        const Vec3& middle = cells.directions.middle({cell.row, cell.column});
        const std::optional<Containment>& found = of.found[sectorOfCell(of.bands, middle)];
        const bool within = found == Containment::Straddles && glm::dot(middle, of.bands.axis) >= 0.0;
        drawn.add(cell.number, found == Containment::Inside || within);
        undecided.add(cell.number, !found);
    }
    return {drawn.take(), undecided.take()};
}

}  // namespace cullscope::spherical
