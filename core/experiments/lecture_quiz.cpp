#include "core/experiments/lecture_quiz.h"

#include <algorithm>
#include <map>

#include "core/experiments/result_file.h"
#include "core/experiments/run_rows.h"
#include "core/spatial/bsp_tree.h"

namespace cullscope {
namespace {

using Origin = ResultColumn::Origin;

constexpr const char* kLectureNotes = "Lecture notes \"Visible Surface Determination\"";

/// The leaves below the given planes, those behind a plane before those in front of it.
std::vector<uint32_t> leavesOf(const BspTree& tree, size_t planes) {
    std::vector<uint32_t> leaves;
    std::vector<int32_t> open{tree.nodes().empty() ? BspTree::kNone : 0};
    while (!open.empty()) {
        const int32_t number = open.back();
        open.pop_back();
        if (number == BspTree::kNone) continue;
        const BspTree::Node& node = tree.nodes()[size_t(number)];
        if (node.depth == planes) {
            leaves.push_back(uint32_t(number));
            continue;
        }
        open.push_back(node.front);
        open.push_back(node.back);
    }
    return leaves;
}

/// The names of parts: by the leaf or the plane in which they lie, and their object.
class PartNames {
public:
    PartNames(const Scene& scene, const BspTree& tree) : m_scene(scene), m_tree(tree), m_planes(scene.planes().size()) {
        std::map<size_t, std::vector<uint32_t>> places;  // by object
        const std::vector<uint32_t> leaves = leavesOf(tree, m_planes);
        for (auto leaf = leaves.rbegin(); leaf != leaves.rend(); ++leaf)
            for (const size_t object : objectsBelow(*leaf)) places[object].push_back(*leaf);
        for (uint32_t node = 0; node < tree.nodes().size(); ++node)
            if (tree.nodes()[node].depth < m_planes)
                for (const size_t object : objectsOf(node)) places[object].push_back(node);
        for (const auto& [object, at] : places)
            for (size_t i = 0; i < at.size(); ++i)
                m_names[{at[i], object}] = scene.instances()[object].name + (at.size() > 1 ? std::to_string(i + 1) : "");
    }

    /// What lies in a node's plane, or in the cell of a leaf of the given planes.
    [[nodiscard]] std::vector<std::string> at(uint32_t node) const {
        std::vector<std::string> names;
        for (auto entry = m_names.lower_bound({node, 0}); entry != m_names.end() && entry->first.first == node; ++entry)
            names.push_back(entry->second);
        return names;
    }
    /// The leaf of the given planes that a node lies in; the node itself above them.
    [[nodiscard]] uint32_t leafAround(uint32_t node) const {
        while (m_tree.nodes()[node].depth > m_planes) node = uint32_t(m_tree.nodes()[node].parent);
        return node;
    }
    [[nodiscard]] const std::string& name(uint32_t node, uint32_t triangle) const {
        return m_names.at({leafAround(node), m_scene.instanceOf(triangle)});
    }

private:
    [[nodiscard]] std::vector<size_t> objectsOf(uint32_t node) const {
        std::vector<size_t> objects;
        for (const BspTree::Part& part : m_tree.partsOf(m_tree.nodes()[node])) {
            const size_t object = m_scene.instanceOf(part.triangle);
            if (std::ranges::find(objects, object) == objects.end()) objects.push_back(object);
        }
        return objects;
    }
    [[nodiscard]] std::vector<size_t> objectsBelow(uint32_t leaf) const {
        std::vector<size_t> objects;
        for (uint32_t node = leaf; node < m_tree.nodes().size(); ++node) {
            if (m_tree.nodes()[node].depth < m_planes || leafAround(node) != leaf) continue;
            for (const size_t object : objectsOf(node))
                if (std::ranges::find(objects, object) == objects.end()) objects.push_back(object);
        }
        return objects;
    }

    const Scene& m_scene;
    const BspTree& m_tree;
    size_t m_planes;
    std::map<std::pair<uint32_t, size_t>, std::string> m_names;  ///< by node and object
};

std::string joined(const std::vector<std::string>& names, const char* between) {
    std::string text;
    for (const std::string& name : names) text += (text.empty() ? "" : between) + name;
    return text;
}

/// The rows of a question: what the key says beside what the tree says.
Rows questionRows(const LectureCells& cells, const std::vector<std::string>& leafKey, const std::string& orderKey) {
    Rows rows;
    const auto add = [&](const std::string& what, const std::string& key, const std::string& computed) {
        rows.push_back({{"what", what}, {"key", key}, {"computed", computed}, {"differs", key == computed ? 0.0 : 1.0}});
    };
    for (size_t i = 0; i < leafKey.size(); ++i)
        add("C" + std::to_string(i + 1), leafKey[i], i < cells.leaves.size() ? cells.leaves[i] : "");
    add("order", orderKey, joined(cells.order, ", "));
    return rows;
}

Experiment question(std::string id, std::string title, std::vector<std::string> leafKey, std::string orderKey) {
    Experiment experiment;
    experiment.id = id;
    experiment.title = std::move(title);
    experiment.source = kLectureNotes;
    experiment.notes = {
        note(CULLSCOPE_TR("Computed from the scene of the same name: its planes P1, P2, … divide it level by level, and its "
                          "objects hang at the leaves. C1 is the leaf behind all planes, the last one before all of them.")),
        note(CULLSCOPE_TR("The order is that of drawing, back to front, as seen from the scene's camera V."))};
    experiment.columns = {{"what", CULLSCOPE_TR("asked"), Origin::Axis},
                          {"key", CULLSCOPE_TR("answer key"), Origin::Stated},
                          {"computed", CULLSCOPE_TR("computed"), Origin::Measured},
                          {"differs", CULLSCOPE_TR("differs"), Origin::Measured}};
    Setting setting;
    setting.scene = std::move(id);
    experiment.settings = {setting};
    experiment.checks = {everyRowCheck("answers that differ from the key", {}, "differs", {.most = 0.0})};
    experiment.measured = [leafKey = std::move(leafKey), orderKey = std::move(orderKey)](
                              const Setting& /*setting*/, const ScenePointer& scene, const Progress& progress) {
        return questionRows(lectureCells(*scene, scene->remarks().camera.value_or(Camera{}).eye, progress), leafKey, orderKey);
    };
    return experiment;
}

}  // namespace

LectureCells lectureCells(const Scene& scene, const Vec3& eye, const Progress& progress) {
    BspOptions options;
    options.plane = BspPlane::Given;
    const BspTree tree(scene, options, progress);
    const PartNames names(scene, tree);
    LectureCells cells;
    for (const uint32_t leaf : leavesOf(tree, scene.planes().size())) {
        const std::vector<std::string> parts = names.at(leaf);
        cells.leaves.push_back(parts.empty() ? "NULL" : joined(parts, "+"));
    }
    tree.walk(
        eye, false, [](uint32_t /*node*/, int /*side*/) {},
        [&](uint32_t node) {
            for (const BspTree::Part& part : tree.partsOf(tree.nodes()[node])) {
                const std::string& name = names.name(node, part.triangle);
                if (std::ranges::find(cells.order, name) == cells.order.end()) cells.order.push_back(name);
            }
        });
    return cells;
}

std::vector<Experiment> lectureQuestions() {
    return {question("quiz", CULLSCOPE_TR("The lecture's quiz: leaves of a BSP tree and the order of drawing"),
                     {"B", "A2", "NULL", "A1", "NULL", "C2", "NULL", "C1"}, "B, A2, A1, C2, C1"),
            question("example", CULLSCOPE_TR("The lecture's worked example of a BSP tree"), {"B", "D", "A", "C"}, "B, D, A, C")};
}

}  // namespace cullscope
