#pragma once

#include "core/raster/occlusion_buffer.h"
#include "core/visibility/eye_bounds.h"
#include "core/visibility/part_walk.h"

namespace cullscope::occlusion {

/// Whether a buffer hides a part of one instance. Keeps references.
class BufferHiding final : public HidingTest {
public:
    BufferHiding(const OcclusionBuffer& buffer, const View& view, const EyeFromLocal& object)
        : HidingTest(0), m_buffer(buffer), m_view(view), m_object(object) {
        for (int column = 0; column < 3; ++column) m_spread[column] = glm::abs(object.linear[column]);
    }

    [[nodiscard]] Reach test(const Vec3& middle, const Vec3& half, Decision* said) const override;

private:
    const OcclusionBuffer& m_buffer;
    const View& m_view;
    const EyeFromLocal& m_object;
    Mat3 m_spread{0.0};  ///< its entries' sizes: of a level box in the world around a box that is level in the mesh
};

}  // namespace cullscope::occlusion
