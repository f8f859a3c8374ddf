#include "core/raster/canvas.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/raster/rows.h"

namespace cullscope {
namespace {

uint8_t byteOf(double share) { return uint8_t(std::lround(std::clamp(share, 0.0, 1.0) * 255.0)); }

double distanceToSegment(const Vec2& point, const Vec2& from, const Vec2& to) {
    const Vec2 along = to - from;
    const double squared = glm::dot(along, along);
    const double share = squared > 0.0 ? std::clamp(glm::dot(point - from, along) / squared, 0.0, 1.0) : 0.0;
    return glm::length(point - from - share * along);
}

}  // namespace

Canvas::Canvas(const Viewport& size, const Vec3f& background, float alpha)
    : m_size(size),
      m_rgba(size_t(size.width) * size_t(size.height) * 4),
      m_clip{0.0, 0.0, double(size.width), double(size.height)} {
    for (size_t i = 0; i < m_rgba.size(); i += 4) {
        for (int c = 0; c < 3; ++c) m_rgba[i + size_t(c)] = byteOf(background[c]);
        m_rgba[i + 3] = byteOf(alpha);
    }
}

void Canvas::blend(int x, int y, const Vec3f& colour, double coverage) {
    if (x < 0 || y < 0 || x >= m_size.width || y >= m_size.height || coverage <= 0.0) return;
    if (x + 0.5 < m_clip.left || x + 0.5 > m_clip.right || y + 0.5 < m_clip.top || y + 0.5 > m_clip.bottom) return;
    uint8_t* pixel = &m_rgba[4 * (size_t(y) * size_t(m_size.width) + size_t(x))];
    const double below = pixel[3] / 255.0 * (1.0 - coverage), alpha = coverage + below;
    for (int c = 0; c < 3; ++c) pixel[c] = byteOf((double(colour[c]) * coverage + pixel[c] / 255.0 * below) / alpha);
    pixel[3] = byteOf(alpha);
}

void Canvas::fill(const Rectangle& rectangle, const Vec3f& colour, double opacity) {
    const int right = std::min(m_size.width, int(std::ceil(rectangle.right - 0.5)));
    const int bottom = std::min(m_size.height, int(std::ceil(rectangle.bottom - 0.5)));
    for (int y = std::max(0, int(std::ceil(rectangle.top - 0.5))); y < bottom; ++y)
        for (int x = std::max(0, int(std::ceil(rectangle.left - 0.5))); x < right; ++x) blend(x, y, colour, opacity);
}

void Canvas::fill(std::span<const Vec2> polygon, const Vec3f& colour, double opacity) {
    for (int y = 0; y < m_size.height; ++y) {
        const double middle = y + 0.5;
        std::vector<double> crossings;
        for (size_t i = 0; i < polygon.size(); ++i) {
            const Vec2 &from = polygon[i], &to = polygon[(i + 1) % polygon.size()];
            if ((from.y <= middle) != (to.y <= middle))
                crossings.push_back(from.x + (middle - from.y) / (to.y - from.y) * (to.x - from.x));
        }
        std::ranges::sort(crossings);
        for (size_t i = 0; i + 1 < crossings.size(); i += 2)
            fill(Rectangle{crossings[i], double(y), crossings[i + 1], y + 1.0}, colour, opacity);
    }
}

template <typename Distance>
void Canvas::cover(const Vec2& low, const Vec2& high, const Vec3f& colour, const Distance& distance) {
    const int left = std::max(0, int(std::floor(low.x - 1.0))), right = std::min(m_size.width - 1, int(std::ceil(high.x + 1.0)));
    const int top = std::max(0, int(std::floor(low.y - 1.0))), bottom = std::min(m_size.height - 1, int(std::ceil(high.y + 1.0)));
    for (int y = top; y <= bottom; ++y)
        for (int x = left; x <= right; ++x) blend(x, y, colour, std::clamp(0.5 - distance(Vec2(x + 0.5, y + 0.5)), 0.0, 1.0));
}

void Canvas::stroke(const Vec2& from, const Vec2& to, const Pen& pen) {
    const Vec2 reach(0.5 * pen.width);
    cover(glm::min(from, to) - reach, glm::max(from, to) + reach, pen.colour,
          [&](const Vec2& point) { return distanceToSegment(point, from, to) - 0.5 * pen.width; });
}

void Canvas::line(std::span<const Vec2> points, const Pen& pen) {
    double passed = 0.0;
    for (size_t i = 1; i < points.size(); ++i) {
        const Vec2 from = points[i - 1], along = points[i] - from;
        const double length = glm::length(along);
        if (pen.dash <= 0.0 || length <= 0.0) {
            stroke(from, points[i], pen);
            continue;
        }
        // Dashes continue over the corners of a line.
        for (double at = 0.0; at < length;) {
            const double phase = std::fmod(passed + at, 2.0 * pen.dash);
            const double next = std::min(length, at + std::max((phase < pen.dash ? pen.dash : 2.0 * pen.dash) - phase, 1e-3));
            if (phase < pen.dash) stroke(from + along * (at / length), from + along * (next / length), pen);
            at = next;
        }
        passed += length;
    }
}

void Canvas::dot(const Vec2& centre, double radius, const Vec3f& colour) {
    cover(centre - radius, centre + radius, colour, [&](const Vec2& point) { return glm::length(point - centre) - radius; });
}

void Canvas::ring(const Vec2& centre, double radius, const Pen& pen) {
    const double reach = radius + 0.5 * pen.width;
    cover(centre - reach, centre + reach, pen.colour,
          [&](const Vec2& point) { return std::abs(glm::length(point - centre) - radius) - 0.5 * pen.width; });
}

std::vector<uint8_t> Canvas::rgba() const { return upsideDown(m_rgba, m_size.height); }

}  // namespace cullscope
