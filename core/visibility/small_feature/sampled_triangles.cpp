#include "core/visibility/small_feature/sampled_triangles.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <limits>

#include "core/visibility/eye_bounds.h"

namespace cullscope::small_feature {
namespace {

/// A vertex on the screen, in pixels.
struct ScreenPoint {
    float x = 0.0f, y = 0.0f;
};

/// An object with more pixels than these for each triangle has few triangles without a pixel centre.
constexpr uint64_t kMostPixelsOfTriangle = 4;

/// Triangles between two ranges that are drawn with them.
constexpr uint32_t kMostBetween = 2;

/// The mesh's vertices on the screen. NaN: what OpenGL may clip, at the near plane or beyond the picture's size on each side.
void project(const TriangleMesh& mesh, const Mat4f& clip, const View& view, std::vector<ScreenPoint>& points) {
    const auto width = float(view.viewport().width), height = float(view.viewport().height);
    // 2 w of the near plane: the distance ahead with room for its rounding. In a parallel view w is 1: a triangle that OpenGL
    // clips at the near plane lies within its corners on the screen there.
    const float least = view.frustum().parallel() ? 0.5f : float(view.camera().nearDistance) * 2.0f;
    constexpr float kNone = std::numeric_limits<float>::quiet_NaN();
    points.resize(mesh.vertexCount());
    for (size_t i = 0; i < points.size(); ++i) {
        const Vec3f& p = mesh.positions()[i];
        const float w = clip[0][3] * p.x + clip[1][3] * p.y + clip[2][3] * p.z + clip[3][3];
        const float toPixels = 0.5f / w;
        const float x = ((clip[0][0] * p.x + clip[1][0] * p.y + clip[2][0] * p.z + clip[3][0]) * toPixels + 0.5f) * width;
        const float y = ((clip[0][1] * p.x + clip[1][1] * p.y + clip[2][1] * p.z + clip[3][1]) * toPixels + 0.5f) * height;
        const bool near = w >= least && x >= -width && x <= 2.0f * width && y >= -height && y <= 2.0f * height;
        points[i] = near ? ScreenPoint{x, y} : ScreenPoint{kNone, kNone};
    }
}

/// Whether a pixel centre, at k + ½ for k from 0 to size − 1, lies in an interval. Its ends are within twice the picture's size.
bool holdsCentre(float least, float most, int size) {
    // Rounded up from a number that is above −2^15, and down.
    constexpr int kShift = 1 << 15;
    const int first = kShift - int(float(kShift) - (least - 0.5f));
    const int last = int(most - 0.5f + float(kShift)) - kShift;
    return std::max(first, 0) <= std::min(last, size - 1);
}

}  // namespace

SampledTriangles::SampledTriangles(const Scene& scene, const View& view, const PixelCover& cover)
    : m_scene(scene), m_view(view), m_cover(cover) {}

std::vector<uint64_t> SampledTriangles::appendAll(std::span<const KeptObject> objects, std::vector<DrawRange>& ranges) const {
    constexpr size_t kObjects = 64;
    std::vector<std::vector<DrawRange>> parts((objects.size() + kObjects - 1) / kObjects);
    std::vector<uint64_t> left(objects.size());
    tbb::parallel_for(size_t{0}, parts.size(), [&](size_t part) {
        for (size_t i = part * kObjects; i < std::min(objects.size(), (part + 1) * kObjects); ++i) {
            const uint32_t instance = objects[i].instance;
            const uint64_t count = m_scene.meshOf(instance).triangleCount();
            if (m_cover.of(relativeToEye(m_scene.instanceBox(instance), m_view.eye())) <= kMostPixelsOfTriangle * count)
                left[i] = append(instance, parts[part]);
            else
                parts[part].push_back({instance, 0, uint32_t(3 * count)});
        }
    });
    for (const std::vector<DrawRange>& part : parts) ranges.insert(ranges.end(), part.begin(), part.end());
    return left;
}

uint64_t SampledTriangles::append(uint32_t instance, std::vector<DrawRange>& ranges) const {
    const TriangleMesh& mesh = m_scene.meshOf(instance);
    thread_local std::vector<ScreenPoint> points;
    project(mesh, m_view.clipFromPositions(m_scene.instances()[instance].worldFromMesh, mesh.origin()), m_view, points);
    const auto count = uint32_t(mesh.triangleCount());
    // Of the picture's rounding and of that here, in pixels.
    const float room = 2.0f * float(m_cover.roomFor(relativeToEye(m_scene.instanceBox(instance), m_view.eye()))) + 0x1p-6f;
    uint64_t drawn = 0;
    uint32_t begin = 0, end = 0;  // of the range in hand
    const auto close = [&] {
        if (end == begin) return;
        ranges.push_back({instance, 3 * begin, 3 * (end - begin)});
        drawn += end - begin;
    };
    for (uint32_t i = 0; i < count; ++i) {
        const ScreenPoint &a = points[mesh.indices()[3 * i]], &b = points[mesh.indices()[3 * i + 1]],
                          &c = points[mesh.indices()[3 * i + 2]];
        const float sum = a.x + b.x + c.x;
        const bool known = sum == sum;
        if (known && !(holdsCentre(std::min({a.x, b.x, c.x}) - room, std::max({a.x, b.x, c.x}) + room, m_view.viewport().width) &&
                       holdsCentre(std::min({a.y, b.y, c.y}) - room, std::max({a.y, b.y, c.y}) + room, m_view.viewport().height)))
            continue;
        if (end == begin || i > end + kMostBetween) {
            close();
            begin = i;
        }
        end = i + 1;
    }
    close();
    return count - drawn;
}

}  // namespace cullscope::small_feature
