#include <epoxy/gl.h>

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <array>
#include <cmath>
#include <memory>

#include "core/gpu/drawing.h"
#include "core/scene/eye_triangle.h"

namespace cullscope {
namespace {

/// The shading of a triangle for any direction from the eye: its corners' normals, weighted as at the point in that direction.
/// The weights are the products of the direction with b × c, c × a and a × b, up to a common factor, so that the normal is a
/// matrix times the direction.
struct ShadedTriangle {
    uint32_t item = 0;  ///< triangle number + 1
    Mat3 normal{0.0};   ///< times a direction: a shading normal of any length
};

/// The colours of a picture's pixels, as lambert.frag has them: a headlight at the eye, normals interpolated over the triangle.
class PictureShading {
public:
    PictureShading(const Scene& scene, const View& view, const DrawStyle& style)
        : m_view(view),
          m_step(view.direction(1.0, 0.0) - view.direction(0.0, 0.0)),
          m_surface(glm::max(style.surface, Vec3f(0.0f)) * 255.0f),
          m_scene(scene) {
        for (uint32_t i = 0; i < scene.instances().size(); ++i) {
            m_instances.emplace_back(scene, i, view.eye());
            m_normals.push_back(glm::transpose(glm::inverse(Mat3(scene.instances()[i].worldFromMesh))));
        }
    }

    [[nodiscard]] ShadedTriangle shaded(uint32_t item) const {
        const uint32_t triangle = item - 1;
        const size_t instance = m_instances.size() == 1 ? 0 : m_scene.instanceOf(triangle);
        const uint64_t own = triangle - m_scene.firstTriangle(instance);
        const auto corners = m_instances[instance].corners(own);
        const TriangleMesh& mesh = m_scene.meshOf(instance);
        ShadedTriangle result{item};
        double largest = 0.0;
        for (size_t i = 0; i < 3; ++i) {
            const Vec3 weight = glm::cross(corners[(i + 1) % 3], corners[(i + 2) % 3]);
            const Vec3 normal = m_normals[instance] * Vec3(mesh.normals()[mesh.indices()[3 * own + i]]);
            result.normal += glm::outerProduct(normal, weight);
        }
        for (int column = 0; column < 3; ++column)
            for (int row = 0; row < 3; ++row) largest = std::max(largest, std::abs(result.normal[column][row]));
        // Its length does not matter; scaled, its square stays within the range of numbers.
        if (largest > 0.0 && std::isfinite(largest)) result.normal /= largest;
        return result;
    }

    /// Shades pixels [begin, end) of a row, which show one triangle: RGBA.
    void shade(const ShadedTriangle& triangle, int begin, int end, int row, uint8_t* rgba) const {
        const Vec3 first = m_view.direction(begin + 0.5, row + 0.5);
        const Vec3f direction(first), step(m_step), normal(triangle.normal * first), normalStep(triangle.normal * m_step);
        for (int x = 0; x < end - begin; ++x, rgba += 4) {
            const Vec3f d = direction + float(x) * step, n = normal + float(x) * normalStep;
            const float squares = glm::dot(d, d) * glm::dot(n, n);
            const float cosine = squares > 0.0f ? std::abs(glm::dot(d, n)) / std::sqrt(squares) : 1.0f;
            const float shade = std::min(0.12f + 0.88f * cosine, 1.0f);
            for (int channel = 0; channel < 3; ++channel)
                rgba[channel] = uint8_t(std::min(m_surface[channel] * shade, 255.0f) + 0.5f);
            rgba[3] = 255;
        }
    }

private:
    const View& m_view;
    Vec3 m_step;  ///< from a pixel's direction to that of the next one in its row
    Vec3f m_surface;
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
    const size_t pixels = width * static_cast<size_t>(tile.size.height);
    const std::array<uint8_t, 4> background{byteOf(style.background.x), byteOf(style.background.y), byteOf(style.background.z),
                                            byteOf(style.backgroundAlpha)};
    const bool whole = tile.x == 0 && tile.y == 0 && tile.size == picture.size;
    const std::unique_ptr<uint8_t[]> colour(new uint8_t[pixels * 4]);
    const std::unique_ptr<float[]> depth(whole ? nullptr : new float[pixels]);
    const auto writeRows = [&](const tbb::blocked_range<int>& rows) {
        // A triangle is met again in the next rows.
        constexpr size_t kKept = 1024;
        std::vector<ShadedTriangle> kept(kKept);
        for (int row = rows.begin(); row < rows.end(); ++row) {
            const size_t from = size_t(tile.y + row) * size_t(picture.size.width) + size_t(tile.x);
            const uint32_t* items = &picture.triangle[from];
            uint8_t* rgba = &colour[4 * size_t(row) * width];
            for (size_t begin = 0, end = 0; begin < width; begin = end) {
                const uint32_t item = items[begin];
                for (end = begin + 1; end < width && items[end] == item;) ++end;
                if (item == 0) {
                    for (size_t x = begin; x < end; ++x) std::ranges::copy(background, rgba + 4 * x);
                    continue;
                }
                ShadedTriangle& triangle = kept[item % kKept];
                if (triangle.item != item) triangle = shading.shaded(item);
                shading.shade(triangle, tile.x + int(begin), tile.x + int(end), tile.y + row, rgba + 4 * begin);
            }
            if (!whole) std::copy_n(&picture.depth[from], width, &depth[size_t(row) * width]);
        }
    };
    constexpr int kRowsTogether = 32;
    tbb::parallel_for(tbb::blocked_range<int>(0, tile.size.height, kRowsTogether), writeRows, tbb::simple_partitioner());
    glTextureSubImage2D(target.colourTexture(), 0, 0, 0, tile.size.width, tile.size.height, GL_RGBA, GL_UNSIGNED_BYTE,
                        colour.get());
    glTextureSubImage2D(target.depthTexture(), 0, 0, 0, tile.size.width, tile.size.height, GL_DEPTH_COMPONENT, GL_FLOAT,
                        whole ? picture.depth.data() : depth.get());
}

}  // namespace cullscope
