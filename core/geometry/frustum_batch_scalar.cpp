#include "core/geometry/frustum_batch_kernel.h"

namespace cullscope {
namespace {

struct ScalarLanes {
    using Vector = double;
    using Mask = bool;
    static constexpr size_t kWidth = 1;
    static constexpr size_t kVectors = 1;
    static constexpr size_t kPlanesBetweenLooks = 1;

    static Vector load(const double* from) { return *from; }
    static void store(double* to, Vector a) { *to = a; }
    static Vector spread(double value) { return value; }
    static Vector abs(Vector a) { return __builtin_fabs(a); }
    // As the vector instructions do: the second operand where one is NaN.
    static Vector min(Vector a, Vector b) { return a < b ? a : b; }
    static Vector max(Vector a, Vector b) { return a > b ? a : b; }
    static Mask less(Vector a, Vector b) { return a < b; }
    static uint64_t bits(Mask mask) { return mask ? 1 : 0; }
};

template <typename Shape>
BatchDistances distances(const double* block, const BatchPlanes& frustum, size_t plane) {
    return {Shape::withReach(Shape::distance(block, frustum.planes[plane]), block), Shape::outer(block, frustum.planes[plane]),
            marginOf<ScalarLanes, Shape>(block, frustum)};
}

}  // namespace

void testBoxesScalar(const double* blocks, size_t blockCount, const BatchPlanes& frustum, uint64_t* outside,
                     const BatchListener* listener) {
    test<ScalarLanes, Boxes<ScalarLanes>>(blocks, blockCount, frustum, outside, listener);
}

void testSpheresScalar(const double* blocks, size_t blockCount, const BatchPlanes& frustum, uint64_t* outside,
                       const BatchListener* listener) {
    test<ScalarLanes, Spheres<ScalarLanes>>(blocks, blockCount, frustum, outside, listener);
}

BatchDistances boxDistances(const double* block, const BatchPlanes& frustum, size_t plane) {
    return distances<Boxes<ScalarLanes>>(block, frustum, plane);
}

BatchDistances sphereDistances(const double* block, const BatchPlanes& frustum, size_t plane) {
    return distances<Spheres<ScalarLanes>>(block, frustum, plane);
}

}  // namespace cullscope
