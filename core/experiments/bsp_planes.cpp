#include "core/experiments/bsp_planes.h"

#include <array>
#include <chrono>

#include "core/base/error.h"
#include "core/experiments/run_rows.h"
#include "core/geometry/random.h"
#include "core/spatial/bsp_tree.h"

namespace cullscope {
namespace {

using Origin = ResultColumn::Origin;

constexpr size_t kRandomTriangles = 10'000;
constexpr const char *kSmallTriangles = "random, small", *kLargeTriangles = "random, large", *kBunnyScene = "bunny";
constexpr uint64_t kMostPolygons = 2'000'000;
constexpr std::array kChoices{std::pair("first", BspPlane::First), std::pair("fewest", BspPlane::Fewest),
                              std::pair("balance", BspPlane::Balance)};

/// Random triangles in the cube [−1, 1]³ with edges of at most `edge`.
ScenePointer scatteredTriangles(double edge) {
    Random random(1);
    TriangleMesh::Data data;
    data.name = "random triangles";
    for (uint32_t i = 0; i < kRandomTriangles; ++i) {
        const Vec3 middle(random.between(-1.0, 1.0), random.between(-1.0, 1.0), random.between(-1.0, 1.0));
        for (uint32_t corner = 0; corner < 3; ++corner) {
            data.positions.push_back(Vec3f(middle + 0.5 * edge * random.direction()));
            data.indices.push_back(3 * i + corner);
        }
    }
    return std::make_shared<const Scene>("random triangles",
                                         std::vector<MeshPointer>{std::make_shared<TriangleMesh>(std::move(data))},
                                         std::vector<Instance>{{0, Mat4(1.0), "triangles"}});
}

Rows treeRow(const Setting& setting, const ScenePointer& opened, const Progress& progress) {
    using Clock = std::chrono::steady_clock;
    const ScenePointer scene = opened ? opened : scatteredTriangles(setting.words("scene") == kSmallTriangles ? 0.2 : 2.0);
    BspOptions options;
    for (const auto& [id, plane] : kChoices)
        if (setting.words("plane") == id) options.plane = plane;
    options.limit = kMostPolygons;
    const Clock::time_point start = Clock::now();
    Row row{{"triangles", double(scene->triangleCount())}};
    try {
        const BspTree tree(*scene, options, progress);
        row["nodes"] = double(tree.nodes().size());
        row["depth"] = double(tree.depth());
        row["fragments"] = double(tree.parts().size());
        row["ended"] = std::string("complete");
    } catch (const Error& error) {
        if (error.kind() != ErrorKind::Usage) throw;
        row["ended"] = std::string(CULLSCOPE_TR("stopped at the limit"));
    }
    row["build_ms"] = std::chrono::duration<double, std::milli>(Clock::now() - start).count();
    return {row};
}

}  // namespace

Experiment bspPlanes() {
    Experiment experiment;
    experiment.id = "bsp-planes";
    experiment.title = CULLSCOPE_TR("BSP trees by the choice of the dividing plane");
    experiment.notes = {
        note(CULLSCOPE_TR(
            "\"random, small\": 10,000 random triangles in a cube, with edges of at most a tenth of its side. \"random, "
            "large\": with edges of up to its side, which fill it.")),
        note(CULLSCOPE_TR("A tree that needs more than 2,000,000 polygons is given up."))};
    Axis planes{"plane", CULLSCOPE_TR("plane"), Axis::Kind::Label, {}};
    for (const auto& [id, plane] : kChoices) planes.values.emplace_back(std::string(id));
    experiment.axes = {{"scene",
                        CULLSCOPE_TR("scene"),
                        Axis::Kind::Label,
                        {std::string(kSmallTriangles), std::string(kLargeTriangles), std::string(kBunnyScene)}},
                       planes};
    experiment.settings = settingsOf(experiment.axes);
    for (Setting& setting : experiment.settings)
        if (setting.words("scene") == kBunnyScene) setting.scene = kBunnyScene;
    experiment.columns = {{"scene", CULLSCOPE_TR("scene"), Origin::Axis},
                          {"plane", CULLSCOPE_TR("plane"), Origin::Axis},
                          {"triangles", CULLSCOPE_TR("triangles"), Origin::Measured},
                          {"fragments", CULLSCOPE_TR("polygons"), Origin::Measured},
                          {"nodes", CULLSCOPE_TR("nodes"), Origin::Measured},
                          {"depth", CULLSCOPE_TR("depth"), Origin::Measured},
                          {"build_ms", CULLSCOPE_TR("build, ms"), Origin::Measured},
                          {"ended", CULLSCOPE_TR("tree"), Origin::Measured}};
    experiment.measured = treeRow;
    return experiment;
}

}  // namespace cullscope
