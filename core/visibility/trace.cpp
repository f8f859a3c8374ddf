#include "core/visibility/trace.h"

#include "core/base/message.h"

namespace cullscope {

const char* causeName(Cause cause) {
    switch (cause) {
        case Cause::OutsideFrustum:
            return CULLSCOPE_TR("outside the frustum");
        case Cause::BackFacing:
            return CULLSCOPE_TR("back-facing");
        case Cause::Hidden:
            return CULLSCOPE_TR("hidden");
        case Cause::TooSmall:
            break;
    }
    return CULLSCOPE_TR("too small");
}

}  // namespace cullscope
