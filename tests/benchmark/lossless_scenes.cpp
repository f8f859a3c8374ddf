#include "tests/benchmark/lossless_scenes.h"

#include "core/scene/camera_path.h"

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

test::CullerPointer lossless(MapLayout layout, uint32_t level, bool horizon, const char* facing) {
    ParameterSet parameters(findStrategy("spherical-lossless").info.parameters);
    parameters.set("layout", std::string(mapLayoutId(layout)));
    parameters.set("level", int64_t{level});
    parameters.set("horizon", horizon);
    parameters.set("facing", std::string(facing));
    return test::makeCuller("spherical-lossless", parameters);
}

std::vector<Views> cutAndWithin(const Scene& scene, size_t each) {
    constexpr Viewport kSize{320, 240};
    std::vector<Views> all{{"cut", {}}, {"within", {}}};
    for (const char* name : {"case-1", "case-2", "case-3"}) {
        const CameraPath path = cameraPath(name, scene);
        for (size_t i = 0; i < each / 3; ++i) all[0].views.emplace_back(path.camera(i * path.poses.size() / (each / 3)), kSize);
    }
    const CameraPath around = cameraPath("fibonacci:" + std::to_string(each), scene);
    for (size_t i = 0; i < each; ++i) all[1].views.emplace_back(around.camera(i), kSize);
    return all;
}

}  // namespace cullscope::benchmark
