#include "core/raster/picture_shading.h"

#include <algorithm>
#include <bit>
#include <vector>

#include "core/raster/in_parallel.h"
#include "core/raster/kernel_choice.h"
#include "core/raster/shaded_rows.h"

namespace cullscope {
namespace {

void copyTo(double* values, const Mat3& matrix) {
    for (int column = 0; column < 3; ++column)
        for (int row = 0; row < 3; ++row) *values++ = matrix[column][row];
}
void copyTo(double* values, const Vec3& vector) {
    for (int axis = 0; axis < 3; ++axis) values[axis] = vector[axis];
}

std::vector<ShadedInstance> shadedInstances(const Scene& scene, const View& view) {
    std::vector<ShadedInstance> instances(scene.instances().size());
    for (size_t i = 0; i < instances.size(); ++i) {
        const Mat4& place = scene.instances()[i].worldFromMesh;
        const TriangleMesh& mesh = scene.meshOf(i);
        const Mat3 linear(place), fromWorld = glm::inverse(linear);
        ShadedInstance& to = instances[i];
        // Translations are summed before any rounding.
        copyTo(to.eye, fromWorld * (view.eye() - Vec3(place[3]) - linear * mesh.origin()));
        copyTo(to.fromWorld, fromWorld);
        copyTo(to.forward, fromWorld * view.frustum().forward);
        copyTo(to.ahead, glm::transpose(linear) * view.frustum().forward);
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
    const std::vector<ShadedInstance> instances = shadedInstances(scene, view);
    Shading shading{};
    shading.instances = instances.data();
    shading.instanceCount = instances.size();
    const Frustum& frustum = view.frustum();
    copyTo(shading.forward, frustum.forward);
    copyTo(shading.right, frustum.right);
    copyTo(shading.up, frustum.up);
    shading.halfWidth = frustum.halfWidthAt(1.0);
    shading.halfHeight = frustum.halfHeightAt(1.0);
    shading.parallel = frustum.parallel();
    shading.width = view.viewport().width;
    shading.height = view.viewport().height;
    const auto atOne = [&view](double x) { return view.sightOrigin(x, 0.0) + view.direction(x, 0.0); };
    copyTo(shading.step, atOne(1.0) - atOne(0.0));
    const Vec3f surface = glm::max(colours.surface, Vec3f(0.0f)) * 255.0f;
    for (int channel = 0; channel < 3; ++channel) shading.surface[channel] = surface[channel];
    shading.background = std::bit_cast<uint32_t>(colours.background);

    const auto width = size_t(part.size.width);
    std::unique_ptr<uint32_t[]> rgba(new uint32_t[width * size_t(part.size.height)]);
    ShadingKernel* const kernel = kernelFor<ShadingKernel>(simd, CULLSCOPE_VARIANTS(shade));
    const int upward = (part.size.height + kShadedRows - 1) / kShadedRows;
    forEachOf(size_t(upward), parallel, [&](size_t ofRows) {
        const int row = int(ofRows) * kShadedRows;
        // Blocks begin at the same columns of the picture, whatever part of it is shaded.
        for (int column = 0, next = 0; column < part.size.width; column = next) {
            next = std::min(part.size.width, (part.x + column) / kShadedColumns * kShadedColumns + kShadedColumns - part.x);
            const size_t from = size_t(part.y + row) * size_t(picture.size.width) + size_t(part.x + column);
            kernel(shading,
                   {part.x + column, part.y + row, next - column, std::min(kShadedRows, part.size.height - row),
                    &picture.triangle[from], size_t(picture.size.width), &rgba[size_t(row) * width + size_t(column)], width});
        }
    });
    return rgba;
}

}  // namespace cullscope
