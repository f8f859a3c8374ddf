#include "core/frame/cause.h"

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
            return CULLSCOPE_TR("too small");
        case Cause::NoSample:
            break;
    }
    return CULLSCOPE_TR("covers no sample");
}

const char* planeName(FrustumPlane plane) {
    switch (plane) {
        case FrustumPlane::Left:
            return CULLSCOPE_TR("left plane");
        case FrustumPlane::Right:
            return CULLSCOPE_TR("right plane");
        case FrustumPlane::Bottom:
            return CULLSCOPE_TR("bottom plane");
        case FrustumPlane::Top:
            return CULLSCOPE_TR("top plane");
        case FrustumPlane::Near:
            return CULLSCOPE_TR("near plane");
        case FrustumPlane::Far:
            break;
    }
    return CULLSCOPE_TR("far plane");
}

}  // namespace cullscope
