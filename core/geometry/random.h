#pragma once

#include <cstdint>

#include "core/geometry/types.h"

namespace cullscope {

/// SplitMix64 (Steele, Lea & Flood 2014): a seed gives the same numbers on every machine, which the standard library's
/// distributions do not guarantee.
class Random {
public:
    explicit Random(uint64_t seed) : m_state(seed) {}

    uint64_t bits() {
        uint64_t z = (m_state += 0x9E3779B97F4A7C15ull);
        z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9ull;
        z = (z ^ (z >> 27)) * 0x94D049BB133111EBull;
        return z ^ (z >> 31);
    }
    /// Uniform in [0, 1).
    double unit() { return static_cast<double>(bits() >> 11) * 0x1p-53; }
    double between(double low, double high) { return low + (high - low) * unit(); }
    /// Uniform on the unit sphere (Archimedes: the z of such points is uniform in [−1, 1]).
    Vec3 direction();

private:
    uint64_t m_state;
};

}  // namespace cullscope
