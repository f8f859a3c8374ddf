#include "core/visibility/spherical/recorded_decisions.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "core/geometry/angle.h"
#include "core/visibility/left_out_triangles.h"
#include "core/visibility/spherical/contour_bands.h"
#include "core/visibility/spherical/recorded_tests.h"

namespace cullscope::spherical {
namespace {

/// The sectors about which no decision was said hold no triangles: their horizon is the largest size before them, and they are
/// cut where a nearer one was.
void fillEmptySectors(ContourBands& bands) {
    for (uint32_t sector = 0; sector < bands.sectors; ++sector) {
        double largest = 0.0;
        bool drawn = true;
        for (uint32_t band = 0; band < bands.bands; ++band) {
            BandSector& entry = bands.table[size_t(band) * bands.sectors + sector];
            if (entry.size > 0.0) {
                largest = std::max(largest, entry.size);
                drawn = entry.drawn;
            } else {
                entry.horizon = largest;
                entry.drawn = drawn;
            }
        }
    }
}

/// Reads the stream of one log.
class StreamReader {
public:
    explicit StreamReader(const FrameLog& log) : m_log(log) {}

    [[nodiscard]] std::vector<SphericalDecision> read() {
        auto detail = m_log.details.begin();
        for (size_t number = 0; number < m_log.decisions.size(); ++number) {
            const Decision& decision = m_log.decisions[number];
            add(decision);
            for (; detail != m_log.details.end() && detail->decision == number; ++detail) add(decision, *detail->detail);
        }
        std::vector<SphericalDecision> result;
        for (auto& [instance, object] : m_objects) {
            if (object.bandsSaid) fillEmptySectors(*object.decision.bands);
            if (object.cellsSaid && !object.decision.walk) object.decision.drawn = object.runs.take();
            result.push_back(std::move(object.decision));
        }
        return result;
    }

private:
    struct Object {
        SphericalDecision decision;
        RunCollector runs;  ///< of cells of maps
        bool bandsSaid = false, cellsSaid = false;
    };

    Object& objectOf(uint32_t instance) {
        Object& object = m_objects[instance];
        object.decision.instance = instance;
        return object;
    }

    void add(const Decision& decision) {
        using Kind = Subject::Kind;
        const bool culled = decision.outcome == Decision::Outcome::Culled;
        // Without a sphere's test of its own, an object that is left out was outside with its group or its box.
        if (decision.subject.kind == Kind::Object && culled) objectOf(decision.subject.number);
        if (decision.subject.kind == Kind::Node && culled)
            for (const uint32_t instance : m_log.objectsOf(decision)) objectOf(instance);
        const auto found = m_objects.find(decision.subject.object);
        if (found == m_objects.end()) return;
        if (decision.subject.kind == Kind::Band)
            addBand(found->second, decision);
        else if (decision.subject.kind == Kind::Cells)
            addRange(found->second.decision, decision);
        else if (decision.subject.kind != Kind::Cell)
            return;
        else if (found->second.decision.walk)
            addToWalk(*found->second.decision.walk, found->second.decision, decision);
        else if (decision.outcome != Decision::Outcome::Open)
            addCell(found->second, decision);
    }

    static void addBand(Object& object, const Decision& decision) {
        if (!object.decision.bands || decision.subject.number >= object.decision.bands->table.size()) return;
        // The sectors of slopes are all drawn in part.
        const bool within = decision.containment == Containment::Straddles && !object.decision.bands->slopes;
        const ContourBands& bands = *object.decision.bands;
        // The fifth operand is the angle at which the band ends that was hidden before.
        const bool cut = !bands.slopes && decision.operandCount > 4;
        const double ended = cut ? decision.operands[4] * kPi / 180.0 / bands.width : 0.0;
        object.decision.bands->table[decision.subject.number] = {decision.operands[0], decision.operands[1],
                                                                 !within && decision.containment != Containment::Outside, within,
                                                                 cut ? uint32_t(std::lround(ended)) - 1 : BandSector::kUncut};
        object.bandsSaid = true;
    }

    /// Of the groups of cells the ranges are drawn. One without triangles is not said.
    static void addRange(SphericalDecision& object, const Decision& decision) {
        const std::optional<size_t> index = CellGroups(object).rangeOf(decision.subject.number);
        if (!index || decision.outcome != Decision::Outcome::Drawn) return;
        if (object.drawn.size() <= *index) object.drawn.resize(*index + 1);
        object.drawn[*index] = {uint32_t(decision.operands[0]), uint32_t(decision.operands[1]) + 1};
        object.drawnTriangles += decision.places.count;
    }

    static void addCell(Object& object, const Decision& decision) {
        const bool drawn = decision.outcome != Decision::Outcome::Culled;
        object.runs.add(decision.subject.number, drawn);
        object.cellsSaid = true;
        if (drawn) object.decision.drawnTriangles += decision.places.count;
    }

    static void addToWalk(CellWalk& walk, SphericalDecision& object, const Decision& decision) {
        const uint32_t node = decision.subject.number;
        switch (decision.outcome) {
            case Decision::Outcome::Culled:
                walk.culled[size_t(decision.cause)] += decision.places.count;
                walk.judged.push_back({node, decision.cause});
                break;
            case Decision::Outcome::Drawn:
                object.drawnTriangles += decision.places.count;
                walk.judged.push_back({node, std::nullopt});
                break;
            case Decision::Outcome::DrawnAfterAll: {
                object.drawnTriangles += decision.places.count;
                walk.culled[size_t(decision.cause)] -= decision.places.count;
                const auto judged = std::find_if(walk.judged.rbegin(), walk.judged.rend(),
                                                 [&](const JudgedCell& cell) { return cell.node == node; });
                if (judged != walk.judged.rend()) *judged = {node, std::nullopt, true};
                break;
            }
            case Decision::Outcome::PartlyDrawn:
            case Decision::Outcome::Open:
                break;
        }
    }

    void add(const Decision& decision, const DecisionDetail& detail) {
        if (decision.subject.object == Subject::kNoObject) return;
        SphericalDecision& object = objectOf(decision.subject.object).decision;
        if (const auto* sphere = dynamic_cast<const SphereDetail*>(&detail)) {
            object.relation = sphere->relation;
            object.eye = sphere->eye;
        } else if (const auto* ray = dynamic_cast<const RayDetail*>(&detail)) {
            object.rays[ray->corner] = ray->ray;
        } else if (const auto* region = dynamic_cast<const RegionDetail*>(&detail)) {
            object.region = region->region;
        } else if (const auto* bands = dynamic_cast<const BandsDetail*>(&detail)) {
            object.bands = bands->bands;
        } else if (const auto* runs = dynamic_cast<const RunsDetail*>(&detail)) {
            object.drawn = runs->drawn;
            object.drawnTriangles = runs->drawnTriangles;
        } else if (const auto* walk = dynamic_cast<const WalkDetail*>(&detail)) {
            addWalk(object, *walk);
        } else if (const auto* triangles = dynamic_cast<const LeftOutTriangles*>(&detail)) {
            for (const LeftOutTriangles::Run& run : triangles->runs) {
                object.drawnTriangles -= run.places.count;
                object.leftOutAlone += run.places.count;
            }
        }
    }

    static void addWalk(SphericalDecision& object, const WalkDetail& detail) {
        CellWalk& walk = object.walk.emplace();
        walk.cones = detail.cones;
        walk.hiding = detail.horizon;
        walk.nodesVisited = detail.nodesVisited;
        walk.outline = detail.outline;
        if (detail.whole == 0) return;
        walk.judged.push_back({0, std::nullopt});
        object.drawnTriangles = detail.whole;
    }

    const FrameLog& m_log;
    std::map<uint32_t, Object> m_objects;  ///< by instance
};

}  // namespace

std::vector<SphericalDecision> decisionsOf(const FrameLog& log) { return StreamReader(log).read(); }

bool asksKernels(const FrameLog& log) {
    return std::ranges::any_of(log.details, [](const LoggedDetail& logged) {
        return dynamic_cast<const KernelsDetail*>(logged.detail.get()) != nullptr;
    });
}

}  // namespace cullscope::spherical
