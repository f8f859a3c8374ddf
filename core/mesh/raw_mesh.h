#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/geometry/types.h"
#include "core/mesh/load.h"

namespace cullscope {

/// The index of a corner that refers to no vertex.
inline constexpr uint32_t kNoVertex = 0xffffffffU;

/// Larger coordinates count as infinite: squares of their offsets would overflow float.
inline constexpr double kLargestCoordinate = 1e30;

/// An object as read from a file, without any checks.
struct RawMesh {
    std::string name;
    std::vector<Vec3> wide;                ///< positions of files with double precision (or text); else empty
    std::vector<Vec3f> narrow;             ///< positions of files whose coordinates are floats; else empty
    std::vector<Vec3f> normals;            ///< empty, or one for each position; unusable ones are computed later
    std::vector<uint32_t> triangles;       ///< three corners for each face; kNoVertex and indices that are too large are out of
                                           ///< range
    std::vector<uint32_t> polygonCorners;  ///< faces with another number of corners, one after the other
    std::vector<size_t> polygonEnds;       ///< where each of them ends in polygonCorners
    std::optional<Vec3> origin;            ///< of the float coordinates; none: one that suits the mesh (originForFloats)
    bool verticesCounted = false;          ///< the reader has counted unreferenced and non-finite vertices itself

    [[nodiscard]] size_t vertexCount() const { return wide.empty() ? narrow.size() : wide.size(); }
    [[nodiscard]] Vec3 position(size_t vertex) const { return wide.empty() ? Vec3(narrow[vertex]) : wide[vertex]; }
    [[nodiscard]] size_t bytes() const;

    /// Appends a face with any number of corners.
    void addFace(std::span<const uint32_t> corners);
};

[[nodiscard]] inline bool usableCoordinates(const Vec3& position) {
    const Vec3 size = glm::abs(position);  // comparisons with NaN are false
    return size.x <= kLargestCoordinate && size.y <= kLargestCoordinate && size.z <= kLargestCoordinate;
}

}  // namespace cullscope
