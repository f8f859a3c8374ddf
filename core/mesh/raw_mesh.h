#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "core/geometry/types.h"
#include "core/mesh/load.h"

namespace cullscope {

/// Stands for a corner whose index names no vertex.
inline constexpr uint32_t kNoVertex = 0xffffffffU;

/// Larger coordinates are treated like infinite ones: their offsets would leave what a float's squares can hold.
inline constexpr double kLargestCoordinate = 1e30;

/// An object as it stands in a file: nothing checked yet.
struct RawMesh {
    std::string name;
    std::vector<Vec3> wide;                ///< positions of files with double precision (or text); else empty
    std::vector<Vec3f> narrow;             ///< positions of files whose coordinates are floats; else empty
    std::vector<Vec3f> normals;            ///< empty, or one a position; those that are unusable are made
    std::vector<uint32_t> triangles;       ///< three corners a face; kNoVertex or anything else too large: out of range
    std::vector<uint32_t> polygonCorners;  ///< faces with another number of corners, one after the other
    std::vector<size_t> polygonEnds;       ///< where each of them ends in polygonCorners
    bool verticesCounted = false;          ///< the reader has counted unreferenced and non-finite vertices itself

    [[nodiscard]] size_t vertexCount() const { return wide.empty() ? narrow.size() : wide.size(); }
    [[nodiscard]] Vec3 position(size_t vertex) const { return wide.empty() ? Vec3(narrow[vertex]) : wide[vertex]; }
    [[nodiscard]] size_t bytes() const;

    /// Adds a face with any number of corners.
    void addFace(std::span<const uint32_t> corners);
};

[[nodiscard]] inline bool usableCoordinates(const Vec3& position) {
    const Vec3 size = glm::abs(position);  // comparisons with NaN are false
    return size.x <= kLargestCoordinate && size.y <= kLargestCoordinate && size.z <= kLargestCoordinate;
}

}  // namespace cullscope
