#include "core/visibility/spherical/spherical_culling.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

#include "core/base/message.h"
#include "core/visibility/facing.h"
#include "core/visibility/spherical/listings.h"
#include "core/visibility/spherical/map_shows.h"
#include "core/visibility/spherical/object_space_view.h"
#include "core/visibility/spherical/recorded_tests.h"
#include "core/visibility/spherical/slope_horizon.h"
#include "core/visibility/spherical/visible_region.h"

namespace cullscope::spherical {
namespace {

/// The structures that both strategies have for one mesh.
struct MappedMesh {
    SphericalMapsPointer maps;
    std::unique_ptr<const BandCells> bandCells;
    std::unique_ptr<const HorizonCells> horizonCells;  ///< of `spherical-horizon`
};

/// The maps of a scene's meshes.
struct MappedScene : Structure {
    using Structure::Structure;

    [[nodiscard]] const MappedMesh& meshOf(uint32_t instance) const { return meshes[scene().instances()[instance].mesh]; }

    std::vector<MappedMesh> meshes;
    TriangleOrderPointer order;
    /// Whether every mesh is star-shaped around its centre, for pictures of both sides and of front sides; of
    /// `spherical-horizon`.
    bool starShaped = false, starShapedInFront = false;
};

ParameterDeclaration wholeNumber(std::string key, int64_t value, double least, double most, std::string description) {
    return {std::move(key), ParameterType::Integer, value, least, most, "", std::move(description), {}};
}

ParameterDeclaration rowsParameter() {
    return readWhenBuilding(
        wholeNumber("rows", SphericalGrid::kRows, 0, 4096,
                    CULLSCOPE_TR("Rows of the maps, 2 at least; columns are twice as many. A mesh has no more cells than "
                                 "triangles. 0: as many cells a triangle as in the paper.")));
}

std::vector<ParameterDeclaration> bandParameters(double width, int64_t sectors) {
    return {
        {"band", ParameterType::Real, width, 0.25, 45.0, "°", CULLSCOPE_TR("Width of a contour band, seen from the centre."), {}},
        wholeNumber("sectors", sectors, 1, 1440, CULLSCOPE_TR("Sectors into which a contour band is divided."))};
}

double bandWidth(const ParameterSet& parameters) { return Angle::fromDegrees(parameters.real("band")).radians(); }
uint32_t sectors(const ParameterSet& parameters) { return uint32_t(parameters.integer("sectors")); }

SphericalGrid gridFor(const TriangleMesh& mesh, const ParameterSet& parameters) {
    const auto rows = uint32_t(parameters.integer("rows"));
    if (rows == 0) return SphericalGrid::forTriangles(mesh.triangleCount());
    // With more cells than triangles most cells would be empty; the limit saves memory in a scene of many small meshes.
    const auto most = uint32_t(std::ceil(std::sqrt(double(mesh.triangleCount()) / 2.0)));
    const uint32_t taken = std::max(std::min(rows, most), 2u);
    return SphericalGrid(2 * taken, taken);
}

TriangleOrderPointer orderOfAll(const std::vector<MappedMesh>& meshes) {
    auto order = std::make_shared<TriangleOrder>();
    auto owner = std::make_shared<std::vector<SphericalMapsPointer>>();
    for (const MappedMesh& mesh : meshes) {
        owner->push_back(mesh.maps);
        order->meshes.push_back(mesh.maps ? TriangleOrder::OfMesh{mesh.maps->indices(), mesh.maps->triangleOrder()}
                                          : TriangleOrder::OfMesh{});
    }
    order->owner = std::move(owner);
    return order;
}

void fillReport(MappedScene& structure) {
    double cells = 0, entries = 0, centroid = 0, index = 0, access = 0, bands = 0, rows = 0;
    SphericalMaps::BuildTimes times;
    for (const MappedMesh& mesh : structure.meshes) {
        if (!mesh.maps) continue;
        const SphericalMaps::Bytes bytes = mesh.maps->bytes();
        cells += mesh.maps->grid().cellCount();
        rows = std::max(rows, double(mesh.maps->grid().rows()));
        entries += double(mesh.maps->indexEntries());
        centroid += double(bytes.centroidMap);
        index += double(bytes.indexMap);
        access += double(bytes.accessMap);
        bands += double(mesh.bandCells->bytes() + (mesh.horizonCells ? mesh.horizonCells->bytes() : 0));
        times.centroidMap += mesh.maps->buildTimes().centroidMap;
        times.indexMap += mesh.maps->buildTimes().indexMap;
        times.accessMap += mesh.maps->buildTimes().accessMap;
    }
    structure.report.bytes = uint64_t(centroid + index + access + bands);
    structure.report.figures = {{"objects", double(structure.scene().instances().size())},
                                {"rows", rows},
                                {"cells", cells},
                                {"index map entries", entries},
                                {"centroid map bytes", centroid},
                                {"index map bytes", index},
                                {"memory access map bytes", access},
                                {"band cell bytes", bands},
                                {"centroid map ms", times.centroidMap},
                                {"index map ms", times.indexMap},
                                {"memory access map ms", times.accessMap}};
}

/// The decision about one object. It does not depend on other objects, so that objects are decided in parallel.
struct MappedObject {
    ObjectSpaceView seen;
    SphericalDecision decision;
};

/// The common part of both strategies: maps, relation to the frustum, draw list, records.
class SphericalCulling : public StrategyWithMaps<MappedScene> {
    using StrategyWithMaps::StrategyWithMaps;

protected:
    /// Decides about an object that intersects the frustum: fills `drawn` and the parts of the decision that are displayed.
    virtual void decideAbout(const MappedMesh& mesh, const ObjectSpaceView& view, const ParameterSet& parameters,
                             SphericalDecision& decision, bool recording) const = 0;
    /// The cause of triangles that `decideAbout` culls.
    [[nodiscard]] virtual Cause causeOf(SphereRelation relation) const = 0;
    /// The line of the listing at which an object was decided that is not outside.
    [[nodiscard]] virtual BandsLine lineOf(const SphericalDecision& decision) const = 0;
    /// What the strategy builds for a mesh besides its maps.
    virtual void buildFor(MappedScene& /*structure*/, MappedMesh& /*mesh*/) const {}

    void fill(MappedScene& structure, const ParameterSet& parameters, const Progress& progress) const override {
        const Scene& scene = structure.scene();
        structure.meshes.resize(scene.meshes().size());
        const std::vector<bool> shown = scene.shownMeshes();
        const auto count = double(structure.meshes.size());
        for (size_t i = 0; i < structure.meshes.size(); ++i) {
            if (!shown[i]) continue;
            const Progress part = progress.part(double(i) / count, double(i + 1) / count);
            MappedMesh& mesh = structure.meshes[i];
            mesh.maps = std::make_shared<SphericalMaps>(scene.meshes()[i], gridFor(*scene.meshes()[i], parameters), part);
            mesh.bandCells = std::make_unique<BandCells>(*mesh.maps);
            part.check();
            buildFor(structure, mesh);
        }
        structure.order = orderOfAll(structure.meshes);
        fillReport(structure);
    }

    void decide(FrameContext& frame, const MappedScene& structure, ViewState& /*state*/,
                const ParameterSet& parameters) const override {
        std::vector<MappedObject> decided = decideAll(frame, structure, parameters);
        DrawList list{frame.facing(), {}, structure.order};
        {
            const StageTimer stage(frame, CULLSCOPE_TR("draw list"));
            for (MappedObject& object : decided) {
                const MappedMesh& mesh = structure.meshOf(object.decision.instance);
                if (!mesh.maps) continue;
                submit(mesh, object.decision, list, frame.counters());
                if (frame.recording()) record(mesh, object, decided.size() <= kMostWithTests, frame);
            }
            if (frame.recording()) keepNotes(structure, decided, frame);
        }
        frame.draw(std::move(list));
    }

    [[nodiscard]] StructureSnapshot snapshotOf(const MappedScene& structure, const FrameLog& log) const override {
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

    [[nodiscard]] MapSnapshot mapOfDecision(const MappedScene& structure, const FrameLog& /*log*/,
                                            const SphericalDecision& decision) const override {
        return {structure.meshOf(decision.instance).maps, decision};
    }

private:
    [[nodiscard]] std::vector<MappedObject> decideAll(FrameContext& frame, const MappedScene& structure,
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

    void submit(const MappedMesh& mesh, const SphericalDecision& decision, DrawList& list, FrameCounters& counters) const {
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
        if (decision.region && counters.figures.empty())
            counters.figures.push_back({"case", double(decision.region->caseNumber)});
    }

    /// `tests`: those of rays and bands, too.
    void record(const MappedMesh& mesh, MappedObject& object, bool tests, FrameContext& frame) const {
        auto& [seen, decision] = object;
        const Subject subject = Subject::ofObject(decision.instance);
        recordTests(seen, subject, uint8_t(BandsLine::Sphere), frame);
        if (tests) {
            recordRays(*mesh.maps, decision, frame);
            recordBands(decision, frame);
            recordRanges(*mesh.maps, decision, uint8_t(lineOf(decision)), frame);
        }
        const bool outside = decision.relation == SphereRelation::Outside;
        Decision end = ending(subject, decision.drawnTriangles > 0 ? Decision::Outcome::PartlyDrawn : Decision::Outcome::Culled,
                              outside ? Cause::OutsideFrustum : causeOf(decision.relation));
        if (decision.drawnTriangles == mesh.maps->mesh().triangleCount()) end = ending(subject, Decision::Outcome::Drawn);
        frame.say(atLine(outside ? BandsLine::Outside : lineOf(decision), end));
        decision.said = frame.said();
    }

    static void keepNotes(const MappedScene& structure, std::vector<MappedObject>& decided, FrameContext& frame) {
        frame.countPlacesIn(structure.order);
        auto notes = std::make_shared<SphericalNotes>();
        for (MappedObject& object : decided)
            if (structure.meshOf(object.decision.instance).maps) notes->decisions.push_back(std::move(object.decision));
        frame.note(std::move(notes));
    }

    [[nodiscard]] static SnapshotNode nodeOf(const Scene& scene, const SphericalDecision& decision) {
        SnapshotNode node;
        node.instance = decision.instance;
        node.box = scene.instanceBox(decision.instance);
        node.triangles = scene.meshOf(decision.instance).triangleCount();
        node.culled = decision.relation == SphereRelation::Outside;
        node.containment = containmentOf(decision.relation);
        return node;
    }
};

class Spherical final : public SphericalCulling {
    using SphericalCulling::SphericalCulling;

protected:
    [[nodiscard]] Promise promiseOf(const MappedScene& /*structure*/, const ParameterSet& /*parameters*/,
                                    Facing /*facing*/) const override {
        return Promise::Approximate;
    }
    [[nodiscard]] Cause causeOf(SphereRelation relation) const override {
        return relation == SphereRelation::Within ? Cause::Hidden : Cause::OutsideFrustum;
    }
    [[nodiscard]] BandsLine lineOf(const SphericalDecision& decision) const override { return lineOfBands(decision); }

    void decideAbout(const MappedMesh& mesh, const ObjectSpaceView& view, const ParameterSet& parameters,
                     SphericalDecision& decision, bool recording) const override {
        if (view.relation == SphereRelation::Within) {
            decision.bands = makeBands(view.eye, bandWidth(parameters), sectors(parameters));
            decision.drawn = drawnByS(*mesh.bandCells, *decision.bands);
            return;
        }
        for (size_t i = 0; i < decision.rays.size(); ++i)
            // The ray starts at the near plane: nothing before it is visible.
            decision.rays[i] =
                followCorner(*mesh.maps, {view.eye + view.cornerDirections[i], view.cornerDirections[i]}, recording);
        const Join join = parameters.choice("joined") == "arcs" ? Join::Arcs : Join::Chart;
        decision.region = visibleRegion(*mesh.maps, decision.rays, join);
        decision.drawn = runsOf(mesh.maps->grid(), *decision.region);
    }
};

class SphericalHorizon final : public SphericalCulling {
    using SphericalCulling::SphericalCulling;

    static constexpr size_t kFewTriangles = 500;

protected:
    [[nodiscard]] Promise promiseOf(const MappedScene& structure, const ParameterSet& /*parameters*/,
                                    Facing facing) const override {
        const bool starShaped = facing == Facing::Front ? structure.starShapedInFront : structure.starShaped;
        return starShaped ? Promise::Conservative : Promise::Approximate;
    }

    void fill(MappedScene& structure, const ParameterSet& parameters, const Progress& progress) const override {
        structure.starShaped = structure.starShapedInFront = true;
        SphericalCulling::fill(structure, parameters, progress);
    }
    void buildFor(MappedScene& structure, MappedMesh& mesh) const override {
        mesh.horizonCells = std::make_unique<HorizonCells>(*mesh.maps, *mesh.bandCells);
        // Above the limit the star-shape test is not run, because the user did not request it; the weaker promise is made
        // instead.
        const bool tested = structure.starShaped && mesh.maps->mesh().triangleCount() <= kOptionalAnalysisLimit;
        structure.starShaped = tested && isStarShaped(*mesh.maps, Facing::TwoSided);
        structure.starShapedInFront =
            structure.starShaped && structure.starShapedInFront && isStarShaped(*mesh.maps, Facing::Front);
    }
    [[nodiscard]] Cause causeOf(SphereRelation /*relation*/) const override { return Cause::Hidden; }
    [[nodiscard]] BandsLine lineOf(const SphericalDecision& decision) const override { return lineOfHorizon(decision); }
    void decideAbout(const MappedMesh& mesh, const ObjectSpaceView& view, const ParameterSet& parameters,
                     SphericalDecision& decision, bool recording) const override {
        // A surface that the near plane cuts hides nothing, and an object of few triangles is drawn faster than it is tested.
        if (!view.beyondNear || mesh.maps->mesh().triangleCount() < kFewTriangles) {
            decision.drawn = {{0, mesh.maps->grid().cellCount()}};
            return;
        }
        decision.bands = makeBands(view.eye, bandWidth(parameters), sectors(parameters));
        decision.drawn = drawnBySlope(*mesh.maps, *mesh.bandCells, *mesh.horizonCells, view, *decision.bands);
        if (recording) markDrawnSectors(*mesh.maps, *mesh.bandCells, decision.drawn, *decision.bands);
    }
};

}  // namespace

RegisteredStrategy spherical() {
    StrategyInfo info{"spherical",
                      CULLSCOPE_TR("Spherical coordinates"),
                      CULLSCOPE_TR("Looks up on a map of directions what four corner rays enclose; seen whole, compares contour "
                                   "bands by S. As published, with its losses."),
                      "Han & Hong 2008",
                      {facingParameter("two-sided"), rowsParameter()}};
    std::ranges::move(bandParameters(5.0, 36), std::back_inserter(info.parameters));
    info.parameters.push_back(
        choiceParameter("joined", "chart", CULLSCOPE_TR("How the four hits are joined to the visible region."),
                        {{"chart", CULLSCOPE_TR("straight on the map, so that the extremes are the hits'")},
                         {"arcs", CULLSCOPE_TR("by great circles, whose extremes may lie between the hits")}}));
    info.sweeps = {{"rows", {"45", "90", "180", "360"}}, {"band", {"2.5", "5", "10", "20"}}};
    info.shows = withListing(showsOfBands(), bandsListing());
    return {info, std::make_shared<Spherical>(info.id)};
}

RegisteredStrategy sphericalHorizon() {
    StrategyInfo info{"spherical-horizon",
                      CULLSCOPE_TR("Spherical coordinates, exact horizon"),
                      CULLSCOPE_TR("Leaves out cells whose slope lies below the horizon of the surface in front of them: loses "
                                   "nothing of star-shaped objects."),
                      "Han & Hong 2008, S replaced by the slope",
                      {facingParameter(), rowsParameter()}};
    std::ranges::move(bandParameters(3.0, 72), std::back_inserter(info.parameters));
    info.shows = withListing(showsOfBands(), horizonListing());
    return {info, std::make_shared<SphericalHorizon>(info.id)};
}

}  // namespace cullscope::spherical
