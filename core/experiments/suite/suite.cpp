#include "core/experiments/suite/suite.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "core/base/atomic_file.h"
#include "core/base/error.h"
#include "core/base/json.h"
#include "core/experiments/stability/battery.h"
#include "core/measure/reference.h"
#include "core/mesh/save.h"
#include "core/scene/drawn_sets.h"

namespace cullscope::suite {
namespace {

/// Cases of sizes that no program's floats hold, and of surfaces that a mesh file's reader leaves out.
constexpr std::array kNotForFiles{"gallery/case-20-tiny", "gallery/case-20-huge", "gallery/case-20-mixed",
                                  "gallery/case-34-nothing"};

void saveScene(const std::filesystem::path& file, const Scene& scene, const Progress& progress) {
    std::vector<PlacedMesh> placed;
    for (size_t i = 0; i < scene.instances().size(); ++i)
        placed.push_back({fmt::format("object-{}", i), &scene.meshOf(i), scene.instances()[i].worldFromMesh});
    saveMeshFile(file, placed, progress);
}

/// What must be drawn of a scene, seen from every pose.
WrittenSets required(const ScenePointer& scene, const std::string& file, const CameraPath& path, const Viewport& size,
                     Renderer& renderer, WrittenScene& written, const Progress& progress) {
    const SceneBuffers buffers(scene, Upload::Vbo);
    WrittenSets sets{file, path, size, "two-sided", {}};
    for (size_t pose = 0; pose < path.poses.size(); ++pose) {
        progress.check();
        const Reference truth = itemBufferReference(renderer, buffers, View(path.camera(pose), size), Facing::TwoSided);
        std::set<uint32_t> objects;
        for (const uint32_t triangle : truth.visibleTriangles) objects.insert(uint32_t(scene->instanceOf(triangle)));
        sets.poses.push_back({path.poses[pose], {objects.begin(), objects.end()}, rangesOf(truth.visibleTriangles)});
        written.visibleTriangles += truth.visibleTriangles.size();
    }
    written.poses += path.poses.size();
    return sets;
}

std::string casesJson() {
    Json cases = Json::array();
    for (const stability::StabilityCase& each : stability::battery())
        cases.push_back({{"number", each.number},
                         {"id", each.id},
                         {"title", each.title},
                         {"right_answer", each.expected},
                         {"scene", each.scene}});
    return Json{{"cases", std::move(cases)}}.dump(2) + "\n";
}

constexpr const char* kReadme = R"(# A suite for programs that leave out what is not seen

`NAME.obj` is a scene: each `o` is an object, in the order of the file, counted from 0; triangles count on through the
objects, in the file's order. `NAME.required.json` (with several sizes, `NAME.WIDTHxHEIGHT.required.json`) has the
cameras and, at each pose, the objects and the triangles of which a pixel is seen. They must be drawn; what else is drawn
is waste.

    {"scene": "NAME.obj", "size": [320, 240], "facing": "two-sided", "fovy_deg": 45, "near": 0.1, "far": 100,
     "poses": [{"eye": [0,0,3], "target": [0,0,0], "up": [0,1,0], "objects": [0, 4], "triangles": [3, "7-12"]}, ...]}

`fovy_deg` is the full vertical angle. A pixel shows the nearest triangle at its centre, both sides drawn, so what a
picture of that size shows is what is required. Numbers in quotes are ranges, both ends included.

To have a program judged, let it draw each pose and write the same file with what it drew: "objects" by number or by
name, or "triangles". Then

    cullbench judge NAME.obj --path NAME.required.json --size WIDTHxHEIGHT --drawn FILE

counts missed pixels, falsely culled triangles and waste, says what kind of culling it is, and ends with status 1 where
something that is seen is missing. `battery.json` lists the cases of the battery with their right answers, those
without a scene, too.
)";

}  // namespace

std::vector<SuiteScene> suiteScenes() {
    std::vector<SuiteScene> scenes;
    for (const stability::StabilityCase& each : stability::battery()) {
        if (each.scene.empty() || std::ranges::find(kNotForFiles, each.scene) != kNotForFiles.end()) continue;
        const std::string name = each.scene.substr(each.scene.find('/') + 1);
        if (std::ranges::find(scenes, name, &SuiteScene::name) != scenes.end()) continue;
        scenes.push_back({name, each.scene, "given", each.sizes});
    }
    scenes.push_back({"teapot", "teapot:triangles=4000", "fibonacci:8"});
    scenes.push_back({"field", "field:mesh=star:triangles=500,n=10", "walk:8"});
    scenes.push_back({"layers", "layers:count=12,triangles=400,waves=0.02", "front:4"});
    scenes.push_back({"plant", "plant:pipelines=6", "walk:8"});
    return scenes;
}

std::vector<WrittenScene> writeSuite(const std::filesystem::path& folder, const std::vector<SuiteScene>& scenes,
                                     Renderer& renderer, const Progress& progress) {
    std::error_code failure;
    std::filesystem::create_directories(folder, failure);
    if (failure) throwUsage(CULLSCOPE_TR("The folder %1 cannot be made: %2."), {folder.string(), systemReason(failure.value())});
    std::vector<WrittenScene> written;
    for (size_t i = 0; i < scenes.size(); ++i) {
        progress.check();
        progress.tell(double(i) / double(scenes.size()), CULLSCOPE_TR("writing"));
        const SuiteScene& one = scenes[i];
        const std::string mesh = one.name + ".obj";
        const Progress quiet{nullptr, progress.stop};
        const ScenePointer made = openScene(one.specification, {}, quiet).scene;
        // The path is that of the scene as it was made; the sets are those of what a reader of the file has.
        const CameraPath path = cameraPath(one.path, *made, quiet);
        saveScene(folder / mesh, *made, quiet);
        const ScenePointer read = openScene((folder / mesh).string(), {}, quiet).scene;
        WrittenScene result{one.name, read->triangleCount(), read->instances().size()};
        for (const Viewport& size : one.sizes) {
            const std::string words = one.sizes.size() > 1 ? fmt::format(".{}x{}", size.width, size.height) : "";
            writeDrawnSets(folder / (one.name + words + ".required.json"),
                           required(read, mesh, path, size, renderer, result, quiet));
        }
        written.push_back(std::move(result));
    }
    writeFileAtomically(folder / "battery.json", [](std::ostream& out) { out << casesJson(); });
    writeFileAtomically(folder / "README.md", [](std::ostream& out) { out << kReadme; });
    return written;
}

}  // namespace cullscope::suite
