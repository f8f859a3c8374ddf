#include "core/visibility/spherical/mapped_culling.h"

#include <tbb/parallel_for.h>

#include <algorithm>

#include "core/base/message.h"
#include "core/visibility/spherical/bands_so_far.h"
#include "core/visibility/spherical/recorded_decisions.h"
#include "core/visibility/spherical/recorded_tests.h"

namespace cullscope::spherical {
namespace {

SnapshotNode nodeOf(const Scene& scene, const SphericalDecision& decision) {
    SnapshotNode node;
    node.instance = decision.instance;
    node.box = scene.instanceBox(decision.instance);
    node.triangles = scene.meshOf(decision.instance).triangleCount();
    node.culled = decision.relation == SphereRelation::Outside;
    node.containment = containmentOf(decision.relation);
    return node;
}

}  // namespace

void MappedCulling::fill(MappedScene& structure, const ParameterSet& parameters, const Progress& progress) const {
    const Scene& scene = structure.scene();
    structure.meshes.resize(scene.meshes().size());
    const std::vector<bool> shown = scene.shownMeshes();
    const auto count = double(structure.meshes.size());
    for (size_t i = 0; i < structure.meshes.size(); ++i) {
        if (!shown[i]) continue;
        const Progress part = progress.part(double(i) / count, double(i + 1) / count);
        MappedMesh& mesh = structure.meshes[i];
        mesh.maps = makeMaps(scene.meshes()[i], parameters, part);
        mesh.bandCells = std::make_unique<BandCells>(*mesh.maps);
        part.check();
        buildFor(structure, mesh);
    }
    finish(structure);
}

void MappedCulling::decide(FrameContext& frame, const MappedScene& structure, ViewState& /*state*/,
                           const ParameterSet& parameters) const {
    std::vector<MappedObject> decided = decideAll(frame, structure, parameters);
    DrawList list{frame.facing(), {}, structure.order};
    {
        const StageTimer stage(frame, CULLSCOPE_TR("draw list"));
        if (frame.recording()) frame.countPlacesIn(structure.order);
        if (frame.recording() && decided.size() > kMostWithTests) sayResultsAlone(frame);
        for (MappedObject& object : decided) {
            const MappedMesh& mesh = structure.meshOf(object.decision.instance);
            if (!mesh.maps) continue;
            submit(mesh, object.decision, list, frame.counters());
            if (!object.record) continue;
            object.record->sayTo(frame);
            object.record.reset();
        }
    }
    frame.draw(std::move(list));
}

std::vector<MappedObject> MappedCulling::decideAll(FrameContext& frame, const MappedScene& structure,
                                                   const ParameterSet& parameters) const {
    const StageTimer stage(frame, CULLSCOPE_TR("maps and bands"));
    std::vector<MappedObject> decided(frame.scene().instances().size());
    tbb::parallel_for(uint32_t{0}, uint32_t(decided.size()), [&](uint32_t i) {
        const MappedMesh& mesh = structure.meshOf(i);
        decided[i].decision.instance = i;
        if (!mesh.maps) return;
        if (frame.recording()) decided[i].record.emplace(i, decided.size() <= kMostWithTests);
        decideOne(frame, mesh, parameters, decided[i]);
    });
    return decided;
}

void MappedCulling::decideOne(const FrameContext& frame, const MappedMesh& mesh, const ParameterSet& parameters,
                              MappedObject& object) const {
    SphericalDecision& decision = object.decision;
    ObjectRecord* record = object.record ? &*object.record : nullptr;
    const ObjectSpaceView seen =
        objectSpaceView(frame.scene(), decision.instance, mesh.maps->frame(), frame.view(), record, uint8_t(BandsLine::Sphere));
    decision.relation = seen.relation;
    decision.eye = seen.eye;
    if (seen.relation == SphereRelation::AroundEye)
        decision.drawn = {{0, mesh.maps->grid().cellCount()}};
    else if (seen.relation != SphereRelation::Outside)
        decideAbout(mesh, seen, parameters, decision, record);
    for (size_t i = 0; i < decision.drawn.size(); ++i) {
        decision.drawnTriangles += mesh.maps->run(decision.drawn[i].first, decision.drawn[i].last).second;
        if (record != nullptr && saysRanges()) sayRange(*mesh.maps, decision, i, uint8_t(lineOf(decision)), *record);
    }
    if (record != nullptr) sayEnd(mesh, decision, *record);
}

void MappedCulling::sayEnd(const MappedMesh& mesh, const SphericalDecision& decision, ObjectRecord& record) const {
    const bool outside = decision.relation == SphereRelation::Outside;
    Decision end =
        ending(record.subject(), decision.drawnTriangles > 0 ? Decision::Outcome::PartlyDrawn : Decision::Outcome::Culled,
               outside ? Cause::OutsideFrustum : causeOf(decision));
    if (decision.drawnTriangles == mesh.maps->mesh().triangleCount()) end = ending(record.subject(), Decision::Outcome::Drawn);
    record.say(atLine(outside ? BandsLine::Outside : lineOf(decision), end));
    const bool said = record.tests() && (decision.region || decision.bands);
    if (!said) record.attach(std::make_shared<RunsDetail>(decision.drawn, decision.drawnTriangles));
}

void MappedCulling::submit(const MappedMesh& mesh, const SphericalDecision& decision, DrawList& list,
                           FrameCounters& counters) const {
    for (const CellRun& run : decision.drawn) {
        const auto [first, count] = mesh.maps->run(run.first, run.last);
        if (count == 0) continue;
        list.ranges.push_back({decision.instance, uint32_t(3 * first), uint32_t(3 * count)});
    }
    const Cause cause = decision.relation == SphereRelation::Outside ? Cause::OutsideFrustum : causeOf(decision);
    counters.culledTriangles[size_t(cause)] += mesh.maps->mesh().triangleCount() - decision.drawnTriangles;
    ++counters.nodesVisited;
    if (decision.bands) {
        counters.nodesVisited += mesh.bandCells->cells.size();
        counters.bytesTouched += mesh.bandCells->bytes() + (mesh.horizonCells ? mesh.horizonCells->bytes() : 0);
    }
    if (!counters.figures.empty() || !decision.rays.front().followed) return;
    // Of the first object for which rays were followed.
    if (decision.region) counters.figures.push_back({"case", double(decision.region->caseNumber)});
    const auto hits = std::ranges::count_if(decision.rays, [](const CornerRay& ray) { return ray.hit.has_value(); });
    counters.figures.push_back({"rays_hit", double(hits)});
}

StructureSnapshot MappedCulling::snapshotOf(const MappedScene& structure, const FrameLog& log) const {
    const std::vector<std::optional<FrustumPlane>> rejectedBy = rejectingPlanes(log, structure.scene().instances().size());
    StructureSnapshot result;
    std::vector<MapSnapshot> maps;
    for (const SphericalDecision& decision : decisionsOf(log)) {
        result.nodes.push_back(nodeOf(structure.scene(), decision));
        result.nodes.back().rejectedBy = rejectedBy[decision.instance];
        maps.push_back(mapOfDecision(structure, log, decision));
    }
    setMaps(result, std::move(maps));
    return result;
}

DrawList MappedCulling::decidedAhead(const Structure& structure, const FrameLog& log, size_t entries) const {
    DrawList ahead = StrategyWithMaps::decidedAhead(structure, log, entries);
    const size_t all = std::min(entries, log.entries()), done = log.commandsWithin(all);
    if (done > 0) return ahead;
    const auto objects = bandsInHand(log, all - done);
    // Cells of such an object are named by its bands, and then again by its ranges.
    std::erase_if(ahead.ranges, [&](const DrawRange& range) { return objects.contains(range.instance); });
    for (const auto& [instance, object] : objects) {
        const MappedMesh& mesh = own(structure).meshOf(instance);
        for (const CellRun& run : cellsSoFar(*mesh.bandCells, object).drawn)
            if (const auto [first, count] = mesh.maps->run(run.first, run.last); count > 0)
                ahead.ranges.push_back({instance, uint32_t(3 * first), uint32_t(3 * count)});
    }
    return ahead;
}

MapSnapshot MappedCulling::mapOfDecision(const MappedScene& structure, const FrameLog& log,
                                         const SphericalDecision& decision) const {
    const MappedMesh& mesh = structure.meshOf(decision.instance);
    MapSnapshot map{mesh.maps, decision};
    if (log.whole) return map;
    const auto objects = bandsInHand(log, log.decisions.size());
    const auto object = objects.find(decision.instance);
    if (object == objects.end()) return map;
    CellsSoFar cells = cellsSoFar(*mesh.bandCells, object->second);
    map.decision.drawnTriangles = 0;
    for (const CellRun& run : cells.drawn) map.decision.drawnTriangles += mesh.maps->run(run.first, run.last).second;
    map.decision.drawn = std::move(cells.drawn);
    map.undecided = std::move(cells.undecided);
    return map;
}

}  // namespace cullscope::spherical
