#include "core/raster/picture_shading.h"

#include <algorithm>
#include <bit>
#include <vector>

#include "core/raster/in_parallel.h"
#include "core/raster/shaded_rows.h"

namespace cullscope {
namespace {

ShadingKernel* shadingKernelOf(RasterSimd simd) {
#ifdef CULLSCOPE_RASTER_AVX
    if (simd == RasterSimd::Avx512) return shadeRowAvx512;
    if (simd == RasterSimd::Avx2) return shadeRowAvx2;
#endif
    return simd == RasterSimd::Portable ? shadeRowPortable : nullptr;
}

void copyTo(double* values, const Mat3& matrix) {
    for (int column = 0; column < 3; ++column)
        for (int row = 0; row < 3; ++row) *values++ = matrix[column][row];
}
void copyTo(double* values, const Vec3& vector) {
    for (int axis = 0; axis < 3; ++axis) values[axis] = vector[axis];
}

std::vector<ShadedInstance> shadedInstances(const Scene& scene, const View& view, const Vec3& step) {
    std::vector<ShadedInstance> instances(scene.instances().size());
    const Frustum& frustum = view.frustum();
    for (size_t i = 0; i < instances.size(); ++i) {
        const Mat4& place = scene.instances()[i].worldFromMesh;
        const TriangleMesh& mesh = scene.meshOf(i);
        const Mat3 linear(place), fromWorld = glm::inverse(linear);
        ShadedInstance& to = instances[i];
        // Translations are summed before any rounding.
        copyTo(to.eye, fromWorld * (view.eye() - Vec3(place[3]) - linear * mesh.origin()));
        copyTo(to.forward, fromWorld * frustum.forward);
        copyTo(to.right, fromWorld * frustum.right);
        copyTo(to.up, fromWorld * frustum.up);
        copyTo(to.step, fromWorld * step);
        copyTo(to.normals, glm::transpose(fromWorld));
        to.positions = mesh.positions().empty() ? nullptr : &mesh.positions().front().x;
        to.normal = mesh.normals().empty() ? nullptr : &mesh.normals().front().x;
        to.indices = mesh.indices().data();
        to.firstTriangle = uint32_t(scene.firstTriangle(i));
    }
    return instances;
}

}  // namespace

std::unique_ptr<uint32_t[]> shadedPicture(const Scene& scene, const View& view, const FinishedPicture& picture,
                                          const PicturePart& part, const PictureColours& colours, bool parallel,
                                          RasterSimd simd) {
    const Vec3 step = view.direction(1.0, 0.0) - view.direction(0.0, 0.0);
    const std::vector<ShadedInstance> instances = shadedInstances(scene, view, step);
    Shading shading{};
    shading.instances = instances.data();
    shading.instanceCount = instances.size();
    const Frustum& frustum = view.frustum();
    copyTo(shading.forward, frustum.forward);
    copyTo(shading.right, frustum.right);
    copyTo(shading.up, frustum.up);
    shading.tanHalfWidth = frustum.tanHalfWidth;
    shading.tanHalfHeight = frustum.tanHalfHeight;
    shading.width = view.viewport().width;
    shading.height = view.viewport().height;
    copyTo(shading.step, step);
    const Vec3f surface = glm::max(colours.surface, Vec3f(0.0f)) * 255.0f;
    for (int channel = 0; channel < 3; ++channel) shading.surface[channel] = surface[channel];
    shading.background = std::bit_cast<uint32_t>(colours.background);

    const auto width = size_t(part.size.width);
    std::unique_ptr<uint32_t[]> rgba(new uint32_t[width * size_t(part.size.height)]);
    ShadingKernel* const kernel = shadingKernelOf(simd);
    constexpr int kRowsTogether = 16;
    forEachOf(size_t((part.size.height + kRowsTogether - 1) / kRowsTogether), parallel, [&](size_t together) {
        const int first = int(together) * kRowsTogether;
        for (int row = first; row < std::min(first + kRowsTogether, part.size.height); ++row) {
            const size_t from = size_t(part.y + row) * size_t(picture.size.width) + size_t(part.x);
            kernel(shading, &picture.triangle[from], part.size.width, part.x, part.y + row, &rgba[size_t(row) * width]);
        }
    });
    return rgba;
}

}  // namespace cullscope
