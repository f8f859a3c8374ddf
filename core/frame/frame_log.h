#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/base/message.h"
#include "core/frame/cause.h"
#include "core/frame/commands.h"
#include "core/frame/decision.h"
#include "core/scene/scene.h"

namespace cullscope {

/// Time of one part of a frame's decisions.
struct Stage {
    std::string name;  ///< English, marked for translation
    double milliseconds = 0.0;
};

/// One of a strategy's tests and its result in one frame.
struct CullPart {
    std::string name;      ///< English, marked for translation
    uint64_t objects = 0;  ///< objects that it was applied to
    uint64_t culledTriangles = 0;
};

/// A number by its name, as result files have it.
struct NamedFigure {
    std::string name;
    double value = 0.0;
};

/// A parameter that a strategy moved by itself, and what it was in one frame.
struct HeldParameter {
    std::string key;
    double value = 0.0;
    std::string unit;  ///< as in its declaration
};

/// What one frame counted.
struct FrameCounters {
    std::array<uint64_t, kCauseCount> culledTriangles{};  ///< by Cause; triangles that OpenGL culls itself (back faces) are not
                                                          ///< known here
    std::vector<CullPart> parts;                          ///< of strategies that combine several tests: the result of each
    uint64_t nodesVisited = 0;
    uint64_t bytesTouched = 0;         ///< of the strategy's structures
    uint64_t workBytes = 0;            ///< memory that the frame needed besides the structure and what its commands hold
    std::vector<NamedFigure> figures;  ///< what a family counts besides
    std::vector<HeldParameter> held;   ///< in force in place of what they are set to
};

/// What a decision found that is no number, such as where a ray ended: plain data of the family that said it, for its own shows.
/// Only the family's files know the derived type.
struct DecisionDetail {
    virtual ~DecisionDetail() = default;
};
/// The detail of one decision of a log.
struct LoggedDetail {
    size_t decision = 0;  ///< its number
    std::shared_ptr<const DecisionDetail> detail;
};

/// Everything of one frame, in the order in which it happened: the commands as they were executed, the decisions where they were
/// asked for, counters, and time by stage. The picture, the item buffer, counts, colours by verdict and every explanation are
/// replays of it.
struct FrameLog {
    Camera camera;  ///< the culling view's
    Viewport size;  ///< the culling view's
    Facing facing = Facing::TwoSided;
    std::vector<Command> commands;
    bool recorded = false;              ///< whether decisions were asked for
    std::vector<Decision> decisions;    ///< empty unless `recorded`
    TriangleOrderPointer order;         ///< that decisions about cells count places in; null: every mesh's own
    std::vector<uint32_t> objects;      ///< instances that decisions about nodes refer to
    std::vector<LoggedDetail> details;  ///< of decisions that have one, by ascending number
    /// What the decisions leave out because the frame has too much of it, and from what size on; most important first. English,
    /// marked for translation. Empty: they say everything.
    std::vector<Message> coarser;
    bool whole = true;  ///< false: the first entries of a frame that has more; the rest is not decided yet
    FrameCounters counters;
    std::vector<Stage> stages;
    double cullMilliseconds = 0.0;  ///< the whole frame without executing and logging draw commands
    /// How long the view's frame before took, cull and draw together, as the strategy was told; none: it was not.
    std::optional<double> frameBeforeMilliseconds;

    /// What it gave to OpenGL; of a finished picture the triangles that it shows.
    [[nodiscard]] uint64_t consideredTriangles() const;
    /// Memory that the frame needed besides the structure: what its commands hold, such as a picture or triangles that the
    /// strategy made, and FrameCounters::workBytes.
    [[nodiscard]] uint64_t frameBytes() const;
    /// Whether every command draws the scene's own triangles with a depth test: then the order of the commands does not matter.
    [[nodiscard]] bool drawsScene() const;
    /// Object where a command draws stand-ins (frame/draw_list.h): the frame is compared with the scene object by object.
    [[nodiscard]] Grain grain() const;
    /// Commands and decisions together.
    [[nodiscard]] size_t entries() const { return commands.size() + decisions.size(); }
    /// How many commands are among the first `entries` entries.
    [[nodiscard]] size_t commandsWithin(size_t entries) const;
    /// The first `entries` entries, for a replay of a part. Counters and stages are those of the whole frame.
    [[nodiscard]] FrameLog upTo(size_t entries) const;
    /// The instances of a decision about a node.
    [[nodiscard]] std::span<const uint32_t> objectsOf(const Decision& decision) const {
        return std::span(objects).subspan(decision.firstObject, decision.objectCount);
    }
};

/// The scene's triangles that a frame drew, each once, as one draw list with the frame's facing rule: what the frame shows from
/// any other place. Of parts of triangles the whole triangles, of a finished picture those that it shows. Of stand-ins what was
/// drawn, if it is one list, else the whole objects.
[[nodiscard]] DrawList drawnTriangles(const Scene& scene, const FrameLog& log);

/// By which number a pixel that shows a triangle of the scene is compared (`item`: its number + 1; 0: nothing): the same by
/// triangle, that of the first triangle of its object by object.
[[nodiscard]] uint32_t comparedItem(const Scene& scene, Grain grain, uint32_t item);

}  // namespace cullscope
