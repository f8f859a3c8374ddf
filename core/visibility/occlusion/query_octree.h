#pragma once

#include <memory>

#include "core/frame/named_parts.h"
#include "core/spatial/instance_octree.h"
#include "core/visibility/octree_walk.h"
#include "core/visibility/registry.h"

namespace cullscope::occlusion {

/// Parameters that the strategies over this octree share.
inline constexpr const char* kBatch = "batch";
inline constexpr const char* kLatency = "latency";
inline constexpr const char* kLeaf = "leaf";

/// A whole number as a parameter.
[[nodiscard]] ParameterDeclaration wholeParameter(const char* key, int64_t value, double least, double most,
                                                  const char* description);
/// `leaf`, read when building: how many objects a leaf of the octree may have.
[[nodiscard]] ParameterDeclaration leafParameter();

/// The octree over a scene's objects about whose groups OpenGL is asked.
struct QueryOctree : Structure {
    using Structure::Structure;
    InstanceOctree octree;
};

/// Builds the octree, and counts its nodes. Throws Error(Interrupted) on a stop request.
void fillQueryOctree(QueryOctree& structure, const ParameterSet& parameters, const Progress& progress);

/// The lines of a strategy's listing at which bars count.
struct QueryBarLines {
    uint8_t outside = 0, unasked = 0, asked = 0, hidden = 0, drawn = 0;
};
/// Counts of nodes, and of the objects that are drawn, for queryBarsShow.
[[nodiscard]] Bars queryBars(const FrameLog& log, const QueryBarLines& lines);
[[nodiscard]] Show queryBarsShow();

/// The octree's groups and the objects in them, with what a recorded frame decided.
[[nodiscard]] StructureSnapshot queryTree(const QueryOctree& structure, const FrameLog& log);

/// What strategies have in common that walk this octree with a view's memory: all but the walk. Conservative at latency 0, where
/// the answers are those of the same frame, else approximate.
template <typename Memory>
class QueryStrategy : public StrategyWith<QueryOctree, Memory> {
public:
    [[nodiscard]] ViewStatePointer begin(const Structure& /*structure*/) const override { return std::make_unique<Memory>(); }
    [[nodiscard]] Bars bars(std::string_view /*id*/, const Structure& /*structure*/, const FrameLog& log) const override {
        return queryBars(log, m_lines);
    }
    [[nodiscard]] NamedParts partsByLeaf(const Structure& structure, const FrameLog& /*log*/) const override {
        return objectsByLeaf(this->own(structure).octree, structure.scene());
    }

protected:
    explicit QueryStrategy(const QueryBarLines& lines) : m_lines(lines) {}

    void fill(QueryOctree& structure, const ParameterSet& parameters, const Progress& progress) const override {
        fillQueryOctree(structure, parameters, progress);
    }
    [[nodiscard]] Promise promiseOf(const QueryOctree& /*structure*/, const ParameterSet& parameters,
                                    Facing /*facing*/) const override {
        return parameters.integer(kLatency) == 0 ? Promise::Conservative : Promise::Approximate;
    }
    [[nodiscard]] StructureSnapshot snapshotOf(const QueryOctree& structure, const FrameLog& log) const override {
        return queryTree(structure, log);
    }

private:
    QueryBarLines m_lines;
};

}  // namespace cullscope::occlusion
