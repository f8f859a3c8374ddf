#include "core/visibility/object_record.h"

namespace cullscope {

void ObjectRecord::attach(std::shared_ptr<const DecisionDetail> detail) {
    m_details.push_back({m_decisions.size() - 1, std::move(detail)});
}

void ObjectRecord::sayTo(FrameContext& frame) const {
    auto detail = m_details.begin();
    for (size_t number = 0; number < m_decisions.size(); ++number) {
        frame.say(m_decisions[number]);
        for (; detail != m_details.end() && detail->decision == number; ++detail) frame.attach(detail->detail);
    }
}

}  // namespace cullscope
