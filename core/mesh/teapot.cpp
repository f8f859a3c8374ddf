#include <cmath>
#include <map>

#include "core/base/error.h"
#include "core/mesh/parametric.h"

// Newell's control points (M. Newell, "The Utilization of Procedure Models in Digital Image Synthesis", 1975; bottom by J.
// Blinn). Rim, body, lid and bottom are profiles turned about the axis; handle and spout are mirrored halves. z is up in the
// data.

namespace cullscope {
namespace {

using Patch = std::array<Vec3, 16>;
using Profile = std::array<Vec2, 4>;  ///< radius, height

constexpr std::array<std::array<double, 8>, 6> kProfiles{{
    {1.4, 2.4, 1.3375, 2.53125, 1.4375, 2.53125, 1.5, 2.4},  // rim
    {1.5, 2.4, 1.75, 1.875, 2.0, 1.35, 2.0, 0.9},            // upper body
    {2.0, 0.9, 2.0, 0.45, 1.5, 0.225, 1.5, 0.15},            // lower body
    {1.5, 0.15, 1.5, 0.075, 1.425, 0.0, 0.0, 0.0},           // bottom
    {0.0, 3.15, 0.8, 3.15, 0.0, 2.7, 0.2, 2.7},              // knob
    {0.2, 2.7, 0.4, 2.55, 1.3, 2.55, 1.3, 2.4},              // lid
}};

/// One row across a half tube: the inner and outer control point (x, z) and the half width of the two between them.
struct TubeRow {
    double innerX, innerZ, outerX, outerZ, halfWidth;
};
constexpr std::array<TubeRow, 7> kHandle{{{-1.6, 2.025, -1.5, 2.25, 0.3},
                                          {-2.3, 2.025, -2.5, 2.25, 0.3},
                                          {-2.7, 2.025, -3.0, 2.25, 0.3},
                                          {-2.7, 1.8, -3.0, 1.8, 0.3},
                                          {-2.7, 1.575, -3.0, 1.35, 0.3},
                                          {-2.5, 1.125, -2.65, 0.9375, 0.3},
                                          {-2.0, 0.9, -1.9, 0.6, 0.3}}};
constexpr std::array<TubeRow, 7> kSpout{{{1.7, 1.425, 1.7, 0.6, 0.66},
                                         {2.6, 1.425, 3.1, 0.825, 0.66},
                                         {2.3, 2.1, 2.4, 2.025, 0.25},
                                         {2.7, 2.4, 3.3, 2.4, 0.25},
                                         {2.8, 2.475, 3.525, 2.49375, 0.25},
                                         {2.9, 2.475, 3.45, 2.5125, 0.15},
                                         {2.8, 2.4, 3.2, 2.4, 0.15}}};

/// A quarter turn of a profile; 0.56 is the tangent length of the circles in Newell's data.
Patch turned(const std::array<double, 8>& profile, int quarter) {
    constexpr std::array<Vec2, 5> kDirections{Vec2(1, 0), Vec2(0, 1), Vec2(-1, 0), Vec2(0, -1), Vec2(1, 0)};
    const Vec2 from = kDirections[quarter];
    const Vec2 to = kDirections[quarter + 1];
    const std::array<Vec2, 4> arc{from, from + to * 0.56, from * 0.56 + to, to};
    Patch patch;
    for (int row = 0; row < 4; ++row)
        for (int column = 0; column < 4; ++column)
            patch[row * 4 + column] = Vec3(arc[column] * profile[row * 2], profile[row * 2 + 1]);
    return patch;
}

/// Four rows of a half tube on one side (−1 or +1) of the plane y = 0.
Patch halfTube(const std::array<TubeRow, 7>& rows, size_t first, double side) {
    Patch patch;
    for (size_t row = 0; row < 4; ++row) {
        const TubeRow& r = rows[first + row];
        patch[row * 4 + 0] = {r.innerX, 0, r.innerZ};
        patch[row * 4 + 1] = {r.innerX, side * r.halfWidth, r.innerZ};
        patch[row * 4 + 2] = {r.outerX, side * r.halfWidth, r.outerZ};
        patch[row * 4 + 3] = {r.outerX, 0, r.outerZ};
    }
    return patch;
}

std::vector<Patch> teapotPatches() {
    std::vector<Patch> patches;
    for (const auto& profile : kProfiles)
        for (int quarter = 0; quarter < 4; ++quarter) patches.push_back(turned(profile, quarter));
    for (const size_t first : {size_t{0}, size_t{3}})
        for (const double side : {-1.0, 1.0}) {
            patches.push_back(halfTube(kHandle, first, side));
            patches.push_back(halfTube(kSpout, first, side));
        }
    return patches;
}

/// Whether the patch's rows and columns are clockwise seen from outside, by its place in the order of teapotPatches().
bool flipped(size_t patch) {
    if (patch < 24) return false;
    const size_t side = (patch - 24) / 2 % 2;
    const bool spout = patch % 2 == 1;
    return (side == 1) != spout;
}

std::array<double, 4> bernstein(double t) {
    const double s = 1 - t;
    return {s * s * s, 3 * s * s * t, 3 * s * t * t, t * t * t};
}

Vec3 evaluate(const Patch& patch, double u, double v) {
    const std::array<double, 4> row = bernstein(u);
    const std::array<double, 4> column = bernstein(v);
    Vec3 point(0.0);
    for (int i = 0; i < 4; ++i)
        for (int j = 0; j < 4; ++j) point += patch[i * 4 + j] * (row[i] * column[j]);
    return point;
}

/// Welds points of neighbouring patches: their borders are the same curves, which are evaluated to equal values within 1e-9.
class PatchWelder {
public:
    explicit PatchWelder(size_t vertices) { m_positions.reserve(vertices); }

    /// The vertex at a point on the border of patches; shared where it exists.
    uint32_t shared(const Vec3& p) {
        const auto grid = [](double x) { return static_cast<int64_t>(std::llround(x * 1e8)); };
        const auto [entry, isNew] =
            m_known.try_emplace({grid(p.x), grid(p.y), grid(p.z)}, static_cast<uint32_t>(m_positions.size()));
        return isNew ? own(p) : entry->second;
    }
    /// Adds a vertex of one patch, converted to y up, centred on the axis at half the height of the data.
    uint32_t own(const Vec3& p) {
        m_positions.emplace_back(Vec3(p.x, p.z - 1.575, -p.y));
        return static_cast<uint32_t>(m_positions.size() - 1);
    }
    [[nodiscard]] Vec3 position(uint32_t vertex) const { return Vec3(m_positions[vertex]); }
    std::vector<Vec3f> takePositions() { return std::move(m_positions); }

private:
    std::map<std::array<int64_t, 3>, uint32_t> m_known;
    std::vector<Vec3f> m_positions;
};

/// Nothing is added where a patch ends in a pole, or where its corners lie on a line.
void addTriangle(std::vector<uint32_t>& indices, const PatchWelder& vertices, uint32_t a, uint32_t b, uint32_t c) {
    const Vec3 p = vertices.position(a);
    if (glm::cross(vertices.position(b) - p, vertices.position(c) - p) != Vec3(0.0)) indices.insert(indices.end(), {a, b, c});
}

}  // namespace

MeshPointer teapotMesh(size_t triangles, const Progress& progress) {
    if (triangles < 56 || triangles > 2'000'000'000)
        throwUsage(CULLSCOPE_TR("%1 takes between %2 and %3 triangles, not %4."),
                   {"teapot", "56", "2000000000", std::to_string(triangles)});
    // Eight of the 32 patches end in a pole and lose one triangle a step there: 64 n² − 8 n in all.
    const auto steps = static_cast<uint32_t>(std::max(1.0, std::round((8 + std::sqrt(64 + 256.0 * double(triangles))) / 128)));
    const std::vector<Patch> patches = teapotPatches();
    PatchWelder welder(patches.size() * size_t{steps} * steps);
    TriangleMesh::Data data;
    data.name = "teapot";
    data.indices.reserve(patches.size() * size_t{steps} * steps * 6);
    for (size_t p = 0; p < patches.size(); ++p) {
        const auto verticesOfRow = [&](uint32_t i) {
            std::vector<uint32_t> vertices;
            for (uint32_t j = 0; j <= steps; ++j) {
                const bool onBorder = i == 0 || i == steps || j == 0 || j == steps;
                const Vec3 point = evaluate(patches[p], double(i) / steps, double(j) / steps);
                vertices.push_back(onBorder ? welder.shared(point) : welder.own(point));
            }
            return vertices;
        };
        std::vector<uint32_t> below = verticesOfRow(0);
        for (uint32_t i = 0; i < steps; ++i) {
            progress.check();
            progress.tell((double(p) + double(i) / steps) / double(patches.size()), CULLSCOPE_TR("Tessellating the shape"));
            const std::vector<uint32_t> above = verticesOfRow(i + 1);
            for (uint32_t j = 0; j < steps; ++j) {
                std::array<uint32_t, 4> quad{below[j], above[j], above[j + 1], below[j + 1]};
                if (flipped(p)) std::swap(quad[1], quad[3]);
                addTriangle(data.indices, welder, quad[0], quad[1], quad[2]);
                addTriangle(data.indices, welder, quad[0], quad[2], quad[3]);
            }
            below = above;
        }
    }
    data.positions = welder.takePositions();
    return std::make_shared<TriangleMesh>(std::move(data));
}

}  // namespace cullscope
