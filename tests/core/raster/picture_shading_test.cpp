// The shading of pictures made in software: the same bytes by every instruction set, and the colours of plain code.

#include "core/raster/picture_shading.h"

#include <cstring>

#include "core/mesh/parametric.h"
#include "core/scene/eye_triangle.h"
#include "tests/support/random_polygons.h"

namespace cullscope::test::picture_shading_test {
namespace {

/// The shading of a triangle for any direction from the eye: its corners' normals, weighted as at the point in that direction.
/// The weights are the products of the direction with b × c, c × a and a × b, up to a common factor, so that the normal is a
/// matrix times the direction.
struct ShadedTriangle {
    uint32_t item = 0;  ///< triangle number + 1
    Mat3 normal{0.0};   ///< times a direction: a shading normal of any length
};

/// The colours of a picture's pixels, one after the other: a headlight at the eye, normals interpolated over the triangle.
class PlainShading {
public:
    PlainShading(const Scene& scene, const View& view, const Vec3f& surface)
        : m_view(view),
          m_step(atOne(view, 1.0, 0.0) - atOne(view, 0.0, 0.0)),
          m_sightStep(view.direction(1.0, 0.0) - view.direction(0.0, 0.0)),
          m_surface(glm::max(surface, Vec3f(0.0f)) * 255.0f),
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
        auto corners = m_instances[instance].corners(own);
        // A parallel view looks the same when everything is moved along its direction: here to distance 1.
        if (m_view.frustum().parallel())
            for (Vec3& corner : corners) corner += (1.0 - glm::dot(corner, m_view.frustum().forward)) * m_view.frustum().forward;
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
        const Vec3 first = atOne(m_view, begin + 0.5, row + 0.5);
        const Vec3f direction(m_view.direction(begin + 0.5, row + 0.5)), step(m_sightStep), normal(triangle.normal * first),
            normalStep(triangle.normal * m_step);
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
    /// The place seen at a point of the picture at distance 1, relative to the eye.
    static Vec3 atOne(const View& view, double x, double y) { return view.sightOrigin(x, y) + view.direction(x, y); }

    const View& m_view;
    Vec3 m_step;       ///< from a pixel's place at distance 1 to that of the next one in its row
    Vec3 m_sightStep;  ///< the same of its direction
    Vec3f m_surface;
    const Scene& m_scene;
    std::vector<InstanceFromEye> m_instances;
    std::vector<Mat3> m_normals;
};

std::vector<uint8_t> plainly(const Scene& scene, const View& view, const FinishedPicture& picture, const PicturePart& part,
                             const PictureColours& colours) {
    const PlainShading shading(scene, view, colours.surface);
    std::vector<uint8_t> rgba(4 * size_t(part.size.width) * size_t(part.size.height));
    for (int row = 0; row < part.size.height; ++row) {
        const uint32_t* items = &picture.triangle[size_t(part.y + row) * size_t(picture.size.width) + size_t(part.x)];
        uint8_t* to = &rgba[4 * size_t(row) * size_t(part.size.width)];
        for (int begin = 0, end = 0; begin < part.size.width; begin = end) {
            for (end = begin + 1; end < part.size.width && items[end] == items[begin];) ++end;
            if (items[begin] != 0)
                shading.shade(shading.shaded(items[begin]), part.x + begin, part.x + end, part.y + row, to + 4 * begin);
            else
                for (int x = begin; x < end; ++x) std::ranges::copy(colours.background, to + 4 * x);
        }
    }
    return rgba;
}

void expectAsPlainly(const Scene& scene, const View& view, const PicturePart& part) {
    const RasterPicture drawn = drawDepthBuffer(trianglesOnRaster(scene, view, Facing::TwoSided));
    const PictureColours colours{{0.8f, 0.75f, 0.7f}, {1, 2, 3, 4}};
    const std::vector<uint8_t> expected = plainly(scene, view, *drawn.picture, part, colours);
    const auto first = shadedPicture(scene, view, *drawn.picture, part, colours, false, RasterSimd::Portable);
    const std::span bytes(reinterpret_cast<const uint8_t*>(first.get()), expected.size());
    // The kernels add up a row's directions from other pixels: a value may fall on the other side of a rounding.
    size_t differing = 0;
    int most = 0;
    for (size_t i = 0; i < bytes.size(); ++i) {
        differing += bytes[i] != expected[i] ? 1 : 0;
        most = std::max(most, std::abs(int(bytes[i]) - int(expected[i])));
    }
    EXPECT_LE(most, 1);
    EXPECT_LE(differing, bytes.size() / 2000);
    for (const RasterSimd simd : availableRasterSimd())
        for (const bool parallel : {false, true}) {
            const auto again = shadedPicture(scene, view, *drawn.picture, part, colours, parallel, simd);
            EXPECT_EQ(std::memcmp(first.get(), again.get(), bytes.size()), 0) << "instruction set " << int(simd);
        }
}

TEST(PictureShading, hasTheColoursOfPlainCodeByEveryInstructionSet) {
    for (uint64_t seed = 0; seed < howMany(100, 20); ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        const View view(aroundPolygons(seed), {157, 99});
        expectAsPlainly(*randomPolygons(seed), view, {0, 0, view.viewport()});
    }
}

TEST(PictureShading, isTheSameOfInstancesThatAreMirroredAndFlattenedAndInAPartOfThePicture) {
    const ScenePointer scene = sceneOf({starMesh(3, 3'000), torusMesh(2'000), meshOf({}, {}), sphereMesh(500)},
                                       {Mat4(1.0), scaling({-1.2, 1.2, 0.1}), Mat4(1.0), translation({1e-3, 0.7, 1})});
    const View view({{0.5, 1, 3}, Vec3(0.0), {0, 1, 0}, Angle::fromDegrees(50), 0.1, 100}, {203, 151});
    expectAsPlainly(*scene, view, {0, 0, view.viewport()});
    expectAsPlainly(*scene, view, {37, 11, {101, 97}});
}

TEST(PictureShading, followsThePlainCodeInParallelViews) {
    const ScenePointer scene = sceneOf({starMesh(3, 3'000), torusMesh(2'000), sphereMesh(500)},
                                       {Mat4(1.0), scaling({-1.2, 1.2, 0.1}), translation({1e-3, 0.7, 1})});
    const Camera camera = inParallel({{0.5, 1, 3}, Vec3(0.0), {0, 1, 0}, Angle::fromDegrees(50), 0.1, 100});
    const View view(camera, {203, 151});
    expectAsPlainly(*scene, view, {0, 0, view.viewport()});
    expectAsPlainly(*scene, view, {37, 11, {101, 97}});
}

}  // namespace
}  // namespace cullscope::test::picture_shading_test
