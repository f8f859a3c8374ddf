#pragma once

#include "core/visibility/spherical/listings.h"
#include "core/visibility/spherical/map_shows.h"
#include "core/visibility/spherical/mapped_scene.h"
#include "core/visibility/spherical/object_space_view.h"

namespace cullscope::spherical {

/// The decision about one object. It does not depend on other objects, so that objects are decided in parallel.
struct MappedObject {
    SphericalDecision decision;
    std::optional<ObjectRecord> record;  ///< only while the frame is recorded
};

/// The common part of the strategies that decide by cells of maps: maps, relation to the frustum, draw list, records.
class MappedCulling : public StrategyWithMaps<MappedScene> {
    using StrategyWithMaps::StrategyWithMaps;

public:
    /// Besides what decisions name, the cells of bands that were found to be drawn.
    [[nodiscard]] DrawList decidedAhead(const Structure& structure, const FrameLog& log, size_t entries) const final;

protected:
    /// Decides about an object that intersects the frustum: fills `drawn` and the parts of the decision that are displayed.
    /// `record`, if it is not null, is told of the tests of rays, bands and cells where they fall.
    virtual void decideAbout(const MappedMesh& mesh, const ObjectSpaceView& view, const ParameterSet& parameters,
                             SphericalDecision& decision, ObjectRecord* record) const = 0;
    /// The cause of triangles that `decideAbout` culls.
    [[nodiscard]] virtual Cause causeOf(const SphericalDecision& decision) const = 0;
    /// The line of the listing at which an object was decided that is not outside.
    [[nodiscard]] virtual BandsLine lineOf(const SphericalDecision& decision) const = 0;
    /// Whether the ranges of cells that are drawn are said.
    [[nodiscard]] virtual bool saysRanges() const { return true; }
    /// What the strategy builds for a mesh besides its maps.
    virtual void buildFor(MappedScene& /*structure*/, MappedMesh& /*mesh*/) const {}

    void fill(MappedScene& structure, const ParameterSet& parameters, const Progress& progress) const override;
    void decide(FrameContext& frame, const MappedScene& structure, ViewState& state,
                const ParameterSet& parameters) const override;
    [[nodiscard]] StructureSnapshot snapshotOf(const MappedScene& structure, const FrameLog& log) const override;
    [[nodiscard]] MapSnapshot mapOfDecision(const MappedScene& structure, const FrameLog& log,
                                            const SphericalDecision& decision) const override;

private:
    [[nodiscard]] std::vector<MappedObject> decideAll(FrameContext& frame, const MappedScene& structure,
                                                      const ParameterSet& parameters) const;
    void decideOne(const FrameContext& frame, const MappedMesh& mesh, const ParameterSet& parameters, MappedObject& object) const;
    /// Says what became of an object.
    void sayEnd(const MappedMesh& mesh, const SphericalDecision& decision, ObjectRecord& record) const;
    void submit(const MappedMesh& mesh, const SphericalDecision& decision, DrawList& list, FrameCounters& counters) const;
};

}  // namespace cullscope::spherical
