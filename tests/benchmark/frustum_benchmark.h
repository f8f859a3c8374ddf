#pragma once

#include <functional>
#include <string>
#include <vector>

#include "core/spatial/instance_octree.h"
#include "core/visibility/octree_walk.h"
#include "tests/benchmark/frustum_objects.h"

namespace cullscope::benchmark {

/// One way to test all objects, and how many the last pass kept.
struct Variant {
    std::string name;
    std::function<void()> pass;
    std::function<size_t()> kept;
};

/// What one variant took over the same objects in turns with the others.
struct FrustumSample {
    std::string shape, variant;
    size_t objects = 0;
    double share = 0.0;  ///< of the objects, those that reach into the view
    size_t kept = 0;
    double milliseconds = 0.0;  ///< processor time of a pass, median over the rounds
    double toNaive = 0.0;       ///< naive time over this one's, median of the rounds' ratios; 0 where there is none
    double toRead = 0.0;        ///< this one's time over that of reading, the same way
    bool fitsCache = false;     ///< the batch's arrays

    [[nodiscard]] double millionPerSecond() const { return double(objects) / milliseconds / 1000.0; }
};

inline const std::string kNaive = "naive", kRead = "read", kHierarchical = "hierarchical";

/// Runs the variants in turns; shape, share and fitsCache are left to the caller.
[[nodiscard]] std::vector<FrustumSample> inTurns(const std::vector<Variant>& variants, size_t objects);

/// Objects as instances of one mesh, and the octree over them, walked as `frustum-octree` walks it.
class Hierarchy {
public:
    /// A box is bounded by itself, a sphere by itself and its box.
    explicit Hierarchy(const std::vector<Box3>& boxes);
    explicit Hierarchy(const std::vector<Sphere>& spheres);
    /// Walks the octree: with separating axes, the plane that failed the last time first.
    [[nodiscard]] size_t kept(const View& view);

private:
    explicit Hierarchy(ScenePointer scene);

    ScenePointer m_scene;
    InstanceOctree m_octree;
    LastFailedPlanes m_memory;
};

}  // namespace cullscope::benchmark
