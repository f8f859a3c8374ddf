#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/progress.h"
#include "core/scene/camera.h"
#include "core/scene/scene.h"

namespace cullscope {

/// Camera poses with common lens parameters.
struct CameraPath {
    std::string name;
    Angle fovy = Angle::fromDegrees(45.0);
    double nearDistance = 0.05;
    double farDistance = 1000.0;
    ProjectionKind projection = ProjectionKind::Perspective;
    double height = 2.0;  ///< of parallel views, in scene units
    struct Pose {
        Vec3 eye, target, up;
    };
    std::vector<Pose> poses;

    [[nodiscard]] Camera camera(size_t pose) const;
};

/// The most poses of a path, built in or from a file.
inline constexpr size_t kMostPoses = 1'000'000;

/// A built-in path (builtInPaths()) for a scene, or a JSON file. `tour:N` and the cases take seconds in large scenes.
/// Throws Error(Usage) for an unknown name or a bad number of poses, Error(Input) naming file and field for a bad or missing
/// file, Error(Interrupted) on a stop request.
[[nodiscard]] CameraPath cameraPath(std::string_view nameOrFile, const Scene& scene, const Progress& progress = {});

/// The vertical field of view of a picture of that size with that horizontal one; both are full angles.
[[nodiscard]] Angle verticalField(Angle horizontal, const Viewport& size);

/// The path that a scene is measured on by default: `given` where it gives its cameras, `tour:16` where one stands in it
/// (isStoodIn in scene/tour.h), else `fibonacci:16` for one object, `walk:16` for several. Looks at every triangle once.
[[nodiscard]] std::string defaultPathName(const Scene& scene);

/// The area-weighted centroid of all surfaces: the middle of an object, hardly affected by thin protruding parts. Looks at every
/// triangle once.
[[nodiscard]] Vec3 surfaceCentroid(const Scene& scene);

/// The camera with which a window first shows a scene: all of it in view, slightly from above, with the scene's up axis
/// (Scene::upAxis); or the camera that the scene gives.
[[nodiscard]] Camera overviewCamera(const Scene& scene, double aspect);

/// Sets near and far for an eye anywhere: far lies beyond the whole scene, near is half the distance to the bounding sphere, or
/// inside it half a thousandth of its radius.
void fitDepthRange(Camera& camera, const Scene& scene);

/// Reads and writes the JSON form (docs/files.md, "Camera paths"). Reading takes memory for the poses alone, and not for what
/// else a file holds. Throws Error(Input) naming file and field, and for more than kMostPoses.
[[nodiscard]] CameraPath readCameraPath(const std::filesystem::path& file);
void writeCameraPath(const std::filesystem::path& file, const CameraPath& path);

struct BuiltInPath {
    std::string id;           ///< "orbit:N"
    std::string description;  ///< English, marked for translation
};
[[nodiscard]] const std::vector<BuiltInPath>& builtInPaths();
/// Their ids with commas between them.
[[nodiscard]] std::string builtInPathNames();

}  // namespace cullscope
