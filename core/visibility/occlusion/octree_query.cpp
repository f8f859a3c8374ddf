#include "core/visibility/occlusion/octree_query.h"

#include "core/base/message.h"
#include "core/visibility/facing.h"
#include "core/visibility/occlusion/query_octree.h"
#include "core/visibility/occlusion/query_walk.h"

namespace cullscope::occlusion {
namespace {

constexpr const char* kAsk = "ask";
constexpr const char* kNodes = "nodes";
constexpr const char* kLeaves = "leaves";

constexpr QueryBarLines kQueryBarLines{uint8_t(QueryLine::Outside), uint8_t(QueryLine::Unasked), uint8_t(QueryLine::Ask),
                                       uint8_t(QueryLine::Hidden), uint8_t(QueryLine::Draw)};

/// The questions of a view whose answers are still due.
struct QueryMemory : ViewState {
    std::deque<AskedFrame> past;  ///< oldest first

    [[nodiscard]] ViewStatePointer clone() const override { return std::make_unique<QueryMemory>(*this); }
};

class OctreeQuery final : public QueryStrategy<QueryMemory> {
public:
    OctreeQuery() : QueryStrategy(kQueryBarLines) {}

protected:
    void decide(FrameContext& frame, const QueryOctree& structure, QueryMemory& memory,
                const ParameterSet& parameters) const override {
        const StageTimer stage(frame, CULLSCOPE_TR("walk and queries"));
        const QueryOptions options{parameters.choice(kAsk) == kNodes, size_t(parameters.integer(kBatch)),
                                   size_t(parameters.integer(kLatency))};
        const QueryCounters counted = walkByQueries(structure.octree, frame, options, memory.past);
        frame.counters().figures = {{"queries", double(counted.asked)},
                                    {"hidden_nodes", double(counted.hidden)},
                                    {"query_batches", double(counted.batches)}};
    }
};

Show queryListing() {
    return listingShow({{CULLSCOPE_TR("visit(group)"), 0},
                        {CULLSCOPE_TR("test its box against the frustum"), 1},
                        {CULLSCOPE_TR("outside: leave all its objects out"), 1},
                        {CULLSCOPE_TR("first, or across near plane: visible"), 1},
                        {CULLSCOPE_TR("else ask OpenGL: does its box show?"), 1},
                        {CULLSCOPE_TR("no: hidden, leave all its objects out"), 1},
                        {CULLSCOPE_TR("yes: visit(parts), nearest first"), 1},
                        {CULLSCOPE_TR("no parts: draw its objects"), 1}});
}

}  // namespace

RegisteredStrategy octreeQuery() {
    StrategyInfo info{
        "octree-query",
        CULLSCOPE_TR("Octree with occlusion queries"),
        CULLSCOPE_TR("Draws an octree's objects from near to far, and first asks OpenGL of each group whether its box shows."),
        "lecture, Octree Method",
        {facingParameter(),
         wholeParameter(
             kLatency, 0, 0, 2,
             CULLSCOPE_TR("How many frames later an answer is used; 0: each batch is waited for, and nothing is lost.")),
         wholeParameter(
             kBatch, 16, 1, 4096,
             CULLSCOPE_TR("How many boxes are asked about at once, at most: more need fewer waits, and hide less from each "
                          "other. The lecture asks one by one.")),
         choiceParameter(kAsk, kNodes, CULLSCOPE_TR("Which groups OpenGL is asked about."),
                         {{kNodes, CULLSCOPE_TR("every group before its parts")},
                          {kLeaves, CULLSCOPE_TR("only groups without parts, as in the lecture")}}),
         leafParameter()},
        GlRequirement::Context};
    info.remembers = true;
    info.sweeps = {{kLatency, {"0", "1", "2"}}, {kBatch, {"1", "4", "16", "64", "256"}}};
    info.shows = {treeShow(), queryListing(), queryBarsShow()};
    return {std::move(info), std::make_shared<OctreeQuery>()};
}

}  // namespace cullscope::occlusion
