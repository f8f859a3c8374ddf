#include "core/geometry/frustum_planes.h"

#include <cmath>

namespace cullscope {
namespace {

bool finite(const Mat4& matrix) {
    for (int column = 0; column < 4; ++column)
        for (int row = 0; row < 4; ++row)
            if (!std::isfinite(matrix[column][row])) return false;
    return true;
}

bool invertible(const Mat4& matrix) {
    const double determinant = glm::determinant(matrix);
    return finite(matrix) && std::isfinite(determinant) && determinant != 0.0;
}

/// The plane a·x + b·y + c·z + d >= 0 with a unit normal; none where the normal has no length.
std::optional<Plane> normalised(const Vec4& coefficients) {
    const double length = glm::length(Vec3(coefficients));
    if (!(length > 0.0) || !std::isfinite(length)) return std::nullopt;
    return Plane{Vec3(coefficients) / length, coefficients.w / length};
}

/// The plane through three points that has `inside` on its positive side.
std::optional<Plane> through(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& inside) {
    // Normalised edges: those of the near plane may be 1e-15 of those of the far plane.
    const Vec3 cross = glm::cross(glm::normalize(b - a), glm::normalize(c - a));
    std::optional<Plane> plane = normalised(Vec4(cross, 0.0));
    if (!plane) return std::nullopt;
    plane->offset = -glm::dot(plane->normal, a);
    const double side = plane->distance(inside);
    if (!(std::abs(side) > 0.0)) return std::nullopt;
    if (side < 0.0) *plane = {-plane->normal, -plane->offset};
    return plane;
}

/// Near bottom-left, bottom-right, top-right, top-left, then the far ones in the same order, as Frustum::corners. None where the
/// signs of w differ: the corners do not all lie in front of the eye.
std::optional<std::array<Vec3, 8>> cornersOf(const Mat4& clip, ClipDepth depth) {
    const Mat4 inverse = glm::inverse(clip);
    const double nearDepth = depth == ClipDepth::MinusOneToOne ? -1.0 : depth == ClipDepth::ZeroToOne ? 0.0 : 1.0;
    const double farDepth = depth == ClipDepth::ReversedZeroToOne ? 0.0 : 1.0;
    std::array<Vec3, 8> corners;
    int positive = 0;
    for (size_t i = 0; i < corners.size(); ++i) {
        const double x = i % 4 == 0 || i % 4 == 3 ? -1.0 : 1.0;
        const double y = i % 4 < 2 ? -1.0 : 1.0;
        const Vec4 corner = inverse * Vec4(x, y, i < 4 ? nearDepth : farDepth, 1.0);
        corners[i] = Vec3(corner) / corner.w;
        if (!std::isfinite(glm::length(corners[i]))) return std::nullopt;
        positive += corner.w > 0.0 ? 1 : 0;
    }
    if (positive != 0 && positive != 8) return std::nullopt;
    return corners;
}

}  // namespace

std::optional<FrustumPlanes> planesFromRows(const Mat4& clip, ClipDepth depth) {
    if (!invertible(clip)) return std::nullopt;
    const Mat4 rows = glm::transpose(clip);
    const Vec4 &x = rows[0], &y = rows[1], &z = rows[2], &w = rows[3];
    Vec4 nearRow, farRow;
    switch (depth) {
        case ClipDepth::MinusOneToOne:
            nearRow = w + z;
            farRow = w - z;
            break;
        case ClipDepth::ZeroToOne:
            nearRow = z;
            farRow = w - z;
            break;
        case ClipDepth::ReversedZeroToOne:
            nearRow = w - z;
            farRow = z;
            break;
    }
    FrustumPlanes planes;
    const std::array<Vec4, 6> coefficients{w + x, w - x, w + y, w - y, nearRow, farRow};
    for (size_t i = 0; i < planes.size(); ++i) {
        const std::optional<Plane> plane = normalised(coefficients[i]);
        if (!plane) return std::nullopt;
        planes[i] = *plane;
    }
    return planes;
}

std::optional<FrustumPlanes> planesFromCorners(const Mat4& clip, ClipDepth depth) {
    if (!invertible(clip)) return std::nullopt;
    const std::optional<std::array<Vec3, 8>> corners = cornersOf(clip, depth);
    if (!corners) return std::nullopt;
    Vec3 inside(0.0);
    for (const Vec3& corner : *corners) inside += corner / 8.0;
    // Each side plane takes two far corners and one near corner: with long edges the offset loses little precision.
    constexpr std::array<std::array<size_t, 3>, 6> kOwnCorners{
        {{0, 4, 7}, {1, 6, 5}, {0, 5, 4}, {3, 7, 6}, {0, 1, 2}, {4, 6, 5}}};
    FrustumPlanes planes;
    for (size_t i = 0; i < planes.size(); ++i) {
        const auto& [a, b, c] = kOwnCorners[i];
        const std::optional<Plane> plane = through((*corners)[a], (*corners)[b], (*corners)[c], inside);
        if (!plane) return std::nullopt;
        planes[i] = *plane;
    }
    return planes;
}

PlaneDifference largestDifference(const FrustumPlanes& a, const FrustumPlanes& b) {
    PlaneDifference largest;
    double angle = 0.0;
    for (size_t i = 0; i < a.size(); ++i) {
        angle =
            std::max(angle, std::atan2(glm::length(glm::cross(a[i].normal, b[i].normal)), glm::dot(a[i].normal, b[i].normal)));
        largest.offset = std::max(largest.offset, std::abs(a[i].offset - b[i].offset));
    }
    largest.angle = Angle::fromRadians(angle);
    return largest;
}

}  // namespace cullscope
