#pragma once

#include <cstdint>
#include <vector>

#include "core/geometry/shaft.h"
#include "core/scene/scene_rays.h"
#include "core/spatial/welded_triangles.h"

namespace cullscope {

/// The pictures for which a proof holds (HidingSheets): how far a view may cut off what is near, how coarse its pixels and its
/// depths may be.
struct SightRoom {
    /// No corner of the near rectangle is so far from the eye.
    double reach = 0.0;
    /// A pixel's width and height at distance 1 are at most so large.
    static constexpr double kPixel = 0x1p-6;
    /// The near distance is at least so large: interpolated depths have errors that grow with the squared distance over it.
    double nearest = 0.0;

    SightRoom() = default;
    explicit SightRoom(const Scene& scene);
    [[nodiscard]] bool holds(const View& view) const;
};

/// Proves that nothing in a box can be seen from anywhere in another one.
///
/// All lines of sight between the two boxes lie in their shaft. Let a sheet be any set of the scene's triangles, and its border
/// the edges that an odd number of them share. Move one end of a line of sight, or both: whether it crosses the sheet an odd
/// number of times changes only where an end passes through the sheet, or the line over the border. So where the sheet touches
/// neither box and its border lies outside the shaft, all lines of sight cross it an odd number of times as soon as one does, and
/// an odd number is not 0: nothing in one box is visible from the other. The sheet need not be flat, convex or of one object; it
/// must only have no hole in the shaft.
///
/// What OpenGL rounds is room in the proof: the farther box grows sideways by what corners are moved when they are snapped to a
/// part of a pixel, the sheet keeps clear of it by the error of depths, and of the nearer one by what a near plane cuts off. Only
/// edges whose corners OpenGL places alike count as shared (WeldedTriangles). Triangles of an object whose back faces are not
/// drawn are used only where their fronts face all of the box from which is looked. Needles, and triangles that may be seen
/// nearly edge-on, are no part of a sheet: a sample that a snapped corner moved into one may get any depth.
///
/// Two things are not proven. What hides must have the depths of its own plane within these rooms also where OpenGL clips it at
/// a side of the picture, into pieces that may be needles; and what is hidden must not be drawn before its own box, as a surface
/// that is seen edge-on may be by the same rounding.
class HidingSheets {
public:
    /// The scene, triangles and rays must outlive this object.
    HidingSheets(const Scene& scene, const WeldedTriangles& triangles, const SceneRays& rays);

    /// What one thread remembers while it looks for sheets.
    struct Work {
        std::vector<uint32_t> inSheet, odd;  ///< by triangle, and by edge: the number of the search in which it is
        std::vector<uint32_t> sheet, open;
        uint32_t search = 0;
    };

    /// Whether it is proven; false says nothing. Where no sheet is found, the larger box is halved, at most `halvings` times.
    [[nodiscard]] bool hides(const Box3& from, const Box3& box, int halvings, Work& work) const;

private:
    struct Pair;

    [[nodiscard]] bool hiddenByOneSheet(const Box3& from, const Box3& box, Work& work, bool& blocked) const;
    [[nodiscard]] bool sheetThrough(uint32_t seed, const Pair& pair, Work& work) const;
    [[nodiscard]] bool add(uint32_t triangle, const Pair& pair, Work& work) const;
    [[nodiscard]] bool usable(uint32_t triangle, const Pair& pair) const;
    [[nodiscard]] bool close(uint32_t edge, const Pair& pair, Work& work) const;
    [[nodiscard]] bool crossedOdd(const Pair& pair, const Work& work) const;

    const Scene& m_scene;
    const WeldedTriangles& m_triangles;
    const SceneRays& m_rays;
    SightRoom m_room;
    double m_diagonal = 0.0;
    double m_rounding = 0.0;         ///< of OpenGL's positions, besides what grows with the distance
    std::vector<bool> m_dropsBacks;  ///< by instance
};

}  // namespace cullscope
