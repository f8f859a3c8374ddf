#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/base/progress.h"
#include "core/scene/scene.h"

namespace cullscope {

/// Of each instance of a scene the world boxes of a few parts of its mesh, which together hold all its triangles: of a wall that
/// stands askew, or of a mesh that has its parts around an open space, they enclose far less than its one box. As that one, they
/// contain every vertex also as displaced by a picture's float rounding (Scene::pictureRounding).
class PartBoxes {
public:
    static constexpr size_t kMost = 8;            ///< parts of an instance
    static constexpr size_t kLeastTriangles = 8;  ///< of a part; smaller meshes have none

    PartBoxes() = default;
    /// Halves each mesh by the medians of its triangles' centres along the longest side. O(triangles) for each instance. Throws
    /// Error(Interrupted) soon after a stop is requested.
    explicit PartBoxes(const Scene& scene, const Progress& progress = {});

    /// Empty where the instance's box is all there is.
    [[nodiscard]] std::span<const Box3> of(uint32_t instance) const {
        return std::span(m_boxes).subspan(m_first[instance], m_first[instance + 1] - m_first[instance]);
    }
    [[nodiscard]] uint64_t bytes() const { return m_boxes.size() * sizeof(Box3) + m_first.size() * sizeof(uint32_t); }

private:
    std::vector<Box3> m_boxes;
    std::vector<uint32_t> m_first;  ///< by instance, and the end
};

}  // namespace cullscope
