#include "tests/support/exact_visibility.h"

#include <cmath>
#include <cstdio>

namespace cullscope::test {
namespace {

QuadVector unit(const QuadVector& v) { return scaled(v, 1 / root(dot(v, v))); }

/// The tangent from the series of sine and cosine; the error of 40 terms is below 2^-113 for angles up to pi/2.
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

}  // namespace

ExactVisibility::ExactVisibility(const Camera& camera, const Viewport& viewport) : m_eye(quad(camera.eye)) {
    const QuadVector forward = unit(plus(quad(camera.target), scaled(m_eye, -1)));
    const QuadVector right = unit(cross(forward, quad(camera.up)));
    const QuadVector up = cross(right, forward);
    const Quad tall = tangent(Quad(camera.fovy.radians()) / 2);
    const Quad wide = tall * viewport.width / viewport.height;
    const auto side = [&](const QuadVector& axis, Quad tangentOfHalf) {
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
        QuadVector point;
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
        vertices.emplace_back();
        if (used[v] == 0) continue;
        const QuadVector point = eyeRelative(mesh.positions()[v]);
        const Distances& fromPlanes = vertices.back() = distances(point);
        const double reach = std::sqrt(static_cast<double>(dot(point, point)));
        for (size_t plane = 0; plane < 6; ++plane) {
            farthest[plane] = std::max(farthest[plane], fromPlanes[plane]);
            truth.closest[plane] =
                std::min(truth.closest[plane], std::abs(static_cast<double>(fromPlanes[plane])) / std::max(reach, 1e-300));
        }
        (inside(fromPlanes) ? anyInside : anyOutside) = true;
    }
    // A vertex inside proves visibility; a plane with every vertex outside, hence their convex hull, disproves it.
    truth.visible = anyInside;
    bool separated = false;
    for (const Quad distance : farthest) separated = separated || distance < 0;
    for (size_t i = 0; !truth.visible && !separated && i + 2 < mesh.indices().size(); i += 3)
        truth.visible =
            reachesInside(vertices[mesh.indices()[i]], vertices[mesh.indices()[i + 1]], vertices[mesh.indices()[i + 2]]);
    truth.straddles = truth.visible && anyOutside;
    return truth;
}

Distances ExactVisibility::distances(const QuadVector& eyeRelative) const {
    Distances distances;
    for (size_t plane = 0; plane < 6; ++plane)
        distances[plane] = dot(m_halfSpaces[plane].normal, eyeRelative) + m_halfSpaces[plane].offset;
    return distances;
}

bool ExactVisibility::meets(const Box3& world) const {
    QuadBox box{};
    for (int axis = 0; axis < 3; ++axis) {
        const auto i = size_t(axis);
        box.centre[i] = (Quad(world.min[axis]) + Quad(world.max[axis])) / 2 - m_eye[i];
        box.halves[i][i] = (Quad(world.max[axis]) - Quad(world.min[axis])) / 2;
    }
    const QuadVector nearCentre = scaled(m_halfSpaces[4].normal, -m_halfSpaces[4].offset);
    return test::meets(
        box, [&](const QuadVector& point) { return distances(point); }, nearCentre);
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
