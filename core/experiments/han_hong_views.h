#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>

#include "core/experiments/experiment.h"
#include "core/scene/camera_path.h"

/// Views for the tables of Han & Hong 2008.
namespace cullscope::han_hong {

/// What `spherical` considers of a scene's first object (the paper's column 고려되는 면 개수).
struct Considered {
    int caseNumber = 0;  ///< 0: no region; bands decide, or nothing
    size_t hits = 0;     ///< corner rays that hit
    uint64_t faces = 0;  ///< of the cells in the region's boxes; without a region 0
};

/// The faces that `spherical` considers, without drawing them.
class ConsideredFaces {
public:
    explicit ConsideredFaces(const Scene& scene);
    ~ConsideredFaces();

    [[nodiscard]] Considered in(const View& view) const;

private:
    struct Impl;
    std::unique_ptr<Impl> m_impl;
};

/// Table 2's cases: the paper's considered faces over the faces of its Table 2, and the direction to the eye.
struct TableCase {
    int number = 1;
    double share = 0.0;
    Vec3 direction, up;
};
[[nodiscard]] const std::array<TableCase, 3>& tableCases();

/// Random views that are tried for a case and lens (han_hong_random_views.h).
inline constexpr size_t kRandomViews = 20'000;
/// Considered faces within this share of the wanted number count as the paper's.
inline constexpr double kNearTheShare = 0.05;

/// Whether what a view considers is of the case, and within a share of that many faces.
[[nodiscard]] bool isNear(const Considered& found, const TableCase& wanted, double faces, double within);

/// A view and what is found in it.
struct FoundView {
    View view;
    Considered found;
};

/// From each of the twelve directions of a case the view, of its targets and distances, in which the case is the stated one and
/// the considered faces are nearest to its share of the object's, and of those within 2 % the one with the most corner rays that
/// hit; where the case occurs at no distance, a view of another. The scene must not be empty.
[[nodiscard]] std::vector<FoundView> nearestViews(const Scene& scene, const ConsideredFaces& considered, const TableCase& wanted,
                                                  Angle field);

/// Twelve views of a case with this vertical field of view at 4 : 3, each from slightly another direction, with the target (the
/// surface's middle, the bounding sphere's centre, or between both) and the distance at which the case is the stated one and the
/// considered faces are nearest to the case's share of the object's, and of these with the most corner rays that hit. Where a
/// direction has no view of the case near that share, or their mean is beyond 5 % of it, up to twelve random views that are take
/// the place of all (han_hong_random_views.h). Where there are none either, such a direction has the nearest view, maybe of
/// another case; the rows of the path show it. The scene must not be empty.
[[nodiscard]] CameraPath viewsOfCase(const Scene& scene, const TableCase& wanted, Angle field);

/// A path through views with one field of view, whose depth range holds those of all; without views it has no poses.
[[nodiscard]] CameraPath pathThrough(const std::vector<View>& views, Angle field, std::string name);

/// The share of an object's faces that views of a case consider: the range over the same targets and distances of 1.02 to 12
/// radii at which the case occurs, from one direction; none where it occurs at no distance.
struct ShareRange {
    double least = 0.0, most = 0.0;
};
[[nodiscard]] std::optional<ShareRange> sharesOfCase(const Scene& scene, const ConsideredFaces& faces, const TableCase& wanted,
                                                     Angle field, const Vec3& direction);

/// Which cases have views with the paper's number of faces: by lens, over all targets, distances and a case's twelve directions,
/// and among that many random views.
[[nodiscard]] Experiment tableViews(size_t randomViews = kRandomViews);

}  // namespace cullscope::han_hong
