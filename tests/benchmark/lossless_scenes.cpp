#include "tests/benchmark/lossless_scenes.h"

#include "core/visibility/strategy_request.h"

namespace cullscope::benchmark {

MeshPointer freshCopy(const TriangleMesh& mesh) {
    TriangleMesh::Data data;
    data.name = mesh.name();
    data.origin = mesh.origin();
    data.positions.assign(mesh.positions().begin(), mesh.positions().end());
    data.normals.assign(mesh.normals().begin(), mesh.normals().end());
    data.indices.assign(mesh.indices().begin(), mesh.indices().end());
    return std::make_shared<TriangleMesh>(std::move(data));
}

ScenePointer sceneOf(MeshPointer mesh) {
    std::string name = mesh->name();
    return std::make_shared<Scene>(name, std::vector<MeshPointer>{std::move(mesh)}, std::vector<Instance>{{0, Mat4(1.0), name}});
}

namespace {

ParameterSet losslessParameters(MapLayout layout, uint32_t level, bool horizon, const char* facing) {
    ParameterSet parameters(findStrategy("spherical-lossless").info.parameters);
    parameters.set("layout", std::string(mapLayoutId(layout)));
    parameters.set("level", int64_t{level});
    parameters.set("horizon", horizon);
    parameters.set("facing", std::string(facing));
    return parameters;
}

}  // namespace

test::CullerPointer lossless(MapLayout layout, uint32_t level, bool horizon, const char* facing) {
    return test::makeCuller("spherical-lossless", losslessParameters(layout, level, horizon, facing));
}

std::string losslessText(MapLayout layout, uint32_t level, bool horizon, const char* facing) {
    return strategyText({"spherical-lossless", losslessParameters(layout, level, horizon, facing)});
}

CameraPath objectPath(const std::string& name, const Scene& scene, size_t views) {
    if (name == kObjectPaths.back()) return cameraPath("fibonacci:" + std::to_string(views), scene);
    CameraPath path = cameraPath(name, scene);
    std::vector<CameraPath::Pose> chosen;
    for (size_t i = 0; i < views; ++i) chosen.push_back(path.poses[i * path.poses.size() / views]);
    path.poses = std::move(chosen);
    return path;
}

}  // namespace cullscope::benchmark
