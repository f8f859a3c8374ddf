#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "core/scene/scene.h"

namespace cullscope {

/// Which faces OpenGL draws.
enum class Facing {
    TwoSided,
    Front,
    ByObject  ///< Front of each object whose front faces suffice (Scene::frontFacesSuffice), both sides of the others
};

inline constexpr size_t kFacingRules = 3;

/// The rule of one object under a rule of all: TwoSided or Front.
[[nodiscard]] inline Facing facingOf(const Scene& scene, size_t instance, Facing rule) {
    if (rule != Facing::ByObject) return rule;
    return scene.frontFacesSuffice(instance) ? Facing::Front : Facing::TwoSided;
}
/// Whether that rule drops the object's back faces.
[[nodiscard]] inline bool dropsBacks(const Scene& scene, size_t instance, Facing rule) {
    return facingOf(scene, instance, rule) == Facing::Front;
}

/// How what is drawn meets what was drawn before it.
enum class DepthRule {
    Nearest,  ///< depth test: the nearest surface stays
    InOrder   ///< no depth test: what is drawn later covers what was drawn before
};

/// What a frame is compared with the scene by: what it draws stands for the scene's own triangles, or for its objects.
enum class Grain {
    Triangle,  ///< every surface is one of the scene's triangles, or a part of one
    Object     ///< surfaces of an object may be other ones than its triangles, such as a coarser level of detail
};

/// The triangles of a scene's meshes in an order chosen by a strategy, so that what it draws lies in few ranges. Views of arrays
/// that `owner` keeps alive; they never change.
struct TriangleOrder {
    struct OfMesh {
        std::span<const uint32_t> indices;    ///< three for each triangle; empty: this mesh keeps its own order
        std::span<const uint32_t> triangles;  ///< the triangle's number in the mesh, by place in this order
        /// The places from this one on are stand-ins: other triangles between the mesh's vertices, drawn in place of its surface.
        /// Their numbers are those of some triangles of the mesh, for the object that they belong to.
        size_t standIns = SIZE_MAX;
    };
    std::vector<OfMesh> meshes;  ///< by Scene::meshes()
    std::shared_ptr<const void> owner;
};

using TriangleOrderPointer = std::shared_ptr<const TriangleOrder>;

/// The number in the mesh of the triangle at a place of an order; null: every mesh's own.
[[nodiscard]] inline uint64_t triangleAt(const TriangleOrder* order, uint32_t mesh, uint64_t place) {
    if (order == nullptr || order->meshes[mesh].triangles.empty()) return place;
    return order->meshes[mesh].triangles[place];
}

/// A range of indices of one instance's mesh, in the draw list's order.
struct DrawRange {
    uint32_t instance = 0;
    uint32_t firstIndex = 0;  ///< a multiple of 3
    uint32_t indexCount = 0;  ///< a multiple of 3

    bool operator==(const DrawRange&) const = default;
};

/// The ranges that a strategy draws, in order. Consecutive ranges of the same instance become one multi-draw call.
struct DrawList {
    Facing facing = Facing::TwoSided;
    std::vector<DrawRange> ranges;
    TriangleOrderPointer order{};  ///< the order that the ranges refer to; null: every mesh's own
    DepthRule depth = DepthRule::Nearest;
    Grain grain = Grain::Triangle;  ///< Object where a range has stand-ins

    [[nodiscard]] uint64_t triangleCount() const {
        uint64_t count = 0;
        for (const DrawRange& range : ranges) count += range.indexCount / 3;
        return count;
    }
    /// The order of a mesh's triangles; empty: its own.
    [[nodiscard]] TriangleOrder::OfMesh orderOf(uint32_t mesh) const {
        return order ? order->meshes[mesh] : TriangleOrder::OfMesh{};
    }
    /// The number in the mesh of the triangle at a place of this list's order.
    [[nodiscard]] uint64_t triangleAt(uint32_t mesh, uint64_t place) const {
        return cullscope::triangleAt(order.get(), mesh, place);
    }
    /// Whether a range has stand-ins.
    [[nodiscard]] bool standIn(uint32_t mesh, const DrawRange& range) const {
        return grain == Grain::Object && range.firstIndex / 3 >= orderOf(mesh).standIns;
    }
};

}  // namespace cullscope
