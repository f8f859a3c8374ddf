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
    Approximate    ///< may lose pixels: how many is measured
};
/// "exact", "conservative", "approximate": as in files.
[[nodiscard]] const char* promiseId(Promise promise);

/// What a strategy needs of OpenGL in order to decide.
enum class GlRequirement {
    None,                 ///< the processor decides
    Context,              ///< `cull` needs a renderer, and its context current
    CompatibilityProfile  ///< the same with features that only a compatibility profile has
};

/// What is known of a strategy before it is made.
struct StrategyInfo {
    std::string id;           ///< on the command line and in files
    std::string name;         ///< English, marked for translation
    std::string description;  ///< one English sentence, marked for translation
    std::string source;       ///< paper or textbook
    std::vector<ParameterDeclaration> parameters;
    GlRequirement glRequirement = GlRequirement::None;
};

/// Why a strategy cannot be used with an OpenGL; nothing where it can.
[[nodiscard]] std::optional<Message> unavailable(const StrategyInfo& info, const GlInfo& gl);
/// Throws Error(OpenGl) saying it.
void requireAvailable(const StrategyInfo& info, const GlInfo& gl);

struct Stage {
    std::string name;  ///< English, marked for translation
    double milliseconds = 0.0;
};

/// One of a strategy's tests, and what it did in one `cull`.
struct CullPart {
    std::string name;      ///< English, marked for translation
    uint64_t objects = 0;  ///< for which it held and was made
    uint64_t culledTriangles = 0;
};

/// The answer to one `cull`.
struct Verdict {
    DrawList drawList;
    uint64_t consideredTriangles = 0;                     ///< given to OpenGL
    std::array<uint64_t, kCauseCount> culledTriangles{};  ///< by Cause; what OpenGL culls itself (back faces) is not known here
    std::vector<CullPart> parts;  ///< of strategies that put several tests together: what each of them left out
    uint64_t nodesVisited = 0;
    uint64_t bytesTouched = 0;  ///< of the strategy's structures
    int caseNumber = 0;         ///< 1 to 3: of Han & Hong's cases, of the first object that the frustum cuts; 0: none
    std::vector<Stage> stages;
    double cullMilliseconds = 0.0;  ///< all of `cull`
};

/// Adds the time from its making to its end to a verdict as a stage.
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

/// What a strategy built: for `cullbench inspect` and result files.
struct StructureReport {
    double buildMilliseconds = 0.0;
    uint64_t bytes = 0;
    struct Figure {
        std::string name;  ///< "objects", "nodes", "cells", "depth"
        double value = 0.0;
    };
    std::vector<Figure> figures;
};

/// Decides what to draw. One object serves one scene at a time; `cull` may be called from one thread at a time.
/// A strategy never draws and knows no window; one that asks OpenGL (StrategyInfo::glRequirement) asks through a renderer.
class Strategy {
public:
    explicit Strategy(ParameterSet parameters) : m_parameters(std::move(parameters)) {}
    virtual ~Strategy() = default;
    Strategy(const Strategy&) = delete;
    Strategy& operator=(const Strategy&) = delete;

    [[nodiscard]] const ParameterSet& parameters() const { return m_parameters; }

    /// Prepares what culling this scene needs and times it. The scene must outlive the next build or the strategy.
    void build(const Scene& scene, const Progress& progress = {});
    /// Needs a build before. `trace`, where given, gets every decision (slower). `renderer` is what a strategy asks that asks
    /// OpenGL; the others need none. Throws Error(OpenGl) where it asks for what is not there.
    [[nodiscard]] Verdict cull(const View& view, Trace* trace = nullptr, Renderer* renderer = nullptr);

    /// What it promises for the built scene with its parameters.
    [[nodiscard]] virtual Promise promise() const = 0;
    /// What it promises at a view, where that depends on the eye's place; never more than `promise()`.
    [[nodiscard]] virtual Promise promiseAt(const View& /*view*/) const { return promise(); }
    /// The facing rule for the built scene: its parameter's (visibility/facing.h), unless it overrides it.
    [[nodiscard]] virtual Facing facing() const { return m_facing; }
    /// The facing rule of the ground truth that it is measured against: its own, except for `backface`.
    [[nodiscard]] virtual Facing referenceFacing() const { return facing(); }
    /// The boxes that it tests, with what the traced cull of the built scene decided about each; empty where it has none.
    [[nodiscard]] virtual StructureSnapshot snapshot(const Trace& /*trace*/) const { return {}; }
    [[nodiscard]] const StructureReport& structure() const { return m_structure; }

protected:
    virtual void buildStructures(const Scene& scene, const Progress& progress, StructureReport& report) = 0;
    /// Fills the draw list's ranges and the counters; facing, considered triangles and the total time are filled in by `cull`.
    virtual void decide(const View& view, Verdict& verdict, Trace* trace) = 0;
    [[nodiscard]] const Scene& scene() const { return *m_scene; }
    /// What the `cull` under way may ask. Throws Error(OpenGl) where it was given none.
    [[nodiscard]] Renderer& renderer() const;

private:
    ParameterSet m_parameters;
    const Scene* m_scene = nullptr;
    Facing m_facing = Facing::TwoSided;
    Renderer* m_renderer = nullptr;  ///< while `cull` runs
    StructureReport m_structure;
};

using StrategyPointer = std::unique_ptr<Strategy>;

}  // namespace cullscope
