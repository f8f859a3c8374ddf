#include "core/geometry/predicates.h"

#include <array>
#include <cmath>
#include <cstddef>

namespace cullscope {
namespace {

/// A sum of at most N doubles that is not rounded: its terms do not overlap and grow in magnitude (Shewchuk 1997, "expansion").
template <size_t N>
struct ExactSum {
    std::array<double, N> terms;
    size_t count = 0;

    /// Shewchuk's Grow-Expansion; terms that become zero are dropped.
    void add(double value) {
        size_t kept = 0;
        double sum = value;
        for (size_t i = 0; i < count; ++i) {
            const double next = sum + terms[i];
            const double part = next - sum;
            const double rest = (sum - (next - part)) + (terms[i] - part);
            sum = next;
            if (rest != 0.0) terms[kept++] = rest;
        }
        if (sum != 0.0) terms[kept++] = sum;
        count = kept;
    }
    /// Adds ± the product of two numbers.
    void addProduct(double a, double b) {
        const double product = a * b;
        add(std::fma(a, b, -product));
        add(product);
    }
    template <size_t M, size_t K>
    void addProduct(const ExactSum<M>& a, const ExactSum<K>& b, double factor) {
        for (size_t i = 0; i < a.count; ++i)
            for (size_t j = 0; j < b.count; ++j) addProduct(factor * a.terms[i], b.terms[j]);
    }
    /// The last term is larger than all others together.
    [[nodiscard]] int sign() const { return count == 0 ? 0 : terms[count - 1] > 0.0 ? 1 : -1; }
};

using ExactDifference = ExactSum<2>;

ExactDifference exactDifference(double a, double b) {
    ExactDifference result;
    result.add(a);
    result.add(-b);
    return result;
}

/// a·d − b·c.
ExactSum<16> exactMinor(const ExactDifference& a, const ExactDifference& b, const ExactDifference& c, const ExactDifference& d) {
    ExactSum<16> result;
    result.addProduct(a, d, 1.0);
    result.addProduct(b, c, -1.0);
    return result;
}

int exactSide(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& point) {
    std::array<ExactDifference, 3> u, v, w;
    for (int axis = 0; axis < 3; ++axis) {
        u[size_t(axis)] = exactDifference(b[axis], a[axis]);
        v[size_t(axis)] = exactDifference(c[axis], a[axis]);
        w[size_t(axis)] = exactDifference(point[axis], a[axis]);
    }
    ExactSum<192> determinant;
    for (size_t axis = 0; axis < 3; ++axis) {
        const size_t y = (axis + 1) % 3, z = (axis + 2) % 3;
        determinant.addProduct(exactMinor(u[y], u[z], v[y], v[z]), w[axis], 1.0);
    }
    return determinant.sign();
}

int signOf(double value) { return value > 0.0 ? 1 : value < 0.0 ? -1 : 0; }

}  // namespace

int sideOfPlane(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& point) {
    const Vec3 u = b - a, v = c - a, w = point - a;
    double determinant = 0.0, magnitude = 0.0;
    for (int axis = 0; axis < 3; ++axis) {
        const int y = (axis + 1) % 3, z = (axis + 2) % 3;
        const double first = u[y] * v[z], second = u[z] * v[y];
        determinant += (first - second) * w[axis];
        magnitude += (std::abs(first) + std::abs(second)) * std::abs(w[axis]);
    }
    // Fewer than eight roundings in a row, each of 2^-53 of the sum of the magnitudes. Differences that are 0 are exact.
    if (std::abs(determinant) > 0x1p-50 * magnitude || magnitude == 0.0) return signOf(determinant);
    return exactSide(a, b, c, point);
}

int clearSideOfPlane(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& point) {
    const Vec3 u = b - a, v = c - a, w = point - a;
    double determinant = 0.0, unclear = 0.0;
    for (int axis = 0; axis < 3; ++axis) {
        const int y = (axis + 1) % 3, z = (axis + 2) % 3;
        const double first = u[y] * v[z], second = u[z] * v[y];
        determinant += (first - second) * w[axis];
        // The difference's own rounding, and that of the point's coordinate.
        const double moved = std::abs(w[axis]) * 0x1p-44 + (std::abs(point[axis]) + std::abs(a[axis])) * 0x1p-48;
        unclear += (std::abs(first) + std::abs(second)) * moved;
    }
    return std::abs(determinant) > unclear ? signOf(determinant) : 0;
}

int turnOf(const Vec2& a, const Vec2& b, const Vec2& c) {
    const double first = (b.x - a.x) * (c.y - a.y), second = (b.y - a.y) * (c.x - a.x);
    const double determinant = first - second, magnitude = std::abs(first) + std::abs(second);
    if (std::abs(determinant) > 0x1p-51 * magnitude || magnitude == 0.0) return signOf(determinant);
    return exactMinor(exactDifference(b.x, a.x), exactDifference(b.y, a.y), exactDifference(c.x, a.x), exactDifference(c.y, a.y))
        .sign();
}

bool onOneLine(const Vec3& a, const Vec3& b, const Vec3& c) {
    for (int axis = 0; axis < 3; ++axis) {
        const int y = (axis + 1) % 3, z = (axis + 2) % 3;
        if (turnOf({a[y], a[z]}, {b[y], b[z]}, {c[y], c[z]}) != 0) return false;
    }
    return true;
}

}  // namespace cullscope
