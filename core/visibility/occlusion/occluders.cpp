#include "core/visibility/occlusion/occluders.h"

#include <algorithm>
#include <cmath>

#include "core/base/message.h"
#include "core/visibility/eye_bounds.h"

namespace cullscope::occlusion {

Occluders::Occluders(const Scene& scene, const Progress& progress) : meshes(occluderMeshes(scene, progress)) {
    areaOfSquares.reserve(scene.instances().size());
    for (const Instance& instance : scene.instances()) {
        const double volume = std::abs(glm::determinant(Mat3(instance.worldFromMesh)));
        areaOfSquares.push_back(std::cbrt(volume * volume));
    }
}

uint64_t Occluders::bytes() const {
    uint64_t sum = areaOfSquares.size() * sizeof(double);
    for (const OccluderMesh& mesh : meshes) sum += mesh.bytes();
    return sum;
}

size_t Occluders::countFrom(const Scene& scene, uint32_t instance, const View& view, double pixels) const {
    const Box3& box = scene.instanceBox(instance);
    const Vec3 beyond = glm::max(glm::max(box.min - view.eye(), view.eye() - box.max), Vec3(0.0));
    const double distance = std::max(glm::length(beyond), view.frustum().nearDistance);
    const double square = areaOfSquares[instance];
    if (!(square > 0.0)) return 0;
    return meshes[scene.instances()[instance].mesh].countFrom(areaOfPixels(view, distance, pixels) / square);
}

double areaOfPixels(const View& view, double distance, double pixels) {
    const double pixel = 2.0 * view.frustum().halfHeightAt(distance) / view.viewport().height;
    return pixels * pixel * pixel;
}

AskedBox askedBox(const OcclusionBuffer& buffer, const Box3& world, const View& view) {
    const EyeBox box = relativeToEye(world, view.eye());
    return askedBox(buffer, box, marginFromEye(world.centre(), box.centre, glm::length(box.halfExtent), view.eye()), view);
}

AskedBox askedBox(const OcclusionBuffer& buffer, EyeBox box, double margin, const View& view) {
    AskedBox asked;
    asked.growth = boxGrowth(box, margin, view);
    const double rounding = boxRounding(box, margin, view);
    box.halfExtent += Vec3(rounding);
    asked.nearest = nearestAhead(box, view.frustum()) - asked.growth;
    // An infinite box, or one of no numbers, is placed nowhere.
    asked.place = buffer.place(box, asked.growth);
    return asked;
}

Decision hidingTest(bool hidden, const char* sentence, std::initializer_list<double> operands) {
    Decision decision;
    decision.containment = hidden ? Containment::Outside : Containment::Straddles;
    decision.cause = Cause::Hidden;
    decision.sentence = sentence;
    std::ranges::copy(operands, decision.operands.begin());
    decision.operandCount = uint8_t(operands.size());
    return decision;
}

Decision askedDecision(const OcclusionBuffer& buffer, const AskedBox& asked, bool hidden, const View& view) {
    if (!asked.place || asked.place->pixels() == 0)
        return hidingTest(
            false,
            CULLSCOPE_TR("Its box, grown by %1, reaches before the near plane or lies beside the picture: it counts "
                         "as visible."),
            {asked.growth});
    const BoxInPicture& place = *asked.place;
    const auto pixels = double(place.pixels());
    const float farthest = buffer.farthestIn(place);
    if (!(farthest > 0.0f))
        return hidingTest(hidden,
                          CULLSCOPE_TR("Its box, grown by %1, begins %2 ahead and covers at most %3 pixels: one of them shows no "
                                       "occluder, so it counts as visible."),
                          {asked.growth, asked.nearest, pixels});
    return hidingTest(hidden,
                      hidden ? CULLSCOPE_TR("Its box, grown by %1, begins %2 ahead and covers at most %3 pixels: all show "
                                            "occluders, the farthest %4 ahead, which hide it.")
                             : CULLSCOPE_TR("Its box, grown by %1, begins %2 ahead and covers at most %3 pixels: all show "
                                            "occluders, but the farthest is %4 ahead, so it counts as visible."),
                      {asked.growth, asked.nearest, pixels, view.distanceFromDepth(farthest)});
}

}  // namespace cullscope::occlusion
