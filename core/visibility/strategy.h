#pragma once

#include <array>
#include <chrono>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/base/message.h"
#include "core/base/progress.h"
#include "core/frame/draw_list.h"
#include "core/gpu/context.h"
#include "core/gpu/renderer.h"
#include "core/scene/camera.h"
#include "core/scene/scene.h"
#include "core/visibility/parameters.h"
#include "core/visibility/structure_snapshot.h"
#include "core/visibility/trace.h"

namespace cullscope {

enum class Promise {
    Exact,         ///< draws what is visible and nothing else that could be visible
    Conservative,  ///< loses no visible pixel; may draw too much
    Approximate    ///< may lose pixels; their number is measured
};
/// The id used in files: "exact", "conservative", "approximate".
[[nodiscard]] const char* promiseId(Promise promise);

/// What a strategy needs of OpenGL in order to cull.
enum class GlRequirement {
    None,                 ///< culls on the processor only
    Context,              ///< `cull` needs a renderer and its context current
    CompatibilityProfile  ///< as Context, and features that exist only in a compatibility profile
};

/// The properties of a strategy that do not depend on an instance of it.
struct StrategyInfo {
    std::string id;           ///< on the command line and in files
    std::string name;         ///< English, marked for translation
    std::string description;  ///< one English sentence, marked for translation
    std::string source;       ///< paper or textbook
    std::vector<ParameterDeclaration> parameters;
    GlRequirement glRequirement = GlRequirement::None;
};

/// Why a strategy cannot be used with an OpenGL; none where it can.
[[nodiscard]] std::optional<Message> unavailable(const StrategyInfo& info, const GlInfo& gl);
/// Throws Error(OpenGl) with that reason.
void requireAvailable(const StrategyInfo& info, const GlInfo& gl);

struct Stage {
    std::string name;  ///< English, marked for translation
    double milliseconds = 0.0;
};

/// One of a strategy's tests and its result in one `cull`.
struct CullPart {
    std::string name;      ///< English, marked for translation
    uint64_t objects = 0;  ///< objects that it was applied to
    uint64_t culledTriangles = 0;
};

/// The result of one `cull`.
struct Verdict {
    DrawList drawList;
    uint64_t consideredTriangles = 0;                     ///< submitted to OpenGL
    std::array<uint64_t, kCauseCount> culledTriangles{};  ///< by Cause; triangles that OpenGL culls itself (back faces) are not
                                                          ///< known here
    std::vector<CullPart> parts;                          ///< of strategies that combine several tests: the result of each
    uint64_t nodesVisited = 0;
    uint64_t bytesTouched = 0;  ///< of the strategy's structures
    int caseNumber = 0;         ///< 1 to 3: of Han & Hong's cases, of the first object that the frustum cuts; 0: none
    std::vector<Stage> stages;
    double cullMilliseconds = 0.0;  ///< all of `cull`
};

/// Measures the time from its construction to its destruction and adds it to a verdict as a stage.
class StageTimer {
public:
    StageTimer(Verdict& verdict, const char* name) : m_verdict(verdict), m_name(name) {}
    ~StageTimer() {
        const std::chrono::duration<double, std::milli> passed = std::chrono::steady_clock::now() - m_start;
        m_verdict.stages.push_back({m_name, passed.count()});
    }
    StageTimer(const StageTimer&) = delete;
    StageTimer& operator=(const StageTimer&) = delete;

private:
    Verdict& m_verdict;
    const char* m_name;
    std::chrono::steady_clock::time_point m_start = std::chrono::steady_clock::now();
};

/// Size and build time of a strategy's structures, for `cullbench inspect` and result files.
struct StructureReport {
    double buildMilliseconds = 0.0;
    uint64_t bytes = 0;
    struct Figure {
        std::string name;  ///< "objects", "nodes", "cells", "depth"
        double value = 0.0;
    };
    std::vector<Figure> figures;
};

/// Decides which triangles are drawn. One object serves one scene at a time; `cull` may be called from one thread at a time. A
/// strategy never draws and does not know any window; one that needs OpenGL (StrategyInfo::glRequirement) uses it through a
/// renderer.
class Strategy {
public:
    explicit Strategy(ParameterSet parameters) : m_parameters(std::move(parameters)) {}
    virtual ~Strategy() = default;
    Strategy(const Strategy&) = delete;
    Strategy& operator=(const Strategy&) = delete;

    [[nodiscard]] const ParameterSet& parameters() const { return m_parameters; }

    /// Builds the structures for culling this scene and measures the time. The scene must outlive the next build or the strategy.
    void build(const Scene& scene, const Progress& progress = {});
    /// Needs a build before. `trace`, if not null, receives every decision (slower). `renderer` is used by strategies that need
    /// OpenGL and may be null for the others. Throws Error(OpenGl) where such a strategy gets none or lacks a feature.
    [[nodiscard]] Verdict cull(const View& view, Trace* trace = nullptr, Renderer* renderer = nullptr);

    /// The promise for the built scene with these parameters.
    [[nodiscard]] virtual Promise promise() const = 0;
    /// The promise at a view, where it depends on the eye's position; never stronger than `promise()`.
    [[nodiscard]] virtual Promise promiseAt(const View& /*view*/) const { return promise(); }
    /// The facing rule for the built scene: by the parameter (visibility/facing.h), unless a strategy overrides it.
    [[nodiscard]] virtual Facing facing() const { return m_facing; }
    /// The facing rule of the reference that the strategy is measured against: its own, except for `backface`.
    [[nodiscard]] virtual Facing referenceFacing() const { return facing(); }
    /// The boxes that the strategy tests, with the results of the traced cull of the built scene; empty for a strategy without
    /// boxes.
    [[nodiscard]] virtual StructureSnapshot snapshot(const Trace& /*trace*/) const { return {}; }
    [[nodiscard]] const StructureReport& structure() const { return m_structure; }

protected:
    virtual void buildStructures(const Scene& scene, const Progress& progress, StructureReport& report) = 0;
    /// Fills the draw list's ranges and the counters; `cull` fills in facing, considered triangles and the total time.
    virtual void decide(const View& view, Verdict& verdict, Trace* trace) = 0;
    [[nodiscard]] const Scene& scene() const { return *m_scene; }
    /// The renderer passed to the current `cull`. Throws Error(OpenGl) where none was passed.
    [[nodiscard]] Renderer& renderer() const;

private:
    ParameterSet m_parameters;
    const Scene* m_scene = nullptr;
    Facing m_facing = Facing::TwoSided;
    Renderer* m_renderer = nullptr;  ///< set while `cull` runs
    StructureReport m_structure;
};

using StrategyPointer = std::unique_ptr<Strategy>;

}  // namespace cullscope
