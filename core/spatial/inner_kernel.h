#pragma once

#include <memory>
#include <vector>

#include "core/mesh/triangle_mesh.h"
#include "core/spatial/direction_map.h"

namespace cullscope {

/// The part of a closed solid that is filled from the centre of its bounding sphere outward: in every direction up to a radius.
/// It is star-shaped whatever the solid is, and none of the surface lies in it, so that what lies behind it as seen from outside
/// is hidden (methods.md, `spherical-lossless`).
class InnerKernel {
public:
    /// Whether a mesh has a kernel; where it has none, why.
    enum class State {
        Filled,
        NotClosed,      ///< open, not manifold or not consistently oriented: there is no inside
        CentreOutside,  ///< the centre lies in no part of the solid
        TooThin,        ///< the surface comes too near to the centre
        NotAsked        ///< above kOptionalAnalysisLimit triangles nobody asks whether a mesh is closed
    };
    /// English, marked for translation.
    [[nodiscard]] static const char* stateName(State state);

    /// In parallel; the result does not depend on the number of threads.
    explicit InnerKernel(const TriangleMesh& mesh);

    [[nodiscard]] State state() const { return m_state; }
    [[nodiscard]] bool filled() const { return m_state == State::Filled; }
    /// Whether the surface around it shows its front sides outward: where only those are drawn, nothing else can hide.
    [[nodiscard]] bool outward() const { return m_outward; }

    /// Its cells are those of the octahedral map of this level.
    [[nodiscard]] uint32_t level() const { return m_level; }
    /// The radius up to which every direction of a cell is filled, mesh units.
    [[nodiscard]] float radius(const MapCell& cell) const { return m_radii[place(cell.x, cell.y)]; }
    /// The same of every direction within `reach()` of a direction, which is of any length but 0.
    [[nodiscard]] float radiusAround(const Vec3& direction) const {
        const MapCell cell = octahedralCell(direction, m_level);
        return m_radiiAround[place(cell.x, cell.y)];
    }
    [[nodiscard]] double reach() const { return m_reach; }  ///< radians
    /// Over all directions.
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
    double m_overhang;  ///< radians by which a triangle may reach beyond its centroid's direction
    State m_state;
    float m_least = 0.0f;
    std::vector<float> m_radii, m_radiiAround;  ///< by row (y), then x
};

using InnerKernelPointer = std::shared_ptr<const InnerKernel>;

}  // namespace cullscope
