#pragma once

#include <memory>
#include <string_view>
#include <utility>

#include "core/gpu/gpu_frame.h"
#include "core/visibility/built_strategy.h"

namespace cullscope::test {

/// Whether a frame's decisions are recorded.
enum class Recording { Off, On };

/// What a draw list stands for: where it has stand-ins, the whole objects that it draws.
inline DrawList standingFor(const DrawList& list, const Scene& scene) {
    if (list.grain == Grain::Triangle) return list;
    DrawList whole{list.facing, {}};
    for (const DrawRange& range : list.ranges)
        whole.ranges.push_back({range.instance, 0, uint32_t(scene.meshOf(range.instance).indices().size())});
    return whole;
}

/// A frame, and its counts by their short names.
struct Culled {
    FrameLog log;
    DrawList drawList;  ///< drawnTriangles
    uint64_t consideredTriangles = 0;
    std::array<uint64_t, kCauseCount> culledTriangles{};
    std::vector<CullPart> parts;
    uint64_t nodesVisited = 0;
    uint64_t bytesTouched = 0;
    int caseNumber = 0;  ///< of Han & Hong's cases; 0: none
};

/// A strategy that a test builds for one scene after another, with the memory of one view. Nothing is drawn.
class Culler {
public:
    explicit Culler(RegisteredStrategy strategy) : Culler(strategy, ParameterSet(strategy.info.parameters)) {}
    Culler(RegisteredStrategy strategy, ParameterSet parameters)
        : m_strategy(std::move(strategy)), m_parameters(std::move(parameters)) {}

    /// The scene must outlive the next build or the culler.
    void build(const Scene& scene) {
        m_built.reset();
        m_buffers.reset();
        const ScenePointer borrowed(&scene, [](const Scene*) {});
        StructureStore store;
        m_built = std::make_shared<const BuiltStrategy>(m_strategy, m_parameters, store.get(m_strategy, m_parameters, borrowed));
        m_state = m_built->begin();
    }
    /// Needs a build before. `renderer`: of the current context, for strategies that ask OpenGL.
    Culled cull(const View& view, Recording recording = Recording::Off, Renderer* renderer = nullptr) {
        const bool recorded = recording == Recording::On;
        Culled culled;
        if (renderer == nullptr) {
            culled.log = m_built->decide(view, *m_state, recorded);
        } else {
            if (!m_buffers) m_buffers = std::make_unique<SceneBuffers>(m_built->scenePointer(), Upload::Vbo);
            GpuFrame frame(*renderer, *m_buffers, view, recorded);
            m_built->draw(frame, *m_state);
            culled.log = frame.take();
        }
        culled.drawList = drawnTriangles(m_built->scene(), culled.log);
        culled.consideredTriangles = culled.log.consideredTriangles();
        culled.culledTriangles = culled.log.counters.culledTriangles;
        culled.parts = culled.log.counters.parts;
        culled.nodesVisited = culled.log.counters.nodesVisited;
        culled.bytesTouched = culled.log.counters.bytesTouched;
        for (const NamedFigure& figure : culled.log.counters.figures)
            if (figure.name == "case") culled.caseNumber = int(figure.value);
        return culled;
    }
    Culled cull(const View& view, Renderer* renderer) { return cull(view, Recording::Off, renderer); }

    [[nodiscard]] const BuiltStrategyPointer& built() const { return m_built; }
    /// The memory of the view.
    [[nodiscard]] ViewState& state() { return *m_state; }
    [[nodiscard]] const ParameterSet& parameters() const { return m_parameters; }
    [[nodiscard]] Promise promise() const { return m_built->promise(); }
    [[nodiscard]] Promise promiseAt(const View& view) const { return m_built->promiseAt(view); }
    [[nodiscard]] Facing facing() const { return m_built->facing(); }
    [[nodiscard]] Facing referenceFacing() const { return m_built->referenceFacing(); }
    [[nodiscard]] const StructureReport& structure() const { return m_built->report(); }
    [[nodiscard]] StructureSnapshot snapshot(const FrameLog& log) const { return m_built->snapshot(log); }

private:
    RegisteredStrategy m_strategy;
    ParameterSet m_parameters;
    BuiltStrategyPointer m_built;
    ViewStatePointer m_state;
    std::unique_ptr<SceneBuffers> m_buffers;
};
using CullerPointer = std::unique_ptr<Culler>;

[[nodiscard]] inline CullerPointer makeCuller(std::string_view id) { return std::make_unique<Culler>(findStrategy(id)); }
[[nodiscard]] inline CullerPointer makeCuller(std::string_view id, ParameterSet parameters) {
    return std::make_unique<Culler>(findStrategy(id), std::move(parameters));
}

}  // namespace cullscope::test
