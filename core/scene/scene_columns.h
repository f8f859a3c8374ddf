#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/scene/scene.h"

namespace cullscope {

/// The box around the middle 94 % of a scene's triangles along each axis: where its parts are, without what lies far from them or
/// is spread around them, such as a sky. The bounds of a scene of few triangles.
[[nodiscard]] Box3 denseBox(const Scene& scene);

/// What vertical lines through a scene cross. The lines stand on a grid over a part of it as seen from above.
class SceneColumns {
public:
    struct Crossing {
        double height = 0.0;  ///< along the axis that is up
        bool floor = false;   ///< a front face that is at most 60 degrees from level
    };

    /// `side`: columns along the longer side of `part`, of which the height does not count. Every triangle is looked at once:
    /// about 50 ms for a million.
    SceneColumns(const Scene& scene, const Box3& part, uint32_t side);

    [[nodiscard]] uint32_t across() const { return m_across; }
    [[nodiscard]] uint32_t along() const { return m_along; }
    [[nodiscard]] size_t count() const { return m_crossings.size(); }
    [[nodiscard]] uint32_t upAxis() const { return m_up; }
    /// By ascending height.
    [[nodiscard]] std::span<const Crossing> crossings(size_t column) const { return m_crossings[column]; }
    /// A point of a column.
    [[nodiscard]] Vec3 at(size_t column, double height) const;

private:
    void add(const std::array<Vec3, 3>& corners, bool mirrored);

    uint32_t m_up, m_first, m_second;  ///< axes: up, along a row of columns, from row to row
    uint32_t m_across = 0, m_along = 0;
    double m_step = 1.0;  ///< between two columns, scene units
    Vec3 m_corner{0.0};   ///< the first column
    std::vector<std::vector<Crossing>> m_crossings;
};

}  // namespace cullscope
