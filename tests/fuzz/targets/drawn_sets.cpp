#include "core/scene/drawn_sets.h"

#include "core/mesh/parametric.h"
#include "tests/fuzz/support.h"
#include "tests/fuzz/targets.h"

namespace cullscope::fuzz {

void drawn_sets(std::string_view input) {
    static const Scene kScene("two", {sphereMesh(20), torusMesh(40)}, {{0, Mat4(1.0), "a"}, {1, Mat4(1.0), "b"}});
    const std::filesystem::path file = fileOf(input, "input.json");
    DrawnSets sets;
    if (!acceptedFile(file, [&] { sets = readDrawnSets(file, kScene); })) return;
    require(!sets.poses.empty(), "sets without poses");
    require(sets.path.poses.empty() || sets.path.poses.size() == sets.poses.size(), "some poses have no camera");
    for (const DrawnSets::Triangles& drawn : sets.poses) {
        uint64_t before = 0;
        for (const auto& [first, end] : drawn) {
            require(first < end && end <= kScene.triangleCount(), "a range that is empty or beyond the scene");
            require(&drawn.front().first == &first || first > before, "ranges that touch or are not sorted");
            before = end;
        }
    }
    for (size_t pose = 0; pose < sets.path.poses.size(); ++pose)
        require(sets.nearestPose(sets.path.camera(pose)) < sets.poses.size(), "a nearest pose that is not there");
}

}  // namespace cullscope::fuzz
