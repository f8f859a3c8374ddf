#pragma once

#include <array>
#include <optional>
#include <vector>

#include "core/frame/frame_steps.h"
#include "core/visibility/structure_snapshot.h"
#include "core/visibility/subject_place.h"

namespace cullscope {

/// Where the subject of a log's entry lies, so that views and panels can mark it: by its kind, and by what the strategy tells of
/// it (SubjectPlaces).
struct SubjectShape {
    static constexpr size_t kMostTriangles = 1'000;

    std::vector<Box3> boxes;                     ///< world coordinates
    std::vector<std::vector<Vec3>> polygons;     ///< outlines in world coordinates, as of planes that divide space
    std::vector<std::array<Vec3, 3>> triangles;  ///< corners in world coordinates; in place of more there is their box
    std::vector<std::vector<Vec3>> lines;        ///< through points in world coordinates
    std::vector<std::vector<Vec3>> compared;     ///< the same of what the subject is compared with
    std::optional<std::array<Vec2, 2>> pixels;   ///< lower left and upper right corner in the culling view's picture
    /// Of `pixels`, for pictures of other views: what the culling eye sees through them, as far as the scene reaches.
    std::vector<std::vector<Vec3>> sight;
    std::vector<std::vector<Vec2>> mapLines;       ///< over the object's map (SubjectPlace)
    std::optional<SubjectPlace::OnCurve> onCurve;  ///< on the object's curve
    std::optional<uint32_t> object;                ///< instance
    std::optional<uint64_t> triangle;              ///< number in the scene: one of the subject's
    std::optional<uint32_t> node;                  ///< of a group: its number in the structure (SnapshotNode::number)
};

/// `log`: the whole frame's. `snapshot`: of that frame. Of a command: what it draws, or the boxes that it asks about.
[[nodiscard]] SubjectShape subjectShape(const Scene& scene, const FrameLog& log, const StructureSnapshot& snapshot,
                                        const FrameEntry& entry);

/// What sentences call what an entry speaks of: a node as the snapshot names it, other subjects as the strategy does.
[[nodiscard]] EntryNames entryNames(const StructureSnapshot& snapshot, const FrameEntry& entry);

}  // namespace cullscope
