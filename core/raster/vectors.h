#pragma once

#include <cstdint>

// Vectors of the kernels that are compiled for several instruction sets; each of those files has its own, hence the anonymous
// namespace.

namespace cullscope {
namespace {

// Eight pixels of a row. The compiler splits them where a register holds fewer.
using Floats = float __attribute__((vector_size(32)));
using Ints = int32_t __attribute__((vector_size(32)));
using Numbers = uint32_t __attribute__((vector_size(32)));
using Doubles = double __attribute__((vector_size(32)));
using HalfFloats = float __attribute__((vector_size(16)));
using HalfNumbers = uint32_t __attribute__((vector_size(16)));
using HalfInts = int32_t __attribute__((vector_size(16)));
// The same in memory, where they may begin at any pixel.
using FloatsInMemory = float __attribute__((vector_size(32), aligned(4), may_alias));
using HalfFloatsInMemory = float __attribute__((vector_size(16), aligned(4), may_alias));
using HalfNumbersInMemory = uint32_t __attribute__((vector_size(16), aligned(4), may_alias));
using NumbersInMemory = uint32_t __attribute__((vector_size(32), aligned(4), may_alias));

}  // namespace
}  // namespace cullscope
