#pragma once

#include <array>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "core/frame/frame_log.h"

namespace cullscope {

/// The parts into which a strategy cut the scene's objects, and the places in which they lie, by their names: what a frame can be
/// asked about besides objects and triangles. Read from a recorded frame that draws triangles of the strategy's own.
struct NamedParts {
    /// Of more own triangles no parts are named.
    static constexpr size_t kMostTriangles = 100'000;
    /// Leaves that a strategy made by itself are named up to so many of them.
    static constexpr size_t kMostLeaves = 64;

    struct Part {
        std::string name;               ///< the object's; with a number where the object has several parts
        uint32_t object = 0;            ///< instance
        std::optional<size_t> place;    ///< of `places`; none: it lies in none of them
        std::vector<PlaceRun> drawn{};  ///< its triangles among `own`, in the order in which they are drawn
    };

    OwnTrianglesPointer own;          ///< null: the frame drew none, and every part is a whole object
    std::vector<Part> parts;          ///< by object, then by number
    std::vector<std::string> places;  ///< the leaves of a tree, then planes in which parts lie; empty: it has none, or too many
    size_t leaves = 0;                ///< how many leaves there are, named or not

    /// Whether an object has several parts.
    [[nodiscard]] bool divides() const;
    /// The part that has a scene triangle at a point of it; none: no part has it.
    [[nodiscard]] std::optional<size_t> partAt(const Scene& scene, uint64_t triangle, const Vec3& point) const;
    /// The middle of a part's surface, in world coordinates.
    [[nodiscard]] Vec3 middleOf(const Scene& scene, size_t part) const;
};

/// What a drawn fragment belongs to: fragments of one object with the same number are one part, and the parts of an object are
/// numbered as these ascend.
struct PartKey {
    uint64_t number = 0;
    std::optional<size_t> place;  ///< NamedParts::Part::place
};
using PartOf = std::function<PartKey(const Decision& fragment)>;

/// The parts of a frame, without the places' names. Without a function, every polygon of an object of which a triangle was cut is
/// a part, in the order of the triangles and of places in space; an object that was not cut is one part.
[[nodiscard]] NamedParts namedParts(const Scene& scene, const FrameLog& log, const PartOf& partOf = {});

/// The corners of an own triangle of an instance, in world coordinates.
[[nodiscard]] std::array<Vec3, 3> worldCorners(const OwnTriangles& own, size_t triangle, const Scene& scene, uint32_t instance);
/// How far a point of a triangle's plane lies beyond its edges, as a share of the triangle's height: 0 within it. Infinity for a
/// triangle without area.
[[nodiscard]] double shareOutside(const std::array<Vec3, 3>& corners, const Vec3& point);

}  // namespace cullscope
