#pragma once

#include <cstdint>
#include <cstring>

// Vectors of the kernels that are compiled for several instruction sets; each of those files has its own, hence the anonymous
// namespace.

namespace cullscope {
namespace {

// Eight pixels of a tile or a row. The compiler splits them where a register holds fewer.
inline constexpr int kLanes = 8;
using Floats = float __attribute__((vector_size(32)));
using Ints = int32_t __attribute__((vector_size(32)));
using Numbers = uint32_t __attribute__((vector_size(32)));
using Doubles = double __attribute__((vector_size(32)));
using EightDoubles = double __attribute__((vector_size(64)));
using HalfFloats = float __attribute__((vector_size(16)));
using HalfNumbers = uint32_t __attribute__((vector_size(16)));
using HalfInts = int32_t __attribute__((vector_size(16)));

// Reads and writes pixels in memory, where a vector may begin at any of them; no vector is returned, which without AVX would have
// a calling convention of its own.
template <typename Vector>
inline void load(Vector& vector, const void* pixels) {
    std::memcpy(&vector, pixels, sizeof vector);
}
template <typename Vector>
inline void store(void* pixels, const Vector& vector) {
    std::memcpy(pixels, &vector, sizeof vector);
}

}  // namespace
}  // namespace cullscope
