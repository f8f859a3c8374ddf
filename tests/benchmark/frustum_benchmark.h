#pragma once

#include <functional>
#include <string>
#include <vector>

#include "core/spatial/instance_octree.h"
#include "core/visibility/octree_walk.h"
#include "tests/benchmark/frustum_objects.h"

namespace cullscope::benchmark {

/// One method of testing all objects, and the number of objects that the last pass kept.
struct Variant {
    std::string name;
    std::function<void()> pass;
    std::function<size_t()> kept;
};

/// The time of one variant on the same objects, measured in turns with the others.
struct FrustumSample {
    std::string shape, variant;
    size_t objects = 0;
    double share = 0.0;  ///< share of the objects that intersect the frustum
    size_t kept = 0;
    double milliseconds = 0.0;  ///< processor time of a pass, median over the rounds
    double toNaive = 0.0;       ///< the naive loop's time divided by this one's, median of the rounds' ratios; 0 where there is
                                ///< none
    double toRead = 0.0;        ///< this one's time divided by that of reading, likewise
    bool fitsCache = false;     ///< whether the batch's arrays fit the cache

    [[nodiscard]] double millionPerSecond() const { return double(objects) / milliseconds / 1000.0; }
};

inline const std::string kNaive = "naive", kRead = "read", kHierarchical = "hierarchical";

/// Runs the variants in turns; the caller fills in shape, share and fitsCache.
[[nodiscard]] std::vector<FrustumSample> inTurns(const std::vector<Variant>& variants, size_t objects);

/// The objects as instances of one mesh, and an octree over them, walked as by `frustum-octree`.
class Hierarchy {
public:
    /// A box has its own bounds, a sphere itself and its box.
    explicit Hierarchy(const std::vector<Box3>& boxes);
    explicit Hierarchy(const std::vector<Sphere>& spheres);
    /// Walks the octree with separating axes and the last failed plane first; returns the number of kept objects.
    [[nodiscard]] size_t kept(const View& view);

private:
    explicit Hierarchy(ScenePointer scene);

    ScenePointer m_scene;
    InstanceOctree m_octree;
    LastFailedPlanes m_memory;
};

}  // namespace cullscope::benchmark
