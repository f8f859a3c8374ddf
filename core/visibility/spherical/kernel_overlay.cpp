// Inner kernels: the filled part of a solid, and its outline as seen from an eye.

#include <algorithm>

#include "core/visibility/spherical/map_overlays.h"
#include "core/visibility/spherical/map_place.h"

namespace cullscope::spherical {
namespace {

// Widths and radii in units.
constexpr float kGridWidth = 1.5f;
constexpr float kHorizonWidth = 3.0f;
constexpr float kKernelAxisWidth = 1.5f;
constexpr float kHorizonMarkWidth = 2.0f;
constexpr double kKernelMarkRadius = 5.0;

constexpr double kKernelLeastGap = 8.0;  ///< pixels between lines of the grid, on average
constexpr double kKernelLeastRadius =
    20.0;                           ///< pixels; smaller kernels are left out, because many small ones would hide each other
constexpr double kLeastStep = 2.0;  ///< pixels between points of a line

/// The kernel as a surface through the corners of its cells, in the world. Each cell has one radius, and a corner takes the
/// smallest of the cells that share it, so that the surface has no steps and lies inside the kernel everywhere.
class KernelSurface {
public:
    KernelSurface(const InnerKernel& kernel, const MapPlace& place) : m_size(1U << kernel.level()) {
        const std::vector<float> radii = cornerRadii(kernel);
        for (uint32_t y = 0; y <= m_size; ++y)
            for (uint32_t x = 0; x <= m_size; ++x) {
                const Vec3 direction = directionAt(MapLayout::Octahedral, Vec2(x, y) / double(m_size));
                m_corners.push_back(place.world(double(radii[number(x, y)]) * direction));
            }
    }

    /// Mean distance from the centre over all corners, in world units.
    [[nodiscard]] double meanRadius(const Vec3& centre) const {
        double sum = 0.0;
        for (const Vec3& corner : m_corners) sum += glm::distance(corner, centre);
        return sum / double(m_corners.size());
    }

    [[nodiscard]] uint32_t size() const { return m_size; }
    [[nodiscard]] const Vec3& corner(uint32_t x, uint32_t y) const { return m_corners[number(x, y)]; }

    /// By cell (row, then column): whether its outer side faces the eye.
    [[nodiscard]] std::vector<char> facing(const Vec3& eye, const Vec3& centre) const {
        std::vector<char> result;
        for (uint32_t y = 0; y < m_size; ++y)
            for (uint32_t x = 0; x < m_size; ++x) {
                const Vec3 &a = corner(x, y), &b = corner(x + 1, y + 1), &c = corner(x + 1, y), &d = corner(x, y + 1);
                const Vec3 normal = glm::cross(b - a, d - c), middle = 0.25 * (a + b + c + d);
                result.push_back(glm::dot(normal, middle - centre) * glm::dot(normal, eye - middle) > 0.0 ? 1 : 0);
            }
        return result;
    }

private:
    [[nodiscard]] size_t number(uint32_t x, uint32_t y) const { return size_t(y) * (m_size + 1) + x; }

    [[nodiscard]] std::vector<float> cornerRadii(const InnerKernel& kernel) const {
        std::vector<float> radii(size_t(m_size + 1) * (m_size + 1), std::numeric_limits<float>::infinity());
        const auto lower = [&](uint32_t x, uint32_t y, float radius) {
            radii[number(x, y)] = std::min(radii[number(x, y)], radius);
        };
        for (uint32_t y = 0; y < m_size; ++y)
            for (uint32_t x = 0; x < m_size; ++x)
                for (const auto& [right, down] : {std::pair(0U, 0U), std::pair(1U, 0U), std::pair(0U, 1U), std::pair(1U, 1U)})
                    lower(x + right, y + down, kernel.radius({kernel.level(), x, y}));
        // Each border of the square is folded onto itself at its middle; the square's four corners are the same direction and are
        // joined last.
        const auto join = [&](uint32_t ax, uint32_t ay, uint32_t bx, uint32_t by) {
            lower(ax, ay, radii[number(bx, by)]);
            lower(bx, by, radii[number(ax, ay)]);
        };
        for (uint32_t i = 0; i <= m_size / 2; ++i)
            for (const uint32_t side : {0U, m_size}) {
                join(i, side, m_size - i, side);
                join(side, i, side, m_size - i);
            }
        join(0, 0, m_size, m_size);
        join(0, m_size, m_size, 0);
        join(0, 0, 0, m_size);
        join(m_size, 0, m_size, m_size);
        return radii;
    }

    uint32_t m_size;
    std::vector<Vec3> m_corners;
};

class KernelLines {
public:
    explicit KernelLines(const OverlayContext& context) : m_context(context) {}

    void add(const MapSnapshot& map) {
        const MapPlace place(m_context.scene, map);
        const Vec3 centre = place.world(Vec3(0.0));
        const KernelSurface surface(*map.kernel, place);
        const double pixels = pixelsOf(m_context.viewing, centre, surface.meanRadius(centre)) / m_context.style.unit;
        if (pixels < kKernelLeastRadius) return;
        addGrid(surface, centre, pixels);
        addHorizon(map, place);
        m_axes.push_back({centre, place.world(map.decision.eye), m_context.contrast});
        addMark(m_marks, m_context, centre, kKernelMarkRadius, MarkShape::Dot, m_context.contrast);
    }

    [[nodiscard]] std::vector<OverlayLines> overlays() && {
        // Drawn without depth test, because all of it lies inside the object.
        return {{std::move(m_grid), {kGridWidth, false}},
                {std::move(m_axes), {kKernelAxisWidth, false}, true},
                {std::move(m_horizons), {kHorizonWidth, false}, true},
                {std::move(m_marks), {kHorizonMarkWidth, false}, true}};
    }

private:
    /// The smallest power of two by which cells of that many pixels are at least `least` pixels apart.
    [[nodiscard]] static uint32_t strideFor(double pixels, double least, uint32_t most) {
        uint32_t stride = 1;
        while (stride < most && stride * pixels < least) stride *= 2;
        return stride;
    }

    void addGrid(const KernelSurface& surface, const Vec3& centre, double pixels) {
        const uint32_t size = surface.size();
        const Vec3f& colour = m_context.palette[size_t(TriangleState::Hidden)].colour;
        // A quarter of a turn is half the side of the square.
        const double ofCell = pixels * std::numbers::pi / size;
        const uint32_t stride = strideFor(ofCell, kKernelLeastGap, size / 2), step = strideFor(ofCell, kLeastStep, stride);
        const std::vector<char> facing = surface.facing(m_context.viewing.eye(), centre);
        const auto faces = [&](uint32_t x, uint32_t y) { return x < size && y < size && facing[size_t(y) * size + x] != 0; };
        for (uint32_t line = 0; line <= size; line += stride)
            for (uint32_t at = 0; at < size; at += step) {
                if (faces(at, line) || faces(at, line - 1))
                    m_grid.push_back({surface.corner(at, line), surface.corner(at + step, line), colour});
                if (faces(line, at) || faces(line - 1, at))
                    m_grid.push_back({surface.corner(line, at), surface.corner(line, at + step), colour});
            }
    }

    void addHorizon(const MapSnapshot& map, const MapPlace& place) {
        if (!map.decision.walk) return;
        const std::vector<Vec3>& outline = map.decision.walk->outline;
        // The outline is the border of what the eye can see, as that of a visible region.
        const Vec3f horizon = regionColour(m_context.style.background);
        for (size_t i = 0; i < outline.size(); ++i)
            m_horizons.push_back({place.world(outline[i]), place.world(outline[(i + 1) % outline.size()]), horizon});
    }

    const OverlayContext& m_context;
    std::vector<LineSegment> m_grid, m_horizons, m_axes, m_marks;
};

}  // namespace

std::vector<OverlayLines> kernelOverlay(const OverlayContext& context, const std::vector<MapSnapshot>& maps) {
    KernelLines lines(context);
    for (const MapSnapshot& map : maps)
        if (hasKernel(map)) lines.add(map);
    return std::move(lines).overlays();
}

}  // namespace cullscope::spherical
