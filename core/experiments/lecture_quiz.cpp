#include "core/experiments/lecture_quiz.h"

#include <algorithm>
#include <map>

#include "core/base/error.h"
#include "core/experiments/result_file.h"
#include "core/experiments/run_rows.h"
#include "core/frame/part_names.h"
#include "core/spatial/bsp_cells.h"

namespace cullscope {
namespace {

using Origin = ResultColumn::Origin;

constexpr const char* kOrder = "order";
constexpr const char* kLectureNotes = "Lecture notes \"Visible Surface Determination\"";

/// The names of parts: by the leaf or the plane in which they lie, and their object.
class PartsOfCells {
public:
    PartsOfCells(const Scene& scene, const BspTree& tree) : m_scene(scene), m_cells(cellsOf(tree, scene.planes().size())) {
        std::map<size_t, std::map<uint32_t, uint32_t>> places;  // by object: its cells, by their rank
        for (uint32_t node = 0; node < tree.nodes().size(); ++node)
            for (const BspTree::Part& part : tree.partsOf(tree.nodes()[node])) {
                const uint32_t cell = m_cells.cellOf(node);
                places[scene.instanceOf(part.triangle)].emplace(m_cells.rank[cell], cell);
            }
        const PartNames partNames(scene);
        for (const auto& [object, cells] : places) {
            size_t number = 0;
            for (const auto& [rank, cell] : cells)
                m_names[{cell, object}] = cells.size() > 1 ? partNames.of(object, ++number) : scene.instances()[object].name;
        }
    }

    [[nodiscard]] const BspCells& cells() const { return m_cells; }
    /// What lies in a node's plane, or in the cell of a leaf of the given planes.
    [[nodiscard]] std::vector<std::string> at(uint32_t node) const {
        std::vector<std::string> names;
        for (auto entry = m_names.lower_bound({node, 0}); entry != m_names.end() && entry->first.first == node; ++entry)
            names.push_back(entry->second);
        return names;
    }
    [[nodiscard]] const std::string& name(uint32_t node, uint32_t triangle) const {
        return m_names.at({m_cells.cellOf(node), m_scene.instanceOf(triangle)});
    }

private:
    const Scene& m_scene;
    BspCells m_cells;
    std::map<std::pair<uint32_t, size_t>, std::string> m_names;  ///< by cell and object
};

std::string joined(const std::vector<std::string>& names, const char* between) {
    std::string text;
    for (const std::string& name : names) text += (text.empty() ? "" : between) + name;
    return text;
}

/// The rows of a scene of the user's: what the tree says.
Rows computedRows(const LectureCells& cells) {
    Rows rows;
    for (size_t i = 0; i < cells.leaves.size(); ++i)
        rows.push_back({{"what", BspCells::leafName(i)}, {"computed", cells.leaves[i]}});
    for (const auto& [plane, parts] : cells.inPlanes) rows.push_back({{"what", "in " + plane}, {"computed", parts}});
    rows.push_back({{"what", kOrder}, {"computed", joined(cells.order, ", ")}});
    return rows;
}

/// The rows of a question: what the key says beside what the tree says.
Rows questionRows(const LectureCells& cells, const std::vector<std::string>& leafKey, const std::string& orderKey) {
    Rows rows;
    const auto add = [&](const std::string& what, const std::string& key, const std::string& computed) {
        rows.push_back({{"what", what}, {"key", key}, {"computed", computed}, {"differs", key == computed ? 0.0 : 1.0}});
    };
    for (size_t i = 0; i < leafKey.size(); ++i)
        add(BspCells::leafName(i), leafKey[i], i < cells.leaves.size() ? cells.leaves[i] : "");
    add(kOrder, orderKey, joined(cells.order, ", "));
    return rows;
}

LectureCells cellsSeenFromCamera(const Scene& scene, const Progress& progress) {
    // Without planes there is no tree, and the sentence about that is thrown below.
    if (!scene.planes().empty() && !scene.remarks().camera)
        throwUsage(CULLSCOPE_TR("\"%1\" names no camera, from which the order is seen. Write a line eye x y z into its .polygons "
                                "file."),
                   {scene.name()});
    return lectureCells(scene, scene.remarks().camera.value_or(Camera{}).eye, progress);
}

/// The question about a scene of the user's, which has no key.
Experiment ownQuestion(Experiment experiment, const std::string& scene) {
    experiment.title = CULLSCOPE_TR("Leaves of a BSP tree and the order of drawing");
    experiment.source.clear();
    std::erase_if(experiment.columns, [](const ResultColumn& column) { return column.key == "key" || column.key == "differs"; });
    experiment.notes = {
        note(CULLSCOPE_TR("Computed from the scene's own planes, which divide it level by level; its objects hang at the leaves. "
                          "C1 is the leaf behind all planes, the last one before all of them.")),
        note(CULLSCOPE_TR("What lies in a plane hangs at the plane's node, in a row \"in\" with the plane's name.")),
        note(CULLSCOPE_TR("The order is that of drawing, back to front, as seen from the scene's camera V."))};
    experiment.checks.clear();
    experiment.axes.front().values.clear();  // as many leaves as the scene has
    experiment.settings.front().scene = scene;
    experiment.measured = [](const Setting& /*setting*/, const ScenePointer& opened, const Progress& progress) {
        return computedRows(cellsSeenFromCamera(*opened, progress));
    };
    experiment.ofScene = {};
    return experiment;
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
    Axis asked{"what", CULLSCOPE_TR("asked"), Axis::Kind::InTurns, {}};
    for (size_t i = 0; i < leafKey.size(); ++i) asked.values.emplace_back(BspCells::leafName(i));
    asked.values.emplace_back(std::string(kOrder));
    experiment.axes = {asked};
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
    experiment.ofScene = [experiment](const std::string& scene) { return ownQuestion(experiment, scene); };
    return experiment;
}

}  // namespace

LectureCells lectureCells(const Scene& scene, const Vec3& eye, const Progress& progress) {
    BspOptions options;
    options.plane = BspPlane::Given;
    const BspTree tree(scene, options, progress);
    const PartsOfCells names(scene, tree);
    LectureCells cells;
    for (const uint32_t leaf : names.cells().leaves) {
        const std::vector<std::string> parts = names.at(leaf);
        cells.leaves.push_back(parts.empty() ? "NULL" : joined(parts, "+"));
    }
    std::vector<std::vector<std::string>> inPlanes(scene.planes().size());
    for (uint32_t node = 0; node < tree.nodes().size(); ++node)
        if (!names.cells().leafOf[node])
            for (const std::string& part : names.at(node)) inPlanes[tree.nodes()[node].depth].push_back(part);
    for (size_t plane = 0; plane < inPlanes.size(); ++plane)
        if (!inPlanes[plane].empty()) cells.inPlanes.emplace_back(scene.planes()[plane].name, joined(inPlanes[plane], "+"));
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
