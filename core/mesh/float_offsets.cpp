#include "core/mesh/float_offsets.h"

#include <algorithm>
#include <array>

#include "core/mesh/steps.h"

namespace cullscope {
namespace {

/// The middle half of the vertices along an axis.
struct MiddleHalf {
    double first = 0.0, last = 0.0;
};

/// Reorders the coordinates.
MiddleHalf middleHalf(std::vector<double>& coordinates) {
    const auto nth = [&](size_t place) {
        std::nth_element(coordinates.begin(), coordinates.begin() + std::ptrdiff_t(place), coordinates.end());
        return coordinates[place];
    };
    return {nth(coordinates.size() / 4), nth(coordinates.size() * 3 / 4)};
}

/// Not inlined, because GCC 12 leaves out the conversion of two doubles to floats and back where it sees both, and with it the
/// rounding.
[[gnu::noinline]] Vec3f floatOffset(const Vec3& position, const Vec3& origin) { return Vec3f(position - origin); }

}  // namespace

Vec3 originForFloats(const RawMesh& raw, const Box3& bounds) {
    constexpr size_t kSample = 4096;
    // Up to here a float's 24 bits keep the middle half to a part in 100,000 of its own extent at least.
    constexpr double kFewTimes = 64.0;
    const Vec3 size = bounds.max - bounds.min;
    const size_t step = std::max<size_t>(1, raw.vertexCount() / kSample);
    Vec3 middle(0.0);
    double extent = 0.0, extentOfHalf = 0.0;
    std::vector<double> coordinates;
    for (int axis = 0; axis < 3; ++axis) {
        coordinates.clear();
        for (size_t vertex = 0; vertex < raw.vertexCount(); vertex += step) coordinates.push_back(raw.position(vertex)[axis]);
        const MiddleHalf half = middleHalf(coordinates);
        middle[axis] = half.first + 0.5 * (half.last - half.first);
        extent = std::max(extent, size[axis]);
        extentOfHalf = std::max(extentOfHalf, half.last - half.first);
    }
    return extent > kFewTimes * extentOfHalf ? middle : bounds.centre();
}

size_t trianglesBentByRounding(const RawMesh& raw, const Vec3& origin, const Progress& progress) {
    constexpr double kTenth = 0.1;
    size_t bent = 0;
    inSteps(raw.triangles.size() / 3, progress, [&](size_t begin, size_t end) {
        for (size_t triangle = begin; triangle < end; ++triangle) {
            std::array<Vec3, 3> exact, rounded;
            for (size_t i = 0; i < 3; ++i) {
                exact[i] = raw.position(raw.triangles[3 * triangle + i]);
                rounded[i] = Vec3(floatOffset(exact[i], origin));
            }
            double longest = 0.0, change = 0.0;
            for (size_t i = 0; i < 3; ++i) {
                const Vec3 side = exact[(i + 1) % 3] - exact[i];
                longest = std::max(longest, glm::length(side));
                change = std::max(change, glm::length(rounded[(i + 1) % 3] - rounded[i] - side));
            }
            bent += change > kTenth * longest ? 1 : 0;
        }
    });
    return bent;
}

std::vector<Vec3f> takeOffsets(RawMesh& raw, const Vec3& origin, const Progress& progress) {
    std::vector<Vec3f> offsets = std::move(raw.narrow);
    if (!raw.wide.empty()) offsets.resize(raw.wide.size());
    inSteps(offsets.size(), progress, [&](size_t begin, size_t end) {
        for (size_t i = begin; i < end; ++i) offsets[i] = Vec3f((raw.wide.empty() ? Vec3(offsets[i]) : raw.wide[i]) - origin);
    });
    std::vector<Vec3>().swap(raw.wide);
    return offsets;
}

}  // namespace cullscope
