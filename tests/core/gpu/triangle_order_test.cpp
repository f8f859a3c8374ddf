// Draw lists in a strategy's own order of the triangles.
#include <gmock/gmock.h>

#include <algorithm>
#include <numeric>

#include "core/mesh/parametric.h"
#include "tests/support/gl_environment.h"
#include "tests/support/test_scenes.h"

namespace cullscope::test::triangle_order_test {
namespace {

/// Every mesh's triangles in reverse order.
TriangleOrderPointer backward(const Scene& scene) {
    struct Arrays {
        std::vector<std::vector<uint32_t>> indices, triangles;
    };
    auto arrays = std::make_shared<Arrays>();
    auto order = std::make_shared<TriangleOrder>();
    for (const MeshPointer& mesh : scene.meshes()) {
        std::vector<uint32_t>& triangles = arrays->triangles.emplace_back(mesh->triangleCount());
        std::iota(triangles.rbegin(), triangles.rend(), 0u);
        std::vector<uint32_t>& indices = arrays->indices.emplace_back();
        for (const uint32_t triangle : triangles)
            for (size_t i = 0; i < 3; ++i) indices.push_back(mesh->indices()[3 * size_t(triangle) + i]);
    }
    for (size_t i = 0; i < arrays->indices.size(); ++i) order->meshes.push_back({arrays->indices[i], arrays->triangles[i]});
    order->owner = arrays;
    return order;
}

ScenePointer twoObjects() { return sceneOf({knotMesh(3000), teapotMesh(2000)}, {Mat4(1.0), translation({1, 0, -1})}); }

const View kView({{2, 3, 5}, Vec3(0.0), {0, 1, 0}, Angle::fromDegrees(45), 0.05, 100}, {160, 120});

/// The first `share` of each object's triangles, in their own order or from the end of the reverse order: the same triangles.
DrawList partOf(const Scene& scene, double share, const TriangleOrderPointer& order) {
    DrawList list = everything(scene, Facing::TwoSided);
    for (DrawRange& range : list.ranges) {
        const uint32_t all = range.indexCount;
        range.indexCount = 3 * uint32_t(all / 3 * share);
        if (order) range.firstIndex = all - range.indexCount;
    }
    list.order = order;
    return list;
}

TEST(TriangleOrder, pictureDoesNotDependOnIt) {
    const ScenePointer scene = twoObjects();
    for (const Upload upload : {Upload::Vbo, Upload::VertexArray}) {
        const SceneBuffers buffers(scene, upload);
        for (const double share : {1.0, 0.37}) {
            const Picture own = picture(buffers, kView, partOf(*scene, share, nullptr));
            EXPECT_EQ(picture(buffers, kView, partOf(*scene, share, backward(*scene))), own) << share;
        }
    }
}

TEST(TriangleOrder, itemBufferNamesTrianglesAndNotPlaces) {
    const ScenePointer scene = twoObjects();
    const SceneBuffers buffers(scene, Upload::Vbo);
    for (const double share : {1.0, 0.37}) {
        const DrawList own = partOf(*scene, share, nullptr), turned = partOf(*scene, share, backward(*scene));
        EXPECT_EQ(GlEnvironment::renderer().drawItemBuffer(buffers, kView, turned).triangle,
                  GlEnvironment::renderer().drawItemBuffer(buffers, kView, own).triangle);
        const auto seen = GlEnvironment::renderer().pick(buffers, kView, own, 80, 60);
        const auto seenTurned = GlEnvironment::renderer().pick(buffers, kView, turned, 80, 60);
        ASSERT_EQ(seen.has_value(), seenTurned.has_value());
        if (seen) {
            EXPECT_EQ(seen->triangle, seenTurned->triangle);
        }
    }
}

TEST(TriangleOrder, itsBuffersGoWithIt) {
    const ScenePointer scene = twoObjects();
    const SceneBuffers buffers(scene, Upload::Vbo);
    TriangleOrderPointer order = backward(*scene);
    const unsigned first = buffers.ordered(order, 0).buffer;
    ASSERT_TRUE(glIsBuffer(first));
    EXPECT_EQ(buffers.ordered(order, 0).buffer, first);
    order = backward(*scene);
    const unsigned next = buffers.ordered(order, 0).buffer;
    EXPECT_TRUE(glIsBuffer(next));
    // OpenGL may reuse the name; at most one order's buffers are left.
    EXPECT_TRUE(next == first || !glIsBuffer(first));
}

TEST(TriangleOrder, meshWithoutOneIsDrawnInItsOwn) {
    const ScenePointer scene = twoObjects();
    const SceneBuffers buffers(scene, Upload::Vbo);
    auto order = std::make_shared<TriangleOrder>(*backward(*scene));
    order->meshes[1] = {};
    DrawList list = everything(*scene, Facing::TwoSided);
    list.order = order;
    EXPECT_EQ(picture(buffers, kView, list), picture(buffers, kView, everything(*scene, Facing::TwoSided)));
    EXPECT_EQ(list.triangleAt(1, 5), 5u);
    EXPECT_EQ(list.triangleAt(0, 5), scene->meshOf(0).triangleCount() - 6);
}

}  // namespace
}  // namespace cullscope::test::triangle_order_test
