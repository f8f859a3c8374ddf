#include "core/visibility/occlusion/pvs_build.h"

#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <functional>

#include "core/base/message.h"
#include "core/spatial/hiding_sheets.h"
#include "core/spatial/instance_octree.h"
#include "core/spatial/part_boxes.h"
#include "core/visibility/occlusion/guided_rays.h"

namespace cullscope::occlusion {
namespace {

constexpr size_t kCellsAtOnce = 64;  // between reports of progress
constexpr int kGroupHalvings = 0, kPartHalvings = 3;

/// Calls `work` for every cell, several at a time.
void forEachCell(size_t count, const Progress& progress, const char* stage, const std::function<void(uint32_t cell)>& work) {
    for (size_t begin = 0; begin < count; begin += kCellsAtOnce) {
        progress.tell(double(begin) / double(count), stage);
        tbb::parallel_for(begin, std::min(count, begin + kCellsAtOnce), [&](size_t cell) {
            progress.check();
            work(uint32_t(cell));
        });
    }
}

using Seen = std::vector<std::vector<uint8_t>>;  // by cell, a byte for each object

uint64_t seedOf(const PvsOptions& options, uint32_t cell) {
    return Random(options.seed * 0x9E3779B97F4A7C15ull + uint64_t(cell)).bits();
}

/// Rays from every cell; returns how many.
uint64_t sampleCells(const Scene& scene, const ViewCells& cells, const SceneRays& rays, const PvsOptions& options, Seen& seen,
                     const Progress& progress) {
    const GuidedRays guided(scene, rays);
    std::vector<uint64_t> shot(cells.boxes.size(), 0);
    tbb::enumerable_thread_specific<GuidedRays::Work> works;
    forEachCell(cells.boxes.size(), progress, CULLSCOPE_TR("Rays from view cells"), [&](uint32_t cell) {
        seen[cell].assign(scene.instances().size(), 0);
        for (const uint32_t instance : cells.crossing[cell]) seen[cell][instance] = 1;
        shot[cell] = guided.sample(cells.boxes[cell], {options.rays, seedOf(options, cell)}, works.local(), seen[cell], progress);
    });
    uint64_t sum = 0;
    for (const uint64_t count : shot) sum += count;
    return sum;
}

/// Adds to each cell's set what the cells beside it see.
void addNeighbours(const ViewCells& cells, Seen& seen) {
    const std::vector<std::vector<uint32_t>> beside = neighbours(cells);
    const Seen own = seen;
    tbb::parallel_for(size_t{0}, seen.size(), [&](size_t cell) {
        for (const uint32_t other : beside[cell])
            for (size_t i = 0; i < seen[cell].size(); ++i) seen[cell][i] |= own[other][i];
    });
}

/// Adds to a cell's set what was not seen from it and is not proven to be hidden from it.
class ProofOfCell {
public:
    ProofOfCell(const Scene& scene, const InstanceOctree& octree, const PartBoxes& parts, const HidingSheets& sheets,
                const Box3& cell, HidingSheets::Work& work, std::vector<uint8_t>& seen, const Progress& progress)
        : m_scene(scene),
          m_octree(octree),
          m_parts(parts),
          m_sheets(sheets),
          m_cell(cell),
          m_work(work),
          m_seen(seen),
          m_progress(progress) {}

    void visit(uint32_t number) {
        m_progress.check();
        const InstanceOctree::Node& node = m_octree.nodes()[number];
        const std::span<const uint32_t> objects = std::span(m_octree.order()).subspan(node.first, node.count);
        const auto seen = size_t(std::ranges::count_if(objects, [&](uint32_t object) { return m_seen[object] != 0; }));
        if (seen == objects.size()) return;
        if (seen == 0 && objects.size() > 1 && m_sheets.hides(m_cell, node.box, kGroupHalvings, m_work)) {
            proven += objects.size();
            return;
        }
        if (!node.leaf()) {
            for (uint32_t i = 0; i < node.childCount; ++i) visit(node.firstChild + i);
            return;
        }
        for (const uint32_t object : objects)
            if (m_seen[object] == 0) ask(object);
    }

    uint64_t proven = 0, unproven = 0;

private:
    void ask(uint32_t object) {
        m_progress.check();
        const std::span<const Box3> parts = m_parts.of(object);
        const auto hidden = [&](const Box3& box) { return m_sheets.hides(m_cell, box, kPartHalvings, m_work); };
        if (parts.empty() ? hidden(m_scene.instanceBox(object)) : std::ranges::all_of(parts, hidden)) {
            ++proven;
            return;
        }
        ++unproven;
        m_seen[object] = 1;
    }

    const Scene& m_scene;
    const InstanceOctree& m_octree;
    const PartBoxes& m_parts;
    const HidingSheets& m_sheets;
    const Box3& m_cell;
    HidingSheets::Work& m_work;
    std::vector<uint8_t>& m_seen;
    const Progress& m_progress;
};

void proveCells(const Scene& scene, const SceneRays& rays, BuiltSets& built, Seen& seen, const Progress& progress) {
    const WeldedTriangles triangles(scene, progress);
    const HidingSheets sheets(scene, triangles, rays);
    const InstanceOctree octree(scene, InstanceOctree::kLeafInstances, progress);
    const PartBoxes parts(scene, progress);
    if (octree.nodes().empty()) return;
    std::vector<std::array<uint64_t, 2>> counts(built.cells.boxes.size());
    tbb::enumerable_thread_specific<HidingSheets::Work> works;
    forEachCell(built.cells.boxes.size(), progress, CULLSCOPE_TR("Proofs of what is hidden"), [&](uint32_t cell) {
        ProofOfCell proof(scene, octree, parts, sheets, built.cells.boxes[cell], works.local(), seen[cell], progress);
        proof.visit(0);
        counts[cell] = {proof.proven, proof.unproven};
    });
    for (const auto& [proven, unproven] : counts) {
        built.proven += proven;
        built.unproven += unproven;
    }
}

}  // namespace

std::optional<BuiltSets> buildSets(const Scene& scene, const PvsOptions& options, const Progress& progress) {
    if (scene.triangleCount() > kOptionalAnalysisLimit) return std::nullopt;
    std::optional<ViewCells> cells = viewCells(scene, options.cells, progress);
    if (!cells) return std::nullopt;
    BuiltSets built;
    built.cells = std::move(*cells);
    const SceneRays rays(
        scene, scene.bounds().centre(), [&](uint32_t instance) { return scene.frontFacesSuffice(instance); }, progress);
    Seen seen(built.cells.boxes.size());
    built.rays = sampleCells(scene, built.cells, rays, options, seen, progress.part(0.0, options.proven ? 0.4 : 1.0));
    for (const std::vector<uint8_t>& one : seen) built.seen += uint64_t(std::ranges::count(one, uint8_t(1)));
    if (options.neighbours) addNeighbours(built.cells, seen);
    if (options.proven) proveCells(scene, rays, built, seen, progress.part(0.4, 1.0));
    built.sets = RegionSets(built.cells.nodes, built.cells.boxes.size(), scene.instances().size(), built.cells.within);
    for (uint32_t cell = 0; cell < seen.size(); ++cell) built.sets.setOf(cell, seen[cell]);
    return built;
}

}  // namespace cullscope::occlusion
