#include "core/visibility/occlusion/occlusion_chc.h"

#include "core/base/message.h"
#include "core/visibility/facing.h"
#include "core/visibility/occlusion/chc_walk.h"
#include "core/visibility/occlusion/query_octree.h"

namespace cullscope::occlusion {
namespace {

constexpr const char* kTogether = "together";
constexpr const char* kRetest = "retest";
constexpr const char* kPhase = "phase";
constexpr const char* kRandomPhase = "random";
constexpr const char* kSamePhase = "same";
constexpr const char* kLevels = "depth";
constexpr const char* kArea = "area";

constexpr QueryBarLines kChcBarLines{uint8_t(ChcLine::Outside), uint8_t(ChcLine::Unasked), uint8_t(ChcLine::Ask),
                                     uint8_t(ChcLine::Hidden), uint8_t(ChcLine::Draw)};

struct ChcMemory : ViewState {
    ChcHistory history;

    [[nodiscard]] ViewStatePointer clone() const override { return std::make_unique<ChcMemory>(*this); }
};

class OcclusionChc final : public QueryStrategy<ChcMemory> {
public:
    OcclusionChc() : QueryStrategy(kChcBarLines) {}

protected:
    void decide(FrameContext& frame, const QueryOctree& structure, ChcMemory& memory,
                const ParameterSet& parameters) const override {
        const StageTimer stage(frame, CULLSCOPE_TR("walk and queries"));
        ChcOptions options;
        options.latency = size_t(parameters.integer(kLatency));
        options.batch = size_t(parameters.integer(kBatch));
        options.together = size_t(parameters.integer(kTogether));
        options.retest.every = uint64_t(parameters.integer(kRetest));
        options.retest.random = parameters.choice(kPhase) == kRandomPhase;
        options.depth = size_t(parameters.integer(kLevels));
        options.area = parameters.real(kArea);
        options.retest.waits = options.latency == 0;
        const ChcCounters counted = walkCoherently(structure.octree, frame, options, memory.history);
        frame.counters().figures = {
            {"queries", double(counted.queries)},        {"hidden_nodes", double(counted.hidden)},
            {"query_batches", double(counted.batches)},  {"query_boxes", double(counted.boxes)},
            {"multi_queries", double(counted.multi)},    {"split_queries", double(counted.split)},
            {"retest_queries", double(counted.retests)},
        };
    }
};

Show chcListing() {
    return listingShow({{CULLSCOPE_TR("visit the nearest group left"), 0},
                        {CULLSCOPE_TR("test its box against the frustum"), 1},
                        {CULLSCOPE_TR("outside: leave all its objects out"), 1},
                        {CULLSCOPE_TR("first, near or visible before: visible"), 1},
                        {CULLSCOPE_TR("a leaf and due: ask again at the end"), 2},
                        {CULLSCOPE_TR("else ask OpenGL, several in one query"), 1},
                        {CULLSCOPE_TR("some of several show: ask one by one"), 1},
                        {CULLSCOPE_TR("no: hidden, leave all its objects out"), 1},
                        {CULLSCOPE_TR("visible: visit(parts), nearest first"), 1},
                        {CULLSCOPE_TR("no parts: draw its objects"), 1}});
}

}  // namespace

RegisteredStrategy occlusionChc() {
    StrategyInfo info{
        "occlusion-chc",
        CULLSCOPE_TR("Coherent hierarchical culling (CHC++)"),
        CULLSCOPE_TR("Draws what was visible in the frame before, and asks OpenGL about what was hidden, many groups at once."),
        "Mattausch, Bittner & Wimmer 2008, CHC++: Coherent Hierarchical Culling Revisited",
        {facingParameter(),
         wholeParameter(kLatency, 0, 0, 1,
                        CULLSCOPE_TR("How many frames later answers about hidden groups are used; 0: they are waited for, and "
                                     "nothing is lost.")),
         wholeParameter(kBatch, 50, 1, 4096,
                        CULLSCOPE_TR("How many groups that were hidden are gathered before OpenGL is asked about them.")),
         wholeParameter(kTogether, 50, 1, 4096,
                        CULLSCOPE_TR("How many groups one query covers at most; 1: each has a query of its own.")),
         wholeParameter(kRetest, 10, 1, 1000,
                        CULLSCOPE_TR("After how many frames a visible group without parts is asked about again.")),
         choiceParameter(kPhase, kRandomPhase, CULLSCOPE_TR("After how many frames that is done for the first time."),
                         {{kRandomPhase, CULLSCOPE_TR("a random part of these frames, so that the queries spread")},
                          {kSamePhase, CULLSCOPE_TR("all of these frames")}}),
         wholeParameter(kLevels, 3, 0, 8,
                        CULLSCOPE_TR("How many levels below a group lie the boxes by which it is asked about, at most; 0: by its "
                                     "own box.")),
         {kArea,
          ParameterType::Real,
          1.4,
          0.0,
          100.0,
          "",
          CULLSCOPE_TR("How many times the surface of the group's own box these boxes have together, at most."),
          {}},
         leafParameter()},
        GlRequirement::Context};
    info.remembers = true;
    info.sweeps = {{kLatency, {"0", "1"}}, {kBatch, {"1", "10", "50", "200"}}, {kRetest, {"1", "5", "10", "20"}}};
    info.shows = {treeShow(), chcListing(), queryBarsShow()};
    return {std::move(info), std::make_shared<OcclusionChc>()};
}

}  // namespace cullscope::occlusion
