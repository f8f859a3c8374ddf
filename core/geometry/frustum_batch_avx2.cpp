#include <immintrin.h>

#include "core/geometry/frustum_batch_kernel.h"

namespace cullscope {
namespace {

struct Avx2Lanes {
    using Vector = __m256d;
    using Mask = __m256d;
    static constexpr size_t kWidth = 4;
    static constexpr size_t kVectors = 4;
    static constexpr size_t kPlanesBetweenLooks = 2;

    static Vector load(const double* from) { return _mm256_loadu_pd(from); }
    static void store(double* to, Vector a) { _mm256_storeu_pd(to, a); }
    static Vector spread(double value) { return _mm256_set1_pd(value); }
    static Vector abs(Vector a) { return _mm256_andnot_pd(_mm256_set1_pd(-0.0), a); }
    static Vector min(Vector a, Vector b) { return _mm256_min_pd(a, b); }
    static Vector max(Vector a, Vector b) { return _mm256_max_pd(a, b); }
    static Mask less(Vector a, Vector b) { return _mm256_cmp_pd(a, b, _CMP_LT_OQ); }
    static uint64_t bits(Mask mask) { return static_cast<uint64_t>(_mm256_movemask_pd(mask)); }
};

}  // namespace

void testBoxesAvx2(const double* blocks, size_t blockCount, const BatchPlanes& frustum, uint64_t* outside,
                   const BatchListener* listener) {
    test<Avx2Lanes, Boxes<Avx2Lanes>>(blocks, blockCount, frustum, outside, listener);
}

void testSpheresAvx2(const double* blocks, size_t blockCount, const BatchPlanes& frustum, uint64_t* outside,
                     const BatchListener* listener) {
    test<Avx2Lanes, Spheres<Avx2Lanes>>(blocks, blockCount, frustum, outside, listener);
}

}  // namespace cullscope
