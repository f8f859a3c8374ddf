#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/scene/camera_path.h"
#include "core/scene/scene.h"

namespace cullscope {

/// What a program draws of a scene, pose by pose: triangles, or whole objects.
struct DrawnSets {
    /// Ranges of scene triangle numbers [first, end), ascending and disjoint.
    using Triangles = std::vector<std::pair<uint64_t, uint64_t>>;

    std::string file{};            ///< that they were read from
    CameraPath path;               ///< the poses that the file has beside the sets; none where it has only sets
    std::vector<Triangles> poses;  ///< what is drawn at each
    bool byObjects = true;         ///< whether every pose names objects
    std::optional<Viewport> size;  ///< of the picture that they were found for, where the file says it

    /// The pose whose camera is nearest to one: by place and direction of view. There must be a pose with a camera.
    [[nodiscard]] size_t nearestPose(const Camera& camera) const;
};

/// Triangle numbers as ranges: sorted, each once.
[[nodiscard]] DrawnSets::Triangles rangesOf(std::vector<uint32_t> triangles);

/// Reads the JSON form (docs/files.md, "Drawn sets"): a camera path whose poses also list "objects", by number or name, or
/// "triangles", by number or range. The cameras may be missing. Throws Error(Input) naming file, pose and entry.
[[nodiscard]] DrawnSets readDrawnSets(const std::filesystem::path& file, const Scene& scene);

/// The picture size that a file of cameras states, with drawn sets beside them or without; none: it states none, or is no file in
/// JSON. Throws Error(Input) where it is no size.
[[nodiscard]] std::optional<Viewport> pictureSizeIn(const std::filesystem::path& file);

/// One pose of a file to be written.
struct WrittenPose {
    CameraPath::Pose pose;
    std::vector<uint32_t> objects;     ///< instances, ascending
    DrawnSets::Triangles triangles{};  ///< empty with `objects` only
};
struct WrittenSets {
    std::string scene;  ///< file or specification, as a remark
    CameraPath path;    ///< of which the lens is written
    Viewport size;
    std::string facing;  ///< "two-sided", "front" or "auto", as a remark
    std::vector<WrittenPose> poses;
};
void writeDrawnSets(const std::filesystem::path& file, const WrittenSets& sets);

}  // namespace cullscope
