#include "core/visibility/occlusion/cluster_occlusion.h"

#include "core/visibility/occlusion/occluders.h"

namespace cullscope::occlusion {

HidingTest::Reach BufferHiding::test(const Vec3& middle, const Vec3& half, Decision* said) const {
    // A picture's float rounding displaces what the box holds.
    const EyeBox box{m_object.linear * middle + m_object.centre, m_spread * half + Vec3(m_object.rounding)};
    const AskedBox asked = askedBox(m_buffer, box, m_object.margin, m_view);
    const bool hidden = asked.place && asked.place->pixels() > 0 && m_buffer.hides(*asked.place);
    if (said != nullptr) *said = askedDecision(m_buffer, asked, hidden, m_view);
    return hidden ? Reach::Hidden : Reach::Open;
}

}  // namespace cullscope::occlusion
