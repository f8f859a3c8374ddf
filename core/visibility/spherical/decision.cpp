#include "core/visibility/spherical/decision.h"

#include <map>
#include <numbers>

#include "core/base/message.h"

namespace cullscope::spherical {

const char* relationName(SphereRelation relation) {
    switch (relation) {
        case SphereRelation::Outside:
            return CULLSCOPE_TR("outside the frustum");
        case SphereRelation::Cut:
            return CULLSCOPE_TR("cut by the frustum");
        case SphereRelation::Within:
            return CULLSCOPE_TR("inside the frustum");
        case SphereRelation::AroundEye:
            break;
    }
    return CULLSCOPE_TR("around the eye");
}

Containment containmentOf(SphereRelation relation) {
    if (relation == SphereRelation::Outside) return Containment::Outside;
    return relation == SphereRelation::Within ? Containment::Inside : Containment::Straddles;
}

std::vector<std::optional<FrustumPlane>> rejectingPlanes(const FrameLog& log, size_t instances) {
    std::vector<std::optional<FrustumPlane>> planes(instances);
    std::map<uint32_t, std::optional<FrustumPlane>> ofGroups;
    for (const Decision& decision : log.decisions) {
        const bool rejects = decision.outcome == Decision::Outcome::Open && decision.containment == Containment::Outside;
        if (decision.subject.kind == Subject::Kind::Object && rejects && decision.plane)
            planes[decision.subject.number] = decision.plane;
        if (decision.subject.kind != Subject::Kind::Node) continue;
        if (rejects) ofGroups[decision.subject.number] = decision.plane;
        if (decision.outcome != Decision::Outcome::Culled) continue;
        for (const uint32_t instance : log.objectsOf(decision)) planes[instance] = ofGroups[decision.subject.number];
    }
    return planes;
}

Vec2 ContourBands::anglesOf(const Vec3& direction) const {
    const double along = glm::dot(direction, axis), x = glm::dot(direction, side), y = glm::dot(direction, over);
    const double beta = std::atan2(y, x);
    const double turned = beta < 0.0 ? beta + 2.0 * std::numbers::pi : beta;
    return {std::atan2(std::hypot(x, y), along), turned < 2.0 * std::numbers::pi ? turned : 0.0};
}

uint32_t ContourBands::sectorOf(double beta) const {
    return std::min(uint32_t(std::max(beta, 0.0) / (2.0 * std::numbers::pi) * sectors), sectors - 1);
}

namespace {

CellState stateOf(const JudgedCell& judged) {
    if (!judged.cause) return CellState::Drawn;
    return *judged.cause == Cause::BackFacing ? CellState::BackFacing
           : *judged.cause == Cause::Hidden   ? CellState::Hidden
                                              : CellState::OutsideFrustum;
}

std::vector<CellState> statesOfWalk(const MapSnapshot& map) {
    std::vector<CellState> byTriangle(map.tree->mesh().triangleCount(), CellState::OutsideFrustum);
    if (map.decision.walk)
        for (const JudgedCell& judged : map.decision.walk->judged) {
            const CellTree::Node& node = map.tree->nodes()[judged.node];
            for (uint32_t place = node.first; place < node.first + node.count; ++place)
                byTriangle[map.tree->triangleOrder()[place]] = stateOf(judged);
        }
    std::vector<CellState> states(map.maps->grid().cellCount(), CellState::Empty);
    for (uint32_t cell = 0; cell < states.size(); ++cell)
        for (const uint32_t triangle : map.maps->centroids(cell)) states[cell] = std::max(states[cell], byTriangle[triangle]);
    return states;
}

}  // namespace

std::vector<CellState> cellStates(const MapSnapshot& map) {
    if (map.tree) return statesOfWalk(map);
    const uint32_t cells = map.maps->grid().cellCount();
    const bool hidden = map.decision.bands.has_value();
    std::vector<CellState> states(cells, hidden ? CellState::Hidden : CellState::OutsideFrustum);
    for (const CellRun& run : map.decision.drawn)
        std::fill(states.begin() + run.first, states.begin() + run.last, CellState::Drawn);
    for (const CellRun& run : map.undecided)
        std::fill(states.begin() + run.first, states.begin() + run.last, CellState::Undecided);
    for (uint32_t cell = 0; cell < cells; ++cell)
        if (map.maps->centroids(cell).empty()) states[cell] = CellState::Empty;
    return states;
}

}  // namespace cullscope::spherical
