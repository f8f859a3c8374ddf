#include "core/visibility/occlusion/octree_query.h"

#include <algorithm>

#include "core/base/message.h"
#include "core/frame/named_parts.h"
#include "core/visibility/facing.h"
#include "core/visibility/object_nodes.h"
#include "core/visibility/occlusion/query_walk.h"
#include "core/visibility/octree_walk.h"

namespace cullscope::occlusion {
namespace {

constexpr const char* kAsk = "ask";
constexpr const char* kBatch = "batch";
constexpr const char* kLatency = "latency";
constexpr const char* kLeaf = "leaf";
constexpr const char* kNodes = "nodes";
constexpr const char* kLeaves = "leaves";

struct QueryOctree : Structure {
    using Structure::Structure;
    InstanceOctree octree;
};

/// The questions of a view whose answers are still due.
struct QueryMemory : ViewState {
    std::deque<AskedFrame> past;  ///< oldest first

    [[nodiscard]] ViewStatePointer clone() const override { return std::make_unique<QueryMemory>(*this); }
};

class OctreeQuery final : public StrategyWith<QueryOctree, QueryMemory> {
public:
    [[nodiscard]] ViewStatePointer begin(const Structure& /*structure*/) const override {
        return std::make_unique<QueryMemory>();
    }

    /// Counts of nodes, and of the objects that are drawn.
    [[nodiscard]] Bars bars(std::string_view /*id*/, const Structure& /*structure*/, const FrameLog& log) const override {
        const auto count = [&](QueryLine line) {
            return uint64_t(
                std::ranges::count_if(log.decisions, [&](const Decision& decision) { return decision.line == uint8_t(line); }));
        };
        return {{},
                {{CULLSCOPE_TR("groups outside the frustum"), count(QueryLine::Outside), TriangleState::OutsideFrustum},
                 {CULLSCOPE_TR("groups visible without asking"), count(QueryLine::Unasked)},
                 {CULLSCOPE_TR("groups asked about"), count(QueryLine::Ask)},
                 {CULLSCOPE_TR("groups hidden"), count(QueryLine::Hidden), TriangleState::Hidden},
                 {CULLSCOPE_TR("objects drawn"), count(QueryLine::Draw), TriangleState::Visible}}};
    }

    [[nodiscard]] NamedParts partsByLeaf(const Structure& structure, const FrameLog& /*log*/) const override {
        return objectsByLeaf(own(structure).octree, structure.scene());
    }

protected:
    void fill(QueryOctree& structure, const ParameterSet& parameters, const Progress& progress) const override {
        structure.octree = InstanceOctree(structure.scene(), uint32_t(parameters.integer(kLeaf)), progress);
        structure.report.bytes = structure.octree.bytes();
        uint8_t depth = 0;
        size_t leaves = 0;
        for (const InstanceOctree::Node& node : structure.octree.nodes()) {
            depth = std::max(depth, node.depth);
            leaves += node.leaf() ? 1 : 0;
        }
        structure.report.figures = {{"objects", double(structure.scene().instances().size())},
                                    {"nodes", double(structure.octree.nodes().size())},
                                    {"leaves", double(leaves)},
                                    {"depth", double(depth)}};
    }

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

    [[nodiscard]] Promise promiseOf(const QueryOctree& /*structure*/, const ParameterSet& parameters,
                                    Facing /*facing*/) const override {
        return parameters.integer(kLatency) == 0 ? Promise::Conservative : Promise::Approximate;
    }
    [[nodiscard]] StructureSnapshot snapshotOf(const QueryOctree& structure, const FrameLog& log) const override {
        StructureSnapshot tree = objectNodes(log, structure.scene());
        tree.objectSentence = CULLSCOPE_TR("The object \"%1\" lies in a box of the octree; it has %2 triangles.");
        tree.groupSentence = CULLSCOPE_TR("It lies in a group of %1 objects, of which all are drawn where their box is visible.");
        addGroups(tree, structure.octree, structure.scene(), log);
        return tree;
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

ParameterDeclaration whole(const char* key, int64_t value, double least, double most, const char* description) {
    return {key, ParameterType::Integer, value, least, most, "", description, {}};
}

}  // namespace

RegisteredStrategy octreeQuery() {
    StrategyInfo info{
        "octree-query",
        CULLSCOPE_TR("Octree with occlusion queries"),
        CULLSCOPE_TR("Draws an octree's objects from near to far, and first asks OpenGL of each group whether its box shows."),
        "lecture, Octree Method",
        {facingParameter(),
         whole(kLatency, 0, 0, 2,
               CULLSCOPE_TR("How many frames later an answer is used; 0: each batch is waited for, and nothing is lost.")),
         whole(kBatch, 16, 1, 4096,
               CULLSCOPE_TR("How many boxes are asked about at once, at most: more need fewer waits, and hide less from each "
                            "other. The lecture asks one by one.")),
         choiceParameter(kAsk, kNodes, CULLSCOPE_TR("Which groups OpenGL is asked about."),
                         {{kNodes, CULLSCOPE_TR("every group before its parts")},
                          {kLeaves, CULLSCOPE_TR("only groups without parts, as in the lecture")}}),
         readWhenBuilding(
             whole(kLeaf, 1, 1, 1e6, CULLSCOPE_TR("How many objects a group may have that is not divided into parts.")))},
        GlRequirement::Context};
    info.remembers = true;
    info.sweeps = {{kLatency, {"0", "1", "2"}}, {kBatch, {"1", "4", "16", "64", "256"}}};
    info.shows = {treeShow(), queryListing(), barsShow("asked-groups", CULLSCOPE_TR("Groups by what was asked"))};
    return {std::move(info), std::make_shared<OctreeQuery>()};
}

}  // namespace cullscope::occlusion
