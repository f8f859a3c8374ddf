#pragma once

#include <memory>
#include <vector>

#include "core/mesh/triangle_mesh.h"
#include "core/spatial/direction_map.h"

namespace cullscope {

/// The part of a closed solid that is filled from the centre of its bounding sphere outward: in every direction up to a radius.
/// It is star-shaped for every solid and contains no part of the surface, so that everything behind it, seen from outside, is
/// hidden (docs/methods/spherical.md).
class InnerKernel {
public:
    /// Whether a mesh has a kernel, or why it has none.
    enum class State {
        Filled,
        NotClosed,      ///< open, non-manifold or not consistently oriented: it has no inside
        CentreOutside,  ///< the centre is not inside the solid
        TooThin,        ///< the surface comes too near to the centre
        NotAsked        ///< above kOptionalAnalysisLimit triangles it is not checked whether the mesh is closed
    };
    /// English, marked for translation.
    [[nodiscard]] static const char* stateName(State state);

    /// Computed in parallel; the result does not depend on the number of threads.
    explicit InnerKernel(const TriangleMesh& mesh);

    [[nodiscard]] State state() const { return m_state; }
    [[nodiscard]] bool filled() const { return m_state == State::Filled; }
    /// Whether the surface around the kernel is front-facing outward. Only then can it hide anything where back faces are not
    /// drawn.
    [[nodiscard]] bool outward() const { return m_outward; }

    /// The level of the octahedral map whose cells are the kernel's.
    [[nodiscard]] uint32_t level() const { return m_level; }
    /// The radius up to which the solid is filled in every direction of a cell, mesh units.
    [[nodiscard]] float radius(const MapCell& cell) const { return m_radii[place(cell.x, cell.y)]; }
    /// The same for all directions within `reach()` of a direction, which is of any length but 0.
    [[nodiscard]] float radiusAround(const Vec3& direction) const {
        const MapCell cell = octahedralCell(direction, m_level);
        return m_radiiAround[place(cell.x, cell.y)];
    }
    [[nodiscard]] double reach() const { return m_reach; }  ///< radians
    /// The smallest radius over all directions.
    [[nodiscard]] float leastRadius() const { return m_least; }
    [[nodiscard]] uint64_t bytes() const { return (m_radii.size() + m_radiiAround.size()) * sizeof(float); }

private:
    [[nodiscard]] size_t place(uint32_t x, uint32_t y) const { return (size_t(y) << m_level) + x; }
    [[nodiscard]] State stateOf(const TriangleMesh& mesh);
    [[nodiscard]] std::vector<float> nearestSurface(const TriangleMesh& mesh) const;
    void lookAround(const std::vector<float>& nearest);

    uint32_t m_level;
    bool m_outward = false;
    double m_reach;
    double m_overhang;  ///< radians by which a triangle may extend beyond the direction of its centroid
    State m_state;
    float m_least = 0.0f;
    std::vector<float> m_radii, m_radiiAround;  ///< by row (y), then x
};

using InnerKernelPointer = std::shared_ptr<const InnerKernel>;

}  // namespace cullscope
