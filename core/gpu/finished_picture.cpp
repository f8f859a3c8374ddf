#include <epoxy/gl.h>

#include <tbb/parallel_for.h>

#include "core/gpu/drawing.h"
#include "core/scene/eye_triangle.h"

namespace cullscope {
namespace {

/// The colours of a picture's pixels, as lambert.frag has them: a headlight at the eye, normals interpolated over the triangle.
class PictureShading {
public:
    PictureShading(const Scene& scene, const View& view, const DrawStyle& style) : m_view(view), m_style(style), m_scene(scene) {
        for (uint32_t i = 0; i < scene.instances().size(); ++i) {
            m_instances.emplace_back(scene, i, view.eye());
            m_normals.push_back(glm::transpose(glm::inverse(Mat3(scene.instances()[i].worldFromMesh))));
        }
    }

    /// RGB in [0, 1] of a scene triangle at a pixel.
    [[nodiscard]] Vec3f colour(uint32_t triangle, int x, int y) const {
        const auto instance = static_cast<uint32_t>(m_scene.instanceOf(triangle));
        const uint64_t own = triangle - m_scene.firstTriangle(instance);
        const auto [a, b, c] = m_instances[instance].corners(own);
        const Vec3 direction = m_view.direction(x + 0.5, y + 0.5);
        const Vec3 normal = glm::cross(b - a, c - a);
        const double along = glm::dot(normal, direction);
        const Vec3 point = along != 0.0 ? direction * (glm::dot(normal, a) / along) : a;
        const double squared = glm::dot(normal, normal);
        // Barycentric coordinates of the point.
        const double u = squared > 0.0 ? glm::dot(normal, glm::cross(c - b, point - b)) / squared : 1.0;
        const double v = squared > 0.0 ? glm::dot(normal, glm::cross(a - c, point - c)) / squared : 0.0;
        const TriangleMesh& mesh = m_scene.meshOf(instance);
        const auto normalAt = [&](size_t corner) { return Vec3(mesh.normals()[mesh.indices()[3 * own + corner]]); };
        const Vec3 shading = m_normals[instance] * (u * normalAt(0) + v * normalAt(1) + (1.0 - u - v) * normalAt(2));
        const double lengths = glm::length(point) * glm::length(shading);
        const double cosine = lengths > 0.0 ? std::abs(glm::dot(point, shading)) / lengths : 1.0;
        return m_style.surface * float(0.12 + 0.88 * cosine);
    }

private:
    const View& m_view;
    const DrawStyle& m_style;
    const Scene& m_scene;
    std::vector<InstanceFromEye> m_instances;
    std::vector<Mat3> m_normals;
};

uint8_t byteOf(float value) { return static_cast<uint8_t>(std::lround(std::clamp(value, 0.0f, 1.0f) * 255.0f)); }

}  // namespace

void writePicture(const Scene& scene, const View& view, const FinishedPicture& picture, const DrawStyle& style,
                  Framebuffer& target) {
    const PictureTile& tile = target.tile();
    const PictureShading shading(scene, view, style);
    const auto width = static_cast<size_t>(tile.size.width);
    std::vector<uint8_t> colour(width * static_cast<size_t>(tile.size.height) * 4);
    std::vector<float> depth(width * static_cast<size_t>(tile.size.height));
    tbb::parallel_for(0, tile.size.height, [&](int row) {
        for (int column = 0; column < tile.size.width; ++column) {
            const int x = tile.x + column, y = tile.y + row;
            const size_t from = size_t(y) * size_t(picture.size.width) + size_t(x);
            const size_t to = size_t(row) * width + size_t(column);
            const uint32_t item = picture.triangle[from];
            const Vec3f rgb = item == 0 ? style.background : shading.colour(item - 1, x, y);
            for (int channel = 0; channel < 3; ++channel) colour[4 * to + size_t(channel)] = byteOf(rgb[channel]);
            colour[4 * to + 3] = item == 0 ? byteOf(style.backgroundAlpha) : 255;
            depth[to] = item == 0 ? 0.0f : picture.depth[from];
        }
    });
    glTextureSubImage2D(target.colourTexture(), 0, 0, 0, tile.size.width, tile.size.height, GL_RGBA, GL_UNSIGNED_BYTE,
                        colour.data());
    glTextureSubImage2D(target.depthTexture(), 0, 0, 0, tile.size.width, tile.size.height, GL_DEPTH_COMPONENT, GL_FLOAT,
                        depth.data());
}

}  // namespace cullscope
