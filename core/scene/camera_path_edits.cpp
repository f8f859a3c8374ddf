#include "core/scene/camera_path_edits.h"

#include <cassert>

namespace cullscope {
namespace {

Vec3 smooth(const Vec3& before, const Vec3& here, const Vec3& after) { return 0.25 * before + 0.5 * here + 0.25 * after; }

}  // namespace

CameraPath trimmed(const CameraPath& path, size_t first, size_t last) {
    assert(first <= last && last < path.poses.size());
    CameraPath result = path;
    result.poses.assign(path.poses.begin() + std::ptrdiff_t(first), path.poses.begin() + std::ptrdiff_t(last) + 1);
    return result;
}

CameraPath smoothed(const CameraPath& path) {
    constexpr double kLeast = 1e-3;  // of the former distance to the target
    CameraPath result = path;
    for (size_t i = 1; i + 1 < path.poses.size(); ++i) {
        const CameraPath::Pose &before = path.poses[i - 1], &here = path.poses[i], &after = path.poses[i + 1];
        const CameraPath::Pose pose{smooth(before.eye, here.eye, after.eye), smooth(before.target, here.target, after.target),
                                    smooth(before.up, here.up, after.up)};
        const Vec3 forward = pose.target - pose.eye;
        const bool looks = glm::length(forward) > kLeast * glm::length(here.target - here.eye);
        if (looks && glm::length(glm::cross(forward, pose.up)) > kLeast * glm::length(forward)) result.poses[i] = pose;
    }
    return result;
}

}  // namespace cullscope
