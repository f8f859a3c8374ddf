#include "core/visibility/spherical/spherical_culling.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

#include "core/base/message.h"
#include "core/visibility/facing.h"
#include "core/visibility/spherical/object_space_view.h"
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

ParameterDeclaration wholeNumber(std::string key, int64_t value, double least, double most, std::string description) {
    return {std::move(key), ParameterType::Integer, value, least, most, "", std::move(description), {}};
}

ParameterDeclaration rowsParameter() {
    return wholeNumber(
        "rows", SphericalGrid::kRows, 0, 4096,
        CULLSCOPE_TR("Rows of the maps, 2 at least; columns are twice as many. A mesh has no more cells than triangles. "
                     "0: as many cells a triangle as in the paper."));
}

std::vector<ParameterDeclaration> bandParameters(double width, int64_t sectors) {
    return {
        {"band", ParameterType::Real, width, 0.25, 45.0, "°", CULLSCOPE_TR("Width of a contour band, seen from the centre."), {}},
        wholeNumber("sectors", sectors, 1, 1440, CULLSCOPE_TR("Sectors into which a contour band is divided."))};
}

/// The common part of both strategies: maps, relation to the frustum, draw list, trace.
class SphericalCulling : public Strategy {
public:
    using Strategy::Strategy;

    [[nodiscard]] StructureSnapshot snapshot(const Trace& trace) const override {
        const std::vector<std::optional<FrustumPlane>> rejectedBy = rejectingPlanes(trace, scene().instances().size());
        StructureSnapshot result;
        for (const SphericalDecision& decision : trace.spherical) {
            result.nodes.push_back(nodeOf(decision));
            result.nodes.back().rejectedBy = rejectedBy[decision.instance];
            result.maps.push_back({mappedMesh(decision.instance).maps, decision});
        }
        return result;
    }

protected:
    /// Decides about an object that intersects the frustum: fills `drawn` and the parts of the decision that are displayed.
    virtual void decideAbout(const MappedMesh& mesh, const ObjectSpaceView& view, SphericalDecision& decision,
                             bool traced) const = 0;
    /// The cause of triangles that `decideAbout` culls.
    [[nodiscard]] virtual Cause causeOf(SphereRelation relation) const = 0;
    virtual void buildFor(MappedMesh& mesh) = 0;

    [[nodiscard]] double bandWidth() const { return Angle::fromDegrees(parameters().real("band")).radians(); }
    [[nodiscard]] uint32_t sectors() const { return uint32_t(parameters().integer("sectors")); }

    void buildStructures(const Scene& scene, const Progress& progress, StructureReport& report) override {
        m_meshes.clear();
        m_meshes.resize(scene.meshes().size());
        const std::vector<bool> shown = scene.shownMeshes();
        for (size_t i = 0; i < m_meshes.size(); ++i) {
            if (!shown[i]) continue;
            const Progress part = progress.part(double(i) / double(m_meshes.size()), double(i + 1) / double(m_meshes.size()));
            m_meshes[i].maps = std::make_shared<SphericalMaps>(scene.meshes()[i], gridFor(*scene.meshes()[i]), part);
            m_meshes[i].bandCells = std::make_unique<BandCells>(*m_meshes[i].maps);
            part.check();
            buildFor(m_meshes[i]);
        }
        m_order = orderOfAll();
        fillReport(report);
    }

    void decide(const View& view, Verdict& verdict, Trace* trace) override {
        const std::vector<Decided> decided = decideAll(view, trace != nullptr, verdict);
        const StageTimer stage(verdict, CULLSCOPE_TR("draw list"));
        verdict.drawList.order = m_order;
        for (const Decided& object : decided) {
            const MappedMesh& mesh = mappedMesh(object.decision.instance);
            if (!mesh.maps) continue;
            submit(mesh, object.decision, verdict);
            if (trace != nullptr) record(mesh, object, *trace);
        }
    }

private:
    [[nodiscard]] const MappedMesh& mappedMesh(uint32_t instance) const { return m_meshes[scene().instances()[instance].mesh]; }

    [[nodiscard]] SphericalGrid gridFor(const TriangleMesh& mesh) const {
        const auto rows = uint32_t(parameters().integer("rows"));
        if (rows == 0) return SphericalGrid::forTriangles(mesh.triangleCount());
        // With more cells than triangles most cells would be empty; the limit saves memory in a scene of many small meshes.
        const auto most = uint32_t(std::ceil(std::sqrt(double(mesh.triangleCount()) / 2.0)));
        const uint32_t taken = std::max(std::min(rows, most), 2u);
        return SphericalGrid(2 * taken, taken);
    }

    [[nodiscard]] TriangleOrderPointer orderOfAll() const {
        auto order = std::make_shared<TriangleOrder>();
        auto owner = std::make_shared<std::vector<SphericalMapsPointer>>();
        for (const MappedMesh& mesh : m_meshes) {
            owner->push_back(mesh.maps);
            order->meshes.push_back(mesh.maps ? TriangleOrder::OfMesh{mesh.maps->indices(), mesh.maps->triangleOrder()}
                                              : TriangleOrder::OfMesh{});
        }
        order->owner = std::move(owner);
        return order;
    }

    void fillReport(StructureReport& report) const {
        double cells = 0, entries = 0, centroid = 0, index = 0, access = 0, bands = 0, rows = 0;
        SphericalMaps::BuildTimes times;
        for (const MappedMesh& mesh : m_meshes) {
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
        report.bytes = uint64_t(centroid + index + access + bands);
        report.figures = {{"objects", double(scene().instances().size())},
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
    struct Decided {
        ObjectSpaceView seen;
        SphericalDecision decision;
    };

    [[nodiscard]] std::vector<Decided> decideAll(const View& view, bool traced, Verdict& verdict) const {
        const StageTimer stage(verdict, CULLSCOPE_TR("maps and bands"));
        std::vector<Decided> decided(scene().instances().size());
        tbb::parallel_for(uint32_t{0}, uint32_t(decided.size()), [&](uint32_t i) {
            const MappedMesh& mesh = mappedMesh(i);
            SphericalDecision& decision = decided[i].decision;
            decision.instance = i;
            if (!mesh.maps) return;
            const ObjectSpaceView seen = decided[i].seen = objectSpaceView(scene(), i, mesh.maps->sphere(), view);
            decision.relation = seen.relation;
            decision.eye = seen.eye;
            decideByRelation(mesh, seen, decision, traced);
            for (const CellRun& run : decision.drawn) decision.drawnTriangles += mesh.maps->run(run.first, run.last).second;
        });
        return decided;
    }

    void decideByRelation(const MappedMesh& mesh, const ObjectSpaceView& seen, SphericalDecision& decision, bool traced) const {
        if (seen.relation == SphereRelation::AroundEye)
            decision.drawn = {{0, mesh.maps->grid().cellCount()}};
        else if (seen.relation != SphereRelation::Outside)
            decideAbout(mesh, seen, decision, traced);
    }

    void submit(const MappedMesh& mesh, const SphericalDecision& decision, Verdict& verdict) const {
        for (const CellRun& run : decision.drawn) {
            const auto [first, count] = mesh.maps->run(run.first, run.last);
            if (count == 0) continue;
            verdict.drawList.ranges.push_back({decision.instance, uint32_t(3 * first), uint32_t(3 * count)});
        }
        const Cause cause = decision.relation == SphereRelation::Outside ? Cause::OutsideFrustum : causeOf(decision.relation);
        verdict.culledTriangles[size_t(cause)] += mesh.maps->mesh().triangleCount() - decision.drawnTriangles;
        ++verdict.nodesVisited;
        if (decision.bands) {
            verdict.nodesVisited += mesh.bandCells->cells.size();
            verdict.bytesTouched += mesh.bandCells->bytes() + (mesh.horizonCells ? mesh.horizonCells->bytes() : 0);
        }
        if (decision.region && verdict.caseNumber == 0) verdict.caseNumber = decision.region->caseNumber;
    }

    void record(const MappedMesh& mesh, const Decided& object, Trace& trace) const {
        const auto& [seen, decision] = object;
        for (size_t p = 0; p < seen.planesTested; ++p) {
            const ObjectSpaceView::PlaneTest& test = seen.planes[p];
            trace.events.push_back({TraceEvent::Kind::TestedPlane, decision.instance, static_cast<FrustumPlane>(p),
                                    test.containment, test.distance, Cause::OutsideFrustum, test.bound});
        }
        TraceEvent end{TraceEvent::Kind::PartlyDrawn, decision.instance};
        if (decision.relation == SphereRelation::Outside)
            end.kind = TraceEvent::Kind::Culled;
        else if (decision.drawnTriangles == mesh.maps->mesh().triangleCount())
            end.kind = TraceEvent::Kind::Accepted;
        else
            end.cause = causeOf(decision.relation);
        trace.events.push_back(end);
        trace.spherical.push_back(decision);
    }

    [[nodiscard]] SnapshotNode nodeOf(const SphericalDecision& decision) const {
        SnapshotNode node;
        node.instance = decision.instance;
        node.box = scene().instanceBox(decision.instance);
        node.triangles = scene().meshOf(decision.instance).triangleCount();
        node.culled = decision.relation == SphereRelation::Outside;
        node.containment = node.culled                                   ? Containment::Outside
                           : decision.relation == SphereRelation::Within ? Containment::Inside
                                                                         : Containment::Straddles;
        return node;
    }

    std::vector<MappedMesh> m_meshes;
    TriangleOrderPointer m_order;
};

class Spherical final : public SphericalCulling {
public:
    explicit Spherical(ParameterSet set)
        : SphericalCulling(std::move(set)), m_join(parameters().choice("joined") == "arcs" ? Join::Arcs : Join::Chart) {}
    [[nodiscard]] Promise promise() const override { return Promise::Approximate; }

protected:
    void buildFor(MappedMesh& /*mesh*/) override {}
    [[nodiscard]] Cause causeOf(SphereRelation relation) const override {
        return relation == SphereRelation::Within ? Cause::Hidden : Cause::OutsideFrustum;
    }

    void decideAbout(const MappedMesh& mesh, const ObjectSpaceView& view, SphericalDecision& decision,
                     bool traced) const override {
        if (view.relation == SphereRelation::Within) {
            decision.bands = makeBands(view.eye, bandWidth(), sectors());
            decision.drawn = drawnByS(*mesh.bandCells, *decision.bands);
            return;
        }
        for (size_t i = 0; i < decision.rays.size(); ++i)
            // The ray starts at the near plane: nothing before it is visible.
            decision.rays[i] = followCorner(*mesh.maps, {view.eye + view.cornerDirections[i], view.cornerDirections[i]}, traced);
        decision.region = visibleRegion(*mesh.maps, decision.rays, m_join);
        decision.drawn = runsOf(mesh.maps->grid(), *decision.region);
    }

private:
    Join m_join;
};

class SphericalHorizon final : public SphericalCulling {
    static constexpr size_t kFewTriangles = 500;

public:
    using SphericalCulling::SphericalCulling;
    [[nodiscard]] Promise promise() const override { return m_starShaped ? Promise::Conservative : Promise::Approximate; }

protected:
    void buildStructures(const Scene& scene, const Progress& progress, StructureReport& report) override {
        m_starShaped = true;
        SphericalCulling::buildStructures(scene, progress, report);
    }
    void buildFor(MappedMesh& mesh) override {
        mesh.horizonCells = std::make_unique<HorizonCells>(*mesh.maps, *mesh.bandCells);
        // Above the limit the star-shape test is not run, because the user did not request it; the weaker promise is made
        // instead.
        m_starShaped =
            m_starShaped && mesh.maps->mesh().triangleCount() <= kOptionalAnalysisLimit && isStarShaped(*mesh.maps, facing());
    }
    [[nodiscard]] Cause causeOf(SphereRelation /*relation*/) const override { return Cause::Hidden; }

    void decideAbout(const MappedMesh& mesh, const ObjectSpaceView& view, SphericalDecision& decision,
                     bool traced) const override {
        // A surface that the near plane cuts hides nothing, and an object of few triangles is drawn faster than it is tested.
        if (!view.beyondNear || mesh.maps->mesh().triangleCount() < kFewTriangles) {
            decision.drawn = {{0, mesh.maps->grid().cellCount()}};
            return;
        }
        decision.bands = makeBands(view.eye, bandWidth(), sectors());
        decision.drawn = drawnBySlope(*mesh.maps, *mesh.bandCells, *mesh.horizonCells, view, *decision.bands);
        if (traced) markDrawnSectors(*mesh.maps, *mesh.bandCells, decision.drawn, *decision.bands);
    }

private:
    bool m_starShaped = true;
};

}  // namespace

StrategyInfo sphericalInfo() {
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
    return info;
}

StrategyPointer makeSpherical(ParameterSet parameters) { return std::make_unique<Spherical>(std::move(parameters)); }

StrategyInfo sphericalHorizonInfo() {
    StrategyInfo info{"spherical-horizon",
                      CULLSCOPE_TR("Spherical coordinates, exact horizon"),
                      CULLSCOPE_TR("Leaves out cells whose slope lies below the horizon of the surface in front of them: loses "
                                   "nothing of star-shaped objects."),
                      "Han & Hong 2008, S replaced by the slope",
                      {facingParameter(), rowsParameter()}};
    std::ranges::move(bandParameters(3.0, 72), std::back_inserter(info.parameters));
    return info;
}

StrategyPointer makeSphericalHorizon(ParameterSet parameters) {
    return std::make_unique<SphericalHorizon>(std::move(parameters));
}

}  // namespace cullscope::spherical
