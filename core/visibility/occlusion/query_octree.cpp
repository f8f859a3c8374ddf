#include "core/visibility/occlusion/query_octree.h"

#include <algorithm>

#include "core/base/message.h"
#include "core/visibility/object_nodes.h"

namespace cullscope::occlusion {

ParameterDeclaration wholeParameter(const char* key, int64_t value, double least, double most, const char* description) {
    return {key, ParameterType::Integer, value, least, most, "", description, {}};
}

ParameterDeclaration leafParameter() {
    return readWhenBuilding(
        wholeParameter(kLeaf, 1, 1, 1e6, CULLSCOPE_TR("How many objects a group may have that is not divided into parts.")));
}

void fillQueryOctree(QueryOctree& structure, const ParameterSet& parameters, const Progress& progress) {
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

Bars queryBars(const FrameLog& log, const QueryBarLines& lines) {
    const auto count = [&](uint8_t line) { return uint64_t(std::ranges::count(log.decisions, line, &Decision::line)); };
    return {{},
            {{CULLSCOPE_TR("groups outside the frustum"), count(lines.outside), TriangleState::OutsideFrustum},
             {CULLSCOPE_TR("groups visible without asking"), count(lines.unasked)},
             {CULLSCOPE_TR("groups asked about"), count(lines.asked)},
             {CULLSCOPE_TR("groups hidden"), count(lines.hidden), TriangleState::Hidden},
             {CULLSCOPE_TR("objects drawn"), count(lines.drawn), TriangleState::Visible}}};
}

Show queryBarsShow() { return barsShow("asked-groups", CULLSCOPE_TR("Groups by what was asked")); }

StructureSnapshot queryTree(const QueryOctree& structure, const FrameLog& log) {
    StructureSnapshot tree = objectNodes(log, structure.scene());
    tree.objectSentence = CULLSCOPE_TR("The object \"%1\" lies in a box of the octree; it has %2 triangles.");
    tree.groupSentence = CULLSCOPE_TR("It lies in a group of %1 objects, of which all are drawn where their box is visible.");
    addGroups(tree, structure.octree, structure.scene(), log);
    return tree;
}

}  // namespace cullscope::occlusion
