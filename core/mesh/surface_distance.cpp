#include "core/mesh/surface_distance.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <vector>

#include "core/geometry/bounds.h"

namespace cullscope {
namespace {

using SurfaceCorners = std::array<Vec3, 3>;

constexpr double kSlack = 1.1;          ///< the bound beside the true distance, at most
constexpr double kFinest = 1.0 / 4096;  ///< of the extent: what is not told apart
constexpr uint32_t kLeafTriangles = 4;

double squared(const Vec3& vector) { return glm::dot(vector, vector); }

double squaredToSegment(const Vec3& point, const Vec3& a, const Vec3& b) {
    const Vec3 along = b - a;
    const double length = squared(along);
    const double t = length > 0.0 ? std::clamp(glm::dot(point - a, along) / length, 0.0, 1.0) : 0.0;
    return squared(point - a - t * along);
}

/// The squared distance of a point from a triangle, also from one without area.
double squaredToTriangle(const Vec3& point, const SurfaceCorners& corners) {
    const auto& [a, b, c] = corners;
    const Vec3 normal = glm::cross(b - a, c - a);
    const double doubled = squared(normal);
    if (doubled > 0.0) {
        bool within = true;
        for (size_t i = 0; i < 3; ++i)
            within = within && glm::dot(glm::cross(corners[(i + 1) % 3] - corners[i], point - corners[i]), normal) >= 0.0;
        const double height = glm::dot(point - a, normal);
        if (within) return height * height / doubled;
    }
    return std::min({squaredToSegment(point, a, b), squaredToSegment(point, b, c), squaredToSegment(point, c, a)});
}

double squaredToBox(const Vec3& point, const Box3& box) {
    return squared(glm::max(glm::max(box.min - point, point - box.max), Vec3(0.0)));
}

/// Triangles in a tree of boxes, for the nearest one to a point.
class SurfaceTree {
public:
    SurfaceTree(std::span<const Vec3f> points, std::span<const uint32_t> indices) : m_points(points), m_indices(indices) {
        for (size_t i = 0; i + 2 < indices.size(); i += 3)
            m_triangles.push_back({Vec3(points[indices[i]]), Vec3(points[indices[i + 1]]), Vec3(points[indices[i + 2]])});
        if (!m_triangles.empty()) build(0, uint32_t(m_triangles.size()));
    }

    struct Nearest {
        uint32_t triangle = 0;
        double squared = std::numeric_limits<double>::infinity();
    };
    /// `known`: a triangle that is no farther than most; the search begins with its distance.
    [[nodiscard]] Nearest nearest(const Vec3& point, uint32_t known) const {
        Nearest best{known, squaredToTriangle(point, m_triangles[known])};
        search(0, point, best);
        return best;
    }
    [[nodiscard]] const std::vector<SurfaceCorners>& triangles() const { return m_triangles; }
    [[nodiscard]] std::span<const Vec3f> points() const { return m_points; }
    [[nodiscard]] std::span<const uint32_t> indices() const { return m_indices; }
    /// Around the corners.
    [[nodiscard]] Box3 box() const { return m_nodes.empty() ? Box3{} : m_nodes.front().box; }

private:
    struct Node {
        Box3 box;
        uint32_t first = 0, count = 0;  ///< of a leaf its triangles
        uint32_t second = 0;            ///< of others the second child; the first one follows the node
    };

    uint32_t build(uint32_t begin, uint32_t end) {
        const auto number = uint32_t(m_nodes.size());
        m_nodes.push_back({});
        Box3 box, middles;
        for (uint32_t i = begin; i < end; ++i) {
            for (const Vec3& corner : m_triangles[i]) box.add(corner);
            middles.add(middle(m_triangles[i]));
        }
        m_nodes[number].box = box;
        if (end - begin <= kLeafTriangles) {
            m_nodes[number].first = begin;
            m_nodes[number].count = end - begin;
            return number;
        }
        const Vec3 extent = middles.max - middles.min;
        const int axis = extent.x >= extent.y && extent.x >= extent.z ? 0 : extent.y >= extent.z ? 1 : 2;
        const uint32_t half = begin + (end - begin) / 2;
        const auto at = [&](uint32_t i) { return m_triangles.begin() + std::ptrdiff_t(i); };
        std::nth_element(at(begin), at(half), at(end),
                         [&](const SurfaceCorners& a, const SurfaceCorners& b) { return middle(a)[axis] < middle(b)[axis]; });
        build(begin, half);
        m_nodes[number].second = build(half, end);
        return number;
    }
    static Vec3 middle(const SurfaceCorners& corners) { return corners[0] + corners[1] + corners[2]; }

    void search(uint32_t number, const Vec3& point, Nearest& best) const {
        const Node& node = m_nodes[number];
        if (node.count > 0) {
            for (uint32_t i = node.first; i < node.first + node.count; ++i)
                if (const double away = squaredToTriangle(point, m_triangles[i]); away < best.squared) best = {i, away};
            return;
        }
        std::array<uint32_t, 2> children{number + 1, node.second};
        std::array<double, 2> away{squaredToBox(point, m_nodes[children[0]].box), squaredToBox(point, m_nodes[children[1]].box)};
        if (away[1] < away[0]) {
            std::swap(children[0], children[1]);
            std::swap(away[0], away[1]);
        }
        for (size_t i = 0; i < 2; ++i)
            if (away[i] < best.squared) search(children[i], point, best);
    }

    std::span<const Vec3f> m_points;
    std::span<const uint32_t> m_indices;
    std::vector<SurfaceCorners> m_triangles;  ///< in the order of the tree
    std::vector<Node> m_nodes;
};

/// How far the points of one surface lie from the other, at most.
class OneSided {
public:
    OneSided(const SurfaceTree& from, const SurfaceTree& to, double finest, const Progress& progress)
        : m_from(from), m_to(to), m_finest(finest), m_progress(progress) {}

    /// `worst`: a distance that is known to be there.
    [[nodiscard]] double bound(double worst) {
        m_worst = worst;
        const std::span<const uint32_t> indices = m_from.indices();
        std::vector<Corner> corners(m_from.points().size());  // by vertex
        std::vector<bool> known(corners.size(), false);
        uint32_t last = 0;
        for (size_t i = 0; i < indices.size(); ++i) {
            if (i % 4096 == 0) m_progress.check();
            const uint32_t vertex = indices[i];
            if (known[vertex]) continue;
            known[vertex] = true;
            corners[vertex] = at(Vec3(m_from.points()[vertex]), last);
            last = corners[vertex].nearest.triangle;
        }
        for (size_t i = 0; i + 2 < indices.size(); i += 3)
            refine({{corners[indices[i]], corners[indices[i + 1]], corners[indices[i + 2]]}});
        return std::max(m_worst, m_bound);
    }
    [[nodiscard]] double worst() const { return m_worst; }

private:
    struct Corner {
        Vec3 point{0.0};
        SurfaceTree::Nearest nearest;
    };
    struct Piece {
        std::array<Corner, 3> corners;
    };

    Corner at(const Vec3& point, uint32_t known) {
        const Corner corner{point, m_to.nearest(point, known)};
        m_worst = std::max(m_worst, std::sqrt(corner.nearest.squared));
        return corner;
    }

    /// No point of the piece lies farther than this. The distance from one triangle is largest at a corner, for the triangle is
    /// convex; and no distance changes by more than the way between two points.
    [[nodiscard]] double atMost(const Piece& piece) const {
        double longest = 0.0, largest = 0.0, best = std::numeric_limits<double>::infinity();
        for (size_t i = 0; i < 3; ++i) {
            longest = std::max(longest, squared(piece.corners[i].point - piece.corners[(i + 1) % 3].point));
            largest = std::max(largest, piece.corners[i].nearest.squared);
            const SurfaceCorners& near = m_to.triangles()[piece.corners[i].nearest.triangle];
            double farthest = 0.0;
            for (const Corner& corner : piece.corners) farthest = std::max(farthest, squaredToTriangle(corner.point, near));
            best = std::min(best, farthest);
        }
        // Every point of a triangle lies within longest edge/√3 of one of its corners.
        return std::min(std::sqrt(best), std::sqrt(largest) + std::sqrt(longest / 3.0));
    }

    void refine(const Piece& whole) {
        std::vector<Piece> open{whole};
        while (!open.empty()) {
            const Piece piece = open.back();
            open.pop_back();
            const double most = atMost(piece);
            if (most <= std::max(kSlack * m_worst, m_finest)) {
                m_bound = std::max(m_bound, most);
                continue;
            }
            if (++m_divided % 256 == 0) m_progress.check();
            const auto& [a, b, c] = piece.corners;
            const auto between = [&](const Corner& first, const Corner& second) {
                return at(0.5 * (first.point + second.point), first.nearest.triangle);
            };
            const Corner ab = between(a, b), bc = between(b, c), ca = between(c, a);
            open.insert(open.end(), {Piece{{a, ab, ca}}, Piece{{ab, b, bc}}, Piece{{ca, bc, c}}, Piece{{ab, bc, ca}}});
        }
    }

    const SurfaceTree& m_from;
    const SurfaceTree& m_to;
    double m_finest;
    const Progress& m_progress;
    double m_worst = 0.0, m_bound = 0.0;
    size_t m_divided = 0;
};

}  // namespace

struct SurfaceDistance::Surface : SurfaceTree {
    using SurfaceTree::SurfaceTree;
};

SurfaceDistance::SurfaceDistance(std::span<const Vec3f> points, std::span<const uint32_t> indices)
    : m_surface(std::make_unique<const Surface>(points, indices)) {}
SurfaceDistance::~SurfaceDistance() = default;

double SurfaceDistance::to(std::span<const uint32_t> other, const Progress& progress) const {
    const SurfaceTree& own = *m_surface;
    if (own.indices().empty() && other.empty()) return 0.0;
    if (own.indices().empty() || other.empty()) return std::numeric_limits<double>::infinity();
    const SurfaceTree others(own.points(), other);
    Box3 box = own.box();
    box.add(others.box().min);
    box.add(others.box().max);
    const double finest = kFinest * box.diagonal();
    OneSided there(own, others, finest, progress), back(others, own, finest, progress);
    const double bound = there.bound(0.0);
    return std::max(bound, back.bound(there.worst()));
}

}  // namespace cullscope
