#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/message.h"
#include "core/base/progress.h"
#include "core/frame/frame_context.h"
#include "core/gpu/context.h"
#include "core/scene/camera.h"
#include "core/scene/scene.h"
#include "core/visibility/bars.h"
#include "core/visibility/parameters.h"
#include "core/visibility/show.h"
#include "core/visibility/structure_snapshot.h"

namespace cullscope {

struct CellMap;
struct Curve;
struct NamedParts;
struct OverlayContext;
struct OverlayLines;
struct SubjectShape;
struct WhyStep;

using CellMapPointer = std::shared_ptr<const CellMap>;

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
    Context,              ///< its frames need a context that draws (gpu/gpu_frame.h)
    CompatibilityProfile  ///< as Context, and features that exist only in a compatibility profile
};

/// One parameter over several values, all others at their defaults: one line of the plot of speed against lost pixels.
struct DeclaredSweep {
    std::string key;
    std::vector<std::string> values;  ///< as on the command line
    std::string automatic{};          ///< the value with which the strategy chooses itself; empty: there is none
};

/// What the others are compared with by a strategy that is measured along with them.
enum class BaselineRole {
    None,       ///< it is no baseline
    Triangles,  ///< drawing every triangle: what the papers compare with
    FrontFaces  ///< drawing every front face: the strong baseline
};

/// The properties of a strategy that do not depend on a scene.
struct StrategyInfo {
    std::string id;           ///< on the command line and in files
    std::string name;         ///< English, marked for translation
    std::string description;  ///< one English sentence, marked for translation
    std::string source;       ///< paper or textbook
    std::vector<ParameterDeclaration> parameters;
    GlRequirement glRequirement = GlRequirement::None;
    bool remembers = false;  ///< what it draws depends on the frames before, by its ViewState: a frame is judged with that memory
    BaselineRole baseline = BaselineRole::None;
    bool limit = false;  ///< it knows beforehand what is visible: its speed is what any culling could gain at most
    std::vector<DeclaredSweep> sweeps{};
    std::vector<Show> shows{};
    /// With CompatibilityProfile: why it cannot be used with an OpenGL that gives none, and what to use instead. One English
    /// sentence, marked for translation; %1 is the strategy's id, %2 the name of that OpenGL.
    std::string withoutProfile{};
    /// Its method asks where the eye is: a parallel view has none, so it decides nothing there and draws everything (unserved).
    bool needsEyePoint = false;
    /// The file parameter by whose content it decides: without a name there it draws everything (unserved). Empty: none.
    std::string decidesByFile{};

    /// The show with this id; null where the strategy declares none.
    [[nodiscard]] const Show* show(std::string_view showId) const;
    /// The first show of a kind; null where the strategy declares none.
    [[nodiscard]] const Show* first(Show::Kind kind) const;
};

/// Why a strategy cannot be used with an OpenGL; none where it can.
[[nodiscard]] std::optional<Message> unavailable(const StrategyInfo& info, const GlInfo& gl);
/// Throws Error(OpenGl) with that reason.
void requireAvailable(const StrategyInfo& info, const GlInfo& gl);

/// Why a strategy decides nothing with these parameters in the views of a camera and draws every triangle there; none where it
/// serves them.
[[nodiscard]] std::optional<Message> unserved(const StrategyInfo& info, const ParameterSet& parameters, const Camera& camera);

/// Size and build time of a strategy's structures, for `cullbench inspect` and result files.
struct StructureReport {
    double buildMilliseconds = 0.0;
    uint64_t bytes = 0;
    struct Figure {
        std::string name;  ///< "objects", "nodes", "cells", "depth"
        double value = 0.0;
    };
    std::vector<Figure> figures;
    std::string layout;  ///< id of the layout of the structures' cells; empty: there is only one
};

/// Something that a strategy has for each mesh in one of several states, such as an inner kernel.
struct MeshStates {
    std::string key;                       ///< in result files
    std::string name;                      ///< English
    std::map<std::string, size_t> meshes;  ///< number of meshes by state, English
};

/// What a strategy built for a scene with those of its parameters that are read when building. Does not change afterwards; every
/// view, meter and experiment of the scene shares it (StructureStore).
class Structure {
public:
    explicit Structure(ScenePointer scene) : m_scene(std::move(scene)) {}
    virtual ~Structure() = default;
    Structure(const Structure&) = delete;
    Structure& operator=(const Structure&) = delete;

    [[nodiscard]] const Scene& scene() const { return *m_scene; }
    [[nodiscard]] const ScenePointer& scenePointer() const { return m_scene; }

    StructureReport report;

private:
    ScenePointer m_scene;
};
using StructurePointer = std::shared_ptr<const Structure>;

/// What one view remembers from frame to frame. A view whose scene, structure or parameters change begins anew.
struct ViewState {
    /// How long the view's last frame took, cull and draw together. What times frames writes it after each one (renderFrame; the
    /// desktop's pictures); none: it was not timed. The next frame is told (FrameContext::frameBeforeMilliseconds).
    std::optional<double> frameMilliseconds;
    /// Whether the strategy, told this frame's time, may decide another one for the same view: what it remembers is not settled.
    /// The desktop then asks for further frames while the view stands.
    bool unsteady = false;

    virtual ~ViewState() = default;
    /// A state of its own with the same memory.
    [[nodiscard]] virtual std::unique_ptr<ViewState> clone() const { return std::make_unique<ViewState>(*this); }
};
using ViewStatePointer = std::unique_ptr<ViewState>;

/// A way to decide what is drawn. Has no state: what it built is in a Structure, what a view remembers in a ViewState. Any number
/// of threads may use it.
class Strategy {
public:
    virtual ~Strategy() = default;

    /// Builds what the strategy needs for a scene; `Structure::report` gets bytes and figures, but not the time. Throws
    /// Error(Interrupted) on a stop request.
    [[nodiscard]] virtual std::shared_ptr<Structure> build(const ScenePointer& scene, const ParameterSet& parameters,
                                                           const Progress& progress) const = 0;
    /// Finds, once for a structure, what its promise rests on and no frame needs: its time is not the structure's. Without it the
    /// promise is one that holds in any case. Throws Error(Interrupted) on a stop request.
    virtual void prove(Structure& /*structure*/, const Progress& /*progress*/) const {}
    /// The memory of a view without a past.
    [[nodiscard]] virtual ViewStatePointer begin(const Structure& /*structure*/) const { return std::make_unique<ViewState>(); }
    /// One frame: says to `frame` what is drawn, in order, and, while it records, every decision where it falls.
    virtual void draw(FrameContext& frame, const Structure& structure, ViewState& state,
                      const ParameterSet& parameters) const = 0;

    /// The promise for a scene with these parameters.
    [[nodiscard]] virtual Promise promise(const Structure& structure, const ParameterSet& parameters, Facing facing) const = 0;
    /// The promise at a view, where it depends on the eye's position; never stronger than `promise`.
    [[nodiscard]] virtual Promise promiseAt(const Structure& structure, const ParameterSet& parameters, Facing facing,
                                            const View& /*view*/) const {
        return promise(structure, parameters, facing);
    }
    /// The facing rule for a scene: by the parameter (visibility/facing.h), unless a strategy has a rule of its own.
    [[nodiscard]] virtual Facing facing(const Scene& scene, const ParameterSet& parameters) const;
    /// The facing rule of the reference that the strategy is measured against: its own, except for `backface`.
    [[nodiscard]] virtual Facing referenceFacing(const Scene& scene, const ParameterSet& parameters) const {
        return facing(scene, parameters);
    }
    /// The boxes that the strategy tests, if it declares a Tree, with the decisions of a recorded frame; and where what these
    /// are about lies.
    [[nodiscard]] virtual StructureSnapshot snapshot(const Structure& /*structure*/, const FrameLog& /*log*/) const { return {}; }

    /// Where a group of that snapshot lies, by its number: what views mark when it is chosen. Its box, unless a strategy knows
    /// more.
    [[nodiscard]] virtual SubjectShape groupShape(const Structure& structure, const StructureSnapshot& snapshot,
                                                  uint32_t number) const;
    /// The number of the smallest group of that snapshot that holds a triangle of the scene at a point of it; none: groups hold
    /// objects.
    [[nodiscard]] virtual std::optional<uint32_t> groupAt(const Structure& /*structure*/, uint64_t /*triangle*/,
                                                          const Vec3& /*point*/) const {
        return std::nullopt;
    }
    /// The parts into which a recorded frame cut the scene's objects (frame/named_parts.h), and the places in which they lie.
    [[nodiscard]] virtual NamedParts parts(const Structure& structure, const FrameLog& log) const;
    /// The same for questions about the place in which a part lies: here parts are what lies in one leaf of the strategy's own
    /// tree. Those of `parts`, unless a strategy knows more.
    [[nodiscard]] virtual NamedParts partsByLeaf(const Structure& structure, const FrameLog& log) const;

    /// What the first entries of a recorded frame have decided to draw and no command has drawn yet: by what their decisions name
    /// (frame/decided_ahead.h), unless a strategy knows more.
    [[nodiscard]] virtual DrawList decidedAhead(const Structure& structure, const FrameLog& log, size_t entries) const;

    // What the strategy declares in StrategyInfo::shows, of a recorded frame.

    /// The lines of a declared overlay.
    [[nodiscard]] virtual std::vector<OverlayLines> overlay(std::string_view id, const OverlayContext& context,
                                                            const Structure& structure, const FrameLog& log) const;
    /// Why a declared show has nothing to show of this frame; none where it has. `colouring`: of a map, else empty.
    [[nodiscard]] virtual std::optional<Message> whyNotShown(std::string_view id, std::string_view colouring,
                                                             const Structure& structure, const FrameLog& log) const;
    /// A declared map of directions of one object; null where the frame tells nothing of it. `object` as for a curve. May take as
    /// long as the strategy's own structures do: it is called beside the window.
    [[nodiscard]] virtual CellMapPointer directionMap(std::string_view id, const Structure& structure, const FrameLog& log,
                                                      const std::optional<uint32_t>& object) const;
    /// A declared curve of one object; none where the frame tells nothing of it. `object`: an instance; none, or one that the
    /// frame did not decide about: the one that the strategy shows by itself. `part`: one of CurveParts; none, or one that there
    /// is not: the one that the strategy shows by itself. Cheap enough for the window's thread.
    [[nodiscard]] virtual std::optional<Curve> curve(std::string_view id, const Structure& structure, const FrameLog& log,
                                                     const std::optional<uint32_t>& object,
                                                     const std::optional<uint32_t>& part) const;
    /// Declared counts; of the first entries of a log (FrameLog::upTo), those of its decisions.
    [[nodiscard]] virtual Bars bars(std::string_view id, const Structure& structure, const FrameLog& log) const;
    /// One English line about the frame, which cullbench prints beside a picture; empty: there is nothing to say.
    [[nodiscard]] virtual std::string frameLine(const Structure& structure, const FrameLog& log) const;
    /// The states of what it has for the meshes; empty for most strategies.
    [[nodiscard]] virtual std::vector<MeshStates> meshStates(const Structure& /*structure*/,
                                                             const ParameterSet& /*parameters*/) const {
        return {};
    }
    /// Appends the strategy's own steps of the decision about a triangle, numbered within its instance's mesh (why.h).
    virtual void addWhySteps(const Structure& structure, const FrameLog& log, uint32_t instance, uint32_t triangle,
                             std::vector<WhyStep>& steps) const;
};

/// A Strategy with a structure and a view's memory of its own types.
template <typename OwnStructure, typename OwnState = ViewState>
class StrategyWith : public Strategy {
public:
    [[nodiscard]] std::shared_ptr<Structure> build(const ScenePointer& scene, const ParameterSet& parameters,
                                                   const Progress& progress) const final {
        auto structure = std::make_shared<OwnStructure>(scene);
        fill(*structure, parameters, progress);
        return structure;
    }
    void prove(Structure& structure, const Progress& progress) const final {
        proveFor(static_cast<OwnStructure&>(structure), progress);
    }
    void draw(FrameContext& frame, const Structure& structure, ViewState& state, const ParameterSet& parameters) const final {
        decide(frame, own(structure), static_cast<OwnState&>(state), parameters);
    }
    [[nodiscard]] Promise promise(const Structure& structure, const ParameterSet& parameters, Facing facing) const final {
        return promiseOf(own(structure), parameters, facing);
    }
    [[nodiscard]] StructureSnapshot snapshot(const Structure& structure, const FrameLog& log) const final {
        StructureSnapshot result = snapshotOf(own(structure), log);
        markTested(result, log);
        markReached(result, log);
        return result;
    }

protected:
    [[nodiscard]] static const OwnStructure& own(const Structure& structure) {
        return static_cast<const OwnStructure&>(structure);
    }
    virtual void fill(OwnStructure& structure, const ParameterSet& parameters, const Progress& progress) const = 0;
    virtual void proveFor(OwnStructure& /*structure*/, const Progress& /*progress*/) const {}
    virtual void decide(FrameContext& frame, const OwnStructure& structure, OwnState& state,
                        const ParameterSet& parameters) const = 0;
    [[nodiscard]] virtual Promise promiseOf(const OwnStructure& structure, const ParameterSet& parameters,
                                            Facing facing) const = 0;
    [[nodiscard]] virtual StructureSnapshot snapshotOf(const OwnStructure& /*structure*/, const FrameLog& /*log*/) const {
        return {};
    }
};

}  // namespace cullscope
