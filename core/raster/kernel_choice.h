#pragma once

#include <cstddef>
#include <initializer_list>

#include "core/raster/scene_triangles.h"

namespace cullscope {

/// The variant of a kernel for an instruction set, of those in the order of RasterSimd; null: there is none.
template <typename Kernel>
Kernel* kernelFor(RasterSimd simd, std::initializer_list<Kernel*> variants) {
    return size_t(simd) < variants.size() ? variants.begin()[size_t(simd)] : nullptr;
}

}  // namespace cullscope

/// The kernels of a name that are compiled for this kind of processor.
#ifdef CULLSCOPE_RASTER_AVX
#define CULLSCOPE_VARIANTS(name) \
    { name##Portable, name##Avx2, name##Avx512 }
#else
#define CULLSCOPE_VARIANTS(name) \
    { name##Portable }
#endif
