#include "core/experiments/han_hong_layouts.h"

#include <cmath>

#include "core/base/message.h"
#include "core/experiments/han_hong_rows.h"
#include "core/spatial/spherical_maps.h"

namespace cullscope::han_hong {
namespace {

using Origin = ResultColumn::Origin;

constexpr double kMegabyte = 1e6, kMebibyte = 1024.0 * 1024.0;

/// What layouts are counted in, of one mesh.
struct Counts {
    double vertices = 0.0, faces = 0.0, cells = 0.0, entries = 0.0;  ///< entries: of the triangle index map
};

/// A structure of the paper as it may have been laid out.
struct Layout {
    const char* structure;
    const char* words;
    double stated;                          ///< the paper's number; 0: it states none for this layout
    double aVertex, aFace, aCell, anEntry;  ///< bytes

    [[nodiscard]] double bytes(const Counts& counts) const {
        return aVertex * counts.vertices + aFace * counts.faces + aCell * counts.cells + anEntry * counts.entries;
    }
};

constexpr const char *kModelName = CULLSCOPE_TR("model"), *kCentroidMap = CULLSCOPE_TR("centroid map"),
                     *kIndexMap = CULLSCOPE_TR("triangle index map"), *kAccessMap = CULLSCOPE_TR("memory access map");

const std::array<Layout, 13>& layouts() {
    static const std::array<Layout, 13> kLayouts{{
        {kModelName, CULLSCOPE_TR("a vertex: position, normal; a face: 3 indices"), 3.46, 24, 12, 0, 0},
        {kModelName, CULLSCOPE_TR("a face: 3 corners with position and normal"), 10.0, 0, 72, 0, 0},
        {kModelName, CULLSCOPE_TR("a face: 3 corners with position, 1 normal, 3 indices"), 10.0, 0, 60, 0, 0},
        {kCentroidMap, CULLSCOPE_TR("the paper's formula: 4 floats a face"), 4.3, 0, 16, 0, 0},
        {kCentroidMap, CULLSCOPE_TR("R, θ, φ in floats a face; 4 numbers a cell"), 4.3, 0, 12, 16, 0},
        {kCentroidMap, CULLSCOPE_TR("R, θ, φ and index a face; 4 numbers a cell"), 4.3, 0, 16, 16, 0},
        {kCentroidMap, CULLSCOPE_TR("R, θ, φ in doubles a face; 4 numbers a cell"), 4.3, 0, 24, 16, 0},
        {kIndexMap, CULLSCOPE_TR("index and R an entry"), 6.7, 0, 0, 0, 8},
        {kIndexMap, CULLSCOPE_TR("index and R an entry; start and count a cell"), 6.7, 0, 0, 8, 8},
        {kIndexMap, CULLSCOPE_TR("index, R and a link to the next an entry"), 6.7, 0, 0, 0, 12},
        {kIndexMap, CULLSCOPE_TR("index an entry; start, nearest and farthest R a cell, as here"), 6.7, 0, 0, 12, 4},
        {kAccessMap, CULLSCOPE_TR("the paper's formula: 4 integers a cell"), 0.51, 0, 0, 16, 0},
        {kAccessMap, CULLSCOPE_TR("start and count a cell"), 0.51, 0, 0, 8, 0},
    }};
    return kLayouts;
}

Rows layoutRows(const Setting& /*setting*/, const ScenePointer& scene, const Progress& progress) {
    const MeshPointer& mesh = scene->meshes().front();
    const SphericalMaps maps(mesh, SphericalGrid(), progress);
    const Counts counts{double(mesh->vertexCount()), double(mesh->triangleCount()), double(maps.grid().cellCount()),
                        double(maps.indexEntries())};
    Rows rows;
    for (const Layout& layout : layouts()) {
        const double bytes = layout.bytes(counts);
        rows.push_back({{"structure", std::string(layout.structure)},
                        {"layout", std::string(layout.words)},
                        {"bytes", bytes},
                        {"megabytes", bytes / kMegabyte},
                        {"mebibytes", bytes / kMebibyte},
                        {"bytes_a_face", bytes / counts.faces},
                        {"paper_megabytes", layout.stated},
                        {"off_mb", bytes / kMegabyte / layout.stated - 1.0},
                        {"off_mib", bytes / kMebibyte / layout.stated - 1.0}});
    }
    return rows;
}

}  // namespace

Experiment tableLayouts() {
    Experiment experiment;
    experiment.id = "table-1-layouts";
    experiment.title = CULLSCOPE_TR("What the sizes in Table 1 can be made of");
    experiment.source = std::string(kSource) + ", Table 1";
    experiment.notes = {
        note(CULLSCOPE_TR("The paper gives about 10, 4.3, 6.7 and 0.51 MB, and formulas that give other sizes; 3.46 MB stands "
                          "in its table without a word. Each row is a layout that fits its text, with its size here.")),
        note(CULLSCOPE_TR("The index map has as many entries as triangles touch cells at 360 × 180. The paper stores R with "
                          "each entry; here R is kept by cell, as its nearest and its farthest value, unless storage=entries of "
                          "spherical is chosen, which table-1 builds and spherical-readings times."))};
    Axis axis{"layout", CULLSCOPE_TR("layout"), Axis::Kind::InTurns, {}};
    for (const Layout& layout : layouts()) axis.values.emplace_back(std::string(layout.words));
    experiment.axes = {axis};
    experiment.columns = {{"structure", CULLSCOPE_TR("structure"), Origin::Axis},
                          {"layout", CULLSCOPE_TR("layout"), Origin::Axis},
                          {"paper_megabytes", CULLSCOPE_TR("paper: MB"), Origin::Stated, 2},
                          {"megabytes", CULLSCOPE_TR("here: MB"), Origin::Measured, 2},
                          {"mebibytes", CULLSCOPE_TR("here: MiB"), Origin::Measured, 2},
                          {"off_mb", CULLSCOPE_TR("off in MB, %"), Origin::Measured, 1, 100.0},
                          {"off_mib", CULLSCOPE_TR("off in MiB, %"), Origin::Measured, 1, 100.0},
                          {"bytes_a_face", CULLSCOPE_TR("bytes a face"), Origin::Measured, 1},
                          {"bytes", CULLSCOPE_TR("bytes"), Origin::Measured}};
    Setting setting;
    setting.scene = kBunny;
    experiment.settings = {setting};
    experiment.measured = layoutRows;
    return withOtherScenes(std::move(experiment));
}

}  // namespace cullscope::han_hong
