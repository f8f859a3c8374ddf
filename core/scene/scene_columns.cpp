#include "core/scene/scene_columns.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/scene/eye_triangle.h"

namespace cullscope {
namespace {

/// Where in its cell a column stands: not in the middle, where regular scenes have their edges.
constexpr double kPlaceAcross = 0.4897, kPlaceAlong = 0.5113;

}  // namespace

Box3 denseBox(const Scene& scene) {
    constexpr uint64_t kFew = 200, kMostLookedAt = 100'000;
    constexpr double kLeftOut = 0.03;  // at each end
    if (scene.triangleCount() < kFew) return scene.bounds();
    const uint64_t step = scene.triangleCount() / kMostLookedAt + 1;
    std::array<std::vector<double>, 3> middles;
    for (size_t i = 0; i < scene.instances().size(); ++i) {
        const InstanceFromEye instance(scene, i, Vec3(0.0));
        const uint64_t first = scene.firstTriangle(i);
        // By scene number, so that small objects are not all looked at in full.
        for (uint64_t number = (first + step - 1) / step * step; number < first + scene.meshOf(i).triangleCount();
             number += step) {
            const auto [a, b, c] = instance.corners(number - first);
            for (int axis = 0; axis < 3; ++axis) middles[size_t(axis)].push_back((a[axis] + b[axis] + c[axis]) / 3.0);
        }
    }
    Box3 box;
    for (int axis = 0; axis < 3; ++axis) {
        std::vector<double>& along = middles[size_t(axis)];
        std::ranges::sort(along);
        const auto last = double(along.size() - 1);
        box.min[axis] = along[size_t(kLeftOut * last)];
        box.max[axis] = along[size_t((1.0 - kLeftOut) * last)];
    }
    return box;
}

SceneColumns::SceneColumns(const Scene& scene, const Box3& part, uint32_t side)
    : m_up(scene.upAxis() == UpAxis::Z ? 2 : 1), m_first(0), m_second(m_up == 2 ? 1 : 2) {
    if (part.empty()) return;
    const Vec3 extent = part.max - part.min;
    m_step = std::max(extent[m_first], extent[m_second]) / side;
    if (!(m_step > 0.0)) return;
    m_across = std::max(1u, uint32_t(std::ceil(extent[m_first] / m_step - 1e-9)));
    m_along = std::max(1u, uint32_t(std::ceil(extent[m_second] / m_step - 1e-9)));
    m_corner[m_first] = part.min[m_first] + kPlaceAcross * extent[m_first] / m_across;
    m_corner[m_second] = part.min[m_second] + kPlaceAlong * extent[m_second] / m_along;
    m_crossings.resize(size_t(m_across) * m_along);
    for (uint32_t i = 0; i < scene.instances().size(); ++i) {
        const InstanceFromEye instance(scene, i, m_corner);
        const bool mirrored = glm::determinant(Mat3(scene.instances()[i].worldFromMesh)) < 0.0;
        for (uint64_t triangle = 0; triangle < scene.meshOf(i).triangleCount(); ++triangle)
            add(instance.corners(triangle), mirrored);
    }
    for (std::vector<Crossing>& column : m_crossings)
        std::ranges::sort(column, [](const Crossing& a, const Crossing& b) {
            return a.height != b.height ? a.height < b.height : a.floor < b.floor;
        });
}

Vec3 SceneColumns::at(size_t column, double height) const {
    Vec3 point = m_corner;
    point[m_first] += m_step * double(column % m_across);
    point[m_second] += m_step * double(column / m_across);
    point[m_up] = height;
    return point;
}

/// Corners relative to the first column.
void SceneColumns::add(const std::array<Vec3, 3>& corners, bool mirrored) {
    constexpr double kLevel = 0.5;  // cosine of the steepest floor
    std::array<Vec2, 3> flat;
    for (size_t i = 0; i < 3; ++i) flat[i] = Vec2(corners[i][m_first], corners[i][m_second]) / m_step;
    const auto [left, right] = std::minmax({flat[0].x, flat[1].x, flat[2].x});
    const auto [low, high] = std::minmax({flat[0].y, flat[1].y, flat[2].y});
    const auto from = [](double least) { return uint32_t(std::max(0.0, std::ceil(least))); };
    const auto to = [](double most, uint32_t count) {
        return most < 0.0 ? 0u : uint32_t(std::min(double(count), std::floor(most) + 1.0));
    };
    const uint32_t firstX = from(left), endX = to(right, m_across), firstY = from(low), endY = to(high, m_along);
    if (firstX >= endX || firstY >= endY) return;
    const auto turn = [](const Vec2& a, const Vec2& b, const Vec2& p) {
        return (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x);
    };
    const double area = turn(flat[0], flat[1], flat[2]);
    if (area == 0.0) return;
    const Vec3 normal = glm::cross(corners[1] - corners[0], corners[2] - corners[0]);
    const bool floor = (mirrored ? -normal[m_up] : normal[m_up]) >= kLevel * glm::length(normal);
    for (uint32_t y = firstY; y < endY; ++y)
        for (uint32_t x = firstX; x < endX; ++x) {
            const Vec2 place(x, y);
            const double a = turn(flat[1], flat[2], place) / area, b = turn(flat[2], flat[0], place) / area;
            if (a < 0.0 || b < 0.0 || a + b > 1.0) continue;
            const double height = a * corners[0][m_up] + b * corners[1][m_up] + (1.0 - a - b) * corners[2][m_up];
            m_crossings[size_t(y) * m_across + x].push_back({m_corner[m_up] + height, floor});
        }
}

}  // namespace cullscope
