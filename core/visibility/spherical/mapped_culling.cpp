#include "core/visibility/spherical/mapped_culling.h"

#include <tbb/parallel_for.h>

#include "core/base/message.h"
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

/// The same bands before anything was said of their sectors.
ContourBands unsaid(ContourBands bands) {
    bands.table.assign(bands.table.size(), {});
    return bands;
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
    const std::vector<MappedObject> decided = decideAll(frame, structure, parameters);
    DrawList list{frame.facing(), {}, structure.order};
    {
        const StageTimer stage(frame, CULLSCOPE_TR("draw list"));
        if (frame.recording()) frame.countPlacesIn(structure.order);
        if (frame.recording() && decided.size() > kMostWithTests) sayResultsAlone(frame);
        for (const MappedObject& object : decided) {
            const MappedMesh& mesh = structure.meshOf(object.decision.instance);
            if (!mesh.maps) continue;
            submit(mesh, object.decision, list, frame.counters());
            if (frame.recording()) record(mesh, object, decided.size() <= kMostWithTests, frame);
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
        SphericalDecision& decision = decided[i].decision;
        decision.instance = i;
        if (!mesh.maps) return;
        const ObjectSpaceView seen = decided[i].seen = objectSpaceView(frame.scene(), i, mesh.maps->sphere(), frame.view());
        decision.relation = seen.relation;
        decision.eye = seen.eye;
        if (seen.relation == SphereRelation::AroundEye)
            decision.drawn = {{0, mesh.maps->grid().cellCount()}};
        else if (seen.relation != SphereRelation::Outside)
            decideAbout(mesh, seen, parameters, decision, frame.recording());
        for (const CellRun& run : decision.drawn) decision.drawnTriangles += mesh.maps->run(run.first, run.last).second;
    });
    return decided;
}

void MappedCulling::submit(const MappedMesh& mesh, const SphericalDecision& decision, DrawList& list,
                           FrameCounters& counters) const {
    for (const CellRun& run : decision.drawn) {
        const auto [first, count] = mesh.maps->run(run.first, run.last);
        if (count == 0) continue;
        list.ranges.push_back({decision.instance, uint32_t(3 * first), uint32_t(3 * count)});
    }
    const Cause cause = decision.relation == SphereRelation::Outside ? Cause::OutsideFrustum : causeOf(decision.relation);
    counters.culledTriangles[size_t(cause)] += mesh.maps->mesh().triangleCount() - decision.drawnTriangles;
    ++counters.nodesVisited;
    if (decision.bands) {
        counters.nodesVisited += mesh.bandCells->cells.size();
        counters.bytesTouched += mesh.bandCells->bytes() + (mesh.horizonCells ? mesh.horizonCells->bytes() : 0);
    }
    // Of the first object that the frustum cuts.
    if (decision.region && counters.figures.empty()) counters.figures.push_back({"case", double(decision.region->caseNumber)});
}

void MappedCulling::record(const MappedMesh& mesh, const MappedObject& object, bool tests, FrameContext& frame) const {
    const auto& [seen, decision] = object;
    const Subject subject = Subject::ofObject(decision.instance);
    recordTests(seen, subject, uint8_t(BandsLine::Sphere), frame);
    frame.attach(std::make_shared<SphereDetail>(decision.relation, decision.eye));
    if (decision.bands) frame.attach(std::make_shared<BandsDetail>(tests ? unsaid(*decision.bands) : *decision.bands));
    const size_t before = frame.said();
    if (tests) sayTests(mesh, decision, frame);
    for (uint32_t i = 0; i < decision.rays.size(); ++i)
        if (decision.rays[i].followed)
            frame.attach(std::make_shared<RayDetail>(i, decision.rays[i]), {Subject::Kind::Ray, i, decision.instance}, before);
    if (decision.region)
        frame.attach(std::make_shared<RegionDetail>(*decision.region),
                     {Subject::Kind::Cells, CellGroups::kRegion, decision.instance}, before);
    const bool outside = decision.relation == SphereRelation::Outside;
    Decision end = ending(subject, decision.drawnTriangles > 0 ? Decision::Outcome::PartlyDrawn : Decision::Outcome::Culled,
                          outside ? Cause::OutsideFrustum : causeOf(decision.relation));
    if (decision.drawnTriangles == mesh.maps->mesh().triangleCount()) end = ending(subject, Decision::Outcome::Drawn);
    frame.say(atLine(outside ? BandsLine::Outside : lineOf(decision), end));
    frame.attach(std::make_shared<RunsDetail>(decision.drawn, decision.drawnTriangles));
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

MapSnapshot MappedCulling::mapOfDecision(const MappedScene& structure, const FrameLog& /*log*/,
                                         const SphericalDecision& decision) const {
    return {structure.meshOf(decision.instance).maps, decision};
}

}  // namespace cullscope::spherical
