#include <immintrin.h>

#include "core/geometry/frustum_batch_kernel.h"

namespace cullscope {
namespace {

struct Avx512Lanes {
    using Vector = __m512d;
    using Mask = __mmask8;
    static constexpr size_t kWidth = 8;
    static constexpr size_t kVectors = 4;
    static constexpr size_t kPlanesBetweenLooks = 2;

    static Vector load(const double* from) { return _mm512_loadu_pd(from); }
    static void store(double* to, Vector a) { _mm512_storeu_pd(to, a); }
    static Vector spread(double value) { return _mm512_set1_pd(value); }
    static Vector abs(Vector a) { return _mm512_abs_pd(a); }
    // With a mask of all lanes: GCC 12 warns of the undefined vector inside the intrinsics without a mask.
    static Vector min(Vector a, Vector b) { return _mm512_mask_min_pd(a, 0xFF, a, b); }
    static Vector max(Vector a, Vector b) { return _mm512_mask_max_pd(a, 0xFF, a, b); }
    static Mask less(Vector a, Vector b) { return _mm512_cmp_pd_mask(a, b, _CMP_LT_OQ); }
    static uint64_t bits(Mask mask) { return mask; }
};

}  // namespace

void testBoxesAvx512(const double* blocks, size_t blockCount, const BatchPlanes& frustum, uint64_t* outside,
                     const BatchListener* listener) {
    test<Avx512Lanes, Boxes<Avx512Lanes>>(blocks, blockCount, frustum, outside, listener);
}

void testSpheresAvx512(const double* blocks, size_t blockCount, const BatchPlanes& frustum, uint64_t* outside,
                       const BatchListener* listener) {
    test<Avx512Lanes, Spheres<Avx512Lanes>>(blocks, blockCount, frustum, outside, listener);
}

}  // namespace cullscope
