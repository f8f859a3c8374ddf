#include "core/scene/split_scene.h"

#include "core/base/error.h"
#include "core/mesh/split.h"

namespace cullscope {
namespace {

constexpr size_t kMostObjects = 4'000'000;  ///< the same as the largest field

/// The range of new meshes that are the parts of one old mesh.
struct Run {
    uint32_t first = 0;
    uint32_t count = 0;
};

void refuseTooMany(const Scene& scene, const std::vector<Run>& runs) {
    size_t objects = 0;
    for (const Instance& instance : scene.instances()) objects += runs[instance.mesh].count;
    if (objects > kMostObjects)
        throwUsage(CULLSCOPE_TR("The scene would fall into %1 objects; at most %2 are possible. Split it by=clusters with more "
                                "triangles each."),
                   {std::to_string(objects), std::to_string(kMostObjects)});
}

}  // namespace

ScenePointer splitScene(const Scene& scene, std::string name, const SplitRule& rule, const Progress& progress) {
    std::vector<MeshPointer> meshes;
    std::vector<Run> runs;
    const double share = 1.0 / double(std::max<size_t>(1, scene.meshes().size()));
    for (const MeshPointer& mesh : scene.meshes()) {
        const Progress part = progress.part(double(runs.size()) * share, double(runs.size() + 1) * share);
        const std::vector<MeshPointer> parts =
            rule.by == SplitRule::By::Clusters ? clusters(mesh, rule.triangles, part) : components(mesh, part);
        runs.push_back({static_cast<uint32_t>(meshes.size()), static_cast<uint32_t>(parts.size())});
        meshes.insert(meshes.end(), parts.begin(), parts.end());
    }
    refuseTooMany(scene, runs);
    std::vector<Instance> instances;
    for (const Instance& instance : scene.instances()) {
        const Run& run = runs[instance.mesh];
        for (uint32_t part = 0; part < run.count; ++part)
            instances.push_back({run.first + part, instance.worldFromMesh,
                                 run.count == 1 ? instance.name : instance.name + " " + std::to_string(part + 1)});
    }
    SceneRemarks remarks;
    remarks.up = scene.remarks().up;
    remarks.guessedUp = scene.remarks().guessedUp;
    return std::make_shared<const Scene>(std::move(name), std::move(meshes), std::move(instances), &scene, std::move(remarks));
}

}  // namespace cullscope
