#pragma once

#include "core/visibility/registry.h"
#include "core/visibility/structure_store.h"

namespace cullscope {

/// A strategy with its parameters and what it built for a scene. Immutable: views, meters and experiments share it, each with a
/// ViewState of its own.
class BuiltStrategy {
public:
    BuiltStrategy(const RegisteredStrategy& strategy, ParameterSet parameters, StructurePointer structure);

    [[nodiscard]] const StrategyInfo& info() const { return m_info; }
    [[nodiscard]] const std::string& id() const { return m_info.id; }
    [[nodiscard]] const ParameterSet& parameters() const { return m_parameters; }
    [[nodiscard]] const StructurePointer& structure() const { return m_structure; }
    [[nodiscard]] const StructureReport& report() const { return m_structure->report; }
    [[nodiscard]] const Scene& scene() const { return m_structure->scene(); }
    [[nodiscard]] const ScenePointer& scenePointer() const { return m_structure->scenePointer(); }

    [[nodiscard]] Promise promise() const { return m_strategy->promise(*m_structure, m_parameters, m_facing); }
    /// Everything is drawn in a view that the strategy does not serve: that loses nothing. Of one that waits for its file it says
    /// nothing.
    [[nodiscard]] Promise promiseAt(const View& view) const {
        if (unserved(view.camera())) return m_info.decidesByFile.empty() ? Promise::Conservative : Promise::Approximate;
        return m_strategy->promiseAt(*m_structure, m_parameters, m_facing, view);
    }
    /// Why it draws everything in the views of a camera; none where it decides.
    [[nodiscard]] std::optional<Message> unserved(const Camera& camera) const {
        return cullscope::unserved(m_info, m_parameters, camera);
    }
    [[nodiscard]] Facing facing() const { return m_facing; }
    [[nodiscard]] Facing referenceFacing() const { return m_referenceFacing; }

    [[nodiscard]] ViewStatePointer begin() const { return m_strategy->begin(*m_structure); }
    /// One frame in a context: the strategy decides, and the context executes what it says. Throws Error(OpenGl) where the
    /// strategy needs OpenGL and the context has none.
    void draw(FrameContext& frame, ViewState& state) const;
    /// One frame that is not drawn, for strategies that decide on the processor.
    [[nodiscard]] FrameLog decide(const View& culling, ViewState& state, bool recording = false) const;

    /// Without nodes for a strategy that declares no Tree.
    [[nodiscard]] StructureSnapshot snapshot(const FrameLog& log) const;

    [[nodiscard]] SubjectShape groupShape(const StructureSnapshot& snapshot, uint32_t number) const;
    [[nodiscard]] std::optional<uint32_t> groupAt(uint64_t triangle, const Vec3& point) const {
        return m_strategy->groupAt(*m_structure, triangle, point);
    }
    [[nodiscard]] NamedParts parts(const FrameLog& log) const;
    [[nodiscard]] NamedParts partsByLeaf(const FrameLog& log) const;

    [[nodiscard]] std::vector<MeshStates> meshStates() const { return m_strategy->meshStates(*m_structure, m_parameters); }

    // Of a recorded frame.

    [[nodiscard]] DrawList decidedAhead(const FrameLog& log, size_t entries) const {
        return m_strategy->decidedAhead(*m_structure, log, entries);
    }
    /// The lines of an overlay that the strategy declares; none for any other id.
    [[nodiscard]] std::vector<OverlayLines> overlay(std::string_view id, const OverlayContext& context,
                                                    const FrameLog& log) const;
    /// Why the boxes, or an overlay or a map that some strategy declares, cannot be shown of this frame; none where they can, and
    /// for any other id. `colouring`: of a map, else empty.
    [[nodiscard]] std::optional<Message> whyNotShown(std::string_view id, std::string_view colouring, const FrameLog& log) const;
    /// A map of directions that the strategy declares (strategy.h); null for any other id.
    [[nodiscard]] CellMapPointer directionMap(std::string_view id, const FrameLog& log,
                                              const std::optional<uint32_t>& object = {}) const;
    /// A curve that the strategy declares (strategy.h); none for any other id.
    [[nodiscard]] std::optional<Curve> curve(std::string_view id, const FrameLog& log, const std::optional<uint32_t>& object,
                                             const std::optional<uint32_t>& part) const;
    /// The counts that the strategy declares, each with its declared title.
    [[nodiscard]] std::vector<Bars> bars(const FrameLog& log) const;
    /// Where the frame's decisions fell in the strategy's listing; none where it declares no listing.
    [[nodiscard]] std::optional<ListingState> listing(const FrameLog& log) const;
    /// The same of the decisions about one triangle (frame/listing.h).
    [[nodiscard]] std::optional<ListingState> listing(const FrameLog& log, uint64_t triangle) const;
    [[nodiscard]] std::string frameLine(const FrameLog& log) const;
    void addWhySteps(const FrameLog& log, uint32_t instance, uint32_t triangle, std::vector<WhyStep>& steps) const;

private:
    /// The frame of a view that the strategy does not serve.
    static void drawEverything(FrameContext& frame);

    StrategyInfo m_info;
    std::shared_ptr<const Strategy> m_strategy;
    ParameterSet m_parameters;
    StructurePointer m_structure;
    Facing m_facing, m_referenceFacing;
};
using BuiltStrategyPointer = std::shared_ptr<const BuiltStrategy>;

/// Builds a strategy for a scene, or takes what another one of the scene built with the same build parameters. Throws what
/// findStrategy and Strategy::build throw.
[[nodiscard]] BuiltStrategyPointer buildStrategy(const RegisteredStrategy& strategy, const ParameterSet& parameters,
                                                 const ScenePointer& scene, StructureStore& store, const Progress& progress = {});
[[nodiscard]] BuiltStrategyPointer buildStrategy(std::string_view id, const ParameterSet& parameters, const ScenePointer& scene,
                                                 StructureStore& store, const Progress& progress = {});

/// What a registered strategy promises with its default parameters for a small closed solid, by its id: what lists say before a
/// scene is open. Of another scene the promise may be weaker (BuiltStrategy::promise).
[[nodiscard]] Promise usualPromise(const std::string& id);

}  // namespace cullscope
