#include "core/experiments/han_hong_random_views.h"

#include <cmath>

#include "core/geometry/random.h"

namespace cullscope::han_hong {
namespace {

constexpr uint64_t kSeed = 2008;
constexpr Viewport kPicture{320, 240};
constexpr double kNearest = 1.05, kFarthest = 4.0, kNear = 0.005;  // radii

View randomView(const Sphere& around, Angle field, Random& random) {
    const double distance = kNearest * std::pow(kFarthest / kNearest, random.unit());
    const Vec3 eye = around.centre + distance * around.radius * random.direction();
    const Vec3 target = around.centre + random.unit() * around.radius * random.direction();
    return {{eye, target, random.direction(), field, kNear * around.radius, (distance + 2.0) * around.radius}, kPicture};
}

}  // namespace

std::vector<FoundView> randomViews(const Scene& scene, const ConsideredFaces& considered, Angle field, size_t tries, size_t most,
                                   const std::function<bool(const Considered& found)>& wanted) {
    Random random(kSeed);
    std::vector<FoundView> views;
    for (size_t i = 0; i < tries && views.size() < most; ++i) {
        const View view = randomView(scene.boundingSphere(), field, random);
        const Considered found = considered.in(view);
        if (wanted(found)) views.push_back({view, found});
    }
    return views;
}

std::vector<FoundView> randomViewsOfCase(const Scene& scene, const ConsideredFaces& considered, const TableCase& wanted,
                                         Angle field, size_t tries, size_t most) {
    const double faces = wanted.share * double(scene.meshOf(0).triangleCount());
    return randomViews(scene, considered, field, tries, most,
                       [&](const Considered& found) { return isNear(found, wanted, faces, kNearTheShare); });
}

}  // namespace cullscope::han_hong
