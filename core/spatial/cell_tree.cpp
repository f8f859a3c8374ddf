#include "core/spatial/cell_tree.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_sort.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "core/base/message.h"

namespace cullscope {
namespace {

using Range = tbb::blocked_range<uint32_t>;

constexpr uint32_t kTrianglesPerPass = 8192;
constexpr uint32_t kLeavesAPart = 64;
// cos 84°: a wider cone is hardly ever back-facing as a whole, and its test loses its precision.
constexpr double kWidestConeCosine = 0.104528;
// Bound on the rounding of values stored as float.
constexpr double kFloatError = 1e-6;
constexpr float kNoCone = 2.0f;

Vec3f roundedDown(const Vec3& v) {
    Vec3f result(v);
    for (int i = 0; i < 3; ++i)
        if (double(result[i]) > v[i]) result[i] = std::nextafter(result[i], -std::numeric_limits<float>::infinity());
    return result;
}
float roundedUp(double value) {
    const auto result = float(value);
    return double(result) < value ? std::nextafter(result, std::numeric_limits<float>::infinity()) : result;
}
Vec3f roundedUp(const Vec3& v) { return {roundedUp(v.x), roundedUp(v.y), roundedUp(v.z)}; }

Vec3 middleOf(const CellTree::Node& node) { return 0.5 * (Vec3(node.low) + Vec3(node.high)); }

/// The orientation of a triangle.
struct Facet {
    Vec3 normal{0.0};     ///< unit; the null vector where the triangle has no area
    double height = 0.0;  ///< smallest altitude; infinite where two corners coincide, because such a triangle is never drawn
};

Facet facetOf(const std::array<Vec3, 3>& corners) {
    const auto& [a, b, c] = corners;
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    if (a == b || b == c || c == a) return {Vec3(0.0), kInfinity};
    const Vec3 normal = glm::cross(b - a, c - a);
    const double area = glm::length(normal);
    const double longest = std::max({glm::length(b - a), glm::length(c - b), glm::length(a - c)});
    if (!(area > 0.0)) return {};
    return {normal / area, area / longest};
}

/// Sets a node's cone from its axis and the cosine of its half-angle.
void setCone(CellTree::Node& node, const Vec3& axis, double cosine) {
    cosine -= kFloatError;
    node.coneAxis = Vec3f(axis);
    node.coneCosine = cosine < kWidestConeCosine ? kNoCone : float(cosine);
    node.coneSine = float(std::sqrt(std::max(0.0, 1.0 - cosine * cosine)) + kFloatError);
}

bool hasCone(const CellTree::Node& node) { return node.coneCosine <= 1.0f; }
bool hasNormals(const CellTree::Node& node) { return node.coneAxis != Vec3f(0.0f); }

/// The largest n · v over all unit vectors n in a node's cone.
double largestAlong(const CellTree::Node& node, const Vec3& v) {
    const double length = glm::length(v), along = glm::dot(Vec3(node.coneAxis), v);
    if (along >= length * node.coneCosine) return length;
    return along * node.coneCosine + std::sqrt(std::max(0.0, length * length - along * along)) * node.coneSine;
}

}  // namespace

CellTree::CellTree(MeshPointer mesh, const Options& options, const Progress& progress)
    : m_mesh(std::move(mesh)), m_options(options) {
    if (m_mesh->triangleCount() == 0) return;
    if (divided()) {
        sortTriangles(progress);
    } else {
        m_order.resize(m_mesh->triangleCount());
        std::iota(m_order.begin(), m_order.end(), 0U);
    }
    divide();
    m_codes = {};
    bound(progress);
    progress.check();
}

std::array<Vec3, 3> CellTree::corners(uint32_t triangle) const {
    std::array<Vec3, 3> result;
    for (size_t i = 0; i < 3; ++i)
        result[i] = Vec3(m_mesh->positions()[m_mesh->indices()[3 * size_t(triangle) + i]]) - sphere().centre;
    return result;
}

void CellTree::sortTriangles(const Progress& progress) {
    progress.tell(0.0, CULLSCOPE_TR("order of the triangles"));
    const auto count = uint32_t(m_mesh->triangleCount());
    std::vector<uint64_t> keys(count);  // code in the upper half, triangle number in the lower
    tbb::parallel_for(Range(0, count, kTrianglesPerPass), [&](const Range& part) {
        if (progress.stopRequested()) return;
        for (uint32_t triangle = part.begin(); triangle < part.end(); ++triangle) {
            const std::array<Vec3, 3> points = corners(triangle);
            const Vec3 centroid = points[0] + points[1] + points[2];
            const MapCell cell = centroid == Vec3(0.0) ? MapCell{} : mapCellOf(m_options.layout, centroid, kFinestLevel);
            keys[triangle] = uint64_t(mortonCode(cell.x, cell.y)) << 32 | triangle;
        }
    });
    progress.check();
    tbb::parallel_sort(keys.begin(), keys.end());
    progress.check();
    m_codes.resize(count);
    m_order.resize(count);
    m_indices.resize(3 * size_t(count));
    tbb::parallel_for(Range(0, count, kTrianglesPerPass), [&](const Range& part) {
        for (uint32_t place = part.begin(); place < part.end(); ++place) {
            m_codes[place] = uint32_t(keys[place] >> 32);
            m_order[place] = uint32_t(keys[place]);
            for (size_t i = 0; i < 3; ++i) m_indices[3 * size_t(place) + i] = m_mesh->indices()[3 * size_t(m_order[place]) + i];
        }
    });
}

void CellTree::divide() {
    const uint32_t finest = m_options.level == 0 ? kFinestLevel : std::min(m_options.level, kFinestLevel);
    const uint32_t few = m_options.level == 0 ? kTrianglesALeaf : 1;
    const auto codeAt = [](uint32_t code, uint32_t level) { return code >> (2 * (kFinestLevel - level)); };
    Node root;
    root.count = uint32_t(m_order.size());
    m_nodes.push_back(root);
    if (!divided()) return;
    for (size_t i = 0; i < m_nodes.size(); ++i) {
        Node node = m_nodes[i];
        const auto begin = m_codes.begin() + node.first, end = begin + node.count;
        // The smallest cell that contains all its triangles: this skips chains of nodes with one child.
        while (node.level < finest && codeAt(*begin, node.level + 1U) == codeAt(*(end - 1), node.level + 1U))
            node.code = codeAt(*begin, ++node.level);
        if (node.level < finest && node.count > few) {
            node.firstChild = uint32_t(m_nodes.size());
            for (auto from = begin; from != end;) {
                Node child;
                child.level = uint8_t(node.level + 1);
                child.code = codeAt(*from, child.level);
                const auto to =
                    std::partition_point(from, end, [&](uint32_t code) { return codeAt(code, child.level) == child.code; });
                child.first = uint32_t(from - m_codes.begin());
                child.count = uint32_t(to - from);
                m_nodes.push_back(child);
                ++node.childCount;
                from = to;
            }
        }
        m_deepest = std::max(m_deepest, uint32_t(node.level));
        m_nodes[i] = node;
    }
}

void CellTree::bound(const Progress& progress) {
    progress.tell(0.6, CULLSCOPE_TR("bounds of the cells"));
    tbb::parallel_for(Range(0, uint32_t(m_nodes.size()), kLeavesAPart), [&](const Range& part) {
        if (progress.stopRequested()) return;
        for (uint32_t node = part.begin(); node < part.end(); ++node)
            if (m_nodes[node].childCount == 0) boundLeaf(m_nodes[node]);
    });
    progress.check();
    for (size_t node = m_nodes.size(); node-- > 0;)
        if (m_nodes[node].childCount > 0) boundInner(m_nodes[node]);
}

void CellTree::boundLeaf(Node& node) const {
    Box3 box;
    Vec3 sum(0.0);
    double height = std::numeric_limits<double>::infinity();
    std::vector<std::pair<Vec3, double>> planes;  // unit normal, and its dot product with the triangle's points
    for (uint32_t place = node.first; place < node.first + node.count; ++place) {
        const std::array<Vec3, 3> points = corners(m_order[place]);
        for (const Vec3& point : points) box.add(point);
        const Facet facet = facetOf(points);
        height = std::min(height, facet.height);
        if (facet.normal == Vec3(0.0)) continue;
        planes.emplace_back(facet.normal, glm::dot(facet.normal, points[0]));
        sum += facet.normal;
    }
    node.low = roundedDown(box.min);
    node.high = roundedUp(box.max);
    node.leastHeight = -roundedUp(-height);
    node.coneCosine = planes.empty() ? 1.0f : kNoCone;
    if (glm::length(sum) < 1e-3) return;
    const Vec3 axis = glm::normalize(sum), middle = middleOf(node);
    double cosine = 1.0, margin = -std::numeric_limits<double>::infinity();
    for (const auto& [normal, offset] : planes) {
        cosine = std::min(cosine, glm::dot(normal, axis));
        margin = std::max(margin, glm::dot(normal, middle) - offset);
    }
    setCone(node, axis, cosine);
    node.planeMargin = roundedUp(margin + kFloatError * glm::length(box.halfExtent()));
}

void CellTree::boundInner(Node& node) const {
    const std::span<const Node> children(m_nodes.data() + node.firstChild, node.childCount);
    Vec3 sum(0.0);
    bool cones = true, normals = false;
    node.low = children[0].low;
    node.high = children[0].high;
    node.leastHeight = children[0].leastHeight;
    for (const Node& child : children) {
        node.low = glm::min(node.low, child.low);
        node.high = glm::max(node.high, child.high);
        node.leastHeight = std::min(node.leastHeight, child.leastHeight);
        cones = cones && hasCone(child);
        normals = normals || hasNormals(child);
        sum += double(child.count) * Vec3(child.coneAxis);
    }
    // Children with opposite normals have no common axis.
    node.coneCosine = cones && !normals ? 1.0f : kNoCone;
    if (!cones || glm::length(sum) < 1e-3) return;
    const Vec3 axis = glm::normalize(sum), middle = middleOf(node);
    double angle = 0.0, margin = -std::numeric_limits<double>::infinity();
    for (const Node& child : children) {
        if (!hasNormals(child)) continue;
        // Computed from the chord, which keeps its precision for small angles; axes stored as float are not exactly of unit
        // length.
        const double chord = glm::length(axis - glm::normalize(Vec3(child.coneAxis)));
        const double apart = 2.0 * std::asin(std::min(1.0, 0.5 * chord)) + kFloatError;
        angle = std::max(angle, apart + std::acos(std::min(1.0, double(child.coneCosine))));
        margin = std::max(margin, child.planeMargin + largestAlong(child, middle - middleOf(child)));
    }
    setCone(node, axis, angle < 1.5 ? std::cos(angle) : -1.0);
    node.planeMargin = roundedUp(margin + kFloatError * glm::length(Vec3(node.high) - Vec3(node.low)));
}

size_t CellTree::leafCount() const {
    return size_t(std::count_if(m_nodes.begin(), m_nodes.end(), [](const Node& node) { return node.childCount == 0; }));
}

const CellTree::Node* CellTree::leafAt(const Vec3& direction) const {
    if (m_nodes.empty()) return nullptr;
    const MapCell cell = mapCellOf(m_options.layout, direction, kFinestLevel);
    const uint32_t code = mortonCode(cell.x, cell.y);
    const auto holds = [&](const Node& node) { return code >> (2 * (kFinestLevel - node.level)) == node.code; };
    const Node* node = m_nodes.data();
    while (holds(*node)) {
        if (node->childCount == 0) return node;
        const std::span<const Node> children(m_nodes.data() + node->firstChild, node->childCount);
        const auto child = std::find_if(children.begin(), children.end(), holds);
        if (child == children.end()) return nullptr;
        node = &*child;
    }
    return nullptr;
}

uint64_t CellTree::bytes() const {
    return m_nodes.size() * sizeof(Node) + (m_order.size() + m_indices.size()) * sizeof(uint32_t);
}

}  // namespace cullscope
