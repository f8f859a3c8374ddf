#include "tests/core/visibility/exact_visibility.h"

#include <cmath>
#include <cstdio>

namespace cullscope::test {
namespace {

using Vector = std::array<Quad, 3>;

Quad dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
Vector cross(const Vector& a, const Vector& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
Vector scaled(const Vector& a, Quad by) { return {a[0] * by, a[1] * by, a[2] * by}; }
Vector plus(const Vector& a, const Vector& b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }
Vector quad(const Vec3& v) { return {v.x, v.y, v.z}; }

/// Newton's iteration from the double root: 53, 106, 212 good bits.
Quad root(Quad square) {
    Quad guess = std::sqrt(static_cast<double>(square));
    for (int i = 0; i < 3; ++i) guess = (guess + square / guess) / 2;
    return guess;
}

Vector unit(const Vector& v) { return scaled(v, 1 / root(dot(v, v))); }

/// Sine over cosine by their series; 40 terms leave less than 2^-113 for angles up to pi/2.
Quad tangent(Quad angle) {
    Quad sine = 0;
    Quad cosine = 0;
    Quad term = 1;
    for (int n = 0; n < 80; ++n) {
        (n % 2 == 0 ? cosine : sine) += n % 4 < 2 ? term : -term;
        term = term * angle / (n + 1);
    }
    return sine / cosine;
}

/// Signed distances of one vertex from the six planes.
using Distances = std::array<Quad, 6>;

Distances between(const Distances& a, const Distances& b, size_t plane) {
    const Quad share = a[plane] / (a[plane] - b[plane]);
    Distances point;
    for (size_t i = 0; i < 6; ++i) point[i] = a[i] + (b[i] - a[i]) * share;
    point[plane] = 0;
    return point;
}

/// Cuts a convex polygon, its points given by their distances from the planes, down to what lies inside one plane.
void clip(std::vector<Distances>& polygon, size_t plane) {
    std::vector<Distances> kept;
    for (size_t i = 0; i < polygon.size(); ++i) {
        const Distances& here = polygon[i];
        const Distances& next = polygon[(i + 1) % polygon.size()];
        if (here[plane] >= 0) kept.push_back(here);
        if ((here[plane] < 0) != (next[plane] < 0)) kept.push_back(between(here, next, plane));
    }
    polygon = std::move(kept);
}

bool reachesInside(const Distances& a, const Distances& b, const Distances& c) {
    for (size_t plane = 0; plane < 6; ++plane)
        if (a[plane] < 0 && b[plane] < 0 && c[plane] < 0) return false;
    std::vector<Distances> polygon{a, b, c};
    for (size_t plane = 0; plane < 6 && !polygon.empty(); ++plane) clip(polygon, plane);
    return !polygon.empty();
}

bool inside(const Distances& distances) {
    for (const Quad distance : distances)
        if (distance < 0) return false;
    return true;
}

}  // namespace

ExactVisibility::ExactVisibility(const Camera& camera, const Viewport& viewport) : m_eye(quad(camera.eye)) {
    const Vector forward = unit(plus(quad(camera.target), scaled(m_eye, -1)));
    const Vector right = unit(cross(forward, quad(camera.up)));
    const Vector up = cross(right, forward);
    const Quad tall = tangent(Quad(camera.fovy.radians()) / 2);
    const Quad wide = tall * viewport.width / viewport.height;
    const auto side = [&](const Vector& axis, Quad tangentOfHalf) {
        return HalfSpace{unit(plus(scaled(forward, tangentOfHalf), axis)), 0};
    };
    m_halfSpaces = {side(right, wide),
                    side(scaled(right, -1), wide),
                    side(up, tall),
                    side(scaled(up, -1), tall),
                    HalfSpace{forward, -Quad(camera.nearDistance)},
                    HalfSpace{scaled(forward, -1), Quad(camera.farDistance)}};
}

ObjectTruth ExactVisibility::judge(const Scene& scene, size_t instance) const {
    const TriangleMesh& mesh = scene.meshOf(instance);
    const Mat4& place = scene.instances()[instance].worldFromMesh;
    const auto eyeRelative = [&](const Vec3f& position) {
        Vector point;
        for (int row = 0; row < 3; ++row) {
            point[row] = Quad(place[3][row]) - m_eye[row];
            for (int axis = 0; axis < 3; ++axis)
                point[row] += Quad(place[axis][row]) * (Quad(mesh.origin()[axis]) + Quad(position[axis]));
        }
        return point;
    };

    ObjectTruth truth;
    std::vector<Distances> vertices;
    std::vector<char> used(mesh.vertexCount(), 0);
    for (const uint32_t index : mesh.indices()) used[index] = 1;
    bool anyInside = false;
    bool anyOutside = false;
    Distances farthest;
    farthest.fill(-1);
    for (size_t v = 0; v < mesh.vertexCount(); ++v) {
        Distances& distances = vertices.emplace_back();
        if (used[v] == 0) continue;
        const Vector point = eyeRelative(mesh.positions()[v]);
        const double reach = std::sqrt(static_cast<double>(dot(point, point)));
        for (size_t plane = 0; plane < 6; ++plane) {
            distances[plane] = dot(m_halfSpaces[plane].normal, point) + m_halfSpaces[plane].offset;
            farthest[plane] = std::max(farthest[plane], distances[plane]);
            truth.closest[plane] =
                std::min(truth.closest[plane], std::abs(static_cast<double>(distances[plane])) / std::max(reach, 1e-300));
        }
        (inside(distances) ? anyInside : anyOutside) = true;
    }
    // A vertex inside decides; so does a plane that has every vertex, hence their convex hull, on its outside.
    truth.visible = anyInside;
    bool separated = false;
    for (const Quad distance : farthest) separated = separated || distance < 0;
    for (size_t i = 0; !truth.visible && !separated && i + 2 < mesh.indices().size(); i += 3)
        truth.visible =
            reachesInside(vertices[mesh.indices()[i]], vertices[mesh.indices()[i + 1]], vertices[mesh.indices()[i + 2]]);
    truth.straddles = truth.visible && anyOutside;
    return truth;
}

std::string described(const Camera& camera, const Viewport& viewport) {
    std::array<char, 640> text{};
    std::snprintf(text.data(), text.size(),
                  "eye (%.17g, %.17g, %.17g) target (%.17g, %.17g, %.17g) up (%.17g, %.17g, %.17g) fovy %.17g rad near %.17g far "
                  "%.17g size %dx%d",
                  camera.eye.x, camera.eye.y, camera.eye.z, camera.target.x, camera.target.y, camera.target.z, camera.up.x,
                  camera.up.y, camera.up.z, camera.fovy.radians(), camera.nearDistance, camera.farDistance, viewport.width,
                  viewport.height);
    return text.data();
}

}  // namespace cullscope::test
