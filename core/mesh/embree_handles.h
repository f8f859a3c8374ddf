#pragma once

#include <embree3/rtcore.h>

#include <memory>

namespace cullscope {

/// Embree's objects as pointers that release them.
template <typename Handle, void (*Release)(Handle)>
struct EmbreeReleaser {
    using pointer = Handle;
    void operator()(Handle handle) const { Release(handle); }
};
using EmbreeDevicePointer = std::unique_ptr<RTCDevice, EmbreeReleaser<RTCDevice, rtcReleaseDevice>>;
using EmbreeScenePointer = std::unique_ptr<RTCScene, EmbreeReleaser<RTCScene, rtcReleaseScene>>;

}  // namespace cullscope
