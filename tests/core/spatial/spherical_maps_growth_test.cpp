// With automatic resolution, the bytes of the maps grow in proportion to the number of triangles.
#include <gtest/gtest.h>

#include <cmath>

#include "core/mesh/parametric.h"
#include "core/spatial/spherical_maps.h"

namespace cullscope::test::spherical_maps_growth_test {
namespace {

double bytesAFace(size_t triangles) {
    const MeshPointer mesh = sphereMesh(triangles);
    const SphericalMaps maps(mesh, SphericalGrid::forTriangles(mesh->triangleCount()));
    return double(maps.bytes().all()) / double(mesh->triangleCount());
}

TEST(SphericalMapsGrowth, bytesGrowInProportionToTheFaces) {
    const double few = bytesAFace(10'000), many = bytesAFace(1'000'000);
    EXPECT_LT(std::abs(many / few - 1.0), 0.15) << few << " and " << many << " bytes a face";
}

}  // namespace
}  // namespace cullscope::test::spherical_maps_growth_test
